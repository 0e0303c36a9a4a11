// Private to this room. Orbits and motions as a page shows them: curves at the stops, impacts,
// stuck phases, multipliers, and the command that computes them again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/report/json/detail/json_page.hpp"
#include "graze/study/sweep/sweep.hpp"

namespace graze {

// Data shared by the orbits of a page.
struct PageSource {
  const RunInfo& info;
  std::string parameter;                // that the run was over; empty: none
  std::optional<double> closure_speed;  // where the user gave one, m/s
  int most_samples = 1024;              // of an orbit's curve
  StopSignal stop{};                    // of what is followed for the page
};

// Number of samples of a curve over `periods`, enough to resolve the fastest mode; at most `most`,
// but some in every period.
int page_samples(const System& system, long long periods, int most);

// An orbit of `system`, which is the one at `value` of the parameter.
Json page_orbit(const PageSource& source, const System& system, const Orbit& orbit,
                std::optional<double> value);

// A settled motion, from the start of a forcing period on.
struct PageMotion {
  AttractorClass attractor;
  State start;
  std::optional<double> value;        // of the parameter
  std::vector<std::string> settings;  // "name=value" of what differs from the scene of the run
  std::string settled_in;             // "sweep", "map"
};
PageMotion page_motion_of(const PageSource& source, const SweepRow& row);

// For a motion of `system`: the orbit that it settled on, else the motion itself. Null where it was
// stopped.
Json page_motion(const PageSource& source, const System& system, const PageMotion& motion);

// Indices of the orbits out of `count` that a page keeps, so that files stay small: every n-th, the
// first and the last included, at most `most`.
std::vector<std::size_t> kept_of(std::size_t count, std::size_t most);

}  // namespace graze
