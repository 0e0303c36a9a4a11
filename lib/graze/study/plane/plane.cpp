#include "graze/study/plane/plane.hpp"

#include "graze/base/errors.hpp"
#include "graze/base/even_values.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/start_coordinate.hpp"

namespace graze {

double PlaneAxis::value(int i) const { return even_value(from, to, i, points); }

std::size_t Plane::cells() const {
  return static_cast<std::size_t>(x.points) * static_cast<std::size_t>(y.points);
}

std::size_t Plane::cell(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(x.points) +
         static_cast<std::size_t>(column);
}

double Plane::x_at(std::size_t cell) const {
  return x.value(static_cast<int>(cell % static_cast<std::size_t>(x.points)));
}

double Plane::y_at(std::size_t cell) const {
  return y.value(static_cast<int>(cell / static_cast<std::size_t>(x.points)));
}

void require_plane(const Scene& scene, const Plane& plane) {
  for (const PlaneAxis* axis : {&plane.x, &plane.y}) {
    Scene copy = scene;
    if (names_start_coordinate(axis->name))
      start_coordinate(copy, axis->name);
    else
      parameter_direction(scene, axis->name);
    if (axis->from == axis->to)
      throw InputError(axis->name + ": its range must not be empty; give two ends that differ");
  }
  if (are_same_parameter(plane.x.name, plane.y.name))
    throw InputError(plane.y.name + ": both axes are this one; give two that differ");
}

Scene scene_at(const Scene& scene, const Plane& plane, std::size_t cell) {
  return with_number(with_number(scene, plane.x.name, plane.x_at(cell)), plane.y.name,
                     plane.y_at(cell));
}

}  // namespace graze
