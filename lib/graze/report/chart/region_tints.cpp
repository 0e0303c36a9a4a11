#include "graze/report/chart/detail/region_tints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "graze/record/names/motion_names.hpp"
#include "graze/report/appearance/looks.hpp"

namespace graze {
namespace {

enum Tint : int { kAsked, kDoubled, kClear, kAskedAndMore, kSeveral, kSticking, kRest, kTints };

// The smallest space for a label, relative to the axes: for each character and for each line.
constexpr double kRegionCharacter = 0.018, kRegionLine = 0.055;
constexpr std::size_t kMostLabels = 24;

int tint_of(const StableNames& stable, int period, int impacts) {
  const MotionName asked{AttractorKind::kOrbit, period, impacts};
  const MotionName doubled{AttractorKind::kOrbit, 2 * period, 2 * impacts};
  if (stable.empty()) return -1;
  if (stable.size() > 1)
    return std::find(stable.begin(), stable.end(), asked) == stable.end() ? kSeveral
                                                                          : kAskedAndMore;
  const MotionName& only = stable.front();
  if (only == asked) return kAsked;
  if (only == doubled) return kDoubled;
  switch (only.kind) {
    case AttractorKind::kClear:
      return kClear;
    case AttractorKind::kSticks:
    case AttractorKind::kAtRest:
      return kSticking;
    default:
      return kRest;
  }
}

// Over several lines: "(1,1)", "+ no impact"; narrow: "(1,1)", "+ no", "impact".
std::vector<std::string> lines_of(const StableNames& stable, bool narrow) {
  std::vector<std::string> lines;
  for (const MotionName& name : stable) {
    const std::string line = (lines.empty() ? "" : "+ ") + name_of(name);
    const std::size_t space = narrow ? line.rfind(' ') : std::string::npos;
    if (space == std::string::npos || space < 2) {
      lines.push_back(line);
      continue;
    }
    lines.push_back(line.substr(0, space));
    lines.push_back(line.substr(space + 1));
  }
  return lines;
}

// Counts the cells of an area in any box that begins at the grid's corner.
class CellSums {
 public:
  CellSums(const StableRegions& regions, int area)
      : columns_(regions.columns),
        sums_(static_cast<std::size_t>((regions.columns + 1) * (regions.rows + 1))) {
    for (int row = 0; row < regions.rows; ++row)
      for (int column = 0; column < columns_; ++column) {
        const auto cell = static_cast<std::size_t>(row * columns_ + column);
        at(column + 1, row + 1) = at(column, row + 1) + at(column + 1, row) - at(column, row) +
                                  (regions.places[cell].area == area ? 1 : 0);
      }
  }

  // Whether all the cells of a box belong to the area.
  bool fills(int column, int row, int width, int height) {
    return at(column + width, row + height) - at(column, row + height) - at(column + width, row) +
               at(column, row) ==
           width * height;
  }

 private:
  int& at(int column, int row) {
    return sums_[static_cast<std::size_t>(row * (columns_ + 1) + column)];
  }
  int columns_;
  std::vector<int> sums_;
};

// The middle of the widest space for a label within an area, in cells.
struct Room {
  double column = 0.0, row = 0.0;
};
std::optional<Room> room_for(const StableRegions& regions, int area,
                             const std::vector<std::string>& lines) {
  std::size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  const double wide = kRegionCharacter * static_cast<double>(longest) * regions.columns;
  const double high = kRegionLine * static_cast<double>(lines.size()) * regions.rows;
  CellSums sums(regions, area);
  const std::size_t inner = regions.areas[static_cast<std::size_t>(area)].inner;
  const auto columns = static_cast<std::size_t>(regions.columns);
  const std::size_t column_of_inner = inner % columns, row_of_inner = inner / columns;
  const auto inner_column = static_cast<double>(column_of_inner);
  const auto inner_row = static_cast<double>(row_of_inner);
  std::optional<Room> best;
  // Ever larger spaces; of several possible places the one nearest to the innermost cell.
  for (double part = 1.0; part < 16.0; part *= 1.2) {
    const int width = static_cast<int>(std::ceil(part * wide));
    const int height = static_cast<int>(std::ceil(part * high));
    std::optional<Room> found;
    double nearest = 0.0;
    for (int row = 0; row + height <= regions.rows; ++row)
      for (int column = 0; column + width <= regions.columns; ++column) {
        if (!sums.fills(column, row, width, height)) continue;
        const Room room{column + 0.5 * width, row + 0.5 * height};
        const double away = std::hypot((room.column - inner_column) / regions.columns,
                                       (room.row - inner_row) / regions.rows);
        if (found && away >= nearest) continue;
        found = room;
        nearest = away;
      }
    if (!found) break;
    best = found;
  }
  return best;
}

// The name of the motion of the loci, with `times` its period and impacts: "(2,2)".
std::string asked(const StableRegions& regions, int times) {
  return name_of({AttractorKind::kOrbit, times * regions.period, times * regions.impacts});
}

// The motion of the loci and its doubled one have their own ground in every picture.
std::string colour_of(const StableRegions& regions, int tint) {
  const auto of_motion = [&](int times, std::size_t other) -> std::string {
    const Look* fixed = fixed_ground(asked(regions, times));
    return fixed ? fixed->colour : other_grounds()[other];
  };
  switch (tint) {
    case kAsked:
      return of_motion(1, 0);
    case kDoubled:
      return of_motion(2, 1);
    case kClear:
      return ground_look("clear").colour;
    case kAskedAndMore:
      return ground_look("asked and more").colour;
    case kSeveral:
      return ground_look("several").colour;
    case kSticking:
      return ground_look("sticks").colour;
    default:
      return ground_look("other").colour;
  }
}

std::string title_of(const StableRegions& regions, int tint) {
  switch (tint) {
    case kAsked:
      return "only " + asked(regions, 1);
    case kDoubled:
      return "only " + asked(regions, 2);
    case kClear:
      return "only no impact";
    case kAskedAndMore:
      return asked(regions, 1) + " and others";
    case kSeveral:
      return "several, without " + asked(regions, 1);
    case kSticking:
      return "only sticking";
    default:
      return "only other motions";
  }
}

// Names the largest areas that have space for it.
void name_areas(const StableRegions& regions, ChartPanel& panel) {
  const std::size_t count = std::min(regions.areas.size(), kMostLabels);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::string> lines = lines_of(regions.areas[i].stable, false);
    if (lines.empty()) continue;
    std::optional<Room> room = room_for(regions, static_cast<int>(i), lines);
    if (!room) {
      lines = lines_of(regions.areas[i].stable, true);
      room = room_for(regions, static_cast<int>(i), lines);
    }
    if (!room) continue;
    const auto at = [](const std::array<double, 2>& ends, double part) {
      return ends[0] + (ends[1] - ends[0]) * part;
    };
    panel.names.push_back({ChartName::Of::kArea,
                           fmt::format("{}", fmt::join(lines, "\n")),
                           {{at(panel.cells->x, room->column / regions.columns),
                             at(panel.cells->y, room->row / regions.rows)}}});
  }
}

struct RegionTints {
  std::vector<ChartCells::Ground> grounds;  // all that there may be
  std::vector<int> of;                      // of every place; -1: none
};
RegionTints region_tints(const StableRegions& regions) {
  RegionTints tints;
  for (int tint = 0; tint < kTints; ++tint)
    tints.grounds.push_back({title_of(regions, tint), colour_of(regions, tint)});
  for (const RegionPlace& place : regions.places)
    tints.of.push_back(tint_of(place.stable, regions.period, regions.impacts));
  return tints;
}

}  // namespace

MapLegend region_legend(const StableRegions& regions) {
  const RegionTints tints = region_tints(regions);
  MapLegend legend;
  std::map<int, std::size_t> entries;  // of tints
  std::map<std::string, int> kinds;
  for (std::size_t i = 0; i < regions.places.size(); ++i) {
    const RegionPlace& place = regions.places[i];
    if (!place.finished) {
      legend.kind_of.push_back(-1);
      continue;
    }
    const std::string label = label_of(place.stable);
    const auto [kind, is_new] = kinds.emplace(label, static_cast<int>(legend.kinds.size()));
    if (is_new) {
      const int tint = tints.of[i];
      const auto [entry, is_first] = entries.emplace(tint, legend.entries.size());
      if (is_first)
        legend.entries.push_back(
            tint < 0 ? MapLegend::Entry{"nothing stable found", ground_look("none").colour}
                     : MapLegend::Entry{tints.grounds[static_cast<std::size_t>(tint)].title,
                                        tints.grounds[static_cast<std::size_t>(tint)].colour});
      legend.kinds.push_back({label.empty() ? "nothing stable found" : label, entry->second});
    }
    legend.kind_of.push_back(kind->second);
  }
  return legend;
}

void add_tints(const StableRegions& regions, ChartPanel& panel) {
  const RegionPlace &first = regions.places.front(), &last = regions.places.back();
  // Panels have the requested range, which may be given from its upper end.
  const auto ends = [](const AxisRange& range, bool is_mirrored) {
    return is_mirrored ? std::array{range.high, range.low} : std::array{range.low, range.high};
  };
  RegionTints tints = region_tints(regions);
  panel.cells = ChartCells{.columns = static_cast<std::size_t>(regions.columns),
                           .rows = static_cast<std::size_t>(regions.rows),
                           .x = ends(panel.x.range, last.value < first.value),
                           .y = ends(panel.y.range, last.second < first.second),
                           .grounds = std::move(tints.grounds),
                           .ground = std::move(tints.of)};
  name_areas(regions, panel);
}

}  // namespace graze
