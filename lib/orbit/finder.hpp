// Finding the periodic orbits of a scene's system from several independent starts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/orbit/orbit.hpp"

namespace graze {

struct FinderOptions {
  int period = 1;              // p
  std::optional<int> impacts;  // k; nothing: (p, 1) orbits and whatever the simulation settles on
  bool from_closed_form = true;
  bool from_simulation = true;
  bool from_random = true;
  bool keep_virtual = false;  // list inadmissible solutions too
  int random_guesses = 32;    // at most; 128/N where that is less, but at least 4
  std::uint64_t random_seed = 1;
  long long max_impacts = 10'000'000;  // of the simulation
  // Below it the tail of a chatter is summed, m/s; default_closure_speed where absent.
  std::optional<double> closure_speed;
  StopSignal stop;
};

struct StartCount {
  int tried = 0;
  int converged = 0;
};

struct FoundOrbits {
  std::vector<Orbit> orbits;  // by period, impacts, phases; each once, each minimal
  int inadmissible = 0;       // distinct solutions left out because they are no orbits
  StartCount closed_form, simulation, random;
  bool simulated = false;          // whether the simulation was among the starts
  std::vector<std::string> notes;  // sentences: what the simulation does, what did not hold
};

// Finds orbits. Requires forcing and a stop; finding none is an empty list. Without a start there
// is no simulation.
FoundOrbits find_orbits(const System& system, const std::optional<State>& start,
                        const FinderOptions& options);

// A guess at a (p, 1) orbit: at forcing phase theta the motion meets the stop at speed v, otherwise
// as near to the forced response as a static push and a matching velocity allow.
ImpactPoint rough_guess(const System& system, int stop, double theta, double speed);

// Whether two orbits are one: same pattern, phases and speeds within the accuracy of a solution.
// `speed_scale`, m/s: that of the forced motion, from which impact speeds are left over.
bool same_orbit(const Orbit& a, const Orbit& b, double speed_scale);

}  // namespace graze
