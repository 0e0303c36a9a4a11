// Options of `graze compare`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "command.hpp"

namespace graze {

void add_compare(CLI::App& graze, std::optional<Command>& parsed);

}  // namespace graze
