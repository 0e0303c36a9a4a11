// Results as charts (chart.hpp), for pictures and pages.
#pragma once

#include "graze/base/vector.hpp"
#include "graze/record/record_names.hpp"
#include "graze/report/chart/chart.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// The orbits found, at most eight, a row each: the motion at the stop of the first one's first
// impact over the orbit's periods, its impacts marked and its stuck phases shaded, and the phase
// portrait.
Chart chart_of(const OrbitRecord& record);
// The same for a page: all orbits in one phase plane, and below it over time. Its things are the
// orbits.
Chart explored_chart(const OrbitRecord& record);

// Measured values as dots, with the fitted model as a line, a panel for each series; below each the
// residuals, with bars of their uncertainties if these are known.
Chart chart_of(const FitRecord& record);

// Error over computing time per forcing period, both logarithmic: a line for each flow with a mark
// for each of its settings, the settings that no other beats in both, and the tolerance of the
// scene; below, where a stop is compliant, the order of steps across a contact.
Chart chart_of(const CostRecord& record);

// Two motions over time at the first stop, displacement and velocity. For a series of numbers of
// modes the sizes of the differences from one to the next.
Chart chart_of(const ComparisonRecord& record);

// s1 and s2 of the probes over the parameter, in per cent, a curve for each value of the other one.
Chart chart_of(const SensitivityRecord& record);

// Single runs over a parameter: the speed of every impact as a dot, a panel for each stop; below,
// the largest size of each probe.
Chart chart_of(const RunDiagramRecord& record);

// Branches of orbits over their parameter: the speed of every impact, or the record's amplitude, a
// curve each, divided by stability, with the special points. `multipliers`: the largest one in a
// panel below.
Chart chart_of(const BranchRecord& record, bool multipliers = false);
// Every sample of the sweep as a dot: impact speeds, or displacements towards the stops, a panel
// each, and exponents; over them the branches.
Chart chart_of(const DiagramRecord& record, bool multipliers = false);

// The same for a page: its things are the motions, any two of whose numbers may be its axes.
Chart explored_chart(const BranchRecord& record);
Chart explored_chart(const DiagramRecord& record);

// Loci in the plane of two parameters, each kind in a colour and a dash of its own; parts whose
// orbits are none of the system grey. Points of codimension two are marked and named; what is
// stable, where the record has it, is a ground below.
Chart chart_of(const LociRecord& record);

// The plane of two numbers, a ground for each attractor, or a scale of colours for the shown
// quantity; with the loci over it.
Chart chart_of(const MapRecord& record);
// The same for a page: its cells are things, shown by what they settle on or by any of their
// numbers.
Chart explored_chart(const MapRecord& record);
Chart explored_chart(const ComparisonMapRecord& record);
// Likewise by what is stable where, if the record has it.
Chart explored_chart(const LociRecord& record);
// Over a plane, a ground for what both motions settle on, or a scale for a difference.
Chart chart_of(const ComparisonMapRecord& record);

// The first six mode shapes of a structure, each by its largest value: of a beam over its length;
// of matrices whose nodes have coordinates its bars, displaced, in the plane of their largest
// extents, a panel each mode, else over the degrees of freedom. `omega`: of the modes, rad/s.
Chart mode_shapes_chart(const Scene& scene, const Vector& omega);

// The shapes of the beam at the record's instants, with its stops.
Chart shapes_chart(const SimulationRecord& record);

// The force of every stop over time, each in a panel; for more than four stops rows in one panel,
// all to one scale. On compliant stops the force itself, of the samples in the record; means over
// windows where the stop is rigid, and for all stops if they were requested.
Chart forces_chart(const SimulationRecord& record);
// Whether means were requested.
bool shows_force_means(const SimulationRecord& record);

// Amplitudes over the frequency at the places of the stops, from the samples in the record.
Chart spectrum_chart(const SimulationRecord& record);
// The power spectral density at the first places that were measured, of a run with statistics.
Chart psd_chart(const SimulationRecord& record);

// The recorded samples over time: displacement at every place that has stops (the first four), with
// the impacts and the phases in which it was stuck; velocity at the first of them; probes; contact
// forces where there were any; the energy, when the samples carry its balance, and the work done on
// it since the first sample. Below, the phase portraits of the first two places. Without stops all
// of it for the first modal coordinate.
Chart motion_chart(const SimulationRecord& record);
// The same for a page, with every impact and no portrait; the first panels show the displacements
// at the places, in their order, then comes the velocity at the first.
Chart explored_chart(const SimulationRecord& record);

// The Poincare section of the run: speed over phase of its impacts, or velocity over displacement
// once a forcing period; a colour for each stop.
Chart section_chart(const SimulationRecord& record);

// The speed and the phase of each impact of the record's section over those of the previous one.
Chart returns_chart(const SimulationRecord& record);

}  // namespace graze
