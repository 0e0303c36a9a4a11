// Results as pictures. Gnuplot draws them; the script and its data stay beside the picture, so that
// it can be changed and drawn again without the run: x.svg comes with x.gp and x.gp.dat.
#pragma once

#include <string>

#include "graze/record/file/run_info.hpp"
#include "graze/record/record_names.hpp"
#include "graze/report/chart/chart.hpp"
#include "graze/report/picture/picture_request.hpp"

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
void draw_simulation(const PictureRequest& request, const SimulationRecord& record);

// The Poincare section of the run: speed over phase of its impacts, or velocity over displacement
// once a forcing period; a colour for each stop. In .svg and .pdf the dots are pixels of 0.06 mm.
void draw_section(const PictureRequest& request, const SimulationRecord& record);

// A chart of any result (chart/charts.hpp).
void draw_chart(const PictureRequest& request, const RunInfo& info, const Chart& chart);

// The plane of two numbers, a colour for each attractor, or a scale of colours for what is shown;
// over it the loci, each kind in a dash of its own.
void draw_map(const PictureRequest& request, const MapRecord& record);

// Over a plane, a colour for what both motions settle on, or for a difference.
void draw_comparison(const PictureRequest& request, const ComparisonMapRecord& record);

// The speed of every impact against the parameter, with stability and special points.
void draw_branches(const PictureRequest& request, const BranchRecord& record);

// Loci in the plane of two parameters, each kind in a colour and a dash of its own; parts whose
// orbits are none of the system grey. Points of codimension two are marked, and named while they
// are few.
void draw_loci(const PictureRequest& request, const LociRecord& record);

// Every sample of the sweep as a dot against the parameter: impact speeds, or displacements towards
// the stops, a panel each; over them the branches, stable and unstable, with their special points.
// In .svg and .pdf the dots are pixels of 0.06 mm, all else is lines and text.
void draw_diagram(const PictureRequest& request, const DiagramRecord& record);

}  // namespace graze
