// What the motion settles on over a plane of two numbers of a scene: two parameters, or two
// coordinates of its start, whose map shows the basins of attraction.
//
// Every cell is a run of its own from the scene's start, followed until it has settled (settle()),
// so that the map depends on its values alone, however many threads share the work. Motions are
// distinguished by (p, k) and whether they stick; where both numbers are coordinates of the start,
// repeating motions of the same system also by their states.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/study/plane/plane.hpp"
#include "graze/study/sweep/settled_row.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

struct MapCell {
  bool is_known = false;  // false: it was not run
  AttractorClass attractor;
  int place = -1;  // index of AttractorMap::attractors; -1: it has none
  // Impacts per forcing period; nullopt when the motion comes to rest, since the number of impacts
  // of a chatter depends on the speed at which it is summed.
  std::optional<double> impacts_per_period;
  double peak_speed = 0.0;                 // of its impacts, m/s; 0 where it has none
  double stuck_part = 0.0;                 // of the time, on any stop
  std::optional<double> exponent;          // the largest, 1/s; minus infinity where all are lost
  std::optional<Amplitudes> amplitudes{};  // if requested
  std::string message;                     // a sentence, or empty
};

// A cell with the states at the starts of its periods where motions are distinguished by them; only
// the first of these where the cell's motion is kept to be shown.
struct SettledCell {
  MapCell cell;
  std::vector<State> period_states;
};

// Periods, impacts and exponents are those of a cell; shares are of the cells, pieces are named
// "cell i".
struct AttractorMapOptions : RowOptions, Plane, SharedWork<SettledCell> {};

struct MapAttractor {
  AttractorClass attractor;
  std::size_t first = 0, cells = 0;  // the first cell, and how many
  std::vector<State> period_states;  // at the starts of its periods, in that cell; if compared
};

// The motion of a cell once it has settled, from the start of a forcing period.
struct CellMotion {
  std::size_t cell = 0;
  State start;
};

struct AttractorMap {
  static constexpr std::size_t kMostMotions = 400;  // kept of a map of parameters

  AttractorMapOptions options;
  bool is_of_starts = false;   // both numbers are coordinates of the start
  std::vector<MapCell> cells;  // as the plane has them
  // Sorted by the number of cells, largest first, then by their first cell.
  std::vector<MapAttractor> attractors;
  // Of cells spread over the plane; for basins of the first cell of each attractor.
  std::vector<CellMotion> motions;
  StopReason stopped = StopReason::kNone;

  const MapCell& at(int column, int row) const { return cells[options.cell(column, row)]; }
};

// Requires forcing and a stop. Throws InputError for a name that the scene does not have, or the
// same name twice. A cell whose values the scene does not allow says so.
AttractorMap map_attractors(const Scene& scene, const AttractorMapOptions& options);

}  // namespace graze
