#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/names/plane_names.hpp"
#include "graze/report/text/detail/folding.hpp"
#include "graze/report/text/detail/sentences.hpp"
#include "graze/report/text/detail/text_plane.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

std::string number(const std::optional<double>& value, int digits = 6) {
  return value && std::isfinite(*value) ? digits_text(*value, digits) : "-";
}

std::string motions_text(const ComparisonRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  Table table({"motion", "settles on", in.head("first impact", "s"), in.head("its speed", "m/s"),
               in.head("mean energy", "J"), in.head("lost at the stops", "J/period")});
  for (std::size_t i = 0; i < record.motions.size(); ++i) {
    const ComparedMotion& motion = record.motions[i];
    std::optional<double> time, speed;
    if (!motion.first.empty()) {
      time = motion.first.front().time;
      speed = motion.first.front().speed;
    }
    table.add({record.names[i], attractor_title(motion.attractor), number(time, 9), number(speed),
               number(motion.energy), number(motion.taken)});
  }
  return table.text(options.width);
}

// The differences of each motion from the previous one.
std::string differences_text(const ComparisonRecord& record, const TextOptions& options) {
  Table table({"difference", "first impacts that agree", "first impact (periods)", "its speed (%)",
               "displacement (%)", "velocity (%)", "mean energy (%)", "lost at the stops (%)"});
  for (std::size_t i = 0; i < record.differences.size(); ++i) {
    const MotionDifference& difference = record.differences[i];
    const auto percent = [](std::optional<double> part) {
      if (part) *part *= 100.0;
      return number(part, 4);
    };
    table.add({fmt::format("{} to {}", record.names[i], record.names[i + 1]),
               fmt::format("{} of {}", difference.agreeing, difference.first),
               number(difference.first_time, 4), percent(difference.first_speed),
               percent(difference.displacement), percent(difference.velocity),
               percent(difference.energy), percent(difference.taken)});
  }
  return table.text(options.width);
}

std::string first_impacts_text(const ComparisonRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  const std::vector<RunImpact>&one = record.motions[0].first, &other = record.motions[1].first;
  bool several = false;  // stops are hit
  for (const std::vector<RunImpact>* impacts : {&one, &other})
    for (const RunImpact& impact : *impacts) several = several || impact.stop > 0;
  std::vector<std::string> header = {"impact"};
  for (int motion = 0; motion < 2; ++motion) {
    if (several) header.emplace_back("stop");
    header.insert(header.end(), {in.head("time", "s"), in.head("speed", "m/s")});
  }
  Table table(header);
  for (std::size_t k = 0; k < std::max(one.size(), other.size()); ++k) {
    std::vector<std::string> row = {std::to_string(k + 1)};
    for (const std::vector<RunImpact>* impacts : {&one, &other}) {
      const bool has = k < impacts->size();
      if (several) row.push_back(has ? std::to_string((*impacts)[k].stop + 1) : "-");
      row.push_back(has ? decimals_text((*impacts)[k].time, 9) : "-");
      row.push_back(has ? digits_text((*impacts)[k].speed, 9) : "-");
    }
    table.add(row);
  }
  return fmt::format("first impacts: {}, then {}\n", record.names[0], record.names[1]) +
         table.text(options.width);
}

// "median 0.12, nine in ten below 0.5, largest 2" of the sizes.
std::string spread_text(std::vector<double> sizes) {
  if (sizes.empty()) return "-";
  std::sort(sizes.begin(), sizes.end());
  const auto at = [&](double part) {
    return sizes[static_cast<std::size_t>(part * static_cast<double>(sizes.size() - 1))];
  };
  return fmt::format("median {:.3g}, nine in ten within {:.3g}, largest {:.3g}", at(0.5), at(0.9),
                     sizes.back());
}

}  // namespace

std::string to_text(const ComparisonRecord& record, const TextOptions& options) {
  std::string text = motions_text(record, options);
  if (!record.differences.empty()) text += "\n" + differences_text(record, options);
  if (record.motions.size() == 2 && record.differences[0].first > 0)
    text += "\n" + first_impacts_text(record, options);
  return text + (record.outcome.message.empty() ? "" : "\n" + ending(record.outcome));
}

std::string to_text(const ComparisonMapRecord& record, const TextOptions& options) {
  const ComparisonMap& map = record.map;
  std::map<std::string, std::size_t> names;
  for (const ComparedCell& cell : map.cells) ++names[cell_name(cell)];
  std::vector<std::pair<std::string, std::size_t>> counts(names.begin(), names.end());
  std::stable_sort(counts.begin(), counts.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text = fmt::format("{} against {}: {}", record.one, record.other,
                                 plane_text(map.options, record.x_unit, record.y_unit));
  Table table({"settle on", "cells", "part"});
  std::vector<std::size_t> shares;
  for (const auto& [name, cells] : counts) shares.push_back(cells);
  const std::size_t all = map.cells.size();
  const std::vector<bool> is_folded = folded_groups(shares, all);
  Folded folded;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto& [name, cells] = counts[i];
    if (is_folded[i])
      folded.add(cells);
    else
      table.add({name, std::to_string(cells), share_text(cells, all)});
  }
  text += table.text(options.width) + folded.text(all) + "\n";
  for (const ComparedQuantity quantity : kComparedQuantities) {
    if (quantity == ComparedQuantity::kAttractor) continue;
    std::vector<double> sizes;
    for (const ComparedCell& cell : map.cells)
      if (is_comparable(cell) && std::isfinite(compared_value(cell.difference, quantity)))
        sizes.push_back(std::abs(compared_value(cell.difference, quantity)));
    const std::size_t count = sizes.size();
    text += fmt::format("{}: {} ({} cells)\n", title_of(quantity), spread_text(std::move(sizes)),
                        count);
  }
  return text + (record.outcome.message.empty() ? "" : "\n" + ending(record.outcome));
}

}  // namespace graze
