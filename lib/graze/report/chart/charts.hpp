// Results as charts (chart.hpp): what their pictures and their pages draw.
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

// What was measured as dots, with the fitted model as a line, a panel each series; below each the
// residuals, with bars of their uncertainties where they are known.
Chart chart_of(const FitRecord& record);

// Error over computing time per forcing period, both logarithmic: a line for each flow with a mark
// for each of its settings, the settings that no other beats in both, and the tolerance that the
// scene allows; below, where a stop is compliant, the order of steps across a contact.
Chart chart_of(const CostRecord& record);

// Two motions over time at the first stop, displacement and velocity. Of a series of numbers of
// modes the sizes of the differences from one to the next.
Chart chart_of(const ComparisonRecord& record);

// s1 and s2 of the probes over the parameter, in per cent, a curve for each value of the other one.
Chart chart_of(const SensitivityRecord& record);

// Single runs over a parameter: the speed of every impact as a dot, a panel each stop; below, the
// largest size that each probe saw.
Chart chart_of(const RunDiagramRecord& record);

// The first six mode shapes of a structure, each by its largest value: of a beam over its length;
// of matrices whose nodes have coordinates its bars, displaced, in the plane of their largest
// extents, a panel each mode, else over the degrees of freedom. `omega`: of the modes, rad/s.
Chart mode_shapes_chart(const Scene& scene, const Vector& omega);

// The shapes of the beam at the record's instants, with its stops.
Chart shapes_chart(const SimulationRecord& record);

// The force of every stop over time, each a panel; of more than four stops rows in one panel, all
// in one scale. On compliant stops the force itself, of the samples that the record holds; means
// over windows where the stop is rigid, and of all stops where they were asked for.
Chart forces_chart(const SimulationRecord& record);
// Whether means were asked for.
bool shows_force_means(const SimulationRecord& record);

// Amplitudes over the frequency at the places of the stops, of the samples that the record holds.
Chart spectrum_chart(const SimulationRecord& record);

// The speed and the phase of each impact of the record's section over those of the one before.
Chart returns_chart(const SimulationRecord& record);

}  // namespace graze
