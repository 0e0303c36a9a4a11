#include "graze/report/picture/detail/gnuplot_looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

// The point types of a shape: filled, and as an outline.
struct PointTypes {
  int filled, outline;
};

PointTypes types_of(MarkShape shape) {
  switch (shape) {
    case MarkShape::kSquare:
      return {5, 4};
    case MarkShape::kDiamond:
      return {13, 12};
    case MarkShape::kUp:
      return {9, 8};
    case MarkShape::kDown:
      return {11, 10};
    case MarkShape::kPentagon:
      return {15, 14};
    case MarkShape::kCross:
      return {2, 2};
    case MarkShape::kPlus:
      return {1, 1};
    case MarkShape::kStar:
      return {3, 3};
    default:
      return {7, 6};
  }
}

}  // namespace

int point_type(const Look& look) {
  const PointTypes types = types_of(look.mark);
  return look.open ? types.outline : types.filled;
}

std::string dashes_of(const Look& look) {
  if (look.dashes.empty()) return " dt solid";
  std::string lengths;
  for (const int length : look.dashes)
    lengths += (lengths.empty() ? "" : ",") + std::to_string(length);
  return " dt (" + lengths + ")";
}

std::string line_of(const Look& look, double weight) {
  return fmt::format("with lines lw {:.3g}{} lc rgb '{}'", weight * look.width, dashes_of(look),
                     look.colour);
}

std::string mark_of(const Look& look, double scale) {
  // Crosses have no face: their strokes are as wide as two outlines.
  const bool crosses = look.mark == MarkShape::kCross || look.mark == MarkShape::kPlus;
  const double width = crosses ? 2.0 * look.width : look.width;
  return fmt::format("with points pt {} ps {:.2f}*mark lw {:.3g} lc rgb '{}'", point_type(look),
                     look.size * scale, width, look.colour);
}

void add_marks(std::vector<std::string>& layers, const std::string& table, const Look& look,
               double scale) {
  if (look.open)
    layers.push_back(fmt::format("{} with points pt {} ps {:.2f}*mark lc rgb '#FFFFFF'", table,
                                 types_of(look.mark).filled, look.size * scale));
  layers.push_back(table + " " + mark_of(look, scale));
}

}  // namespace graze
