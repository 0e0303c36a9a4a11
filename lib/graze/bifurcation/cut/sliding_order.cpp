#include "graze/bifurcation/cut/detail/sliding_order.hpp"

#include <algorithm>
#include <limits>

namespace graze {
namespace {

double turned(const OrbitRubbing& event) { return event.at.phase + kTurn * event.at.period_index; }

// The events of one friction.
std::vector<OrbitRubbing> events_of(const Orbit& orbit, int friction) {
  std::vector<OrbitRubbing> list;
  std::copy_if(orbit.rubbing.begin(), orbit.rubbing.end(), std::back_inserter(list),
               [&](const OrbitRubbing& event) { return event.friction == friction; });
  return list;
}

int frictions_in(const Orbit& orbit) {
  int count = 0;
  for (const OrbitRubbing& event : orbit.rubbing) count = std::max(count, event.friction + 1);
  return count;
}

bool are_alike(const std::vector<OrbitRubbing>& a, const std::vector<OrbitRubbing>& b) {
  if (a.size() != b.size()) return false;
  const std::size_t n = a.size();
  for (std::size_t turn = 0; turn < std::max<std::size_t>(n, 1); ++turn) {
    bool same = true;
    for (std::size_t i = 0; i < n && same; ++i) same = a[i].what == b[(i + turn) % n].what;
    if (same) return true;
  }
  return false;
}

}  // namespace

// Events of different frictions may change places: nothing happens where they do.
bool has_same_sliding(const Orbit& a, const Orbit& b) {
  const int frictions = std::max(frictions_in(a), frictions_in(b));
  for (int k = 0; k < frictions; ++k)
    if (!are_alike(events_of(a, k), events_of(b, k))) return false;
  return true;
}

namespace {

// The shortest piece of sliding or sticking, rad, and what it is that begins to exist with it.
struct ShortestPiece {
  double lasts = std::numeric_limits<double>::infinity();
  SpecialKind kind = SpecialKind::kSwitchingSliding;
};

ShortestPiece shortest_piece(const Orbit& orbit) {
  double shortest = std::numeric_limits<double>::infinity();
  SpecialKind kind = SpecialKind::kSwitchingSliding;
  for (int k = 0; k < frictions_in(orbit); ++k) {
    const std::vector<OrbitRubbing> events = events_of(orbit, k);
    const std::size_t n = events.size();
    for (std::size_t i = 0; i < n; ++i) {
      const OrbitRubbing &here = events[i], &next = events[(i + 1) % n];
      const double whole = kTurn * orbit.period;
      double lasts = turned(next) - turned(here);
      if (lasts < 0.0 || n == 1) lasts += whole;
      if (!(lasts < shortest)) continue;
      shortest = lasts;
      const Rubs before = events[(i + n - 1) % n].what;
      const bool rests = here.what == Rubs::kSticks;
      kind =
          rests
              ? (before == next.what ? SpecialKind::kGrazingSliding : SpecialKind::kCrossingSliding)
          : before == Rubs::kSticks && next.what == Rubs::kSticks ? SpecialKind::kAddingSliding
                                                                  : SpecialKind::kSwitchingSliding;
    }
  }
  return {shortest, kind};
}

}  // namespace

SpecialKind kind_of_change(const Orbit& orbit) { return shortest_piece(orbit).kind; }

// Fall and piece vanish with the root of the distance along a branch.
std::optional<SpecialKind> what_hardly_lasts(const Orbit& orbit) {
  constexpr double kHardly = 1e-2;
  const bool falls = std::any_of(
      orbit.rubbing.begin(), orbit.rubbing.end(),
      [](const OrbitRubbing& event) { return event.fall > 0.0 && event.fall < kHardly; });
  if (falls) return SpecialKind::kGrazingSliding;
  const ShortestPiece piece = shortest_piece(orbit);
  return piece.lasts < kHardly ? std::optional(piece.kind) : std::nullopt;
}

}  // namespace graze
