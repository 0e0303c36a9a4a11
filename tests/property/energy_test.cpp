// The energy balance closes along every run, and what each entry may be.
#include "graze/motion/simulation.hpp"
#include "property/scene_property.hpp"

namespace graze {
namespace {

using property::Prepared;
using property::relative;
using property::Summary;

constexpr double kDefect = 1e-10;
// The shares of an impact that brings the structure to rest on several stops may be of either sign
// and cancel: 4 roundings of its energy. A run meets a corner that does that in few places; 64.
constexpr double kAddedByMomentumLaw = 256.0 * std::numeric_limits<double>::epsilon();

bool momentum_law(const Scene& scene) {
  return std::all_of(scene.stops.begin(), scene.stops.end(),
                     [](const SceneStop& stop) { return stop.impulse == Impulse::kMomentum; });
}

// Energy of the forced response and of the rest position under load, J. Where the motion is small
// against them, at first or at a beat's low, the terms of the work are of this size and cancel.
double energy_scale(const System& system) {
  constexpr double kLargestAmplification = 256.0;  // beyond it a mode counts as resonant
  double scale = 0.0;
  for (Eigen::Index j = 0; j < system.omega.size(); ++j) {
    const double omega = system.omega[j];
    double speed = 0.0, quickest = omega;
    const auto add = [&](double frequency, double force) {
      quickest = std::max(quickest, frequency);
      const double impedance = std::hypot((omega - frequency) * (omega + frequency),
                                          2.0 * system.delta()[j] * frequency);
      const double larger = std::max(omega, frequency);
      speed +=
          std::abs(force) * larger / std::max(impedance, larger * larger / kLargestAmplification);
    };
    if (const HarmonicForcing* forcing = system.forcing()) {
      add(forcing->frequency, forcing->amplitude[j]);
      for (const Harmonic& one : forcing->harmonics)
        add(one.order * forcing->frequency, std::hypot(one.cosine[j], one.sine[j]));
    }
    if (system.load() && quickest > 0.0) speed += std::abs((*system.load())[j]) / quickest;
    scale += 0.5 * speed * speed;
  }
  // The moments from which works under several harmonics come are rounded at the power of the
  // response over a whole flight, once for each radian that its quickest mode turns.
  constexpr double kCounted = 256.0;  // roundings that size_of() counts anyway
  if (system.harmonics())
    scale *= std::max(1.0, std::pow(system.omega.maxCoeff() * system.first_period(), 2) / kCounted);
  return scale;
}

// Of the largest entry, or roundings of the terms that entries are made of.
double size_of(const EnergyBalance& balance, double scale) {
  constexpr double kRounding = 256.0 * std::numeric_limits<double>::epsilon();
  return balance.size() + kRounding / kDefect * scale;
}

void check_balance(const EnergyBalance& balance, double scale, bool momentum, double time,
                   Summary& summary) {
  // An oblique law can make the motion grow until its squares leave the range.
  if (!momentum && !(balance.size() < 1e100)) return;
  const double size = size_of(balance, scale);
  const std::string when = fmt::format(
      "at t = {:.17g} s: start {:.6g}, now {:.6g}, forcing {:.6g}, load {:.6g}, constraint {:.6g}, "
      "impacts {:.6g}, dissipation {:.6g}",
      time, balance.start, balance.now, balance.work.forcing, balance.work.load,
      balance.work.constraint, balance.impacts, balance.work.dissipation);
  summary.require("defect/size", relative(std::abs(balance.defect()), size), kDefect, when);
  summary.require("-dissipation/size", relative(-balance.work.dissipation, size), kDefect, when);
  if (momentum)
    summary.require("work of constraint/size, momentum law",
                    relative(std::abs(balance.work.constraint), size), kDefect, when);
}

TEST(RandomScene, EnergyBalanceCloses) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    SimulationOptions options;
    const double unit = support::time_unit(prepared);
    options.duration = property::kPeriods * unit;
    options.max_impacts = property::kMostImpacts;
    options.energy = true;
    const bool momentum = momentum_law(prepared.scene);
    const double scale = energy_scale(prepared.system);
    RunListeners listeners;
    // The work up to a sample costs as much as that of a whole arc.
    listeners.sample_rate = std::max(3.0, property::samples_per_period() / 1e4) / unit;
    listeners.sample = [&](const Sample& sample) {
      check_balance(*sample.energy, scale, momentum, sample.time, summary);
    };
    const Simulation run = simulate(prepared.system, prepared.start, options, listeners);
    check_balance(*run.energy, scale, momentum, run.end_time, summary);
    const EnergyBalance& balance = *run.energy;
    const RunTotals& totals = run.totals;
    if (momentum)
      summary.require("energy added by impacts/size, momentum law",
                      relative(totals.energy_added, size_of(balance, scale)), kAddedByMomentumLaw,
                      "at the end");
    if (totals.energy_added > 0.0) summary.count("scenes whose impacts add energy");
    if (balance.work.constraint != 0.0) summary.count("scenes whose stops do work");
    summary.count("scenes");
    summary.count("impacts", totals.impacts);
  });
}

}  // namespace
}  // namespace graze
