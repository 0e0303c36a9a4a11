#include "graze/system/measured_row.hpp"

#include <cmath>

namespace graze {

double MeasuredRow::carried_at(double theta) const {
  double sum = 0.0;
  for (const Harmonic& one : carried)
    sum += one.cosine * std::cos(one.order * theta) + one.sine * std::sin(one.order * theta);
  return sum;
}

double MeasuredRow::carried_rate(double theta) const {
  double sum = 0.0;
  for (const Harmonic& one : carried)
    sum += one.order * frequency *
           (one.sine * std::cos(one.order * theta) - one.cosine * std::sin(one.order * theta));
  return sum;
}

MeasuredRow measured_row(const System& system, const Vector& row, bool of_velocity) {
  MeasuredRow seen{row, of_velocity, {}, 0.0};
  if (!system.carried()) return seen;
  seen.frequency = system.forcing()->frequency;
  for (const Harmonic& one : *system.carried())
    seen.carried.push_back({one.order, row.dot(one.cosine), row.dot(one.sine)});
  return seen;
}

}  // namespace graze
