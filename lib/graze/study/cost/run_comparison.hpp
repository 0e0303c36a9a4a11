// The error of a run compared with a reference of the same motion.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/motion/simulation.hpp"
#include "graze/study/cost/reference_run.hpp"

namespace graze {

struct RunError {
  bool impacts_agree = false;
  // Largest error of the time of an impact, or of the beginning or the end of a contact, s; for a
  // motion without impacts largest error of the displacements relative to their largest size.
  // Absent where the run failed or its sequence of impacts differs.
  std::optional<double> error;
  // Error of the state at the end, displacements times frequencies and velocities, relative to a
  // speed; absent likewise.
  std::optional<double> state_error;
  std::string message;  // why the run failed
};

class RunComparison {
 public:
  // Compares the first `impacts` of the reference, or all if it has fewer; those no faster than
  // `slowest` (m/s) do not count. `speed`: of the motion, kg^1/2 m/s.
  RunComparison(ReferenceRun reference, std::size_t impacts, double slowest, double speed);

  const ReferenceRun& reference() const { return reference_; }
  std::size_t impacts() const { return impacts_; }  // compared
  // The error of the run from `start` that ends where the reference does.
  RunError of(const System& system, const State& start, const SimulationOptions& options) const;

 private:
  struct Run;
  bool agrees(const std::vector<ReferenceImpact>& impacts) const;
  double time_error(const std::vector<ReferenceImpact>& impacts) const;
  std::optional<double> displacement_error(const std::vector<State>& samples) const;
  double state_error(const System& system, const State& end) const;

  ReferenceRun reference_;
  std::size_t impacts_ = 0, instants_ = 0;  // compared; a contact has two
  double slowest_, speed_;
};

}  // namespace graze
