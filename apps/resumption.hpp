// How simulate --resume finds the run to go on from.
#pragma once

#include "command.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/record/records.hpp"

namespace graze {

// A run that was cut, to go on from.
struct CutRun {
  double time = 0.0;                  // s, where it was cut
  std::optional<double> sample_rate;  // 1/s, of the samples counted in `state`; absent: none
  RunState state;
};

// The run that --resume names by its folder. Throws FileError where there is none; InputError where
// it is of another scene, cannot go on, or --out is that folder, whose tables would be lost.
CutRun read_cut_run(const SimulateCommand& command, const RunInfo& info);

// Throws InputError where the run is past the end asked for; both count from t = 0.
void check_end(const CutRun& cut, const SimulationOptions& options, const System& system);

// Adds to the outcome of a run that was stopped and left its state the command that goes on.
void tell_how_to_go_on(const SimulateCommand& command, RunOutcome ended, Outcome& outcome);

// Sets which sample comes next, of `stride` for each that is kept: at the rate of before (1/s, of
// those that are kept) the one after the last kept, at another the first whose time is not over.
void place_samples(CutRun& cut, double rate, long long stride);

}  // namespace graze
