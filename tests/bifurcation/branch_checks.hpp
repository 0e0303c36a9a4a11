// Branches of orbits as the tests trace them, and what they are held against: the closed form,
// value by value, and what happens in runs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/initial_state.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/closed_form/closed_form.hpp"
#include "graze/scene/parameter.hpp"
#include "support/reference.hpp"

namespace graze::support {

inline OrbitBranches trace(const Scene& scene, const std::string& parameter, double from, double to,
                           bool keep_virtual, int period = 1) {
  const SystemFamily family(scene, parameter);
  BranchOptions options;
  options.period = period;
  options.from = from;
  options.to = to;
  options.keep_virtual = keep_virtual;
  options.sticking = false;
  return trace_orbits(family, options);
}

// The branches that starts from simulations lead to.
inline OrbitBranches trace_from_runs(const Scene& scene, const std::string& parameter,
                                     BranchOptions options) {
  options.finder.from_closed_form = options.finder.from_random = false;
  return trace_orbits(SystemFamily(scene, parameter), options);
}

// Of these the ones whose orbits stick.
inline OrbitBranches sticking_branches(const Scene& scene, const std::string& parameter,
                                       const BranchOptions& options) {
  OrbitBranches result = trace_from_runs(scene, parameter, options);
  std::erase_if(result.branches, [](const OrbitBranch& branch) { return !branch.sticks(); });
  return result;
}

// Events of a kind in a period of a run from the scene's initial state, on average over so many
// periods after as many.
inline double events_a_period(const SystemFamily& family, double value, EventKind kind,
                              int periods) {
  const System system = *family.at(value);
  const Scene scene = with_parameter(family.scene(), family.parameter(), value);
  SimulationOptions options;
  options.periods = 2 * periods;
  int count = 0;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    count += event.kind == kind && event.period_index >= periods;
  };
  simulate(system, initial_state(scene, system), options, listeners);
  return static_cast<double>(count) / periods;
}

// |kappa| and the gap of the closed form at one value; a fold is where they meet.
struct FoldDistance {
  double kappa = 0.0, gap = 0.0;
  // (|kappa| - |gap|)/|kappa|: positive where there are two solutions.
  double relative() const { return (kappa - std::abs(gap)) / kappa; }
};

inline std::optional<FoldDistance> fold_distance(const SystemFamily& family, double value,
                                                 int period = 1) {
  const std::optional<System> system = family.at(value);
  if (!system) return {};
  const ClosedFormAnswer answer = closed_form(*system, 0, period);
  if (!answer.form) return {};
  return FoldDistance{std::abs(answer.form->kappa), system->stops[0].gap};
}

// Nearer to a fold than this the closed form itself loses digits: an error e of |kappa| moves a
// phase by e/sqrt(2 distance).
inline constexpr double kBesideFold = 1e-6;

// Every point of every branch, away from folds, is a solution of the closed form to 1e-10 in phase
// and in speed (relative to the largest speed at that value). Returns how many were compared.
inline int expect_closed_form(const OrbitBranches& result, const SystemFamily& family,
                              int period = 1) {
  int compared = 0;
  for (const OrbitBranch& branch : result.branches) {
    for (const OrbitBranchPoint& point : branch.points) {
      const auto distance = fold_distance(family, point.value, period);
      if (!distance || distance->relative() < kBesideFold) continue;
      const System system = *family.at(point.value);
      const auto solutions = closed_form(system, 0, period).form->solutions(distance->gap);
      const Vector& row = system.stops[0].row;
      double nearest = std::numeric_limits<double>::infinity(), size = 0.0;
      for (const ImpactPoint& exact : solutions)
        size = std::max(size, std::abs(row.dot(exact.before.qdot)));
      for (const ImpactPoint& exact : solutions) {
        const OrbitImpact& impact = point.orbit.impacts[0];
        nearest = std::min(
            nearest, std::abs(std::remainder(impact.phase - exact.theta, 2.0 * std::numbers::pi)) +
                         std::abs(impact.speed - row.dot(exact.before.qdot)) / size);
      }
      EXPECT_LE(nearest, 1e-10) << "branch " << branch.id << " at " << point.value;
      ++compared;
    }
  }
  return compared;
}

// How many times the branches pass a value of the parameter.
inline int segments(const OrbitBranches& result, double value) {
  int count = 0;
  for (const OrbitBranch& branch : result.branches)
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
      count += (branch.points[i].value - value) * (branch.points[i + 1].value - value) < 0.0;
  return count;
}

inline std::vector<const SpecialPoint*> special_points(const OrbitBranches& result,
                                                       SpecialKind kind) {
  std::vector<const SpecialPoint*> list;
  for (const OrbitBranch& branch : result.branches)
    for (const SpecialPoint& special : branch.special)
      if (special.kind == kind) list.push_back(&special);
  return list;
}

}  // namespace graze::support
