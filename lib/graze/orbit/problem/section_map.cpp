#include "graze/orbit/problem/detail/section_map.hpp"

#include <algorithm>
#include <utility>

#include "graze/base/angle.hpp"
#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/system/detail/gap_value.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// Number of time constants until the structure leaves a spring. Where the resistance R grows with
// the depth x (damping by Lee and Wang's first law, or Hunt and Crossley's) the force F - R v
// vanishes at a speed that does not grow with x, and the structure moves out no faster: that takes
// x R/F. Its velocity settles in m/R, m the effective mass 1/|row|^2, which an integration has to
// resolve.
double time_constants_to_leave(const Stop& stop, double depth) {
  const ContactForce& law = stop.force();
  if (law.damping != ContactDamping::kDepth && law.damping != ContactDamping::kPower) return 0.0;
  const double resistance = law.resistance(depth);
  return resistance * resistance * depth * stop.row.squaredNorm() /
         (law.stiffness * law.power(depth));
}

// Contacts of orbits last less than one time constant, or as many as the square of the speed over
// that at which the force vanishes; each costs some ten evaluations.
constexpr double kMostTimeConstants = 1e4;

// Whether a motion can start at these positions, with the stops `closed` touched.
bool is_clear(const System& system, const Vector& q, const std::vector<int>& closed) {
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Stop& stop = system.stops[i];
    if (std::binary_search(closed.begin(), closed.end(), static_cast<int>(i))) continue;
    if (stop.is_compliant()) {
      const double depth = stop.row.dot(q) - stop.gap;
      if (depth > 0.0 && time_constants_to_leave(stop, depth) > kMostTimeConstants) return false;
      continue;
    }
    const GapValue<double> gap = gap_value<double>(stop.row, q, stop.gap);
    if (gap.value < -gap.rounding) return false;
  }
  return true;
}

Instant<double> instant_at(const System& system, double theta) {
  const double local = wrapped(theta - system.forcing()->phase) / system.forcing()->frequency;
  return {0, local < system.period() ? local : 0.0};
}

}  // namespace

double seconds_between(const System& system, const Instant<double>& from,
                       const Instant<double>& to) {
  return static_cast<double>(to.period - from.period) * system.period() + to.local - from.local;
}

std::vector<int> closed_stops(const MotionState<double>& at) {
  std::vector<int> closed;
  const std::size_t stops = at.contacts.size() - (at.places ? at.places->size() : 0);
  for (std::size_t i = 0; i < stops; ++i)
    if (at.contacts[i] == Contact::kClosed) closed.push_back(static_cast<int>(i));
  return closed;
}

State rate_of(const System& system, const MotionState<double>& at) {
  Motion<double> motion(system, at);
  CarriedDeviations none(system, motion, nullptr, nullptr);
  return none.rate_now(none.closed_now());
}

SectionMap::SectionMap(const System& reference, std::vector<int> closed,
                       const SegmentOptions& options)
    : options_(options), closed_(std::move(closed)) {
  const Eigen::Index n = reference.modes();
  const MotionScale scale = motion_scale(reference);
  basis_ = Matrix::Identity(n, n);
  Vector speeds = scale.velocity;
  if (!closed_.empty()) {
    const ConstrainedStructure<double> held(reference, closed_);
    basis_ = held.basis;
    speeds = scale.displacement * held.reduced.omega.cwiseMax(reference.forcing()->frequency);
  }
  const Eigen::Index m = basis_.cols();
  unit_.resize(2 * m);
  if (const Matrix* own = reference.coordinates()) {
    basis_ = closed_.empty() ? basis_ : orthonormal_columns<double>(*own * basis_, m);
    unit_ << Vector::Constant(m, scale.length), Vector::Constant(m, scale.speed);
  } else {
    unit_ << Vector::Constant(m, scale.displacement), speeds;
  }
}

Matrix SectionMap::seen(const System& system, const Matrix& q, const Matrix& qdot) const {
  Matrix coordinates(size(), q.cols());
  if (closed_.empty() && !system.coordinates()) {
    coordinates << q, qdot;
  } else {
    const Matrix own = seen_by(system);
    coordinates << own * q, own * qdot;
  }
  return unit_.cwiseInverse().asDiagonal() * coordinates;
}

Vector SectionMap::pack(const System& system, const State& state) const {
  return seen(system, state.q, state.qdot);
}

Vector SectionMap::pack_rate(const System& system, const System& tangent, const State& at,
                             const State& moved) const {
  const Vector rate = pack(system, moved);
  return tangent.coordinates() ? Vector(rate + pack(tangent, at)) : rate;
}

std::optional<SectionMap::Chart> SectionMap::chart_at(const System& system, const Vector& x) const {
  if (!x.allFinite()) return {};
  const Eigen::Index n = system.modes(), m = basis_.cols(), k = n - m;
  const Vector coordinates = x.cwiseProduct(unit_);
  if (k == 0 && !system.coordinates())
    return Chart{{coordinates.head(n), coordinates.tail(n)}, basis_};
  Matrix right = Matrix::Zero(n, 2 + m);
  for (Eigen::Index a = 0; a < k; ++a)
    right(a, 0) = system.stops[static_cast<std::size_t>(closed_[static_cast<std::size_t>(a)])].gap;
  right.col(0).tail(m) = coordinates.head(m);
  right.col(1).tail(m) = coordinates.tail(m);
  right.bottomRightCorner(m, m).setIdentity();
  const Matrix solution = LuFactors(determining(system)).solve_columns(right);
  if (!solution.allFinite()) return {};
  return Chart{{solution.col(0), solution.col(1)}, solution.rightCols(m)};
}

// B^T dq = da - dB^T q, U^T T dq = -U^T dT q; likewise for the velocity.
State SectionMap::chart_rate(const System& system, const System& tangent, const State& at) const {
  const Eigen::Index n = at.q.size(), k = n - basis_.cols();
  if (k == 0 && !tangent.coordinates()) return {Vector::Zero(n), Vector::Zero(n)};
  Matrix state(n, 2), right = Matrix::Zero(n, 2);
  state << at.q, at.qdot;
  if (k > 0) right.topRows(k) = -rows_of(tangent, closed_).transpose() * state;
  for (Eigen::Index a = 0; a < k; ++a)
    right(a, 0) +=
        tangent.stops[static_cast<std::size_t>(closed_[static_cast<std::size_t>(a)])].gap;
  if (tangent.coordinates()) right.bottomRows(n - k) = -seen_by(tangent) * state;
  const Matrix moved = LuFactors(determining(system)).solve_columns(right);
  return {moved.col(0), moved.col(1)};
}

ParameterDeviation SectionMap::moved_start(const System& system, const System& tangent,
                                           const State& at,
                                           const MotionState<double>& start) const {
  ParameterDeviation moved(system, tangent, chart_rate(system, tangent, at));
  moved.begin(at, start);
  return moved;
}

Matrix SectionMap::seen_by(const System& system) const {
  const Matrix* own = system.coordinates();
  return own ? Matrix(basis_.transpose() * *own) : Matrix(basis_.transpose());
}

Matrix SectionMap::determining(const System& system) const {
  const Eigen::Index n = system.modes(), m = basis_.cols();
  Matrix whole(n, n);
  if (m < n) whole.topRows(n - m) = rows_of(system, closed_).transpose();
  whole.bottomRows(m) = seen_by(system);
  return whole;
}

std::optional<MotionState<double>> SectionMap::start_of(const System& system, const Vector& x,
                                                        double theta) const {
  const std::optional<Chart> chart = chart_at(system, x);
  if (!chart || !is_clear(system, chart->state.q, closed_)) return {};
  const State& at = chart->state;
  const Instant<double> instant = instant_at(system, theta);
  MotionState<double> own = Motion<double>(system, instant, at.q, at.qdot).state();
  if (closed_.empty()) return own;
  MotionState<double> state{instant, at.q, at.qdot,
                            std::vector<Contact>(system.stops.size(), Contact::kClear),
                            std::vector<int>(system.stops.size(), 0)};
  for (std::size_t i = system.stops.size(); i < own.contacts.size(); ++i) {
    state.contacts.push_back(own.contacts[i]);
    state.multiplicities.push_back(own.multiplicities[i]);
  }
  state.places = own.places;
  for (std::size_t i = 0; i < system.stops.size(); ++i)
    if (system.stops[i].is_compliant() && system.stops[i].row.dot(at.q) > system.stops[i].gap)
      state.contacts[i] = Contact::kCompressed;
  for (const int i : closed_) state.contacts[static_cast<std::size_t>(i)] = Contact::kClosed;
  return state;
}

// Deviations by theta where it moves, by y and y'. A later theta is the same state at a later time:
// the motion up to that time is subtracted.
Deviations SectionMap::start_deviations(const System& system, const MotionState<double>& start,
                                        const Chart& chart, bool moves) const {
  const Eigen::Index n = system.modes(), m = basis_.cols(), first = moves ? 1 : 0;
  Deviations deviations{Matrix::Zero(n, first + 2 * m), Matrix::Zero(n, first + 2 * m),
                        Eigen::RowVectorXd::Zero(first + 2 * m)};
  deviations.q.middleCols(first, m) = chart.slope * unit_.head(m).asDiagonal();
  deviations.qdot.rightCols(m) = chart.slope * unit_.tail(m).asDiagonal();
  if (!moves) return deviations;
  const State rate = rate_of(system, start);
  deviations.q.col(0) = -rate.q / system.forcing()->frequency;
  deviations.qdot.col(0) = -rate.qdot / system.forcing()->frequency;
  return deviations;
}

std::optional<SectionMap::Image> SectionMap::image(const System& system, const Vector& x,
                                                   double theta, int periods, bool moves,
                                                   std::span<const System* const> tangents) const {
  const std::optional<Chart> chart = chart_at(system, x);
  const std::optional<MotionState<double>> start = start_of(system, x, theta);
  if (!chart || !start) return {};
  const Instant<double> end{periods, start->instant.local};
  Deviations deviations = start_deviations(system, *start, *chart, moves);
  Image image;
  image.by_parameters.resize(size(), static_cast<Eigen::Index>(tangents.size()));
  // The first tangent is carried together with the deviations, each other one by itself.
  for (std::size_t k = 0; k < std::max<std::size_t>(tangents.size(), 1); ++k) {
    std::optional<ParameterDeviation> parameter;
    if (k < tangents.size())
      parameter = moved_start(system, *tangents[k], chart->state, *start);
    TrajectorySegment segment = pass(system, *start, end, options_, k == 0 ? &deviations : nullptr,
                                     parameter ? &*parameter : nullptr);
    if (!segment.failure.empty()) return {};
    if (parameter)
      image.by_parameters.col(static_cast<Eigen::Index>(k)) =
          pack_rate(system, *tangents[k], {segment.end.q, segment.end.qdot}, parameter->value());
    if (k > 0) continue;
    image.end = std::move(segment.end);
    image.contacts = std::move(segment.contacts);
  }
  image.image = pack(system, {image.end.q, image.end.qdot});
  const Matrix slopes = seen(system, deviations.q, deviations.qdot);
  if (!slopes.allFinite()) return {};
  image.jacobian = slopes.rightCols(size());
  if (!moves) return image;
  const State rate = rate_of(system, image.end);
  image.by_start = slopes.col(0);
  image.by_end = pack(system, rate) / system.forcing()->frequency;
  return image;
}

std::string SectionMap::why_no_image(const System& system, const Vector& x, double theta,
                                     int periods) const {
  const std::optional<Chart> chart = chart_at(system, x);
  const std::optional<MotionState<double>> start = start_of(system, x, theta);
  if (!chart || !start) return "the motion cannot start on the section";
  Deviations deviations = start_deviations(system, *start, *chart, false);
  return pass(system, *start, {periods, start->instant.local}, options_, &deviations).failure;
}

std::optional<TrajectorySegment> SectionMap::follow(const System& system, const Vector& x,
                                                    double theta, int periods, bool minima) const {
  const std::optional<MotionState<double>> start = start_of(system, x, theta);
  if (!start) return {};
  SegmentOptions options = options_;
  options.minima = minima;
  TrajectorySegment segment = pass(system, *start, {periods, start->instant.local}, options);
  if (!segment.failure.empty()) return {};
  return segment;
}

std::optional<TrajectorySegment> SectionMap::follow_along(const System& system, const Vector& x,
                                                          double theta, int periods, bool moves,
                                                          const System& tangent,
                                                          const Vector& direction,
                                                          double parameter_rate) const {
  const std::optional<Chart> chart = chart_at(system, x);
  const std::optional<MotionState<double>> start = start_of(system, x, theta);
  if (!chart || !start) return {};
  Deviations deviations = start_deviations(system, *start, *chart, moves);
  ParameterDeviation parameter = moved_start(system, tangent, chart->state, *start);
  SegmentOptions options = options_;
  options.along = SegmentDirection{direction, parameter_rate, &tangent};
  TrajectorySegment segment =
      pass(system, *start, {periods, start->instant.local}, options, &deviations, &parameter);
  if (!segment.failure.empty()) return {};
  return segment;
}

std::optional<SectionMap::Within> SectionMap::within(
    const System& system, const Vector& x, double theta, double angle, bool moves,
    std::span<const System* const> tangents) const {
  const std::optional<Chart> chart = chart_at(system, x);
  const std::optional<MotionState<double>> start = start_of(system, x, theta);
  if (!chart || !start) return {};
  const double frequency = system.forcing()->frequency;
  const Instant<double> end = later(start->instant, angle / frequency, system.period());
  Within within;
  Deviations deviations = start_deviations(system, *start, *chart, moves);
  TrajectorySegment segment = pass(system, *start, end, options_, &deviations);
  if (!segment.failure.empty()) return {};
  within.by_state = {deviations.q.rightCols(size()), deviations.qdot.rightCols(size()), {}};
  if (moves) within.by_start = {deviations.q.col(0), deviations.qdot.col(0)};
  within.at = std::move(segment.end);
  within.state = {within.at.q, within.at.qdot};
  for (const System* tangent : tangents) {
    ParameterDeviation parameter = moved_start(system, *tangent, chart->state, *start);
    if (!pass(system, *start, end, options_, nullptr, &parameter).failure.empty()) return {};
    within.by_parameters.push_back(parameter.value());
  }
  within.by_angle = rate_of(system, within.at);
  within.by_angle.q /= frequency;
  within.by_angle.qdot /= frequency;
  return within;
}

SectionMap SectionMap::leaving_out(const LeftOut& one) const {
  SectionMap other = *this;
  other.options_.left_out = one;
  return other;
}

}  // namespace graze
