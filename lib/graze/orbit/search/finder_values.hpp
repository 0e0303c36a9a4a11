// Options and results of a search for orbits (finder.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

// Quasi-random starts of each round of a search for orbits of one impact.
inline constexpr int kStartsOfOneImpact = 16;

struct FinderOptions {
  int period = 1;  // p
  // k, on every sequence of stops of that length (each class of rotations once). nullopt: k = 1,
  // then 2 and 3 while the structure is small (finder.cpp, kCheapWork), and whatever the simulation
  // settles on.
  std::optional<int> impacts;
  // Whether p was asked for: then no orbit of another period is listed, even if the simulation
  // settles on it; a note names it.
  bool only_this_period = false;
  bool from_closed_form = true;
  bool from_simulation = true;
  bool from_random = true;
  bool keep_virtual = false;  // list inadmissible solutions too
  // Largest number of rough guesses at a pattern, where they are needed; 128/(N k) where that is
  // less, but at least 4.
  int random_guesses = 32;
  std::uint64_t random_seed = 1;
  long long max_impacts = kDefaultImpactBudget;  // of the simulation
  int threads = 0;                               // 0: as many as there are cores; changes no result
  // Speed below which the tail of a chatter is summed, m/s; default_closure_speed where absent.
  std::optional<double> closure_speed;
  StopSignal stop;
  // With compliant and rigid stops: list also orbits that stick on the latter, whatever their
  // number of impacts.
  bool sticking = false;

  // Whether an orbit that the simulation settles on, with this period and number of impacts, is one
  // of those asked for.
  bool asks_for(int its_period, std::size_t its_impacts) const {
    if (!impacts) return !only_this_period || its_period == period;
    return its_period == period && its_impacts == static_cast<std::size_t>(*impacts);
  }
};

struct StartCount {
  int tried = 0;
  int converged = 0;
};

struct FoundOrbits {
  std::vector<Orbit> orbits;  // in the order of comes_before; each once, each minimal
  int inadmissible = 0;       // distinct solutions left out because they are no orbits
  StartCount closed_form, two_impacts, simulation, random, global;
  int patterns = 0;                  // patterns searched at random
  int pairs = 0;                     // pairs of stops whose two impacts have a closed form
  bool simulated = false;            // whether the simulation was among the starts
  std::vector<std::string> notes;    // sentences: what the simulation does, what did not hold
  std::vector<std::string> details;  // sentences about the numerics, for experts
  std::string tried;                 // what was done, for a search that found nothing
};

}  // namespace graze
