// Options of `graze simulate`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "command.hpp"

namespace graze {

void add_simulate(CLI::App& graze, std::optional<Command>& parsed);

}  // namespace graze
