#include "graze/motion/detail/arc_extent.hpp"

#include <algorithm>

#include "graze/motion/detail/clearance.hpp"

namespace graze {
namespace {

Observable<double> negative(Observable<double> observable) {
  observable.constant = -observable.constant;
  observable.displacement = -observable.displacement;
  observable.velocity = -observable.velocity;
  observable.harmonic = {-observable.harmonic.re, -observable.harmonic.im};
  return observable;
}

}  // namespace

Observable<double> displacement_of(const ConstrainedStructure<double>& structure,
                                   const MeasuredRow& seen) {
  if (structure.is_free()) return {0.0, seen.row, {}, {}};
  Observable<double> of{seen.row.dot(structure.rest), structure.basis.transpose() * seen.row, {}, {}};
  if (seen.carried.empty()) return of;
  of.velocity = Vector::Zero(of.displacement.size());
  for (const MeasuredRow::Harmonic& one : seen.carried) {
    const std::size_t k = structure.harmonic_of(one.order);
    of.displacement[structure.drive(k)] += one.cosine / structure.units[k];
    of.velocity[structure.drive(k)] -= one.sine / structure.rate_unit(k);
  }
  return of;
}

Observable<double> velocity_of(const ConstrainedStructure<double>& structure,
                               const MeasuredRow& seen) {
  const Vector on = structure.seen(seen.row);
  Observable<double> of{0.0, Vector::Zero(on.size()), on, {}};
  for (const MeasuredRow::Harmonic& one : seen.carried) {
    const std::size_t k = structure.harmonic_of(one.order);
    const Eigen::Index at = structure.drive(k);
    of.velocity[at] += one.cosine / structure.units[k];
    of.displacement[at] += one.sine * structure.reduced.omega[at] / structure.units[k];
  }
  return of;
}

double lowest_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                    double from, double to, double below) {
  const ArcCurve<double> curve = phase.curve(observable, to);
  double lowest = std::min({below, curve.at(from, 0).value, curve.at(to, 0).value});
  if (from == 0.0) {
    const std::optional<GapMinimum> minimum = lowest_minimum(curve, 0, lowest);
    return minimum ? std::min(minimum->gap, lowest) : lowest;
  }
  for (const GapMinimum& minimum : minima_below(curve, 0, lowest))
    if (minimum.s > from) lowest = std::min(lowest, minimum.gap);
  return lowest;
}

double highest_along(const ExactPhase<double>& phase, const Observable<double>& observable,
                     double from, double to, double above) {
  return -lowest_along(phase, negative(observable), from, to, -above);
}

}  // namespace graze
