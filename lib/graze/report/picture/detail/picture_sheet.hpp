// The sheet that a picture is drawn on: its size, its font, and what stands at its head.
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
  double laid_out = 9.0;  // the height that the layout reckons with
  double caption = 0.0;   // above it
  double scale = 1.0;     // of text, lines and marks on paper

  // As many columns as have the room of `columns` in a width of 12 cm, one at least.
  std::size_t columns(std::size_t columns) const;
};
// Of a layout that is `natural` cm high unless another height is asked for.
Canvas canvas_of(const PictureRequest& request, const RunInfo& info, double natural);

// What the picture is of, in a line or two: the scene's title, else its file, and what was set in
// it; or what was asked for.
std::vector<std::string> caption_of(const PictureRequest& request, const RunInfo& info,
                                    double width);
// gnuplot's terminal for the file, its size and its font, and the units of a script that come with
// it (GnuplotScript).
std::string terminal_of(const PictureRequest& request, const Canvas& canvas);

}  // namespace graze
