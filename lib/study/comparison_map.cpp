#include "graze/study/comparison_map.hpp"

#include <optional>
#include <utility>

#include "graze/base/errors.hpp"

namespace graze {
namespace {

// Nothing where it was stopped.
std::optional<ComparedCell> compared_cell(const Scene& one, const Scene& other,
                                          const ComparisonMapOptions& options, std::size_t i) {
  ComparedCell cell;
  cell.is_known = true;
  try {
    const auto first = compared_motion(scene_at(one, options, i), options);
    if (!first) return {};
    const auto second = compared_motion(scene_at(other, options, i), options);
    if (!second) return {};
    cell.one = first->attractor;
    cell.other = second->attractor;
    cell.difference = difference(*first, *second, options);
    cell.message = first->message.empty() ? second->message : first->message;
  } catch (const InputError& error) {
    cell.message = error.what();
  }
  return cell;
}

}  // namespace

ComparisonMap compare_over(const Scene& one, const Scene& other,
                           const ComparisonMapOptions& options) {
  require_plane(one, options);
  require_plane(other, options);
  ComparisonMap map;
  map.options = options;
  map.options.progress = nullptr;
  map.options.memory = {};
  MadePieces<ComparedCell> made = make_pieces<ComparedCell>(
      "cell", options.cells(), options,
      [&](std::size_t i) { return compared_cell(one, other, options, i); });
  for (std::optional<ComparedCell>& cell : made.pieces)
    map.cells.push_back(cell ? std::move(*cell) : ComparedCell{});
  if (!made.is_complete) map.stopped = options.stop.reason();
  return map;
}

}  // namespace graze
