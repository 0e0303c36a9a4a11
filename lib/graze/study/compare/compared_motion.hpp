// Motions of one scene and of the same with another choice (a discretisation, an impulse law, a
// mode more), side by side: their first impacts, what they settle on, and the energy of that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/scene/scene.hpp"
#include "graze/study/run_impact.hpp"
#include "graze/study/sweep/settled_row.hpp"

namespace graze {

struct CompareOptions : RowOptions {
  long long first = 20;  // impacts from the start on that are compared
  // First impacts agree while their times differ by no more than this part of a forcing period and
  // their speeds by no more than this part of the fastest one of them.
  double within = 0.01;
};

struct ComparedMotion {
  double forcing_period = 0.0;   // s
  std::vector<RunImpact> first;  // impacts and contacts, from the start on
  AttractorClass attractor;
  std::string message;  // a sentence, or empty
  // For the settled motion; absent when it could not be followed.
  std::optional<double> energy;  // mechanical, its mean over time, J
  std::optional<double> taken;   // by the stops, in a forcing period, J; negative: they add
  // At the first stop, positive towards it, at equal distances of time: displacement (m) and
  // velocity (m/s) over a repetition. Empty where the motion does not repeat.
  std::vector<double> displacement, velocity;
};

// The motion from the scene's start. Returns nullopt when it was stopped. Requires forcing, a stop
// and the exact flow. Throws InputError where the scene does not allow a start.
std::optional<ComparedMotion> compared_motion(const Scene& scene, const CompareOptions& options);

// Differences of another motion from one. Absent where either has no such number.
struct MotionDifference {
  int agreeing = 0, first = 0;  // `agreeing` of the `first` impacts compared agree
  // Of the first impact: other minus one, in forcing periods, and as a part of the faster.
  std::optional<double> first_time, first_speed;
  bool is_same_attractor = false;
  // For two that repeat alike, compared in the forcing period in which they differ least: root mean
  // square of the difference, relative to the larger of the two about their means.
  std::optional<double> displacement, velocity;
  // Other minus one, relative to the larger.
  std::optional<double> energy, taken;
};
MotionDifference difference(const ComparedMotion& one, const ComparedMotion& other,
                            const CompareOptions& options);

}  // namespace graze
