// The options of pictures and pages.
#pragma once

#include <CLI/CLI.hpp>

#include "command.hpp"

namespace graze {

// What a command's pictures have that may be asked for, besides title and style.
struct PictureFeatures {
  bool ranges = false;       // of the axes
  bool scales = false;       // of the axes, logarithmic or in decibels
  bool labels = false;       // beside special points and curves
  bool multipliers = false;  // of branches
};

void add_picture(CLI::App* app, CommonOptions& command, const PictureFeatures& features);

}  // namespace graze
