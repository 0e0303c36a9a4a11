// What the measures of a motion have to be, whatever the motion: momentum balances mode by mode,
// and nothing sampled lies outside.
#include "graze/motion/simulation.hpp"
#include "property/scene_property.hpp"

namespace graze {
namespace {

using property::Prepared;
using property::relative;
using property::Summary;

// q'' = f(theta) + c - 2 delta q' - w^2 q - sum_i d_i |b_i|^2 F_i, integrated over the run.
TEST(RandomScene, MeasuredImpulsesBalanceTheMomentum) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    const System& system = prepared.system;
    SimulationOptions options;
    options.duration = property::kPeriods * support::time_unit(prepared);
    options.max_impacts = property::kMostImpacts;
    options.measure = MeasureOptions{};
    // A held structure's equations round by the squares of its quickest frequencies, and its means
    // divide that by those of its slowest.
    const double slowest =
        (system.omega.array() > 0.0).select(system.omega, system.omega.maxCoeff()).minCoeff();
    const double mean_limit =
        1e-12 + 8.0 * std::numeric_limits<double>::epsilon() *
                    (slowest > 0.0 ? std::pow(system.omega.maxCoeff() / slowest, 2) : 0.0);
    const std::vector<int> modes{0, system.modes() - 1};
    for (const int j : modes)
      options.measure->rows.push_back({Vector::Unit(system.modes(), j), false});
    const Simulation run = simulate(system, prepared.start, options);
    const Amplitudes& found = *run.amplitudes;
    if (!(run.end_time > 0.0)) return;
    const HarmonicForcing* forcing = system.forcing();
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const int j = modes[k];
      double sum = 0.0, size = 0.0;
      const auto add = [&](double term, double of) {
        sum += term;
        size += std::abs(of);
      };
      const double w = system.omega[j], delta = system.delta()[j];
      const Amplitude& q = found.rows[k];
      const double largest = q.largest();
      add(prepared.start.qdot[j], prepared.start.qdot[j]);
      add(-run.final.qdot[j], run.final.qdot[j]);
      add(-2.0 * delta * (run.final.q[j] - prepared.start.q[j]), 2.0 * delta * largest);
      add(-w * w * q.mean * found.duration, w * w * largest * found.duration);
      if (system.load())
        add((*system.load())[j] * run.end_time, (*system.load())[j] * run.end_time);
      if (forcing) {
        const auto add_harmonic = [&](double order, double cosine, double sine) {
          const double w = order * forcing->frequency, from = order * forcing->phase,
                       to = from + w * run.end_time;
          add((cosine * (std::sin(to) - std::sin(from)) - sine * (std::cos(to) - std::cos(from))) /
                  w,
              std::hypot(cosine, sine) / w * (1.0 + w * run.end_time));
        };
        add_harmonic(1, forcing->amplitude[j], 0.0);
        for (const Harmonic& one : forcing->harmonics)
          add_harmonic(one.order, one.cosine[j], one.sine[j]);
      }
      for (std::size_t i = 0; i < system.stops.size(); ++i) {
        const Stop& stop = system.stops[i];
        const double impulse =
            stop.direction()[j] * stop.row.squaredNorm() * found.stops[i].impulse;
        add(-impulse, impulse);
      }
      // An oblique law can make the motion grow until it leaves the range.
      if (!(size < 1e100)) continue;
      summary.require("momentum missing/size", relative(std::abs(sum), size), 1e-10,
                      fmt::format("mode {} until t = {:.17g} s", j + 1, run.end_time));
      summary.require("mean outside/size",
                      relative(std::max(q.mean - q.highest, q.lowest - q.mean), largest),
                      mean_limit, fmt::format("mode {}", j + 1));
      summary.require("|mean| over rms/size", relative(std::abs(q.mean) - q.rms, largest), 1e-10,
                      fmt::format("mode {}", j + 1));
    }
  });
}

TEST(RandomScene, MeasuredExtremesEncloseTheSamples) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    const System& system = prepared.system;
    if (system.stops.empty()) return;
    SimulationOptions options;
    const double unit = support::time_unit(prepared);
    options.duration = property::kPeriods * unit;
    options.max_impacts = property::kMostImpacts;
    const Vector& row = system.stops.front().row;
    options.measure = MeasureOptions{{{row, false}}, 0.0};
    double highest = -std::numeric_limits<double>::infinity(), lowest = -highest, fastest = 0.0;
    // Sums of parts round by their sizes.
    double size = 0.0, speed = 0.0;
    RunListeners listeners;
    listeners.sample_rate = std::max(3.0, property::samples_per_period() / 1e3) / unit;
    listeners.sample = [&](const Sample& sample) {
      highest = std::max(highest, row.dot(sample.state.q));
      lowest = std::min(lowest, row.dot(sample.state.q));
      fastest = std::max(fastest, std::abs(row.dot(sample.state.qdot)));
      size = std::max(size, row.cwiseAbs().dot(sample.state.q.cwiseAbs()));
      speed = std::max(speed, row.cwiseAbs().dot(sample.state.qdot.cwiseAbs()));
    };
    const Simulation run = simulate(system, prepared.start, options, listeners);
    const Amplitude& found = run.amplitudes->rows.front();
    if (!(run.end_time > 0.0) || !(found.largest() < 1e100)) return;
    // What is at rest may move by rounding, and samples be few.
    size = std::max(size, found.largest());
    speed = std::max(speed, system.omega.maxCoeff() * size);
    summary.require("sample above/size", relative(highest - found.highest, size), 1e-12, "");
    summary.require("sample below/size", relative(found.lowest - lowest, size), 1e-12, "");
    summary.require("sample faster/speed", relative(fastest - *found.speed, speed), 1e-12, "");
  });
}

}  // namespace
}  // namespace graze
