#include "graze/flow/sprung/detail/sprung_phase.hpp"

#include <cmath>
#include <limits>

#include "graze/flow/held/detail/structure_forms.hpp"
#include "graze/flow/stepped/detail/step_methods.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
SprungPhase::SprungPhase(const System& system, const PhaseKey& key, SprungEquations given)
    : IntegratedPhase(key),
      structure_(std::move(given.structure)),
      equations_(std::move(given.system)),
      refusal_(std::move(given.refusal)),
      springs_(key.springs.all()) {
  for (const Stop& stop : system.stops) {
    rows_.push_back(stop.row);
    gaps_.push_back(stop.gap);
  }
  watch(structure_.observables(system), Vector::Ones(structure_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) watches()[i].mobility = rows_[i].norm();
  for (const int i : springs_) spring_rows_.push_back(rows_[static_cast<std::size_t>(i)]);
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    Watch watch;
    watch.spring = static_cast<int>(k);
    watch.of_spring = equations_.springs[k].resting ? SpringWatch::kRest : SpringWatch::kDepth;
    watch.leaving = equations_.springs[k].resting ? Leaving::kAsked : Leaving::kKnown;
    depth_watches_.push_back(watch);
    watch.leaving = Leaving::kKnown;
    watch.of_spring = equations_.springs[k].loaded ? SpringWatch::kGrip : SpringWatch::kSlack;
    grip_watches_.push_back(watch);
  }
}

SprungPhase::SprungPhase(const System& system, const PhaseKey& key,
                         const std::optional<StepSetting>& steps)
    : SprungPhase(system, key, sprung_equations(system, key)) {
  add_force_weights(system);
  if (structure_.left.size() > 0 || system.harmonics()) add_powers(system);
  if (system.carried()) add_moving(system);
  integrate(steps);
}

// A spring pushes the structure off the stops that hold it.
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

// An oblique law projects along other directions than it holds; powers are formed before that. The
// harmonics press by K and D.
void SprungPhase::add_powers(const System& system) {
  const Matrix& basis = structure_.basis;
  SprungSystem::Powers& powers = equations_.powers.emplace();
  powers.forcing = Vector::Zero(basis.cols());
  if (system.forcing()) powers.forcing = basis.transpose() * system.forcing()->amplitude;
  powers.damping = basis.transpose() * system.damping() * basis;
  if (system.harmonics()) {
    powers.by_place = powers.by_rate = Matrix::Zero(basis.cols(), basis.cols());
    for (std::size_t k = 0; k < system.harmonics()->size(); ++k) {
      const Harmonic& one = (*system.harmonics())[k];
      const Eigen::Index at = structure_.drive(k);
      const double unit = structure_.units[k];
      powers.by_place.col(at) = basis.transpose() * one.cosine / unit;
      powers.by_rate.col(at) = -basis.transpose() * one.sine / structure_.rate_unit(k);
    }
  }
  if (structure_.left.size() == 0) return;
  for (const int i : structure_.constrained) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    // A contact force of 1 N accelerates by -direction |row|^2.
    powers.held.push_back({watches()[static_cast<std::size_t>(i)],
                           stop.row.squaredNorm() * basis.transpose() * stop.direction()});
  }
}

void SprungPhase::add_moving(const System& system) {
  StructureForms forms = structure_forms(system, structure_);
  SprungSystem::Moving& moving = equations_.moving.emplace(SprungSystem::Moving{
      std::move(forms.place), std::move(forms.rate), std::move(forms.forcing),
      std::move(forms.force_place), std::move(forms.force_rate), system.damping(), spring_rows_, {}});
  for (const int i : structure_.constrained) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    moving.held.push_back({watches()[static_cast<std::size_t>(i)],
                           stop.row.squaredNorm() * stop.direction()});
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
    // For a spring whose surface is touched at rest, a depth within its error is kept.
    const bool resting = equations_.springs[depths_.size()].resting;
    depths_.push_back(resting ? rows_[at].dot(q) - gaps_[at]
                              : depth_value<double>(rows_[at], q, gaps_[at]));
  }
  start_steps(theta, q, qdot, depths_, time);
}

Vector SprungPhase::spring_push(const Vector& q, const Vector& qdot) const {
  std::vector<double> depths;
  for (const int i : springs_)
    depths.push_back(rows_[static_cast<std::size_t>(i)].dot(q) -
                     gaps_[static_cast<std::size_t>(i)]);
  return graze::spring_push(equations_, depths, qdot);
}

// The force s seconds after the start, without the contact forces of closed stops.
Vector SprungPhase::force(double s, const Vector& q, const Vector& qdot) const {
  const LinearSystem<double>& free = structure_.whole;
  Vector sum = -2.0 * free.delta.cwiseProduct(qdot) - free.omega.cwiseAbs2().cwiseProduct(q);
  if (free.load.size() > 0) sum += free.load;
  if (free.forced) sum += free.forces(theta_ + free.frequency * s);
  return sum - spring_push(q, qdot);
}

ForcesAtStart SprungPhase::at_start() const {
  return forces_at_start(structure_, equations_, depths_, theta_, q_, qdot_);
}

CurvePoint<double> SprungPhase::gap_rate(int stop, int order) const {
  return at_start().gap_rate(rows_[static_cast<std::size_t>(stop)], qdot_, order);
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

// The depth begins at zero where the spring has just been entered: at a speed, or under a force. A
// grip may begin at zero wherever the spring is.
void SprungPhase::watch_springs(const MotionState<double>& now, const Flight<double>& flight,
                                std::vector<Watched>& list) {
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    const int i = springs_[k];
    const auto at = static_cast<std::size_t>(i);
    const bool loaded = equations_.springs[k].loaded, at_surface = depths_[k] == 0.0;
    Watch& depth = depth_watches_[k];
    depth.multiplicity = 0;
    depth.departure = 0.0;
    depth.sure = grip_watches_[k].sure = flight.sure_of(i);
    if (depth.of_spring == SpringWatch::kRest) {
      list.push_back({i, &depth, ArrivalKind::kTouch});
      continue;
    }
    if (at_surface) {
      depth.multiplicity = depth_multiplicity(*this, i, now.multiplicities[at], rows_[at], qdot_);
      depth.departure =
          -gap_rate(i, depth.multiplicity).value / std::tgamma(depth.multiplicity + 1.0);
    }
    list.push_back({i, &depth, loaded ? ArrivalKind::kSeparation : ArrivalKind::kLeft});
    if (!equations_.springs[k].law.parts_early()) continue;
    grip_watches_[k].multiplicity = at_surface ? 0 : now.multiplicities[at];
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
