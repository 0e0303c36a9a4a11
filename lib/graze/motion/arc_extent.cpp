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
                                   const Vector& row) {
  if (structure.is_free()) return {0.0, row, {}, {}};
  return {row.dot(structure.rest), structure.basis.transpose() * row, {}, {}};
}

Observable<double> velocity_of(const ConstrainedStructure<double>& structure, const Vector& row) {
  const Vector on = structure.is_free() ? row : Vector(structure.basis.transpose() * row);
  return {0.0, Vector::Zero(on.size()), on, {}};
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
