#include "graze/scene/ground_motion.hpp"

#include <Eigen/SparseCholesky>
#include <cstddef>

#include "graze/base/vector.hpp"

namespace graze {

// Continuous slopes: with h the distances and a the accelerations,
//
//   h_k a_(k-1) + 2 (h_k + h_(k+1)) a_k + h_(k+1) a_(k+1) = 6 (slope_(k+1) - slope_k),
//
// a symmetric matrix whose diagonal prevails.
std::vector<double> spline_accelerations(const std::vector<double>& times,
                                         const std::vector<double>& values, bool repeats) {
  const auto lines = static_cast<Eigen::Index>(times.size()) - 1;
  // The unknown of an instant: of one that repeats the last is the first; else both ends have none.
  const Eigen::Index count = repeats ? lines : lines - 1;
  const auto unknown = [&](Eigen::Index k) { return repeats ? k % lines : k - 1; };
  const auto exists = [&](Eigen::Index k) { return repeats || (k > 0 && k < lines); };
  std::vector<double> accelerations(times.size(), 0.0);
  if (count < 1) return accelerations;
  std::vector<Eigen::Triplet<double>> entries;
  Vector jumps = Vector::Zero(count);
  for (Eigen::Index k = 0; k < lines; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double length = times[at + 1] - times[at];
    const double slope = (values[at + 1] - values[at]) / length;
    for (const Eigen::Index end : {k, k + 1}) {
      if (!exists(end)) continue;
      entries.emplace_back(unknown(end), unknown(end), 2.0 * length);
      jumps[unknown(end)] += end == k ? 6.0 * slope : -6.0 * slope;
      const Eigen::Index other = end == k ? k + 1 : k;
      if (exists(other)) entries.emplace_back(unknown(end), unknown(other), length);
    }
  }
  Eigen::SparseMatrix<double> lengths(count, count);
  lengths.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(lengths);
  const Vector solved = factors.solve(jumps);
  for (Eigen::Index k = 0; k <= lines; ++k)
    if (exists(k)) accelerations[static_cast<std::size_t>(k)] = solved[unknown(k)];
  return accelerations;
}

Drift drift_of(const TimeCourse& acceleration) {
  Drift drift{0.0, 0.0};
  for (std::size_t k = 1; k < acceleration.times.size(); ++k) {
    const double h = acceleration.times[k] - acceleration.times[k - 1];
    const double from = acceleration.values[k - 1], to = acceleration.values[k];
    drift.displacement += h * (drift.velocity + h * (2.0 * from + to) / 6.0);
    drift.velocity += 0.5 * h * (from + to);
  }
  return drift;
}

}  // namespace graze
