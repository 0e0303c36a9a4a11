#include "graze/report/picture/detail/picture_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace graze {
namespace {

enum Tint : int { kAsked, kDoubled, kClear, kAskedAndMore, kSeveral, kSticking, kRest, kTints };

// The smallest place that a label takes, as parts of the axes: so much for each character and for
// each line.
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

// How many cells of an area lie in any box that begins at the grid's corner.
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

  // Whether all the cells of a box belong to it.
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

// The middle of the widest room for a label within an area, in cells.
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
  // Ever more room around it; of several places that have it the one nearest to the innermost.
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

}  // namespace

RegionTints::RegionTints(const StableRegions& regions, const PicturePlane& plane)
    : regions_(regions), plane_(plane) {
  const RegionPlace &first = regions.places.front(), &last = regions.places.back();
  mirrored_x_ = last.value < first.value;
  mirrored_y_ = last.second < first.second;
  for (const RegionPlace& place : regions.places)
    tints_.push_back(tint_of(place.stable, regions.period, regions.impacts));
}

double RegionTints::x(double column) const {
  const double part = column / regions_.columns;
  return plane_.x.low + plane_.x.span() * (mirrored_x_ ? 1.0 - part : part);
}

double RegionTints::y(double row) const {
  const double part = row / regions_.rows;
  return plane_.y.low + plane_.y.span() * (mirrored_y_ ? 1.0 - part : part);
}

int RegionTints::tint_at(int column, int row) const {
  return tints_[static_cast<std::size_t>(row * regions_.columns + column)];
}

// Equal cells side by side are one box, and equal boxes one above the other.
std::vector<RegionTints::Box> RegionTints::boxes() const {
  std::vector<Box> list;
  for (int row = 0; row < regions_.rows; ++row)
    for (int first = 0; first < regions_.columns;) {
      const int tint = tint_at(first, row);
      int last = first;
      while (last + 1 < regions_.columns && tint_at(last + 1, row) == tint) ++last;
      const auto below = std::find_if(list.begin(), list.end(), [&](const Box& box) {
        return box.end == row && box.first == first && box.last == last && box.tint == tint;
      });
      if (tint >= 0 && below != list.end())
        ++below->end;
      else if (tint >= 0)
        list.push_back({first, last, row, row + 1, tint});
      first = last + 1;
    }
  return list;
}

void RegionTints::write(GnuplotScript& script) const {
  std::array<PlotTable, kTints> tables;
  for (const Box& box : boxes()) {
    const double left = x(box.first), right = x(box.last + 1), low = y(box.row), high = y(box.end);
    tables[static_cast<std::size_t>(box.tint)].row({0.5 * (left + right), 0.5 * (low + high),
                                                    std::min(left, right), std::max(left, right),
                                                    std::min(low, high), std::max(low, high)});
  }
  for (std::size_t tint = 0; tint < kTints; ++tint)
    if (!tables[tint].empty()) script.data(fmt::format("stable{}", tint), tables[tint]);
}

// The asked motion and its doubled one have their own ground in every picture.
std::string RegionTints::colour_of(int tint) const {
  const auto of_motion = [&](int times, std::size_t other) -> std::string {
    const Look* fixed = fixed_ground(asked(times));
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

// The outline, of the same colour, covers the hair of white that smoothed edges leave between two.
std::string RegionTints::fill_of(int tint) const {
  const std::string colour = colour_of(tint);
  return fmt::format("lc rgb '{0}' lw 0.3 fs solid border lc rgb '{0}'", colour);
}

std::string RegionTints::asked(int times) const {
  return name_of({AttractorKind::kOrbit, times * regions_.period, times * regions_.impacts});
}

std::vector<std::string> RegionTints::layers() const {
  std::vector<std::string> layers;
  for (int tint = 0; tint < kTints; ++tint)
    if (std::find(tints_.begin(), tints_.end(), tint) != tints_.end())
      layers.push_back(fmt::format("$stable{} with boxxyerror {} notitle", tint, fill_of(tint)));
  return layers;
}

std::string RegionTints::tint_title(int tint) const {
  switch (tint) {
    case kAsked:
      return asked(1) + " alone";
    case kDoubled:
      return asked(2) + " alone";
    case kClear:
      return "no impact alone";
    case kAskedAndMore:
      return asked(1) + " and others";
    case kSeveral:
      return "several, no " + asked(1);
    case kSticking:
      return "sticks alone";
    default:
      return "other motion alone";
  }
}

std::vector<std::string> RegionTints::legend() const {
  std::vector<std::string> entries;
  for (int tint = 0; tint < kTints; ++tint)
    if (std::find(tints_.begin(), tints_.end(), tint) != tints_.end())
      entries.push_back(fmt::format("NaN with boxes {} title {}", fill_of(tint),
                                    gnuplot_string(tint_title(tint))));
  return entries;
}

void RegionTints::label(GnuplotScript& script, LabelRoom& room_for_words) const {
  const std::size_t count = std::min(regions_.areas.size(), kMostLabels);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::string> lines = lines_of(regions_.areas[i].stable, false);
    if (lines.empty()) continue;
    std::optional<Room> room = room_for(regions_, static_cast<int>(i), lines);
    if (!room) {
      lines = lines_of(regions_.areas[i].stable, true);
      room = room_for(regions_, static_cast<int>(i), lines);
    }
    if (!room) continue;
    room_for_words.take(lines, x(room->column), y(room->row));
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const double above = 0.5 * static_cast<double>(lines.size() - 1) - static_cast<double>(k);
      script.command(
          fmt::format("set label {} at {:.9g}, {:.9g} center offset 0, {:.3g} front "
                      "font medium",
                      gnuplot_string(lines[k]), x(room->column), y(room->row), above));
    }
  }
}

}  // namespace graze
