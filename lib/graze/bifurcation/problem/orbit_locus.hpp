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
  kFold,              // LP
  kPeriodDoubling,    // PD
  kTorus,             // NS
  kGrazing,           // GR: an approach touches a stop, or an impact speed vanishes
  kChatterCompletes,  // CH: a chatter completes at the instant of its release
  kLevel,             // UZ: a number of the orbits has a value (OrbitLevel)
  kExtreme            // EX: it is largest or smallest over the first parameter
};

// All but those of levels, which are of a user's own.
inline constexpr std::array<OrbitLocusKind, 5> kOrbitLocusKinds = {
    OrbitLocusKind::kFold, OrbitLocusKind::kPeriodDoubling, OrbitLocusKind::kTorus,
    OrbitLocusKind::kGrazing, OrbitLocusKind::kChatterCompletes};

// "LP", "PD", "NS", "GR", "CH", "UZ", "EX".
const char* label_of(OrbitLocusKind kind);

// UZ and EX.
inline bool is_of_level(OrbitLocusKind kind) {
  return kind == OrbitLocusKind::kLevel || kind == OrbitLocusKind::kExtreme;
}

struct OrbitLocusPoint {
  double value = 0.0, second = 0.0;  // of both parameters
  double angle = 0.0;                // of the critical multiplier, rad; 0 on GR
  // Impacts of the orbit, in time order as in Orbit; on GR including the one that touches, at zero
  // speed.
  std::vector<OrbitImpact> impacts;
  // Whether it is clear of every stop between the impacts, with positive impact speeds except the
  // one that vanishes on GR, and does not stick.
  bool admissible = false;
  // For an orbit that is followed, which its impacts do not define.
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
  kGrazing,           // beyond it solutions are virtual
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
  std::size_t level = 0;  // of UZ and EX: which of the levels
  // The impacts at its points, on GR with the grazing contact; for orbits that stick, whose impacts
  // come and go, its stuck phases instead.
  ImpactPattern pattern;
  std::vector<OrbitLocusPoint> points;  // in order along the locus, special points among them
  std::vector<OrbitLocusSpecial> special;
  std::array<OrbitLocusEnd, 2> ends{OrbitLocusEnd::kNotConverged, OrbitLocusEnd::kNotConverged};

  bool sticks() const { return !points.empty() && !points.front().sticking.empty(); }
};

// The locus of equations that corresponds to a locus of critical orbits; requires a kind with a
// critical multiplier, LP, PD, NS.
LocusKind as_locus_kind(OrbitLocusKind kind);

// The end of a locus of orbits that corresponds to the end of a traced locus. A trace that was
// halted has reached orbits that meet no stop any more.
OrbitLocusEnd as_orbit_end(LocusEnd end);

}  // namespace graze
