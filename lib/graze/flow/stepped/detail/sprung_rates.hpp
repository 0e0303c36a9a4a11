// The right-hand side of a structure on compressed springs (SprungSystem), in units of the contact:
//
//   z = (w (y - y_0)/u, y'/u),   w_j = max(omega_j, w_c),
//
// with w_c the frequency and u the speed of the contact that begins: its depths are small against
// the displacements, and errors are measured against them. Displacements are counted from the start
// of the piece, so that a depth does not lose the digits of the displacement before it. The works
// follow z, those of the springs per u^2, the others per the square of the largest velocity.
//
// A structure on a rotating hub (SprungSystem::turning) is integrated here with springs and
// without; u is then the size of its own motion.
#pragma once

#include <limits>

#include "graze/base/angle.hpp"
#include "graze/flow/stepped/detail/step_rates.hpp"

namespace graze::step_walk {

// Roundings, of each coordinate's part, in a grip that is computed from the state.
inline constexpr double kGripRoundings = 8.0;

// Rounding of a sum of exponentials, in errors of a step: for 128 modes, each with some roundings.
inline constexpr double kModalErrors = 1024.0;

class Sprung {
 public:
  using State = std::vector<double>;
  // Coordinates that do not take part in the contact are known to some roundings of their size.
  static double relative(double /*tolerance*/) {
    return 4.0 * std::numeric_limits<double>::epsilon();
  }

  // `tolerance`: of a step, against u; 0: its length is fixed.
  Sprung(const SprungSystem& system, double tolerance)
      : system_(system),
        tolerance_(tolerance),
        contacts_(system.springs.size()),
        grips_(system.springs.size()),
        grip_roundings_(system.springs.size()) {}

  // To be called before begin(): the time, s, on which a torque depends.
  void set_time(double time) {
    if (system_.turning) system_.turning->structure.begin(time);
  }
  void begin(double theta, const Vector& x, std::span<const double> depths, State& start);
  void operator()(const State& z, State& slope, double s);
  double observed(const Watch& watch, double s, const State& z);
  // Rate of change of a watch, per s.
  double rate(const Watch& watch, double s, const State& z);
  void whole(const State& z, Vector& x) const;
  SprungWorks works(const State& z) const;
  double frequency() const { return system_.frequency; }
  // Units u of the velocities, and w.
  double unit() const { return unit_; }
  const Vector& scale() const { return scale_; }
  struct Compression {
    double depth = 0.0, rate = 0.0;  // m, m/s
  };
  // The depth of a spring at the start, m, and what an entry of z adds to it and to its rate.
  struct Contact {
    double start = 0.0;
    Vector depth, rate;
  };
  Compression compression(std::size_t spring, const State& z) const;
  // Depth of a spring whose surface the structure touches at rest, m, and its error bound after so
  // many steps: each step errs by its tolerance and rounding in each entry of z, and sums of modes
  // that go on from there by kModalErrors as much. A late decision changes nothing: until then the
  // spring acts as it does beyond its surface.
  struct Left {
    double value = 0.0, error = 0.0;
    bool is_certain() const { return std::abs(value) > error; }
  };
  Left left(std::size_t spring, const State& z, long long steps) const;
  // The same for the gap or the contact force of a rigid stop that was zero at the start, s seconds
  // later.
  Left changed(const Watch& watch, double s, const State& z, long long steps) const;
  // Force of a spring, N, and its rate, N/s; 0 where it is not loaded.
  std::size_t springs() const { return contacts_.size(); }
  double force(std::size_t spring, const State& z) const;
  bool is_damped(std::size_t spring) const {
    return system_.springs[spring].law.damping != ContactDamping::kNone;
  }
  double force_rate(std::size_t spring, double s, const State& z);
  // The longest step, s, that resolves the force of a parted spring: one whose damping sets in
  // within a depth h takes hold there within h/(2 Q v). For a structure on a rotating hub it is a
  // quarter of its fastest oscillation: between its ends a gap has hardly more than one minimum,
  // which is searched for.
  double longest_step() const { return longest_step_; }
  // The first step, s: a part of the contact that is long enough to estimate the error. Where the
  // depths of all springs are held, the fastest oscillation replaces the contact.
  double first_step(double longest) const {
    const double pace = contact_frequency_ > 0.0 ? contact_frequency_ : quickest();
    return pace > 0.0 ? std::fmin(longest, 0.1 / pace) : longest;
  }

  // The highest frequency of the structure, the contact and the force, rad/s; 0 on a rotating hub,
  // where steps are short against it.
  double quickest() const {
    return system_.turning ? 0.0 : std::fmax(largest_of(scale_), system_.frequency);
  }
  // For series expansions; on a rotating hub the right-hand side has more terms.
  const SprungSystem& system() const { return system_; }
  const Contact& contact(std::size_t spring) const { return contacts_[spring]; }
  Eigen::Index modes() const { return system_.load.size(); }
  double start_phase() const { return theta_; }
  double contact_frequency() const { return contact_frequency_; }  // w_c, rad/s
  double work_unit() const { return work_unit_; }
  const Vector& push() const { return push_; }            // constant forces over u
  const Vector& harmonic() const { return force_; }       // amplitudes of the harmonic force over u
  const Matrix& stiffness() const { return stiffness_; }  // K/w
  // Places of the works in z: of forcing, weight, damping and closed stops, and lost in the
  // springs.
  enum Place { kForcing, kWeight, kDissipation, kConstraint, kSprings };
  std::size_t place(std::size_t work) const { return 2 * static_cast<std::size_t>(modes()) + work; }

  long long evaluations = 0;

 private:
  // 0 for an empty vector: the structure may be held in all its coordinates.
  static double largest_of(const Vector& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }
  Vector times(const Matrix& matrix, const Vector& y) const {
    return matrix.cols() == 1 ? Vector(matrix.col(0).cwiseProduct(y)) : Vector(matrix * y);
  }
  Compression compression_rate(std::size_t spring, const State& slope) const;
  void set_units(double theta, const Vector& velocity, std::span<const double> depths);
  void add_moving_powers(const State& z, double cosine, double s, State& slope);
  void add_powers(const State& z, const Vector& resistance, double cosine, double s, State& slope);
  // For a rotating hub: the motion in all coordinates, forces other than springs and stiffness, the
  // inertia that the shape adds, and a force that holds the structure.
  void spread(const State& z);
  void turn(double s, Eigen::Ref<Vector> acceleration, State& slope);
  void add_inertia(Eigen::Ref<Vector> acceleration) const;
  void set_turning_units(const Vector& velocity);
  double hold_force(int hold, double s, const State& z);
  double hold_rate(int hold, double s, const State& z);
  double gained(const Watch& watch, const State& z) const;
  // Error bounds of the entries of a part of z after so many steps.
  Vector errors(const Eigen::Ref<const Vector>& part, long long steps) const;
  Vector spring_push(const State& z) const;

  SprungSystem system_;
  double tolerance_;
  double theta_ = 0.0;
  Vector from_;            // y_0
  Vector start_velocity_;  // y'_0/u
  Vector scale_;           // w
  double unit_ = 1.0;      // u
  double work_unit_ = 1.0;
  double longest_step_ = 0.0;
  double contact_frequency_ = 0.0;
  Vector push_, force_;  // per u: the part of the forces that does not depend on z, and the
                         // harmonic part
  Matrix stiffness_;     // K/w
  std::vector<Contact> contacts_;
  std::vector<double> grips_, grip_roundings_;  // at the start
  State slope_;
  Vector resistance_;
  Vector y_, ydot_;  // of a structure that turns, in all coordinates
  Vector angle_;     // its row on those that are left free
};

inline Sprung::Compression Sprung::compression(std::size_t spring, const State& z) const {
  const Contact& contact = contacts_[spring];
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n), velocity(z.data() + n, n);
  return {contact.start + contact.depth.dot(moved), contact.rate.dot(velocity)};
}

inline Sprung::Left Sprung::left(std::size_t spring, const State& z, long long steps) const {
  const Contact& contact = contacts_[spring];
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n);
  return {contact.start + contact.depth.dot(moved),
          contact.depth.cwiseAbs().dot(errors(moved, steps))};
}

inline Vector Sprung::errors(const Eigen::Ref<const Vector>& part, long long steps) const {
  const double per_entry = tolerance_ * static_cast<double>(steps);
  const double per_size = relative(tolerance_) * static_cast<double>(steps) +
                          static_cast<double>(modes()) * std::numeric_limits<double>::epsilon();
  return kModalErrors * (per_entry + per_size * part.cwiseAbs().array()).matrix();
}

inline Sprung::Compression Sprung::compression_rate(std::size_t spring, const State& slope) const {
  const Contact& contact = contacts_[spring];
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(slope.data(), n), velocity(slope.data() + n, n);
  return {contact.depth.dot(moved), contact.rate.dot(velocity)};
}

// A body of inverse mass 1/m = row.acting that meets the spring at speed v, or rests on it under a
// push a, or is at a depth: the largest of these depths and the stiffness there set the units.
inline void Sprung::set_units(double theta, const Vector& velocity,
                              std::span<const double> depths) {
  const Vector acceleration = system_.load + system_.force * std::cos(theta) -
                              times(system_.damping, velocity) - times(system_.stiffness, from_);
  contact_frequency_ = unit_ = 0.0;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const SprungSystem::Spring& spring = system_.springs[i];
    const double mobility = spring.row.dot(spring.acting), n = spring.law.exponent;
    const double stiffness = spring.law.stiffness * mobility;
    const double v = std::abs(spring.row.dot(velocity)), a = spring.row.dot(acceleration);
    double depth = std::abs(depths[i]);
    depth = std::fmax(depth, std::pow(0.5 * (n + 1.0) * v * v / stiffness, 1.0 / (n + 1.0)));
    depth = std::fmax(depth, std::pow(2.0 * std::fmax(a, 0.0) / stiffness, 1.0 / n));
    const double frequency = std::sqrt(stiffness * std::pow(depth, n - 1.0));
    contact_frequency_ =
        std::fmax(contact_frequency_, frequency + spring.law.resistance(depth) * mobility);
    unit_ = std::fmax(unit_, frequency * depth / std::sqrt(mobility));
  }
  longest_step_ = std::numeric_limits<double>::infinity();
  for (const SprungSystem::Spring& spring : system_.springs) {
    const double v = std::abs(spring.row.dot(velocity));
    if (!spring.loaded && !spring.resting && spring.law.damping == ContactDamping::kOnset &&
        v > 0.0)
      longest_step_ =
          std::fmin(longest_step_, spring.law.onset_depth / (2.0 * spring.law.onset_sharpness * v));
  }
  if (system_.turning) set_turning_units(velocity);
  // No error is smaller than the rounding of the velocities, those that the forces cause among
  // them: at rest, where the push begins at zero, nothing else tells how fast anything will be.
  const double pace = std::fmax(contact_frequency_, system_.frequency);
  const double driven =
      pace > 0.0 ? (largest_of(system_.load) + largest_of(system_.force)) / pace : 0.0;
  const double rounding =
      std::numeric_limits<double>::epsilon() * std::fmax(largest_of(velocity), driven);
  if (tolerance_ > 0.0) unit_ = std::fmax(unit_, 16.0 * rounding / tolerance_);
  if (!(unit_ > 0.0)) unit_ = 1.0;
}

inline void Sprung::begin(double theta, const Vector& x, std::span<const double> depths,
                          State& start) {
  const Eigen::Index n = modes();
  theta_ = theta;
  from_ = x.head(n);
  const Vector velocity = x.tail(n);
  set_units(theta, velocity, depths);
  const Vector own = system_.stiffness.cols() == 1 ? Vector(system_.stiffness.col(0))
                                                   : Vector(system_.stiffness.diagonal());
  scale_ = own.cwiseMax(0.0).cwiseSqrt().cwiseMax(contact_frequency_);
  // A coordinate without restoring force gets the unit of the slowest of the others.
  for (double& w : scale_)
    if (!(w > 0.0)) w = system_.turning ? system_.turning->structure.lowest_frequency() : 1.0;
  push_ = (system_.load - times(system_.stiffness, from_)) / unit_;
  force_ = system_.force / unit_;
  stiffness_ = system_.stiffness.cols() == 1
                   ? Matrix(system_.stiffness.col(0).cwiseQuotient(scale_))
                   : Matrix(system_.stiffness * scale_.cwiseInverse().asDiagonal());
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Vector& row = system_.springs[i].row;
    contacts_[i] = {depths[i], unit_ * row.cwiseQuotient(scale_), unit_ * row};
  }
  const double largest = std::fmax(unit_, largest_of(velocity));
  work_unit_ = largest * largest;
  if (system_.turning) angle_ = system_.turning->gathered(system_.turning->structure.angle_row());
  start.assign(place(kSprings) + contacts_.size(), 0.0);
  start_velocity_ = velocity / unit_;
  Eigen::Map<Vector>(start.data() + n, n) = start_velocity_;
  for (std::size_t i = 0; i < grips_.size(); ++i) {
    const Compression at = compression(i, start);
    const ContactForce& law = system_.springs[i].law;
    grips_[i] = law.grip(at.depth, at.rate);
    const double speeds = system_.springs[i].row.cwiseAbs().dot(velocity.cwiseAbs());
    grip_roundings_[i] = kGripRoundings * static_cast<double>(n) *
                         std::numeric_limits<double>::epsilon() * law.grip_size(at.depth, speeds);
  }
}

inline void Sprung::operator()(const State& z, State& slope, double s) {
  ++evaluations;
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n), velocity(z.data() + n, n);
  Eigen::Map<Vector> rate(slope.data(), n), acceleration(slope.data() + n, n);
  rate = scale_.cwiseProduct(velocity);
  acceleration = push_;
  const double cosine = system_.frequency > 0.0 ? std::cos(theta_ + system_.frequency * s) : 0.0;
  if (system_.frequency > 0.0) acceleration += force_ * cosine;
  if (stiffness_.cols() == 1)
    acceleration -= stiffness_.col(0).cwiseProduct(moved);
  else
    acceleration.noalias() -= stiffness_ * moved;
  if (system_.damping.cols() == 1)
    resistance_ = system_.damping.col(0).cwiseProduct(velocity);
  else
    resistance_.noalias() = system_.damping * velocity;
  if (system_.turning) {
    spread(z);
    turn(s, acceleration, slope);
  } else {
    acceleration -= resistance_;
    add_powers(z, resistance_, cosine, s, slope);
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const SprungSystem::Spring& spring = system_.springs[i];
    slope[place(kSprings + i)] = 0.0;
    if (!spring.loaded && !spring.resting) continue;
    const Compression at = compression(i, z);
    if (spring.resting && !(at.depth > 0.0)) continue;
    const double force = spring.law.at(at.depth, at.rate) / unit_;
    acceleration -= force * spring.acting;
    const double speed = at.rate / unit_;
    slope[place(kSprings + i)] = spring.law.is_of_one_piece()
                                     ? spring.law.resistance(at.depth) * speed * speed
                                     : spring.law.resisting(at.depth, at.rate) / unit_ * speed;
  }
  if (system_.turning) add_inertia(acceleration);
}

inline double Sprung::force(std::size_t spring, const State& z) const {
  if (!system_.springs[spring].loaded) return 0.0;
  const Compression at = compression(spring, z);
  return system_.springs[spring].law.at(at.depth, at.rate);
}

inline double Sprung::force_rate(std::size_t spring, double s, const State& z) {
  const SprungSystem::Spring& own = system_.springs[spring];
  if (!own.loaded) return 0.0;
  slope_.resize(z.size());
  (*this)(z, slope_, s);
  const Compression at = compression(spring, z), rate = compression_rate(spring, slope_);
  return own.law.by_depth(at.depth, at.rate) * at.rate +
         own.law.by_rate(at.depth, at.rate) * rate.rate;
}

inline double Sprung::observed(const Watch& watch, double s, const State& z) {
  if (watch.of_spring == SpringWatch::kHold)
    return watch.constant + watch.factor * hold_force(watch.spring, s, z);
  if (watch.of_spring != SpringWatch::kNone) {
    const auto i = static_cast<std::size_t>(watch.spring);
    const Compression at = compression(i, z);
    if (watch.of_spring == SpringWatch::kDepth) return at.depth;
    const double grip = system_.springs[i].law.grip(at.depth, at.rate);
    const double sign = watch.of_spring == SpringWatch::kGrip ? 1.0 : -1.0;
    // From a zero at the start on, changes within the rounding count as none.
    if (watch.multiplicity > 0) return sign * (grip - grips_[i]) + grip_roundings_[i];
    return sign * grip;
  }
  if (watch.multiplicity > 0 && watch.harmonic_re == 0.0 && watch.harmonic_im == 0.0 &&
      watch.force_weights.size() == 0)
    return gained(watch, z);
  Vector x;
  whole(z, x);
  double sum = watch.constant + watch.weights.dot(x);
  if (watch.harmonic_re != 0.0 || watch.harmonic_im != 0.0) {
    const double theta = theta_ + system_.frequency * s;
    sum += watch.harmonic_re * std::cos(theta) - watch.harmonic_im * std::sin(theta);
  }
  for (Eigen::Index i = 0; i < watch.force_weights.size(); ++i) {
    const auto spring = static_cast<std::size_t>(i);
    if (!system_.springs[spring].loaded) continue;
    const Compression at = compression(spring, z);
    sum += watch.force_weights[i] * system_.springs[spring].law.at(at.depth, at.rate);
  }
  return sum;
}

// Change since the start, where the watch is zero: computed from the motion since then, without the
// displacements before it, whose rounding is large against a gap that has just been left.
inline double Sprung::gained(const Watch& watch, const State& z) const {
  const Eigen::Index n = modes();
  const Eigen::Map<const Vector> moved(z.data(), n), velocity(z.data() + n, n);
  return unit_ * (watch.weights.head(n).cwiseQuotient(scale_).dot(moved) +
                  watch.weights.tail(n).dot(velocity - start_velocity_));
}

inline double Sprung::rate(const Watch& watch, double s, const State& z) {
  if (watch.of_spring == SpringWatch::kHold) return watch.factor * hold_rate(watch.spring, s, z);
  slope_.resize(z.size());
  (*this)(z, slope_, s);
  if (watch.of_spring != SpringWatch::kNone) {
    const auto i = static_cast<std::size_t>(watch.spring);
    const Compression at = compression(i, z), rate = compression_rate(i, slope_);
    if (watch.of_spring == SpringWatch::kDepth) return at.rate;
    const double grip = system_.springs[i].law.grip_rate(at.depth, at.rate, rate.rate);
    return watch.of_spring == SpringWatch::kGrip ? grip : -grip;
  }
  const Eigen::Index n = modes();
  double sum =
      unit_ *
      (watch.weights.head(n).cwiseQuotient(scale_).dot(Eigen::Map<const Vector>(slope_.data(), n)) +
       watch.weights.tail(n).dot(Eigen::Map<const Vector>(slope_.data() + n, n)));
  const double theta = theta_ + system_.frequency * s;
  sum -= system_.frequency *
         (watch.harmonic_re * std::sin(theta) + watch.harmonic_im * std::cos(theta));
  for (Eigen::Index i = 0; i < watch.force_weights.size(); ++i)
    if (watch.force_weights[i] != 0.0)
      sum += watch.force_weights[i] * force_rate(static_cast<std::size_t>(i), s, z);
  return sum;
}

inline void Sprung::whole(const State& z, Vector& x) const {
  const Eigen::Index n = modes();
  x.resize(2 * n);
  x.head(n) = from_ + unit_ * Eigen::Map<const Vector>(z.data(), n).cwiseQuotient(scale_);
  x.tail(n) = unit_ * Eigen::Map<const Vector>(z.data() + n, n);
}

}  // namespace graze::step_walk
