// The sheet of a picture: its size, its font, and its caption.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graze/record/file/run_info.hpp"
#include "graze/report/picture/picture_request.hpp"

namespace graze {

// The sheet of a picture, in centimetres of a layout, in which the names of axes have 8 points.
struct Canvas {
  double width = 12.0;
  double height = 9.0;    // without the caption
  double laid_out = 9.0;  // the height for which the layout is computed
  double caption = 0.0;   // above it
  double scale = 1.0;     // of text, lines and marks on paper

  // The number of columns that have the width of `columns` in 12 cm, at least one.
  std::size_t columns(std::size_t columns) const;
};
// The canvas of a layout that is `natural` cm high unless another height is requested.
Canvas canvas_of(const PictureRequest& request, const RunInfo& info, double natural);

// The subject of the picture, in a line or two: the scene's title, else its file, and what was set
// in it; or the requested title.
std::vector<std::string> caption_of(const PictureRequest& request, const RunInfo& info,
                                    double width);
// gnuplot's terminal for the file, its size and its font, and the units of a script that come with
// it (GnuplotScript).
std::string terminal_of(const PictureRequest& request, const Canvas& canvas);

}  // namespace graze
