// The response that meets no stop along a locus, which ends where the response touches one.
#pragma once

#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/bifurcation/problem/detail/response_equations.hpp"

namespace graze {

class ResponseLocus : public LocusOrbits {
 public:
  explicit ResponseLocus(const ResponseEquations& equations) : equations_(equations) {}

  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> zero) const override;
  ImpactPattern pattern(const std::vector<LocusPlace>& /*places*/) const override { return {}; }
  std::optional<Vector> margins(const LocusSite& at) const override;

 private:
  std::optional<Orbit> orbit(const LocusSite& at) const;

  const ResponseEquations& equations_;
};

}  // namespace graze
