// A scene: plain values that mirror the TOML file. What a scene does not name is absent here
// (empty optional, empty list) and is never simulated. SI units, angles in radians.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/base/defaults.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/time_course.hpp"
#include "graze/base/units.hpp"
#include "graze/contact/contact_force.hpp"
#include "graze/contact/hertz_stiffness.hpp"
#include "graze/scene/structures.hpp"

namespace graze {

enum class Side { kAbove, kBelow };
enum class Impulse { kMomentum, kCollocation };
// kSupport: the far end of the springs and dashpots between the ground and a mass moves, or what
// holds a structure of matrices; kNone: no
// force, its frequency is that of what moves otherwise.
enum class ForcingKind { kBase, kDistributed, kModal, kPoint, kSupport, kNone };
// What a stop stands on: the clamp, or ground, with which it is shaken, or what does not move.
enum class StopFrame { kClamp, kSpace };
// How the motion between impacts is computed: exactly, or integrated step by step by rk4, dopri5,
// fehlberg78, or (with a hub) bulirsch-stoer.
enum class FlowChoice { kAuto, kExact, kRk4, kDopri5, kFehlberg78, kBulirschStoer };
// The name in a scene file.
std::string flow_name(FlowChoice flow);

// Motor torque from t = 0 on: either constant for a while,
struct TorquePulse {
  double amplitude = 0.0;  // N m
  double duration = 0.0;   // s, > 0
};
// or through measured points, linear between them and zero outside; it jumps at an instant that is
// given twice.
struct TorqueTable {
  std::vector<double> times;   // s, >= 0, ascending, at least two
  std::vector<double> values;  // N m, as many
};
using Torque = std::variant<TorquePulse, TorqueTable>;

// kPaper: as printed in Yigit, Ulsoy & Scott (1990), without the two terms of the hub's equation
// that conserve the energy.
enum class HubEquations { kConsistent, kPaper };

// What the beam's clamp is fixed to, a rigid hub that turns about its centre; coordinates are its
// angle and the beam's modes. The beam leaves it radially.
struct Hub {
  double radius = 0.0;   // alpha, m, >= 0: from the centre to the clamp
  double inertia = 0.0;  // I_R, kg m^2, >= 0
  std::optional<Torque> torque{};
  HubEquations equations = HubEquations::kConsistent;
  bool centrifugal = true;           // terms with the square of the rate, and the inertia's change
  std::optional<double> friction{};  // Coulomb's at the joint, N m, >= 0
};

struct ViscousDamping {
  double coefficient = 0.0;  // eta, N s/m^2: force per length per velocity relative to the clamp
};
struct DampingRatios {
  std::vector<double> ratios;  // zeta_j, one per mode
};
struct RayleighDamping {
  double mass = 0.0;       // 1/s
  double stiffness = 0.0;  // s
};
// The same ratio of all modes.
struct DampingRatio {
  double ratio = 0.0;  // zeta
};
using Damping = std::variant<ViscousDamping, DampingRatios, RayleighDamping, DampingRatio>;

// A frequency as the scene writes it, in rad/s or in Hz; as a number it is in rad/s.
struct Frequency {
  double written = 0.0;   // > 0
  bool in_hertz = false;  // what is written: Hz, else rad/s

  operator double() const { return in_hertz ? kTurn * written : written; }
  // Takes a number in rad/s.
  Frequency& operator=(double angular) {
    written = angular;
    in_hertz = false;
    return *this;
  }
  // Stores the same frequency in Hz, or in rad/s.
  void write_in_hertz(bool hertz) {
    if (hertz != in_hertz) written = hertz ? written / kTurn : kTurn * written;
    in_hertz = hertz;
  }
};

// A point of the structure.
struct StructurePoint {
  double position = 0.0;      // m from the left end (beam, string, bar)
  std::vector<double> shape;  // phi_j there (modal structure), kg^-1/2
  // The degree of freedom (matrices) or the mass (lumped), and one that moves with it:
  // displacements are then those of the first relative to the second.
  std::string node{}, against{};
};

enum class SpectrumSides { kOne, kTwo };
// What a record of a moving clamp is one of.
enum class BaseRecord { kAcceleration, kDisplacement };

// A course of time from a file, joined by straight lines; nothing beside it, or again and again. Or
// one that is drawn: a sum of harmonics with random phases that has a spectral density.
struct SignalSource {
  std::string file{};      // a table with a row of names
  std::string column{};    // whose values those are; empty: the second one
  std::string time{};      // of the instants, s; empty: the first one
  BaseRecord quantity = BaseRecord::kAcceleration;  // of the kind "base"
  bool repeats = false;
  std::string spectrum{};  // in place of `file`: frequency, Hz, and density, unit^2/Hz, by columns
  SpectrumSides sides = SpectrumSides::kOne;
  int seed = 1;
  double duration = 0.0;  // s, over which the drawn course does not repeat
  double step = 0.0;      // s, between its instants
  // As it was read or drawn; of a clamp always its acceleration.
  std::shared_ptr<const TimeCourse> course{};
};

// amplitude cos(order frequency t + phase), with the frequency of the first load of a scene, or with
// one of its own; or amplitude times a course of time.
struct HarmonicLoad {
  ForcingKind kind = ForcingKind::kBase;
  double amplitude = 0.0;         // base, support: m; distributed: N/m; modal: 1; point: N
  std::optional<double> order{};  // a ratio of small whole numbers; absent: 1
  double phase = 0.0;             // rad
  StructurePoint at{};            // of the kinds "point" and "support"
  // In place of the order, > 0; loads then have no common period.
  std::optional<Frequency> own{};
  // In place of the harmonic; of the kind "base" the acceleration of the clamp.
  std::optional<SignalSource> signal{};

  bool has_place() const { return kind == ForcingKind::kPoint || kind == ForcingKind::kSupport; }
};

// The first load; of one that is a signal the frequency is that with which it repeats, or 1 rad/s.
struct Forcing : HarmonicLoad {
  Frequency frequency{};  // > 0
};

// A constant force along +u.
struct PointLoad : StructurePoint {
  double force = 0.0;  // N
};

// Dry friction by Coulomb's law against the motion of a point along u: its force, or a coefficient
// and the normal force that presses there.
struct DryFriction : StructurePoint {
  std::optional<double> force, coefficient, normal_force;  // N, 1, N
  std::optional<double> static_force, static_coefficient;  // up to which it sticks; as sliding
  double speed = 0.0;                                      // m/s along +u, of a belt
  int stop = 0;  // number of a stop, from 1, whose spring presses there; 0: none
  double parallel = 0.0, series = 0.0;  // N/m, of springs beside it, and between it and its place
  // Of the spring in series on the modes, as its point's; empty without.
  std::vector<double> spring_shape{};

  // N; at a stop parts of the force of its spring.
  double sliding() const {
    return force ? *force : stop > 0 ? *coefficient : *coefficient * *normal_force;
  }
  double sticking() const {
    return static_force         ? *static_force
           : static_coefficient ? *static_coefficient * (stop > 0 ? 1.0 : *normal_force)
                                : sliding();
  }
  // Their derivatives as the numbers change by `rate`.
  double sliding_rate(const DryFriction& rate) const {
    return force      ? *rate.force
           : stop > 0 ? *rate.coefficient
                      : *rate.coefficient * *normal_force + *coefficient * *rate.normal_force;
  }
  double sticking_rate(const DryFriction& rate) const {
    return static_force                     ? *rate.static_force
           : static_coefficient && stop > 0 ? *rate.static_coefficient
           : static_coefficient
               ? *rate.static_coefficient * *normal_force + *static_coefficient * *rate.normal_force
               : sliding_rate(rate);
  }
};

// Uniform acceleration along +u of every mass element; a constant load of the modes. With a hub it
// acts along -u at angle 0, and keeps that direction in space while the beam rotates.
struct Gravity {
  double acceleration = 0.0;  // m/s^2
};

enum class ContactModel {
  kKelvinVoigt,
  kLeeWang1,
  kLeeWang2,
  kHuntCrossley,
  kLankaraniNikravesh,
  kFlores,
  kAdams,
  kJankowski,
  kElastoGap
};
// The name in a scene file.
std::string contact_model_name(ContactModel model);

// The damping of a compliant stop (contact/detail/restitution_damping.hpp): its coefficient, or
// what the model builds it from.
struct SpringDamping {
  ContactModel model = ContactModel::kKelvinVoigt;
  std::optional<double> coefficient;  // C, see contact_force.hpp
  std::optional<double> ratio;        // zeta, of a linear spring
  std::optional<double> alpha;        // e = 1 - alpha v, s/m
  std::optional<double> restitution;  // e, at `speed` where it depends on it
  std::optional<double> speed;        // m/s
  std::optional<double> mass;         // kg
  std::optional<double> onset;        // m, also of Adams' model, and
  std::optional<double> sharpness;    // Q, of the second model of Lee & Wang
  bool exact = false;  // C gives the restitution itself, not what the model's formula makes of it
};

// The geometry of the structure and the stop, in place of a stiffness
// (contact/hertz_stiffness.hpp).
struct SpringGeometry {
  std::array<ElasticBody, 2> bodies{};
  double angle = 0.0;  // rad
};

// A compliant stop: F = k x^n + C T(x) x'.
struct Spring {
  double stiffness = 0.0;  // k, N/m^n
  double exponent = 1.0;   // n
  std::optional<SpringGeometry> geometry;
  std::optional<SpringDamping> damping;
  Separation release = Separation::kAtZeroForce;
  // In place of stiffness and exponent: the linear spring of the modes left out, 1/k = static
  // flexibility of the structure at the stop less that of its modes.
  bool is_residual = false;
};

// amplitude cos(order frequency t + phase) along u, with the frequency of the forcing.
struct StopMotion {
  double amplitude = 0.0;         // m
  std::optional<double> order{};  // as of a HarmonicLoad
  double phase = 0.0;             // rad
};

// At the point that meets it; where that is relative to another one, the gap is one between two
// bodies.
struct SceneStop : StructurePoint {
  double gap = 0.0;          // m; may be 0 or negative (preload)
  Side side = Side::kAbove;  // above: free while u < gap; below: free while u > -gap
  // r(v) = a0 - a1 v - a2 v^2 - .., v the approach speed; one entry: r is constant. a0 in 0..1,
  // a_i in (s/m)^i.
  std::vector<double> restitution = {0.0};
  Impulse impulse = Impulse::kMomentum;
  std::optional<Spring> spring{};  // in place of restitution and impulse
  std::vector<StopMotion> motion{};  // the sum of which it moves by
  StopFrame frame = StopFrame::kClamp;
};

// kDisplacement, kVelocity: of the point, with a hub along the arc from angle 0 on; kDeflection:
// from the line that rotates with the hub, without a hub the displacement; kStrain: of the fibre at
// half the thickness, -h/2 u'' (beam), or u' (bar); kAngle, kRate: of the hub, wherever the probe
// is.
enum class ProbeQuantity { kDisplacement, kVelocity, kDeflection, kStrain, kAngle, kRate };
// The name in a scene file.
std::string probe_quantity_name(ProbeQuantity quantity);
inline bool is_of_hub(ProbeQuantity quantity) {
  return quantity == ProbeQuantity::kAngle || quantity == ProbeQuantity::kRate;
}

// A quantity at a place, recorded in the time series of a motion.
// Its place is that of a StructurePoint; results keep it member by member, which a base would hide.
struct Probe {
  double position = 0.0;
  std::vector<double> shape;
  std::string node{}, against{};
  ProbeQuantity quantity = ProbeQuantity::kDisplacement;
};

struct Initial {
  std::vector<double> q;     // kg^1/2 m, one per mode
  std::vector<double> qdot;  // kg^1/2 m/s, one per mode
  double angle = 0.0;        // rad, of the hub
  double rate = 0.0;         // rad/s
  // In place of q and qdot, one for each mass or degree of freedom (lumped, matrices in the scene),
  // or for each of the positions of a beam, string or bar, with straight lines between them.
  std::vector<double> displacement{}, velocity{};  // m, m/s
  std::vector<double> positions{};                 // m, rising
  std::optional<double> speed{};                   // m/s, of all of the structure, in addition
  bool in_equilibrium = false;  // in place of displacements: at rest under its constant loads
};

struct Solver {
  FlowChoice flow = FlowChoice::kAuto;
  double tolerance =
      kDefaultTolerance;       // of the stop's displacement over one forcing period, relative
  std::optional<double> step;  // s, of a flow with steps of one length
};

// Where each key of the scene was written: "forcing.frequency" -> file:line:column.
using Origins = std::map<std::string, SourceLocation>;

// The unit of each number that the scene writes with one of its own: "stop.gap" -> "mm".
using WrittenUnits = std::map<std::string, std::string>;

struct Scene {
  std::string title;
  Units units = Units::kSi;
  std::variant<Beam, ModalStructure, TautString, Bar, MatrixStructure, LumpedStructure> structure;
  std::optional<Hub> hub{};  // of a beam
  std::optional<Damping> damping;
  std::optional<Forcing> forcing;       // the first load
  std::vector<HarmonicLoad> further{};  // none without it
  std::optional<Gravity> gravity;
  std::vector<PointLoad> loads{};
  std::vector<SceneStop> stops;
  std::vector<DryFriction> frictions{};
  std::vector<Probe> probes{};
  std::optional<Initial> initial;
  Solver solver;
  std::shared_ptr<const Origins> origins;         // null for a scene made in code
  std::shared_ptr<const WrittenUnits> written{};  // likewise

  // All loads, the first one first.
  std::vector<const HarmonicLoad*> harmonic_loads() const;
  bool has_load(ForcingKind kind) const;
  // Whether loads have a common period: all are harmonics of the first one's frequency.
  bool repeats() const;
  // How a stop moves relative to the clamp, in the order of its terms and then of the loads.
  std::vector<StopMotion> motion_of(const SceneStop& stop) const;
  bool has_moving_stop() const;
  // The largest part of the forcing frequency of which the frequency of each load and of each
  // motion of a stop is a whole multiple; 0 where there is none, as of incommensurate orders.
  double common_order() const;

  const Beam* beam() const { return std::get_if<Beam>(&structure); }
  const TautString* string() const { return std::get_if<TautString>(&structure); }
  const Bar* bar() const { return std::get_if<Bar>(&structure); }
  const MatrixStructure* matrices() const { return std::get_if<MatrixStructure>(&structure); }
  const LumpedStructure* lumped() const { return std::get_if<LumpedStructure>(&structure); }
  // Matrices, or masses and springs; null of another structure.
  const DiscreteStructure* discrete() const;
  DiscreteStructure* discrete();
  // The modes, given as such or computed from a discrete structure.
  const ModalStructure* modal() const {
    if (const DiscreteStructure* given = discrete()) return &given->modal;
    return std::get_if<ModalStructure>(&structure);
  }
  // The beam, string or bar, or null of another structure.
  const Span* span() const;
  Span* span();
  // "beam", "string", "bar", "modal", "matrices" or "lumped", the table that it stands in.
  const char* structure_name() const;
  // Number of the structure's modes N; a hub adds its angle to them.
  int modes() const;
};

// An error about `key`, located where the key (or else the nearest table above it) was written.
InputError scene_error(const Scene& scene, const std::string& key, const std::string& sentence);

}  // namespace graze
