#include <fmt/format.h>

#include <map>

#include "graze/base/errors.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/json/detail/json_page_map.hpp"
#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/picture/detail/map_legend.hpp"
#include "graze/scene/detail/start_coordinate.hpp"

namespace graze {
namespace {

// At some 20 bytes a cell a browser still reads the file.
constexpr std::size_t kMostCells = 4'000'000;
constexpr std::size_t kMostMessages = 1'000;  // different ones

Json axis_of(const PlaneAxis& axis, const std::string& unit) {
  Json json = page_axis(parameter_title(axis.name), unit, cell_range(axis), 0.0);
  json["path"] = axis.name;
  json["hertz"] = has_hertz_axis(axis.name);
  std::vector<double> values;
  for (int i = 0; i < axis.points; ++i) values.push_back(axis.value(i));
  json["values"] = packed(values);
  return json;
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

Json number_json(const AttractorMap& map, MapQuantity quantity) {
  const auto of = [&](std::size_t i) { return cell_value(map.cells[i], quantity); };
  const CellBar bar = cell_bar(map.cells.size(), of, scale_of(quantity));
  std::vector<float> values;
  for (std::size_t i = 0; i < map.cells.size(); ++i) values.push_back(static_cast<float>(of(i)));
  return {{"key", name_of(quantity)},  {"name", title_of(quantity)},
          {"unit", unit_of(quantity)}, {"factor", 1.0},
          {"low", bar.range.low},      {"high", bar.range.high},
          {"colours", bar.colours},    {"values", packed(values)}};
}

// The sentences of cells, each once, and which cell has which; nothing where none has any.
Json messages_json(const AttractorMap& map) {
  std::map<std::string, std::int32_t> known;
  Json texts = Json::array();
  std::vector<std::int32_t> of(map.cells.size(), -1);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const std::string& message = map.cells[i].message;
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

Json cells_json(const AttractorMap& map) {
  const MapLegend legend = map_legend(map);
  Json entries = Json::array(), kinds = Json::array();
  for (const auto& [name, colour] : legend.entries)
    entries.push_back({{"name", name}, {"colour", colour}});
  for (const auto& [name, entry] : legend.kinds) {
    const std::size_t i = kinds.size();
    const bool wild = i < map.attractors.size() &&
                      map.attractors[i].attractor.status == SweepStatus::kNotPeriodic;
    kinds.push_back(
        {{"name", name}, {"entry", entry}, {"wild", wild}, {"cells", 0}, {"first", -1}});
  }
  for (std::size_t i = legend.kind_of.size(); i-- > 0;) {
    if (legend.kind_of[i] < 0) continue;
    Json& kind = kinds[static_cast<std::size_t>(legend.kind_of[i])];
    kind["cells"] = kind["cells"].get<std::size_t>() + 1;
    kind["first"] = i;
  }
  return {{"entries", entries},
          {"kinds", kinds},
          {"kind", packed_kinds(legend)},
          {"messages", messages_json(map)}};
}

// What stands before and after the settings of a cell in the command that follows its motion, and
// the start that its coordinates replace numbers of.
Json command_json(const MapRecord& record, const Scene& scene) {
  const AttractorMapOptions& options = record.map.options;
  std::string after = fmt::format(" --periods {}", options.periods);
  if (options.closure_speed) after += fmt::format(" --closure-speed {}", *options.closure_speed);
  if (options.max_impacts != kDefaultImpactBudget)
    after += fmt::format(" --max-impacts {}", options.max_impacts);
  Json command = {{"before", page_command(record.info, "simulate", {})},
                  {"after", after + " --plot cell.html"}};
  Scene started = scene;
  for (const PlaneAxis* axis : {&options.x, &options.y})
    if (names_start_coordinate(axis->name)) start_coordinate(started, axis->name);
  if (started.initial)
    command["start"] = {{"q", started.initial->q}, {"qdot", started.initial->qdot}};
  return command;
}

}  // namespace

void check_map_page(const std::string& file, const Plane& plane) {
  if (plane.cells() > kMostCells)
    throw InputError(fmt::format(
        "{}: a page of a map holds {} cells at most, and this map has {}; give fewer --points or "
        "--second-points, or draw a picture (.svg, .png or .pdf)",
        file, kMostCells, plane.cells()));
}

void write_page(const std::string& file, const MapRecord& record, const Scene& scene) {
  const AttractorMap& map = record.map;
  Json view = page_view(record.info, record.outcome, record.warnings, {});
  view["kind"] = "map";
  view["title"] = map.is_of_starts ? "Basins of attraction" : "Map of attractors";
  view["subtitle"] = scene.title;
  view["x"] = axis_of(map.options.x, record.x_unit);
  view["y"] = axis_of(map.options.y, record.y_unit);
  view["cells"] = cells_json(map);
  view["shown"] = name_of(record.shown);
  view["samples"] = map.options.samples;
  Json numbers = Json::array();
  for (const MapQuantity quantity : kMapQuantities)
    if (quantity != MapQuantity::kAttractor &&
        (quantity != MapQuantity::kExponent || map.options.exponent_periods > 0))
      numbers.push_back(number_json(map, quantity));
  view["numbers"] = numbers;
  view["command"] = command_json(record, scene);
  Json orbits = Json::array();
  view["motions"] = cell_motions_json(record, scene, orbits);
  view["is_of_starts"] = map.is_of_starts;
  view["loci"] = locus_lines_json(record);
  write_page_file(file, view, orbits);
}

}  // namespace graze
