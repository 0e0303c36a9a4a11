// The words of results for motions: events, ends, stabilities, and what a sweep settles on.
#pragma once

#include <optional>
#include <string>

#include "graze/bifurcation/problem/orbit_locus.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/record/study_records.hpp"

namespace graze {

inline constexpr SweepDirection kSweepDirections[] = {SweepDirection::kUp, SweepDirection::kDown,
                                                      SweepDirection::kFresh};
inline constexpr DiagramSection kDiagramSections[] = {DiagramSection::kImpact,
                                                      DiagramSection::kStroboscopic};

std::string name_of(SweepDirection direction);
std::string name_of(SweepStart start);
std::string name_of(SweepStatus status);
std::string name_of(DiagramSection section);
// "impacts", "sticking", "clear", "at rest"; for a motion that does not repeat "torus" or "chaos"
// where the exponents decide that, else the status.
std::string attractor_kind(const AttractorClass& attractor);

// "(2,1)": one impact in two forcing periods; "(1,stick)": comes to rest on a stop and is released
// once a period; "no impact".
std::string orbit_label(int period, long long impacts, bool sticks);
// The same for a settled motion, or "clear", "at rest", "torus", "chaos", "not periodic", or why
// there is no attractor.
std::string attractor_label(const AttractorClass& attractor);
// The same for tables and pictures: "no impact" in place of "clear".
std::string attractor_title(const AttractorClass& attractor);

// The number of stops in a row, those of every period one stop after the other.
std::size_t stops_seen(const SweepRow& row);

// The forcing period of an impact within the periods that a row shows, from 0; and its phase
// (frequency t + phase) mod 2 pi, rad.
long long period_index(const SweepRow& row, const MetImpact& impact);
double impact_phase(const MetImpact& impact);

// The words of results for kinds and ends.

std::string name_of(EventKind kind);
std::string name_of(OrbitBranchEnd end);
// What a normal form says of the orbits beside a fold or a doubling, a clause; empty without one.
std::string words_beyond(const SpecialPoint& special);
std::string name_of(OrbitLocusEnd end);

// "yes", "no", or "on the circle" for a stability that rounding leaves open.
std::string stability_word(const std::optional<bool>& stable);

}  // namespace graze
