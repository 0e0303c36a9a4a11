#include "graze/scene/detail/text_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include "graze/base/detail/named_pipe.hpp"
#include "graze/base/errors.hpp"
#include "graze/scene/detail/text_check.hpp"

namespace graze {
std::string read_text_file(const std::filesystem::path& file, const std::string& kind) {
  const std::string name = file.string();
  std::error_code no_matter;  // ignored: a file that cannot be inspected cannot be opened either
  if (std::filesystem::is_directory(file, no_matter))
    throw FileError(fmt::format("{}: cannot be read as {}, it is a directory", name, kind));
  if (is_named_pipe(file))
    throw InputError(fmt::format("{}: cannot be read as {}, it is a named pipe and no regular file",
                                 name, kind));
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw FileError(fmt::format("{}: cannot be read, {}", name,
                                errno != 0 ? std::strerror(errno) : "it cannot be opened"));
  std::string text;
  std::vector<char> piece(65536);
  while (stream && text.size() <= kLargestText) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw FileError(fmt::format("{}: cannot be read to its end", name));
  return text;
}

}  // namespace graze
