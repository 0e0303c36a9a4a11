#include "graze/orbit/search/detail/random_start.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include "graze/orbit/closed_form/detail/periodic_response.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

// Twice the scale covers motions that stay within it, and some larger ones.
constexpr double kStartReach = 2.0;

// Moves a state along the direction of a spring's force, to at most the depth of an impact at that
// speed, m/s.
void bring_within_reach(const System& system, double speed, State& state) {
  for (const Stop& stop : system.stops) {
    if (!stop.is_compliant()) continue;
    const double mobility = stop.row.squaredNorm();
    // A stop that preloads the structure penetrates the undeflected one.
    const double deepest =
        std::max(stop.force().depth_storing(0.5 * speed * speed / mobility), -stop.gap);
    const double beyond = stop.row.dot(state.q) - stop.gap - deepest;
    if (beyond > 0.0) state.q -= beyond / mobility * stop.row;
  }
}

}  // namespace

State start_at(const System& system, std::span<const double> coordinates) {
  State state{Vector::Zero(system.modes()), Vector::Zero(system.modes())};
  if (const PeriodicResponseAnswer answer = periodic_response(system, 1); answer.response)
    state = answer.response->forced_state(system.forcing()->phase);
  const double frequency = system.forcing()->frequency, length = motion_scale(system).length;
  for (std::size_t i = 0; i < places_of_starts(system); ++i) {
    const Vector& row = system.row(static_cast<int>(i));
    Vector shape(system.modes());
    // A free mass has no static compliance; the forcing's time scale replaces it.
    for (int j = 0; j < system.modes(); ++j)
      shape[j] = row[j] / std::max(system.omega[j] * system.omega[j], 1e-2 * frequency * frequency);
    shape *= kStartReach * length / row.dot(shape);
    state.q += coordinates[2 * i] * shape;
    state.qdot += coordinates[2 * i + 1] * frequency * shape;
  }
  bring_within_reach(system, kStartReach * motion_scale(system).speed, state);
  bring_clear(system, state);
  return state;
}

State random_start(const System& system, std::uint64_t seed, std::uint64_t draw) {
  // Neighbouring draws begin far apart (the golden ratio's bits).
  std::mt19937_64 engine(seed ^ (0x9E3779B97F4A7C15u * (draw + 1)));
  // Bits are converted to [-1, 1) by hand: the standard leaves the distributions' algorithms open.
  std::vector<double> coordinates(2 * places_of_starts(system));
  for (double& coordinate : coordinates)
    coordinate = static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0;
  return start_at(system, coordinates);
}

bool is_clear(const System& system, const State& state) {
  return std::all_of(system.stops.begin(), system.stops.end(), [&](const Stop& stop) {
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    return stop.is_compliant() || gap.value >= -gap.rounding;
  });
}

bool bring_clear(const System& system, State& state) {
  for (const Stop& stop : system.stops) {
    const GapValue<double> gap = gap_value<double>(stop.row, state.q, stop.gap);
    if (!stop.is_compliant() && gap.value < -gap.rounding) state.q += gap.value * stop.direction();
  }
  return is_clear(system, state);
}

}  // namespace graze
