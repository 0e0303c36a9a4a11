// graze simulate: the motion from the scene's initial state.
#include <cmath>
#include <deque>

#include "graze/base/angle.hpp"
#include "graze/report/csv.hpp"
#include "graze/report/json.hpp"
#include "graze/report/pictures.hpp"
#include "graze/report/text.hpp"
#include "graze/scene/reader.hpp"
#include "session.hpp"

namespace graze {
namespace {

constexpr double kSamplesPerPeriod = 100.0;
// A picture shows the end of the run: this many samples at this many a period.
constexpr double kPictureSamplesPerPeriod = 400.0;
constexpr std::size_t kPictureSamples = 12 * 400;

double natural_period(const System& system) {
  if (system.forcing) return system.period();
  const double slowest = system.omega.minCoeff();
  return slowest > 0.0 ? kTurn / slowest : 1.0;
}

SimulationOptions simulation_options(const Command& command, const Scene& scene) {
  SimulationOptions options;
  options.duration = command.duration;
  if (command.periods) options.periods = *command.periods;
  options.max_impacts = command.max_impacts;
  options.stop = stop_signal(command);
  if (!scene.forcing && !options.duration) {
    if (command.periods)
      throw InputError(
          "--periods: the scene has no forcing, so it has no forcing periods; give "
          "--duration in seconds");
    throw InputError(
        "the scene has no forcing, so it has no forcing periods; give --duration in "
        "seconds");
  }
  // Whole periods are counted in 64 bits, and a double tells the periods apart up to 2^53.
  if (options.duration && !(*options.duration >= 0.0 && std::isfinite(*options.duration)))
    throw InputError("--duration: it must be a finite number of seconds, 0 or more");
  if (options.duration && scene.forcing &&
      *options.duration * scene.forcing->frequency > 2.0 * 3.14 * 0x1p53)
    throw InputError("--duration: it must not exceed 2^53 forcing periods");
  if (command.sample_rate && command.record != "samples")
    throw InputError("--sample-rate: it needs --record samples");
  return options;
}

}  // namespace

int run_simulate(const Command& command) {
  if (!command.plot.empty()) check_picture_name(command.plot);
  const Scene scene = read_scene(command.scene, command.settings);
  SimulationRecord record{
      run_info(command.name, command.scene, scene), assemble(scene), {}, {}, {}, {}, {}};
  const State start = initial_state(scene, record.system);
  const SimulationOptions options = simulation_options(command, scene);
  if (options.duration)
    record.info.options.emplace_back("duration", *options.duration);
  else
    record.info.options.emplace_back("periods", options.periods);
  record.info.options.emplace_back("record", command.record);
  record.info.options.emplace_back("max_impacts", options.max_impacts);
  record.info.options.emplace_back("max_seconds", command.max_seconds);
  record.warnings = system_warnings(scene, record.system);
  warn(command, record.warnings);

  RunListeners listeners;
  listeners.progress = progress_line(command);
  const bool wants_samples = command.record == "samples";
  const bool draws = !command.plot.empty();
  if (command.record != "none" || draws)
    listeners.event = [&](const Event& event) { record.events.push_back(event); };
  std::deque<Sample> tail;
  if (wants_samples) {
    listeners.sample_rate =
        command.sample_rate.value_or(kSamplesPerPeriod / natural_period(record.system));
    record.info.options.emplace_back("sample_rate", listeners.sample_rate);
    listeners.sample = [&](const Sample& sample) { record.samples.push_back(sample); };
  } else if (draws) {
    listeners.sample_rate = kPictureSamplesPerPeriod / natural_period(record.system);
    listeners.sample = [&](const Sample& sample) {
      tail.push_back(sample);
      if (tail.size() > kPictureSamples) tail.pop_front();
    };
  }
  prepare_output(command);
  record.run = simulate(record.system, start, options, listeners);
  listeners.progress = nullptr;
  record.outcome = simulation_outcome(record.run);
  if (record.run.totals.energy_added > 0.0) {
    record.warnings.push_back("impacts added kinetic energy, as the oblique impulse law can");
    warn(command, {record.warnings.back()});
  }

  SimulationRecord drawn;
  if (draws) {
    drawn = record;
    if (!wants_samples) drawn.samples.assign(tail.begin(), tail.end());
  }
  if (command.record == "none") record.events.clear();
  std::vector<std::pair<std::string, std::string>> files;
  if (command.record != "none") files.emplace_back("events.csv", events_csv(record));
  if (wants_samples) files.emplace_back("samples.csv", samples_csv(record));
  return conclude(
      command, record.info, record.outcome,
      {to_json(record), to_text(record), files, [&] { draw_simulation(command.plot, drawn); }});
}

}  // namespace graze
