// Boundaries of the response that meets no stop: where it touches one (GR). It is known in closed
// form at every value, and so is how far it stays from each stop, with its rate: between two
// neighbours that is followed from one extreme to the next, so that a peak between them is seen.
#pragma once

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/bifurcation/problem/detail/response_equations.hpp"

namespace graze {

class ResponseBoundaries : public BranchBoundaries {
 public:
  // Refers to all of them, which must outlive it.
  ResponseBoundaries(const ResponseEquations& equations, const ContinuationOptions& options,
                     const BranchOptions& branches)
      : equations_(equations), options_(options), branches_(branches) {}

  bool lists(const SolutionPoint& solution) const override;
  bool goes_on(const SolutionPoint& /*previous*/, const SolutionPoint& /*here*/) override {
    return true;
  }
  void pass(const JudgedPoint& a, const JudgedPoint& b, std::vector<BranchPlace>& places) override;

 private:
  // m, and m per unit of the parameter.
  struct Clearance {
    double value = 0.0, rate = 0.0;
  };
  std::optional<Clearance> clearance(std::size_t stop, double value) const;
  // Where a stop is touched between these values, in order.
  std::vector<double> touched(std::size_t stop, double from, double to) const;
  bool is_clear(double value) const;
  std::optional<BranchPlace> grazing(double value) const;

  const ResponseEquations& equations_;
  const ContinuationOptions& options_;
  const BranchOptions& branches_;
};

}  // namespace graze
