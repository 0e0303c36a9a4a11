// The results as comma-separated tables: header row first, no comment lines, numbers with all
// their digits, empty cells for what does not exist. Units stand in result.json.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/motion/run_events.hpp"
#include "graze/motion/sample.hpp"
#include "graze/record/record_names.hpp"

namespace graze {

class RunSection;
struct OrbitLoci;
struct StableRegions;

// Tables of a run grow row by row, so header and rows come apart.
std::string events_csv_header();
std::string events_csv_row(const Event& event);
// The numbers of that row behind its kind, NaN for what does not exist, from `row` on, which has
// room for them.
inline constexpr std::size_t kEventNumbers = 11;
void write_event_row(const Event& event, double* row);
// With `energy` the entries of the energy balance follow, then the probes.
std::vector<std::string> sample_columns(const System& system, bool energy,
                                        const std::vector<ProbeRow>& probes = {});
std::string samples_csv_header(const System& system, bool energy,
                               const std::vector<ProbeRow>& probes = {});
std::string samples_csv_row(const System& system, const Sample& sample,
                            const std::vector<ProbeRow>& probes = {});
// The numbers of that row, NaN for what does not exist, from `row` on, which has room for them;
// returns the end of them.
double* write_sample_row(const System& system, const Sample& sample,
                         const std::vector<ProbeRow>& probes, double* row);
// How many there are.
std::size_t sample_numbers(const System& system, const Sample& sample,
                           const std::vector<ProbeRow>& probes);

// One line a window of time: its ends and the mean force of every stop meanwhile.
std::string forces_csv(const StopForces& forces);

// One line a point: "time,stop,phase,speed" or "time,stop,displacement,velocity".
std::string section_csv(const RunSection& section);

std::string orbits_csv(const OrbitRecord& record);
// Their motions over one period: a line a sample, flight by flight from impact to impact with the
// ends of each, so that an impact has a line before and one after it.
std::string profiles_csv(const OrbitRecord& record);
// The stuck phases of the orbits.
std::string stuck_csv(const OrbitRecord& record);
// Their contacts at compliant stops.
std::string contacts_csv(const OrbitRecord& record);
std::string branches_csv(const BranchRecord& record);
std::string special_csv(const BranchRecord& record);
std::string loci_csv(const OrbitLoci& traced);
std::string special_csv(const LociRecord& record);
// One line a place; labels hold commas and stand in quotes.
std::string regions_csv(const StableRegions& regions);

// One line a flow and setting.
std::string costs_csv(const CostRecord& record);
std::string mode_costs_csv(const CostRecord& record);
std::string closure_costs_csv(const CostRecord& record);
std::string corrector_costs_csv(const CostRecord& record);
std::string contact_orders_csv(const CostRecord& record);

// One line a measured value, with the model's and the difference; one line a parameter.
std::string fit_csv(const FitRecord& record);
std::string parameters_csv(const FitRecord& record);

// One line a value, with peak, s1, end and s2 of every probe.
std::string sensitivity_csv(const SensitivityRecord& record);

// Of single runs over a parameter: one line an impact, one for a value that has none; and one line
// a value with what its probes saw.
std::string run_impacts_csv(const RunDiagramRecord& record);
std::string runs_csv(const RunDiagramRecord& record);

// One line a cell that was run, row by row; attractors by their numbers in result.json.
std::string map_csv(const MapRecord& record);

// Motions side by side: one line a motion, with its differences from the one before; one line an
// impact. Over a plane: one line a cell that was run.
std::string comparison_csv(const ComparisonRecord& record);
std::string first_impacts_csv(const ComparisonRecord& record);
std::string comparison_csv(const ComparisonMapRecord& record);

// One line a sample, one for a value that has none.
std::string sweep_csv(const DiagramRecord& record);
// One line a value, with all Lyapunov exponents; empty cells for minus infinity.
std::string exponents_csv(const DiagramRecord& record);

}  // namespace graze
