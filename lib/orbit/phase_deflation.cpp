#include "graze/orbit/phase_deflation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// How far a known point reaches, rad. With one impact and gap 0, the residual is a sine about a
// solution, chord times cos(x/2), and the product (chord + eta^2/chord) cos(x/2) falls all the way
// to the other solution, half a turn away, when eta is no less than the longest chord, 2. With a
// shorter reach a valley is left around the known point, and a descent ends there.
constexpr double kReach = 2.0;

double chord(double difference, double turns) {
  return 2.0 * turns * std::sin(difference / (2.0 * turns));
}

// Half the derivative of its square.
double half_slope(double difference, double turns) { return turns * std::sin(difference / turns); }

}  // namespace

void PhaseDeflation::add(const std::vector<int>& stops, const Vector& phases) {
  const std::size_t k = stops.size();
  for (std::size_t first = 0; first < k; ++first) {
    bool fits = true;
    for (std::size_t i = 0; i < k && fits; ++i) fits = stops[(first + i) % k] == pattern_.stops[i];
    if (!fits) continue;
    Vector image(static_cast<Eigen::Index>(k));
    for (std::size_t i = 0; i < k; ++i)
      image[static_cast<Eigen::Index>(i)] = phases[static_cast<Eigen::Index>((first + i) % k)];
    points_.push_back(image);
  }
}

double PhaseDeflation::factor(const Vector& phases, Vector* gradient) const {
  const Eigen::Index k = phases.size();
  const double turns = pattern_.period;
  double sum = 1.0;
  if (gradient) gradient->setZero(k);
  for (const Vector& point : points_) {
    const Vector from = phases - point;
    double distance = chord(from[0], 1.0) * chord(from[0], 1.0);
    for (Eigen::Index i = 1; i < k; ++i)
      distance += chord(from[i] - from[0], turns) * chord(from[i] - from[0], turns);
    const double part = kReach * kReach / distance;
    sum += part;
    if (!gradient) continue;
    (*gradient)[0] -= 2.0 * part / distance * half_slope(from[0], 1.0);
    for (Eigen::Index i = 1; i < k; ++i) {
      const double slope = 2.0 * part / distance * half_slope(from[i] - from[0], turns);
      (*gradient)[i] -= slope;
      (*gradient)[0] += slope;
    }
  }
  for (Eigen::Index i = 0; i < k; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      if (pattern_.stops[static_cast<std::size_t>(i)] !=
          pattern_.stops[static_cast<std::size_t>(j)])
        continue;
      const double difference = phases[i] - phases[j];
      const double distance = chord(difference, turns) * chord(difference, turns);
      const double part = kReach * kReach / distance;
      sum += part;
      if (!gradient) continue;
      const double slope = 2.0 * part / distance * half_slope(difference, turns);
      (*gradient)[i] -= slope;
      (*gradient)[j] += slope;
    }
  return sum;
}

bool PhaseDeflation::knows(const Vector& phases, double distance) const {
  const double turns = pattern_.period;
  return std::any_of(points_.begin(), points_.end(), [&](const Vector& point) {
    const Vector from = phases - point;
    if (!(std::abs(chord(from[0], 1.0)) <= distance)) return false;
    for (Eigen::Index i = 1; i < from.size(); ++i)
      if (!(std::abs(chord(from[i] - from[0], turns)) <= 2.0 * distance)) return false;
    return true;
  });
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
