// Amplitudes of the orbits of branches, point by point, as response curves show them.
#pragma once

#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/bifurcation/trace/orbit_branches_values.hpp"
#include "graze/motion/amplitudes.hpp"

namespace graze {

struct BranchAmplitudes {
  struct Measured {
    std::vector<Amplitudes> points, special;  // in their order
  };
  std::vector<MeasuredPlace> places;  // of the scene's own value; rows may depend on the parameter
  std::vector<Measured> branches;     // in their order

  bool empty() const { return places.empty(); }
};

// On several cores, 0: all. Points not yet measured when it is stopped have no rows.
BranchAmplitudes measure_branches(const SystemFamily& family, const OrbitBranches& traced,
                                  int threads, const StopSignal& stop = {});

}  // namespace graze
