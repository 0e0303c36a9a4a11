#include "graze/base/detail/named_pipe.hpp"

#include <string>
#include <system_error>

namespace graze {

bool is_named_pipe(const std::filesystem::path& file) {
  const std::string name = file.lexically_normal().string();
  if (name == "/dev/stdin" || name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/"))
    return false;
  std::error_code no_matter;  // ignored: a file that cannot be inspected cannot be opened either
  return std::filesystem::is_fifo(file, no_matter);
}

}  // namespace graze
