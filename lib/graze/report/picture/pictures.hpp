// Results as pictures. Gnuplot draws them; the script and its data are kept beside the picture, so
// that it can be changed and drawn again without the run: x.svg comes with x.gp and x.gp.dat.
#pragma once

#include <string>

#include "graze/record/file/run_info.hpp"
#include "graze/record/record_names.hpp"
#include "graze/report/chart/chart.hpp"
#include "graze/report/picture/picture_request.hpp"

namespace graze {

// Throws InputError unless `file` ends in .svg, .png or .pdf. `allowed`: the list of allowed
// endings in the message.
void check_picture_name(const std::string& file, const char* allowed = ".svg, .png or .pdf");

// All throw FileError, leaving the files as they were, when gnuplot is missing or fails or the
// files cannot be written.

// A chart of any result (chart/charts.hpp).
void draw_chart(const PictureRequest& request, const RunInfo& info, const Chart& chart);

}  // namespace graze
