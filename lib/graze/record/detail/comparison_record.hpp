// The results of compare with what made them.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/study/compare/detail/comparison_map.hpp"

namespace graze {

// What is told of two motions.
enum class ComparedQuantity {
  kAttractor,  // what both settle on
  kAgreeing,   // first impacts that agree
  kFirstTime,  // of the first impact
  kFirstSpeed,
  kDisplacement,  // of what they settle on
  kVelocity,
  kEnergy,
  kTaken  // by the stops
};

// Motions of a scene and of others, each next to the one before.
struct ComparisonRecord {
  RunInfo info;
  std::vector<std::string> names;                    // of the scenes: "the scene", "beam.modes=5"
  std::vector<std::vector<std::string>> settings{};  // of each beside those of the first
  std::vector<int> modes;  // of each where that is what they differ in; else none
  CompareOptions options;
  std::vector<ComparedMotion> motions;
  std::vector<MotionDifference> differences;  // of each but the first from the one before
  std::vector<SimulationRecord> runs;         // with the samples that a picture shows; or none
  std::vector<std::string> warnings;
  Outcome outcome;
};

struct ComparisonMapRecord {
  RunInfo info;
  std::string one, other;            // names of the scenes
  std::vector<std::string> against;  // "KEY=VALUE" of what makes the other
  ComparisonMap map;
  std::string x_unit, y_unit;
  ComparedQuantity shown = ComparedQuantity::kAttractor;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// Fills in the differences, and the outcome: "compared"; "budget" where a motion could not be
// followed; or why not all of `asked` were.
void conclude_comparison(ComparisonRecord& record, std::size_t asked, StopReason stopped);
// "complete", and else likewise. Values that a scene does not allow are what the cell is.
Outcome comparison_map_outcome(const ComparisonMap& map);

}  // namespace graze
