// Contents of the picture of a run: the motion at the places of the stops, its stuck phases there,
// the contact forces and the energy.
#pragma once

#include <string>
#include <vector>

#include "graze/record/records.hpp"
#include "graze/report/chart/chart.hpp"
#include "graze/report/chart/detail/drawn_curve.hpp"

namespace graze {

constexpr std::size_t kMostRunPlaces = 4;  // that pictures and pages of a run show

struct TimeSpan {
  double start = 0.0, end = 0.0;  // s
};

// A stop at a place: at `place` on its axis, approached in the direction `sense`.
struct SeenStop {
  int index = 0;
  double sense = 1.0;  // +1, or -1 for a stop on the other side
  double place = 0.0;  // m
};

// Whether it is near the range of the motion; otherwise axes that show both would flatten the
// motion.
bool is_near(const SeenStop& stop, const AxisRange& motion);

// What lies behind it; `is_upright`: displacements are on the axis of y.
ChartFill behind(const SeenStop& stop, bool is_upright);

struct SeenImpact {
  double time = 0.0, place = 0.0;    // s, m
  double before = 0.0, after = 0.0;  // velocity, m/s
};

struct MotionPoint {
  double time = 0.0;          // s
  double displacement = 0.0;  // m
  double velocity = 0.0;      // m/s; NaN: it jumps here
};

struct StuckPhase {
  TimeSpan time;
  double place = 0.0;  // of the stop, m; NaN: where dry friction sticks
};

// One point of the structure, along the row of the first stop there, or of the first dry friction.
// Where there is neither it is the first modal coordinate.
struct SeenPlace {
  Vector row;
  std::vector<SeenStop> stops;
  std::vector<int> frictions{};  // that rub along it
  std::vector<SeenImpact> impacts;
  std::vector<MotionPoint> motion;  // includes the impacts themselves, which samples may miss
  std::vector<StuckPhase> stuck;    // stop by stop, then of dry friction

  bool is_modal() const { return stops.empty() && frictions.empty(); }
  // "stop", "stop 2" where there are several, "friction", or "q_1".
  std::string name(const System& system) const;
  // The same behind an arrow, where there is a stop to move to.
  std::string towards(const System& system) const;
};

struct SeenForce {
  int stop = 0;
  DrawnCurve force;  // N, broken where the stop is open
};

struct EnergyTerm {
  std::string name;
  std::string colour;
  DrawnCurve curve;  // J
};

struct SeenProbe {
  int number = 1;  // from 1
  ProbeQuantity quantity = ProbeQuantity::kDisplacement;
  DrawnCurve curve;  // never empty
};

struct MotionSeen {
  TimeSpan window;
  std::vector<SeenPlace> places;   // in the order of the stops, then of frictions; never empty
  std::vector<SeenForce> forces;   // of the stops that held something
  std::vector<DrawnCurve> rubbing;  // forces of dry friction against u, N
  std::vector<EnergyTerm> energy;  // energy now, and the work done on it since the window began
  std::vector<SeenProbe> probes;   // none where no samples are
};

// The places of the system's stops and of its dry friction, in their order, without motion.
std::vector<SeenPlace> places_of(const System& system);

MotionSeen motion_seen(const SimulationRecord& record);

// When the stop was closed for longer than an instant, within the window.
std::vector<TimeSpan> stuck_phases(const SimulationRecord& record, int stop,
                                   const TimeSpan& window);

}  // namespace graze
