#include "graze/orbit/search/detail/phase_deflation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// Range of the deflation of a known point, rad. With one impact and gap 0, the residual is a sine
// about a solution, chord times cos(x/2), and the product (chord + eta^2/chord) cos(x/2) falls all
// the way to the other solution, pi away, when eta is at least the longest chord, 2. With a shorter
// range a valley is left around the known point, and a descent ends there.
constexpr double kDeflationReach = 2.0;

double chord(double difference, double turns) {
  return 2.0 * turns * std::sin(difference / (2.0 * turns));
}

// Half the derivative of the squared chord.
double half_slope(double difference, double turns) { return turns * std::sin(difference / turns); }

}  // namespace

Vector PhaseDeflation::place(const Vector& phases) const {
  const double turns = pattern_.period;
  Vector where(2 * phases.size());
  where.head(2) << std::cos(phases[0]), std::sin(phases[0]);
  for (Eigen::Index i = 1; i < phases.size(); ++i) {
    const double angle = (phases[i] - phases[0]) / turns;
    where.segment(2 * i, 2) << turns * std::cos(angle), turns * std::sin(angle);
  }
  return where;
}

Vector PhaseDeflation::pull_back(const Vector& where, const Vector& along) const {
  const double turns = pattern_.period;
  Vector gradient(where.size() / 2);
  gradient[0] = along[1] * where[0] - along[0] * where[1];
  for (Eigen::Index i = 1; i < gradient.size(); ++i) {
    gradient[i] = (along[2 * i + 1] * where[2 * i] - along[2 * i] * where[2 * i + 1]) / turns;
    gradient[0] -= gradient[i];
  }
  return gradient;
}

void PhaseDeflation::add(const std::vector<int>& stops, const Vector& phases) {
  const std::size_t k = stops.size();
  for (std::size_t first = 0; first < k; ++first) {
    bool fits = true;
    for (std::size_t i = 0; i < k && fits; ++i) fits = stops[(first + i) % k] == pattern_.stops[i];
    if (!fits) continue;
    Vector image(static_cast<Eigen::Index>(k));
    for (std::size_t i = 0; i < k; ++i)
      image[static_cast<Eigen::Index>(i)] = phases[static_cast<Eigen::Index>((first + i) % k)];
    points_.push_back(place(image));
  }
}

double PhaseDeflation::factor(const Vector& phases, Vector* gradient) const {
  const Eigen::Index k = phases.size();
  const double turns = pattern_.period;
  const Vector here = place(phases);
  double sum = 1.0;
  Vector along = Vector::Zero(2 * k);
  for (const Vector& point : points_) {
    const double distance = (here - point).squaredNorm();
    const double part = kDeflationReach * kDeflationReach / distance;
    sum += part;
    if (gradient) along -= 2.0 * part / distance * (here - point);
  }
  if (gradient) *gradient = pull_back(here, along);
  for (Eigen::Index i = 0; i < k; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      if (pattern_.stops[static_cast<std::size_t>(i)] !=
          pattern_.stops[static_cast<std::size_t>(j)])
        continue;
      const double difference = phases[i] - phases[j];
      const double distance = chord(difference, turns) * chord(difference, turns);
      const double part = kDeflationReach * kDeflationReach / distance;
      sum += part;
      if (!gradient) continue;
      const double slope = 2.0 * part / distance * half_slope(difference, turns);
      (*gradient)[i] -= slope;
      (*gradient)[j] += slope;
    }
  return sum;
}

bool PhaseDeflation::knows(const Vector& phases, double distance) const {
  // The first phase, and the difference of two for each other.
  const double most = distance * std::sqrt(4.0 * static_cast<double>(phases.size()) - 3.0);
  const Vector here = place(phases);
  return std::any_of(points_.begin(), points_.end(),
                     [&](const Vector& point) { return (here - point).norm() <= most; });
}

double PhaseDeflation::nearest_pair(const Vector& phases) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < phases.size(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (pattern_.stops[static_cast<std::size_t>(i)] ==
          pattern_.stops[static_cast<std::size_t>(j)])
        nearest = std::min(nearest, std::abs(chord(phases[i] - phases[j], pattern_.period)));
  return nearest;
}

}  // namespace graze
