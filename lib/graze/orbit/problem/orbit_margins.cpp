#include "graze/orbit/problem/detail/orbit_margins.hpp"

#include <algorithm>
#include <cmath>

#include "graze/flow/exact/detail/arc_curve.hpp"
#include "graze/motion/detail/clearance.hpp"

namespace graze {
namespace {

double speed_rate(const Stop& stop, const Stop& stop_rate, const State& before, const State& rate,
                  double parameter) {
  return stop.row.dot(rate.qdot) + parameter * stop_rate.row.dot(before.qdot);
}

// Rate of the state just after impact i: that of q'+ = q'- - (1 + r) v d.
State rate_after(const System& system, const ImpactPattern& pattern,
                 const std::vector<ImpactPoint>& points, const OrbitDirection& direction,
                 std::size_t i) {
  const Stop& stop = stop_of(system, pattern, i);
  const Stop& stop_rate = stop_of(*direction.tangent, pattern, i);
  const State &before = points[i].before, &rate = direction.impacts[i].before;
  const double v = stop.row.dot(before.qdot), p = direction.parameter;
  const double jump = stop.restitution().jump(v);
  const double jump_rate =
      stop.restitution().jump_slope(v) * speed_rate(stop, stop_rate, before, rate, p) +
      p * stop.restitution().jump_rate(v, stop_rate.restitution());
  return {rate.q, rate.qdot - jump_rate * stop.direction() - (p * jump) * stop_rate.direction()};
}

// The flight after an impact, with its approaches to the stops.
class MarginFlight {
 public:
  MarginFlight(const System& system, const ImpactPattern& pattern,
               const std::vector<ImpactPoint>& points, const OrbitDirection& direction,
               std::size_t i)
      : system_(system),
        pattern_(pattern),
        points_(points),
        direction_(direction),
        flow_(system),
        i_(i),
        next_((i + 1) % points.size()),
        after_(after_impact(stop_of(system, pattern, i), points[i].before)),
        rate_(rate_after(system, pattern, points, direction, i)),
        duration_(flight_time(system, pattern, points, i)) {}

  void add_approaches(double level, std::vector<OrbitMargin>& margins) const {
    if (!(duration_ > 0.0)) return;
    Arc<double> arc(flow_);
    arc.start(points_[i_].theta, after_.q, after_.qdot);
    for (std::size_t k = 0; k < system_.stops.size(); ++k) {
      const bool from_here = static_cast<int>(k) == pattern_.stops[i_];
      const ArcCurve<double> curve(
          arc, gap_observable<double>(system_.stops[k].row, system_.stops[k].gap), duration_,
          from_here);
      std::vector<GapMinimum> minima = minima_below(curve, 0, level);
      drop_dips_of_impacts(k, minima);
      for (const GapMinimum& minimum : minima) margins.push_back(margin_at(curve, k, minimum));
    }
  }

 private:
  bool falls_back(std::size_t impact) const {
    return !(stop_of(system_, pattern_, impact).row.dot(points_[impact].before.qdot) > 0.0);
  }

  void drop_dips_of_impacts(std::size_t k, std::vector<GapMinimum>& minima) const {
    const int stop = static_cast<int>(k);
    if (stop == pattern_.stops[i_] && falls_back(i_) && !minima.empty() && minima.front().gap < 0.0)
      minima.erase(minima.begin());
    if (stop == pattern_.stops[next_] && falls_back(next_) && !minima.empty() &&
        minima.back().gap < 0.0)
      minima.pop_back();
  }

  OrbitMargin margin_at(const ArcCurve<double>& curve, std::size_t k,
                        const GapMinimum& minimum) const {
    const Stop &stop = system_.stops[k], &stop_rate = direction_.tangent->stops[k];
    const double p = direction_.parameter, frequency = system_.forcing()->frequency;
    const Transition there = transition(system_, flow_, after_, points_[i_].theta, minimum.s);
    const State by_parameter =
        end_tangent(system_, *direction_.tangent, flow_, after_, points_[i_].theta, minimum.s);
    const double turned = direction_.impacts[i_].theta;
    const FlowMatrix& flow = there.flow;
    const Vector q = flow.qq.cwiseProduct(rate_.q) + flow.qv.cwiseProduct(rate_.qdot) +
                     turned * there.phase_rate.q + p * by_parameter.q;
    const Vector qdot = flow.vq.cwiseProduct(rate_.q) + flow.vv.cwiseProduct(rate_.qdot) +
                        turned * there.phase_rate.qdot + p * by_parameter.qdot;
    OrbitMargin margin;
    margin.impact = i_;
    margin.stop = static_cast<int>(k);
    margin.value = minimum.gap;
    margin.rate = p * stop_rate.gap - stop.row.dot(q) - p * stop_rate.row.dot(there.end.q);
    margin.after = minimum.s * frequency;
    const double bend = curve.at(minimum.s, 1).slope;
    const double turn = stop.row.dot(qdot) + p * stop_rate.row.dot(there.end.qdot);
    margin.after_rate = bend > 0.0 ? turn / bend * frequency : 0.0;
    return margin;
  }

  const System& system_;
  const ImpactPattern& pattern_;
  const std::vector<ImpactPoint>& points_;
  const OrbitDirection& direction_;
  ExactFlow<double> flow_;
  std::size_t i_, next_;
  State after_, rate_;  // just after the impact
  double duration_;
};

}  // namespace

std::vector<OrbitMargin> speed_margins(const System& system, const ImpactPattern& pattern,
                                       const std::vector<ImpactPoint>& points,
                                       const OrbitDirection& direction) {
  std::vector<OrbitMargin> margins;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Stop& stop = stop_of(system, pattern, i);
    OrbitMargin margin;
    margin.impact = i;
    margin.stop = pattern.stops[i];
    margin.is_speed = true;
    margin.value = stop.row.dot(points[i].before.qdot);
    margin.rate = speed_rate(stop, stop_of(*direction.tangent, pattern, i), points[i].before,
                             direction.impacts[i].before, direction.parameter);
    margins.push_back(margin);
  }
  return margins;
}

std::vector<OrbitMargin> approach_margins(const System& system, const ImpactPattern& pattern,
                                          const std::vector<ImpactPoint>& points,
                                          const OrbitDirection& direction, double level) {
  std::vector<OrbitMargin> margins;
  for (std::size_t i = 0; i < points.size(); ++i)
    MarginFlight(system, pattern, points, direction, i).add_approaches(level, margins);
  return margins;
}

double gap_drift(const System& system, const ImpactPattern& pattern,
                 const std::vector<ImpactPoint>& points, const OrbitDirection& direction) {
  double fastest = 0.0;
  const auto consider = [&](const State& rate) {
    for (std::size_t k = 0; k < system.stops.size(); ++k) {
      double drift = std::abs(direction.parameter * direction.tangent->stops[k].gap);
      for (int j = 0; j < system.modes(); ++j) {
        const double turned = rate.qdot[j] / std::max(system.omega[j], system.forcing()->frequency);
        drift +=
            std::abs(system.stops[k].row[j]) * std::sqrt(rate.q[j] * rate.q[j] + turned * turned);
      }
      fastest = std::max(fastest, drift);
    }
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    consider(direction.impacts[i].before);
    consider(rate_after(system, pattern, points, direction, i));
  }
  return fastest;
}

}  // namespace graze
