#include "graze/orbit/passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "graze/base/linear_equations.hpp"
#include "graze/flow/contact_share.hpp"
#include "graze/hybrid/clearance.hpp"
#include "graze/hybrid/next_flight.hpp"
#include "graze/orbit/shooting.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

void note_smallest(std::optional<double>& smallest, const std::optional<double>& value) {
  if (value && (!smallest || *value < *smallest)) smallest = value;
}

class Follower {
 public:
  Follower(const System& system, const MotionState<double>& start, const Instant<double>& end,
           const PassageOptions& options, Deviations* deviations, ParameterDeviation* parameter)
      : system_(system),
        end_(end),
        options_(options),
        deviations_(deviations),
        parameter_(parameter),
        motion_(system, start),
        longest_flight_(longest_flight(system)) {
    for (std::size_t i = 0; i < start.contacts.size(); ++i)
      if (start.contacts[i] == Contact::kClosed)
        open_hold(static_cast<int>(i), start.instant, true);
  }

  Passage follow() {
    while (proceed()) {
    }
    for (PassedHold& hold : holding_) {
      hold.to = motion_.instant();
      hold.to_end = true;
      passage_.holds.push_back(hold);
    }
    passage_.end = motion_.state();
    if (deviations_ && passage_.failure.empty())
      move_instant(*deviations_, rate_now(closed_now()), -deviations_->delay);
    if (parameter_ && passage_.failure.empty()) parameter_->end(rate_now(closed_now()));
    return std::move(passage_);
  }

 private:
  const RigidStop& stop(int i) const { return system_.stops[static_cast<std::size_t>(i)]; }

  bool fail(std::string sentence) {
    passage_.failure = std::move(sentence);
    return false;
  }

  std::vector<int> closed_now() const {
    std::vector<int> closed;
    for (std::size_t i = 0; i < system_.stops.size(); ++i)
      if (motion_.is_closed(static_cast<int>(i))) closed.push_back(static_cast<int>(i));
    return closed;
  }

  State state_now() const { return {motion_.q(), motion_.qdot()}; }

  State rate_now(const std::vector<int>& closed) const {
    return held_rate(system_, closed, {motion_.q(), motion_.qdot()},
                     motion_.flow().phase(motion_.instant()));
  }

  // One flight or one change; false when the passage is over.
  bool proceed() {
    const Instant<double> start = motion_.instant();
    if (motion_.has_news()) {
      const Arrival<double> news = motion_.fly(start.local);
      if (deviations_ && news.kind == ArrivalKind::kContact)
        meet(news, stop(news.stop).row.transpose() * deviations_->q, closed_now());
      if (parameter_ && news.kind == ArrivalKind::kContact)
        parameter_->meet_at_once(news.stop, state_now(), rate_now(closed_now()), news.speed);
      return receive(news);
    }
    if (tail_ && not_before(start, tail_->over)) announce_tail();
    if (not_before(start, end_)) return false;
    if ((++polls_ & 255) == 0 && options_.stop.requested())
      return fail("stopped before the orbit was found");
    const NextFlight flight = next_flight(motion_, end_, tail_, longest_flight_);
    const Arrival<double> arrival = motion_.fly(flight.until, flight.horizon);
    if (arrival.kind == ArrivalKind::kNotFinite || arrival.kind == ArrivalKind::kRefused)
      return receive(arrival);
    const std::vector<int>& closed = motion_.flown().closed();
    if (options_.flight) options_.flight(motion_.flown(), start, arrival.flight);
    if (options_.minima && arrival.flight > 0.0) note_minima(arrival.flight);
    if (options_.along && arrival.flight > 0.0) note_approaches(arrival.flight);
    if (deviations_) carry(arrival, closed);
    if (parameter_) carry_parameter(arrival, closed);
    return receive(arrival);
  }

  Contact contact_at_departure(int i) const {
    return motion_.departure().contacts[static_cast<std::size_t>(i)];
  }

  bool departed_from(int i) const { return contact_at_departure(i) != Contact::kClear; }

  // Deviations along the flight; at a contact, to the deviated motion's own contact.
  void carry(const Arrival<double>& arrival, const std::vector<int>& closed) {
    hold(system_, closed, *deviations_);
    const Deviations change = growth(motion_.flown(), arrival.flight, *deviations_);
    Eigen::RowVectorXd reach(deviations_->count());
    if (arrival.kind == ArrivalKind::kContact) {
      const RigidStop& s = stop(arrival.stop);
      reach = s.row.transpose() * change.q;
      // A flight that left this stop left it with b.dq = 0, as an identity.
      if (!departed_from(arrival.stop)) reach += s.row.transpose() * deviations_->q;
    }
    deviations_->q += change.q;
    deviations_->qdot += change.qdot;
    if (arrival.kind == ArrivalKind::kContact) meet(arrival, reach, closed);
  }

  void carry_parameter(const Arrival<double>& arrival, const std::vector<int>& closed) {
    const MotionState<double>& start = motion_.departure();
    parameter_->carry(motion_.flown(), {start.q, start.qdot}, motion_.flow().phase(start.instant),
                      arrival.flight);
    if (arrival.kind == ArrivalKind::kContact)
      parameter_->meet(arrival.stop, state_now(), rate_now(closed), arrival.speed,
                       departed_from(arrival.stop));
  }

  // `reach`: b.dq at the undeviated contact.
  void meet(const Arrival<double>& arrival, const Eigen::RowVectorXd& reach,
            const std::vector<int>& closed) {
    const RigidStop& s = stop(arrival.stop);
    move_instant(*deviations_, rate_now(closed), -reach / arrival.speed);
    deviations_->q -= s.row * (s.row.transpose() * deviations_->q) / s.row.squaredNorm();
  }

  // The stops that the flight flown last moved clear of.
  std::vector<int> open_stops() const {
    std::vector<int> open;
    for (int i = 0; i < static_cast<int>(system_.stops.size()); ++i)
      if (contact_at_departure(i) != Contact::kClosed &&
          contact_at_departure(i) != Contact::kLocked)
        open.push_back(i);
    return open;
  }

  int multiplicity(int i) const {
    return motion_.departure().multiplicities[static_cast<std::size_t>(i)];
  }

  void note_minima(double flight) {
    const ContactPhase<double>& phase = motion_.flown();
    for (const int i : open_stops())
      note_smallest(passage_.clearance,
                    smallest_minimum(phase.gap(i, flight, departed_from(i)), multiplicity(i)));
    for (PassedHold& hold : holding_)
      if (contact_at_departure(hold.stop) == Contact::kClosed)
        note_smallest(hold.smallest_force, smallest_minimum(phase.force(hold.stop, flight)));
  }

  // The approaches of a flight to the open stops. The time of a minimum does not matter to its gap
  // to first order, so neither do the delays of the deviations there.
  void note_approaches(double flight) {
    const ContactPhase<double>& phase = motion_.flown();
    for (const int i : open_stops())
      for (const GapMinimum& minimum :
           minima_below(phase.gap(i, flight, departed_from(i)), multiplicity(i),
                        std::numeric_limits<double>::infinity()))
        passage_.approaches.push_back(
            {i, passage_.impacts.size(), minimum.s, minimum.gap, gap_rate(i, minimum.s)});
  }

  // How the gap at a stop, s after the departure, moves along the direction.
  double gap_rate(int i, double s) const {
    const PassageDirection& along = *options_.along;
    const MotionState<double>& departure = motion_.departure();
    Deviations one{deviations_->q * along.deviations, deviations_->qdot * along.deviations,
                   deviations_->delay * along.deviations};
    hold(system_, motion_.flown().closed(), one);
    ParameterDeviation by_parameter = *parameter_;
    by_parameter.carry(motion_.flown(), {departure.q, departure.qdot},
                       motion_.flow().phase(departure.instant), s);
    const Vector q =
        one.q + growth(motion_.flown(), s, one).q + along.parameter * by_parameter.value().q;
    State there{Vector(system_.modes()), Vector(system_.modes())};
    motion_.flown().state(s, there.q, there.qdot);
    const RigidStop& rate = along.tangent->stops[static_cast<std::size_t>(i)];
    return along.parameter * (rate.gap - rate.row.dot(there.q)) - stop(i).row.dot(q);
  }

  // How the speed of an impact moves, the deviations being those at the contact.
  double speed_rate(int i, const State& before) const {
    const PassageDirection& along = *options_.along;
    const RigidStop& rate = along.tangent->stops[static_cast<std::size_t>(i)];
    return stop(i).row.dot(deviations_->qdot * along.deviations) +
           along.parameter *
               (stop(i).row.dot(parameter_->value().qdot) + rate.row.dot(before.qdot));
  }

  bool receive(const Arrival<double>& arrival) {
    switch (arrival.kind) {
      case ArrivalKind::kTime:
      case ArrivalKind::kTouch:
        return true;
      case ArrivalKind::kContact:
        return impact();
      case ArrivalKind::kStick:
        if (!(tail_ && tail_->holds(arrival.stop)))
          open_hold(arrival.stop, motion_.instant(), false);
        return true;
      case ArrivalKind::kEntry:
      case ArrivalKind::kSeparation:
      case ArrivalKind::kLeft:
        return fail("what a compliant stop does to small deviations is not followed");
      case ArrivalKind::kRelease:
        close_hold(arrival.stop);
        return true;
      case ArrivalKind::kUndecided:
      case ArrivalKind::kNotFinite:
      case ArrivalKind::kRefused:
        return fail(failure_of(motion_, arrival));
    }
    return false;
  }

  bool impact() {
    const State before = state_now();
    const std::vector<ImpactShare<double>> shares = motion_.impact();
    int hits = 0;
    for (const ImpactShare<double>& share : shares) {
      if (!share.hit) continue;
      ++hits;
      ++impacts_;
      passage_.impacts.push_back({share.stop, motion_.instant(), share.speed, before,
                                  options_.along ? speed_rate(share.stop, before) : 0.0});
    }
    if (impacts_ > options_.max_impacts)
      return fail(fmt::format("the budget of {} impacts was spent", options_.max_impacts));
    if ((deviations_ || parameter_) && hits > 1)
      return fail("two stops are hit at one instant: the map has no derivative there");
    if (deviations_) jump(shares);
    if (parameter_) parameter_->jump(shares, before.qdot);
    close_chatter(shares);
    return true;
  }

  // The derivative of q'+ = q'- - D (B^T D)^-1 (v- - target) over the stops that act.
  void jump(const std::vector<ImpactShare<double>>& shares) {
    std::vector<int> acting;
    Vector slopes(static_cast<Eigen::Index>(shares.size()));
    for (const ImpactShare<double>& share : shares) {
      if (!(share.impulse > 0.0)) continue;
      // A closed stop takes up what comes; so does one that leaves no room for a rebound.
      slopes[static_cast<Eigen::Index>(acting.size())] =
          share.speed_after < 0.0 ? jump_slope(stop(share.stop), share.speed) : 1.0;
      acting.push_back(share.stop);
    }
    undo(acting, slopes.head(static_cast<Eigen::Index>(acting.size())), deviations_->qdot);
  }

  // Takes these parts of what the stops see of the columns out of them, along the impulses.
  void undo(const std::vector<int>& stops, const Vector& parts, Matrix& columns) const {
    if (columns.cols() == 0) return;
    const Matrix rows = rows_of(system_, stops), directions = directions_of(system_, stops);
    const Matrix undone = parts.asDiagonal() * (rows.transpose() * columns);
    columns -= directions * LuFactors(rows.transpose() * directions).solve_columns(undone);
  }

  void close_chatter(const std::vector<ImpactShare<double>>& shares) {
    const State before = state_now();
    const auto closed = motion_.close_chatter(shares, options_.closure_speed);
    if (!closed) return;
    if (deviations_) {
      const Vector all = Vector::Ones(static_cast<Eigen::Index>(closed->closed.size()));
      undo(closed->closed, all, deviations_->q);
      undo(closed->closed, all, deviations_->qdot);
    }
    if (parameter_) parameter_->close(closed->closed, before);
    tail_ = tail_of(motion_, *closed);
  }

  void announce_tail() {
    const std::vector<int> stops = tail_->stops;
    tail_.reset();
    for (const int i : stops)
      if (motion_.is_closed(i)) open_hold(i, motion_.instant(), false);
  }

  void open_hold(int i, const Instant<double>& from, bool from_start) {
    holding_.push_back({i, from, from, from_start, false, motion_.force(i), {}});
  }

  void close_hold(int i) {
    if (tail_ && tail_->holds(i)) tail_.reset();
    const auto held = std::find_if(holding_.begin(), holding_.end(),
                                   [i](const PassedHold& hold) { return hold.stop == i; });
    if (held == holding_.end()) return;
    held->to = motion_.instant();
    passage_.holds.push_back(*held);
    holding_.erase(held);
  }

  const System& system_;
  const Instant<double> end_;
  const PassageOptions& options_;
  Deviations* deviations_;
  ParameterDeviation* parameter_;
  Motion<double> motion_;
  std::vector<PassedHold> holding_;
  double longest_flight_;  // s
  std::optional<ChatterTail> tail_;
  long long polls_ = 0, impacts_ = 0;
  Passage passage_;
};

}  // namespace

Passage pass(const System& system, const MotionState<double>& start, const Instant<double>& end,
             const PassageOptions& options, Deviations* deviations, ParameterDeviation* parameter) {
  return Follower(system, start, end, options, deviations, parameter).follow();
}

}  // namespace graze
