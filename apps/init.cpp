// graze init: a scene to begin with.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "first_scene.hpp"
#include "graze/base/errors.hpp"
#include "session.hpp"

namespace graze {
namespace {

namespace fs = std::filesystem;

// Where the example's matrices lie beside the program: installed, or as it is built.
std::string example_matrices() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  for (const char* folder : {"../share/graze/matrices", "../data/matrices"}) {
    const fs::path there = (program.parent_path() / folder).lexically_normal();
    if (fs::exists(there / "portal_frame_mass.mtx", none)) return there.string() + "/";
  }
  throw FileError(
      "graze init matrices: the example's matrices are not beside this program, in "
      "../share/graze/matrices; see [matrices] in docs/scenes.md for what to write");
}

// Never over a file that is there, not even one that comes to be in this moment.
void write_new_file(const std::string& name, const std::string& text) {
  const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0 && errno == EEXIST)
    throw FileError(fmt::format("{}: it is there already; nothing was written", name));
  std::size_t written = 0;
  while (file >= 0 && written < text.size()) {
    const ssize_t more = ::write(file, text.data() + written, text.size() - written);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    written += static_cast<std::size_t>(more);
  }
  const int reason = errno;
  const bool whole = file >= 0 && written == text.size();
  if (file >= 0 && ::close(file) == 0 && whole) return;
  if (file >= 0) ::unlink(name.c_str());
  throw FileError(fmt::format("{}: cannot be written, {}", name, std::strerror(reason)));
}

}  // namespace

int run(const InitCommand& command) {
  const std::string text =
      first_scene(command.kind, command.kind == "matrices" ? example_matrices() : "");
  if (command.file.empty())
    print([&](const TextSink& out) { out(text); });
  else
    write_new_file(command.file, text);
  return 0;
}

}  // namespace graze
