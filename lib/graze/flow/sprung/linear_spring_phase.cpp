#include "graze/flow/sprung/detail/linear_spring_phase.hpp"

#include <algorithm>

#include "graze/flow/exact/detail/first_zero.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

bool is_linear(const ContactForce& law) {
  return law.exponent == 1.0 &&
         (law.damping == ContactDamping::kNone || law.damping == ContactDamping::kConstant);
}

// Depths on the coordinates that closed stops leave free.
std::vector<Observable<double>> depths_of(const System& system, const PhaseKey& key,
                                          const SprungEquations& given) {
  std::vector<Observable<double>> depths;
  const std::vector<int> stops = key.springs.all();
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const Stop& stop = system.stops[static_cast<std::size_t>(stops[k])];
    const double held = given.structure.is_free() ? 0.0 : stop.row.dot(given.structure.rest);
    depths.push_back({held - stop.gap, given.system.springs[k].row, {}, {}});
  }
  return depths;
}

// A spring pushes the structure off the stops that hold it.
std::vector<Observable<double>> observables_of(const System& system, const PhaseKey& key,
                                               const SprungEquations& given) {
  const ConstrainedStructure<double>& structure = given.structure;
  std::vector<Observable<double>> list = structure.observables(system);
  const std::vector<Observable<double>> depths = depths_of(system, key, given);
  for (std::size_t c = 0; c < structure.constrained.size(); ++c) {
    if (system.follows(structure.constrained[c])) continue;  // nobody asks for that force
    const auto column = static_cast<Eigen::Index>(c);
    const Vector share = structure.shares.col(column) / structure.rows.col(column).squaredNorm();
    Observable<double>& seen = list[static_cast<std::size_t>(structure.constrained[c])];
    for (std::size_t k = 0; k < key.springs.loaded.size(); ++k) {
      const SprungSystem::Spring& spring = given.system.springs[k];
      const double weight = -share.dot(spring.pushing);
      const Observable<double> force = linear_force(spring.law, depths[k]);
      seen.constant += weight * force.constant;
      seen.displacement += weight * force.displacement;
      if (force.velocity.size() > 0) seen.velocity += weight * force.velocity;
    }
  }
  return list;
}

CoupledSystem coupled_by_springs(const PhaseKey& key, const SprungEquations& given) {
  const SprungSystem& sprung = given.system;
  const auto matrix = [](const Matrix& of) {
    return of.cols() == 1 && of.rows() > 1 ? Matrix(of.col(0).asDiagonal()) : of;
  };
  CoupledSystem coupled{matrix(sprung.stiffness),
                        matrix(sprung.damping),
                        sprung.load,
                        sprung.force,
                        sprung.frequency,
                        {}};
  for (std::size_t k = 0; k < key.springs.loaded.size(); ++k) {
    const SprungSystem::Spring& spring = sprung.springs[k];
    coupled.stiffness += spring.law.stiffness * spring.acting * spring.row.transpose();
    coupled.damping += dashpot_of(spring.law) * spring.acting * spring.row.transpose();
  }
  // The frequency of each coordinate alone, springs included, balances the first-order form.
  const Vector quickest = coupled.stiffness.diagonal().cwiseMax(0.0).cwiseSqrt();
  const double slowest =
      std::max(sprung.frequency, quickest.size() > 0 ? 1e-3 * quickest.maxCoeff() : 0.0);
  coupled.scale = quickest.cwiseMax(slowest > 0.0 ? slowest : 1.0);
  coupled.loads_vary = true;
  return coupled;
}

}  // namespace

bool suits_linear_springs(const System& system, const PhaseKey& key) {
  if (system.modes() > kMostModesOnLinearSprings) return false;
  // A structure that is held in all its coordinates does not move; friction may hold it so, and
  // lets go by its own event.
  if (static_cast<int>(key.closed.size()) >= system.modes() && system.frictions.empty())
    return false;
  if (!key.springs.resting.empty() || !key.untold.empty()) return false;
  const std::vector<int> stops = key.springs.all();
  return std::all_of(stops.begin(), stops.end(), [&](int i) {
    return is_linear(system.stops[static_cast<std::size_t>(i)].force());
  });
}

LinearSpringPhase::LinearSpringPhase(const System& system, const PhaseKey& key)
    : LinearSpringPhase(system, key, sprung_equations(system, key)) {}

LinearSpringPhase::LinearSpringPhase(const System& system, const PhaseKey& key,
                                     SprungEquations given)
    : CoupledPhase(system, key, given.structure, observables_of(system, key, given),
                   coupled_by_springs(key, given)),
      equations_(given.system),
      stops_(key.springs.all()),
      spring_arc_{this->key(), structure(), equations_, depths_, depths_of(system, key, given)} {
  for (std::size_t k = 0; k < system.frictions.size(); ++k) {
    const auto pressed =
        std::find(key.springs.loaded.begin(), key.springs.loaded.end(), system.frictions[k].stop);
    if (pressed == key.springs.loaded.end()) continue;
    const auto place = static_cast<std::size_t>(pressed - key.springs.loaded.begin());
    limit_friction(
        k, times(system.frictions[k].sticking, linear_force(equations_.springs[place].law,
                                                            spring_arc_.depth_observables[place])));
  }
  for (const Stop& stop : system.stops) stop_rows_.push_back(stop.row);
  for (const int i : stops_) {
    rows_.push_back(system.stops[static_cast<std::size_t>(i)].row);
    gaps_.push_back(system.stops[static_cast<std::size_t>(i)].gap);
  }
}

// An arc at the same start serves both decisions at an instant and the motion from there.
void LinearSpringPhase::start(const double& theta, const Vector& q, const Vector& qdot,
                              const double& /*time*/) {
  if (q_.size() > 0 && theta == theta_ && q == q_ && qdot == qdot_) return;
  forget_curves();
  theta_ = theta;
  q_ = q;
  qdot_ = qdot;
  depths_.clear();
  for (std::size_t k = 0; k < rows_.size(); ++k)
    depths_.push_back(depth_value<double>(rows_[k], q, gaps_[k]));
  const Vector y = structure().coordinates(q, theta);
  coupled_motion().start_from(theta, y, structure().rates(qdot, theta), load_at(y));
}

// The load, less the forces of stiffness and springs at the start.
Vector LinearSpringPhase::load_at(const Vector& y) const {
  const Matrix& stiffness = equations_.stiffness;
  Vector load = equations_.load;
  if (stiffness.cols() == 1)
    load -= stiffness.col(0).cwiseProduct(y);
  else
    load -= stiffness * y;
  for (std::size_t k = 0; k < springs().loaded.size(); ++k) {
    const SprungSystem::Spring& spring = equations_.springs[k];
    load -= spring.law.stiffness * depths_[k] * spring.acting;
  }
  return load;
}

CurvePoint<double> LinearSpringPhase::gap_rate(int stop, int order) const {
  CurvePoint<double> point =
      forces_at_start(structure(), equations_, depths_, theta_, q_, qdot_)
          .gap_rate(stop_rows_[static_cast<std::size_t>(stop)], qdot_, order);
  if (order == 3) point.slope = ExactPhase::gap_rate(stop, order).slope;
  return point;
}

Arrival<double> LinearSpringPhase::first_event(const MotionState<double>& now,
                                               const Flight<double>& flight) {
  if (const int k = left_at_once(rows_, depths_, qdot_); k >= 0) {
    const auto at = static_cast<std::size_t>(k);
    return {equations_.springs[at].loaded ? ArrivalKind::kSeparation : ArrivalKind::kLeft,
            stops_[at]};
  }
  Arrival<double> arrival = ExactPhase::first_event(now, flight);
  if (arrival.fails()) return arrival;
  for (std::size_t k = 0; k < stops_.size() && !arrival.fails(); ++k)
    look_at_spring(k, now, flight, arrival);
  return arrival;
}

// Where the spring has just been entered, the depth begins at zero: at a speed, or from rest as a
// power of time, and so does its force, one power lower. Beyond the surface the force begins at
// zero where it has just come back.
void LinearSpringPhase::look_at_spring(std::size_t k, const MotionState<double>& now,
                                       const Flight<double>& flight,
                                       Arrival<double>& arrival) const {
  const SprungSystem::Spring& spring = equations_.springs[k];
  const int stop = stops_[k];
  const bool from_surface = depths_[k] == 0.0;
  const int known = now.multiplicities[static_cast<std::size_t>(stop)];
  const int depth_leaves =
      from_surface ? depth_multiplicity(*this, stop, known, rows_[k], qdot_) : 0;
  const auto look = [&](const Observable<double>& observable, int multiplicity, ArrivalKind kind,
                        bool below) {
    ArcCurve<double> curve;
    curve = coupled_arc()->curve(observable, arrival.flight, multiplicity > 0);
    const FirstZero<double> zero =
        first_contact(curve, multiplicity, flight.sure_of(stop), flight.stop);
    arrival.evaluations += zero.evaluations;
    if (zero.kind == ZeroKind::kNone) return;
    arrival.stop = stop;
    arrival.flight = zero.s;
    arrival.below = below;
    arrival.kind = zero.kind == ZeroKind::kBudget      ? ArrivalKind::kUndecided
                   : zero.kind == ZeroKind::kNotFinite ? ArrivalKind::kNotFinite
                                                       : kind;
  };
  const Observable<double>& depth = spring_arc_.depth_observables[k];
  look(depth, depth_leaves, spring.loaded ? ArrivalKind::kSeparation : ArrivalKind::kLeft, false);
  if (arrival.fails() || !spring.law.parts_early()) return;
  Observable<double> grip = linear_force(spring.law, depth);
  if (!spring.loaded) {
    grip.constant = -grip.constant;
    grip.displacement = -grip.displacement;
    grip.velocity = -grip.velocity;
  }
  look(grip, from_surface ? depth_leaves - 1 : known,
       spring.loaded ? ArrivalKind::kSeparation : ArrivalKind::kEntry, true);
}

}  // namespace graze
