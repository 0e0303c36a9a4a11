// Orbits that are followed along a locus. On compliant stops it ends where their motion meets no
// stop any more; orbits that stick belong to it while their stuck phases, and the impacts that lead
// to none, are the same: it ends at CH or GR, which is bracketed.
#pragma once

#include <map>
#include <vector>

#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/bifurcation/problem/detail/segment_equations.hpp"

namespace graze {

// Largest distance, in units of the unknowns and ranges of the parameters, between an orbit and a
// solution that is none, where a locus ends between them.
inline constexpr double kLocusBracket = 1e-7;

class FixedPhaseLocus : public LocusOrbits {
 public:
  // Refers to the equations over two parameters.
  explicit FixedPhaseLocus(const SegmentEquations& equations) : equations_(equations) {
    tolerance = SegmentEquations::critical_tolerance();
  }
  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> zero) const override;
  ImpactPattern pattern(const std::vector<LocusPlace>& places) const override;
  // Keeps the places that it goes on from: after a stop no motion can be followed.
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override {
    keep(previous);
    return keep(here);
  }

 protected:
  const System* system_at(const LocusSite& at) const {
    return equations_.system_at(std::array{at.first, at.second});
  }
  const SegmentEquations& equations_;

 private:
  using Unknowns = std::vector<double>;  // both parameters and u
  static Unknowns unknowns_of(const LocusSite& at);
  bool keep(const LocusSite& at) const;

  mutable std::map<Unknowns, LocusPlace> kept_;
};

class ReleaseLocus : public FixedPhaseLocus {
 public:
  // `completing`: along CH, where a motion on either side stands for the one whose chatter
  // completes, and whether it sticks is rounding.
  explicit ReleaseLocus(const SegmentEquations& equations, bool completing = false);

  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> zero) const override;
  bool goes_on(const LocusSite& previous, const LocusSite& here) const override;
  bool resolves(const LocusSite& from, const LocusSite& to) const override;
  OrbitLocusEnd end_between(const LocusSite& inner, const LocusSite& outer) const override;
  OrbitLocusEnd end_at(const LocusSite& last) const override;

 protected:
  // The segments of its orbits.
  virtual std::optional<SegmentShooting> shooting_at(const LocusSite& /*at*/) const {
    return equations_.shooting();
  }
  // The place with its section at the release itself, where no stuck phase may be left.
  std::optional<LocusPlace> place_at_release(const LocusSite& at,
                                             const std::optional<GrazingContact>& grazing) const;

 private:
  // `minima`: as in SegmentOptions.
  std::optional<ReleaseReturn> return_at(const LocusSite& at, bool minima) const;
  // The events from the release on; nullopt when the motion does not fit this layout.
  std::optional<Itinerary> itinerary_at(const LocusSite& at) const;
  // How the locus ends between neighbours; nullopt when it goes on.
  std::optional<OrbitLocusEnd> change(const LocusSite& before, const LocusSite& now) const;

  bool completing_;
};

}  // namespace graze
