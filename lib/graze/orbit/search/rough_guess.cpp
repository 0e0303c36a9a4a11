#include "graze/orbit/search/detail/rough_guess.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "graze/flow/exact/detail/exact_flow.hpp"
#include "graze/orbit/search/detail/phase_search.hpp"

namespace graze {

ImpactPoint rough_guess(const System& system, int stop_index, double theta, double speed) {
  const Stop& stop = system.stops[static_cast<std::size_t>(stop_index)];
  const ExactFlow<double> flow(system);
  const Eigen::Index n = system.modes();
  const double frequency = flow.frequency();
  Vector q(n), qdot(n), push(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    q[j] = mode.forced.re * std::cos(theta) - mode.forced.im * std::sin(theta);
    qdot[j] = -frequency * (mode.forced.re * std::sin(theta) + mode.forced.im * std::cos(theta));
    // A free mass has no static compliance; the forcing's time scale replaces it.
    push[j] = stop.row[j] / std::max(mode.omega * mode.omega, 1e-2 * frequency * frequency);
  }
  push /= stop.row.dot(push);
  q += (stop.gap - stop.row.dot(q)) * push;
  qdot += (speed - stop.row.dot(qdot)) * push;
  return {theta, {q, qdot}};
}

std::vector<std::vector<ImpactPoint>> rough_guesses(const System& system,
                                                    const ImpactPattern& pattern, int count,
                                                    double speed, std::uint64_t seed) {
  PhaseStarts starts(pattern.period, pattern.impacts(), seed);
  std::mt19937_64 engine(seed);
  // Bits are converted to [0, 1) by hand: the standard leaves the distributions' algorithms open.
  const auto uniform = [&engine] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<std::vector<ImpactPoint>> guesses(static_cast<std::size_t>(count));
  for (std::vector<ImpactPoint>& points : guesses) {
    const Vector phases = starts.next();
    for (Eigen::Index i = 0; i < phases.size(); ++i)
      points.push_back(rough_guess(system, pattern.stops[static_cast<std::size_t>(i)], phases[i],
                                   2.0 * uniform() * speed));
  }
  return guesses;
}

}  // namespace graze
