#include <array>
#include <bit>
#include <optional>
#include <utility>

#include "graze/motion/lanes/detail/lane_motions.hpp"
#include "graze/orbit/search/detail/followed_periods.hpp"
#include "graze/orbit/search/detail/settling.hpp"
#include "graze/orbit/search/settled.hpp"
#include "graze/system/detail/gap_value.hpp"

namespace graze {
namespace {

// Motions of systems of one shape; others are followed one by one.
class SettlingMotions {
 public:
  explicit SettlingMotions(SettleTasks& tasks) : tasks_(tasks) {}

  void finish() {
    empty_ = (LaneSet{1} << kLanes) - 1;
    refill_empty();
    while (motions_ && !motions_->is_idle()) {
      const LaneArrivals arrivals = motions_->fly();
      for_each(arrivals.contacts, [&](std::size_t lane) { receive_impact(lane); });
      for_each(arrivals.ends, [&](std::size_t lane) { end_period(lane); });
      for_each(arrivals.left, [&](std::size_t lane) { follow(lane); });
    }
  }

 private:
  struct Place {
    const System* system = nullptr;
    std::optional<Settling> settling{};
    std::optional<FollowedPeriods> followed{};  // once something rare has happened
    Vector q{}, qdot{};
  };

  template <class Do>
  static void for_each(LaneSet lanes, const Do& act) {
    for (; lanes != 0; lanes &= lanes - 1) act(static_cast<std::size_t>(std::countr_zero(lanes)));
  }

  // Lanes for which there was no task at first may get one later.
  void refill_empty() {
    while (empty_ != 0 && refill(static_cast<std::size_t>(std::countr_zero(empty_))))
      empty_ &= empty_ - 1;
  }

  // Takes up tasks until one of them flies in the lane.
  bool refill(std::size_t lane) {
    Place& place = places_[lane];
    while (std::optional<SettleTask> task = tasks_.next(lane)) {
      place.followed.reset();
      place.system = task->system;
      place.settling.emplace(*task->system, task->start, std::move(task->options));
      const Settling& settling = *place.settling;
      const std::optional<LaneForm> form = lane_form(*place.system, settling.flow());
      if (form && has_shape(*place.system, *form)) {
        motions_->adopt(lane, *place.system, settling.flow(), *form, settling.closure_speed());
        place.q.resize(place.system->modes());
        place.qdot.resize(place.system->modes());
        if (begin(lane)) return true;
      } else {
        follow_to_end(place);
      }
      tasks_.take(lane, place.settling->result());
    }
    place.settling.reset();
    place.followed.reset();
    return false;
  }

  bool has_shape(const System& system, const LaneForm& form) {
    if (!motions_) motions_.emplace(system, form);
    return motions_->has_shape(system, form);
  }

  void follow_to_end(Place& place) {
    if (!place.followed) place.followed.emplace(*place.system, *place.settling);
    while (!place.settling->is_over()) place.followed->follow();
  }

  // Follows a motion from the start of a period, alone, until every stop is open. False when it is
  // over.
  bool begin(std::size_t lane) {
    Place& place = places_[lane];
    Settling& settling = *place.settling;
    if (!settling.is_over() && !place.followed) {
      const State start = settling.state();
      if (is_off(*place.system, start)) {
        motions_->begin(lane, start.q, start.qdot);
        return true;
      }
      place.followed.emplace(*place.system, settling);
      place.followed->follow();
    }
    while (!settling.is_over()) {
      if (place.followed->is_clear()) {
        const State now = settling.state();
        motions_->begin(lane, now.q, now.qdot);
        return true;
      }
      place.followed->follow();
    }
    return false;
  }

  // Whether the state is so far from every stop that rounding cannot make it touch one.
  static bool is_off(const System& system, const State& state) {
    for (const Stop& stop : system.stops) {
      const GapValue<double> gap = gap_value(stop.row, state.q, stop.gap);
      if (!(gap.value > gap.rounding)) return false;
    }
    return true;
  }

  void receive_impact(std::size_t lane) {
    Place& place = places_[lane];
    motions_->end_state(lane, place.q, place.qdot);
    if (!place.settling->add_impact(motions_->stop(lane), motions_->local(lane),
                                    motions_->speed(lane), place.q, place.qdot))
      conclude(lane);
    else if (place.settling->is_stopped(kWorkPerFlight * place.system->modes()))
      conclude(lane);
  }

  void end_period(std::size_t lane) {
    Place& place = places_[lane];
    motions_->end_state(lane, place.q, place.qdot);
    place.settling->end_period(place.q, place.qdot, {});
    if (place.settling->is_over() ||
        place.settling->is_stopped(kWorkPerFlight * place.system->modes()))
      conclude(lane);
  }

  // When a lane leaves at a rare event, the rest of the period is followed alone.
  void follow(std::size_t lane) {
    Place& place = places_[lane];
    if (!place.followed) place.followed.emplace(*place.system, *place.settling);
    place.followed->go_on_from(motions_->departure(lane, place.settling->periods()));
    place.followed->follow();
    if (!begin(lane)) conclude(lane);
  }

  void conclude(std::size_t lane) {
    motions_->drop(lane);
    tasks_.take(lane, places_[lane].settling->result());
    // Motions that are followed outside the lanes have their places, too.
    if (refill(lane))
      refill_empty();
    else
      empty_ |= LaneSet{1} << lane;
  }

  // Evaluations of a flight, about; for the stop signal.
  static constexpr long long kWorkPerFlight = 8;

  SettleTasks& tasks_;
  std::optional<LaneMotions> motions_;
  std::array<Place, kLanes> places_{};
  LaneSet empty_ = 0;  // places without a task
};

class OneTask : public SettleTasks {
 public:
  explicit OneTask(SettleTask task) : task_(std::move(task)) {}
  std::optional<SettleTask> next(std::size_t) override {
    return std::exchange(task_, std::nullopt);
  }
  void take(std::size_t, SettledMotion settled) override { motion = std::move(settled); }

  SettledMotion motion;

 private:
  std::optional<SettleTask> task_;
};

}  // namespace

void settle_side_by_side(SettleTasks& tasks) { SettlingMotions(tasks).finish(); }

SettledMotion settle_in_lane(const System& system, const State& start,
                             const SettleOptions& options) {
  OneTask task({&system, start, options});
  settle_side_by_side(task);
  return std::move(task.motion);
}

}  // namespace graze
