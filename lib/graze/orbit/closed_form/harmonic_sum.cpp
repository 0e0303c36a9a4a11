#include "graze/orbit/closed_form/harmonic_sum.hpp"

#include <cmath>
#include <complex>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/motion/detail/clearance.hpp"

namespace graze {

double HarmonicSum::at(double theta) const {
  double sum = mean;
  for (const Term& term : terms) sum += (term.swing * std::polar(1.0, term.order * theta)).real();
  return sum;
}

double HarmonicSum::phase_of_least() const {
  if (is_single()) return -std::arg(-terms.front().swing);
  // The lowest minimum over a period, or where that begins.
  const double start = at(0.0);
  ArcCurve<double> curve(start, std::numeric_limits<double>::epsilon() * std::abs(mean), kTurn);
  for (const Term& term : terms)
    curve.add_exponential({term.swing.real(), term.swing.imag()}, 0.0, term.order, 0.0);
  const std::optional<GapMinimum> lowest = lowest_minimum(curve);
  return lowest && lowest->gap < start ? lowest->s : 0.0;
}

double HarmonicSum::least() const {
  return is_single() ? mean - std::abs(terms.front().swing) : at(phase_of_least());
}

}  // namespace graze
