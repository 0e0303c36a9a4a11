// Orbits of one impact pattern along a locus. Where they become virtual the locus goes on: the
// margins show where.
#pragma once

#include "graze/bifurcation/cut/detail/locus_orbits.hpp"
#include "graze/bifurcation/problem/detail/flight_equations.hpp"

namespace graze {

class FlightLocus : public LocusOrbits {
 public:
  // Refers to the equations over two parameters. `grazing`: the impact at zero speed, on a locus of
  // grazing.
  explicit FlightLocus(const FlightEquations& equations, std::optional<std::size_t> grazing = {})
      : equations_(equations), grazing_(grazing) {}

  std::optional<LocusPlace> place(const LocusSite& at,
                                  std::optional<LocusMargin> zero) const override;
  ImpactPattern pattern(const std::vector<LocusPlace>& /*places*/) const override {
    return equations_.pattern();
  }
  std::optional<Vector> margins(const LocusSite& at) const override;
  bool resolves(const LocusSite& from, const LocusSite& to) const override;

 private:
  Vector speeds(const LocusSite& at) const;

  const FlightEquations& equations_;
  std::optional<std::size_t> grazing_;
};

}  // namespace graze
