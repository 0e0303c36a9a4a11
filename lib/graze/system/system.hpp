// The assembled hybrid system, immutable once made:
//
//   q'' + D q' + omega^2 q = f(frequency t + phase) + load                      in free flight
//   gap_i - row_i.q >= 0,   q'+ = q'- - (1 + r_i) direction_i (row_i.q'-)       at stop i,
//   or, at a compliant one,  q'' = .. - row_i F_i(x_i, x_i'),  x_i = row_i.q - gap_i > 0
//   q'' = .. - row_k R_k,  |R_k| <= limit                                       by dry friction k
//
// with D = diag(2 delta), where the damping couples no modes. Every harmonic effect is folded into
// these numbers; effects that are absent are not stored. The numbers may come from a scene
// (assembly.hpp) or from a program's own model. The row points into the stop, so that row.q' > 0
// approaches it on either side.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/base/time_course.hpp"
#include "graze/base/units.hpp"
#include "graze/base/vector.hpp"
#include "graze/contact/contact_force.hpp"
#include "graze/contact/restitution.hpp"
#include "graze/system/rotation.hpp"

namespace graze {

// cosine cos(order theta) + sine sin(order theta), N entries each; of a force, kg^1/2 m/s^2. Where
// a course takes the place of the cosine, the sine is zero.
struct Harmonic {
  // A course over the time t = (theta - phase)/frequency.
  struct Timed {
    std::shared_ptr<const TimeCourse> course;
    double frequency = 1.0, phase = 0.0;  // of the forcing

    double time(double theta) const { return (theta - phase) / frequency; }
  };
  double order = 1.0;  // whole, where loads have a common period; 0 of a course
  Vector cosine, sine;
  std::optional<Timed> timed{};

  Vector at(double theta) const;
  Vector rate_at(double theta) const;  // per rad
  // cos(order theta) and -sin(order theta), or the course and what stands for its rate: z = unit
  // wave and z' = unit max(frequency, 1 1/s) swing, see ConstrainedStructure.
  double wave(double theta) const;
  double swing(double theta) const;
  double largest_wave() const;

  ComplexVector force() const;  // F of Re(F e^{i order theta})
};

// f(theta) = amplitude cos(theta) + the sum of further harmonics, at theta = frequency t + phase.
struct HarmonicForcing {
  double frequency = 0.0;  // rad/s
  double phase = 0.0;      // rad
  Vector amplitude;        // modal force, kg^1/2 m/s^2, N entries
  std::vector<Harmonic> harmonics{};
  // False where loads have no common period: theta then counts on and is not taken modulo 2 pi.
  bool repeats = true;
  bool has_phase = true;  // false where the frequency is that of no load

  Vector at(double theta) const;
  Vector rate_at(double theta) const;  // of f, per rad
  Vector size() const;                 // no entry of f exceeds that
};

// What a rigid stop does to the velocity of the structure that hits it.
struct ImpactLaw {
  Vector direction;              // d, kg^1/2, N; row.direction = 1
  Restitution restitution{0.0};  // r(v)
};

// A rigid stop has a law of impact, a compliant one a force.
struct Stop {
  Vector row;        // b, kg^-1/2, N
  double gap = 0.0;  // a, m
  std::variant<ImpactLaw, ContactForce> law{};

  bool is_compliant() const { return std::holds_alternative<ContactForce>(law); }
  // Requires a rigid stop.
  const ImpactLaw& impact() const { return std::get<ImpactLaw>(law); }
  ImpactLaw& impact() { return std::get<ImpactLaw>(law); }
  const Restitution& restitution() const { return impact().restitution; }
  // Direction along which it pushes.
  const Vector& direction() const { return is_compliant() ? row : impact().direction; }
  // Requires a compliant stop.
  const ContactForce& force() const { return std::get<ContactForce>(law); }
  ContactForce& force() { return std::get<ContactForce>(law); }
};

// Dry friction by Coulomb's law: R = sliding sign(v), v = row.q' - speed, and |R| <= sticking while
// v = 0. At a compliant stop both are parts of the force of its spring.
struct Friction {
  Vector row;                            // kg^-1/2, N
  Vector direction;                      // d = row/(row.row), kg^1/2, N
  double sliding = 0.0, sticking = 0.0;  // N, or parts
  double speed = 0.0;                    // m/s, of a belt that it acts from
  int stop = -1;                         // whose spring presses there; -1: none
  // A spring between what rubs, which has no mass, and its place: its force is R. What rubs sticks
  // until the spring pulls with R, and then follows its place.
  struct Series {
    double stiffness = 0.0;  // N/m
    Vector row, direction;   // of the length of the spring, and by a force on what rubs
  };
  std::optional<Series> series{};
};

struct State {
  Vector q;     // kg^1/2 m, N
  Vector qdot;  // kg^1/2 m/s, N
};

// A structure that moves in its natural modes, each by itself between impacts unless damping
// couples them.
struct NaturalModes {
  Vector delta;  // 1/s, N: half the diagonal of D
  std::optional<HarmonicForcing> forcing{};
  std::optional<Vector> load{};      // constant modal force (gravity), kg^1/2 m/s^2, N
  std::optional<Matrix> coupling{};  // the rest of D, 1/s, N x N with a zero diagonal
  // Stops that move, by row.c = their motion: q is then that of the structure less c, a sum of
  // harmonics of orders that the forcing has too (kg^1/2 m), and stops stand still; empty: none.
  std::vector<Harmonic> carried{};
  // Displacements of the masses or degrees of freedom by the modes, N x N, of a structure whose
  // modes may change their sign or their order along a branch.
  std::optional<Matrix> coordinates{};
};

struct System {
  Vector omega;  // rad/s, N
  // On a rotating hub (Rotation) the coordinates are those of hub and beam together, N + 1 of them,
  // and directions those of the structure at rest in its shape.
  std::variant<NaturalModes, Rotation> structure;
  std::vector<Stop> stops;
  Units units = Units::kSi;  // of its numbers, for messages
  std::vector<Friction> frictions{};

  int modes() const { return static_cast<int>(omega.size()); }
  // Stops and frictions are counted together: friction k has the index stops.size() + k, and what
  // rubs behind its spring while it follows its place index_of_following().
  bool is_friction(int index) const { return index >= static_cast<int>(stops.size()); }
  bool follows(int index) const {
    return index >= static_cast<int>(stops.size() + frictions.size());
  }
  int index_of_following(int friction) const {
    return friction + static_cast<int>(frictions.size());
  }
  const Friction& friction(int index) const {
    const std::size_t k = static_cast<std::size_t>(index) - stops.size();
    return frictions[k < frictions.size() ? k : k - frictions.size()];
  }
  const Vector& row(int index) const {
    return follows(index)       ? friction(index).series->row
           : is_friction(index) ? friction(index).row
                                : stops[static_cast<std::size_t>(index)].row;
  }
  // Along which what holds the structure there pushes it.
  const Vector& direction(int index) const {
    return follows(index)       ? friction(index).series->direction
           : is_friction(index) ? friction(index).direction
                                : stops[static_cast<std::size_t>(index)].direction();
  }
  bool has_compliant_stop() const {
    return std::any_of(stops.begin(), stops.end(),
                       [](const Stop& stop) { return stop.is_compliant(); });
  }
  bool has_rigid_stop() const {
    return std::any_of(stops.begin(), stops.end(),
                       [](const Stop& stop) { return !stop.is_compliant(); });
  }
  bool turns() const { return std::holds_alternative<Rotation>(structure); }
  // Requires a structure without a rotating hub.
  const NaturalModes& modal() const { return std::get<NaturalModes>(structure); }
  NaturalModes& modal() { return std::get<NaturalModes>(structure); }
  const Vector& delta() const { return modal().delta; }
  // Null without a rotating hub.
  const Rotation* rotation() const { return std::get_if<Rotation>(&structure); }
  const HarmonicForcing* forcing() const {
    return !turns() && modal().forcing ? &*modal().forcing : nullptr;
  }
  // Null where each mode moves by itself, and with a rotating hub.
  const Matrix* coupling() const {
    return !turns() && modal().coupling ? &*modal().coupling : nullptr;
  }
  // Null where modes are never renumbered, and with a rotating hub.
  const Matrix* coordinates() const {
    return !turns() && modal().coordinates ? &*modal().coordinates : nullptr;
  }
  // D, and D q'. Both require a structure without a rotating hub.
  Matrix damping() const {
    Matrix all = coupling() ? *coupling() : Matrix(Matrix::Zero(modes(), modes()));
    all.diagonal() += 2.0 * delta();
    return all;
  }
  Vector resistance(const Vector& qdot) const {
    Vector force = 2.0 * delta().cwiseProduct(qdot);
    if (coupling()) force += *coupling() * qdot;
    return force;
  }
  // What stops that move carry the structure along by; null where all stand still.
  const std::vector<Harmonic>* carried() const {
    return !turns() && !modal().carried.empty() ? &modal().carried : nullptr;
  }
  // Null without harmonics beside the first.
  const std::vector<Harmonic>* harmonics() const {
    return forcing() && !forcing()->harmonics.empty() ? &forcing()->harmonics : nullptr;
  }
  // Whether between impacts each mode moves by itself under one harmonic force: closed forms.
  bool has_closed_forms() const { return !coupling() && !harmonics(); }
  // Whether all stops are rigid as well, so that orbits are equations for their impacts alone. The
  // others are followed.
  bool has_modal_flights() const {
    return !has_compliant_stop() && has_closed_forms() && frictions.empty();
  }
  const Vector* load() const { return !turns() && modal().load ? &*modal().load : nullptr; }
  bool repeats() const { return forcing() && forcing()->repeats; }
  // Whether nothing drives it but belts: orbits then have periods of their own, of which the
  // forcing's is only a guess.
  bool is_self_excited() const {
    return forcing() && forcing()->amplitude.isZero(0.0) && forcing()->harmonics.empty() &&
           std::any_of(frictions.begin(), frictions.end(),
                       [](const Friction& friction) { return friction.speed != 0.0; });
  }
  // T = 2 pi/frequency, s; infinite where no loads repeat.
  double period() const {
    return repeats() ? kTurn / forcing()->frequency : std::numeric_limits<double>::infinity();
  }
  // That of the first load, beside which others may not repeat; infinite where that has none.
  double first_period() const {
    return has_phase() ? kTurn / forcing()->frequency : std::numeric_limits<double>::infinity();
  }
  bool has_phase() const { return forcing() && forcing()->has_phase; }
};

// The structure's own state at forcing phase theta (rad), and that of the system, which differ
// where stops move.
State structure_state(const System& system, const State& state, double theta);
State system_state(const System& system, const State& structure, double theta);

// Forces on the modes, kg^1/2 m/s^2, as they are set; of several harmonics the sums of their sizes.
// Empty without forcing.
std::optional<Vector> modal_forces(const System& system);

}  // namespace graze
