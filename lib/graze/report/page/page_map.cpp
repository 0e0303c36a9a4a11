#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/json/detail/json_page_orbits.hpp"
#include "graze/report/page/detail/page_plane.hpp"
#include "graze/report/page/page.hpp"
#include "graze/study/sweep/settled_row.hpp"

namespace graze {
namespace {

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

// What the motions of the map do, with the cells that they are of.
void add_motions(const MapRecord& record, const Scene& scene, PageCells& page) {
  // Ctrl-C ends it; a budget of time was the map's.
  PageSource source{record.info, "", record.map.options.closure_speed};
  source.stop.interrupted = record.map.options.stop.interrupted;
  const std::vector<CellMotion> motions = motions_of(record, scene, source);
  std::vector<Json> made(motions.size());
  for_each_index(motions.size(), record.map.options.threads, [&](std::size_t i) {
    if (!source.stop.requested()) made[i] = cell_motion(source, record, scene, motions[i]);
  });
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (made[i].is_null()) continue;
    bytes += document_text(made[i]).size();
    if (bytes > kMostBytes && !page.kept.empty()) break;
    page.kept.push_back(static_cast<std::int32_t>(motions[i].cell));
    page.motions.push_back(std::move(made[i]));
  }
}

// At some 20 bytes a cell a browser still reads the file.
constexpr std::size_t kMostCells = 4'000'000;

Json command_json(const MapRecord& record, const Scene& scene) {
  const AttractorMapOptions& options = record.map.options;
  std::string after = fmt::format(" --periods {}", options.periods);
  if (options.closure_speed) after += fmt::format(" --closure-speed {}", *options.closure_speed);
  if (options.max_impacts != kDefaultImpactBudget)
    after += fmt::format(" --max-impacts {}", options.max_impacts);
  return cell_command_json(page_command(record.info, "simulate", {}), after + " --plot cell.html",
                           options, scene);
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
  PageCells cells;
  cells.message = [&](std::size_t i) -> const std::string& { return map.cells[i].message; };
  cells.command = command_json(record, scene);
  for (const MapAttractor& attractor : map.attractors) {
    const bool wild = attractor.attractor.status == SweepStatus::kNotPeriodic;
    cells.remarks.push_back(
        wild ? fmt::format("The numbers are those of the last {} forcing periods; a run agrees "
                           "with the map until rounding errors have grown.",
                           map.options.samples)
             : "");
    // Starts in one basin lead to one orbit.
    cells.is_one_motion.push_back(!wild && map.is_of_starts);
  }
  add_motions(record, scene, cells);
  const Chart chart = explored_chart(record);
  write_plane(file, chart, chart_view(chart, record.info, record.outcome, record.warnings, {}, {}),
              &cells, record.loci ? &*record.loci : nullptr);
}

}  // namespace graze
