#include "graze/flow/held/detail/flight_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/stop_scope.hpp"
#include "graze/flow/exact/detail/first_zero.hpp"

namespace graze {
namespace {

// Order of the series, for steps of some three radians of the fastest mode.
constexpr int kSearchOrder = 16;
// Remainder that the series may have over a step, relative to the size of the motion: small enough
// for the final search to start within its ball.
constexpr double kGapLeftOut = 1e-5;
// When no stop is near for this long, in 1/rad of the fastest mode, no series is formed.
constexpr double kLeap = 4.0;
// How near the zero is approached before the final search, as a part of a step.
constexpr double kSearchResolved = 1.0 / 1024.0;

}  // namespace

FlightSearch::FlightSearch(const System& system, const LinearSystem<double>& modes)
    : series_(modes, Matrix(modes.omega.size(), 0), kSearchOrder),
      omega_(modes.omega),
      frequency_(modes.frequency),
      rows_(modes.omega.size(), static_cast<Eigen::Index>(system.stops.size())),
      gaps_(rows_.cols()) {
  for (Eigen::Index i = 0; i < rows_.cols(); ++i) {
    const Stop& stop = system.stops[static_cast<std::size_t>(i)];
    rows_.col(i) = stop.row;
    gaps_[i] = stop.gap;
  }
  norms_ = rows_.colwise().norm();
  if (modes.forced) push_ += modes.amplitude.norm();
  if (modes.load.size() > 0) push_ += modes.load.norm();
}

// Until when a gap cannot be crossed: |b| (v t + f t^2/2) <= gap, since sqrt(2 E) grows by at most
// |f| per second.
double FlightSearch::reached(double from, double gap, double norm, double speed) const {
  if (!(gap > 0.0)) return from;
  const double way = gap / norm;  // of the modal coordinates
  if (push_ == 0.0) return from + way / speed;
  return from + 2.0 * way / (speed + std::sqrt(speed * speed + 2.0 * push_ * way));
}

// The gap less its rounding error.
double FlightSearch::gap(int stop) const {
  const double rounding = static_cast<double>(q_.size() + 2) *
                          std::numeric_limits<double>::epsilon() *
                          (std::abs(gaps_[stop]) + norms_[stop] * q_.norm());
  return gaps_[stop] - rows_.col(stop).dot(q_) - rounding;
}

void FlightSearch::look(Watched& watched, double from, double step) {
  const double tau = step / series_.unit();
  const BoundedSeries gap =
      series_.gap(rows_.col(watched.stop), norms_[watched.stop], gaps_[watched.stop],
                  from == 0.0 ? watched.multiplicity : 0, tau, coefficients_);
  const SeriesZero zero = first_zero(gap, tau, kSearchResolved);
  watched.clear =
      std::max(watched.clear, zero.clear >= tau ? from + step : from + zero.clear * series_.unit());
}

void FlightSearch::decide(const GapCurves& curves, Watched& watched, double until,
                          const Flight<double>& flight, Arrival<double>& arrival) const {
  const ArcCurve<double>& curve = curves(watched.stop, until, watched.multiplicity > 0);
  const FirstZero<double> zero =
      watched.clear > 0.0 ? first_descent([&](double s) { return curve.at(s, 0, Reach::kStep); },
                                          watched.clear, until, flight.stop)
                          : first_contact(curve, watched.multiplicity, 0.0, flight.stop);
  arrival.evaluations += zero.evaluations;
  watched.clear = until;
  if (zero.kind == ZeroKind::kNone) return;
  arrival.stop = watched.stop;
  arrival.flight = zero.s;
  arrival.kind = zero.kind == ZeroKind::kBudget      ? ArrivalKind::kUndecided
                 : zero.kind == ZeroKind::kNotFinite ? ArrivalKind::kNotFinite
                 : zero.kind == ZeroKind::kBlocked   ? ArrivalKind::kTouch
                                                     : ArrivalKind::kContact;
}

Arrival<double> FlightSearch::first_event(const GapCurves& curves, const Arc<double>& arc,
                                          const MotionState<double>& now,
                                          const Flight<double>& flight) {
  Arrival<double> arrival;
  arrival.flight = flight.horizon;
  watched_.clear();
  for (const int i : flight.order) {
    const auto place = static_cast<std::size_t>(i);
    if (now.contacts[place] == Contact::kLocked) continue;
    watched_.push_back({i, now.multiplicities[place], flight.sure_of(i)});
  }
  q_ = arc.start_displacements();
  qdot_ = arc.start_velocities();
  double from = 0.0;
  for (long long steps = 1;; ++steps) {
    const double ahead = bridged(from);
    if (ahead >= arrival.flight) return arrival;
    if (ahead > from + kLeap * series_.unit()) {
      from = ahead;
    } else {
      step(curves, arc, from, flight, arrival);
      if (arrival.stop >= 0 || from >= arrival.flight) return arrival;
    }
    if (StopScope::is_over() || (steps % kEvaluationsPerLook == 0 && flight.stop.requested()))
      return {ArrivalKind::kUndecided, watched_.front().stop, from, 0.0, arrival.evaluations};
    arc.state(from, q_, qdot_);
  }
}

// Until when none of the gaps can be crossed at the largest possible speed.
double FlightSearch::bridged(double from) {
  const double speed = std::hypot(qdot_.norm(), omega_.cwiseProduct(q_).norm());
  double soonest = std::numeric_limits<double>::infinity();
  for (Watched& watched : watched_) {
    if (from == 0.0 && watched.multiplicity > 0) return from;
    if (watched.clear <= from)
      watched.clear = reached(from, gap(watched.stop), norms_[watched.stop], speed);
    soonest = std::min(soonest, watched.clear);
  }
  return soonest;
}

// One step of the series, or up to the first contact within it.
void FlightSearch::step(const GapCurves& curves, const Arc<double>& arc, double& from,
                        const Flight<double>& flight, Arrival<double>& arrival) {
  series_.expand(arc.start_phase() + frequency_ * from, q_, qdot_);
  ++arrival.evaluations;
  const double step = std::min(series_.step(kGapLeftOut) * series_.unit(), arrival.flight - from);
  const double until = from + step;
  for (Watched& watched : watched_)
    if (watched.clear < until) look(watched, from, step);
  // The nearest stop first: its contact ends the search at the others.
  std::sort(watched_.begin(), watched_.end(),
            [](const Watched& a, const Watched& b) { return a.clear < b.clear; });
  for (Watched& watched : watched_) {
    const double end = std::min(until, arrival.flight);
    if (watched.clear >= end) break;
    decide(curves, watched, end, flight, arrival);
    if (arrival.kind == ArrivalKind::kNotFinite) return;
  }
  from = until;
}

}  // namespace graze
