#include "graze/report/page/detail/page_plane.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <map>

#include "graze/report/chart/detail/chart_loci.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/scene/start_coordinate.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostMessages = 1'000;  // different ones

// Parts of loci one after the other, each ended by a NaN.
struct BrokenLine {
  std::vector<double> x, y;

  void add(const OrbitLocus& locus, const LocusPart& part) {
    for (std::size_t i = part.first; i <= part.last; ++i) {
      x.push_back(locus.points[i].value);
      y.push_back(locus.points[i].second);
    }
    constexpr double kEnd = std::numeric_limits<double>::quiet_NaN();
    x.push_back(kEnd), y.push_back(kEnd);
  }
};

// "fold and period doubling" of "LPPD".
std::string words_of(const std::string& label) {
  static const std::map<std::string, std::string> kWords = {{"CP", "cusp"},
                                                            {"R1", "1:1 resonance"},
                                                            {"R2", "1:2 resonance"},
                                                            {"R3", "1:3 resonance"},
                                                            {"R4", "1:4 resonance"}};
  if (const auto known = kWords.find(label); known != kWords.end()) return known->second;
  std::string words;
  for (std::size_t i = 0; i + 1 < label.size(); i += 2) {
    const std::string part = label.substr(i, 2);
    const std::string title = special_look(part).title;
    const std::string word =
        title.empty() ? part : title.substr(0, std::min(title.find(" ("), title.size()));
    words += (i > 0 ? " and " : "") + word;
  }
  return words;
}

// Bytes while they can count the kinds.
Json packed_kinds(const MapLegend& legend) {
  if (legend.kinds.size() < 255) {
    std::vector<std::uint8_t> kinds;
    for (const int kind : legend.kind_of)
      kinds.push_back(kind < 0 ? 255 : static_cast<std::uint8_t>(kind));
    return packed(kinds);
  }
  return packed(std::vector<std::int32_t>(legend.kind_of.begin(), legend.kind_of.end()));
}

// The sentences of cells, each once, and which cell has which; null where none has any.
Json messages_json(const PlaneCells& cells) {
  std::map<std::string, std::int32_t> known;
  Json texts = Json::array();
  std::vector<std::int32_t> of(cells.legend.kind_of.size(), -1);
  for (std::size_t i = 0; i < of.size(); ++i) {
    const std::string& message = cells.message(i);
    if (message.empty()) continue;
    auto at = known.find(message);
    if (at == known.end()) {
      if (known.size() == kMostMessages) continue;
      at = known.emplace(message, static_cast<std::int32_t>(known.size())).first;
      texts.push_back(message);
    }
    of[i] = at->second;
  }
  if (texts.empty()) return nullptr;
  return {{"texts", texts}, {"of", packed(of)}};
}

}  // namespace

Json plane_axis_json(const PlaneAxis& axis, const std::string& unit) {
  Json json = plane_axis_json(axis.name, unit, cell_range(axis));
  std::vector<double> values;
  for (int i = 0; i < axis.points; ++i) values.push_back(axis.value(i));
  json["values"] = packed(values);
  return json;
}

Json plane_axis_json(const std::string& parameter, const std::string& unit, AxisRange range) {
  Json json = page_axis(parameter_title(parameter), unit, range, 0.0);
  json["path"] = parameter;
  json["hertz"] = has_hertz_axis(parameter, unit);
  json["values"] = packed(std::vector<double>());
  return json;
}

Json cells_json(const PlaneCells& cells) {
  const MapLegend& legend = cells.legend;
  Json entries = Json::array(), kinds = Json::array();
  for (const auto& [name, colour] : legend.entries)
    entries.push_back({{"name", name}, {"colour", colour}});
  for (const auto& [name, entry] : legend.kinds) {
    const std::size_t i = kinds.size();
    const bool wild = i < cells.is_wild.size() && cells.is_wild[i];
    kinds.push_back(
        {{"name", name}, {"entry", entry}, {"wild", wild}, {"cells", 0}, {"first", -1}});
  }
  for (std::size_t i = legend.kind_of.size(); i-- > 0;) {
    if (legend.kind_of[i] < 0) continue;
    Json& kind = kinds[static_cast<std::size_t>(legend.kind_of[i])];
    kind["cells"] = kind["cells"].get<std::size_t>() + 1;
    kind["first"] = i;
  }
  return {{"name", cells.name},
          {"entries", entries},
          {"kinds", kinds},
          {"kind", packed_kinds(legend)},
          {"messages", messages_json(cells)}};
}

Json number_json(const PlaneNumber& number, std::size_t cells) {
  const CellBar bar = cell_bar(cells, number.of, number.scale);
  std::vector<float> values;
  for (std::size_t i = 0; i < cells; ++i) values.push_back(static_cast<float>(number.of(i)));
  Json json = page_axis(number.name, number.unit, bar.range, 0.0);
  // The colours span what the bar does, to the last digit.
  json["low"] = bar.range.low;
  json["high"] = bar.range.high;
  json["key"] = number.key;
  json["colours"] = bar.colours;
  json["values"] = packed(values);
  return json;
}

Json loci_json(const OrbitLoci* traced) {
  if (!traced) return nullptr;
  std::map<OrbitLocusKind, BrokenLine> real;
  BrokenLine not_real;
  Json special = Json::array();
  for (const OrbitLocus& locus : traced->loci) {
    for (const LocusPart& part : locus_parts(locus))
      (part.is_real ? real[locus.kind] : not_real).add(locus, part);
    for (const OrbitLocusSpecial& point : locus.special)
      special.push_back(
          {{"id", point.id},
           {"title", fmt::format("{}: {}, on locus {} ({})", point.id, words_of(point.label),
                                 locus.id, label_of(locus.kind))},
           {"x", point.at.value},
           {"y", point.at.second}});
  }
  Json lines = Json::array();
  const auto list = [&](const char* kind, const BrokenLine& line) {
    if (!line.x.empty())
      lines.push_back({{"kind", kind}, {"x", packed(line.x)}, {"y", packed(line.y)}});
  };
  list("virtual", not_real);
  for (const OrbitLocusKind kind : kOrbitLocusKinds) list(label_of(kind), real[kind]);
  return {{"lines", lines}, {"special", special}};
}

Json cell_command_json(const std::string& before, const std::string& after, const Plane& plane,
                       const Scene& scene) {
  Json command = {{"before", before}, {"after", after}};
  Scene started = scene;
  for (const PlaneAxis* axis : {&plane.x, &plane.y})
    if (names_start_coordinate(axis->name)) start_coordinate(started, axis->name);
  if (started.initial)
    command["start"] = {{"q", started.initial->q}, {"qdot", started.initial->qdot}};
  return command;
}

}  // namespace graze
