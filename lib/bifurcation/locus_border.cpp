#include "graze/bifurcation/locus_border.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace graze {
namespace {

// An impact is born with the root of the distance to its grazing, at most: what the bracket leaves
// of it, of a speed, with some room.
constexpr double kBorn = 1e-2;
// Where an impact is this slow, of a speed, the grazing is some 1e-5 of the range away, and steps
// have shrunk to less.
constexpr double kSlow = 5e-3;

std::vector<int> holds_of(const Itinerary& itinerary) {
  std::vector<int> holds;
  std::ranges::copy_if(itinerary.events, std::back_inserter(holds),
                       [](int event) { return event < 0; });
  return holds;
}

}  // namespace

std::optional<OrbitLocusEnd> locus_end_between(const Itinerary& before, const Itinerary& now,
                                               double speed) {
  if (holds_of(before) != holds_of(now)) return OrbitLocusEnd::kChatterCompletes;
  const bool same = before.events == now.events;
  const bool born = now.events.size() > before.events.size();
  const bool grazes = same ? now.slowest <= kSlow * speed && now.slowest < before.slowest
                           : (born ? now : before).slowest <= kBorn * speed;
  return grazes ? std::optional(OrbitLocusEnd::kGrazing) : std::nullopt;
}

bool grazes_at(const Passage& passage, const Itinerary& itinerary, const MotionScale& scale) {
  const std::optional<double> clearance = passage.clearance();
  return itinerary.slowest <= kBorn * scale.speed ||
         (clearance && *clearance <= kLocusBracket * scale.length);
}

}  // namespace graze
