#include "graze/report/text/detail/text_plane.hpp"

#include <fmt/format.h>

#include "graze/report/text/detail/number_text.hpp"

namespace graze {
namespace {

std::string axis_text(const PlaneAxis& axis, const std::string& unit) {
  return fmt::format("{} from {} to {}", axis.name, digits_text(axis.from, 6),
                     quantity_text(axis.to, 6, unit));
}

}  // namespace

std::string plane_text(const Plane& plane, const std::string& x_unit, const std::string& y_unit) {
  return fmt::format("{} by {} cells, {}, {}\n", plane.x.points, plane.y.points,
                     axis_text(plane.x, x_unit), axis_text(plane.y, y_unit));
}

}  // namespace graze
