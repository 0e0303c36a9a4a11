// What Graze's flows that take steps cost beside a bare loop around the same Boost.Odeint calls:
// pairs StepsOfGraze/<flow>, BareLoop/<flow> on one scene. `graze cost` compares the exact flow
// with the former; that is fair as long as little is lost between the two. The loop knows this
// scene alone: four modes, one stop, constant restitution, no load, no chatter, no sticking.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/step_choice.hpp"

namespace graze {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr long long kPeriods = 10;
constexpr std::size_t kModes = 4;

struct SteppedBeam {
  System system;
  State start;
  StepSetting setting;

  explicit SteppedBeam(const std::vector<std::string>& flow) {
    std::vector<std::string> settings = flow;
    settings.emplace_back("stop.gap=5e-3");
    const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/02_wagg_momentum.toml", settings);
    system = assemble(scene);
    start = initial_state(scene, system);
    setting = *step_choice(scene, system, start);
  }
};

// The displacements times a frequency, then the velocities: Graze's scaling (step_flow.hpp), with
// which one tolerance means the same here and there.
using Course = std::array<double, 2 * kModes>;

class BareBeam {
 public:
  explicit BareBeam(const SteppedBeam& beam)
      : frequency_(beam.system.forcing->frequency), phase_(beam.system.forcing->phase) {
    const System& system = beam.system;
    const RigidStop& stop = system.stops.front();
    clearance_ = stop.gap;
    rebound_ = 1.0 + stop.restitution.at_rest();
    for (std::size_t j = 0; j < kModes; ++j) {
      const auto mode = static_cast<Eigen::Index>(j);
      const double omega = system.omega[mode];
      scale_[j] = std::max(omega, frequency_);
      stiffness_[j] = omega * omega / scale_[j];
      damping_[j] = 2.0 * system.delta[mode];
      force_[j] = system.forcing->amplitude[mode];
      reach_[j] = stop.row[mode] / scale_[j];
      row_[j] = stop.row[mode];
      direction_[j] = stop.direction[mode];
      start[j] = scale_[j] * beam.start.q[mode];
      start[kModes + j] = beam.start.qdot[mode];
    }
  }

  // The two never overlap; a compiler that is told takes two modes at once.
  void operator()(const Course& __restrict x, Course& __restrict slope, double t) {
    ++evaluations;
    // Stages come in pairs at one instant.
    if (t != known_at_) {
      known_at_ = t;
      cosine_ = std::cos(frequency_ * t + phase_);
    }
    for (std::size_t j = 0; j < kModes; ++j) {
      slope[j] = scale_[j] * x[kModes + j];
      slope[kModes + j] = force_[j] * cosine_ - damping_[j] * x[kModes + j] - stiffness_[j] * x[j];
    }
  }
  double gap(const Course& x) const {
    double gap = clearance_;
    for (std::size_t j = 0; j < kModes; ++j) gap -= reach_[j] * x[j];
    return gap;
  }
  void impact(Course& x) {
    double speed = 0.0;
    for (std::size_t j = 0; j < kModes; ++j) speed += row_[j] * x[kModes + j];
    for (std::size_t j = 0; j < kModes; ++j) x[kModes + j] -= rebound_ * speed * direction_[j];
    ++impacts;
  }

  Course start{};
  long long impacts = 0, evaluations = 0;

 private:
  double frequency_, phase_, clearance_ = 0.0, rebound_ = 0.0;
  double known_at_ = -1.0, cosine_ = 1.0;
  std::array<double, kModes> scale_{}, stiffness_{}, damping_{}, force_{}, reach_{}, row_{},
      direction_{};
};

template <class Gap>
double zero_within(const Gap& gap, double from, double to) {
  std::uintmax_t iterations = 100;
  return boost::math::tools::toms748_solve(gap, from, to,
                                           boost::math::tools::eps_tolerance<double>(), iterations)
      .second;
}

void step_with_rk4(BareBeam& beam, const StepSetting& setting, double end) {
  odeint::runge_kutta4<Course> stepper;
  Course x = beam.start, before = x, within = x;
  for (double t = 0.0; t < end;) {
    before = x;
    stepper.do_step(std::ref(beam), before, t, x, setting.step);
    if (beam.gap(x) > 0.0) {
      t += setting.step;
      continue;
    }
    const auto gap = [&](double s) {
      stepper.do_step(std::ref(beam), before, t, within, s);
      return beam.gap(within);
    };
    const double s = zero_within(gap, 0.0, setting.step);
    t += s;
    if (t > end) return;
    stepper.do_step(std::ref(beam), before, t - s, x, s);
    beam.impact(x);
  }
}

void step_with_dopri5(BareBeam& beam, const StepSetting& setting, double end) {
  using Method = odeint::runge_kutta_dopri5<Course>;
  auto stepper = odeint::make_dense_output(setting.tolerance * setting.speed, setting.tolerance,
                                           setting.longest, Method());
  stepper.initialize(beam.start, 0.0, setting.longest);
  Course x{};
  while (stepper.current_time() < end) {
    stepper.do_step(std::ref(beam));
    if (beam.gap(stepper.current_state()) > 0.0) continue;
    const auto gap = [&](double t) {
      stepper.calc_state(t, x);
      return beam.gap(x);
    };
    const double t = zero_within(gap, stepper.previous_time(), stepper.current_time());
    if (t > end) return;
    stepper.calc_state(t, x);
    beam.impact(x);
    stepper.initialize(x, t, stepper.current_time_step());
  }
}

Simulation simulated(const SteppedBeam& beam) {
  SimulationOptions options;
  options.periods = kPeriods;
  options.steps = beam.setting;
  return simulate(beam.system, beam.start, options);
}

void StepsOfGraze(benchmark::State& state, const std::vector<std::string>& flow) {
  const SteppedBeam beam(flow);
  Simulation run;
  for (auto _ : state) run = simulated(beam);
  state.counters["impacts"] = static_cast<double>(run.totals.impacts);
  state.counters["evaluations"] = static_cast<double>(run.evaluations);
}

template <class Stepping>
void BareLoop(benchmark::State& state, const std::vector<std::string>& flow,
              const Stepping& stepping) {
  const SteppedBeam beam(flow);
  BareBeam bare(beam);
  for (auto _ : state) {
    bare.impacts = bare.evaluations = 0;
    stepping(bare, beam.setting, kPeriods * beam.system.period());
  }
  state.counters["impacts"] = static_cast<double>(bare.impacts);
  state.counters["evaluations"] = static_cast<double>(bare.evaluations);
  if (bare.impacts != simulated(beam).totals.impacts)
    state.SkipWithError("the bare loop and Graze differ in their impacts");
}

const std::vector<std::string> kRk4 = {"solver.flow=\"rk4\"", "solver.step=1e-5"};
const std::vector<std::string> kDopri5 = {"solver.flow=\"dopri5\"", "solver.tolerance=1e-9"};
BENCHMARK_CAPTURE(StepsOfGraze, rk4, kRk4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BareLoop, rk4, kRk4, step_with_rk4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(StepsOfGraze, dopri5, kDopri5)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BareLoop, dopri5, kDopri5, step_with_dopri5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace graze
