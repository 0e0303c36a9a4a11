// A folder with an earlier run to go on from.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "command.hpp"

namespace graze {

// Throws InputError where --out is that folder, whose tables would be lost. `option`: what names
// it.
void refuse_own_folder(const CommonOptions& command, const std::filesystem::path& folder,
                       const char* option);

// The words of a command without these options, each of which has a value.
std::vector<std::string> words_without(const std::vector<std::string>& words,
                                       const std::set<std::string>& options);

}  // namespace graze
