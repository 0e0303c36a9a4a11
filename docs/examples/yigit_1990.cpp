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
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/angle.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/report/gnuplot.hpp"
#include "graze/report/picture_style.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/processor_time.hpp"

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

bool begins(const Event& event) {
  return event.kind == EventKind::kImpact || event.kind == EventKind::kContact;
}

// When the sets of impacts begin, and how many impacts each has.
std::vector<std::pair<double, int>> sets_of(const Run& run) {
  std::vector<std::pair<double, int>> sets;
  double last = -1.0;
  for (const Event& event : run.events) {
    if (!begins(event)) continue;
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

// Mean angular acceleration over the first contact, rad/s^2.
double acceleration_at_impact(const Scene& scene) {
  const Run whole = run(scene, 0.4, 10.0);
  double entry = 0.0, exit = 0.0;
  for (const Event& event : whole.events) {
    if (entry == 0.0 && begins(event)) entry = event.time;
    if (exit == 0.0 && event.kind == EventKind::kSeparation) exit = event.time;
  }
  if (exit == 0.0) return 0.0;
  const auto rate_at = [&](double time) { return run(scene, time, 10.0).last_rate; };
  return (rate_at(exit) - rate_at(entry)) / (exit - entry);
}

void print_case(const Case& c) {
  const Scene scene = read_scene(c.scene);
  const Run three = run(scene);
  const auto sets = sets_of(three);
  std::printf("%s\n  sets of impacts:", c.name);
  for (const auto& [time, count] : sets) std::printf(" %.4f s (%d)", time, count);
  std::printf("\n  largest strain %.4g, rate %.4g rad/s\n", largest(three.strain),
              largest(three.rate));
  for (const Event& event : three.events)
    if (event.kind == EventKind::kSeparation && event.effective_restitution) {
      std::printf("  first contact: %.4g s, %.4g N, effective restitution %.4f\n", event.duration,
                  event.peak_force, *event.effective_restitution);
      break;
    }
  std::printf("  dominant frequency after the first set: %.2f Hz\n",
              dominant_frequency(three, sets[0].first + 0.02, sets[1].first));
  if (const double acceleration = acceleration_at_impact(scene); acceleration != 0.0)
    std::printf("  mean angular acceleration over the first contact: %.4g rad/s^2\n", acceleration);
  for (const int modes : {5, 7}) {
    const Run more = run(with_modes(c.scene, modes));
    std::printf("  %d modes: sets", modes);
    for (const auto& [time, count] : sets_of(more)) std::printf(" %.4f s (%d)", time, count);
    std::printf(", largest strain %.4g\n", largest(more.strain));
  }
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options;
  options.duration = kEnd;
  options.closure_speed = default_closure_speed(system, start, scene.solver.tolerance);
  std::printf("  computing time %.3f s\n",
              least_time([&] { simulate(system, start, options); }, 1.0));
}

void draw(const std::string& file) {
  GnuplotScript script;
  set_style(script);
  script.command("set multiplot");
  for (int column = 0; column < 2; ++column) {
    const Run shown = run(read_scene(kCases[column].scene), kEnd, 4000.0);
    PlotTable rate, strain;
    for (std::size_t i = 0; i < shown.times.size(); ++i) {
      rate.row({shown.times[i], shown.rate[i]});
      strain.row({shown.times[i], 1e6 * shown.strain[i]});
    }
    const std::string name = std::to_string(column + 1);
    script.data("rate" + name, rate);
    script.data("strain" + name, strain);
    const double left = column == 0 ? 0.16 : 0.635, right = left + 0.345;
    for (int row = 0; row < 2; ++row) {
      Margins margins{left, 1.0 - right, row == 0 ? 0.58 : 0.14, row == 0 ? 0.08 : 0.50};
      set_margins(script, margins);
      script.command(row == 0 ? "set format x ''" : "set format x '%g'");
      script.command("set xrange [0:1.5]\nset xtics 0.5");
      script.command(row == 0 ? "set yrange [-12:12]\nset ytics 6"
                              : "set yrange [-250:250]\nset ytics 125");
      script.command("unset label");
      if (row == 0)
        script.command("set label 1 '" + std::string(kCases[column].name) +
                       "' at graph 0.5, graph 1.08 center");
      script.command(row == 1 ? "set xlabel 'time (s)'" : "unset xlabel");
      if (column == 0)
        name_vertical_axis(script, row == 0 ? "hub’s rate" : "strain",
                           row == 0 ? "rad/s" : "10^{-6}");
      script.plot({std::string("$") + (row == 0 ? "rate" : "strain") + name +
                   " using 1:2 with lines lw 0.8 lc rgb '" + (row == 0 ? kBlue : kVermillion) +
                   "' notitle"});
    }
  }
  script.command("unset multiplot");
  draw_picture(file, script, 0.75);
}

}  // namespace

int main(int count, char** words) try {
  if (count > 1)
    draw(words[1]);
  else
    for (const Case& c : kCases) print_case(c);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
