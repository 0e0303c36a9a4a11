#include "graze/flow/held/detail/series_phase.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "graze/flow/held/detail/contact_share.hpp"
#include "graze/flow/held/detail/flight_search.hpp"
#include "graze/flow/held/detail/held_exactly.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

// With this order a step goes over two to four radians of the quickest mode, and a coefficient
// costs least for each.
constexpr int kPhaseOrder = 24;
// Remainder of the series over a step, relative to the motion: below its rounding.
constexpr double kMotionLeftOut = std::numeric_limits<double>::epsilon() / 4.0;
// How near a zero is approached as a part of a step; after that to the last digit.
constexpr double kPhaseResolved = 1.0 / 1024.0;
// Steps of one flight: longer ones are cut.
constexpr std::size_t kMostSteps = 256;
// With more modes than this the structure is not decomposed even where its modes are real and the
// decomposition would serve for the rest of the motion.
constexpr int kMostDecomposed = 400;

constexpr double kEps = std::numeric_limits<double>::epsilon();

bool is_along_row(const Stop& stop) {
  constexpr double kRoundings = 16.0;
  const Vector normal = stop.row / stop.row.squaredNorm();
  return (stop.direction() - normal).norm() <= kRoundings * kEps * normal.norm();
}

// Derivatives of t^k/u^k.
double factor_of(int k, double unit) {
  double factor = 1.0;
  for (int i = 1; i <= k; ++i) factor *= i / unit;
  return factor;
}

}  // namespace

bool suits_series(const System& system, const std::vector<int>& closed) {
  if (closed.empty() || system.modes() <= kFewModes || !system.has_closed_forms() ||
      !system.frictions.empty())
    return false;
  for (const int i : closed)
    if (!is_along_row(system.stops[static_cast<std::size_t>(i)])) return false;
  return system.modes() > kMostDecomposed || !proportional_damping(system);
}

SeriesPhase::SeriesPhase(const System& system, PhaseKey key)
    : ContactPhase(std::move(key)),
      system_(system),
      modes_(linear_system<double>(system)),
      rows_(system.modes(), static_cast<Eigen::Index>(system.stops.size())),
      gaps_(rows_.cols()),
      held_gaps_(static_cast<Eigen::Index>(closed().size())),
      series_(modes_, rows_of(system, closed()), kPhaseOrder) {
  for (Eigen::Index i = 0; i < rows_.cols(); ++i) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    rows_.col(i) = stop.row;
    gaps_[i] = stop.gap;
  }
  norms_ = rows_.colwise().norm();
  for (std::size_t i = 0; i < closed().size(); ++i)
    held_gaps_[static_cast<Eigen::Index>(i)] = gaps_[closed()[i]];
}

SeriesPhase::~SeriesPhase() = default;

int SeriesPhase::column_of(int stop) const {
  const auto found = std::find(closed().begin(), closed().end(), stop);
  return found == closed().end() ? -1 : static_cast<int>(found - closed().begin());
}

void SeriesPhase::start(const double& theta, const Vector& q, const Vector& qdot,
                        const double& time) {
  ++arc_;
  theta_ = theta;
  time_ = time;
  q_ = q;
  qdot_ = qdot;
  steps_.assign(1, {0.0, q, qdot});
  series_.settle(held_gaps_, steps_.front().q, steps_.front().qdot);
}

const MotionSeries& SeriesPhase::about(const Step& step) const {
  if (known_arc_ != arc_ || known_from_ != step.from) {
    series_.expand(theta_ + modes_.frequency * step.from, step.q, step.qdot);
    known_arc_ = arc_;
    known_from_ = step.from;
  }
  return series_;
}

const SeriesPhase::Step& SeriesPhase::step_at(double s) const {
  const auto behind = std::upper_bound(steps_.begin(), steps_.end(), s,
                                       [](double at, const Step& step) { return at < step.from; });
  return behind == steps_.begin() ? steps_.front() : *std::prev(behind);
}

void SeriesPhase::state(const double& s, Vector& q, Vector& qdot) const {
  Step step = step_at(s);
  for (;;) {
    const MotionSeries& series = about(step);
    const double longest = series.step(kMotionLeftOut) * series.unit();
    const double left = s - step.from;
    series.state(std::min(left, longest) / series.unit(), q, qdot);
    series.settle(held_gaps_, q, qdot);
    if (left <= longest) return;
    step = {step.from + longest, q, qdot};
  }
}

double SeriesPhase::force_at(int stop, const double& s, const Vector& q, const Vector& qdot) const {
  return series_.forces_at(theta_ + modes_.frequency * s, q, qdot)[column_of(stop)];
}

double SeriesPhase::force_rate(int stop) const {
  const MotionSeries& series = about(steps_.front());
  return series.forces()(column_of(stop), 1) / series.unit();
}

// Rounding of a derivative of the gap at the start: an acceleration is a sum of the terms of its
// equation.
double SeriesPhase::gap_noise(int stop, int order) const {
  const auto row = rows_.col(stop).cwiseAbs();
  const Matrix& c = series_.coefficients();
  if (order == 0)
    return static_cast<double>(q_.size() + 2) * kEps *
           (std::abs(gaps_[stop]) + row.dot(c.col(0).cwiseAbs()));
  const double unit = series_.unit();
  if (order == 1) return kSpeedRoundings * kEps * row.dot(c.col(1).cwiseAbs()) / unit;
  Vector size = modes_.omega.cwiseAbs2().cwiseProduct(c.col(order - 2).cwiseAbs()) +
                (order - 1.0) / unit * 2.0 * modes_.delta.cwiseProduct(c.col(order - 1).cwiseAbs());
  if (modes_.load.size() > 0) size += modes_.load.cwiseAbs();
  if (modes_.forced) size += modes_.amplitude.cwiseAbs();
  for (std::size_t i = 0; i < closed().size(); ++i)
    size += std::abs(series_.forces()(static_cast<Eigen::Index>(i), order - 2)) *
            rows_.col(closed()[i]).cwiseAbs();
  return 2.0 * kSpeedRoundings * kEps * row.dot(size) * factor_of(order - 2, unit);
}

CurvePoint<double> SeriesPhase::outlook(int stop, int order, const double& ahead) const {
  const MotionSeries& series = about(steps_.front());
  const double unit = series.unit();
  const int column = column_of(stop);
  CurvePoint<double> point;
  // Bound on the size of derivative k over that time.
  const auto size = [&](int k) {
    double driven = 0.0;
    if (modes_.forced)
      driven = modes_.amplitude.norm() * std::pow(modes_.frequency, k) * std::max(ahead, 0.0);
    return series.size(k) * factor_of(k, unit) + driven;
  };
  if (column >= 0) {
    const auto value = [&](int k) { return series.forces()(column, k) * factor_of(k, unit); };
    const double weight = series.force_weight(column);
    const double pushed = series.force_push(column);
    point.value = value(order);
    point.slope = value(order + 1);
    point.curvature = value(order + 2);
    point.bound = weight * size(order + 2) + pushed * std::pow(modes_.frequency, order + 2);
    point.third = weight * size(order + 3) + pushed * std::pow(modes_.frequency, order + 3);
    point.noise = series.force_noise(column) * factor_of(order, unit);
    return point;
  }
  const auto value = [&](int k) {
    const double own = -rows_.col(stop).dot(series.coefficients().col(k));
    return (k == 0 ? gaps_[stop] + own : own) * factor_of(k, unit);
  };
  point.value = value(order);
  point.slope = value(order + 1);
  point.curvature = value(order + 2);
  point.bound = norms_[stop] * size(order + 1);
  point.third = norms_[stop] * size(order + 2);
  point.noise = gap_noise(stop, order);
  return point;
}

std::optional<SeriesPhase::Met> SeriesPhase::met_by(const Watched& watched, double tau,
                                                    bool first) const {
  const int left = first && !watched.closed ? watched.multiplicity : 0;
  const BoundedSeries watch = watched.closed
                                  ? series_.force(column_of(watched.stop), watch_)
                                  : series_.gap(rows_.col(watched.stop), norms_[watched.stop],
                                                gaps_[watched.stop], left, tau, watch_);
  if (left > 0 && !(watch.coefficients[0] > 0.0)) return Met{0.0, &watched, true};
  SeriesZero zero = first_zero(watch, tau, kPhaseResolved);
  if (zero.clear >= tau) return {};
  if (!zero.crosses) zero = first_zero(watch, tau, kEps);
  if (zero.clear >= tau) return {};
  return Met{zero.crosses ? zero.zero : zero.clear, &watched, false};
}

std::optional<SeriesPhase::Met> SeriesPhase::first_met(const std::vector<Watched>& list,
                                                       double window, const StopSignal& stop,
                                                       std::vector<Step>& steps, double& reached,
                                                       long long& expansions) const {
  reached = 0.0;
  while (reached < window) {
    const Step& step = steps.back();
    const MotionSeries& series = about(step);
    ++expansions;
    const double longest = series.step(kMotionLeftOut) * series.unit();
    double end = std::min(longest, window - step.from);
    for (const Watched& watched : list)
      if (watched.sure > step.from) end = std::min(end, watched.sure - step.from);
    const bool last = end >= window - step.from;
    double tau = end / series.unit();
    std::optional<Met> met;
    for (const Watched& watched : list)
      if (watched.sure > step.from) {
        continue;
      } else if (const std::optional<Met> found = met_by(watched, tau, steps.size() == 1)) {
        met = found;
        tau = found->s;
      }
    if (met) {
      met->s = step.from + met->s * series.unit();
      return met;
    }
    reached = last ? window : step.from + end;
    if (last) break;
    Step next{reached, {}, {}};
    series.state(tau, next.q, next.qdot);
    series.settle(held_gaps_, next.q, next.qdot);
    steps.push_back(std::move(next));
    if (steps.size() > kMostSteps || stop.requested()) break;
  }
  return {};
}

Arrival<double> SeriesPhase::first_event(const MotionState<double>& now,
                                         const Flight<double>& flight) {
  std::vector<Watched> list;
  for (const int i : flight.order) {
    const auto place = static_cast<std::size_t>(i);
    const Contact at = now.contacts[place];
    if (at == Contact::kLocked) continue;
    list.push_back({i, now.multiplicities[place], at == Contact::kClosed, flight.sure_of(i)});
  }
  Arrival<double> arrival;
  steps_.resize(1);
  const std::optional<Met> met =
      first_met(list, flight.horizon, flight.stop, steps_, arrival.flight, arrival.evaluations);
  if (!met) return arrival;
  arrival.flight = met->s;
  arrival.stop = met->watched->stop;
  arrival.kind = met->watched->closed ? ArrivalKind::kRelease
                 : met->touch         ? ArrivalKind::kTouch
                                      : ArrivalKind::kContact;
  return arrival;
}

bool SeriesPhase::stays_quiet(int stop, const double& duration) const {
  std::vector<Step> steps(1, steps_.front());
  double reached = 0.0;
  long long expansions = 0;
  const std::vector<Watched> list(1, {stop, 0, column_of(stop) >= 0});
  return !first_met(list, duration, {}, steps, reached, expansions) && reached >= duration;
}

const ExactPhase<double>* SeriesPhase::exact() const {
  if (!exact_) exact_ = exact_phase(system_, key());
  if (exact_arc_ != arc_) exact_->start(theta_, q_, qdot_, time_);
  exact_arc_ = arc_;
  return exact_.get();
}

std::vector<double> SeriesPhase::step_ends(double until) const {
  std::vector<double> ends;
  for (std::size_t i = 0; i < steps_.size() && steps_[i].from < until; ++i) {
    const Step& step = steps_[i];
    const double to = i + 1 < steps_.size() ? std::min(steps_[i + 1].from, until) : until;
    // The search for an event ended within its last step, so no later instant is asked for.
    const MotionSeries& series = about(step);
    const double pieces =
        std::ceil(2.0 * (to - step.from) / (series.step(kMotionLeftOut) * series.unit()));
    for (double k = 1.0; k < pieces; ++k) ends.push_back(step.from + k / pieces * (to - step.from));
    ends.push_back(to);
  }
  return ends;
}

// Gauss' rule over each step: over some radians of the quickest mode ten nodes leave less than
// rounding of the product of two velocities.
SeriesWork SeriesPhase::work(double s) const {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  SeriesWork work;
  std::array<double, 10> taus{}, weights{};
  for (std::size_t i = 0; i < steps_.size() && steps_[i].from < s; ++i) {
    const Step& step = steps_[i];
    const MotionSeries& series = about(step);
    const double to = i + 1 < steps_.size() ? std::min(steps_[i + 1].from, s) : s;
    const double half = 0.5 * (to - step.from);
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      taus[2 * k] = half * (1.0 - Rule::abscissa()[k]) / series.unit();
      taus[2 * k + 1] = half * (1.0 + Rule::abscissa()[k]) / series.unit();
      weights[2 * k] = weights[2 * k + 1] = half * Rule::weights()[k];
    }
    const Matrix velocities = series.velocities(taus);
    for (std::size_t k = 0; k < taus.size(); ++k) {
      const auto v = velocities.col(static_cast<Eigen::Index>(k));
      work.dissipation += weights[k] * 2.0 * modes_.delta.dot(v.cwiseAbs2());
      if (modes_.forced)
        work.forcing +=
            weights[k] *
            std::cos(theta_ + modes_.frequency * (step.from + taus[k] * series.unit())) *
            modes_.amplitude.dot(v);
    }
  }
  return work;
}

}  // namespace graze
