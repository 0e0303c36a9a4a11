// Regions of stable motions in a plane of two parameters of the scene: sampled at places, each the
// middle of a cell, and checked by simulation.
//
// Every place searches for attractors by itself (attractor_search.hpp); then, in rounds, it gets
// those that its neighbours found in the round before, until nothing new is found anywhere. A round
// only uses results of earlier rounds, so that results do not depend on the number of threads.
// Regions are the connected places with the same attractors. Regions smaller than the cells, and
// attractors that none of the starts leads to, are missed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/study/plane/attractor_search.hpp"

namespace graze {

struct StableRegionsOptions {
  double from = 0.0, to = 0.0, second_from = 0.0, second_to = 0.0;  // SI
  int columns = 40, rows = 40;  // places over the first parameter and over the second
  // Periods, impacts, budgets. Where no closure speed is given here each place has its own.
  AttractorSearchOptions search;
  std::optional<double> closure_speed;            // m/s
  int threads = 0;                                // 0: all cores
  std::function<void(double fraction)> progress;  // called by one thread at a time
};

// Names of stable motions, sorted, each once.
using StableNames = std::vector<MotionName>;
// "(1,1) + no impact"; "" for none.
std::string label_of(const StableNames& names);

struct RegionPlace {
  double value = 0.0, second = 0.0;  // of the parameters
  bool finished = false;
  StableNames stable;
  int area = -1;        // index into the areas; -1: not finished
  std::string message;  // a sentence when nothing was found or something could not be followed
};

struct RegionArea {
  StableNames stable;
  std::size_t places = 0;
  double share = 0.0;     // of all places of the plane
  std::size_t inner = 0;  // the place furthest from the area's boundary
};

// An orbit at a place.
struct OrbitAtPlace {
  std::size_t place = 0;
  MotionName name;
};

struct StableRegions {
  int columns = 0, rows = 0;
  int period = 1, impacts = 1;           // p, k asked for
  double cell = 0.0, second_cell = 0.0;  // sizes of a cell, SI
  // Row by row from `second_from`, in each from `from`.
  std::vector<RegionPlace> places;
  std::vector<RegionArea> areas;           // the largest first
  long long finished = 0;                  // places
  long long confirmed = 0, undecided = 0;  // see PlaceAttractors
  long long searched = 0;                  // places where the closed form held
  std::vector<OrbitAtPlace> refuted, missed;
  long long simulated = 0;  // motions
  int rounds = 0;           // in which something was handed on
  bool settled = false;     // the last of them found nothing new
  StopReason stopped = StopReason::kNone;
};

// Throws InputError where the scene has no such parameters. Requires forcing and a stop. Places
// that the scene does not allow have a message and no stable motions.
StableRegions find_stable_regions(const Scene& scene, const std::string& first,
                                  const std::string& second, const StableRegionsOptions& options);

}  // namespace graze
