#include "graze/orbit/search/detail/followed_periods.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace graze {
namespace {

// The walk has no end of its own: the settling decides once a period.
constexpr Instant<double> kNoEnd{std::numeric_limits<long long>::max(), 0.0};

}  // namespace

FollowedPeriods::FollowedPeriods(const System& system, Settling& settling)
    : system_(system),
      settling_(settling),
      motion_(system, {settling.periods(), 0.0}, settling.state().q, settling.state().qdot) {
  motion_.stop_on(settling.options().stop);
  walk_.emplace(system_, motion_, settling.closure_speed(), Tails::kUntold);
}

void FollowedPeriods::go_on_from(const MotionState<double>& state) {
  motion_.go_on_from(state);
  walk_.emplace(system_, motion_, settling_.closure_speed(), Tails::kUntold);
}

bool FollowedPeriods::is_clear() const {
  const std::vector<Contact>& contacts = motion_.state().contacts;
  return std::all_of(contacts.begin(), contacts.end(),
                     [](Contact contact) { return contact == Contact::kClear; });
}

void FollowedPeriods::follow() {
  const bool closed = motion_.is_closed_anywhere(), sprung = motion_.is_sprung();
  contacts_ = {closed || sprung || !system_.frictions.empty(), closed, sprung, closed};
  if (follow_to_end()) settling_.end_period(motion_.q(), motion_.qdot(), contacts_);
}

// Returns false when the motion could not be followed to the end of the period.
bool FollowedPeriods::follow_to_end() {
  for (;;) {
    const WalkStep step = walk_->next(kNoEnd);
    if (step == WalkStep::kDeparture) {
      // A period can hold any number of flights, and an instant as many changes as stops, each of
      // which costs a loop over all stops.
      work_ += static_cast<long long>(system_.stops.size());
      if (settling_.is_stopped(std::exchange(work_, 0))) return false;
    } else if (step == WalkStep::kFlight) {
      work_ += (1 + walk_->arrival().evaluations) * system_.modes();
      // What happens at the very end of a period belongs to the next one.
      if (motion_.instant().period > settling_.periods()) return true;
    } else if (!receive(step)) {
      return false;
    }
  }
}

bool FollowedPeriods::receive(WalkStep step) {
  const double local = motion_.instant().local;
  switch (step) {
    case WalkStep::kImpact:
      contacts_.held = false;
      return settling_.add_impact(walk_->arrival().stop, local, walk_->arrival().speed, motion_.q(),
                                  walk_->qdot_before());
    case WalkStep::kStick:
      contacts_.any = contacts_.closed = true;
      return true;
    case WalkStep::kEntry:
      contacts_.any = contacts_.sprung = true;
      contacts_.held = false;
      // A spring that grips again below the surface, on its way out, is no new impact.
      if (motion_.approach_speed(walk_->stop()) < 0.0) return true;
      return settling_.add_impact(walk_->stop(), local, motion_.approach_speed(walk_->stop()),
                                  motion_.q(), motion_.qdot());
    case WalkStep::kRelease:
      contacts_.held = false;
      return true;
    case WalkStep::kFailure:
      if (walk_->arrival().kind != ArrivalKind::kUndecided || !settling_.was_stopped())
        settling_.refuse(walk_->failure());
      return false;
    case WalkStep::kDeparture:
    case WalkStep::kFlight:
    case WalkStep::kChatter:
    case WalkStep::kSeparation:
    case WalkStep::kLeft:
    case WalkStep::kTouch:
    case WalkStep::kFriction:
    case WalkStep::kEnd:
      break;
  }
  return true;
}

}  // namespace graze
