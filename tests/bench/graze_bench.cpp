// Speed of the main jobs, one core: build/tests/bench/graze_bench
#include <benchmark/benchmark.h>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/bifurcation/loci/detail/locus_tracer.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/study/sweep/sweep.hpp"

namespace graze {
namespace {

Scene one_mode_scene(const std::vector<std::string>& settings) {
  return read_scene(GRAZE_SOURCE_DIR "/data/scenes/05_wagg_one_mode.toml", settings);
}

// A branch at N modes with multipliers and admissibility at every point; the counter scales the
// time to 200 points.
void TraceBranch(benchmark::State& state) {
  const Scene scene =
      one_mode_scene({"beam.modes=" + std::to_string(state.range(0)), "forcing.frequency=100"});
  const SystemFamily family(scene, "forcing.frequency");
  BranchOptions options;
  options.from = 95.0;
  options.to = 120.0;
  options.max_step = 0.12;
  options.start_values = 0;
  options.keep_virtual = true;
  options.finder.from_simulation = options.finder.from_random = false;
  std::size_t points = 0;
  for (auto _ : state) {
    const OrbitBranches traced = trace_orbits(family, options);
    for (const OrbitBranch& branch : traced.branches) points += branch.points.size();
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(state.iterations());
  state.counters["s_per_200_points"] =
      benchmark::Counter(static_cast<double>(points) / 200.0,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(TraceBranch)->Arg(1)->Arg(2)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

// The fold locus of the beam over frequency and gap, from one fold: its points, special ones and
// what makes them orbits of the system.
void TraceLocus(benchmark::State& state) {
  const Scene scene =
      one_mode_scene({"beam.modes=" + std::to_string(state.range(0)), "forcing.frequency=47"});
  LocusOptions range;
  range.first_from = 46.0;
  range.first_to = 52.0;
  range.second_from = 1e-3;
  range.second_to = 0.01;
  range.max_step = 0.01;
  const ClosedForm form = *closed_form(assemble(scene), 0, 1).form;
  const double gap = std::abs(form.kappa) * (1.0 - 1e-9);
  const OrbitLocusStart start{
      OrbitLocusKind::kFold, {{1, {0}}, {form.solutions(gap).front()}, 0}, 47.0, gap, 1.0};
  std::size_t points = 0;
  for (auto _ : state) {
    LocusTracer loci(scene, "forcing.frequency", "stop.gap", range, {}, {});
    points += loci.trace(start).trace->places.size();
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(state.iterations());
  state.counters["s_per_200_points"] =
      benchmark::Counter(static_cast<double>(points) / 200.0,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(TraceLocus)->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

// Orbits of the beam that rests on its stop in every period, over the forcing frequency.
void TraceSticking(benchmark::State& state) {
  const SystemFamily family(read_scene(GRAZE_SOURCE_DIR "/data/scenes/09_soft_stop_two_modes.toml"),
                            "forcing.frequency");
  BranchOptions options;
  options.from = 35.0;
  options.to = 40.0;
  std::size_t points = 0;
  for (auto _ : state) {
    const OrbitBranches traced = trace_orbits(family, options);
    for (const OrbitBranch& branch : traced.branches) points += branch.points.size();
  }
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(state.iterations());
}
BENCHMARK(TraceSticking)->Unit(benchmark::kMillisecond);

// What `graze orbit` does on the beam of scene 14 against a steel ball, on one core.
void FindCompliantOrbit(benchmark::State& state) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/14_beam_against_a_ball.toml");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const FinderOptions options;
  std::size_t orbits = 0;
  for (auto _ : state) orbits = find_orbits(system, start, options).orbits.size();
  state.counters["orbits"] = static_cast<double>(orbits);
}
BENCHMARK(FindCompliantOrbit)->Unit(benchmark::kMillisecond);

// 3000 forcing periods of scene 05: 2999 impacts, no chatter.
void SimulateOneMode(benchmark::State& state) {
  const Scene scene = one_mode_scene({});
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.periods = 3000;
  long long impacts = 0;
  for (auto _ : state) impacts = simulate(system, start, options).totals.impacts;
  state.counters["impacts"] = static_cast<double>(impacts);
}
BENCHMARK(SimulateOneMode)->Unit(benchmark::kMillisecond);

// Scene 02, four modes, momentum law: 10 s with chatter, sticking and release.
void SimulateChatter(benchmark::State& state) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/02_wagg_momentum.toml");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.duration = 10.0;
  options.energy = state.range(0) != 0;
  long long impacts = 0;
  for (auto _ : state) impacts = simulate(system, start, options).totals.impacts;
  state.counters["impacts"] = static_cast<double>(impacts);
}
BENCHMARK(SimulateChatter)->ArgName("energy")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// The same beam with a gap of 5 mm for 1000 forcing periods.
void SimulateWideGap(benchmark::State& state) {
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/02_wagg_momentum.toml",
                                 {"stop.gap=5e-3", "beam.modes=" + std::to_string(state.range(0))});
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.periods = 1000;
  long long impacts = 0;
  for (auto _ : state) impacts = simulate(system, start, options).totals.impacts;
  state.counters["impacts"] = static_cast<double>(impacts);
}
BENCHMARK(SimulateWideGap)->ArgName("modes")->Arg(1)->Arg(4)->Arg(8)->Unit(benchmark::kMillisecond);

// 10 s of the beam of scene 13 against a spring: linear (0) and Hertz (1).
void SimulateCompliant(benchmark::State& state) {
  std::vector<std::string> settings;
  if (state.range(0) != 0)
    settings = {
        "stop.spring.stiffness=3.2e9", "stop.spring.exponent=1.5",
        "stop.spring.damping={ model = \"hunt-crossley\", restitution = 0.8, speed = 0.1 }"};
  const Scene scene =
      read_scene(GRAZE_SOURCE_DIR "/data/scenes/13_beam_on_a_spring.toml", settings);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.duration = 10.0;
  long long contacts = 0;
  for (auto _ : state) contacts = simulate(system, start, options).totals.impacts;
  state.counters["contacts"] = static_cast<double>(contacts);
}
BENCHMARK(SimulateCompliant)->ArgName("hertz")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// 1.5 s of the rotating beams of scenes 17, 18 and 19, on the flow that they ask for.
void SimulateHub(benchmark::State& state, const char* name) {
  const Scene scene = read_scene(std::string(GRAZE_SOURCE_DIR "/data/scenes/") + name);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.duration = 1.5;
  options.steps = step_choice(scene, system, start);
  long long impacts = 0;
  for (auto _ : state) impacts = simulate(system, start, options).totals.impacts;
  state.counters["impacts"] = static_cast<double>(impacts);
}
BENCHMARK_CAPTURE(SimulateHub, lee_wang_1, "17_yigit_lee_wang_1.toml")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SimulateHub, lee_wang_2, "18_yigit_lee_wang_2.toml")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SimulateHub, momentum, "19_yigit_momentum.toml")->Unit(benchmark::kMillisecond);

// The same for 1000 forcing periods without (0) and with (1) one effect; instructions of such pairs
// are counted in docs/accuracy.md.
void SimulateEffect(benchmark::State& state, const std::vector<std::string>& settings,
                    double samples, bool energy) {
  std::vector<std::string> all = {"stop.gap=5e-3"};
  if (state.range(0) != 0) all.insert(all.end(), settings.begin(), settings.end());
  const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/02_wagg_momentum.toml", all);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.periods = 1000;
  options.energy = energy && state.range(0) != 0;
  RunListeners listeners;
  if (samples > 0.0 && state.range(0) != 0) {
    listeners.sample = [](const Sample& sample) { benchmark::DoNotOptimize(sample.state.q[0]); };
    listeners.sample_rate = samples / system.period();
  }
  long long impacts = 0;
  for (auto _ : state) impacts = simulate(system, start, options, listeners).totals.impacts;
  state.counters["impacts"] = static_cast<double>(impacts);
}
#define GRAZE_EFFECT(name, settings, samples, energy)                \
  BENCHMARK_CAPTURE(SimulateEffect, name, settings, samples, energy) \
      ->ArgName("with")                                              \
      ->Arg(0)                                                       \
      ->Arg(1)                                                       \
      ->Unit(benchmark::kMillisecond)
using Settings = std::vector<std::string>;
GRAZE_EFFECT(samples, Settings{}, 20.0, false);
GRAZE_EFFECT(energy_balance, Settings{}, 0.0, true);
GRAZE_EFFECT(gravity, Settings{"gravity.acceleration=9.81"}, 0.0, false);
GRAZE_EFFECT(restitution_of_speed, Settings{"stop.restitution=[0.8, 0.01]"}, 0.0, false);
GRAZE_EFFECT(collocation_impulse, Settings{"stop.impulse=\"collocation\""}, 0.0, false);
#undef GRAZE_EFFECT

// 1000 values of the forcing frequency of scene 05, up to 1000 forcing periods at each: fewer where
// the motion settles, or all of them (nearness 0); on one or two threads, for which real time
// counts.
void SweepOneMode(benchmark::State& state) {
  const SystemFamily family(one_mode_scene({}), "forcing.frequency");
  SweepOptions options;
  options.from = 15.0;
  options.to = 120.0;
  options.points = 1000;
  options.threads = static_cast<int>(state.range(1));
  if (state.range(0) != 0) options.nearness = 0.0;
  long long periods = 0, impacts = 0;
  for (auto _ : state) {
    const Sweep swept = sweep(family, options);
    periods = swept.periods;
    impacts = swept.impacts;
  }
  state.counters["periods"] = static_cast<double>(periods);
  state.counters["impacts"] = static_cast<double>(impacts);
}
BENCHMARK(SweepOneMode)
    ->ArgNames({"all_periods", "threads"})
    ->ArgsProduct({{0, 1}, {1, 2}})
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace graze

BENCHMARK_MAIN();
