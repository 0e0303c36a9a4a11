// The study of A. S. Yigit, A. G. Ulsoy, R. A. Scott, J. Sound Vib. 137 (1990) 183-203, with Graze:
// the numbers and the picture of docs/yigit_1990.md. Run from the project's root:
//
//   example_yigit_1990                    prints the numbers
//   example_yigit_1990 PICTURE.svg        draws angular velocity and strain of both damping models
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/angle.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/report/picture/pictures.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/processor_time.hpp"
#include "graze/study/run_impact.hpp"

using namespace graze;

namespace {

constexpr double kEnd = 1.5;      // s
constexpr double kRate = 5000.0;  // 1/s
constexpr double kApart = 0.05;   // s: impacts further apart are of another set

struct Case {
  const char* name;
  const char* scene;
};
constexpr Case kCases[] = {{"first damping model", "data/scenes/17_yigit_lee_wang_1.toml"},
                           {"second damping model", "data/scenes/18_yigit_lee_wang_2.toml"},
                           {"momentum balance", "data/scenes/19_yigit_momentum.toml"}};

struct Run {
  std::vector<Event> events;
  std::vector<double> times, rate, strain;
  double last_rate = 0.0;  // at the end
};

Run run(const Scene& scene, double end = kEnd, double sample_rate = kRate) {
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  const std::vector<ProbeRow> probes = probe_rows(scene, system);
  Run run;
  SimulationOptions options;
  options.duration = end;
  options.closure_speed = default_closure_speed(system, start, scene.solver.tolerance);
  RunListeners listeners;
  listeners.event = [&](const Event& event) { run.events.push_back(event); };
  listeners.sample = [&](const Sample& sample) {
    run.times.push_back(sample.time);
    run.rate.push_back(probes[0].value(sample.state));
    run.strain.push_back(probes[1].value(sample.state));
  };
  listeners.sample_rate = sample_rate;
  run.last_rate = probes[0].value(simulate(system, start, options, listeners).final);
  return run;
}

// When the sets of impacts begin, and how many impacts each has.
std::vector<std::pair<double, int>> sets_of(const Run& run) {
  std::vector<std::pair<double, int>> sets;
  double last = -1.0;
  for (const Event& event : run.events) {
    if (!meets_stop(event)) continue;
    if (sets.empty() || event.time - last > kApart) sets.emplace_back(event.time, 0);
    ++sets.back().second;
    last = event.time;
  }
  return sets;
}

// Hz: where the strain between two instants has its largest Fourier coefficient under Hann's
// window.
double dominant_frequency(const Run& run, double from, double to) {
  double best = 0.0, frequency = 0.0;
  for (double f = 20.0; f <= 300.0; f += 0.1) {
    double re = 0.0, im = 0.0;
    for (std::size_t i = 0; i < run.times.size(); ++i) {
      const double t = run.times[i];
      if (t < from || t > to) continue;
      const double window = 0.5 - 0.5 * std::cos(kTurn * (t - from) / (to - from));
      re += window * run.strain[i] * std::cos(kTurn * f * t);
      im += window * run.strain[i] * std::sin(kTurn * f * t);
    }
    if (std::hypot(re, im) > best) {
      best = std::hypot(re, im);
      frequency = f;
    }
  }
  return frequency;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

Scene with_modes(const char* scene, int modes) {
  return read_scene(scene, {"beam.modes=" + std::to_string(modes)});
}

// Of the first contact, until its force is gone: what it was, and by how much the hub turned faster
// after it than before, on average over its time.
void print_first_contact(const Scene& scene, const Run& whole) {
  const auto parts = [](const Event& event) { return event.kind == EventKind::kSeparation; };
  const auto first = std::find_if(whole.events.begin(), whole.events.end(), parts);
  if (first == whole.events.end() || !first->effective_restitution) return;
  const auto rate_at = [&](double time) { return run(scene, time, 10.0).last_rate; };
  const double before = rate_at(first->time - first->duration), after = rate_at(first->time);
  std::printf("    first contact: %.4g s, %.4g N, effective restitution %.4f\n", first->duration,
              first->peak_force, *first->effective_restitution);
  std::printf("    the hub meanwhile: %.3f to %.3f rad/s, on average %.4g rad/s^2\n", before, after,
              (after - before) / first->duration);
}

void print_sets(const std::vector<std::pair<double, int>>& sets) {
  std::printf("    sets of impacts:");
  for (const auto& [time, count] : sets) std::printf(" %.4f s (%d)", time, count);
  std::printf("\n");
}

void print_case(const Case& c) {
  std::printf("%s\n", c.name);
  for (const int modes : {3, 5, 7}) {
    const Scene scene = with_modes(c.scene, modes);
    const Run whole = run(scene);
    const auto sets = sets_of(whole);
    std::printf("  %d modes\n", modes);
    print_sets(sets);
    print_first_contact(scene, whole);
    std::printf("    largest strain %.4g, rate %.4g rad/s\n", largest(whole.strain),
                largest(whole.rate));
    if (sets.size() < 2) continue;
    const double quiet = sets[0].first + 0.02;
    double lowest = 0.0;
    for (std::size_t i = 0; i < whole.times.size(); ++i)
      if (whole.times[i] > sets[0].first && whole.times[i] < quiet)
        lowest = std::min(lowest, whole.rate[i]);
    std::printf("    within 20 ms of the first impact the rate falls to %.3g rad/s\n", lowest);
    if (modes == 3)
      std::printf("    dominant frequency after the first set: %.2f Hz\n",
                  dominant_frequency(whole, quiet, sets[1].first));
  }
  const Scene scene = read_scene(c.scene);
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.duration = kEnd;
  options.closure_speed = default_closure_speed(system, start, scene.solver.tolerance);
  std::printf("  computing time %.3f s\n",
              least_time([&] { simulate(system, start, options); }, 1.0));
}

// How the third set moves with the gap.
void print_chaos() {
  std::printf("third set of the first model\n");
  for (const char* gap : {"0.180", "0.181", "0.182", "0.183", "0.185"}) {
    const Scene scene = read_scene(kCases[0].scene, {std::string("stop.gap=") + gap});
    const auto sets = sets_of(run(scene, kEnd, 10.0));
    std::printf("  gap %s m: third set at %.2f s\n", gap, sets.size() > 2 ? sets[2].first : 0.0);
  }
}

ChartPanel panel(const Run& shown, const std::vector<double>& values, ChartAxis axis,
                 const char* colour) {
  ChartSeries curve{.look = {.colour = colour, .width = 0.8}, .x = shown.times, .y = values};
  return {.x = {.name = "time", .unit = "s", .range = {0.0, kEnd}},
          .y = std::move(axis),
          .series = {std::move(curve)},
          .height = 2.8};
}

void draw(const std::string& file) {
  std::vector<ChartPanel> rates, strains;
  for (const Case* c : {&kCases[0], &kCases[1]}) {
    const Run shown = run(read_scene(c->scene), kEnd, 4000.0);
    rates.push_back(panel(shown, shown.rate,
                          {.name = "hub's rate", .unit = "rad/s", .range = {-12.0, 12.0}}, kBlue));
    rates.back().heading = c->name;
    strains.push_back(
        panel(shown, shown.strain, {.name = "strain", .range = {-250e-6, 250e-6}}, kVermillion));
  }
  draw_chart(file, RunInfo{}, {"", {rates, strains}});
}

}  // namespace

int main(int count, char** words) try {
  if (count > 1)
    draw(words[1]);
  else
    for (const Case& c : kCases) print_case(c);
  if (count == 1) print_chaos();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
