#include "graze/flow/sprung/detail/sprung_phase.hpp"

#include <cmath>
#include <limits>

#include "graze/flow/stepped/detail/step_methods.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
SprungPhase::SprungPhase(const System& system, const PhaseKey& key, SprungEquations given)
    : IntegratedPhase(key),
      structure_(std::move(given.structure)),
      equations_(std::move(given.system)),
      refusal_(std::move(given.refusal)),
      springs_(key.springs.loaded) {
  springs_.insert(springs_.end(), key.springs.parted.begin(), key.springs.parted.end());
  for (const Stop& stop : system.stops) {
    rows_.push_back(stop.row);
    gaps_.push_back(stop.gap);
  }
  watch(structure_.observables(system), Vector::Ones(structure_.size()));
  for (const int i : springs_) spring_rows_.push_back(rows_[static_cast<std::size_t>(i)]);
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    Watch watch;
    watch.spring = static_cast<int>(k);
    watch.of_spring = SpringWatch::kDepth;
    depth_watches_.push_back(watch);
    watch.of_spring = equations_.springs[k].loaded ? SpringWatch::kGrip : SpringWatch::kSlack;
    grip_watches_.push_back(watch);
  }
}

SprungPhase::SprungPhase(const System& system, const PhaseKey& key,
                         const std::optional<StepSetting>& steps)
    : SprungPhase(system, key, sprung_equations(system, key)) {
  add_force_weights(system);
  if (structure_.left.size() > 0) add_powers(system);
  integrate(steps);
}

// A spring pushes the structure off what holds it.
void SprungPhase::add_force_weights(const System& system) {
  for (std::size_t c = 0; c < structure_.constrained.size(); ++c) {
    const auto column = static_cast<Eigen::Index>(c);
    const Vector share = structure_.shares.col(column) / structure_.rows.col(column).squaredNorm();
    Vector& weights = watches()[static_cast<std::size_t>(structure_.constrained[c])].force_weights;
    weights.resize(static_cast<Eigen::Index>(springs_.size()));
    for (std::size_t k = 0; k < springs_.size(); ++k)
      weights[static_cast<Eigen::Index>(k)] =
          -share.dot(system.stops[static_cast<std::size_t>(springs_[k])].row);
  }
}

// An oblique law projects along other directions than it holds; what forces do is told before that.
void SprungPhase::add_powers(const System& system) {
  const Matrix& basis = structure_.basis;
  SprungSystem::Powers& powers = equations_.powers.emplace();
  powers.forcing = Vector::Zero(basis.cols());
  if (system.forcing()) powers.forcing = basis.transpose() * system.forcing()->amplitude;
  powers.damping = basis.transpose() * (2.0 * system.delta()).asDiagonal() * basis;
  for (const int i : structure_.constrained) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    // A contact force of 1 N accelerates by -direction |row|^2.
    powers.held.push_back({watches()[static_cast<std::size_t>(i)],
                           stop.row.squaredNorm() * basis.transpose() * stop.direction()});
  }
}

void SprungPhase::integrate(const std::optional<StepSetting>& steps) {
  StepSetting setting = steps.value_or(StepSetting{});
  setting.speed = 1.0;  // the state counts in speeds of the contact
  if (!steps) {
    setting.tolerance = kStepTolerance;
    setting.longest = std::numeric_limits<double>::infinity();
  }
  step_by(steps ? step_flow(equations_, setting) : contact_flow(equations_, setting));
}

void SprungPhase::start(const double& theta, const Vector& q, const Vector& qdot,
                        const double& time) {
  theta_ = theta;
  q_ = q;
  qdot_ = qdot;
  depths_.clear();
  for (const int i : springs_) {
    const auto at = static_cast<std::size_t>(i);
    depths_.push_back(depth_value<double>(rows_[at], q, gaps_[at]));
  }
  start_steps(theta, q, qdot, depths_, time);
}

Vector SprungPhase::spring_push(const Vector& q, const Vector& qdot) const {
  Vector push = Vector::Zero(q.size());
  for (std::size_t k = 0; k < springs().loaded.size(); ++k) {
    const SprungSystem::Spring& spring = equations_.springs[k];
    const double depth = spring.whole_row.dot(q) - gaps_[static_cast<std::size_t>(springs_[k])];
    push += spring.law.at(depth, spring.whole_row.dot(qdot)) * spring.whole_row;
  }
  return push;
}

Vector SprungPhase::spring_push_rate(const Vector& acceleration) const {
  Vector push = Vector::Zero(acceleration.size());
  for (std::size_t k = 0; k < springs().loaded.size(); ++k) {
    const SprungSystem::Spring& spring = equations_.springs[k];
    const double depth = depths_[k], rate = spring.whole_row.dot(qdot_);
    push += (spring.law.by_depth(depth, rate) * rate +
             spring.law.resistance(depth) * spring.whole_row.dot(acceleration)) *
            spring.whole_row;
  }
  return push;
}

// s seconds after the start, without what holds.
Vector SprungPhase::force(double s, const Vector& q, const Vector& qdot) const {
  const LinearSystem<double>& free = structure_.whole;
  Vector sum = -2.0 * free.delta.cwiseProduct(qdot) - free.omega.cwiseAbs2().cwiseProduct(q);
  if (free.load.size() > 0) sum += free.load;
  if (free.forced) sum += free.amplitude * std::cos(theta_ + free.frequency * s);
  return sum - spring_push(q, qdot);
}

// What closed stops leave of an acceleration.
Vector SprungPhase::held_back(const Vector& acceleration) const {
  if (structure_.is_free()) return acceleration;
  return acceleration - structure_.directions * (structure_.shares.transpose() * acceleration);
}

SprungPhase::AtStart SprungPhase::at_start() const {
  const LinearSystem<double>& free = structure_.whole;
  const Vector stiffness = free.omega.cwiseAbs2();
  AtStart at;
  at.force = force(0.0, q_, qdot_);
  at.acceleration = held_back(at.force);
  const Vector push_rate = spring_push_rate(at.acceleration);
  at.force_rate =
      -2.0 * free.delta.cwiseProduct(at.acceleration) - stiffness.cwiseProduct(qdot_) - push_rate;
  at.size = 2.0 * free.delta.cwiseProduct(qdot_.cwiseAbs()) +
            stiffness.cwiseProduct(q_.cwiseAbs()) + spring_push(q_, qdot_).cwiseAbs();
  at.rate_size = 2.0 * free.delta.cwiseProduct(at.acceleration.cwiseAbs()) +
                 stiffness.cwiseProduct(qdot_.cwiseAbs()) + push_rate.cwiseAbs();
  if (free.load.size() > 0) at.size += free.load.cwiseAbs();
  if (free.forced) {
    at.force_rate -= free.frequency * std::sin(theta_) * free.amplitude;
    at.size += free.amplitude.cwiseAbs();
    at.rate_size += free.frequency * free.amplitude.cwiseAbs();
  }
  at.jerk = held_back(at.force_rate);
  return at;
}

CurvePoint<double> SprungPhase::gap_rate(int stop, int order) const {
  const Vector& row = rows_[static_cast<std::size_t>(stop)];
  const AtStart at = at_start();
  const double rates[] = {-row.dot(qdot_), -row.dot(at.acceleration), -row.dot(at.jerk)};
  const Vector sizes[] = {qdot_.cwiseAbs(), at.size, at.rate_size};
  CurvePoint<double> point;
  point.value = rates[order - 1];
  if (order < 3) point.slope = rates[order];
  point.noise = kForceRoundings * row.cwiseAbs().dot(sizes[order - 1]);
  return point;
}

double SprungPhase::force_at(int stop, const double& s, const Vector& q, const Vector& qdot) const {
  const Eigen::Index column = structure_.column_of(stop);
  return structure_.shares.col(column).dot(force(s, q, qdot)) /
         structure_.rows.col(column).squaredNorm();
}

double SprungPhase::force_rate(int stop) const {
  const Eigen::Index column = structure_.column_of(stop);
  return structure_.shares.col(column).dot(at_start().force_rate) /
         structure_.rows.col(column).squaredNorm();
}

// The depth begins at zero where the spring has just been entered: at a speed, or pushed. A grip
// may begin at one wherever the spring is.
void SprungPhase::watch_springs(const MotionState<double>& now, std::vector<Watched>& list) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    const int i = springs_[k];
    const auto at = static_cast<std::size_t>(i);
    const bool loaded = equations_.springs[k].loaded;
    Watch& depth = depth_watches_[k];
    depth.multiplicity = 0;
    depth.departure = 0.0;
    if (depths_[k] == 0.0) {
      const double speed = rows_[at].dot(qdot_), push = -gap_rate(i, 2).value;
      depth.multiplicity = depth_multiplicity(rows_[at], qdot_, push);
      depth.departure = depth.multiplicity == 1   ? speed
                        : depth.multiplicity == 2 ? 0.5 * push
                                                  : -gap_rate(i, 3).value / 6.0;
    }
    list.push_back({i, &depth, loaded ? ArrivalKind::kSeparation : ArrivalKind::kLeft});
    if (!equations_.springs[k].law.parts_early()) continue;
    grip_watches_[k].multiplicity = now.multiplicities[at];
    list.push_back(
        {i, &grip_watches_[k], loaded ? ArrivalKind::kSeparation : ArrivalKind::kEntry, true});
  }
}

std::optional<Arrival<double>> SprungPhase::left_at_once(const MotionState<double>& /*now*/) const {
  const int k = graze::left_at_once(spring_rows_, depths_, qdot_);
  if (k < 0) return {};
  const auto at = static_cast<std::size_t>(k);
  return Arrival<double>{
      equations_.springs[at].loaded ? ArrivalKind::kSeparation : ArrivalKind::kLeft, springs_[at]};
}

}  // namespace graze
