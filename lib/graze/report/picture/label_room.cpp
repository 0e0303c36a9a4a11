#include "graze/report/picture/detail/label_room.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "graze/report/appearance/looks.hpp"

namespace graze {
namespace {

// All in cm of a picture 12 cm wide.
constexpr double kCell = 0.05;
constexpr double kCharacter = 0.17, kLine = 0.3;  // of a label's letters
constexpr double kMark = 0.16;                    // half of a mark's width, with its outline
// Distances of a label from its place, nearest first.
constexpr std::array kAway = {0.06, 0.22, 0.45, 0.8, 1.3};
constexpr double kLeader = 0.3;  // farther labels have a line to their place
constexpr unsigned char kOnDot = 1, kOnLine = 253, kOnMark = 254, kOnLabel = 255;

double characters_of(const std::string& text) {
  return static_cast<double>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

LabelRoom::LabelRoom(const LabelPlane& plane, double width, double height)
    : plane_(plane),
      width_(width),
      height_(height),
      columns_(static_cast<int>(std::ceil(width / kCell))),
      rows_(static_cast<int>(std::ceil(height / kCell))),
      taken_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void LabelRoom::fill(const Box& box, unsigned char with) {
  const auto cell = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at / kCell), -1.0, static_cast<double>(count)));
  };
  for (int row = std::max(0, cell(box.low, rows_));
       row <= std::min(rows_ - 1, cell(box.high, rows_)); ++row)
    for (int column = std::max(0, cell(box.left, columns_));
         column <= std::min(columns_ - 1, cell(box.right, columns_)); ++column) {
      unsigned char& taken = taken_[static_cast<std::size_t>(row * columns_ + column)];
      taken = std::max(taken, with);
    }
}

void LabelRoom::add_line(double x0, double y0, double x1, double y1) {
  double ax = cm_x(x0), ay = cm_y(y0), bx = cm_x(x1), by = cm_y(y1);
  if (!std::isfinite(ax + ay + bx + by)) return;
  // Only lines near the panel: next to a grazing a line may have no bound.
  if (std::max(ax, bx) < 0.0 || std::min(ax, bx) > width_ || std::max(ay, by) < 0.0 ||
      std::min(ay, by) > height_)
    return;
  const double most = 2.0 * (width_ + height_);
  const double length = std::min(std::hypot(bx - ax, by - ay), most);
  const int steps = static_cast<int>(std::ceil(length / kCell)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const double x = ax + part * (bx - ax), y = ay + part * (by - ay);
    fill({x, x, y, y}, kOnLine);
  }
}

void LabelRoom::add_dot(double x, double y) {
  const double at_x = cm_x(x), at_y = cm_y(y);
  if (std::isfinite(at_x + at_y)) fill({at_x, at_x, at_y, at_y}, kOnDot);
}

void LabelRoom::add_mark(double x, double y) {
  const double at_x = cm_x(x), at_y = cm_y(y);
  if (std::isfinite(at_x + at_y))
    fill({at_x - kMark, at_x + kMark, at_y - kMark, at_y + kMark}, kOnMark);
}

void LabelRoom::write_over(GnuplotScript& script, const std::string& text, double x, double y) {
  std::vector<std::string> lines;
  double longest = 0.0;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    longest = std::max(longest, characters_of(lines.back()));
    start = end + 1;
  }
  const auto count = static_cast<double>(lines.size());
  const double half_width = 0.5 * kCharacter * longest, half_height = 0.75 * kLine * count;
  fill({cm_x(x) - half_width, cm_x(x) + half_width, cm_y(y) - half_height, cm_y(y) + half_height},
       kOnLabel);
  for (std::size_t k = 0; k < lines.size(); ++k)
    script.command(
        fmt::format("set label {} at {:.9g}, {:.9g} center offset 0, {:.3g} front "
                    "font medium",
                    gnuplot_string(lines[k]), x, y, 0.5 * (count - 1.0) - static_cast<double>(k)));
}

// Returns nullopt when the box covers a mark or a label, is crossed by a line, or reaches out of
// the panel.
std::optional<double> LabelRoom::cost_of(const Box& box) const {
  if (box.left < 0.0 || box.right > width_ || box.low < 0.0 || box.high > height_) return {};
  double cost = 0.0;
  for (int row = static_cast<int>(box.low / kCell);
       row <= std::min(rows_ - 1, static_cast<int>(box.high / kCell)); ++row)
    for (int column = static_cast<int>(box.left / kCell);
         column <= std::min(columns_ - 1, static_cast<int>(box.right / kCell)); ++column) {
      const unsigned char taken = taken_[static_cast<std::size_t>(row * columns_ + column)];
      if (taken >= kOnLine) return {};
      cost += taken;
    }
  return cost;
}

std::optional<LabelRoom::Found> LabelRoom::best_near(const std::string& text, double x, double y,
                                                     bool on_curve) const {
  const double at_x = cm_x(x), at_y = cm_y(y);
  if (!(at_x >= 0.0 && at_x <= width_ && at_y >= 0.0 && at_y <= height_)) return {};
  const double half_width = 0.5 * kCharacter * characters_of(text), half_height = 0.5 * kLine;
  const double clear = on_curve ? 0.0 : kMark;
  std::optional<Found> best;
  for (const double away : kAway) {
    if ((on_curve || is_crowded_) && away > kLeader) break;
    // Clockwise from the upper right, where a reader expects a label.
    for (int k = 0; k < 16; ++k) {
      const double angle = std::numbers::pi * (0.25 + k / 8.0);
      const double c = std::cos(angle), s = std::sin(angle);
      // Far enough for the box to leave a circle about the place.
      const double reach = clear + away;
      const double box_x = at_x + reach * c + half_width * std::clamp(1.5 * c, -1.0, 1.0);
      const double box_y = at_y + reach * s + half_height * std::clamp(1.5 * s, -1.0, 1.0);
      const Box box{box_x - half_width, box_x + half_width, box_y - half_height,
                    box_y + half_height};
      const std::optional<double> cost = cost_of(box);
      if (!cost || (away > kLeader && meets_label(leader_to(box, at_x, at_y)))) continue;
      // A label over ten cells of lines costs as much as one a millimetre away.
      const double all = *cost + 100.0 * away + 0.1 * k;
      if (!best || all < best->cost) best = {{box, all, at_x, at_y, away}};
    }
  }
  return best;
}

LabelRoom::Leader LabelRoom::leader_to(const Box& box, double x, double y) {
  const double to_x = std::clamp(x, box.left, box.right), to_y = std::clamp(y, box.low, box.high);
  const double length = std::hypot(to_x - x, to_y - y);
  const double part = length > 0.0 ? std::min(kMark / length, 1.0) : 0.0;
  return {x + part * (to_x - x), y + part * (to_y - y), to_x, to_y};
}

bool LabelRoom::meets_label(const Leader& leader) const {
  for (int i = 0; i <= kLeaderSteps; ++i) {
    const auto [x, y] = leader.at(i);
    const int column = std::clamp(static_cast<int>(x / kCell), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>(y / kCell), 0, rows_ - 1);
    if (taken_[static_cast<std::size_t>(row * columns_ + column)] == kOnLabel) return true;
  }
  return false;
}

void LabelRoom::put(GnuplotScript& script, const std::string& text, const Found& found) {
  const Box& box = found.box;
  const double x = 0.5 * (box.left + box.right), y = 0.5 * (box.low + box.high);
  if (found.away > kLeader) {
    const Leader leader = leader_to(box, found.x, found.y);
    script.command(fmt::format(
        "set arrow from graph {:.5f}, graph {:.5f} to graph {:.5f}, graph {:.5f} nohead front lw "
        "0.5 lc rgb '{}'",
        leader.from_x / width_, leader.from_y / height_, leader.to_x / width_,
        leader.to_y / height_, kGrey));
    for (int i = 0; i <= kLeaderSteps; ++i) {
      const auto [at_x, at_y] = leader.at(i);
      fill({at_x, at_x, at_y, at_y}, kOnLine);
    }
  }
  if (is_on_ground_)
    script.command("set style textbox opaque margins 0.3,0.3 fillcolor rgb '#FFFFFF' noborder");
  script.command(fmt::format("set label {} at graph {:.5f}, graph {:.5f} center front font small{}",
                             gnuplot_string(text), x / width_, y / height_,
                             is_on_ground_ ? " boxed" : ""));
  // Keeps the width of a letter free beside the label.
  fill({box.left - kCharacter, box.right + kCharacter, box.low, box.high}, kOnLabel);
}

void LabelRoom::name(GnuplotScript& script, const std::vector<NamedPoint>& points) {
  struct Named {
    NamedPoint first;
    std::vector<std::string> ids;
  };
  std::vector<Named> places;
  for (const NamedPoint& point : points) {
    const auto same = std::find_if(places.begin(), places.end(), [&](const Named& place) {
      return std::hypot(cm_x(point.x) - cm_x(place.first.x), cm_y(point.y) - cm_y(place.first.y)) <
             kMark;
    });
    if (same == places.end())
      places.push_back({point, {point.id}});
    else
      same->ids.push_back(point.id);
  }
  constexpr std::size_t kMany = 24, kListed = 2;
  is_crowded_ = places.size() > kMany;
  for (const auto& [first, ids] : places)
    write(script,
          ids.size() > kListed ? fmt::format("{} and {} more", first.id, ids.size() - 1)
                               : fmt::format("{}", fmt::join(ids, ", ")),
          first.x, first.y);
}

bool LabelRoom::write(GnuplotScript& script, const std::string& text, double x, double y) {
  const std::optional<Found> found = best_near(text, x, y, false);
  if (found) put(script, text, *found);
  return found.has_value();
}

bool LabelRoom::write(GnuplotScript& script, const std::string& text,
                      const std::vector<std::pair<double, double>>& places) {
  std::optional<Found> best;
  for (const auto& [x, y] : places) {
    const std::optional<Found> found = best_near(text, x, y, true);
    if (found && (!best || found->cost < best->cost)) best = found;
  }
  if (best) put(script, text, *best);
  return best.has_value();
}

}  // namespace graze
