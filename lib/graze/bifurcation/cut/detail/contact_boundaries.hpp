// Boundaries of orbits that are followed from stroboscopic section to section, on compliant stops:
// where a contact is born or lost (GR). Where the force of its stop sets in continuously the branch
// goes on smoothly, with orbits of other contacts; where it sets in with a jump the map has a
// corner there, at which the trace ends. Solutions that meet no stop are not part of the branch.
#pragma once

#include <functional>

#include "graze/bifurcation/cut/detail/branch_boundaries.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

class ContactBoundaries : public BranchBoundaries {
 public:
  // Refers to both, which must outlive it.
  ContactBoundaries(const SegmentEquations& equations, const ContinuationOptions& options)
      : equations_(equations), options_(options) {}

  bool lists(const SolutionPoint& solution) const override {
    return equations_.judge(solution).has_value();
  }
  bool goes_on(const SolutionPoint& /*previous*/, const SolutionPoint& here) override {
    return lists(here);
  }
  // Whether friction slides and sticks in another order.
  bool lie_across(const SolutionPoint& a, const SolutionPoint& b) const override;
  // Whether, if a contact is born or lost within the step, its grazing lies there too, and the
  // branch has not turned too far up to it.
  bool resolves(const SolutionPoint& from, const SolutionPoint& to) override;
  void pass(const JudgedPoint& a, const JudgedPoint& b, std::vector<BranchPlace>& places) override;
  std::optional<BranchTip> close(Branch& trace, std::size_t side) override;

 private:
  BranchPlace boundary(const SolutionPoint& at, std::optional<OrbitBranchPoint> orbit,
                       bool approach) const;
  std::optional<double> margin_of(const SolutionPoint& point, bool speed,
                                  std::size_t impacts) const;
  double near_enough(const SolutionPoint& point, bool speed) const;
  bool meets_springs(const SolutionPoint& point) const;
  double speed_margin(const SolutionPoint& point, double speed) const;
  std::optional<SolutionPoint> corner_beyond(SolutionPoint before, SolutionPoint last, bool speed,
                                             std::size_t impacts) const;
  std::optional<SolutionPoint> grazing_between(const SolutionPoint& a, const SolutionPoint& b,
                                               std::size_t before, std::size_t after) const;
  std::optional<SolutionPoint> halved(
      SolutionPoint low, SolutionPoint high,
      const std::function<double(const SolutionPoint&)>& test) const;
  std::optional<BranchTip> jump_beyond(const SolutionPoint& last, std::size_t side) const;
  // Where friction slides and sticks in another order.
  void pass_sliding(const JudgedPoint& a, const JudgedPoint& b,
                    std::vector<BranchPlace>& places) const;

  const SegmentEquations& equations_;
  const ContinuationOptions& options_;
};

}  // namespace graze
