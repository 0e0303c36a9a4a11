// graze compare: a scene and the same with another choice, side by side or over a plane of two
// parameters; a series of modes, each next to the one more.
#include <fmt/format.h>

#include <cstdio>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "journals.hpp"
#include "option_notes.hpp"
#include "session.hpp"
#include "work_options.hpp"

namespace graze {
namespace {

constexpr double kComparedSamplesPerPeriod = 400.0;
// A cell takes a tenth of a second and more, and half a kilobyte.
constexpr double kMostCells = 4e6;
constexpr int kMostComparedModes = 64;
constexpr double kPeriodsRun = 50.0, kPeriodsShown = 4.0;

void check_options(const CompareCommand& command) {
  check_plot<ComparisonRecord>(command);
  if (command.against.empty() == (command.most_modes == 0))
    throw InputError(
        "compare: give what is compared, one of --against KEY=VALUE, --modes A:B and "
        "--sensitivity");
  if (!command.is_over_plane()) {
    for (const auto& [given, name] : {std::pair(command.journal.goes_on, "--resume"),
                                      std::pair(command.journal.restarts, "--restart-work"),
                                      std::pair(!command.journal.share.is_all(), "--shard")})
      if (given) throw InputError(fmt::format("{}: it needs a plane; give --parameter too", name));
    return;
  }
  if (command.most_modes > 0)
    throw InputError("--parameter: maps compare two scenes; give --against in place of --modes");
  const double cells = static_cast<double>(command.points) * command.second_points;
  if (cells > kMostCells)
    throw InputError(
        fmt::format("--points, --second-points: {:.0f} cells are too many; at most "
                    "{:.0f} are compared",
                    cells, kMostCells));
  if (command.second.empty() || !command.second_from || !command.second_to)
    throw InputError(
        "--parameter: give the other parameter of the plane too, with --second, --second-from and "
        "--second-to");
  check_journal_options(command, command.journal);
}

void set_comparison(const CompareCommand& command, CompareOptions& options) {
  set_settling(command, command.settling, options);
  options.first = command.first_impacts;
  options.within = command.within;
  options.stop = stop_signal(command);
}

Scene comparable(const CompareCommand& command, const std::vector<std::string>& settings) {
  Scene scene = scene_of(command, settings);
  require_exact_flow(scene, "motions are compared");
  require_forcing_and_stop(scene);
  return scene;
}

// The key that holds the number of modes.
std::string modes_key(const Scene& scene) {
  const std::string name = scene.structure_name();
  if (name == "modal")
    throw scene_error(scene, name,
                      "the modes of this scene are given, so that their number cannot change "
                      "(--modes); it must be a [beam], [string], [bar] or [matrices]");
  return name + ".modes";
}

std::string other_name(const CompareCommand& command) {
  return fmt::format("{}", fmt::join(command.against, ", "));
}

// The end of a run as a picture shows it.
SimulationRecord shown_run(const CompareCommand& command, const Scene& scene,
                           const StopSignal& stop) {
  SimulationRecord record;
  record.system = assemble(scene);
  const double period = record.system.period();
  SimulationOptions options;
  options.duration = command.duration.value_or(kPeriodsRun * period);
  options.max_impacts = command.max_impacts;
  options.closure_speed = command.closure_speed;
  options.stop = stop;
  const double from = *options.duration - command.last.value_or(kPeriodsShown * period);
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.time >= from) record.events.push_back(event);
  };
  listeners.sample = [&](const Sample& sample) {
    if (sample.time >= from) record.samples.push_back(sample);
  };
  listeners.sample_rate = kComparedSamplesPerPeriod / period;
  record.run = simulate(record.system, initial_state(scene, record.system), options, listeners);
  return record;
}

// Now, or later from the folder.
bool draws_motions(const CompareCommand& command, const ComparisonRecord& record) {
  const bool draws = !command.plot.empty() || !command.out.empty() || command.caller;
  return draws && record.modes.empty() && !record.differences.empty();
}

int compare_motions(const CompareCommand& command) {
  ComparisonRecord record;
  std::vector<Scene> scenes;
  const auto add = [&](const std::string& name, const std::vector<std::string>& settings) {
    scenes.push_back(comparable(command, settings));
    record.names.push_back(name);
    record.settings.push_back(settings);
  };
  if (command.most_modes == 0) {
    add("the scene", {});
    add(other_name(command), command.against);
  } else {
    const std::string key = modes_key(comparable(command, {}));
    for (int modes = command.fewest_modes; modes <= command.most_modes; ++modes) {
      add(modes == 1 ? "1 mode" : fmt::format("{} modes", modes),
          {fmt::format("{}={}", key, modes)});
      record.modes.push_back(modes);
    }
  }
  set_comparison(command, record.options);
  record.info = info_of_call(command, scenes.front());
  note_options(command, record.info);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const std::string& warning : system_warnings(scenes[i], assemble(scenes[i])))
      record.warnings.push_back(record.names[i] + ": " + warning);
  warn(command, record.warnings);
  prepare_output(command);
  std::vector<std::optional<ComparedMotion>> motions(scenes.size());
  for_each_index(scenes.size(), command.threads,
                 [&](std::size_t i) { motions[i] = compared_motion(scenes[i], record.options); });
  for (std::optional<ComparedMotion>& motion : motions) {
    if (!motion) break;
    record.motions.push_back(std::move(*motion));
  }
  conclude_comparison(record, scenes.size(), record.options.stop.reason());
  for (std::size_t i = 0; i < scenes.size() && draws_motions(command, record); ++i) {
    record.runs.push_back(shown_run(command, scenes[i], record.options.stop));
    const Outcome shown = simulation_outcome(record.runs.back().run);
    if (record.outcome.name == "compared" && shown.name != "reached_end")
      record.outcome = {shown.name == "interrupted" ? shown.name : "budget",
                        record.names[i] + ", for the picture: " + shown.message};
  }
  return conclude(command, record, scenes.front());
}

int compare_over_plane(const CompareCommand& command) {
  const Scene one = comparable(command, {}), other = comparable(command, command.against);
  ComparisonMapOptions options;
  set_comparison(command, options);
  static_cast<Plane&>(options) = plane_of(command, command, command.points, command.second_points);
  ComparisonMapRecord record;
  record.info = info_of_call(command, one);
  record.one = "the scene";
  record.other = other_name(command);
  record.against = command.against;
  record.x_unit = number_unit(one, options.x.name);
  record.y_unit = number_unit(one, options.y.name);
  record.shown = command.show;
  note_options(command, Recorded::In::kPieces, record.info);
  for (const auto& [name, scene] : {std::pair(record.one, &one), std::pair(record.other, &other)})
    for (const std::string& warning : system_warnings(*scene, assemble(*scene)))
      record.warnings.push_back(name + ": " + warning);
  warn(command, record.warnings);
  prepare_output(command);
  JournalledWork work(command, command.journal, {record.info, "cell", options.cells(), 1, {}, {}});
  work.set(options);
  options.progress = progress_line(command, static_cast<int>(options.cells()), "cells");
  record.map = compare_over(one, other, options);
  options.progress = nullptr;
  if (!work.is_whole_here()) return work.conclude_part(record.map.stopped);
  note_options(command, Recorded::In::kResult, record.info);
  record.outcome = comparison_map_outcome(record.map);
  return work.conclude(record, record.map.stopped, one);
}

}  // namespace

void read_modes(const std::string& text, CompareCommand& command) {
  int end = 0;
  const bool read = std::sscanf(text.c_str(), "%9d:%9d%n", &command.fewest_modes,
                                &command.most_modes, &end) == 2 &&
                    end == static_cast<int>(text.size());
  if (!read || command.fewest_modes < 1 || command.most_modes <= command.fewest_modes ||
      command.most_modes > kMostComparedModes)
    throw InputError(
        fmt::format("--modes: '{}' is not allowed; give the fewest and the most modes, "
                    "like 1:8, at most {}",
                    text, kMostComparedModes));
}

int run(const CompareCommand& command) {
  if (command.sensitivity) {
    if (!command.against.empty() || command.most_modes > 0)
      throw InputError(
          "--sensitivity: it compares one scene over a parameter; leave out "
          "--against and --modes");
    return run_sensitivity(command);
  }
  check_options(command);
  return command.is_over_plane() ? compare_over_plane(command) : compare_motions(command);
}

}  // namespace graze
