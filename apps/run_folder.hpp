// A folder with an earlier run to go on from.
#pragma once

#include <filesystem>

#include "command.hpp"

namespace graze {

// Throws InputError where --out is that folder, whose tables would be lost. `option`: what names
// it.
void refuse_own_folder(const CommonOptions& command, const std::filesystem::path& folder,
                       const char* option);

}  // namespace graze
