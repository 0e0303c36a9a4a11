// The hybrid motion, one certified arc at a time.
//
//   contact: a gap reaches zero at approach speed v = b.q' > 0; an impact is due,
//            q'+ = q'- - D p,   p >= 0,  v+ + r v- <= 0,  p.(v+ + r v-) = 0
//            over all stops touched at that instant (one stop: v+ = -r v-). A stop that is being
//            left takes no part; if thrown back onto it, the structure hits it next, at the same
//            instant. Where such impacts would never end (in the corner between two stops, hit
//            alternately and ever faster) they are summed: v+ = 0;
//   stick:   on a stop at zero speed and pushed; its contact force holds it from then on;
//   release: the first instant at which the contact force of a closed stop falls through zero;
//   entry:   a compliant stop is reached and its spring compressed from then on; nothing jumps;
//   separation: its force is gone, at the surface of the stop or below it;
//   slip, stick, reversal: of dry friction (friction_impl.hpp).
//
// Events lie at the end of the arc that leads to them; the next arc departs from its known zero of
// the gap: simple after an impact, double when pulled away from rest, triple after a release.
// Nothing depends on the order in which the stops are listed.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/held/detail/exact_phase.hpp"
#include "graze/flow/stepped/step_setting.hpp"
#include "graze/flow/turning/detail/turning_structure.hpp"

namespace graze {

// One stop's share in an impact.
template <class Real>
struct ImpactShare {
  int stop = 0;
  Real speed = 0;        // approach speed before, m/s
  Real speed_after = 0;  // and after, where the impulse is not zero, m/s
  Real impulse = 0;      // p, along the stop's direction, m/s
  bool hit = false;      // it took part by approaching
};

// A chatter whose tail was summed.
template <class Real>
struct ClosedChatter {
  std::vector<int> stops;                      // that it ends on, ascending
  std::vector<int> closed;                     // these and those that held the structure before
  Real duration = 0;                           // of the tail, s
  RealVector<Real> q_before{}, qdot_before{};  // the state that was left for rest
};

template <class Real>
class Motion {
 public:
  // Keeps a copy of `system`. Starts at `instant` with the given state; a stop whose gap is
  // zero within rounding counts as touched. `steps`: the motion between events is integrated step
  // by step, and events are looked for at the ends of the steps.
  Motion(const System& system, const Instant<Real>& instant, const RealVector<Real>& q,
         const RealVector<Real>& qdot, const std::optional<StepSetting>& steps = {});
  Motion(const System& system, const MotionState<Real>& state,
         const std::optional<StepSetting>& steps = {});
  // Goes on from this state, as a motion made from it would.
  void go_on_from(const MotionState<Real>& state);
  // A flight that is integrated step by step ends undecided once this is requested.
  void stop_on(const StopSignal& stop) { stop_ = stop; }
  // From now on depths of springs beyond this one, m, are located (StepFlow::deepest).
  void tell_depths_beyond(double depth) { told_depth_ = depth; }
  // From now on this stop is ignored; nullopt: none is.
  void leave_out(std::optional<int> stop);
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;

  // Flies from the present instant to the first event, at most up to `until` (seconds on the local
  // clock, not beyond the period's end), and moves there. The event is searched up to `horizon` >=
  // `until`: flights to different ends under one horizon agree bit for bit where they overlap.
  Arrival<Real> fly(const Real& until, const Real& horizon);
  Arrival<Real> fly(const Real& until) { return fly(until, until); }

  // Applies the impact that is due after kContact; returns the shares of all stops touched, valid
  // until the next impact.
  const std::vector<ImpactShare<Real>>& impact();

  // Right after an impact: sums the tail of a chatter if possible. It is when the last impact was
  // at no more than `closure_speed` (m/s), and the pushes outlast the tail with no other event
  // meanwhile. Then the structure is put to rest on the stop, or on the several stops that throw it
  // at each other; the error of the later motion is of second order in the speed.
  std::optional<ClosedChatter<Real>> close_chatter(const std::vector<ImpactShare<Real>>& shares,
                                                   const Real& closure_speed);
  // The same on one stop, whatever the speed, after an impact with restitution r that left at speed
  // v+, against a push a_n:
  //   duration = 2 v+/(a_n (1 - r)),   duration * |d a_n/dt| <= a_n/2.
  std::optional<ClosedChatter<Real>> close_chatter(int stop, const Real& restitution);
  // Puts the structure to rest on the several stops that throw it at each other at no more than
  // `speed` (m/s), where all of them would press; for motions in which events at such speeds take a
  // negligible time. Returns whether there are such stops.
  bool rest_together(const Real& speed);

  const Instant<Real>& instant() const { return now_.instant; }
  const RealVector<Real>& q() const { return now_.q; }
  const RealVector<Real>& qdot() const { return now_.qdot; }
  const MotionState<Real>& state() const { return now_; }
  // The state from which the last arc was flown: a motion made from it flies the same arc again.
  const MotionState<Real>& departure() const { return departure_; }
  // Whether an event of the present instant (impact, sticking, release) is still to be decided or
  // reported.
  bool has_pending_events() const { return undecided_ || !changes_.empty(); }
  bool is_closed(int stop) const { return contact(stop) == Contact::kClosed; }
  // Whether a stop is closed.
  bool is_closed_anywhere() const { return !closed().empty(); }
  // Whether a spring is compressed.
  bool is_sprung() const { return !springs().empty(); }
  // The force of a compressed spring at the present instant, N; 0 when it is not compressed.
  Real spring_force(int stop) const;
  // Energy stored in the spring, J; 0 at the surface.
  double spring_energy(int stop) const;
  const std::string& refusal() const { return refusal_; }
  // Evaluations of the equations of motion, by a motion integrated step by step.
  long long step_evaluations() const;
  // The clock: forcing period and phase.
  const ExactFlow<Real>& flow() const { return clock_; }
  // The last phase flown and its arc, from its own start.
  const ContactPhase<Real>& flown() const { return *flown_; }
  // The gap at a stop along the arc that starts now, for `window` seconds; valid until it is flown.
  const ArcCurve<Real>& gap_ahead(int stop, const Real& window);
  // Force between structure and stop at the present instant, N; 0 where it is open.
  Real contact_force(int stop) { return is_closed(stop) ? force(stop) : spring_force(stop); }
  // Whether what rubs behind a spring follows its place.
  bool follows(int friction) const {
    return system_.friction(friction).series && !is_closed(friction) &&
           contact(friction) != Contact::kClear;
  }
  // What dry friction exerts along -u at the present instant, N.
  Real friction_force(int friction) {
    if (is_closed(friction)) return force(friction);
    const Real sliding = rubbing_force(friction, false);
    return pushes(friction, true) ? sliding : pushes(friction, false) ? Real(-sliding) : Real(0);
  }
  // Contact force of a closed stop at the present instant, N.
  Real force(int stop) { return start_phase().force_at(stop, Real(0), now_.q, now_.qdot); }
  // gap - row.q at the present instant.
  Real gap(int stop) const;
  // Approach speed row.q' at the present instant.
  Real approach_speed(int stop) const;

 private:
  using Matrix_ = RealMatrix<Real>;
  // A stop of the system in the scalar of the motion.
  struct MetStop {
    RealVector<Real> row, direction;
    Real gap = 0;
    Real norm = 0;   // |row|
    Real norm2 = 0;  // |row|^2 where the direction is row/|row|^2 to rounding; 0: it is oblique
    const Stop* given = nullptr;  // of system_; null: it is dry friction
    Real belt = 0;                // m/s, speed at which that is at rest

    bool is_compliant() const { return given && given->is_compliant(); }
    const Restitution& restitution() const { return given->restitution(); }
    const ContactForce& force() const { return given->force(); }
  };
  struct Change {
    ArrivalKind kind;
    int stop;
  };
  // What an event has changed abruptly, for the other contacts to be decided again.
  enum class Jumped { kVelocities, kForces };
  void adopt_system();
  const MetStop& stop(int i) const { return stops_[static_cast<std::size_t>(i)]; }
  Contact contact(int i) const { return now_.contacts[static_cast<std::size_t>(i)]; }
  int multiplicity(int i) const { return now_.multiplicities[static_cast<std::size_t>(i)]; }
  bool is_held(int i) const {
    return contact(i) == Contact::kClosed || contact(i) == Contact::kLocked;
  }
  void set(int i, Contact contact, int multiplicity = 0);
  // Bound on the rounding of the approach speed, m/s.
  Real speed_rounding(int i) const;
  RealVector<Real> free_acceleration(RealVector<Real>* size = nullptr) const;
  // The same on a rotating hub, under the torque of the present instant.
  RealVector<Real> turning_acceleration(RealVector<Real>* size) const;
  RealVector<Real> accelerated(const RealVector<Real>& force) const;
  void hold_joint(RealVector<Real>& acceleration) const;
  Real hub_rate(const RealVector<Real>& rates) const;
  Matrix_ pressing(const std::vector<int>& stops) const;
  // Sets the directions of impulses for the present shape on a rotating hub.
  void turn_directions();
  Real free_acceleration(Eigen::Index mode, const Real& cosine, Real* size) const;
  Real forcing_cosine() const;
  // Speed, m/s, at which a motion integrated step by step cannot leave a stop that it is pushed on.
  Real unseen_speed(int stop) const;
  // row.q'' without any stop, m/s^2.
  Real free_push(int stop) const;
  // Bound on the rounding of a push row.q'', by the size of its terms, m/s^2.
  Real push_rounding(int i, const RealVector<Real>& size) const;
  bool touches(int i) const;
  bool is_touched(int i) const;
  bool is_leaving(int i) const;
  std::vector<int> closed() const;  // stops
  std::vector<int> held() const;    // and frictions that stick
  bool holds_anywhere() const;
  ContactPhase<Real>& phase_of(std::vector<int> closed);
  void forget_phase();
  PhaseSprings springs() const;
  Real depth(int stop) const;
  void begin_springs();
  void decide_moving_springs();
  void decide_resting_springs();
  std::vector<bool> moving_modes() const;
  bool is_moved(int stop, const std::vector<bool>& moves) const;
  void be_sure_of(int stop, const Real& time);
  void compress(int stop);
  void judge_again(Jumped what);
  void arrive_at_spring(Arrival<Real>& arrival);
  // Adds the acceleration by the compressed springs.
  void add_spring_forces(RealVector<Real>& acceleration, RealVector<Real>* size) const;
  ContactPhase<Real>& start_phase();
  void start_at_now(ContactPhase<Real>& phase) const;

  // D: how the impulse of each of these stops acts on the approach speed at each.
  Matrix_ delassus(const std::vector<int>& stops) const;
  // q' -= amount d
  void push_back(const MetStop& stop, const Real& amount);
  // q' -= sum_i amounts_i d_i
  void push_back_from(const std::vector<int>& stops, const RealVector<Real>& amounts);

  std::optional<Arrival<Real>> decide();
  std::optional<Arrival<Real>> decide_rigid();
  bool decide_resting(const std::vector<int>& resting);
  std::vector<int> decide_degenerate(std::vector<int> held, std::vector<int> stops);
  void ask_the_motion();
  void tell_forces(Arrival<Real>& arrival);
  std::vector<int> untold() const;
  void rest_untold(int stop);
  void ask_again();
  void vanish_together(const Real& flight);
  RealVector<Real> located_size() const;
  void let_loose(int stop, int multiplicity);
  void hold(int stop);
  void let_go(int stop, int multiplicity);
  Real quickest_rate() const;
  void rest_on_closed();
  RealVector<Real> parts_of(int stop, const std::vector<int>& list) const;
  bool is_independent(int stop, const std::vector<int>& of) const;

  // The stops touched at this instant: approach speeds (m/s; 0 where closed), their rounding, and
  // D.
  struct Touched {
    std::vector<int> stops;
    RealVector<Real> speed, rounding;
    Matrix_ acting;
  };
  // An impact at each of them: the speed after it where it acts, and p; m/s.
  struct Jump {
    RealVector<Real> target, impulse;
  };
  static bool is_left(const Touched& touched, Eigen::Index a) {
    return touched.speed[a] < -touched.rounding[a];
  }
  Touched touched_stops() const;
  // The impact on the stops that are approached or at rest.
  Jump jump_of(const Touched& touched) const;
  // Whether that throws the structure back onto a stop that it is leaving.
  bool drives_back(const Touched& touched, const Jump& jump) const;
  // Whether impacts at this instant then follow each other without end, down to rest.
  bool comes_to_rest(Touched touched) const;
  // The stop of an impact that involves it alone; -1: others are touched or held too.
  int lone_stop() const;
  void impact_alone(int stop);
  void impact_together();
  void apply(const std::vector<int>& touched, const RealVector<Real>& target,
             RealVector<Real>& impulse);
  bool is_quiet(const ContactPhase<Real>& phase, const std::vector<int>& chattering,
                const Real& duration);
  bool is_quiet_meanwhile(int stop, const Real& duration);
  Real resolved_speed() const;
  bool may_be_unresolved(const Real& speed) const;
  std::vector<int> chattering_together(const Real& closure_speed) const;
  std::optional<ClosedChatter<Real>> close_shared(const Real& closure_speed);
  std::pair<RealVector<Real>, RealVector<Real>> at_rest_on(const std::vector<int>& stops) const;
  ClosedChatter<Real> settled(const std::vector<int>& stops, const Real& duration);
  static int first_of(const ContactPhase<Real>& phase);
  Arrival<Real> stay();
  Arrival<Real> search(const Real& until, const Real& horizon);
  // The shares of stops, then of friction at rest, in pushes, m/s^2: forces, accelerations that are
  // left, the rounding of pushes, and of shares too; what is left of the limits of friction.
  struct PushShares {
    RealVector<Real> forces, into, rounding, own, acting, left;
    bool presses(Eigen::Index a) const { return forces[a] * own[a] > rounding[a]; }
  };
  std::optional<PushShares> share_pushes(const std::vector<int>& stops);
  std::optional<PushShares> share_among(const std::vector<int>& stops, std::vector<int> standing);
  std::optional<PushShares> solve_pushes(const std::vector<int>& stops,
                                         const std::vector<int>& standing) const;
  std::vector<int> pressed_of(const std::vector<int>& stops, const PushShares& shares) const;
  void rest_on(const std::vector<int>& stops, const std::vector<int>& standing,
               const PushShares& shares);
  void adopt_frictions();
  std::size_t place(int friction) const {
    return static_cast<std::size_t>(friction) - system_.stops.size();
  }
  // Whether something presses there, and the force of sliding or its limit then, N.
  bool is_pressed(int friction) const {
    const int at = system_.friction(friction).stop;
    return at < 0 || contact(at) == Contact::kCompressed;
  }
  Real rubbing_force(int friction, bool at_rest) const {
    const Friction& one = system_.friction(friction);
    const Real part = Real(at_rest ? one.sticking : one.sliding);
    return one.stop < 0 ? part : Real(part * spring_force(one.stop));
  }
  // Whether it exerts its force of sliding against that direction.
  bool pushes(int friction, bool forward) const {
    return contact(friction) == (forward ? Contact::kForward : Contact::kBackward) ||
           (contact(friction) == Contact::kLocked &&
            multiplicity(friction) == (forward ? kCameForward : kCameBackward));
  }
  double spring_length(int friction) const;
  void note_series();
  void follow(int friction);
  void begin_series(int friction);
  void judge_series(int friction, Jumped what);
  void press_frictions(int stop, Contact before);
  RealVector<Real> pushing(int stop) const;
  void note_rubbing();
  void renew_places();
  void slide(int friction, bool forward, int multiplicity);
  void start_sliding(int friction, bool forward);
  Real sliding_rounding(int friction) const;
  void judge_frictions(Jumped what);
  void stand(int friction);
  void stick(int friction, const std::vector<int>& beside);
  void lean(int friction, bool forward);
  void unlock_frictions();
  void arrive_at_standstill(int friction, bool at_once);
  bool arrive_at_slip(int friction, bool forward);
  std::optional<int> stands_in(int friction, bool forward) const;
  bool has_friction() const { return turning_ && system_.rotation()->friction; }
  void set_joint(Joint joint);
  void look_at_joint();
  bool turns_on(const Real& duration) const;
  void stop_joint();
  void arrive_at_joint(bool forward);
  void land(const Real& flight);
  Arrival<Real> arrive(Arrival<Real> arrival, const Real& until);
  void settle_on(int stop, const Real& flight);
  bool settle_among_closed(int stop, const RealVector<Real>& weights);
  void touch_simultaneous(const Real& flight);
  bool is_back_at_once(const Arrival<Real>& arrival) const;
  void fail_audit(int stop, std::string what);
  Real passing_rounding(int stop, const Real& flight) const;
  Real pushing_rounding(int stop, const Real& flight) const;
  void audit_gaps(const Real& flight);
  void audit_forces();
  bool pulls() const;
  Real kinetic_square() const;
  void audit_impact(const Real& before);

  const System system_;
  const std::optional<StepSetting> steps_;
  StopSignal stop_;
  double told_depth_ = std::numeric_limits<double>::infinity();
  ExactFlow<Real> clock_;
  LinearSystem<Real> linear_;
  mutable std::optional<TurningStructure> turning_;
  std::vector<MetStop> stops_;
  // Rigid stops in an order that does not depend on their listing; then the compliant ones.
  std::vector<int> order_, compliant_, all_;
  std::optional<int> left_out_;
  std::vector<int> looked_at_;  // all but that
  std::vector<int> frictions_;  // after the stops
  bool on_belts_ = false;       // some of them
  std::vector<int> watched_;    // both
  RealVector<Real> rubbing_;    // force of what slides; empty without friction
  MotionState<Real> now_, departure_;
  struct KeptPhase {
    std::unique_ptr<ContactPhase<Real>> phase;
    long long asked = 0;  // when it was asked for last, counted
  };
  std::map<PhaseKey, KeptPhase> phases_;
  long long asked_ = 0, forgotten_evaluations_ = 0;
  ContactPhase<Real>* phase_ = nullptr;  // of the closed stops; null until it is looked up
  ContactPhase<Real>* flown_ = nullptr;
  std::vector<Real> sure_;        // be_sure_of(), of every stop; empty: nothing is known
  RealVector<Real> sure_speeds_;  // velocities at the start of that flight
  bool undecided_ = false;        // some stop is touching
  bool recheck_ = false;          // closed stops have felt an impulse
  Real vanished_ = 0;             // s, duration of the flight at whose end forces of closed stops
                                  // vanished
  std::vector<int> entered_;      // springs at whose surface the structure is at this instant
  std::vector<int> not_told_;     // stops that are held while no derivative shows whether they
                                  // press
  std::vector<Change> changes_;
  std::vector<ImpactShare<Real>> shares_;  // of the last impact
  int arrivals_at_once_ = 0;               // arrivals without flight in a row
  bool eventful_ = false;                  // something has happened since the last flight
  std::optional<Arrival<Real>> broken_;    // by what the audit found
  std::string refusal_;
};

}  // namespace graze
