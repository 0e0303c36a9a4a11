// The options of pictures and pages.
#pragma once

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "drawing.hpp"

namespace graze {

void add_picture(CLI::App* app, CommonOptions& command, const PictureFeatures& features);

}  // namespace graze
