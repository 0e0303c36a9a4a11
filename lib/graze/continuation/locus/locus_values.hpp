// Loci in the plane of two parameters as values: their points, their special points, how they end;
// and the options of their continuation. locus.hpp traces them.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/stop_signal.hpp"
#include "graze/base/vector.hpp"
#include "graze/continuation/branch/branch_values.hpp"

namespace graze {

enum class LocusKind {
  kFold,            // LP: a multiplier is 1
  kPeriodDoubling,  // PD: a multiplier is -1
  kTorus            // NS: a pair of multipliers is e^{+-i angle}
};

// "LP", "PD", "NS".
const char* label_of(LocusKind kind);

enum class LocusPointKind {
  kCusp,           // CP: two folds meet; w^T F_uu v v = 0
  kResonance1,     // R1: two multipliers are 1, with one vector; NS meets LP
  kResonance2,     // R2: two multipliers are -1, with one vector; NS meets PD
  kResonance3,     // R3: the pair is e^{+-2 pi i/3}
  kResonance4,     // R4: the pair is +-i
  kFoldDoubling,   // LPPD: multipliers 1 and -1
  kFoldTorus,      // LPNS: 1 and a pair on the unit circle
  kTwoDoublings,   // PDPD: -1 twice, each with its vector
  kDoublingTorus,  // PDNS: -1 and a pair on the unit circle
  kTwoTori,        // NSNS: two pairs on the unit circle
  // Where the coefficient of the normal form vanishes (LocusOptions::coefficient):
  kDegenerateDoubling,  // GPD: sub- and supercritical doublings meet
  kDegenerateTorus,     // GNS: such tori, the Chenciner point
  kCrossing             // BP: another locus of this kind crosses
};

// "CP", "R1", .. as above.
const char* label_of(LocusPointKind kind);

struct LocusPoint {
  Vector u;  // n
  double first = 0.0, second = 0.0;
  double angle = 0.0;     // of the critical multiplier, rad: 0 on LP, pi on PD, in [0, pi] on NS
  double residual = 0.0;  // largest entry of F and of the test for the critical multiplier
  Vector tangent;         // unit, in (u, first/range[, angle], second/range), n + 2 or n + 3
  int orientation = 0;    // as in SolutionPoint
  // All multipliers, the critical ones exact. Empty where the problem gives none.
  std::vector<Eigenvalue> multipliers;
};

// An orbit near a locus.
struct LocusStart {
  LocusKind kind = LocusKind::kFold;
  Vector u;  // n
  double first = 0.0, second = 0.0;
  Complex multiplier = 1.0;  // for NS: one of the pair; not used for LP and PD
};

struct LocusSpecialPoint {
  LocusPointKind kind = LocusPointKind::kCusp;
  LocusPoint point;
  std::size_t after = 0;  // lies between points after and after + 1
};

// Where one of the caller's functions passes zero (LocusOptions::tests).
struct LocusZero {
  std::size_t test = 0;  // which of its values
  LocusPoint point;
  std::size_t after = 0;  // as above
};

enum class LocusEnd {
  kFirstLimit,   // of the first parameter, exactly on it
  kSecondLimit,  // of the second
  kClosed,       // came back to where it started
  // For NS: the pair has become real, at R1 or R2. The angle is exactly 0 or pi; where the orbit
  // shrinks there into one of half its period the equations are singular, and it has an error of
  // 1e-5.
  kResonance,
  kStepLimit,     // max_points reached
  kNotConverged,  // no step, however small, converges
  kHalted,        // `proceed` said no
  kOutOfTime,     // the budget of computing time is spent
  kStopped        // from outside
};

// The end of a locus that corresponds to the end of a branch. `first`: whether a range that the
// branch left (kUnknownLimit) is that of the first parameter; else it is the angle's.
LocusEnd as_locus_end(BranchEnd end, bool first);

struct Locus {
  LocusKind kind = LocusKind::kFold;
  std::vector<LocusPoint> points;  // in order along the locus; a closed one repeats its first
  std::vector<LocusSpecialPoint> special;  // in order along the locus
  std::vector<LocusZero> zeros;            // by test, for each in order along the locus
  std::array<LocusEnd, 2> ends{LocusEnd::kNotConverged, LocusEnd::kNotConverged};
  long long evaluations = 0;  // of F
  long long rejected = 0;     // steps refused

  bool closed() const { return ends[1] == LocusEnd::kClosed; }
  std::vector<LocusSpecialPoint> special_of(LocusPointKind which) const;
};

struct LocusOptions {
  double first_from = 0.0, first_to = 1.0;    // range of the first parameter, either order
  double second_from = 0.0, second_to = 1.0;  // of the second
  // Largest change of either parameter in one step, as a part of its range; 0: a fiftieth.
  double max_step = 0.0;
  double max_distance = 0.05;          // as in ContinuationOptions
  double max_turn = 0.3;               // likewise, rad
  double residual_tolerance = 1e-11;   // likewise; of F, and of the test, which is of order 1
  int max_points = kMostBranchPoints;  // in each direction
  StopSignal stop{};
  // Called with the ends of every step; false: it is too long to show what happens within it.
  // Empty: no step is.
  std::function<bool(const LocusPoint& from, const LocusPoint& to)> resolves{};
  // Called with every new point and the previous one; false ends the locus there. Empty: goes on.
  std::function<bool(const LocusPoint& previous, const LocusPoint& here)> proceed{};
  // Functions that are smooth along the locus, the same number at every point; their zeros are
  // located. The points passed have only their critical multipliers. Returns nullopt when the
  // values are not known. Empty function: no tests.
  std::function<std::optional<Vector>(const LocusPoint& point)> tests{};
  // On PD and NS the coefficient of the normal form (normal_form.hpp), to any factor of one sign;
  // nullopt where it is not known. Empty function: its zeros are not searched for.
  std::function<std::optional<double>(const LocusPoint& point)> coefficient{};
};

}  // namespace graze
