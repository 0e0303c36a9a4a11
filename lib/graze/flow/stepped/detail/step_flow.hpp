// The motion of a linear system of first order between events, integrated step by step by a method
// of Boost.Odeint, and the first fall of an observable through zero by what such integrators can
// see: its sign at the ends of the steps. Where it changes, the zero is refined within the step; a
// fall and a rise within one step are missed (but of a structure on springs looked for). That is
// what the exact flow is compared with.
//
//   x_j' = w_j x_{n+j},   x_{n+j}' = load_j + force_j cos(theta) - 2 delta_j x_{n+j} - k_j x_j
//
// with x = (w q, q'), k_j = omega_j^2/w_j: all entries are velocities, so that one tolerance suits
// them. Modes that do not decouple come as a dense system (first_order.hpp), structures on
// compressed springs as a SprungSystem, whose x = (y, y').
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/contact/contact_force.hpp"
#include "graze/flow/held/detail/first_order.hpp"
#include "graze/flow/turning/detail/turning.hpp"

namespace graze {

// Modes side by side, n of each.
struct ModalRates {
  Vector scale;      // w, rad/s
  Vector stiffness;  // k, rad/s
  Vector damping;    // 2 delta, 1/s
  Vector load, force;
  double frequency = 0.0;  // of the force, rad/s
};

// What is watched beside sums of the state.
enum class SpringWatch {
  kNone,
  kDepth,  // of a spring
  kGrip,   // of a spring (ContactForce::grip)
  kSlack,  // minus that
  kRest,  // of a spring that rests: how far its depth is from zero, less what of it may be an error
  kHold   // constant + weights.x + the force of a hold of a turning structure
};

// Of a watch that starts at zero: whether it is known how it leaves that. What nobody knows is
// looked at when it differs from zero by more than its error.
enum class Leaving {
  kKnown,
  kAsked,   // its sign then ends the flight
  kAwaited  // it is positive, and falls only after that
};

// An observable to be watched: constant + weights.x + harmonic cos(theta + its phase), and of
// compressed springs force_weights.F; or a spring's own.
struct Watch {
  Vector weights;  // 2n
  double constant = 0.0;
  double harmonic_re = 0.0, harmonic_im = 0.0;  // Re(h e^{i theta})
  // It starts at a known zero of this multiplicity, which it leaves as `departure` s^multiplicity.
  // A grip has no departure: it has left its zero where it differs by more than its rounding.
  int multiplicity = 0;
  double departure = 0.0;
  Vector force_weights{};  // per spring; empty: none
  SpringWatch of_spring = SpringWatch::kNone;
  int spring = -1;      // index into SprungSystem::springs, or of a hold
  double factor = 1.0;  // of the force of a hold
  bool is_told = true;  // its least value is (StepDescent::lowest)
  double sure = 0.0;    // s, up to then it is known to be positive
  Leaving leaving = Leaving::kKnown;
  double mobility = 0.0;  // of the force of a stop: the acceleration by 1 N, m/s^2
};

// A structure on compressed springs, on its displacements y and velocities y':
//
//   y'' = load + force cos(theta) - D y' - K y - sum_i acting_i F_i(x_i, x_i'),   x_i' = row_i.y'
//
// with x_i the depth of the contact at spring i. Those that are not loaded do not act, but their
// depth is known.
struct SprungSystem {
  struct Spring {
    ContactForce law;
    Vector row, acting;  // n
    bool loaded = true;
    Vector whole_row{};    // on all coordinates of a structure that turns
    bool resting = false;  // its surface is touched: it is loaded where that is passed
  };
  // What holds the structure by a force that is not along what it forbids: the force, and with
  // which row it takes power, -against.y' times the force.
  struct Holding {
    Watch force;
    Vector against;
  };
  // Powers of the forcing, forcing.y' cos(theta), and of the damping, y'.(damping y'), where they
  // are not those of `force` and D.
  struct Powers {
    Vector forcing;
    Matrix damping;
    std::vector<Holding> held;
  };
  Matrix stiffness, damping;  // K, D: n x n, or a column of the diagonal
  Vector load, force;         // n
  double frequency = 0.0;     // of the force, rad/s
  std::vector<Spring> springs;
  std::optional<Powers> powers{};
  // Then K alone stands above, and everything else but the springs comes from here.
  std::optional<Turning> turning{};
};

// What a spring took from the structure since the start of a piece, J.
struct SpringWork {
  double lost = 0.0;    // to its damping, >= 0
  double stored = 0.0;  // kept, or given back where it is negative
};

// Since the start of a piece on springs.
struct SprungWorks {
  Vector moved;              // y - y_0
  double forcing = 0.0;      // J; of the torque on a hub
  double weight = 0.0;       // of a structure that turns, J; others count it by what they moved
  double dissipation = 0.0;  // by damping, J
  double constraint = 0.0;   // of what holds the structure, J
  std::vector<SpringWork> springs;
};

struct StepDescent {
  int watch = -1;       // which fell through zero first; -1: none did
  double s = 0.0;       // where; else the end of the window, or the last place that is known
  bool finite = true;   // the state stayed in range
  bool beyond = false;  // of a watch that was asked for its sign: it became positive
  std::vector<double> errors{};  // then, of every watch that was
  bool stopped = false;          // the stop signal ended it
  double lowest = 0.0;           // least value of any watch at the ends of the steps
  long long values = 0;          // of observables, taken in search of the zero
};

class StepFlow {
 public:
  static constexpr double kNoDepth = std::numeric_limits<double>::infinity();
  virtual ~StepFlow() = default;
  // A smooth piece begins: the state at forcing phase theta; s counts from here.
  // `depths`: of the springs, m. `time`: of a structure that turns, s.
  virtual void start(double theta, const Vector& x, std::span<const double> depths = {},
                     double time = 0.0) = 0;
  // The first watch to fall through zero within the window, s. Nobody asks beyond `until`, s: up to
  // there the least value is told, and a step that gets beyond it is the last. `stop` is asked now
  // and then: a window may have any number of steps. Of springs the depths beyond `told_depth`, m,
  // are located (deepest).
  virtual StepDescent first_descent(std::span<const Watch* const> watches, double window,
                                    double until, const StopSignal& stop,
                                    double told_depth = kNoDepth) = 0;
  // The state s seconds after the start. Dear where s lies before the step taken last.
  virtual void state(double s, Vector& x) = 0;
  // Goes through the steps once more, from the start up to `until`, s: each, or each part of a long
  // one, from where to where.
  // The states within a step are at hand while it is visited.
  virtual void each_step(double until, const std::function<void(double, double)>& visit) = 0;
  // Of a spring since the start: its largest force, N, and how deep it was compressed, m, where
  // that is beyond the depth to be told; 0 where there is none.
  virtual double peak_force(std::size_t /*spring*/) const { return 0.0; }
  virtual double deepest(std::size_t /*spring*/) const { return 0.0; }
  // Since the start, s seconds after it; nothing but for a structure on springs.
  virtual SprungWorks works(double /*s*/) { return {}; }
  // Of the right-hand side, so far.
  virtual long long evaluations() const = 0;
};

}  // namespace graze
