// Options of `graze compare`.
#pragma once

#include <CLI/CLI.hpp>

#include "command.hpp"

namespace graze {

void add_compare(CLI::App& graze, Command& command);

}  // namespace graze
