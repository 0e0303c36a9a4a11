// What command lines may name: scenes and measurements of the project, and runs that the program
// left.
#pragma once

#include <filesystem>
#include <string>

#include "fuzz/command_lines.hpp"

namespace graze {

// Scenes and measurements of `data`, and folders below `folder` that the program writes first:
// complete runs, shares, and runs that were stopped half way. Throws where it leaves none.
Materials prepared_materials(const std::string& program, const std::filesystem::path& data,
                             const std::filesystem::path& folder);

// The same with every run copied into `folder`; in half of the cases one file of them is damaged.
Materials damaged_copy(const Materials& materials, const std::filesystem::path& folder, Draw& draw);

std::string text_of(const std::filesystem::path& file);

}  // namespace graze
