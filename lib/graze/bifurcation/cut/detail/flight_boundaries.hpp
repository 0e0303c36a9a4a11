// Boundaries of orbits whose flights are prescribed: where a stop is touched between two impacts,
// an impact loses its speed, or one that leaves its stop at rest is pushed back (GR), and where two
// impacts coincide. Solutions go on beyond as virtual ones; between neighbours where a change may
// be hidden further solutions are computed (grazing_samples.hpp).
#pragma once

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/cut/detail/grazing_samples.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/detail/remembered.hpp"

namespace graze {

class FlightBoundaries : public BranchBoundaries {
 public:
  // Refers to all of them, which must outlive it.
  FlightBoundaries(const FlightEquations& equations, const ContinuationOptions& options,
                   const BranchOptions& branches)
      : equations_(equations),
        options_(options),
        branches_(branches),
        samples_(equations, options) {}

  bool lists(const SolutionPoint& solution) const override;
  bool goes_on(const SolutionPoint& /*previous*/, const SolutionPoint& here) override {
    return lists(here);
  }
  void pass(const JudgedPoint& a, const JudgedPoint& b, std::vector<BranchPlace>& places) override;
  std::optional<Orbit> across(const SpecialPoint& special) const override;

 private:
  const SeenSolution& seen(const JudgedPoint& at);
  BranchPlace place_of(const OrbitBranchPoint& at) const;
  std::optional<BranchPlace> between(const SeenSolution& a, const SeenSolution& b) const;
  std::optional<BranchPlace> grazing(const SeenSolution& a, const SeenSolution& b) const;
  std::vector<OrbitBranchPoint> held_beyond(const SolutionPoint& push, double towards) const;

  const FlightEquations& equations_;
  const ContinuationOptions& options_;
  const BranchOptions& branches_;
  GrazingSamples samples_;
  Remembered<std::tuple<Vector, double, Vector>, SeenSolution> seen_;
};

}  // namespace graze
