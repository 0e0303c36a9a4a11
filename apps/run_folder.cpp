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

std::vector<std::string> words_without(const std::vector<std::string>& words,
                                       const std::set<std::string>& options) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (!options.contains(name))
      kept.push_back(words[i]);
    else if (name == words[i])
      ++i;
  }
  return kept;
}

}  // namespace graze
