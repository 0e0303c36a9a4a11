// Results as pictures. Gnuplot draws them; the script stays beside the picture with all its data,
// so that a picture can be changed and drawn again without the run: x.svg comes with x.gp.
#pragma once

#include <string>

#include "graze/record/record_names.hpp"

namespace graze {

// Throws InputError unless `file` ends in .svg, .png or .pdf. `allowed`: what the message says that
// it may end in.
void check_picture_name(const std::string& file, const char* allowed = ".svg, .png or .pdf");

// All throw FileError, leaving the files as they were, when gnuplot is missing or fails or the
// files cannot be written.

// The recorded samples over time: displacement at every place that has stops (the first four), with
// the impacts and the phases in which it was stuck; velocity at the first of them; contact forces
// where there were any; the energy, when the samples carry its balance, and the work done on it
// since the first sample. Below, the phase portraits of the first two places. Without stops all of
// it for the first modal coordinate.
void draw_simulation(const std::string& file, const SimulationRecord& record);

// The Poincare section of the run: speed over phase of its impacts, or velocity over displacement
// once a forcing period; a colour for each stop. In .svg and .pdf the dots are pixels of 0.06 mm.
void draw_section(const std::string& file, const SimulationRecord& record);

// Error over computing time per forcing period, both logarithmic: a line for each flow with a mark
// for each of its settings, open marks where the sequence of impacts was lost, and the settings
// that no other beats in both.
void draw_costs(const std::string& file, const CostRecord& record);

// What was measured as dots, with the fitted model as a line, a panel each series (the first four);
// below each the residuals, with bars of their uncertainties where they are known.
void draw_fit(const std::string& file, const FitRecord& record);

// s1 and s2 of the first three probes over the parameter, in per cent, a line for each value of the
// other one.
void draw_sensitivity(const std::string& file, const SensitivityRecord& record);

// Single runs over a parameter: the speed of every impact as a dot, a panel for each of the first
// three stops; below, the largest size that each of the first three probes saw.
void draw_run_diagram(const std::string& file, const RunDiagramRecord& record);

// The plane of two numbers, a colour for each attractor, or a scale of colours for what is shown;
// over it the loci, each kind in a dash of its own.
void draw_map(const std::string& file, const MapRecord& record);

// The recorded samples of two motions over time at the first stop, the second one dashed:
// displacement and velocity. Of a series of modes the differences from one to the next, on a
// logarithmic axis.
void draw_comparison(const std::string& file, const ComparisonRecord& record);
// Over a plane, a colour for what both motions settle on, or for a difference.
void draw_comparison(const std::string& file, const ComparisonMapRecord& record);

// Phase portrait of the orbits found, at most eight of them, seen at the stop of the first one's
// first impact.
void draw_orbits(const std::string& file, const OrbitRecord& record);

// The speed of every impact against the parameter, with stability and special points.
void draw_branches(const std::string& file, const BranchRecord& record);

// Loci in the plane of two parameters, each kind in a colour and a dash of its own; parts whose
// orbits are none of the system grey. Points of codimension two are marked, and named while they
// are few.
void draw_loci(const std::string& file, const LociRecord& record);

// Every sample of the sweep as a dot against the parameter: impact speeds, or displacements towards
// the stops, a panel each; over them the branches, stable and unstable, with their special points.
// In .svg and .pdf the dots are pixels of 0.06 mm, all else is lines and text.
void draw_diagram(const std::string& file, const DiagramRecord& record);

}  // namespace graze
