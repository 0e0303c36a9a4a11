#include "graze/orbit/release_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/base/linear_equations.hpp"
#include "graze/flow/contact_share.hpp"
#include "graze/orbit/solve.hpp"

namespace graze {
namespace {

double seconds_between(const System& system, const Instant<double>& from,
                       const Instant<double>& to) {
  return static_cast<double>(to.period - from.period) * system.period() + to.local - from.local;
}

// The sum of all sizes that a push is formed from, m/s^2.
double push_scale(const System& system, const Stop& stop) {
  double scale = stop.row.cwiseAbs().dot(system.forcing()->amplitude.cwiseAbs());
  if (system.load()) scale += stop.row.cwiseAbs().dot(system.load()->cwiseAbs());
  return scale > 0.0 ? scale : 1.0;
}

}  // namespace

// The state at the unknowns, and how it moves with y and y': q_y = V, q'_{y'} = V.
struct ReleaseSection::Chart {
  State state;
  Matrix slope;    // V with B^T V = 0, U^T V = 1
  LuFactors left;  // of [B, U]^T
};

ReleaseSection::ReleaseSection(const System& reference, Release release,
                               const PassageOptions& options)
    : release_(std::move(release)), options_(options) {
  const ContactPhase<double> phase(reference, release_.closed);
  basis_ = phase.basis();
  const double displacement = motion_scale(reference).displacement;
  unit_.resize(2 * freedoms());
  unit_ << Vector::Constant(freedoms(), displacement),
      displacement * phase.reduced().omega.cwiseMax(reference.forcing()->frequency);
  push_ = push_scale(reference, reference.stops[static_cast<std::size_t>(release_.released)]);
}

Vector ReleaseSection::pack(double theta, const State& state) const {
  Vector u(size());
  u[0] = theta;
  u.segment(1, freedoms()) = basis_.transpose() * state.q;
  u.tail(freedoms()) = basis_.transpose() * state.qdot;
  u.tail(2 * freedoms()) = u.tail(2 * freedoms()).cwiseQuotient(unit_);
  return u;
}

std::optional<ReleaseSection::Chart> ReleaseSection::chart_at(const System& system,
                                                              const Vector& u) const {
  const Eigen::Index n = system.modes(), m = freedoms(), k = n - m;
  Matrix whole(n, n);
  whole << rows_of(system, release_.closed), basis_;
  Matrix right = Matrix::Zero(n, 2 + m);
  for (Eigen::Index a = 0; a < k; ++a)
    right(a, 0) =
        system.stops[static_cast<std::size_t>(release_.closed[static_cast<std::size_t>(a)])].gap;
  const Vector coordinates = u.tail(2 * m).cwiseProduct(unit_);
  right.col(0).tail(m) = coordinates.head(m);
  right.col(1).tail(m) = coordinates.tail(m);
  right.bottomRightCorner(m, m).setIdentity();
  const LuFactors left(whole.transpose());
  const Matrix solution = left.solve_columns(right);
  if (!solution.allFinite()) return {};
  return Chart{{solution.col(0), solution.col(1)}, solution.rightCols(m), left};
}

std::optional<MotionState<double>> ReleaseSection::state_of(const System& system,
                                                            const Vector& u) const {
  const std::optional<Chart> chart = chart_at(system, u);
  if (!chart) return {};
  MotionState<double> state{{0, 0.0},
                            chart->state.q,
                            chart->state.qdot,
                            std::vector<Contact>(system.stops.size(), Contact::kClear),
                            std::vector<int>(system.stops.size(), 0)};
  for (const int i : release_.closed)
    state.contacts[static_cast<std::size_t>(i)] = Contact::kClosed;
  state.instant.local =
      wrapped(theta_of(u) - system.forcing()->phase) / system.forcing()->frequency;
  if (!(state.instant.local < system.period())) state.instant.local = 0.0;
  return state;
}

Instant<double> ReleaseSection::end_of(const MotionState<double>& start) const {
  return {release_.period, start.instant.local};
}

// The force equation and its derivatives: lambda = share.(load + amplitude cos theta - 2 delta q'
// - w^2 q).
void ReleaseSection::add_force(const System& system, const Vector& u, const Chart& chart,
                               const System* tangent, const State& chart_rate,
                               Equations& equations) const {
  const Eigen::Index m = freedoms();
  const auto place = std::find(release_.closed.begin(), release_.closed.end(), release_.released) -
                     release_.closed.begin();
  const Vector share = contact_share(system, release_.closed).row(place);
  const Vector stiffness = system.omega.cwiseAbs2();
  const Vector &q = chart.state.q, &qdot = chart.state.qdot;
  const double c = std::cos(theta_of(u)), n = std::sin(theta_of(u));
  Vector acceleration = system.forcing()->amplitude * c - 2.0 * system.delta().cwiseProduct(qdot) -
                        stiffness.cwiseProduct(q);
  if (system.load()) acceleration += *system.load();
  equations.residual[0] = share.dot(acceleration) / push_;
  equations.jacobian(0, 0) = -share.dot(system.forcing()->amplitude) * n / push_;
  Eigen::RowVectorXd by_state(2 * m);
  by_state << -share.cwiseProduct(stiffness).transpose() * chart.slope,
      -2.0 * share.cwiseProduct(system.delta()).transpose() * chart.slope;
  equations.jacobian.row(0).tail(2 * m) = by_state.cwiseProduct(unit_.transpose()) / push_;
  if (!tangent) return;
  const Vector share_rate = contact_share_rate(system, *tangent, release_.closed).row(place);
  Vector acceleration_rate =
      tangent->forcing()->amplitude * c - 2.0 * tangent->delta().cwiseProduct(qdot) -
      2.0 * system.omega.cwiseProduct(tangent->omega).cwiseProduct(q) -
      2.0 * system.delta().cwiseProduct(chart_rate.qdot) - stiffness.cwiseProduct(chart_rate.q);
  if (tangent->load()) acceleration_rate += *tangent->load();
  equations.parameter_derivative[0] =
      (share_rate.dot(acceleration) + share.dot(acceleration_rate)) / push_;
}

// How the state at fixed unknowns moves with the parameter: B^T dq = da - dB^T q, U^T dq = 0.
State ReleaseSection::chart_rate(const System& tangent, const Chart& chart) const {
  const Eigen::Index n = chart.state.q.size(), k = n - freedoms();
  const Matrix rows_rate = rows_of(tangent, release_.closed);
  Matrix right = Matrix::Zero(n, 2);
  right.col(0).head(k) = -rows_rate.transpose() * chart.state.q;
  right.col(1).head(k) = -rows_rate.transpose() * chart.state.qdot;
  for (Eigen::Index a = 0; a < k; ++a)
    right(a, 0) +=
        tangent.stops[static_cast<std::size_t>(release_.closed[static_cast<std::size_t>(a)])].gap;
  const Matrix moved = chart.left.solve_columns(right);
  return {moved.col(0), moved.col(1)};
}

std::optional<ReleaseSection::Equations> ReleaseSection::evaluate(const System& system,
                                                                  const Vector& u,
                                                                  const System* tangent) const {
  const std::optional<Chart> chart = chart_at(system, u);
  if (!chart || !u.allFinite()) return {};
  const Eigen::Index n = system.modes();
  Equations equations{Vector::Zero(size()), Matrix::Zero(size(), size()),
                      tangent ? Vector(Vector::Zero(size())) : Vector(), Matrix(0, 0)};
  const State rate =
      tangent ? chart_rate(*tangent, *chart) : State{Vector::Zero(n), Vector::Zero(n)};
  add_force(system, u, *chart, tangent, rate, equations);
  if (freedoms() > 0 && !add_return(system, u, *chart, tangent, rate, equations)) return {};
  return equations;
}

// By theta, y and y'. A later theta is a later start of the same state, and a later end.
Deviations ReleaseSection::start_deviations(const System& system, const Chart& chart) const {
  const Eigen::Index n = system.modes(), m = freedoms();
  Deviations deviations{Matrix::Zero(n, 2 * m + 1), Matrix::Zero(n, 2 * m + 1),
                        Eigen::RowVectorXd::Zero(2 * m + 1)};
  deviations.delay[0] = 1.0 / system.forcing()->frequency;
  deviations.q.middleCols(1, m) = chart.slope;
  deviations.qdot.rightCols(m) = chart.slope;
  return deviations;
}

// The map and its derivatives; false where the motion cannot be followed.
bool ReleaseSection::add_return(const System& system, const Vector& u, const Chart& chart,
                                const System* tangent, const State& chart_rate,
                                Equations& equations) const {
  const Eigen::Index m = freedoms();
  const MotionState<double> start = *state_of(system, u);
  Deviations deviations = start_deviations(system, chart);
  std::optional<ParameterDeviation> parameter;
  if (tangent) parameter.emplace(system, *tangent, chart_rate);
  const Passage passage =
      pass(system, start, end_of(start), options_, &deviations, parameter ? &*parameter : nullptr);
  if (!passage.failure.empty()) return false;
  std::vector<int> closed;
  for (std::size_t i = 0; i < passage.end.contacts.size(); ++i)
    if (passage.end.contacts[i] == Contact::kClosed) closed.push_back(static_cast<int>(i));
  const State end{passage.end.q, passage.end.qdot};
  const State rate = held_rate(system, closed, end, theta_of(u));
  deviations.q.col(0) += rate.q / system.forcing()->frequency;
  deviations.qdot.col(0) += rate.qdot / system.forcing()->frequency;

  const auto seen = [&](const Matrix& q, const Matrix& qdot) {
    Matrix coordinates(2 * m, q.cols());
    coordinates << basis_.transpose() * q, basis_.transpose() * qdot;
    return Matrix(unit_.cwiseInverse().asDiagonal() * coordinates);
  };
  equations.residual.tail(2 * m) = seen(end.q - start.q, end.qdot - start.qdot);
  const Matrix slope = seen(deviations.q, deviations.qdot);
  equations.map = slope.rightCols(2 * m) * unit_.asDiagonal();
  equations.jacobian.bottomLeftCorner(2 * m, 1) = slope.col(0);
  equations.jacobian.bottomRightCorner(2 * m, 2 * m) =
      equations.map - Matrix::Identity(2 * m, 2 * m);
  if (parameter) {
    const State moved = parameter->value();
    equations.parameter_derivative.tail(2 * m) = seen(moved.q, moved.qdot);
  }
  return true;
}

std::vector<Eigenvalue> ReleaseSection::multipliers(const System& system, const Vector& u) const {
  std::vector<Eigenvalue> list;
  if (freedoms() > 0) {
    const std::optional<Equations> equations = evaluate(system, u);
    if (!equations) return {};
    list = eigenvalues(equations->map);
    if (static_cast<Eigen::Index>(list.size()) != equations->map.rows()) return {};
  }
  list.resize(static_cast<std::size_t>(2 * system.modes()), {Complex(0.0), 0.0});
  return list;
}

std::optional<ReleaseReturn> ReleaseSection::follow(const System& system, const Vector& u,
                                                    bool minima) const {
  const std::optional<MotionState<double>> start = state_of(system, u);
  if (!start) return {};
  ReleaseReturn result;
  PassageOptions options = options_;
  options.minima = minima;
  result.passage = pass(system, *start, end_of(*start), options);
  if (!result.passage.failure.empty()) return {};
  const Instant<double>& end = result.passage.end.instant;
  const std::vector<const PassedHold*> begun = holds_begun(result.passage);
  const Itinerary itinerary = itinerary_of(result.passage, still_speed(system));
  result.itinerary = itinerary.events;
  result.slowest = itinerary.slowest;
  result.shortest_hold = std::numeric_limits<double>::infinity();
  // The release is where the force equation has it, to the accuracy of a solution.
  const double together = kShootingAccuracy * system.period();
  for (const PassedHold* hold : begun) {
    result.holds.push_back(hold->stop);
    double duration = seconds_between(system, hold->from, hold->to);
    const bool at_end = hold->to_end || seconds_between(system, hold->to, end) <= together;
    if (hold->stop == release_.released && at_end) result.returns = true;
    if (hold->to_end)
      for (const PassedHold& rest : result.passage.holds)
        if (rest.from_start && rest.stop == hold->stop)
          duration += seconds_between(system, rest.from, rest.to);
    result.shortest_hold = std::min(result.shortest_hold, duration);
  }
  for (const int i : release_.closed)
    if (i != release_.released &&
        result.passage.end.contacts[static_cast<std::size_t>(i)] != Contact::kClosed)
      result.returns = false;
  return result;
}

std::optional<std::vector<PassageMargin>> ReleaseSection::margins(const System& system,
                                                                  const Vector& u,
                                                                  const System& tangent,
                                                                  const Vector& direction,
                                                                  double parameter_rate) const {
  const std::optional<Chart> chart = chart_at(system, u);
  if (!chart) return {};
  const MotionState<double> start = *state_of(system, u);
  Deviations deviations = start_deviations(system, *chart);
  ParameterDeviation parameter(system, tangent, chart_rate(tangent, *chart));
  PassageOptions options = options_;
  PassageDirection along{direction, parameter_rate, &tangent};
  along.deviations.tail(2 * freedoms()).array() *= unit_.array();
  options.along = along;
  const Passage passage = pass(system, start, end_of(start), options, &deviations, &parameter);
  if (!passage.failure.empty()) return {};
  return margins_of(passage, still_speed(system));
}

std::optional<Orbit> ReleaseSection::orbit(const System& system, const Vector& u) const {
  const std::optional<ReleaseReturn> back = follow(system, u);
  if (!back || !back->returns) return {};
  const std::optional<MotionState<double>> start = state_of(system, u);
  // Half-way back to where the last of the stops closed.
  const Instant<double>& end = back->passage.end.instant;
  double held = release_.period * system.period();
  for (const PassedHold& hold : back->passage.holds) {
    if (hold.from_start) continue;
    const bool lasts = hold.to_end || hold.stop == release_.released;
    if (lasts && std::find(release_.closed.begin(), release_.closed.end(), hold.stop) !=
                     release_.closed.end())
      held = std::min(held, seconds_between(system, hold.from, end));
  }
  Instant<double> middle = end;
  middle.local -= 0.5 * held;
  while (middle.local < 0.0) {
    middle.local += system.period();
    --middle.period;
  }
  const Passage to_middle = pass(system, *start, middle, options_);
  if (!to_middle.failure.empty()) return {};
  return sticking_orbit_through(system, to_middle.end, release_.period, options_).orbit;
}

std::vector<OrbitRelease> releases_of(const System& system, const Orbit& orbit,
                                      const PassageOptions& options) {
  struct Found {
    OrbitRelease release;
    double held = 0.0;  // s
  };
  std::vector<Found> found;
  const MotionState<double>& start = orbit.section->states.front();
  const Passage round =
      pass(system, start, {start.instant.period + orbit.period, start.instant.local}, options);
  for (const PassedHold& hold : round.holds) {
    if (hold.to_end) continue;
    const Passage there = pass(system, start, hold.to, options);
    if (!there.failure.empty()) continue;
    Found one;
    one.release.release.period = orbit.period;
    one.release.release.released = hold.stop;
    for (std::size_t i = 0; i < there.end.contacts.size(); ++i)
      if (static_cast<int>(i) == hold.stop || there.end.contacts[i] == Contact::kClosed)
        one.release.release.closed.push_back(static_cast<int>(i));
    one.release.theta =
        wrapped(system.forcing()->frequency * hold.to.local + system.forcing()->phase);
    one.release.state = {there.end.q, there.end.qdot};
    one.held = seconds_between(system, hold.from, hold.to);
    for (const PassedHold& before : round.holds)
      if (hold.from_start && before.to_end && before.stop == hold.stop)
        one.held += seconds_between(system, before.from, before.to);
    found.push_back(std::move(one));
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    const std::size_t at_a = a.release.release.closed.size(),
                      at_b = b.release.release.closed.size();
    return at_a != at_b ? at_a > at_b : a.held > b.held;
  });
  std::vector<OrbitRelease> releases;
  for (Found& one : found) releases.push_back(std::move(one.release));
  return releases;
}

}  // namespace graze
