#include "graze/bifurcation/strobe_grazing.hpp"

#include <array>

#include "graze/base/angle.hpp"

namespace graze {

StrobeGrazing::StrobeGrazing(const PassageEquations& equations, int stop)
    : equations_(equations), stop_(stop) {
  const Eigen::Index n = equations.period() * equations.map().size();
  problem_.first = n;
  problem_.problem.evaluate = [this](const Vector& y, Parameters at) {
    return equations_.touching(y, at, stop_);
  };
  problem_.problem.wrap = Vector::Zero(n + 2);
  problem_.problem.wrap[n + 1] = equations.period() * kTurn;
  // A touch from outside, where the gap has a minimum, and one from within a contact, which a
  // maximum parts in two, are two things.
  const auto push = [this](const BranchPoint& point) {
    return equations_.push(point.u, point.parameters(), stop_).value_or(0.0);
  };
  problem_.proceed = [push](const BranchPoint& previous, const BranchPoint& here) {
    return push(previous) * push(here) > 0.0;
  };
}

Vector StrobeGrazing::pack(const Vector& turns, const Touch& touch, double first) const {
  Vector y(problem_.first + 2);
  y << turns, first / equations_.unit(0), static_cast<double>(touch.turn) * kTurn + touch.angle;
  return y;
}

std::vector<BranchPoint> StrobeGrazing::rewritings(const BranchPoint& point) const {
  const Eigen::Index size = problem_.first, n = equations_.map().size();
  std::vector<BranchPoint> list;
  for (Eigen::Index begun = 0; begun < size; begun += n) {
    const auto from_there = [&](const Vector& turns) {
      Vector turned(size);
      turned << turns.segment(begun, size - begun), turns.head(begun);
      return turned;
    };
    BranchPoint turned = point;
    turned.u.head(size) = from_there(point.u);
    turned.u[size + 1] -= static_cast<double>(begun / n) * kTurn;
    turned.tangent.head(size) = from_there(point.tangent);
    list.push_back(std::move(turned));
  }
  return list;
}

std::optional<Orbit> StrobeGrazing::orbit_at(const BranchPoint& point) const {
  const System* system = equations_.system_at(std::array{first_of(point), point.parameter});
  if (!system) return {};
  const auto touch = equations_.touch_at(point.u, point.parameters(), stop_);
  return touch ? orbit_of(*system, equations_.shooting(), point.u.head(problem_.first), {}, *touch)
               : std::nullopt;
}

double StrobeGrazing::first_of(const BranchPoint& point) const {
  return point.u[problem_.first] * equations_.unit(0);
}

}  // namespace graze
