// Private to this room. Orbits and motions as a page shows them: courses at the stops, impacts,
// stuck phases, multipliers, and the command that makes them again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/report/json_page.hpp"
#include "graze/study/sweep.hpp"

namespace graze {

// What the orbits of a page have in common.
struct PageSource {
  const RunInfo& info;
  std::string parameter;                // that the run was over; empty: none
  std::optional<double> closure_speed;  // where the user gave one, m/s
  int most_samples = 1024;              // of an orbit's curve
};

// Samples of a curve over so many periods, so that the fastest mode is seen; at most `most`, but
// some in every period.
int page_samples(const System& system, long long periods, int most);

// An orbit of `system`, which is the one at `value` of the parameter.
Json page_orbit(const PageSource& source, const System& system, const Orbit& orbit,
                std::optional<double> value);

// What a row of a sweep does, in the system at its value: the orbit that it settled on, else the
// motion from where the row's samples begin.
Json page_motion(const PageSource& source, const System& system, const SweepRow& row);

// Which of `count` orbits a page keeps, so that files stay small: every n-th, the first and the
// last among them, at most `most`.
std::vector<std::size_t> kept_of(std::size_t count, std::size_t most);

}  // namespace graze
