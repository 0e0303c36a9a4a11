// What holds at every instant of a run, looked at densely: nothing is ever beyond a stop, a contact
// force only presses and only where the stop is closed, what is stuck stays where it is. And every
// run ends for a reason that it states.
#include <Eigen/LU>

#include "graze/motion/simulation.hpp"
#include "property/scene_property.hpp"

namespace graze {
namespace {

using property::Prepared;
using property::relative;
using property::Summary;

// Of a length: some 5000 roundings. The roundings of the phases of the quickest modes are among
// them, up to 700 rad a period.
constexpr double kContactOfLength = 1e-12;
constexpr double kOfForce = 1e-12;
// A dot product of at most eight terms, through the reduced coordinates and back. (The gap has the
// wider bound: where a soft structure is held, its place of rest is far beyond its motion.)
constexpr double kContactOfSpeed = 1e-13;

// Which stops are closed, as told by the events.
class ClosedStops {
 public:
  ClosedStops(const Prepared& prepared, const SimulationOptions& options)
      : closed_(prepared.system.stops.size(), false) {
    SimulationOptions at_once = options;
    at_once.duration = 0.0;
    for (const int i : simulate(prepared.system, prepared.start, at_once).stuck) set(i, true);
  }
  void hear(const Event& event) {
    if (event.kind == EventKind::kChatter || event.kind == EventKind::kStick) set(event.stop, true);
    if (event.kind == EventKind::kRelease) set(event.stop, false);
  }
  bool holds(std::size_t i) const { return closed_[i]; }
  std::vector<std::size_t> list() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < closed_.size(); ++i)
      if (closed_[i]) all.push_back(i);
    return all;
  }

 private:
  void set(int i, bool closed) { closed_[static_cast<std::size_t>(i)] = closed; }
  std::vector<bool> closed_;
};

// Sizes of the terms of each contact force, N: of lambda = (B^T D)^-1 B^T (accelerations).
Vector force_sizes(const System& system, const State& state,
                   const std::vector<std::size_t>& closed) {
  Vector size = system.omega.cwiseAbs2().cwiseProduct(state.q).cwiseAbs() +
                2.0 * system.delta().cwiseProduct(state.qdot).cwiseAbs();
  if (system.load()) size += system.load()->cwiseAbs();
  if (system.forcing()) size += system.forcing()->amplitude.cwiseAbs();
  const auto k = static_cast<Eigen::Index>(closed.size());
  Matrix rows(system.modes(), k), directions(system.modes(), k);
  for (Eigen::Index a = 0; a < k; ++a) {
    const Stop& stop = system.stops[closed[static_cast<std::size_t>(a)]];
    rows.col(a) = stop.row;
    directions.col(a) = stop.direction();
  }
  const Matrix shares = rows * (rows.transpose() * directions).transpose().fullPivLu().inverse();
  Vector sizes(k);
  for (Eigen::Index a = 0; a < k; ++a)
    sizes[a] = shares.col(a).cwiseAbs().dot(size) / rows.col(a).squaredNorm();
  return sizes;
}

// Looks at every sample of one run.
class Watch {
 public:
  Watch(const Prepared& prepared, const SimulationOptions& options, Summary& summary)
      : system_(prepared.system),
        summary_(summary),
        closed_(prepared, options),
        reached_(prepared.system.stops.size(), 0.0) {}

  void hear(const Event& event) {
    closed_.hear(event);
    time_ = event.time;
  }

  void look(const Sample& sample) {
    ++samples_;
    for (std::size_t i = 0; i < system_.stops.size(); ++i) {
      const Stop& stop = system_.stops[i];
      const double size = stop.row.cwiseAbs().dot(sample.state.q.cwiseAbs());
      reached_[i] = std::max(reached_[i], size);
      const double length = property::length_at(system_, stop) + reached_[i];
      const double gap = stop.gap - stop.row.dot(sample.state.q);
      if (!smallest_ || gap < *smallest_) smallest_ = gap;
      length_ = std::max(length_, length);
      require("penetration/length", relative(-gap, length), kContactOfLength, sample, i);
      if (!closed_.holds(i)) {
        if (sample.forces[i] != 0.0)
          RC_FAIL(fmt::format("force {} at open stop {}, t = {:.17g} s", sample.forces[i], i + 1,
                              sample.time));
        continue;
      }
      require("gap while stuck/length", relative(std::abs(gap), length), kContactOfLength, sample,
              i);
      const double speed = stop.row.lpNorm<1>() * sample.state.qdot.lpNorm<Eigen::Infinity>();
      require("speed while stuck/speed", relative(std::abs(stop.row.dot(sample.state.qdot)), speed),
              kContactOfSpeed, sample, i);
    }
    look_at_forces(sample);
  }

  // No sample is nearer to a stop than the smallest gap of the run.
  void check_smallest_gap(const Simulation& run) {
    RC_ASSERT(run.totals.smallest_gap.has_value() == !system_.stops.empty());
    if (!smallest_) return;
    summary_.require("smallest gap missed by/length",
                     relative(*run.totals.smallest_gap - *smallest_, length_), kContactOfLength,
                     "at the end");
  }
  long long samples() const { return samples_; }

 private:
  void look_at_forces(const Sample& sample) {
    const std::vector<std::size_t> closed = closed_.list();
    if (closed.empty()) return;
    const Vector sizes = force_sizes(system_, sample.state, closed);
    for (std::size_t a = 0; a < closed.size(); ++a) {
      const double force = sample.forces[closed[a]], size = sizes[static_cast<Eigen::Index>(a)];
      require("pull/force", relative(-force, size), kOfForce, sample, closed[a]);
    }
  }
  void require(const char* name, double value, double limit, const Sample& sample, std::size_t i) {
    const auto [worst, first] = worst_.emplace(name, value);
    if (!first && value <= worst->second) return;
    worst->second = value;
    summary_.require(name, value, limit,
                     fmt::format("at stop {}, t = {:.17g} s; the event before: {:.17g} s", i + 1,
                                 sample.time, time_));
  }

  const System& system_;
  Summary& summary_;
  ClosedStops closed_;
  std::vector<double> reached_;
  std::map<const char*, double> worst_;  // what the summary has seen
  double time_ = 0.0;
  std::optional<double> smallest_;
  double length_ = 0.0;
  long long samples_ = 0;
};

// A run ends where it should or says why not.
void check_outcome(const Prepared& prepared, const Simulation& run, Summary& summary) {
  const bool oblique =
      std::any_of(prepared.scene.stops.begin(), prepared.scene.stops.end(),
                  [](const SceneStop& stop) { return stop.impulse == Impulse::kCollocation; });
  switch (run.outcome) {
    case RunOutcome::kReachedEnd:
      summary.count("reached the end");
      RC_ASSERT(run.message.empty());
      return;
    case RunOutcome::kEventBudget:
      summary.count(run.totals.impacts >= property::kMostImpacts ? "spent the impacts"
                                                                 : "undecided");
      break;
    case RunOutcome::kNotFinite:
      summary.count("grew beyond all numbers");
      if (!oblique || run.totals.energy_added < 1e100) RC_FAIL(run.message);
      break;
    case RunOutcome::kRefused:
      summary.count("refused");
      if (!oblique) RC_FAIL("refused without an oblique law: " + run.message);
      break;
    default:
      RC_FAIL("outcome " + std::to_string(static_cast<int>(run.outcome)) + ": " + run.message);
  }
  RC_ASSERT(!run.message.empty());
}

TEST(RandomScene, NeverPenetratesNeverPullsAndStaysStuckInPlace) {
  property::for_random_scenes([](const Prepared& prepared, Summary& summary) {
    SimulationOptions options;
    const double unit = support::time_unit(prepared);
    options.duration = property::kPeriods * unit;
    options.max_impacts = property::kMostImpacts;
    Watch watch(prepared, options, summary);
    RunListeners listeners;
    listeners.event = [&](const Event& event) { watch.hear(event); };
    listeners.sample = [&](const Sample& sample) { watch.look(sample); };
    listeners.sample_rate = property::samples_per_period() / unit;
    const Simulation run = simulate(prepared.system, prepared.start, options, listeners);
    check_outcome(prepared, run, summary);
    watch.check_smallest_gap(run);
    summary.count("scenes");
    summary.count("samples", watch.samples());
    summary.count("impacts", run.totals.impacts);
    summary.count("chatters", run.totals.chatters);
    summary.count("touches", run.totals.undecided_touches);
    if (run.totals.impacts > 0) summary.count("scenes with impacts");
    if (run.totals.stuck_time > 0.0) summary.count("scenes that stick");
  });
}

}  // namespace
}  // namespace graze
