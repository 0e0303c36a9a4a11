#include "option_groups.hpp"

#include "graze/record/names/detail/sweep_names.hpp"
#include "graze/record/run_picture.hpp"
#include "option_values.hpp"

namespace graze {
namespace {

void add_span(CLI::App* app, SimulateCommand& command) {
  begin_group(app, "Motion");
  auto* duration =
      app->add_option("--duration", command.duration, "Simulated time, s; needed without forcing")
          ->check(at_least("a number of seconds, 0 or more", 0.0))
          ->type_name("S");
  app->add_option("--periods", command.periods,
                  "Simulated forcing periods, instead of --duration (default 100)")
      ->transform(whole_number("a whole number, 0 or more", 0.0, kMostCounted))
      ->type_name("K")
      ->excludes(duration);
}

void add_recording(CLI::App* app, SimulateCommand& command) {
  app->add_option("--record", command.record, "What to keep: none, events or samples")
      ->check(CLI::IsMember({"none", "events", "samples"}))
      ->capture_default_str()
      ->type_name("WHAT");
  app->add_option(
         "--sample-rate", command.sample_rate,
         "Samples per second with --record samples (default: 100 a forcing period; without "
         "forcing, of the slowest mode)")
      ->check(above_zero())
      ->type_name("RATE");
  app->add_option("--sample-format", command.sample_format,
                  "With --record samples and --out: samples.csv, or samples.npz with an array for "
                  "NumPy of every column")
      ->check(CLI::IsMember({"csv", "npz"}))
      ->capture_default_str()
      ->type_name("WHAT");
}

void add_measurement(CLI::App* app, SimulateCommand& command) {
  app->add_flag(
      "--energy", command.energy,
      "Keep the energy balance: the work of every effect, and what is missing in their sum "
      "(--plot keeps it too)");
  app->add_flag(
      "--amplitudes", command.amplitudes,
      "Measure the motion: largest, smallest and root mean square values at the probes and stops, "
      "forces and impulses of the stops");
  app->add_option("--amplitudes-from", command.amplitudes_from,
                  "With --amplitudes or --forces: time that is measured from, s (default: 0)")
      ->check(at_least("a time in s, 0 or more", 0.0))
      ->type_name("S");
  app->add_option("--forces", command.force_windows,
                  "Keep the force of every stop over time, of impacts and while it holds, as means "
                  "over N equal windows of the run; --out writes them, --show forces draws them")
      ->transform(whole_number("a whole number from 1 to 100000", 1.0, 1e5))
      ->type_name("N");
}

void add_section(CLI::App* app, SimulateCommand& command) {
  begin_group(app, "Section");
  auto* section =
      app->add_option_function<std::string>(
             "--section", set_by_name(command.section, kDiagramSections),
             "Poincare section, which --plot then shows: impact (phase and speed of every "
             "impact) or stroboscopic (displacement and velocity at the stops once a "
             "forcing period)")
          ->transform(section_name())
          ->type_name("WHAT");
  app->add_option("--transient", command.transient,
                  "Forcing periods at the beginning that the section leaves out (default: a tenth "
                  "of the run)")
      ->transform(whole_number("a whole number, 0 or more", 0.0, kMostCounted))
      ->type_name("K")
      ->needs(section);
}

void add_run_picture(CLI::App* app, SimulateCommand& command) {
  begin_group(app, kPicturesGroup);
  add_choice(app, "--show", command.show, kRunPictures,
             "With --plot: the motion; returns (each impact over the one before, with --section "
             "impact); spectrum (amplitudes over the frequency, of the last 64 forcing periods); "
             "shapes (of the beam, with --shapes-at); or forces (of every stop over time)")
      ->type_name("WHAT")
      ->needs("--plot");
  app->add_option("--shapes-at", command.shape_times,
                  "With --show shapes: times, s, several with commas")
      ->check(at_least("a time in s, 0 or more", 0.0))
      ->delimiter(',')
      ->type_name("T,..")
      ->needs("--show");
}

void add_resumption(CLI::App* app, SimulateCommand& command) {
  begin_group(app, "Motion");
  app->add_option("--resume", command.resume,
                  "Go on from the run in a folder that --out wrote; the end "
                  "still counts from t = 0")
      ->type_name("FILE|DIR");
}

}  // namespace

void add_simulate(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<SimulateCommand>(
      graze, parsed, "simulate", "Follow the motion, every impact certified");
  app->footer(footer("simulate data/scenes/02_wagg_momentum.toml --duration 1 --energy"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<SimulationRecord>);
  add_span(app, command);
  add_recording(app, command);
  add_measurement(app, command);
  add_section(app, command);
  add_run_picture(app, command);
  add_closure_speed(app, command);
  add_resumption(app, command);
  add_limits(app, command);
}

}  // namespace graze
