// Options that several commands share, in groups.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "drawing.hpp"

namespace graze {

// Headings that options of several groups and commands stand below.
inline constexpr const char* kSceneGroup = "Scene";
inline constexpr const char* kNumericsGroup = "Numerics and limits";
inline constexpr const char* kLongWorkGroup = "Long work";
inline constexpr const char* kOutputGroup = "Output";
inline constexpr const char* kPicturesGroup = "Pictures";

// Those of the command's own come first, then these in their order.
void order_headings(std::vector<std::string>& headings);

// A command, and the options it reads into, which become what is parsed where it is the one given.
template <class Kind>
std::pair<CLI::App*, Kind&> add_command(CLI::App& graze, std::optional<Command>& parsed,
                                        const char* name, const char* what) {
  CLI::App* app = graze.add_subcommand(name, what);
  const auto options = std::make_shared<Kind>();
  options->name = name;
  app->get_help_ptr()->group(kOutputGroup);
  // One reader may read any number of commands.
  app->preparse_callback([options, name](std::size_t) {
    *options = Kind();
    options->name = name;
  });
  app->callback([options, &parsed] { parsed = *options; });
  return {app, *options};
}

// All of them.
void add_commands(CLI::App& graze, std::optional<Command>& parsed);

// The options added next stand below this heading of --help.
void begin_group(CLI::App* app, const char* heading);

// What stands below the options.
std::string footer(const std::string& example);
// The example, without "Example: "; empty: there is none.
std::string example_in(const std::string& footer);

void add_shared(CLI::App* app, SceneOptions& command);
// Parts of it.
void add_printing(CLI::App* app, CommonOptions& command);
void add_output(CLI::App* app, CommonOptions& command);
void add_closure_speed(CLI::App* app, MotionOptions& command);
void add_limits(CLI::App* app, MotionOptions& command);
// Of the orbits that are sought; `what` is said of them.
void add_period(CLI::App* app, OrbitSearchOptions& command, const char* what);
// With those limits.
void add_orbit_search(CLI::App* app, OrbitSearchOptions& command);
void add_range(CLI::App* app, BranchingOptions& command);
// The values of a sweep and what is told at each.
void add_sweep(CLI::App* app, DiagramCommand& command);
// How long motions are followed until they settle.
void add_following(CLI::App* app, SettlingOptions& options);
// The same, and what is told of them; part of add_sweep.
void add_settling(CLI::App* app, SettlingOptions& options);
// Two numbers of the scene and their ranges.
void add_plane(CLI::App* app, MapCommand& command);
// Going on with what a folder holds, and a share of the work.
void add_journal(CLI::App* app, JournalOptions& options);
// Which orbits' branches are traced, and how far from the first.
void add_curve(CLI::App* app, BranchingOptions& command);
// Up to how many, 0 or 1 at least; `what` is said of them.
void add_impacts(CLI::App* app, OrbitSearchOptions& command, int least, double most,
                 const std::string& what);
void add_branch_kind(CLI::App* app, BranchingOptions& command);
// What a map shows of its cells.
void add_map_show(CLI::App* app, MapCommand& command);
// Loci over a map, with the orbits that they are of.
void add_loci_over_map(CLI::App* app, MapCommand& command);
// Loci instead of branches.
void add_locus(CLI::App* app, ContinueCommand& command);
// A special point of an earlier run instead of any search; needs those of search and loci.
void add_restart(CLI::App* app, ContinueCommand& command);

void add_picture(CLI::App* app, CommonOptions& command, const PictureFeatures& features);

// Whole commands, in files of their own.
void add_compare(CLI::App& graze, std::optional<Command>& parsed);
void add_simulate(CLI::App& graze, std::optional<Command>& parsed);

}  // namespace graze
