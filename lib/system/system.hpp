// The assembled hybrid system, immutable once made:
//
//   q'' + 2 delta q' + omega^2 q = amplitude cos(frequency t + phase) + load    in free flight
//   gap_i - row_i.q >= 0,   q'+ = q'- - (1 + r_i) direction_i (row_i.q'-)       at stop i
//
// Every harmonic effect of the scene is folded into these numbers; what a scene does not name is
// absent. The row points into the stop, so that row.q' > 0 approaches it on either side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/vector.hpp"
#include "graze/contact/restitution.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

struct HarmonicForcing {
  double frequency = 0.0;  // rad/s
  double phase = 0.0;      // rad
  Vector amplitude;        // modal force, kg^1/2 m/s^2, N entries
};

struct RigidStop {
  Vector row;                    // b, kg^-1/2, N
  double gap = 0.0;              // a, m
  Vector direction;              // d, kg^1/2, N; row.direction = 1
  Restitution restitution{0.0};  // r(v)
};

struct State {
  Vector q;     // kg^1/2 m, N
  Vector qdot;  // kg^1/2 m/s, N
};

struct System {
  Vector omega;  // rad/s, N
  Vector delta;  // 1/s, N
  std::optional<HarmonicForcing> forcing;
  std::vector<RigidStop> stops;
  std::optional<Vector> load;  // constant modal force (gravity), kg^1/2 m/s^2, N

  int modes() const { return static_cast<int>(omega.size()); }
  // T = 2 pi/frequency, s; requires forcing.
  double period() const;
};

// Assembles a checked scene.
System assemble(const Scene& scene);

// Derivative of every number of the assembled system by a parameter of the scene.
System system_tangent(const Scene& scene, const std::string& parameter);

// The state at t = 0: as the scene says, else at rest; undeformed, but pressed against its stops in
// static equilibrium where one of them is preloaded (negative gap). Throws InputError, with the
// penetration, when it lies beyond a stop by more than the rounding of row.q.
State initial_state(const Scene& scene, const System& system);

// The same, or nothing where the motion cannot start there.
std::optional<State> clear_start(const Scene& scene, const System& system);

// Sentences about what in the scene deserves care: ill-conditioned collocation points, an impulse
// law that can add energy. Empty where all is well.
std::vector<std::string> system_warnings(const Scene& scene, const System& system);

// Condition number of the collocation matrix in force, or 0 where nothing collocates.
double collocation_condition(const Scene& scene);

}  // namespace graze
