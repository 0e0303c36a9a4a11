// The results of commands that do more than follow one motion, find its orbits or trace their
// branches (records.hpp), as values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/mode_table.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/fit/fit.hpp"
#include "graze/record/records.hpp"
#include "graze/study/compare/comparison_map.hpp"
#include "graze/study/compare/contact_order.hpp"
#include "graze/study/compare/sensitivity.hpp"
#include "graze/study/cost/accuracy_costs.hpp"
#include "graze/study/cost/flow_cost.hpp"
#include "graze/study/plane/attractor_map.hpp"
#include "graze/study/plane/region_boundaries.hpp"
#include "graze/study/plane/stable_regions.hpp"
#include "graze/study/sweep/run_series.hpp"
#include "graze/study/sweep/sweep.hpp"

namespace graze {

// The result of a bifurcation diagram: a sweep, and the branches over it.

// What a picture shows of a branch over the parameter: impact speeds (m/s) or displacements at a
// stop (m), one for every impact or forcing period of an orbit.
struct DiagramCurve {
  std::vector<std::vector<double>> points, special;  // for each point of the branch
};

struct DiagramRecord {
  // Includes what made the diagram and the outcome of the whole; without branches if none were
  // requested.
  BranchRecord branches;
  Sweep swept;
  DiagramSection section = DiagramSection::kImpact;
  // One curve for each branch; on a stroboscopic section such a list for each stop, for impacts a
  // single one.
  std::vector<std::vector<DiagramCurve>> curves;
};

// Impacts slower than this part of the fastest are not shown where a chatter completes: there are
// infinitely many.
inline constexpr double kSlowestShown = 1e-3;

// The speeds of all impacts along the branches; where a chatter completes, without those that are
// many times slower than the fastest.
std::vector<DiagramCurve> impact_curves(const OrbitBranches& traced);

// The shown amplitude along the branches, one height for each point; requires both.
std::vector<DiagramCurve> amplitude_curves(const BranchRecord& record);
// The same for another amplitude.
std::vector<DiagramCurve> amplitude_curves(const BranchAmplitudes& amplitudes, const Shown& shown);

// The displacements at each stop at t = 0, T, 2T, .. along the branches.
std::vector<std::vector<DiagramCurve>> stroboscopic_curves(const SystemFamily& family,
                                                           const OrbitBranches& traced);

// How the diagram ended: `branches` is the outcome of tracing them, if they were requested.
Outcome diagram_outcome(const Sweep& swept, const std::optional<Outcome>& branches);

// The result of a diagram of a motion without periodic forcing: one run from the scene's start at
// each value of a parameter.
struct RunDiagramRecord {
  RunInfo info;
  std::string parameter, unit;
  double from = 0.0, to = 0.0;
  double duration = 0.0;  // s
  std::size_t stops = 0;
  std::vector<Probe> probes;
  std::vector<ValueRun> runs;  // the finished ones, in the order of the values
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "complete", or "budget" or "interrupted" with what is missing. `asked`: values in all.
Outcome run_diagram_outcome(const std::vector<ValueRun>& runs, std::size_t asked,
                            StopReason stopped);

// The result of a map of attractors with what made it.

// What a picture of a map shows of its cells.
enum class MapQuantity {
  kAttractor,
  kImpacts,   // a forcing period
  kExponent,  // the largest, 1/s
  kSpeed,     // of the fastest impact, m/s
  kStuck,     // part of the time
  kMeasured   // how large the motion is
};

struct MapRecord {
  RunInfo info;
  AttractorMap map;
  std::optional<OrbitLoci> loci;  // of special points over it, if requested
  std::string x_unit, y_unit;
  MapQuantity shown = MapQuantity::kAttractor;
  std::vector<MeasuredPlace> places{};  // at which motions are measured; empty unless requested
  std::optional<Shown> measured{};      // what is shown of that
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "complete"; "budget" when computing time was spent or a motion could not be followed to its end;
// "interrupted". A start that the scene does not allow is a result of its cell, no failure.
Outcome map_outcome(const AttractorMap& map);

// The result of tracing loci in two parameters, and of searching for stable motions between them.
struct LociRecord {
  RunInfo info;
  OrbitLoci traced;
  std::optional<StableRegions> regions;        // where they were asked for
  std::optional<RegionBoundaries> boundaries;  // of these, if loci of all kinds were traced
  double from = 0.0, to = 0.0, second_from = 0.0, second_to = 0.0;
  std::string unit, second_unit;  // of the parameters
  std::vector<std::string> warnings;
  Outcome outcome;
};

Outcome loci_outcome(const OrbitLoci& traced, const LociOptions& options);

// How the whole ended, `loci` being the outcome of tracing them. With regions, the absence of loci
// is no failure.
Outcome regions_outcome(const StableRegions& regions, const Outcome& loci);

// The results of compare with what made them.

// Compared quantities of two motions.
enum class ComparedQuantity {
  kAttractor,  // what both settle on
  kAgreeing,   // first impacts that agree
  kFirstTime,  // of the first impact
  kFirstSpeed,
  kDisplacement,  // of what they settle on
  kVelocity,
  kEnergy,
  kTaken  // by the stops
};

// Motions of a scene and of others, each compared with the previous one.
struct ComparisonRecord {
  RunInfo info;
  std::vector<std::string> names;                    // of the scenes: "the scene", "beam.modes=5"
  std::vector<std::vector<std::string>> settings{};  // of each beside those of the first
  std::vector<int> modes;  // of each if that is their difference; else empty
  CompareOptions options;
  std::vector<ComparedMotion> motions;
  std::vector<MotionDifference> differences;  // of each but the first from the previous one
  std::vector<SimulationRecord> runs;         // with the samples for a picture; or empty
  std::vector<std::string> warnings;
  Outcome outcome;
};

struct ComparisonMapRecord {
  RunInfo info;
  std::string one, other;            // names of the scenes
  std::vector<std::string> against;  // "KEY=VALUE" of what makes the other
  ComparisonMap map;
  std::string x_unit, y_unit;
  ComparedQuantity shown = ComparedQuantity::kAttractor;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// Fills in the differences, and the outcome: "compared"; "budget" when a motion could not be
// followed; or why not all of `asked` were compared.
void conclude_comparison(ComparisonRecord& record, std::size_t asked, StopReason stopped);
// "complete", and else likewise. Values that a scene does not allow are a result of their cell.
Outcome comparison_map_outcome(const ComparisonMap& map);

// The result of compare --sensitivity with what made it.
struct SensitivityRecord {
  RunInfo info;
  std::string parameter, unit;
  std::string second, second_unit;  // empty: there is none
  double reference = 0.0;           // value of the parameter that s2 compares with
  std::vector<Probe> probes;
  std::vector<SensitivityCurve> curves;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "compared", "incomplete" when a run did not reach its end, or why not all values were run.
Outcome sensitivity_outcome(const std::vector<SensitivityCurve>& curves, std::size_t asked,
                            StopReason stopped);

// The result of comparing flows: the cost of accuracy in time.

// The order of Runge-Kutta steps across the first contact with a compliant stop.
struct ContactOrders {
  FirstContact first;
  std::vector<ContactOrder> lines;  // none where no such contact begins
};

struct CostRecord {
  RunInfo info;
  FlowCosts costs;
  std::vector<ModeCost> modes;  // empty where their number is not free
  ClosureCosts closure;
  CorrectorCosts corrector;
  std::optional<ContactOrders> contact;  // where a stop is compliant
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "measured"; "budget" when the time or the impacts were spent before; "none" when there is nothing
// to compare.
Outcome cost_outcome(const FlowCosts& costs, StopReason stopped);

// The reference for flows.
std::string reference_name(const FlowCosts& costs);

// "first 20 impacts, 2.5 s", "first 20 contacts, 2.5 s" or "no impacts, 2.5 s"
std::string compared_span(const FlowCosts& costs, Units units);

// The result of a fit with what made it.
struct FitRecord {
  RunInfo info;
  std::string data_file;    // as given
  std::string data_sha256;  // of its content
  std::vector<std::string> unused_columns;
  FitResult result;
  std::vector<std::string> warnings;
  Outcome outcome;
};

// "fitted", "not_determined", "not_converged", "budget" or "interrupted".
Outcome fit_outcome(const FitResult& result);

// "restitution", "impact times" or "response".
std::string name_of(MeasurementKind kind);

// The independent variable of the measured values: "speed" (m/s), "time" (s), "impact".
struct Abscissa {
  std::string name, unit;
};
Abscissa abscissa_of(MeasurementKind kind);

// The scene with the fitted values as TOML; empty where there is none.
std::string fitted_scene_text(const FitResult& result);

// The natural modes of a structure as a result.
struct ModesRecord {
  RunInfo info;
  ModeTable table;
  std::string mac_file{};  // file of shapes that the modes are compared with; empty: none
  std::optional<ModalAssurance> mac{};
  std::vector<std::string> warnings;
  Outcome outcome;
};

}  // namespace graze
