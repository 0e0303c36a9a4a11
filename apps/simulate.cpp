// graze simulate: the motion from the scene's initial state, or on from where an earlier run ended.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/beam_shape.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/assembly/system_warnings.hpp"
#include "graze/base/angle.hpp"
#include "graze/base/errors.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "option_notes.hpp"
#include "resumption.hpp"
#include "run_output.hpp"
#include "session.hpp"

namespace graze {
namespace {

constexpr double kSamplesPerPeriod = 100.0;
constexpr double kPictureSamplesPerPeriod = 400.0;
constexpr int kPictureWindows = 400;  // of forces, over the whole run, about

SimulationOptions simulation_options(const SimulateCommand& command, const Scene& scene) {
  SimulationOptions options;
  options.duration = command.duration;
  if (command.periods) options.periods = *command.periods;
  options.max_impacts = command.max_impacts;
  options.energy = command.keeps_balance();
  options.closure_speed = command.closure_speed;
  options.stop = stop_signal(command);
  const bool has_periods = scene.forcing && !scene.forcing->signal;
  if (!has_periods && !options.duration)
    throw InputError(
        fmt::format("{}the scene has no forcing{}, so it has no forcing periods; give "
                    "--duration in seconds",
                    command.periods ? "--periods: " : "",
                    scene.forcing ? " with a frequency in front" : ""));
  // Whole periods are counted in 64 bits, and a double distinguishes them up to 2^53.
  if (options.duration && scene.forcing &&
      *options.duration * scene.forcing->frequency > kTurn * 0x1p53)
    throw InputError("--duration: it must not exceed 2^53 forcing periods");
  if (options.periods > (1LL << 53))
    throw InputError("--periods: it must not exceed 2^53 forcing periods");
  // Time is not counted in periods of one load where others do not repeat with it.
  if (!options.duration && !scene.repeats())
    options.duration = static_cast<double>(options.periods) * kTurn / scene.forcing->frequency;
  if (command.sample_rate && command.record != "samples" && !command.statistics)
    throw InputError("--sample-rate: it needs --record samples or --statistics");
  if (command.sample_format != "csv" && (command.record != "samples" || command.out.empty()))
    throw InputError("--sample-format: it needs --record samples and --out");
  return options;
}

void check_shown(const SimulateCommand& command, const Scene& scene) {
  if (command.show == RunPicture::kReturns && command.section != DiagramSection::kImpact)
    throw InputError("--show returns: it shows impacts; give --section impact too");
  if (command.show == RunPicture::kSpectrum && command.section)
    throw InputError("--show spectrum: it shows the motion; leave out --section");
  if (command.show == RunPicture::kPsd && !command.statistics)
    throw InputError("--show psd: it shows statistics; give --statistics too");
  if (command.show == RunPicture::kPsd && command.section)
    throw InputError("--show psd: it shows the motion; leave out --section");
  if ((command.show == RunPicture::kShapes) == command.shape_times.empty())
    throw InputError("--show shapes: it goes with --shapes-at T1,T2,.., and that with it");
  if (command.show == RunPicture::kForces && scene.stops.empty())
    throw InputError("--show forces: the scene has no stops");
  if (command.show != RunPicture::kShapes) return;
  if (!beam_places(scene, 2))
    throw InputError(
        "--show shapes: only a beam, string or bar, not on a hub, has a shape; this scene has "
        "another structure");
  if (!command.resume.empty())
    throw InputError("--show shapes: the motion before --resume is not known; leave it out");
}

// The motion is followed on from each instant to the next, as exactly as any run. What ends it
// early ends the shapes.
void add_shapes(std::vector<double> times, const State& start, SimulationOptions options,
                SimulationRecord& record) {
  options.measure.reset();
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::optional<Simulation> run;
  for (const double time : times) {
    options.duration = time;
    run = run ? resume(record.system, run->state, options, {})
              : simulate(record.system, start, options, {});
    const Outcome outcome = simulation_outcome(*run);
    if (outcome.name != "reached_end") {
      record.outcome = {outcome.name, fmt::format("the shape at {:.6g} was not reached: {}", time,
                                                  outcome.message)};
      return;
    }
    const Vector u = record.beam->rows * structure_state(record.system, run->final, run->phase).q;
    record.shapes.push_back({time, record.beam->x, {u.begin(), u.end()}});
  }
}

// As many in every forcing period, so that means of what repeats repeat too. What is left of the
// span behind the last is less than a window.
ForceWindows fitted_windows(double span, double period) {
  const double length = span / kPictureWindows;
  if (!std::isfinite(period)) return {length, kPictureWindows};
  const double each = std::fmax(1.0, std::round(period / length));
  // Roundings of the quotient that are not to cost the last window.
  const double count = span * each / period * (1.0 + 4.0 * std::numeric_limits<double>::epsilon());
  return count < 1.0 ? ForceWindows{span, 1}
                     : ForceWindows{period / each, static_cast<int>(std::floor(count))};
}

// What of the run is measured, if anything: at the record's places, and the forces over time.
std::optional<MeasureOptions> measure_options(const SimulateCommand& command,
                                              const SimulationRecord& record, double begin,
                                              double end) {
  // A rigid stop that is hit has no force that could be shown as it is.
  const bool shows_means = command.show == RunPicture::kForces && record.system.has_rigid_stop();
  const bool keeps_forces = command.force_windows || shows_means;
  if (!command.measures() && !keeps_forces) {
    if (command.amplitudes_from)
      throw InputError("--amplitudes-from: it needs --amplitudes, --statistics or --forces");
    return {};
  }
  MeasureOptions measure{rows_of(record.places),
                         std::fmax(command.amplitudes_from.value_or(0.0), begin)};
  if (!keeps_forces) return measure;
  if (!(end > measure.from))
    throw InputError("--forces: nothing of the run is left to be measured, it must end later");
  measure.windows =
      command.force_windows
          ? ForceWindows{(end - measure.from) / *command.force_windows, *command.force_windows}
          : fitted_windows(end - measure.from, record.system.first_period());
  return measure;
}

// 1/s. The slowest mode stands in for the forcing where there is none.
double samples_per_period(const System& system, double count) {
  if (system.has_phase()) return count / system.first_period();
  // A hub turns freely; what it carries does not.
  const double slowest = system.turns() ? system.omega[1] : system.omega.minCoeff();
  return slowest > 0.0 ? count * slowest / kTurn : count;
}

// s.
double end_of(const SimulationOptions& options, const System& system) {
  return options.duration ? *options.duration
                          : static_cast<double>(options.periods) * system.first_period();
}

// What the run is seen by, where that was asked for.
std::optional<RunSection> section_of(const SimulateCommand& command, const System& system,
                                     const SimulationOptions& options) {
  if (!command.section) return {};
  if (!system.has_phase())
    throw InputError(
        "--section: the scene has no forcing with a frequency, so its motion has no phase");
  if (command.section == DiagramSection::kStroboscopic && command.samples_in_full())
    throw InputError(
        fmt::format("--section stroboscopic: it takes a sample each forcing period; leave out {}",
                    command.statistics ? "--statistics" : "--record samples"));
  const double period = system.first_period(), end = end_of(options, system);
  const double from =
      command.transient ? static_cast<double>(*command.transient) * period : 0.1 * end;
  if (from >= end && end > 0.0)
    throw InputError(fmt::format(
        "--transient: the run has {:g} forcing periods; give fewer, or nothing is left of it",
        end / period));
  return RunSection(*command.section, from);
}

double sample_rate(const SimulateCommand& command, const System& system,
                   const std::optional<CutRun>& cut) {
  if (command.section && !command.samples_in_full()) return 1.0 / system.first_period();
  if (!command.samples_in_full()) {
    const double rate = samples_per_period(system, kPictureSamplesPerPeriod);
    // Nothing settles on a hub: the whole run is looked at.
    return system.turns() && command.duration
               ? std::min(rate, static_cast<double>(kPictureSamples - 1) / *command.duration)
               : rate;
  }
  if (command.sample_rate) return *command.sample_rate;
  if (cut && cut->sample_rate) return *cut->sample_rate;
  return samples_per_period(system, kSamplesPerPeriod);
}

// As fine as pictures are, however coarse the table: a power of two times its rate, so that its
// samples stay what they are to the bit.
RunOutput::Rate listening_rate(const SimulateCommand& command, const System& system, double rate) {
  RunOutput::Rate made{rate, 1};
  const bool draws = !command.plot.empty() || (command.statistics && !command.out.empty());
  if (!draws || command.section || !command.samples_in_full()) return made;
  while (made.rate < samples_per_period(system, kPictureSamplesPerPeriod) &&
         made.stride < (1LL << 20)) {
    made.rate *= 2.0;
    made.stride *= 2;
  }
  return made;
}

// Of the run, where they were asked for. By default segments have whole forcing periods, whose
// lines then lie on frequencies of the spectrum; the first covers 2/9 of the time, so that there
// are eight.
std::optional<StatisticsCollector> statistics_of(const SimulateCommand& command,
                                                 const SimulationRecord& record, double from,
                                                 double end, double rate) {
  if (!command.statistics) return {};
  constexpr double kMostSegment = 0x1p20;  // samples
  const double span = end - from;
  if (!(span > 0.0))
    throw InputError("--statistics: nothing of the run is left to be measured, it must end later");
  if (command.psd_segment && *command.psd_segment > span)
    throw InputError(
        fmt::format("--psd-segment: {:g} s are measured; give no more than that", span));
  if (command.psd_segment && *command.psd_segment * rate > kMostSegment)
    throw InputError(
        fmt::format("--psd-segment: a segment would have more than {:.0f} samples; give a shorter "
                    "one or a lower --sample-rate",
                    kMostSegment));
  const double period = 1.0 / samples_per_period(record.system, 1.0);
  const double periods = std::clamp(std::floor(span / period * 2.0 / 9.0), 1.0, 64.0);
  const double segment = command.psd_segment.value_or(std::min(periods * period, span));
  return StatisticsCollector(record.places, record.system.stops.size(), from, rate,
                             segment_length(std::min(std::round(segment * rate), kMostSegment)));
}

// With what holds where an option is not given.
void note_run(SimulateCommand command, const SimulationOptions& options,
              const std::optional<CutRun>& cut, double rate, RunInfo& info) {
  if (!options.duration) command.periods = options.periods;
  command.sample_rate.reset();
  if (command.samples_in_full()) command.sample_rate = rate;
  command.energy = command.keeps_balance();
  command.amplitudes_from.reset();
  if (options.measure) command.amplitudes_from = options.measure->from;
  command.closure_speed = options.closure_speed;
  note_options(command, info);
  if (cut) info.options.emplace_back("resume_time", cut->time);
}

Simulation run_listened(const System& system, const State& start, const std::optional<CutRun>& cut,
                        const SimulationOptions& options, double rate,
                        const SimulateCommand& command, RunOutput& output) {
  RunListeners listeners;
  listeners.progress = progress_line(command);
  if (output.wants_events()) listeners.event = [&](const Event& event) { output.add(event); };
  if (output.wants_samples()) listeners.sample = [&](const Sample& sample) { output.add(sample); };
  listeners.sample_rate = rate;
  listeners.sample_from = output.samples_from();
  return cut ? resume(system, cut->state, options, listeners)
             : simulate(system, start, options, listeners);
}

void check_shape_times(const SimulateCommand& command, const SimulationOptions& options,
                       const System& system) {
  const double end = end_of(options, system);
  for (const double time : command.shape_times)
    if (time > end)
      throw InputError(
          fmt::format("--shapes-at: {:g} lies beyond the end of the run, {:.6g}", time, end));
}

// What a run follows, from its scene and from where an earlier one ended.
struct Plan {
  State start;
  SimulationOptions options;
  std::optional<CutRun> cut;
  std::optional<RunSection> section;
  double rate = 0.0;  // 1/s, of the samples that are kept
  RunOutput::Rate listened;
};

// Fills in what the record says of the system before it moves.
Plan planned(const SimulateCommand& command, const Scene& scene, SimulationRecord& record) {
  const System& system = record.system;
  Plan plan{initial_state(scene, system), simulation_options(command, scene), {}, {}, 0.0, {}};
  check_shape_times(command, plan.options, system);
  plan.options.steps = step_choice(scene, system, plan.start);
  if (command.measures()) record.places = measured_places(scene, system);
  if (!command.resume.empty()) {
    plan.cut = read_cut_run(command, record.info);
    check_end(*plan.cut, plan.options, system);
  }
  plan.options.measure = measure_options(command, record, plan.cut ? plan.cut->time : 0.0,
                                         end_of(plan.options, system));
  plan.section = section_of(command, system, plan.options);
  if (!plan.options.closure_speed)
    plan.options.closure_speed =
        plan.cut ? plan.cut->state.closure_speed
                 : default_closure_speed(system, plan.start, scene.solver.tolerance);
  plan.rate = sample_rate(command, system, plan.cut);
  plan.listened = listening_rate(command, system, plan.rate);
  if (plan.cut) place_samples(*plan.cut, plan.rate, plan.listened.stride);
  return plan;
}

// What --resume counts on from: samples of a picture are none to go on with, of a table or of
// statistics it has a part of them.
void leave_state(const SimulateCommand& command, long long stride, RunState& state) {
  state.samples = command.samples_in_full() ? (state.samples + stride - 1) / stride : 0;
}

}  // namespace

int run(const SimulateCommand& command) {
  check_plot<SimulationRecord>(command);
  const Scene scene = scene_of(command);
  check_shown(command, scene);
  SimulationRecord record;
  record.info = info_of_call(command, scene);
  record.system = assemble(scene);
  record.probes = probe_rows(scene, record.system);
  record.coordinates = coordinate_rows(scene);
  Plan plan = planned(command, scene, record);
  note_run(command, plan.options, plan.cut, plan.rate, record.info);
  record.warnings = system_warnings(scene, record.system);
  warn(command, record.warnings);
  if (plan.cut && command.keeps_balance() && !plan.cut->state.keeps_balance)
    record.notes.push_back(
        "the run before kept no energy balance; it begins where this one goes on");

  const double end = end_of(plan.options, record.system);
  const double from = plan.options.measure ? plan.options.measure->from : 0.0;
  std::optional<StatisticsCollector> statistics =
      statistics_of(command, record, from, end, plan.rate);
  prepare_output(command);
  RunOutput output(command, record.system, record.probes, std::move(plan.section),
                   std::move(statistics), plan.listened, end);
  record.run = run_listened(record.system, plan.start, plan.cut, plan.options, plan.listened.rate,
                            command, output);
  record.outcome = simulation_outcome(record.run);
  tell_how_to_go_on(command, record.run.outcome, record.outcome);
  for (const std::string& warning : simulation_warnings(record.system, record.run)) {
    record.warnings.push_back(warning);
    warn(command, {warning});
  }
  output.show_in(record);
  record.shown = command.show;
  place_beam(command, scene, record);
  if (command.show == RunPicture::kShapes)
    add_shapes(command.shape_times, plan.start, plan.options, record);
  leave_state(command, plan.listened.stride, record.run.state);
  return conclude(
      command, record, scene, {},
      {[&] { return to_json(record, output.events()); }, {}, {}, {}, output.take_tables()});
}

}  // namespace graze
