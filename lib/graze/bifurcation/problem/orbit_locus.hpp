// A locus of special points of orbits in the plane of two parameters of the scene, as a value: its
// points, the points of codimension two on it, how it ends.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "graze/continuation/locus/locus_values.hpp"
#include "graze/orbit/problem/orbit.hpp"

namespace graze {

enum class OrbitLocusKind {
  kFold,             // LP
  kPeriodDoubling,   // PD
  kTorus,            // NS
  kGrazing,          // GR: an approach touches a stop, or an impact speed vanishes
  kChatterCompletes  // CH: a chatter completes at the instant of its release
};

inline constexpr std::array<OrbitLocusKind, 5> kOrbitLocusKinds = {
    OrbitLocusKind::kFold, OrbitLocusKind::kPeriodDoubling, OrbitLocusKind::kTorus,
    OrbitLocusKind::kGrazing, OrbitLocusKind::kChatterCompletes};

// "LP", "PD", "NS", "GR", "CH".
const char* label_of(OrbitLocusKind kind);

struct OrbitLocusPoint {
  double value = 0.0, second = 0.0;  // of both parameters
  double angle = 0.0;                // of the critical multiplier, rad; 0 on GR
  // Of the orbit, in time order as in Orbit; on GR the one that touches among them, at zero speed.
  std::vector<OrbitImpact> impacts;
  // Clear of every stop between the impacts, every impact speed positive but for the one that
  // vanishes on GR, none sticks.
  bool admissible = false;
  // Of an orbit that is followed, whose impacts do not tell it.
  std::vector<StickingPhase> sticking{};
  std::optional<OrbitSection> section{};
};

// Where loci meet or change their nature, with MatCont's names: CP, R1 to R4, LPPD, LPNS, PDPD,
// PDNS, NSNS, BP; and where the orbit grazes besides: LPGR, PDGR, NSGR, GRGR.
struct OrbitLocusSpecial {
  std::string label;
  std::string id;  // "CP-1"
  OrbitLocusPoint at;
  std::optional<double> other_angle{};  // of a further pair on the unit circle, rad
};

enum class OrbitLocusEnd {
  kFirstLimit,   // of the first parameter
  kSecondLimit,  // of the second
  kClosed,
  kGrazing,           // beyond it the orbits are none of the system
  kImpactsMeet,       // a flight from impact to impact shrinks to nothing
  kChatterCompletes,  // beyond it the stuck phases are others
  kResonance,         // of NS: its pair becomes real
  kStepLimit,
  kOutOfTime,
  kStopped,
  kNotConverged
};

struct OrbitLocus {
  int id = 0;  // from 1
  OrbitLocusKind kind = OrbitLocusKind::kFold;
  // Of the impacts at its points, on GR with the grazing contact; where the orbits stick, whose
  // impacts come and go, in place of these its stuck phases.
  ImpactPattern pattern;
  std::vector<OrbitLocusPoint> points;  // in order along the locus, special points among them
  std::vector<OrbitLocusSpecial> special;
  std::array<OrbitLocusEnd, 2> ends{OrbitLocusEnd::kNotConverged, OrbitLocusEnd::kNotConverged};

  bool sticks() const { return !points.empty() && !points.front().sticking.empty(); }
};

// A locus of critical orbits as one of equations; requires a kind that multipliers tell, LP, PD,
// NS.
LocusKind as_locus_kind(OrbitLocusKind kind);

// What an end of a traced locus is called where it is one of orbits. One that was asked to halt has
// come to where its orbits meet no stop any more.
OrbitLocusEnd as_orbit_end(LocusEnd end);

}  // namespace graze
