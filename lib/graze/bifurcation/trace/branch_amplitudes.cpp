#include "graze/bifurcation/trace/branch_amplitudes.hpp"

#include "graze/base/parallel.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"

namespace graze {

BranchAmplitudes measure_branches(const SystemFamily& family, const OrbitBranches& traced,
                                  int threads, const StopSignal& stop) {
  BranchAmplitudes result;
  result.places = measured_places(family.scene(), assemble(family.scene()));
  result.branches.resize(traced.branches.size());
  struct Task {
    const OrbitBranchPoint* at;
    Amplitudes* into;
  };
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < traced.branches.size(); ++i) {
    const OrbitBranch& branch = traced.branches[i];
    BranchAmplitudes::Measured& measured = result.branches[i];
    measured.points.resize(branch.points.size());
    measured.special.resize(branch.special.size());
    for (std::size_t k = 0; k < branch.points.size(); ++k)
      tasks.push_back({&branch.points[k], &measured.points[k]});
    for (std::size_t k = 0; k < branch.special.size(); ++k)
      tasks.push_back({&branch.special[k].at, &measured.special[k]});
  }
  for_each_index(tasks.size(), threads, [&](std::size_t k) {
    if (stop.requested()) return;
    const std::optional<Scene> scene = family.scene_at(tasks[k].at->value);
    if (!scene) return;
    const System system = assemble(*scene);
    *tasks[k].into =
        orbit_amplitudes(system, tasks[k].at->orbit, rows_of(measured_places(*scene, system)));
  });
  return result;
}

}  // namespace graze
