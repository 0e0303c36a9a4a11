// A locus of special points of orbits in the plane of two parameters of the scene, as a value: its
// points, the points of codimension two on it, how it ends.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "graze/continuation/locus_values.hpp"
#include "graze/orbit/orbit.hpp"

namespace graze {

enum class OrbitLocusKind {
  kFold,            // LP
  kPeriodDoubling,  // PD
  kTorus,           // NS
  kGrazing          // GR: an approach touches a stop, or an impact speed vanishes
};

inline constexpr std::array<OrbitLocusKind, 4> kOrbitLocusKinds = {
    OrbitLocusKind::kFold, OrbitLocusKind::kPeriodDoubling, OrbitLocusKind::kTorus,
    OrbitLocusKind::kGrazing};

// "LP", "PD", "NS", "GR".
const char* label_of(OrbitLocusKind kind);

struct OrbitLocusPoint {
  double value = 0.0, second = 0.0;  // of both parameters
  double angle = 0.0;                // of the critical multiplier, rad; 0 on GR
  // Of the orbit, in time order as in Orbit; on GR the one that touches among them, at zero speed.
  std::vector<OrbitImpact> impacts;
  // Clear of every stop between the impacts, every impact speed positive but for the one that
  // vanishes on GR, none sticks.
  bool admissible = false;
  // On compliant stops: the orbit's states at the starts of its forcing periods, from which the
  // motion repeats it. Its impacts do not tell it there.
  std::vector<State> turns{};
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
  kGrazing,      // beyond it the orbits are none of the system
  kImpactsMeet,  // a flight from impact to impact shrinks to nothing
  kResonance,    // of NS: its pair becomes real
  kStepLimit,
  kOutOfTime,
  kStopped,
  kNotConverged
};

struct OrbitLocus {
  int id = 0;  // from 1
  OrbitLocusKind kind = OrbitLocusKind::kFold;
  ImpactPattern pattern;                // of the impacts at its points, on GR with the touch
  std::vector<OrbitLocusPoint> points;  // in order along the locus, special points among them
  std::vector<OrbitLocusSpecial> special;
  std::array<OrbitLocusEnd, 2> ends{OrbitLocusEnd::kNotConverged, OrbitLocusEnd::kNotConverged};
  bool compliant = false;      // of orbits on compliant stops: impacts do not tell them
  double closure_speed = 0.0;  // m/s, there: of chatters on rigid stops beside them
};

// A locus of critical orbits as one of equations; requires a kind that multipliers tell, not GR.
LocusKind as_locus_kind(OrbitLocusKind kind);

// What an end of a traced locus is called where it is one of orbits. One that was asked to halt has
// come to where its orbits meet no stop any more.
OrbitLocusEnd as_orbit_end(LocusEnd end);

}  // namespace graze
