// The motion of a linear system of first order between events, integrated step by step by a method
// of Boost.Odeint. The first fall of an observable through zero is found as such integrators find
// it: by its sign at the ends of the steps. Where it changes, the zero is refined within the step;
// a fall and a rise within one step are missed (on springs they are searched for). The exact flow
// is compared with this.
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

// n modes, a number of each.
struct ModalRates {
  Vector scale;      // w, rad/s
  Vector stiffness;  // k, rad/s
  Vector damping;    // 2 delta, 1/s
  Vector load, force;
  double frequency = 0.0;  // of the force, rad/s
};

// Watched quantities that are no linear function of the state.
enum class SpringWatch {
  kNone,
  kDepth,  // of a spring
  kGrip,   // of a spring (ContactForce::grip)
  kSlack,  // minus that
  kRest,   // distance of the depth of a spring at rest from zero, less its error bound
  kHold    // constant + weights.x + the force of a hold of a turning structure
};

// For a watch that starts at zero: whether it is known how it leaves zero. If not, it is reported
// when it differs from zero by more than its error.
enum class Leaving {
  kKnown,
  kAsked,   // its sign then ends the flight
  kAwaited  // it is positive, and falls only after that
};

// A watched observable: constant + weights.x + harmonic cos(theta + its phase), for compressed
// springs also force_weights.F; or a quantity of one spring.
struct Watch {
  Vector weights;  // 2n
  double constant = 0.0;
  double harmonic_re = 0.0, harmonic_im = 0.0;  // Re(h e^{i theta})
  // It starts at a known zero of this multiplicity, which it leaves as `departure` s^multiplicity.
  // A grip has no departure: it has left its zero when it differs from it by more than its
  // rounding.
  int multiplicity = 0;
  double departure = 0.0;
  Vector force_weights{};  // per spring; empty: none
  SpringWatch of_spring = SpringWatch::kNone;
  int spring = -1;      // index into SprungSystem::springs, or of a hold
  double factor = 1.0;  // of the force of a hold
  bool is_told = true;  // its least value counts in StepDescent::lowest
  double sure = 0.0;    // s, up to when it is known to be positive
  Leaving leaving = Leaving::kKnown;
  double mobility = 0.0;  // of the force of a stop: the acceleration by 1 N, m/s^2
};

// A structure on compressed springs, on its displacements y and velocities y':
//
//   y'' = load + force cos(theta) - D y' - K y - sum_i acting_i F_i(x_i, x_i'),   x_i' = row_i.y'
//
// with x_i the depth of the contact at spring i. Springs that are not loaded do not act, but their
// depth is known.
struct SprungSystem {
  struct Spring {
    ContactForce law;
    Vector row, acting;  // n
    bool loaded = true;
    Vector whole_row{};    // on all coordinates of a structure that turns
    bool resting = false;  // its surface is touched: it acts once that is passed
    Vector pushing{};      // along which it pushes, on all coordinates (pushing_row)
  };
  // A constraint force that is not along the row it holds, as of an oblique law: the force, and the
  // vector with which it takes power, -against.y' times the force.
  struct Holding {
    Watch force;
    Vector against;
  };
  // Powers of the forcing, y'.(forcing cos(theta) + by_place y + by_rate y'), and of the damping,
  // y'.(damping y'), where they are not those of `force` and D. Without further harmonics the
  // forcing has no such matrices.
  struct Powers {
    Vector forcing;
    Matrix damping;
    Matrix by_place{}, by_rate{};
    std::vector<Holding> held;
  };
  // Where stops move: the velocity V of the structure itself and the loads on it (structure_forms.hpp),
  // the damping it meets, the rows of springs on it, and closed stops against it. What stops do by
  // moving counts as work of constraints.
  struct Moving {
    Matrix place, rate;
    Vector forcing;
    Matrix force_place, force_rate, damping;
    std::vector<Vector> rows;
    std::vector<Holding> held;
  };
  Matrix stiffness, damping;  // K, D: n x n, or a column of the diagonal
  Vector load, force;         // n
  double frequency = 0.0;     // of the force, rad/s
  std::vector<Spring> springs;
  std::optional<Powers> powers{};
  std::optional<Moving> moving{};  // then in place of the powers
  // On a rotating hub: only K above is used then, all else but the springs comes from here.
  std::optional<Turning> turning{};
};

// Energy that a spring took from the structure since the start of a piece, J.
struct SpringWork {
  double lost = 0.0;    // to its damping, >= 0
  double stored = 0.0;  // kept, or given back where it is negative
};

// Works since the start of a piece on springs.
struct SprungWorks {
  Vector moved;              // y - y_0
  double forcing = 0.0;      // J; of the torque on a hub
  double weight = 0.0;       // on a rotating hub, J; elsewhere it follows from `moved`
  double dissipation = 0.0;  // by damping, J
  double constraint = 0.0;   // of what holds the structure, J
  std::vector<SpringWork> springs;
};

struct StepDescent {
  int watch = -1;                // the first to fall through zero; -1: none did
  double s = 0.0;                // of that fall; else the end of the window, or of what is known
  bool finite = true;            // the state stayed in range
  bool beyond = false;           // for a watch whose sign was asked for: it became positive
  std::vector<double> errors{};  // then, of every watch that was
  bool stopped = false;          // the stop signal ended it
  double lowest = 0.0;           // least value of any watch at the ends of the steps
  long long values = 0;          // of observables, taken in search of the zero
};

class StepFlow {
 public:
  static constexpr double kNoDepth = std::numeric_limits<double>::infinity();
  virtual ~StepFlow() = default;
  // Starts a smooth piece at the state and forcing phase theta; s counts from here. `depths`: of
  // the springs, m. `time`: used on a rotating hub, s.
  virtual void start(double theta, const Vector& x, std::span<const double> depths = {},
                     double time = 0.0) = 0;
  // The first watch to fall through zero within the window, s. No later instant than `until`, s,
  // will be asked for: the least value counts up to there, and a step that passes it is the last.
  // `stop` is polled: a window may have any number of steps. The largest depths of springs beyond
  // `told_depth`, m, are located (deepest).
  virtual StepDescent first_descent(std::span<const Watch* const> watches, double window,
                                    double until, const StopSignal& stop,
                                    double told_depth = kNoDepth) = 0;
  // The state s seconds after the start. Expensive where s lies before the last step.
  virtual void state(double s, Vector& x) = 0;
  // Goes through the steps once more, from the start up to `until`, s, and visits the beginning and
  // end of each, or of each part of a long one. The states within it are available meanwhile.
  virtual void each_step(double until, const std::function<void(double, double)>& visit) = 0;
  // Largest force of a spring since the start, N, and its largest depth, m, if beyond `told_depth`;
  // 0 where there is none.
  virtual double peak_force(std::size_t /*spring*/) const { return 0.0; }
  virtual double deepest(std::size_t /*spring*/) const { return 0.0; }
  // Works from the start up to s; zero unless the structure is on springs.
  virtual SprungWorks works(double /*s*/) { return {}; }
  // Number of evaluations of the right-hand side so far.
  virtual long long evaluations() const = 0;
};

}  // namespace graze
