#include "graze/report/json/detail/json_page_map.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/report/json/detail/json_document.hpp"
#include "graze/report/json/detail/json_page_orbits.hpp"
#include "graze/report/picture/detail/picture_locus_curves.hpp"
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

}  // namespace

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

}  // namespace graze
