// Boundaries of the response that meets no stop: where it touches one (GR). The response and its
// distance from each stop are known in closed form at every value, with their rates: between two
// neighbours the distance is followed from one extreme to the next, so that no peak is missed.
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
  // Value in m, rate in m per unit of the parameter.
  struct Clearance {
    double value = 0.0, rate = 0.0;
  };
  std::optional<Clearance> clearance(std::size_t stop, double value) const;
  // The values between these at which a stop is touched, in order.
  std::vector<double> touched(std::size_t stop, double from, double to) const;
  bool is_clear(double value) const;
  std::optional<BranchPlace> grazing(double value) const;

  const ResponseEquations& equations_;
  const ContinuationOptions& options_;
  const BranchOptions& branches_;
};

}  // namespace graze
