// The results as tables, which become comma-separated text: header row first, no comment lines,
// numbers with all their digits, empty cells for what does not exist. Units stand in result.json.
#pragma once

#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/motion/run_events.hpp"
#include "graze/motion/sample.hpp"
#include "graze/record/record_names.hpp"
#include "graze/report/csv/result_table.hpp"

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
ResultTable events_table(const std::vector<Event>& events);
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
ResultTable forces_table(const StopForces& forces);

// One line a point: "time,stop,phase,speed" or "time,stop,displacement,velocity".
ResultTable section_table(const RunSection& section);

ResultTable orbits_table(const OrbitRecord& record);
// Their motions over one period: a line a sample, flight by flight from impact to impact with the
// ends of each, so that an impact has a line before and one after it.
ResultTable profiles_table(const OrbitRecord& record);
// The stuck phases of the orbits.
ResultTable stuck_table(const OrbitRecord& record);
// Their contacts at compliant stops.
ResultTable contacts_table(const OrbitRecord& record);
ResultTable branches_table(const BranchRecord& record);
ResultTable special_table(const BranchRecord& record);
ResultTable loci_table(const OrbitLoci& traced);
ResultTable special_table(const LociRecord& record);
// One line a place; labels may hold commas.
ResultTable regions_table(const StableRegions& regions);

// One line a flow and setting.
ResultTable costs_table(const CostRecord& record);
ResultTable mode_costs_table(const CostRecord& record);
ResultTable closure_costs_table(const CostRecord& record);
ResultTable corrector_costs_table(const CostRecord& record);
ResultTable contact_orders_table(const CostRecord& record);

// One line a measured value, with the model's and the difference; one line a parameter.
ResultTable fit_table(const FitRecord& record);
ResultTable parameters_table(const FitRecord& record);

// One line a value, with peak, s1, end and s2 of every probe.
ResultTable sensitivity_table(const SensitivityRecord& record);

// Of single runs over a parameter: one line an impact, one for a value that has none; and one line
// a value with what its probes saw.
ResultTable run_impacts_table(const RunDiagramRecord& record);
ResultTable runs_table(const RunDiagramRecord& record);

// One line a cell that was run, row by row; attractors by their numbers in result.json.
ResultTable map_table(const MapRecord& record);

// Motions side by side: one line a motion, with its differences from the one before; one line an
// impact. Over a plane: one line a cell that was run.
ResultTable comparison_table(const ComparisonRecord& record);
ResultTable first_impacts_table(const ComparisonRecord& record);
ResultTable comparison_table(const ComparisonMapRecord& record);

// One line a sample, one for a value that has none.
ResultTable sweep_table(const DiagramRecord& record);
// One line a value, with all Lyapunov exponents; empty cells for minus infinity.
ResultTable exponents_table(const DiagramRecord& record);

}  // namespace graze
