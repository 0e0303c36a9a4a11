#include "graze/orbit/problem/detail/segment_shooting.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/product_eigenvalues.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Sum of the sizes of all terms of a push, m/s^2.
double push_scale(const System& system, const Stop& stop) {
  double scale = stop.row.cwiseAbs().dot(system.forcing()->size());
  if (system.load()) scale += stop.row.cwiseAbs().dot(system.load()->cwiseAbs());
  return scale > 0.0 ? scale : 1.0;
}

// A compressed spring, and the derivative of its force by the state.
struct PressedSpring {
  std::size_t place = 0;
  const Stop* stop = nullptr;
  double depth = 0.0, speed = 0.0, force = 0.0, by_depth = 0.0, by_rate = 0.0;

  // Rate of its push, force times row, where the state has the rate `moved` and the system
  // `tangent`.
  Vector rate(const System& tangent, const State& at, const State& moved) const {
    const Stop& with = tangent.stops[place];
    double change = by_depth * (stop->row.dot(moved.q) + with.row.dot(at.q) - with.gap) +
                    by_rate * (stop->row.dot(moved.qdot) + with.row.dot(at.qdot));
    if (with.is_compliant()) change += stop->force().rate_at(depth, speed, with.force());
    return change * stop->row + force * with.row;
  }
};

std::vector<PressedSpring> springs_at(const System& system, const State& at) {
  std::vector<PressedSpring> list;
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    if (!stop.is_compliant()) continue;
    const double x = stop.row.dot(at.q) - stop.gap, v = stop.row.dot(at.qdot);
    const double force = x > 0.0 ? stop.force().at(x, v) : 0.0;
    if (force > 0.0)
      list.push_back(
          {i, &stop, x, v, force, stop.force().by_depth(x, v), stop.force().by_rate(x, v)});
  }
  return list;
}

}  // namespace

SegmentShooting::SegmentShooting(const System& reference, SegmentLayout layout,
                                 const SegmentOptions& options)
    : layout_(std::move(layout)),
      rate_(reference.is_self_excited() && !layout_.released ? reference.forcing()->frequency
                                                             : 0.0),
      map_(reference, layout_.closed, options) {
  if (layout_.released)
    push_ = push_scale(reference, reference.stops[static_cast<std::size_t>(*layout_.released)]);
}

SegmentShooting SegmentShooting::over(SegmentLayout layout) const {
  SegmentShooting other = *this;
  other.layout_ = std::move(layout);
  return other;
}

SegmentShooting SegmentShooting::leaving_out(const LeftOut& one) const {
  SegmentShooting other = *this;
  other.map_ = map_.leaving_out(one);
  return other;
}

System SegmentShooting::timed(const System& system, const Vector& u) const {
  System own = system;
  if (is_free()) own.modal().forcing->frequency = rate_ * std::exp(u[0]);
  return own;
}

Vector SegmentShooting::wrap() const {
  if (!layout_.released) return {};
  Vector wrap = Vector::Zero(size());
  wrap[0] = kTurn;
  return wrap;
}

Vector SegmentShooting::pack(const System& system, double theta,
                             const std::vector<State>& states) const {
  Vector u(head() + static_cast<Eigen::Index>(states.size()) * map_.size());
  if (layout_.released) u[0] = theta;
  if (is_free()) u[0] = std::log(system.forcing()->frequency / rate_);
  for (std::size_t i = 0; i < states.size(); ++i)
    u.segment(head() + static_cast<Eigen::Index>(i) * map_.size(), map_.size()) =
        map_.pack(system, states[i]);
  return u;
}

std::vector<State> SegmentShooting::unpack(const System& system, const Vector& u) const {
  std::vector<State> states;
  for (int i = 0; i < layout_.sections; ++i)
    if (auto chart = map_.chart_at(system, at_section(u, i)))
      states.push_back(std::move(chart->state));
  return states;
}

// lambda = share.(load + amplitude cos theta - 2 delta q' - w^2 q - sum F b), F of the springs that
// are compressed.
SegmentShooting::Force SegmentShooting::force(const System& system, const Vector& u,
                                              const SectionMap::Chart& chart,
                                              std::span<const System* const> tangents) const {
  const auto place = std::find(layout_.closed.begin(), layout_.closed.end(), *layout_.released) -
                     layout_.closed.begin();
  const Vector share = contact_share(system, layout_.closed).row(place);
  const Vector stiffness = system.omega.cwiseAbs2();
  const Vector &q = chart.state.q, &qdot = chart.state.qdot;
  const double theta = theta_of(u);
  Vector acceleration =
      system.forcing()->at(theta) - system.resistance(qdot) - stiffness.cwiseProduct(q);
  if (system.load()) acceleration += *system.load();
  const std::vector<PressedSpring> springs = springs_at(system, chart.state);
  for (const PressedSpring& spring : springs) acceleration -= spring.force * spring.stop->row;
  Force result;
  result.value = share.dot(acceleration) / push_;
  result.by_theta = share.dot(system.forcing()->rate_at(theta)) / push_;
  result.by_x.resize(map_.size());
  Vector by_velocity = 2.0 * share.cwiseProduct(system.delta());
  if (system.coupling()) by_velocity += system.coupling()->transpose() * share;
  result.by_x << -share.cwiseProduct(stiffness).transpose() * chart.slope,
      -by_velocity.transpose() * chart.slope;
  for (const PressedSpring& spring : springs) {
    const double part = share.dot(spring.stop->row);
    const Eigen::RowVectorXd seen = spring.stop->row.transpose() * chart.slope;
    result.by_x.head(seen.size()) -= part * spring.by_depth * seen;
    result.by_x.tail(seen.size()) -= part * spring.by_rate * seen;
  }
  result.by_x = result.by_x.cwiseProduct(map_.unit().transpose()) / push_;
  result.by_parameters.resize(static_cast<Eigen::Index>(tangents.size()));
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const System& tangent = *tangents[k];
    const State rate = map_.chart_rate(system, tangent, chart.state);
    const Vector share_rate = contact_share_rate(system, tangent, layout_.closed).row(place);
    Vector acceleration_rate = tangent.forcing()->at(theta) - tangent.resistance(qdot) -
                               2.0 * system.omega.cwiseProduct(tangent.omega).cwiseProduct(q) -
                               system.resistance(rate.qdot) - stiffness.cwiseProduct(rate.q);
    if (tangent.load()) acceleration_rate += *tangent.load();
    for (const PressedSpring& spring : springs)
      acceleration_rate -= spring.rate(tangent, chart.state, rate);
    result.by_parameters[static_cast<Eigen::Index>(k)] =
        (share_rate.dot(acceleration) + share.dot(acceleration_rate)) / push_;
  }
  return result;
}

std::optional<ShootingLinearisation> SegmentShooting::linearise(
    const System& system, const Vector& u, std::span<const System* const> tangents,
    std::vector<Matrix>* factors) const {
  if (!u.allFinite()) return {};
  if (is_free()) return linearise_free(system, u, tangents, factors);
  const Eigen::Index all = size(), n = map_.size(), first = head(), last = all - n;
  ShootingLinearisation sum{Vector(all), Matrix::Zero(all, all), Matrix::Zero(all, all),
                            Matrix(all, static_cast<Eigen::Index>(tangents.size()))};
  if (layout_.released) {
    const auto chart = map_.chart_at(system, at_section(u, 0));
    if (!chart) return {};
    const Force zero = force(system, u, *chart, tangents);
    sum.residual[0] = zero.value;
    sum.jacobian(0, 0) = zero.by_theta;
    sum.jacobian.row(0).segment(1, n) = zero.by_x;
    sum.by_parameters.row(0) = zero.by_parameters;
  }
  if (n == 0) return sum;
  for (int i = 0; i < layout_.sections; ++i) {
    const Eigen::Index at = first + i * n, next = first + (i + 1) % layout_.sections * n;
    const auto passed = map_.image(system, at_section(u, i), theta_of(u), periods_each(),
                                   layout_.released.has_value(), tangents);
    if (!passed) return {};
    sum.residual.segment(at, n) = passed->image - u.segment(next, n);
    sum.jacobian.block(at, at, n, n) += passed->jacobian;
    sum.jacobian.block(at, next, n, n) -= Matrix::Identity(n, n);
    sum.by_parameters.middleRows(at, n) = passed->by_parameters;
    if (layout_.released) {
      sum.jacobian.col(0).segment(at, n) = passed->by_start + passed->by_end;
      if (at == last) sum.closing.col(0).tail(n) = passed->by_end;
    }
    if (factors) factors->push_back(passed->jacobian);
  }
  sum.closing.block(last, first, n, n) = -Matrix::Identity(n, n);
  return sum;
}

namespace {

// The derivative of a system by the logarithm of the rate of its forcing alone.
System by_rate(const System& system) {
  const Vector none = Vector::Zero(system.modes());
  System rate{none, NaturalModes{none}, {}};
  rate.modal().forcing = HarmonicForcing{system.forcing()->frequency, 0.0, none};
  for (const Stop& stop : system.stops) {
    rate.stops.push_back({none, 0.0, ImpactLaw{none, Restitution{0.0}}});
    if (!stop.is_compliant()) continue;
    ContactForce force = stop.force();
    force.stiffness = force.exponent = force.coefficient = 0.0;
    rate.stops.back().law = force;
  }
  rate.frictions.assign(system.frictions.size(), {none, none});
  return rate;
}

}  // namespace

std::optional<ShootingLinearisation> SegmentShooting::linearise_free(
    const System& given, const Vector& u, std::span<const System* const> tangents,
    std::vector<Matrix>* factors) const {
  const System system = timed(given, u), rate = by_rate(system);
  std::vector<const System*> along{&rate};
  along.insert(along.end(), tangents.begin(), tangents.end());
  const Eigen::Index all = size(), n = map_.size(), last = all - n;
  const auto others = static_cast<Eigen::Index>(tangents.size());
  ShootingLinearisation sum{Vector(all), Matrix::Zero(all, all), Matrix::Zero(all, all),
                            Matrix(all, others)};
  const Vector& row = system.frictions.front().row;
  const auto chart = map_.chart_at(system, at_section(u, 0));
  if (!chart) return {};
  const Eigen::RowVectorXd seen = row.transpose() * chart->slope;
  const double unit = map_.unit().tail(n / 2).maxCoeff() * row.norm();
  sum.residual[0] = row.dot(chart->state.qdot) / unit;
  sum.jacobian.row(0).segment(1 + n / 2, n / 2) =
      seen.cwiseProduct(map_.unit().tail(n / 2).transpose()) / unit;
  for (Eigen::Index k = 0; k < others; ++k) {
    const System& tangent = *tangents[static_cast<std::size_t>(k)];
    sum.by_parameters(0, k) = (tangent.frictions.front().row.dot(chart->state.qdot) +
                               row.dot(map_.chart_rate(system, tangent, chart->state).qdot)) /
                              unit;
  }
  for (int i = 0; i < layout_.sections; ++i) {
    const Eigen::Index at = 1 + i * n, next = 1 + (i + 1) % layout_.sections * n;
    const auto passed =
        map_.image(system, at_section(u, i), theta_of(u), periods_each(), false, along);
    if (!passed) return {};
    sum.residual.segment(at, n) = passed->image - u.segment(next, n);
    sum.jacobian.block(at, at, n, n) += passed->jacobian;
    sum.jacobian.block(at, next, n, n) -= Matrix::Identity(n, n);
    sum.jacobian.col(0).segment(at, n) = passed->by_parameters.col(0);
    sum.by_parameters.middleRows(at, n) = passed->by_parameters.rightCols(others);
    if (factors) factors->push_back(passed->jacobian);
  }
  sum.closing.block(last, 1, n, n) = -Matrix::Identity(n, n);
  return sum;
}

std::vector<Eigenvalue> SegmentShooting::multipliers(const System& system,
                                                     const std::vector<Matrix>& factors,
                                                     ErrorBounds errors) const {
  std::vector<Eigenvalue> list;
  if (map_.size() > 0) {
    const double roundings =
        system.has_compliant_stop() ? kMapAccuracy / std::numeric_limits<double>::epsilon() : 0.0;
    list = product_eigenvalues(factors, errors, roundings);
    if (static_cast<Eigen::Index>(list.size()) != map_.size()) return {};
    // A later start of the same orbit is no deviation from it.
    if (is_free())
      list.erase(std::min_element(list.begin(), list.end(), [](const auto& a, const auto& b) {
        return std::abs(a.value - 1.0) < std::abs(b.value - 1.0);
      }));
  }
  list.resize(static_cast<std::size_t>(2 * system.modes()), {Complex(0.0), 0.0});
  return list;
}

std::vector<Eigenvalue> SegmentShooting::multipliers(const System& system, const Vector& u,
                                                     ErrorBounds errors) const {
  std::vector<Matrix> factors;
  if (map_.size() > 0 && !linearise(system, u, {}, &factors)) return {};
  return multipliers(system, factors, errors);
}

std::optional<SegmentShooting::Products> SegmentShooting::products(
    const System& given, const Vector& u, int i, const std::vector<SegmentProduct>& list) const {
  const System system = timed(given, u);
  const Eigen::Index n = map_.size(), at = head() + i * n;
  Products found{ComplexVector::Zero(static_cast<Eigen::Index>(list.size())), {}};
  ComplexVector& sums = found.sums;
  const auto passed = map_.image(system, at_section(u, i), theta_of(u), periods_each(),
                                 layout_.released.has_value(), {});
  const auto chart = map_.chart_at(system, at_section(u, i));
  if (!passed || !chart) return {};
  for (Eigen::Index k = 0; k < sums.size(); ++k) {
    const auto& [left, right, multiplier] = list[static_cast<std::size_t>(k)];
    const ComplexVector w = left.segment(at, n);
    ComplexVector v = passed->jacobian * right.segment(at, n);
    if (layout_.released) {
      const Complex comes_round = i + 1 == layout_.sections ? multiplier : Complex(1.0);
      v += (passed->by_start + comes_round * passed->by_end) * right[0];
    }
    sums[k] = w.cwiseProduct(v).sum();
    if (!layout_.released || i > 0) continue;
    const Force zero = force(system, u, *chart, {});
    sums[k] += left[0] * (zero.by_theta * right[0] + (zero.by_x * right.segment(1, n))(0));
  }
  for (const SegmentContact& contact : passed->contacts)
    found.contacts.push_back({contact.stop, contact.from_start, contact.to_end,
                              seconds_between(system, contact.from, contact.to)});
  return found;
}

std::vector<TrajectorySegment> SegmentShooting::follow(const System& given, const Vector& u,
                                                       bool minima) const {
  const System system = timed(given, u);
  std::vector<TrajectorySegment> segments;
  for (int i = 0; i < layout_.sections; ++i) {
    std::optional<TrajectorySegment> segment =
        map_.follow(system, at_section(u, i), theta_of(u), periods_each(), minima);
    if (!segment) return {};
    segments.push_back(std::move(*segment));
  }
  return segments;
}

std::optional<std::vector<SegmentMargin>> SegmentShooting::margins(const System& given,
                                                                   const Vector& u,
                                                                   const System& tangent,
                                                                   const Vector& direction,
                                                                   double parameter_rate) const {
  const System system = timed(given, u);
  std::vector<SegmentMargin> list;
  for (int i = 0; i < layout_.sections; ++i) {
    Vector along(head() + map_.size());
    along << direction.head(head()), at_section(direction, i);
    const std::optional<TrajectorySegment> segment =
        map_.follow_along(system, at_section(u, i), theta_of(u), periods_each(),
                          layout_.released.has_value(), tangent, along, parameter_rate);
    if (!segment) return {};
    std::ranges::move(margins_of(*segment, still_speed(system)), std::back_inserter(list));
  }
  return list;
}

}  // namespace graze
