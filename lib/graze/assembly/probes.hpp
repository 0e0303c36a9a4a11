// The probes of a scene as rows on the modal coordinates of its structure:
//
//   displacement, deflection  phi(x).q      velocity  phi(x).q'      strain  -h/2 phi''(x).q
//
// With a hub the displacement and the velocity of a point also hold its own arc, (radius + x) times
// the hub's angle or rate; the factor stands beside the row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/scene/scene.hpp"
#include "graze/system/measured_row.hpp"
#include "graze/system/system.hpp"

namespace graze {

struct ProbeRow {
  ProbeQuantity quantity = ProbeQuantity::kDisplacement;
  Vector row;                // on q or on q', N: kg^-1/2, of a strain kg^-1/2 m^-1
  bool of_velocity = false;  // on q' (and the rate) in place of q (and the angle)
  double angle = 0.0;        // factor of the hub's angle or rate; 0 without a hub

  // In the unit of the quantity; with a hub of rows on the system's own coordinates.
  double value(const State& state) const { return row.dot(of_velocity ? state.qdot : state.q); }
};

// The probes of a checked scene, in their order, as rows on the beam's own modes.
std::vector<ProbeRow> probe_rows(const Scene& scene);

// The same as rows on the coordinates of the assembled system.
std::vector<ProbeRow> probe_rows(const Scene& scene, const System& system);

// A place whose motion is measured: a probe, or the structure at a stop, whose displacement is u in
// the sign of the scene, on whichever side the stop stands.
struct MeasuredPlace {
  std::optional<int> probe{}, stop{};  // one of them, index from 0
  std::string unit;                    // of probe_unit(), "" of a scene without units
  MeasuredRow seen;                    // on the coordinates of the system

  std::string name(char between = ' ') const;  // "probe 1", "stop.1", ..
};

std::vector<MeasuredRow> rows_of(const std::vector<MeasuredPlace>& places);

// The probes, then the stops.
std::vector<MeasuredPlace> measured_places(const Scene& scene, const System& system);

// "m", "m/s", "rad", "rad/s", or "" of a strain.
std::string probe_unit(ProbeQuantity quantity);

}  // namespace graze
