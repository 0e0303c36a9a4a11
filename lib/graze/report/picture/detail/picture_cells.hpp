// A plane of two numbers as a picture, a colour for every cell.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/picture/picture_style.hpp"
#include "graze/study/plane/detail/plane.hpp"

namespace graze {

struct Colour {
  double red = 255.0, green = 255.0, blue = 255.0;  // 0..255
};
Colour colour_of(const std::string& hex);  // "#0072B2"

struct CellColours {
  std::function<Colour(std::size_t cell)> of;
  std::vector<std::pair<std::string, std::string>> legend;  // name, colour
};

enum class CellScale {
  kAsIs,      // from dark to bright
  kFromZero,  // the same with zero among them
  kSigned,    // away from zero in two hues
  kUnbounded  // likewise, only as far below zero as above: smaller ones may have no bound
};

// Numbers as colours: what a range spans, from one end of five colours to the other.
struct CellBar {
  AxisRange range;
  std::array<const char*, 5> colours;

  Colour at(double value) const;  // of a finite number; the ends' beyond them
};
// Of so many cells; what is not finite is left out.
CellBar cell_bar(std::size_t cells, const std::function<double(std::size_t cell)>& of,
                 CellScale scale);

// What the cells of an axis span, SI: they reach half their width beyond the values at their
// middles.
AxisRange cell_range(const PlaneAxis& axis);

struct CellNumbers {
  std::function<double(std::size_t cell)> of;  // not finite: none
  // Why it has none: "clear of the stops", "not run", ..; one ground each, and the legend says so.
  std::function<std::string(std::size_t cell)> without;
  std::string title;  // of the bar beside the axes, a gnuplot string
  CellScale scale = CellScale::kFromZero;
};

// A plane with what made it, the SI units of its axes, and the loci over it, or null.
struct DrawnPlane {
  const RunInfo& info;
  const Plane& plane;
  std::string x_unit, y_unit;
  const OrbitLoci* loci = nullptr;
};

// Throw FileError as the pictures do.
void draw_cells(const PictureRequest& request, const DrawnPlane& plane, const CellColours& colours);
void draw_cells(const PictureRequest& request, const DrawnPlane& plane, const CellNumbers& numbers);

}  // namespace graze
