#include "graze/orbit/strobe_map.hpp"

#include "graze/base/angle.hpp"
#include "graze/flow/deviation.hpp"
#include "graze/orbit/shooting.hpp"
#include "graze/system/gap_value.hpp"

namespace graze {
namespace {

// Where the resistance R grows with the depth x (damping by Lee and Wang's first law, or Hunt and
// Crossley's) the force F - R v of a spring vanishes at a speed that does not grow with it, and the
// structure comes out no faster: that takes x R/F. Its velocity settles in m/R, m the effective
// mass 1/|row|^2, which an integration has to resolve.
double time_constants_to_leave(const Stop& stop, double depth) {
  const ContactForce& law = stop.force();
  if (law.damping != ContactDamping::kDepth && law.damping != ContactDamping::kPower) return 0.0;
  const double resistance = law.resistance(depth);
  return resistance * resistance * depth * stop.row.squaredNorm() /
         (law.stiffness * law.power(depth));
}

// Contacts of orbits have less than one, or as many as the square of the speed over that at which
// the force vanishes; each costs some ten evaluations.
constexpr double kMostTimeConstants = 1e4;

}  // namespace

StrobeMap::StrobeMap(const System& reference, const PassageOptions& options, double section)
    : options_(options), section_(section), unit_(2 * reference.modes()) {
  const MotionScale scale = motion_scale(reference);
  unit_ << Vector::Constant(reference.modes(), scale.displacement), scale.velocity;
}

Vector StrobeMap::pack(const State& state) const {
  Vector x(size());
  x << state.q, state.qdot;
  return x.cwiseQuotient(unit_);
}

Vector StrobeMap::pack(const std::vector<State>& turns) const {
  Vector u(static_cast<Eigen::Index>(turns.size()) * size());
  for (std::size_t i = 0; i < turns.size(); ++i)
    u.segment(static_cast<Eigen::Index>(i) * size(), size()) = pack(turns[i]);
  return u;
}

State StrobeMap::unpack(const Vector& x) const {
  const Vector whole = x.cwiseProduct(unit_);
  const Eigen::Index n = size() / 2;
  return {whole.head(n), whole.tail(n)};
}

Instant<double> StrobeMap::first_instant(const System& system) const {
  const double local = wrapped(section_ - system.forcing()->phase) / system.forcing()->frequency;
  return {0, local < system.period() ? local : 0.0};
}

std::optional<MotionState<double>> StrobeMap::start_of(const System& system,
                                                       const Vector& x) const {
  const State state = unpack(x);
  if (!x.allFinite()) return {};
  for (const Stop& stop : system.stops) {
    if (stop.is_compliant()) {
      const double depth = stop.row.dot(state.q) - stop.gap;
      if (depth > 0.0 && time_constants_to_leave(stop, depth) > kMostTimeConstants) return {};
      continue;
    }
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    if (gap.value < -gap.rounding) return {};
  }
  const Instant<double> instant = first_instant(system);
  return Motion<double>(system, instant, state.q, state.qdot).state();
}

Instant<double> StrobeMap::end_of(const MotionState<double>& start) const {
  return {1, start.instant.local};
}

Deviations StrobeMap::unit_deviations() const {
  const Eigen::Index n = size() / 2;
  Deviations deviations{Matrix::Zero(n, 2 * n), Matrix::Zero(n, 2 * n),
                        Eigen::RowVectorXd::Zero(2 * n)};
  deviations.q.leftCols(n) = unit_.head(n).asDiagonal();
  deviations.qdot.rightCols(n) = unit_.tail(n).asDiagonal();
  return deviations;
}

std::optional<StrobeMap::Image> StrobeMap::image(const System& system, const Vector& x,
                                                 const System* tangent) const {
  const std::optional<MotionState<double>> start = start_of(system, x);
  if (!start) return {};
  const Eigen::Index n = size() / 2;
  Deviations deviations = unit_deviations();
  std::optional<ParameterDeviation> parameter;
  if (tangent) parameter.emplace(system, *tangent, State{Vector::Zero(n), Vector::Zero(n)});
  const Passage passage = pass(system, *start, end_of(*start), options_, &deviations,
                               parameter ? &*parameter : nullptr);
  if (!passage.failure.empty()) return {};
  Image image{pack({passage.end.q, passage.end.qdot}), Matrix(2 * n, 2 * n), {}};
  image.jacobian << deviations.q, deviations.qdot;
  image.jacobian = unit_.cwiseInverse().asDiagonal() * image.jacobian;
  if (parameter) image.by_parameter = pack(parameter->value());
  if (!image.jacobian.allFinite()) return {};
  return image;
}

std::optional<Vector> StrobeMap::rate(const System& system, const Vector& x,
                                      const System& tangent) const {
  const std::optional<MotionState<double>> start = start_of(system, x);
  if (!start) return {};
  const Eigen::Index n = size() / 2;
  ParameterDeviation parameter(system, tangent, State{Vector::Zero(n), Vector::Zero(n)});
  const Passage passage = pass(system, *start, end_of(*start), options_, nullptr, &parameter);
  if (!passage.failure.empty()) return {};
  return pack(parameter.value());
}

std::optional<StrobeMap::Within> StrobeMap::within(const System& system, const Vector& x,
                                                   double angle,
                                                   std::span<const System* const> tangents) const {
  const std::optional<MotionState<double>> start = start_of(system, x);
  if (!start) return {};
  const Eigen::Index n = size() / 2;
  const double frequency = system.forcing()->frequency;
  const Instant<double> end = later(start->instant, angle / frequency, system.period());
  Within within;
  within.by_state = unit_deviations();
  Passage passage = pass(system, *start, end, options_, &within.by_state);
  if (!passage.failure.empty()) return {};
  within.at = std::move(passage.end);
  within.state = {within.at.q, within.at.qdot};
  for (const System* tangent : tangents) {
    ParameterDeviation parameter(system, *tangent, State{Vector::Zero(n), Vector::Zero(n)});
    if (!pass(system, *start, end, options_, nullptr, &parameter).failure.empty()) return {};
    within.by_parameters.push_back(parameter.value());
  }
  const Motion<double> motion(system, within.at);
  within.by_angle = held_rate(system, {}, within.state, motion.flow().phase(within.at.instant));
  for (std::size_t i = 0; i < system.stops.size(); ++i)
    within.by_angle.qdot -= motion.spring_force(static_cast<int>(i)) * system.stops[i].row;
  within.by_angle.q /= frequency;
  within.by_angle.qdot /= frequency;
  return within;
}

std::optional<Passage> StrobeMap::follow(const System& system, const Vector& x, bool minima) const {
  const std::optional<MotionState<double>> start = start_of(system, x);
  if (!start) return {};
  PassageOptions options = options_;
  options.minima = minima;
  Passage passage = pass(system, *start, end_of(*start), options);
  if (!passage.failure.empty()) return {};
  return passage;
}

}  // namespace graze
