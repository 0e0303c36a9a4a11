// Searching the torus of impact phases for the solutions of a pattern, however far from the start.
//
// In rounds: starts are points of a Sobol sequence on the ordered phases; from each a
// Levenberg-Marquardt solve (Ceres) of the deflated phase problem, then Newton's method on the
// problem itself. The solutions of a round are deflated in the next one; the search ends after two
// rounds in a row without a new solution. If there is none at all, the lowest deflated residual on
// the whole torus is searched for and used as a start in the same way.
//
// Results do not depend on the number of threads: the starts of a round are independent and are
// collected in their order.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "graze/base/stop_signal.hpp"
#include "graze/orbit/closed_form/detail/phase_problem.hpp"
#include "graze/orbit/problem/orbit.hpp"
#include "graze/orbit/search/detail/phase_deflation.hpp"

namespace graze {

// How long and where the phases of impacts are searched for (phase_search.hpp).
struct PhaseSearchOptions {
  int starts = 64;  // of a round
  int rounds = 8;   // at most
  // Start only where every stop is approached. No solution is excluded, but a start is more likely
  // to lead to an orbit: an orbit is surrounded by such points.
  bool approaching = true;
  int global_evaluations = 2048;
  std::uint64_t seed = 1;  // moves the Sobol sequence
  double length = 1.0;     // m, unit of the residual
  double speed = 1.0;      // m/s, of the forced motion; r(v) is taken there at first
  int threads = 0;         // 0: as many as there are cores
  StopSignal stop;
};

// A solution of the phase problem: its impacts in time order from the smallest phase, which lies in
// [0, 2 pi), the others within 2 pi p of it.
struct PhaseSolution {
  ImpactPattern pattern;
  Vector phases;  // rad
  Vector speeds;  // m/s
};

// The orbit of a solution, without states and multipliers.
Orbit outline(const PhaseSolution& solution);

// Start phases: points of the Sobol sequence, each coordinate moved by exclusive or with a number
// drawn by the seed, on the first phase and the ordered others.
class PhaseStarts {
 public:
  PhaseStarts(int period, int impacts, std::uint64_t seed);
  // The next start, rad: ascending within 2 pi p, the first in [0, 2 pi).
  Vector next();

 private:
  struct Sequence;
  int period_;
  std::vector<std::uint64_t> shift_;
  std::shared_ptr<Sequence> sequence_;
};

class PhaseSearch {
 public:
  // Refers to the response.
  PhaseSearch(const PeriodicResponse& response, const ImpactPattern& pattern,
              const PhaseSearchOptions& options);

  // Deflates a solution: its impacts in time order, phases in rad.
  void know(const std::vector<int>& stops, const Vector& phases);

  // The solutions that the rounds find, each once. A solve may end in another order of the same
  // stops than the pattern's.
  std::vector<PhaseSolution> local();
  // A solution from the lowest deflated residual, if it leads to a new one; if not, the next call
  // searches elsewhere.
  std::optional<PhaseSolution> global();

  int tried() const { return tried_; }          // local solves
  int converged() const { return converged_; }  // those that ended in a solution

 private:
  std::vector<Vector> starts_of_a_round();
  // Adds the solution to the known ones; returns whether it was new.
  bool learn(const PhaseSolution& solution);

  const PeriodicResponse* response_;
  PhaseSearchOptions options_;
  PhaseDeflation deflation_;
  PhaseStarts starts_;
  std::vector<PhaseDeflation> known_;  // one for each order of the stops
  int tried_ = 0, converged_ = 0;
};

// The solution that Newton's method leads to from phases near it; nullopt when there is none, or
// when two impacts of one stop coincide. `length`, m, unit of the residual.
std::optional<PhaseSolution> solution_near(const PhaseProblem& problem, double length,
                                           const Vector& phases);

// The solution that a solve from the start leads to, or nullopt.
std::optional<PhaseSolution> solve_phases(const PeriodicResponse& response,
                                          const PhaseDeflation& deflation, const Vector& start,
                                          const PhaseSearchOptions& options);

}  // namespace graze
