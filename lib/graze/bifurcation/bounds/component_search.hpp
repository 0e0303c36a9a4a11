// How thoroughly the components of (p, 1) solutions over a range were searched for: what is
// certain, and what may have been missed.
#pragma once

#include <string>

namespace graze {

class ClosedFormSurvey;
struct RunSearch;
struct SpeedSurvey;

struct ComponentSearch {
  // The intervals with solutions, of all stops whose restitution is constant.
  int surveys = 0;            // stops that were surveyed
  int left_out = 0;           // stops whose restitution depends on the speed
  int ranges = 0;             // intervals with solutions
  long long evaluations = 0;  // of the fold function
  int undecided = 0;          // cells that may hold more of them
  double widest = 0.0;        // such cell, in units of the parameter
  int lost = 0;               // starts that Newton's method did not confirm
  // Search for orbits among the solutions, where virtual ones are not wanted: by bounds,
  long long cells = 0;       // looked at
  int undecided_cells = 0;   // left over by the budget
  double widest_cell = 0.0;  // of them, in units of the parameter
  double resolution = 0.0;   // width below which no cell was searched, likewise
  int runs_lost = 0;         // orbits that were seen and could not be traced
  // or by samples.
  int samples = 0;              // values at which solutions were judged
  double sample_spacing = 0.0;  // at most, in units of the parameter
  // For stops whose restitution depends on the speed: values at which every solution is known,
  int solved_values = 0;
  double solved_spacing = 0.0;  // in units of the parameter
  int unsolved = 0;             // and at which some may not be
  // Values at which the finder was run.
  int start_values = 0;
  double start_spacing = 0.0;  // in units of the parameter
  bool stopped = false;        // before its end
  int random_starts = 0;       // quasi-random starts of each of its rounds; 0: none

  void add(const ClosedFormSurvey& survey);
  void add(const RunSearch& search);
  void add(const SpeedSurvey& survey);

  // Whether certainly no interval with solutions was missed,
  bool all_solutions() const {
    return surveys > 0 && left_out == 0 && undecided == 0 && lost == 0 && !stopped;
  }
  // and, where only orbits are wanted, no run of them wider than `resolution`.
  bool complete() const {
    return all_solutions() && undecided_cells == 0 && runs_lost == 0 && samples == 0;
  }
};

// A description in sentences, for (period, 1) solutions over a parameter.
std::string in_words(const ComponentSearch& search, const std::string& parameter, int period);

}  // namespace graze
