// Options that several commands share, in groups.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "command.hpp"

namespace graze {

// What stands below the options.
std::string footer(const std::string& example);

void add_shared(CLI::App* app, Command& command);
// Parts of it.
void add_output(CLI::App* app, Command& command);
void add_plot(CLI::App* app, Command& command);
void add_plot_or_page(CLI::App* app, Command& command);
void add_closure_speed(CLI::App* app, Command& command);
void add_limits(CLI::App* app, Command& command);
// With those limits.
void add_orbit_search(CLI::App* app, Command& command);
void add_range(CLI::App* app, Command& command);
// The values of a sweep and what is told at each.
void add_sweep(CLI::App* app, Command& command);
// How long motions are followed until they settle.
void add_following(CLI::App* app, Command& command);
// The same, and what is told of them; part of add_sweep.
void add_settling(CLI::App* app, Command& command);
// Two numbers of the scene and their ranges.
void add_plane(CLI::App* app, Command& command);
// Going on with what a folder holds, and a share of the work.
void add_journal(CLI::App* app, Command& command);
// Which orbits' branches are traced, and how far from the first.
void add_branch_kind(CLI::App* app, Command& command);
// Loci over a map, with the orbits that they are of.
void add_loci_over_map(CLI::App* app, Command& command);
// Loci instead of branches.
void add_locus(CLI::App* app, Command& command);
// A special point of an earlier run instead of any search; needs those of search and loci.
void add_restart(CLI::App* app, Command& command);

}  // namespace graze
