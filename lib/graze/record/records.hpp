// The results of the commands as values: what was computed, and how. Reports format them.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/assembly/beam_shape.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/bifurcation/trace/branch_amplitudes.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/search/finder.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/record/run_picture.hpp"
#include "graze/record/run_statistics.hpp"
#include "graze/record/section.hpp"
#include "graze/record/shown_quantity.hpp"

namespace graze {

// How a command ended, in the words of the result document.
struct Outcome {
  std::string name;     // "reached_end", "found", "complete", ..
  std::string message;  // a sentence unless all went well
};

// The outcome of work over many values that was stopped: "interrupted" or "budget", with the number
// of `things` ("values") kept; nullopt when it was not stopped.
std::optional<Outcome> stopped_outcome(StopReason stopped, std::size_t kept, std::size_t asked,
                                       const char* things);

struct CheckRecord {
  RunInfo info;
  Scene scene;
  ModalModel model;  // of the scene
  System system;
  double collocation_condition = 0.0;   // 0: nothing collocates
  std::optional<double> closure_speed;  // the default of a simulation, m/s; absent without stops
  std::optional<StepSetting> steps;     // of the flow that the scene asks for; absent: exact
  std::vector<std::string> warnings;
  Outcome outcome;
};

// The first and the last events of a run, which may have any number of them.
class EventExcerpt {
 public:
  EventExcerpt() = default;
  // As read back from a record.
  EventExcerpt(long long count, std::vector<Event> first, std::deque<Event> last)
      : count_(count), first_(std::move(first)), last_(std::move(last)) {}

  void add(const Event& event);
  long long count() const { return count_; }
  const std::vector<Event>& first() const { return first_; }
  // The events after the first ones, all or only the last.
  const std::deque<Event>& last() const { return last_; }
  long long left_out() const;

 private:
  long long count_ = 0;
  std::vector<Event> first_;
  std::deque<Event> last_;
};

// A run may be longer than memory: its events and samples go to files as they come; this holds only
// what is shown of them.
struct SimulationRecord {
  RunInfo info;
  System system;
  std::vector<ProbeRow> probes{};
  std::vector<MeasuredPlace> places{};  // at which it was measured; empty unless requested
  Simulation run;
  EventExcerpt excerpt;                       // empty unless recorded
  std::vector<Event> events;                  // the end of the run, for pictures
  std::vector<Sample> samples;                // the end of the run, for pictures
  std::optional<RunSection> section;          // where it was asked for
  std::optional<RunStatistics> statistics{};  // where they were asked for
  RunPicture shown = RunPicture::kMotion;     // in a picture
  std::vector<BeamShape> shapes{};            // at the instants that were asked for
  std::optional<BeamPlaces> beam{};           // where its shape is shown
  // Displacements of the masses, or of the rows of matrices in the scene, per modal one; empty
  // else.
  Matrix coordinates{};
  std::vector<std::string> warnings, notes;
  Outcome outcome;
};

struct OrbitRecord {
  RunInfo info;
  System system;
  FoundOrbits found;
  std::vector<MeasuredPlace> places{};   // at which the orbits are measured
  std::vector<Amplitudes> amplitudes{};  // of every orbit
  std::vector<std::string> warnings;
  Outcome outcome;
};

struct BranchRecord {
  RunInfo info;
  System system;  // at the scene's own value
  OrbitBranches traced;
  double from = 0.0, to = 0.0;
  std::string unit;  // of the parameter
  std::vector<std::string> warnings;
  Outcome outcome;
  BranchAmplitudes amplitudes{};  // empty unless they were asked for
  std::optional<Shown> shown{};   // amplitude shown in a picture; else impact speeds
};

// The entries of a balance for effects that the system has, J: no load without gravity, no impacts
// without rigid stops, no dissipation without damping.
struct EnergyEntries {
  std::optional<double> forcing, load, constraint, impacts, dissipation, contact, stops, friction;
};
EnergyEntries energy_entries(const System& system, const EnergyBalance& balance);
// The defect of the balance relative to its largest entry.
double relative_defect(const EnergyBalance& balance);

Outcome simulation_outcome(const Simulation& run);
// Warnings about a run for its user.
std::vector<std::string> simulation_warnings(const System& system, const Simulation& run);
Outcome orbit_outcome(const FoundOrbits& found, const FinderOptions& options, StopReason stopped);
Outcome branch_outcome(const OrbitBranches& traced, const BranchOptions& options);

}  // namespace graze
