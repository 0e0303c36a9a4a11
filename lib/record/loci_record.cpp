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
  if (traced.cut_short > 0)
    return {"budget",
            fmt::format("{} of {} special points lead to a locus that could not be followed to an "
                        "end, so loci may be missing or cut short",
                        traced.cut_short, traced.starts)};
  if (traced.loci.empty())
    return {"no_orbit", fmt::format("no {} of ({}, {}) orbits was met on {} slices of the plane",
                                    names_of(options.kinds), options.branches.period,
                                    options.branches.impacts, traced.slices)};
  return {"complete", ""};
}

}  // namespace graze
