#include "graze/flow/variation/detail/sprung_deviation.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/stepped/detail/extrapolation.hpp"
#include "graze/flow/stepped/detail/sprung_rates_turning_impl.hpp"

namespace graze {
namespace {

namespace odeint = boost::numeric::odeint;
using step_walk::Sprung;

// Coordinates of the structure and of the harmonics beside the first.
Eigen::Index whole_size(const System& system) {
  return system.modes() +
         static_cast<Eigen::Index>(system.harmonics() ? system.harmonics()->size() : 0);
}

// The equations that the phase integrates, in all coordinates though stops hold the structure: q''
// = P f; behind them those of the harmonics. Returns nullopt when no stop is closed.
std::optional<SprungSystem> constrained_system(const System& system, const SpringArc& phase) {
  if (phase.closed().empty()) return {};
  SprungSystem sprung = phase.equations;
  const ConstrainedStructure<double>& structure = phase.structure;
  const Matrix held = held_projection(system, phase.closed());
  const Eigen::Index n = system.modes(), all = whole_size(system);
  sprung.stiffness = sprung.damping = Matrix::Zero(all, all);
  sprung.load = sprung.force = Vector::Zero(all);
  sprung.stiffness.topLeftCorner(n, n) = held * system.omega.cwiseAbs2().asDiagonal();
  sprung.damping.topLeftCorner(n, n) = held * system.damping();
  if (system.load()) sprung.load.head(n) = held * *system.load();
  if (system.forcing()) sprung.force.head(n) = held * system.forcing()->amplitude;
  for (Eigen::Index k = n; k < all; ++k) {
    const auto place = static_cast<std::size_t>(k - n);
    const Harmonic& one = (*system.harmonics())[place];
    const double w = structure.reduced.omega[structure.drive(place)], unit = structure.units[place];
    sprung.stiffness.col(k).head(n) = -held * one.cosine / unit;
    sprung.damping.col(k).head(n) = held * one.sine / structure.rate_unit(place);
    sprung.stiffness(k, k) = w * w;
  }
  sprung.frequency = system.forcing() ? system.forcing()->frequency : 0.0;
  sprung.powers.reset();
  sprung.moving.reset();
  const std::vector<int> springs = phase.springs().all();
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Vector& row = system.stops[static_cast<std::size_t>(springs[i])].row;
    sprung.springs[i].row = sprung.springs[i].acting = Vector::Zero(all);
    sprung.springs[i].row.head(n) = row;
    sprung.springs[i].acting.head(n) = held * row;
  }
  return sprung;
}

// A state, or its deviations, with the coordinates of the harmonics behind it.
State whole_state(const System& system, const SpringArc& phase, const State& start, double theta) {
  const ConstrainedStructure<double>& structure = phase.structure;
  const Eigen::Index n = system.modes(), all = whole_size(system);
  if (all == n) return start;
  const Vector y = structure.coordinates(start.q, theta), ydot = structure.rates(start.qdot, theta);
  State whole{Vector(all), Vector(all)};
  whole.q << start.q, y.tail(all - n);
  whole.qdot << start.qdot, ydot.tail(all - n);
  return whole;
}

Deviations whole_deviations(const System& system, const Deviations& of) {
  const Eigen::Index n = system.modes(), all = whole_size(system);
  Deviations whole{Matrix::Zero(all, of.count()), Matrix::Zero(all, of.count()), of.delay};
  whole.q.topRows(n) = of.q;
  whole.qdot.topRows(n) = of.qdot;
  return whole;
}

Deviations own_part(const System& system, const Deviations& whole) {
  return {whole.q.topRows(system.modes()), whole.qdot.topRows(system.modes()), whole.delay};
}

// The inhomogeneous terms of the equations of a derivative by a parameter.
struct Source {
  const System& system;
  const System& tangent;
  const std::vector<int> springs;  // the stops that the springs are of
  // P and its derivative by the parameter; empty where no stop is closed.
  Matrix held{}, held_rate{};

  // Terms of the velocities and of the accelerations, per unit of the parameter, at displacements
  // q, velocities v, accelerations a, and the phase theta, of the structure's own coordinates. At
  // equal phases harmonics do not deviate.
  void at(const Vector& q, const Vector& v, const Vector& a, double theta, const SprungSystem& own,
          const std::vector<Sprung::Compression>& contacts, Vector& velocity,
          Vector& acceleration) const {
    // Times stretch where the frequency moves: instants are compared at equal phases.
    const double stretch = -tangent.forcing()->frequency / system.forcing()->frequency;
    velocity = stretch * v;
    Vector push = tangent.forcing()->at(theta) -
                  2.0 * (tangent.delta().cwiseProduct(v) +
                         system.omega.cwiseProduct(tangent.omega).cwiseProduct(q));
    if (tangent.coupling()) push -= *tangent.coupling() * v;
    if (tangent.load()) push += *tangent.load();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (!own.springs[i].loaded) continue;
      const ContactForce& law = own.springs[i].law;
      const Stop& rate = stop_rate(i);
      const double x = contacts[i].depth, u = contacts[i].rate;
      double force = law.by_depth(x, u) * depth_rate(i, q) + law.by_rate(x, u) * rate.row.dot(v);
      if (rate.is_compliant()) force += law.rate_at(x, u, rate.force());
      push -= force * own.springs[i].row.head(q.size()) + law.at(x, u) * rate.row;
    }
    acceleration = stretch * a;
    if (held.size() == 0)
      acceleration += push;
    else
      acceleration += held * push + held_rate * unheld(q, v, theta, own, contacts);
  }
  // Of the depth of a spring at the displacements q.
  double depth_rate(std::size_t spring, const Vector& q) const {
    return stop_rate(spring).row.dot(q) - stop_rate(spring).gap;
  }

 private:
  const Stop& stop_rate(std::size_t i) const {
    return tangent.stops[static_cast<std::size_t>(springs[i])];
  }
  // The forces on the structure except those of its closed stops.
  Vector unheld(const Vector& q, const Vector& v, double theta, const SprungSystem& own,
                const std::vector<Sprung::Compression>& contacts) const {
    Vector push = system.forcing()->at(theta) - system.resistance(v) -
                  system.omega.cwiseAbs2().cwiseProduct(q);
    if (system.load()) push += *system.load();
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (own.springs[i].loaded)
        push -= own.springs[i].law.at(contacts[i].depth, contacts[i].rate) *
                own.springs[i].row.head(q.size());
    return push;
  }
};

// The motion together with its deviations: z, then (w dq, dq') of each, per its own size.
//
// A damping that grows as x^p, p < 1, has no slope at the surface. Deviations of a contact that
// begins there are therefore carried from its own beginning on, d = e + z' k with k by how much
// later that is, so that the depth of e begins at zero: e obeys the equations of d, and what the
// force changes by itself over the time k.
class Varied {
 public:
  using State = std::vector<double>;

  Varied(const SprungSystem& system, const Source* source)
      : system_(system), source_(source), motion_(system, kDeviationTolerance) {}

  State begin(const graze::State& start, double theta, const std::vector<double>& depths,
              const Deviations& deviations, const Vector& sizes) {
    const Eigen::Index n = start.q.size();
    start_ = start.q;
    theta_ = theta;
    Vector x(2 * n);
    x << start.q, start.qdot;
    motion_.begin(theta, x, depths, z_);
    slope_.resize(z_.size());
    sizes_ = sizes;
    const Vector slow = motion_.scale().cwiseInverse();
    stiffness_ = system_.stiffness.cols() == 1 ? Matrix(system_.stiffness.col(0).cwiseProduct(slow))
                                               : Matrix(system_.stiffness * slow.asDiagonal());
    rows_.clear();
    for (const SprungSystem::Spring& spring : system_.springs)
      rows_.push_back(spring.row.cwiseProduct(slow));
    State whole = z_;
    whole.resize(z_.size() + static_cast<std::size_t>(2 * n * deviations.count()));
    Eigen::Map<Matrix> columns(whole.data() + z_.size(), 2 * n, deviations.count());
    columns.topRows(n) = motion_.scale().asDiagonal() * deviations.q;
    columns.bottomRows(n) = deviations.qdot;
    columns.array().rowwise() /= sizes_.transpose().array();
    later_ = Eigen::RowVectorXd();
    for (std::size_t i = 0; i < depths.size(); ++i)
      if (is_steep(system_.springs[i], depths[i], start.qdot)) begin_at_surface(i, columns);
    return whole;
  }

  void operator()(const State& whole, State& slope, double s) {
    const Eigen::Index n = start_.size(), m = sizes_.size();
    std::copy_n(whole.begin(), z_.size(), z_.begin());
    motion_(z_, slope_, s);
    std::copy(slope_.begin(), slope_.end(), slope.begin());
    const Eigen::Map<const Matrix> columns(whole.data() + z_.size(), 2 * n, m);
    Eigen::Map<Matrix> rates(slope.data() + z_.size(), 2 * n, m);
    rates.topRows(n).noalias() = motion_.scale().asDiagonal() * columns.bottomRows(n);
    subtract(stiffness_, columns.topRows(n), rates.bottomRows(n), true);
    subtract(system_.damping, columns.bottomRows(n), rates.bottomRows(n), false);
    contacts_.clear();
    for (std::size_t i = 0; i < system_.springs.size(); ++i) {
      const SprungSystem::Spring& spring = system_.springs[i];
      contacts_.push_back(motion_.compression(i, z_));
      if (!spring.loaded) continue;
      const Sprung::Compression& at = contacts_.back();
      force_.noalias() = rows_[i].transpose() * columns.topRows(n);
      force_ *= spring.law.by_depth(at.depth, at.rate);
      force_.noalias() +=
          spring.law.by_rate(at.depth, at.rate) * (spring.row.transpose() * columns.bottomRows(n));
      rates.bottomRows(n).noalias() -= spring.acting * force_;
    }
    if (source_) add_source(s, rates);
    if (later_.size() != 0)
      rates.bottomRows(n) +=
          system_.frequency * std::sin(theta_ + system_.frequency * s) * system_.force * later_;
  }

  Deviations end(State whole, double s) {
    const Eigen::Index n = start_.size(), m = sizes_.size();
    Eigen::Map<Matrix> columns(whole.data() + z_.size(), 2 * n, m);
    if (later_.size() != 0) {
      std::copy_n(whole.begin(), z_.size(), z_.begin());
      motion_(z_, slope_, s);
      columns += pace() * later_;
    }
    return {motion_.scale().cwiseInverse().asDiagonal() * columns.topRows(n) * sizes_.asDiagonal(),
            columns.bottomRows(n) * sizes_.asDiagonal(), Eigen::RowVectorXd::Zero(m)};
  }

  double first_step(double longest) const { return motion_.first_step(longest); }
  const Vector& scale() const { return motion_.scale(); }

 private:
  static bool is_steep(const SprungSystem::Spring& spring, double depth, const Vector& velocity) {
    return spring.loaded && spring.law.damping == ContactDamping::kApproach &&
           spring.law.exponent > 1.0 && depth == 0.0 && spring.row.dot(velocity) > 0.0;
  }
  // (w q', q'') of the motion, at the slopes computed last.
  Vector pace() const {
    const Eigen::Index n = start_.size();
    const Eigen::Map<const Vector> velocity(z_.data() + n, n), acceleration(slope_.data() + n, n);
    Vector pace(2 * n);
    pace << motion_.unit() * motion_.scale().cwiseProduct(velocity), motion_.unit() * acceleration;
    return pace;
  }
  void begin_at_surface(std::size_t spring, Eigen::Map<Matrix>& columns) {
    const Eigen::Index n = start_.size();
    motion_(z_, slope_, 0.0);
    const Vector rate = pace();
    later_ = rows_[spring].transpose() * columns.topRows(n);
    if (source_)
      later_[0] += source_->depth_rate(spring, start_.head(source_->system.modes())) / sizes_[0];
    later_ /= rows_[spring].dot(rate.head(n));
    columns -= rate * later_;
  }
  // `fresh`: overwrites instead of adding. A matrix may be the column of its diagonal.
  template <class Columns, class Rates>
  static void subtract(const Matrix& matrix, const Columns& columns, Rates&& rates, bool fresh) {
    if (fresh) rates.setZero();
    if (matrix.cols() == 1)
      rates.noalias() -= matrix.col(0).asDiagonal() * columns;
    else
      rates.noalias() -= matrix * columns;
  }

  void add_source(double s, Eigen::Map<Matrix>& rates) {
    const Eigen::Index n = start_.size(), own = source_->system.modes();
    const double u = motion_.unit();
    const Eigen::Map<const Vector> moved(z_.data(), own), velocity(z_.data() + n, own),
        acceleration(slope_.data() + n, own);
    const auto scale = motion_.scale().head(own);
    source_->at(start_.head(own) + u * moved.cwiseQuotient(scale), u * velocity, u * acceleration,
                theta_ + system_.frequency * s, system_, contacts_, drift_, push_);
    rates.col(0).head(own) += scale.cwiseProduct(drift_) / sizes_[0];
    rates.col(0).segment(n, own) += push_ / sizes_[0];
  }

  const SprungSystem& system_;
  const Source* source_;
  Sprung motion_;
  Vector start_, sizes_;
  Eigen::RowVectorXd later_;  // k of each column, s per its size; empty: none is shifted
  double theta_ = 0.0;
  State z_, slope_;
  Matrix stiffness_;          // K/w
  std::vector<Vector> rows_;  // row/w
  Eigen::RowVectorXd force_;
  std::vector<Sprung::Compression> contacts_;
  Vector drift_, push_;
};

// Not finite when the end is not reached, or when it was asked to stop (stop_scope.hpp) before.
Varied::State integrate(Varied& varied, Varied::State whole, double s) {
  step_walk::Extrapolation method =
      step_walk::extrapolation(kDeviationTolerance, Sprung::relative(kDeviationTolerance));
  double at = 0.0, next = varied.first_step(s);
  for (int failures = 0; at < s && failures < step_walk::kMostFailures;) {
    next = std::min(next, s - at);
    if (StopScope::is_over()) break;
    failures =
        method.try_step(std::ref(varied), whole, at, next) == odeint::success ? 0 : failures + 1;
  }
  if (at < s) whole.assign(whole.size(), std::numeric_limits<double>::quiet_NaN());
  return whole;
}

// The size of each column, in the units of z; 1 where it is zero.
Vector sizes_of(const Deviations& deviations, const Vector& scale) {
  Vector sizes(deviations.count());
  for (Eigen::Index k = 0; k < sizes.size(); ++k) {
    const double size = std::fmax(scale.cwiseProduct(deviations.q.col(k)).cwiseAbs().maxCoeff(),
                                  deviations.qdot.col(k).cwiseAbs().maxCoeff());
    sizes[k] = size > 0.0 ? size : 1.0;
  }
  return sizes;
}

}  // namespace

Deviations sprung_deviations(const System& system, const SpringArc& phase, const State& start,
                             double theta, double s, const Deviations& deviations) {
  const std::optional<SprungSystem> held = constrained_system(system, phase);
  Varied varied(held ? *held : phase.equations, nullptr);
  const State from = whole_state(system, phase, start, theta);
  const Deviations all = whole_deviations(system, deviations);
  const Deviations none{Matrix(from.q.size(), 0), Matrix(from.q.size(), 0), {}};
  varied.begin(from, theta, phase.depths, none, Vector(0));
  const Vector sizes = sizes_of(all, varied.scale());
  Varied::State whole = varied.begin(from, theta, phase.depths, all, sizes);
  return own_part(system, varied.end(integrate(varied, std::move(whole), s), s));
}

Deviations sprung_parameter_deviation(const System& system, const System& tangent,
                                      const SpringArc& phase, const State& start, double theta,
                                      double s, const Deviations& column) {
  if (const auto closed =
          linear_spring_parameter_deviation(system, tangent, phase, start, theta, s, column))
    return *closed;
  Source source{system, tangent, phase.springs().all()};
  if (!phase.closed().empty()) {
    source.held = held_projection(system, phase.closed());
    source.held_rate = held_projection_rate(system, tangent, phase.closed());
  }
  const std::optional<SprungSystem> held = constrained_system(system, phase);
  Varied varied(held ? *held : phase.equations, &source);
  const State from = whole_state(system, phase, start, theta);
  const Deviations all = whole_deviations(system, column);
  const auto follow = [&](const Vector& sizes) {
    return varied.end(integrate(varied, varied.begin(from, theta, phase.depths, all, sizes), s), s);
  };
  // The size of a deviation is known only once it has been followed: first with the steps that the
  // motion alone needs.
  const Deviations rough = follow(Vector::Constant(1, std::numeric_limits<double>::max()));
  const Vector size = sizes_of(rough, varied.scale()).cwiseMax(sizes_of(all, varied.scale()));
  return own_part(system, follow(size));
}

}  // namespace graze
