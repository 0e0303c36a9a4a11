#include "run_folder.hpp"

#include <fmt/format.h>

#include "graze/base/errors.hpp"

namespace graze {

void refuse_own_folder(const CommonOptions& command, const std::filesystem::path& folder,
                       const char* option) {
  std::error_code no_matter;  // what cannot be looked at cannot be read either
  if (command.out.empty() || !std::filesystem::equivalent(folder, command.out, no_matter)) return;
  throw InputError(
      fmt::format("--out: {} holds the run that {} goes on from, whose tables it would replace; "
                  "give another folder",
                  command.out, option));
}

}  // namespace graze
