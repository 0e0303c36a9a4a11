// Loci of one kind of one zero problem that have been traced, prepared for many tests whether
// starts lead to one of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "graze/continuation/branch/detail/known_branch.hpp"
#include "graze/continuation/branch/zero_problem.hpp"
#include "graze/continuation/locus/locus_values.hpp"

namespace graze {

class KnownLoci {
 public:
  bool empty() const { return known_.empty(); }
  // Adds a locus with the problem and the options that it was traced with.
  void add(const ZeroProblem& problem, const LocusOptions& options, const Locus& locus);
  // As find_locus: the index of the locus, in the order in which they were added.
  std::optional<std::size_t> find(const ZeroProblem& problem, const LocusOptions& options,
                                  const LocusStart& start) const;

 private:
  struct Known {
    LocusKind kind;
    KnownBranch branch;
  };
  std::vector<Known> known_;
};

}  // namespace graze
