#include "graze/flow/stepped/detail/stepped_phase.hpp"

#include <algorithm>
#include <cmath>

#include "graze/flow/stepped/detail/step_methods.hpp"

namespace graze {

void IntegratedPhase::watch(const std::vector<Observable<double>>& observables, Vector scale) {
  scale_ = std::move(scale);
  for (const Observable<double>& observable : observables) {
    Watch watch;
    watch.constant = observable.constant;
    watch.weights.resize(2 * scale_.size());
    watch.weights << observable.displacement.cwiseQuotient(scale_),
        observable.velocity.size() > 0 ? observable.velocity : Vector(Vector::Zero(scale_.size()));
    watch.harmonic_re = observable.harmonic.re;
    watch.harmonic_im = observable.harmonic.im;
    watches_.push_back(std::move(watch));
  }
}

void IntegratedPhase::start_steps(double theta, const Vector& q, const Vector& qdot,
                                  std::span<const double> depths, double time) {
  Vector x(2 * scale_.size());
  x << scale_.cwiseProduct(structure().coordinates(q, theta)),
      structure().rates(qdot, theta);
  steps_->start(theta, x, depths, time);
}

void IntegratedPhase::state(const double& s, Vector& q, Vector& qdot) const {
  Vector x;
  steps_->state(s, x);
  const Eigen::Index n = scale_.size();
  q = structure().displacements(x.head(n).cwiseQuotient(scale_));
  qdot = structure().velocities(x.tail(n));
}

// The stop's watch, with Taylor's coefficient of the zero that it starts from.
const Watch& IntegratedPhase::watch_of(int stop, Contact at, int multiplicity, double sure) {
  Watch& watch = watches_[static_cast<std::size_t>(stop)];
  const bool is_closed = at == Contact::kClosed;
  watch.multiplicity = is_closed || sure > 0.0 ? 0 : multiplicity;
  watch.sure = sure;
  watch.leaving = is_closed && multiplicity > 0       ? Leaving::kAsked
                  : watch.multiplicity == kLeftUntold ? Leaving::kAwaited
                                                      : Leaving::kKnown;
  if (watch.multiplicity == 0 || watch.leaving == Leaving::kAwaited) return watch;
  const double rate =
      multiplicity == 4 ? gap_rate(stop, 3).slope : gap_rate(stop, multiplicity).value;
  watch.departure = rate / std::tgamma(multiplicity + 1.0);
  return watch;
}

// Events are found by the signs at the ends of steps. A rigid stop that the structure cannot leave
// is touched at once.
Arrival<double> IntegratedPhase::first_event(const MotionState<double>& now,
                                             const Flight<double>& flight) {
  if (const std::optional<Arrival<double>> left = left_at_once(now)) return *left;
  std::vector<Watched> list;
  watch_springs(now, flight, list);
  for (const int i : flight.order) {
    const Contact at = now.contacts[static_cast<std::size_t>(i)];
    if (at == Contact::kLocked || at == Contact::kCompressed || at == Contact::kParted) continue;
    const Watch& watch =
        watch_of(i, at, now.multiplicities[static_cast<std::size_t>(i)], flight.sure_of(i));
    if (watch.multiplicity > 0 && watch.leaving == Leaving::kKnown && !(watch.departure > 0.0))
      return {ArrivalKind::kTouch, i};
    list.push_back(
        {i, &watch, at == Contact::kClosed ? ArrivalKind::kRelease : ArrivalKind::kContact});
  }
  watch_joint(now, list);
  std::vector<const Watch*> watches;
  for (const Watched& watched : list) watches.push_back(watched.watch);
  const StepDescent found =
      steps_->first_descent(watches, std::min(flight.horizon, longest_flight()), flight.until,
                            flight.stop, flight.told_depth);
  Arrival<double> arrival;
  arrival.evaluations = found.values;
  arrival.lowest = found.lowest;
  arrival.flight = found.s;
  if (!found.finite) arrival.kind = ArrivalKind::kNotFinite;
  if (found.stopped) {
    arrival.kind = ArrivalKind::kUndecided;
    arrival.flight = 0.0;
    arrival.stop = list.empty() ? -1 : list.front().stop;
    return arrival;
  }
  if (found.watch < 0 || !found.finite) return arrival;
  const Watched& met = list[static_cast<std::size_t>(found.watch)];
  arrival.stop = met.stop;
  arrival.kind = met.kind;
  arrival.below = met.below;
  if (!found.errors.empty() && met.watch->leaving != Leaving::kKnown) tell(list, found, arrival);
  arrival.forward = met.watch->factor < 0.0;
  return arrival;
}

// A watch whose sign was asked for has that sign since the start.
void IntegratedPhase::tell(const std::vector<Watched>& list, const StepDescent& found,
                           Arrival<double>& arrival) {
  const Watch& watch = *list[static_cast<std::size_t>(found.watch)].watch;
  arrival.flight = 0.0;
  arrival.kind = ArrivalKind::kTouch;
  if (watch.leaving == Leaving::kAwaited) return;
  arrival.sure = found.s;
  if (watch.of_spring == SpringWatch::kRest) {
    if (found.beyond) arrival.kind = ArrivalKind::kEntry;
    return;
  }
  arrival.told = true;
  force_errors_.assign(watches_.size(), 0.0);
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].kind == ArrivalKind::kRelease)
      force_errors_[static_cast<std::size_t>(list[i].stop)] = found.errors[i];
}

namespace {

// A soft mode moves at the frequency of the forcing.
Vector modal_scale(const LinearSystem<double>& modes) {
  const double slowest = std::max(modes.frequency, 1e-3 * modes.omega.norm());
  return modes.omega.cwiseMax(slowest > 0.0 ? slowest : 1.0);
}

ModalRates modal_rates(const LinearSystem<double>& modes, const Vector& scale) {
  const auto or_zero = [&](const Vector& list) {
    return list.size() > 0 ? list : Vector(Vector::Zero(modes.omega.size()));
  };
  return {scale,
          modes.omega.cwiseAbs2().cwiseQuotient(scale),
          2.0 * modes.delta,
          or_zero(modes.load),
          or_zero(modes.amplitude),
          modes.frequency};
}

}  // namespace

SteppedPhase::SteppedPhase(std::unique_ptr<ExactPhase<double>> exact, const StepSetting& setting)
    : IntegratedPhase(exact->key()), exact_(std::move(exact)) {
  if (const CoupledArc* coupled = exact_->coupled_arc()) {
    watch(exact_->observables(), coupled->flow().scale());
    step_by(step_flow(coupled->flow().first_order(), setting));
    return;
  }
  const LinearSystem<double>& modes = exact_->structure().reduced;
  const Vector scale = modal_scale(modes);
  watch(exact_->observables(), scale);
  step_by(step_flow(modal_rates(modes, scale), setting));
}

void SteppedPhase::start(const double& theta, const Vector& q, const Vector& qdot,
                         const double& /*time*/) {
  start_steps(theta, q, qdot);
  exact_->start(theta, q, qdot);
}

double SteppedPhase::longest_flight() const {
  const CoupledArc* coupled = exact_->coupled_arc();
  return coupled ? coupled->flow().longest_flight() : ContactPhase::longest_flight();
}

}  // namespace graze
