#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/orbit/problem/detail/solve.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/study/cost/accuracy_costs.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/study/processor_time.hpp"

namespace graze {
namespace {

constexpr int kMostCorrections = 12;
constexpr double kCorrectorSeconds = 0.2;
// Accuracy of a solution, rad: Newton's last steps are rounding.
constexpr double kLastDigits = 1e-14;

class NewtonCosts {
 public:
  NewtonCosts(const System& system, const ShootingProblem& problem, Vector solution)
      : system_(system), problem_(problem), solution_(std::move(solution)) {}

  // One row for every step from `start` on, until the residual no longer falls.
  void add(const Vector& start, bool predicted, std::vector<CorrectorCost>& rows) const {
    Vector x = start;
    double last = std::numeric_limits<double>::infinity();
    for (int steps = 0; steps <= kMostCorrections; ++steps) {
      CorrectorCost row;
      row.predicted = predicted;
      row.steps = steps;
      row.residual = problem_.residual(system_, x).cwiseAbs().maxCoeff();
      if (!(row.residual < last)) return;
      last = row.residual;
      row.error = phase_error(x) / system_.forcing()->frequency;
      row.seconds = steps == 0 ? 0.0 : least_time([&] { run(start, steps); }, kCorrectorSeconds);
      rows.push_back(row);
      if (phase_error(x) < kLastDigits) return;
      x = run(x, 1);
    }
  }

 private:
  Vector run(Vector x, int steps) const {
    Matrix jacobian;
    for (int i = 0; i < steps; ++i) {
      const Vector r = problem_.residual(system_, x, &jacobian);
      x -= LuFactors(jacobian).solve(r);
    }
    return x;
  }
  double phase_error(const Vector& x) const {
    const auto a = problem_.unpack(system_, x), b = problem_.unpack(system_, solution_);
    double error = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      error = std::max(error, std::abs(a[i].theta - b[i].theta));
    return error;
  }

  const System& system_;
  const ShootingProblem& problem_;
  Vector solution_;
};

}  // namespace

CorrectorCosts corrector_costs(const Scene& scene, const AccuracyCostOptions& options) {
  CorrectorCosts costs;
  if (!scene.forcing || scene.stops.empty()) {
    costs.message = "without forcing and a stop there are no orbits to solve for";
    return costs;
  }
  const System system = assemble(scene);
  if (!system.has_modal_flights()) {
    costs.message = system.harmonics()  ? "not measured under several harmonic loads"
                    : system.coupling() ? "not measured where damping couples modes"
                                      : "not measured where a stop is compliant";
    return costs;
  }
  FinderOptions finder;
  finder.impacts = 1;
  finder.stop = options.stop;
  finder.from_simulation = false;
  const FoundOrbits found = find_orbits(system, initial_state(scene, system), finder);
  if (found.orbits.empty()) {
    costs.message = "no orbit with one impact a period was found";
    return costs;
  }
  const Orbit& orbit = found.orbits.front();
  const ShootingProblem problem(orbit.pattern(), motion_scale(system));
  const Vector solution = problem.pack(system, orbit.points());
  costs.orbit = "orbit (1, 1)";
  // Its neighbour on the branch over the forcing frequency.
  const SystemFamily family(scene, "forcing.frequency");
  const double here = family.value(), there = here * (1.0 - kNeighbour);
  const std::optional<System> neighbour = family.at(there), tangent = family.tangent_at(there);
  const auto solved =
      neighbour ? newton(problem, *neighbour, solution) : std::optional<ShootingSolution>();
  if (!solved || !tangent) {
    costs.message =
        fmt::format("its branch does not go on to a frequency lower by {:g}", here - there);
    return costs;
  }
  const System* tangents[] = {&*tangent};
  const ShootingLinearisation at = problem.linearise(*neighbour, solved->x, tangents);
  const NewtonCosts newton_costs(system, problem, solution);
  newton_costs.add(solved->x, false, costs.rows);
  newton_costs.add(
      solved->x - LuFactors(at.jacobian).solve(at.by_parameters.col(0)) * (here - there), true,
      costs.rows);
  return costs;
}

}  // namespace graze
