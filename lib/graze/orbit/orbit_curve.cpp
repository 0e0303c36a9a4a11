#include "graze/orbit/detail/orbit_curve.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/flow/variation/detail/transition.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/orbit/problem/detail/trajectory_segment.hpp"

namespace graze {
namespace {

// The arcs of a whole orbit, some of which begin at an impact, as flights that all do; `whole`: its
// periods, rad. Every flight begins within them, the one of the smallest phase first.
std::vector<std::vector<CurveSample>> from_impact_to_impact(
    const std::vector<std::vector<CurveSample>>& arcs, const std::vector<bool>& begins_at_impact,
    double whole) {
  std::vector<std::vector<CurveSample>> flights;
  std::vector<CurveSample> head;  // up to the first impact: the end of the last flight
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (begins_at_impact[i]) flights.emplace_back();
    std::vector<CurveSample>& into = flights.empty() ? head : flights.back();
    into.insert(into.end(), arcs[i].begin(), arcs[i].end());
  }
  if (flights.empty()) return {head};
  for (CurveSample& sample : head) {
    sample.theta += whole;
    flights.back().push_back(sample);
  }
  for (std::vector<CurveSample>& flight : flights) {
    const double turn = whole * std::floor(flight.front().theta / whole);
    for (CurveSample& sample : flight) sample.theta -= turn;
  }
  const auto first = std::min_element(
      flights.begin(), flights.end(),
      [](const auto& a, const auto& b) { return a.front().theta < b.front().theta; });
  std::rotate(flights.begin(), first, flights.end());
  return flights;
}

// A motion as it was flown.
class FlownCurve {
 public:
  FlownCurve(const System& system, const Vector& row, int per_period, const OrbitInstant& from)
      : system_(system),
        row_(row),
        per_period_(per_period),
        theta_(from.phase + kTurn * from.period_index) {}

  void fly(const MotionState<double>& start, const Instant<double>& end, double closure_speed) {
    SegmentOptions options;
    options.closure_speed = closure_speed;
    std::vector<Instant<double>> starts;
    options.flight = [&](const ContactPhase<double>& phase, const Instant<double>& at, double s) {
      starts.push_back(at);
      add(phase, s);
    };
    const TrajectorySegment segment = pass(system_, start, end, options);
    for (const Instant<double>& at : starts) {
      const auto there = [&at](const Instant<double>& impact) {
        return impact.period == at.period && impact.local == at.local;
      };
      begins_at_impact_.push_back(
          std::any_of(segment.impacts.begin(), segment.impacts.end(),
                      [&](const SegmentImpact& impact) { return there(impact.at); }) ||
          std::any_of(segment.contacts.begin(), segment.contacts.end(),
                      [&](const SegmentContact& c) { return !c.from_start && there(c.from); }));
    }
  }

  std::vector<std::vector<CurveSample>> from_impact_to_impact(double round) {
    return graze::from_impact_to_impact(flights_, begins_at_impact_, round);
  }

 private:
  void add(const ContactPhase<double>& phase, double s) {
    const double frequency = system_.forcing()->frequency;
    // The hops of a chatter are short and still curves, and so are contacts.
    const int count =
        std::max(12, static_cast<int>(std::ceil(frequency * s / kTurn * per_period_)));
    State state{Vector(system_.modes()), Vector(system_.modes())};
    flights_.emplace_back();
    for (int k = 0; k <= count; ++k) {
      phase.state(s * k / count, state.q, state.qdot);
      flights_.back().push_back(
          {theta_ + frequency * s * k / count, row_.dot(state.q), row_.dot(state.qdot)});
    }
    theta_ += frequency * s;
  }

  const System& system_;
  const Vector& row_;
  int per_period_;
  double theta_;  // rad
  std::vector<std::vector<CurveSample>> flights_;
  std::vector<bool> begins_at_impact_;
};

std::vector<std::vector<CurveSample>> flown_curve(const System& system, const Orbit& orbit,
                                                  const Vector& row, int per_period) {
  const OrbitSection& section = *orbit.section;
  const long long periods = orbit.period / static_cast<long long>(section.states.size());
  FlownCurve curve(system, row, per_period, section.at);
  for (const MotionState<double>& state : section.states)
    curve.fly(state, {state.instant.period + periods, state.instant.local}, section.closure_speed);
  return curve.from_impact_to_impact(kTurn * orbit.period);
}

}  // namespace

std::vector<std::vector<CurveSample>> orbit_curve(const System& system, const Orbit& orbit,
                                                  int stop, int per_period) {
  const Vector& row = system.stops[static_cast<std::size_t>(stop)].row;
  if (orbit.section) return flown_curve(system, orbit, row, per_period);
  const ExactFlow<double> flow(system);
  Arc<double> arc(flow);
  const std::vector<ImpactPoint> points = orbit.points();
  std::vector<std::vector<CurveSample>> flights;
  Vector q(system.modes()), qdot(system.modes());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double next =
        i + 1 < points.size() ? points[i + 1].theta : points.front().theta + kTurn * orbit.period;
    const auto hit = static_cast<std::size_t>(orbit.impacts[i].stop);
    const State after = after_impact(system.stops[hit], points[i].before);
    arc.start(points[i].theta, after.q, after.qdot);
    const double turn = next - points[i].theta;
    const int count = std::max(1, static_cast<int>(std::ceil(turn / kTurn * per_period)));
    std::vector<CurveSample> flight;
    for (int k = 0; k <= count; ++k) {
      const double phase = turn * k / count;
      arc.state(phase / flow.frequency(), q, qdot);
      flight.push_back({points[i].theta + phase, row.dot(q), row.dot(qdot)});
    }
    flights.push_back(std::move(flight));
  }
  return flights;
}

}  // namespace graze
