// Gnuplot scripts with their data, and the pictures that gnuplot draws from them.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "graze/record/file/run_info.hpp"
#include "graze/report/picture/detail/picture_sheet.hpp"
#include "graze/report/picture/picture_request.hpp"

namespace graze {

// Rows of numbers for one layer of a picture. Lines drawn through the rows break at a gap.
class PlotTable {
 public:
  // A row with a number that is not finite becomes a gap.
  void row(std::initializer_list<double> numbers);
  void gap();

  bool empty() const { return rows_ == 0; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t rows_ = 0;
};

// A gnuplot script in the making, all but its terminal and output, and its data, which stand in a
// file of their own. Point sizes in units of the variable `mark`, which comes with the terminal,
// look the same in every file format, and so do spacings of a legend in units of `legend_line`
// and the fonts `small` and `medium` of 8 and 9 points. Heights on the screen are in units of the
// variable `body`, above which the picture's caption stands. Where a picture has another width than
// 12 cm, or another height than its layout, text keeps its room: twelfths of a width of 12 cm are
// those of the sheet times `across`, parts of the height that was laid out those of the sheet times
// `upward`.
class GnuplotScript {
 public:
  void command(const std::string& line);
  // Defines the table as $name, for layers that begin with it.
  void data(const std::string& name, const PlotTable& table);
  // One plot of several layers, each as gnuplot writes it: "$name using 1:2 with lines"; without
  // layers the bare axes, whose ranges must be set then. Layers of empty tables are left out.
  void plot(const std::vector<std::string>& layers);

  const std::string& text() const { return text_; }
  const std::string& data_text() const { return data_; }

 private:
  std::string text_, data_;
  std::set<std::string> known_;  // tables with rows
  bool has_caption_ = false;
};

// `text` as a gnuplot string; _ and ^ in it lower and raise, {} group.
std::string gnuplot_string(const std::string& text);
// The same for text without markup.
std::string plain_gnuplot_string(const std::string& text);

// Draws the script into the requested file, and keeps it beside the picture as x.gp with its data
// as x.gp.dat, so that `gnuplot x.gp`, run in that folder, draws the picture again. Throws
// FileError, leaving all files as they were, when gnuplot is missing or fails, or the folder cannot
// be written to.
void draw_picture(const PictureRequest& request, const RunInfo& info, const GnuplotScript& script,
                  const Canvas& canvas);

// A layer of very many dots, drawn as pixels. A vector picture with a shape for each of them would
// be megabytes large.
struct PixelLayer {
  GnuplotScript script;       // draws the layer over the whole of its canvas
  int width = 0, height = 0;  // of the canvas, pixels
};

// The same with a layer of pixels: where `script` is run, the variable `pixels` names a PNG file
// that shows the layer on a transparent ground. The script that is kept makes that file, x.dots.png
// for x.svg, anew.
void draw_picture(const PictureRequest& request, const RunInfo& info, const GnuplotScript& script,
                  const Canvas& canvas, const PixelLayer& layer);

}  // namespace graze
