#include "graze/record/loci_record.hpp"

#include <fmt/format.h>

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
  if (traced.loci.empty())
    return {"no_orbit", fmt::format("no {} of ({}, {}) orbits was met on {} slices of the plane",
                                    names_of(options.kinds), options.branches.period,
                                    options.branches.impacts, traced.slices)};
  return {"complete", ""};
}

}  // namespace graze
