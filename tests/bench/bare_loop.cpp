// What Graze's flows that take steps cost beside a bare loop around the same Boost.Odeint calls:
// pairs StepsOfGraze/<flow>, BareLoop/<flow> on one scene. `graze cost` compares the exact flow
// with the former; that is fair as long as little is lost between the two. The loop knows this
// scene alone: so many modes, one stop, constant restitution, no load, no chatter, no sticking.
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
#include "graze/motion/simulation.hpp"
#include "graze/scene/reader.hpp"
#include "graze/study/cost/step_choice.hpp"

namespace graze {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr long long kPeriods = 10;

struct SteppedBeam {
  System system;
  State start;
  StepSetting setting;

  SteppedBeam(std::size_t modes, const std::vector<std::string>& flow) {
    std::vector<std::string> settings = flow;
    settings.push_back("stop.gap=5e-3");
    settings.push_back("beam.modes=" + std::to_string(modes));
    const Scene scene = read_scene(GRAZE_SOURCE_DIR "/data/scenes/02_wagg_momentum.toml", settings);
    system = assemble(scene);
    start = initial_state(scene, system);
    setting = *step_choice(scene, system, start);
  }
};

// The displacements times a frequency, then the velocities: Graze's scaling (step_flow.hpp), with
// which one tolerance means the same here and there.
template <std::size_t Modes>
using BeamState = std::array<double, 2 * Modes>;

template <std::size_t Modes>
class BareBeam {
 public:
  using State = BeamState<Modes>;
  static constexpr std::size_t kModes = Modes;

  explicit BareBeam(const SteppedBeam& beam)
      : frequency_(beam.system.forcing()->frequency), phase_(beam.system.forcing()->phase) {
    const System& system = beam.system;
    const Stop& stop = system.stops.front();
    clearance_ = stop.gap;
    rebound_ = 1.0 + stop.restitution().at_rest();
    for (std::size_t j = 0; j < kModes; ++j) {
      const auto mode = static_cast<Eigen::Index>(j);
      const double omega = system.omega[mode];
      scale_[j] = std::max(omega, frequency_);
      stiffness_[j] = omega * omega / scale_[j];
      damping_[j] = 2.0 * system.delta()[mode];
      force_[j] = system.forcing()->amplitude[mode];
      reach_[j] = stop.row[mode] / scale_[j];
      row_[j] = stop.row[mode];
      direction_[j] = stop.direction()[mode];
      start[j] = scale_[j] * beam.start.q[mode];
      start[kModes + j] = beam.start.qdot[mode];
    }
  }

  // The two never overlap; a compiler that is told takes two modes at once.
  void operator()(const State& __restrict x, State& __restrict slope, double t) {
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
  double gap(const State& x) const {
    double gap = clearance_;
    for (std::size_t j = 0; j < kModes; ++j) gap -= reach_[j] * x[j];
    return gap;
  }
  void impact(State& x) {
    double speed = 0.0;
    for (std::size_t j = 0; j < kModes; ++j) speed += row_[j] * x[kModes + j];
    for (std::size_t j = 0; j < kModes; ++j) x[kModes + j] -= rebound_ * speed * direction_[j];
    ++impacts;
  }

  State start{};
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

template <std::size_t Modes>
void step_with_rk4(BareBeam<Modes>& beam, const StepSetting& setting, double end) {
  odeint::runge_kutta4<BeamState<Modes>> stepper;
  BeamState<Modes> x = beam.start, before = x, within = x;
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

template <std::size_t Modes>
void step_with_dopri5(BareBeam<Modes>& beam, const StepSetting& setting, double end) {
  using Method = odeint::runge_kutta_dopri5<BeamState<Modes>>;
  auto stepper = odeint::make_dense_output(setting.tolerance * setting.speed, setting.tolerance,
                                           setting.longest, Method());
  stepper.initialize(beam.start, 0.0, setting.longest);
  BeamState<Modes> x{};
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

void StepsOfGraze(benchmark::State& state, std::size_t modes,
                  const std::vector<std::string>& flow) {
  const SteppedBeam beam(modes, flow);
  Simulation run;
  for (auto _ : state) run = simulated(beam);
  state.counters["impacts"] = static_cast<double>(run.totals.impacts);
  state.counters["evaluations"] = static_cast<double>(run.evaluations);
}

template <std::size_t Modes>
void BareLoop(benchmark::State& state, const std::vector<std::string>& flow,
              void (*stepping)(BareBeam<Modes>&, const StepSetting&, double)) {
  const SteppedBeam beam(Modes, flow);
  BareBeam<Modes> bare(beam);
  for (auto _ : state) {
    bare.impacts = bare.evaluations = 0;
    stepping(bare, beam.setting, kPeriods * beam.system.period());
  }
  state.counters["impacts"] = static_cast<double>(bare.impacts);
  state.counters["evaluations"] = static_cast<double>(bare.evaluations);
  if (bare.impacts != simulated(beam).totals.impacts)
    state.SkipWithError("the bare loop and Graze differ in their impacts");
}

template <std::size_t Modes>
void add_pairs() {
  const std::vector<std::string> rk4 = {"solver.flow=\"rk4\"", "solver.step=1e-5"};
  const std::vector<std::string> dopri5 = {"solver.flow=\"dopri5\"", "solver.tolerance=1e-9"};
  const auto add = [](const std::string& flow, const std::vector<std::string>& settings,
                      void (*stepping)(BareBeam<Modes>&, const StepSetting&, double)) {
    const std::string name = "/" + flow + "/" + std::to_string(Modes);
    benchmark::RegisterBenchmark(("StepsOfGraze" + name).c_str(), StepsOfGraze, Modes, settings)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("BareLoop" + name).c_str(), BareLoop<Modes>, settings, stepping)
        ->Unit(benchmark::kMillisecond);
  };
  add("rk4", rk4, step_with_rk4<Modes>);
  add("dopri5", dopri5, step_with_dopri5<Modes>);
}

const bool kAdded = [] {
  add_pairs<1>();
  add_pairs<3>();
  add_pairs<4>();
  add_pairs<8>();
  return true;
}();

}  // namespace
}  // namespace graze
