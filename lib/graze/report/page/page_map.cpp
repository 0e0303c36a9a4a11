#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/record/detail/map_record.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/json/detail/json_page_orbits.hpp"
#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/picture/detail/map_legend.hpp"
#include "graze/report/picture/detail/picture_locus_curves.hpp"
#include "graze/scene/detail/start_coordinate.hpp"
#include "graze/study/sweep/settled_row.hpp"

namespace graze {
namespace {

// What the page of a map has besides the numbers of its cells: the motions
// that some of them settle on, and the loci over them.

// Of all motions together; a page of more is slow to send and to open.
constexpr std::size_t kMostBytes = 8'000'000;

// A number of a cell that says nothing of where it is (Knuth's multiplicative hash).
std::uint32_t shuffled(std::size_t cell) { return static_cast<std::uint32_t>(cell) * 2654435761u; }

Json cell_motion(const PageSource& source, const MapRecord& record, const Scene& scene,
                 const CellMotion& motion) {
  try {
    Json json = page_motion(
        source, assemble(scene_at(scene, record.map.options, motion.cell)),
        {record.map.cells[motion.cell].attractor, motion.start, std::nullopt, {}, "map"});
    // The page has the command that comes here from the cell's own start.
    if (json.is_object()) json.erase("command");
    return json;
  } catch (const InputError&) {
    return nullptr;  // what cannot be followed again is not shown
  }
}

// The motion of a cell that the map did not keep.
std::optional<CellMotion> settled_again(const MapRecord& record, const Scene& scene,
                                        std::size_t cell, const StopSignal& stop) {
  RowOptions options = record.map.options;
  options.exponent_periods = 0;
  options.stop = stop;
  SweepRow row;
  const Scene there = scene_at(scene, record.map.options, cell);
  const System system = assemble(there);
  if (!settle_row(there, system, initial_state(there, system), options, row)) return {};
  if (row.motion.period_states.empty()) return {};
  return CellMotion{cell, row.motion.period_states.front()};
}

// One of each attractor first, then the others in an order that is spread over the plane however
// many of them there is room for.
std::vector<CellMotion> motions_of(const MapRecord& record, const Scene& scene,
                                   const PageSource& source) {
  const AttractorMap& map = record.map;
  std::vector<CellMotion> kept = map.motions, others;
  std::stable_sort(kept.begin(), kept.end(), [](const CellMotion& a, const CellMotion& b) {
    return shuffled(a.cell) < shuffled(b.cell);
  });
  std::vector<std::optional<CellMotion>> firsts(map.attractors.size());
  for (CellMotion& motion : kept) {
    const int place = map.cells[motion.cell].place;
    if (place >= 0 && !firsts[static_cast<std::size_t>(place)])
      firsts[static_cast<std::size_t>(place)] = std::move(motion);
    else
      others.push_back(std::move(motion));
  }
  for_each_index(firsts.size(), map.options.threads, [&](std::size_t i) {
    if (!firsts[i]) firsts[i] = settled_again(record, scene, map.attractors[i].first, source.stop);
  });
  std::vector<CellMotion> motions;
  for (std::optional<CellMotion>& motion : firsts)
    if (motion) motions.push_back(std::move(*motion));
  motions.insert(motions.end(), others.begin(), others.end());
  return motions;
}

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

// Adds what the motions of the map do to `orbits`; the cells that they are of, in their order.
Json cell_motions_json(const MapRecord& record, const Scene& scene, Json& orbits) {
  // Ctrl-C ends it; a budget of time was the map's.
  PageSource source{record.info, "", record.map.options.closure_speed};
  source.stop.interrupted = record.map.options.stop.interrupted;
  const std::vector<CellMotion> motions = motions_of(record, scene, source);
  std::vector<Json> made(motions.size());
  for_each_index(motions.size(), record.map.options.threads, [&](std::size_t i) {
    if (!source.stop.requested()) made[i] = cell_motion(source, record, scene, motions[i]);
  });
  std::vector<std::int32_t> cells;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (made[i].is_null()) continue;
    bytes += document_text(made[i]).size();
    if (bytes > kMostBytes && !cells.empty()) break;
    cells.push_back(static_cast<std::int32_t>(motions[i].cell));
    orbits.push_back(std::move(made[i]));
  }
  return packed(cells);
}

// The lines of all loci, by kind, and the points of codimension two; null without any.
Json locus_lines_json(const MapRecord& record) {
  if (!record.loci) return nullptr;
  std::map<OrbitLocusKind, BrokenLine> real;
  BrokenLine not_real;
  Json special = Json::array();
  for (const OrbitLocus& locus : record.loci->loci) {
    for (const LocusPart& part : locus_parts(locus))
      (part.is_real ? real[locus.kind] : not_real).add(locus, part);
    for (const OrbitLocusSpecial& point : locus.special)
      special.push_back({{"id", point.id}, {"x", point.at.value}, {"y", point.at.second}});
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
