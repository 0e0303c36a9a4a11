#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "first_scene.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/names/detail/map_names.hpp"
#include "option_groups.hpp"
#include "option_values.hpp"

namespace graze {
namespace {

void add_init(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<InitCommand>(
      graze, parsed, "init", "Write a commented scene to begin with, onto stdout or into a file");
  app->footer(footer("init beam my_beam.toml"));
  begin_group(app, kSceneGroup);
  app->add_option("KIND", command.kind,
                  "What the scene is of: beam against a stop, oscillator (modes given as numbers), "
                  "matrices of a finite-element model, or hub (a beam that turns)")
      ->check(CLI::IsMember(first_scene_kinds()))
      ->capture_default_str()
      ->type_name("KIND");
  app->add_option("FILE", command.file, "File to write, which must not be there yet");
}

void add_check(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<CheckCommand>(
      graze, parsed, "check",
      "Read a scene and say what is simulated: modes, frequencies, conditioning, flow");
  app->footer(footer("check data/scenes/02_wagg_momentum.toml --set beam.modes=8"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<CheckRecord>);
  begin_group(app, "Parameters");
  CLI::Option* list =
      app->add_flag("--parameters", command.parameters,
                    "List what --parameter may name, with values and units, and nothing else");
  for (const char* of_results : {"--json", "--out", "--plot"})
    list->excludes(app->get_option(of_results));
}

void add_modes(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<ModesCommand>(
      graze, parsed, "modes",
      "Natural modes of the structure: frequencies, effective masses, shapes");
  app->footer(footer("modes data/scenes/24_frame_from_matrices.toml --plot modes.png"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<ModesRecord>);
  begin_group(app, "Comparison");
  app->add_option("--mac", command.mac,
                  "Compare the shapes by the modal assurance criterion with those of another "
                  "scene, or of a file with a degree of freedom and its displacements in a line")
      ->type_name("FILE");
}

void add_orbit(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] =
      add_command<OrbitCommand>(graze, parsed, "orbit", "Find periodic orbits, stable or not");
  app->footer(footer("orbit data/scenes/05_wagg_one_mode.toml --set forcing.frequency=40"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<OrbitRecord>);
  add_orbit_search(app, command);
  add_closure_speed(app, command);
  begin_group(app, "Search for orbits");
  add_impacts(app, command, 1, kMostPeriods,
              "Impacts k per orbit, on every sequence of stops; 'any' (default): 1, then 2 and 3 "
              "while the structure is small, and what the simulation settles on");
}

void add_continue(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<ContinueCommand>(
      graze, parsed, "continue", "Trace branches of orbits over a parameter of the scene");
  app->footer(
      footer("continue data/scenes/05_wagg_one_mode.toml --parameter forcing.frequency \\\n"
             "           --from 15 --to 120"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<BranchRecord>);
  add_range(app, command);
  add_orbit_search(app, command);
  add_branch_kind(app, command);
  add_curve(app, command);
  add_closure_speed(app, command);
  add_locus(app, command);
  add_restart(app, command);
}

void add_diagram(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<DiagramCommand>(
      graze, parsed, "diagram",
      "Bifurcation diagram: sweep a parameter, with the branches of orbits over it");
  app->footer(
      footer("diagram data/scenes/05_wagg_one_mode.toml --parameter forcing.frequency \\\n"
             "           --from 15 --to 120"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<DiagramRecord>);
  add_range(app, command);
  add_sweep(app, command);
  add_closure_speed(app, command);
  begin_group(app, "Branches");
  app->add_option_function<std::string>(
         "--branches", set_by_name(command.branches, kDiagramBranches),
         "Branches over the sweep: found, of (1, 1) orbits and of whatever the sweep settles on; "
         "all (p, k) orbits that a search leads to; or none (default: found, with --period or "
         "--impacts all)")
      ->check(CLI::IsMember(names_of(kDiagramBranches)))
      ->type_name("WHICH");
  add_period(app, command, "Forcing periods p of the branches' orbits");
  add_branch_kind(app, command);
  add_curve(app, command);
  begin_group(app, "Sweep");
  CLI::Option* duration =
      app->add_option("--duration", command.duration,
                      "Where no forcing repeats the motion: time of the one run at each value, s")
          ->check(above_zero())
          ->type_name("S");
  for (const char* of_sweep : {"--direction", "--section", "--periods", "--samples", "--branches",
                               "--exponents", "--period", "--impacts", "--max-step", "--follow",
                               "--depth", "--amplitudes", "--show", "--at"})
    duration->excludes(app->get_option(of_sweep));
  add_limits(app, command);
  add_journal(app, command.journal);
}

void add_map(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<MapCommand>(
      graze, parsed, "map",
      "What the motion settles on over two parameters, or two coordinates of its start");
  app->footer(footer(
      "map data/scenes/05_wagg_one_mode.toml --parameter forcing.frequency \\\n"
      "           --from 15 --to 120 --second stop.gap --second-from 0.5e-3 --second-to 2e-3"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<MapRecord>);
  add_plane(app, command);
  begin_group(app, "Cells");
  add_map_show(app, command);
  add_loci_over_map(app, command);
  add_settling(app, command.settling);
  add_closure_speed(app, command);
  add_limits(app, command);
  add_journal(app, command.journal);
}

void add_merge(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<MergeCommand>(
      graze, parsed, "merge",
      "Join the shares of a diagram, map or comparison (--shard) to its result");
  app->footer(footer("merge runs/part* --out runs/whole --plot whole.svg"));
  app->add_option("FOLDER", command.folders, "Folders that --shard wrote to")
      ->required()
      ->type_name("DIR ...");
  add_output(app, command);
  app->get_option("--out")->required();
  add_picture(app, command, kAllFeatures);
  begin_group(app, kNumericsGroup);
  app->add_option("--max-seconds", command.max_seconds,
                  "Most computing time, s; what was reached by then is printed")
      ->check(above_zero())
      ->capture_default_str()
      ->type_name("S");
}

void add_view(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<ViewCommand>(
      graze, parsed, "view", "Print and draw the result in a folder that --out wrote");
  app->footer(footer("view runs/map --show speed --plot speed.svg"));
  app->add_option("RESULT", command.result,
                  "Folder that --out of a command wrote, or the result.json in it")
      ->required()
      ->type_name("DIR");
  add_printing(app, command);
  add_picture(app, command, kAllFeatures);
  begin_group(app, "What is shown");
  CLI::Option* show =
      app->add_option("--show", command.show,
                      "What the picture shows, in the words of --show of the command that made the "
                      "result (default: what it was asked for)")
          ->type_name("WHAT");
  app->add_option("--at", command.at, "Of response curves: the place, e.g. probe.1 or stop.2")
      ->type_name("PLACE")
      ->needs(show);
}

void add_cost(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] =
      add_command<CostCommand>(graze, parsed, "cost", "What accuracy costs in time, flow by flow");
  app->footer(footer("cost data/scenes/02_wagg_momentum.toml --set stop.gap=5e-3 --plot cost.png"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<CostRecord>);
  begin_group(app, "Comparison");
  app->add_option("--impacts", command.impacts,
                  "Impacts over which flows are compared (default 20)")
      ->transform(whole_number_within(1, 1'000'000))
      ->type_name("K");
  app->add_option("--duration", command.duration,
                  "Most simulated time, s (default: 100 forcing periods; without forcing, of the "
                  "slowest oscillation)")
      ->check(above_zero())
      ->type_name("S");
  add_closure_speed(app, command);
  add_limits(app, command);
}

void add_fit(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<FitCommand>(
      graze, parsed, "fit", "Identify parameters of the scene from measurements");
  app->footer(
      footer("fit data/measurements/restitution.toml data/measurements/restitution.csv\n"
             "         graze fit data/measurements/contact.toml data/measurements/contact.csv \\\n"
             "           --parameter stop.spring.stiffness=1e6:1e9"));
  add_shared(app, command);
  app->add_option("DATA", command.data,
                  "Measurements (CSV): speed,restitution; time and stop of impacts; or time and "
                  "force1, gap1, displacement1, velocity1, penetration1, q1, qdot1, ..")
      ->required();
  add_picture(app, command, kFeatures<FitRecord>);
  begin_group(app, "Fit");
  app->add_option("--parameter", command.sought,
                  "A parameter that is fitted and the values between which it is sought; as often "
                  "as wanted. Also record.start, initial.q.1, initial.qdot.1, .. Of restitutions "
                  "all coefficients by default")
      ->type_name("NAME=LOW:HIGH")
      ->allow_extra_args(false)
      ->take_all();
  app->add_option("--column", command.columns,
                  "Columns of a response that are fitted, several with commas (default: all)")
      ->delimiter(',')
      ->type_name("NAME");
  app->add_option("--sigma", command.sigmas,
                  "Standard uncertainty of the data in SI units, in place of a column sigma; of "
                  "one column with its name (default: from the residuals)")
      ->type_name("[COLUMN=]VALUE")
      ->allow_extra_args(false)
      ->take_all();
  app->add_option_function<std::string>(
         "--algorithm", set_if(command.global, "global"),
         "local: from the scene's values on; global: search between all limits first")
      ->check(CLI::IsMember({"local", "global"}))
      ->default_str("local")
      ->type_name("NAME");
  app->add_option("--max-evaluations", command.max_evaluations,
                  "Most evaluations of the model; the best values so far are then printed")
      ->transform(whole_number("a whole number from 1", 1.0, 1e9))
      ->capture_default_str()
      ->type_name("N");
  add_closure_speed(app, command);
  add_limits(app, command);
}

}  // namespace

void add_commands(CLI::App& graze, std::optional<Command>& parsed) {
  add_init(graze, parsed);
  add_check(graze, parsed);
  add_modes(graze, parsed);
  add_simulate(graze, parsed);
  add_orbit(graze, parsed);
  add_continue(graze, parsed);
  add_diagram(graze, parsed);
  add_map(graze, parsed);
  add_merge(graze, parsed);
  add_view(graze, parsed);
  add_cost(graze, parsed);
  add_fit(graze, parsed);
  add_compare(graze, parsed);
}

}  // namespace graze
