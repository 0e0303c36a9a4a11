#include "graze/study/compare/comparison_map.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "graze/base/errors.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Returns nullopt when it was stopped.
std::optional<ComparedCell> compared_cell(const Scene& one, const Scene& other,
                                          const ComparisonMapOptions& options, std::size_t i) {
  ComparedCell cell;
  cell.is_known = true;
  try {
    const auto first = compared_motion(scene_at(one, options, i), options);
    if (!first) return {};
    cell.one = first->attractor;
    const auto second = compared_motion(scene_at(other, options, i), options);
    if (!second) return {};
    cell.other = second->attractor;
    cell.difference = difference(*first, *second, options);
    cell.message = first->message.empty() ? second->message : first->message;
  } catch (const InputError& error) {
    cell.message = error.what();
  }
  return cell;
}

// The plane sets its two numbers in both scenes; the scenes must differ in something else.
void require_difference(const Scene& one, const Scene& other, const Plane& plane) {
  try {
    if (write_scene(scene_at(one, plane, 0)) != write_scene(scene_at(other, plane, 0))) return;
  } catch (const InputError&) {
    return;  // a cell that one of them does not allow
  }
  throw InputError(fmt::format(
      "{}, {}: the plane sets both in either scene, and then nothing is left that differs",
      plane.x.name, plane.y.name));
}

}  // namespace

ComparisonMap compare_over(const Scene& one, const Scene& other,
                           const ComparisonMapOptions& options) {
  require_plane(one, options);
  require_plane(other, options);
  require_difference(one, other, options);
  ComparisonMap map;
  map.options = options;
  map.options.let_go();
  MadePieces<ComparedCell> made = make_pieces<ComparedCell>(
      "cell", options.cells(), options,
      [&](std::size_t i) { return compared_cell(one, other, options, i); });
  for (std::optional<ComparedCell>& cell : made.pieces)
    map.cells.push_back(cell ? std::move(*cell) : ComparedCell{});
  if (!made.is_complete) map.stopped = options.stop.reason();
  return map;
}

}  // namespace graze
