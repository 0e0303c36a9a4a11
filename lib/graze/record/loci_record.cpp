#include "graze/record/detail/loci_record.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze {
namespace {

// "LP and PD"
std::string names_of(const std::vector<OrbitLocusKind>& kinds) {
  std::string names;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (i > 0) names += i + 1 == kinds.size() ? " or " : ", ";
    names += label_of(kinds[i]);
  }
  return names;
}

}  // namespace

Outcome loci_outcome(const OrbitLoci& traced, const LociOptions& options) {
  if (traced.stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped; the loci traced so far are kept"};
  if (traced.stopped == StopReason::kOutOfTime)
    return {"budget", "the budget of computing time was spent; the loci traced so far are kept"};
  std::string missing;
  const auto add = [&](int count, const char* one, const char* several, const std::string& what) {
    if (count > 0)
      missing += fmt::format("{}{} {} {}", missing.empty() ? "" : ", ", count,
                             count == 1 ? one : several, what);
  };
  add(traced.cut_short, "locus", "loci", "could not be followed to an end");
  add(traced.lost_starts, "special point", "special points",
      "led to no locus that could be solved for");
  add(traced.traces_cut_short, "branch", "branches",
      "on the slices could not be followed to an end");
  if (!missing.empty()) return {"budget", missing + ": loci may be missing or cut short"};
  if (traced.loci.empty() && options.start)
    return {"no_orbit", "no locus goes on from the special point"};
  if (traced.loci.empty())
    return {"no_orbit", fmt::format("no {} of ({}, {}) orbits was met on {} slices of the plane",
                                    names_of(options.kinds), options.branches.period,
                                    options.branches.impacts, traced.slices)};
  return {"complete", ""};
}

Outcome regions_outcome(const StableRegions& regions, const Outcome& loci) {
  const std::size_t all = regions.places.size();
  const std::string kept = fmt::format("{} of {} places are kept", regions.finished, all);
  if (loci.name == "interrupted" || regions.stopped == StopReason::kInterrupted)
    return {"interrupted", "stopped; the loci traced so far and " + kept};
  if (regions.stopped == StopReason::kOutOfTime)
    return {"budget", "the budget of computing time was spent; the loci traced so far and " + kept};
  if (loci.name != "complete" && loci.name != "no_orbit") return loci;
  const auto says = [](const RegionPlace& place) { return !place.message.empty(); };
  const auto first = std::find_if(regions.places.begin(), regions.places.end(), says);
  if (first != regions.places.end())
    return {"budget",
            fmt::format("at {} of {} places what is stable is not known in full; the first, "
                        "({:.9g}, {:.9g}): {}",
                        std::count_if(first, regions.places.end(), says), all, first->value,
                        first->second, first->message)};
  if (!regions.settled)
    return {"budget", fmt::format("what places hand on to one another still led to something new "
                                  "after {} rounds",
                                  regions.rounds)};
  return {"complete", ""};
}

}  // namespace graze
