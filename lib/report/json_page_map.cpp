#include "graze/report/json_page_map.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/report/json_page_orbits.hpp"
#include "graze/report/picture_locus_curves.hpp"
#include "graze/scene/start_coordinate.hpp"

namespace graze {
namespace {

// Of all curves together, 12 bytes each, so that a page stays below some ten megabytes.
constexpr std::size_t kMostSamples = 250'000;

// What differs from the scene of the run but for the start, which a motion brings along.
std::vector<std::string> settings_of(const Plane& plane, std::size_t cell) {
  std::vector<std::string> settings;
  if (!names_start_coordinate(plane.x.name))
    settings.push_back(fmt::format("{}={}", plane.x.name, plane.x_at(cell)));
  if (!names_start_coordinate(plane.y.name))
    settings.push_back(fmt::format("{}={}", plane.y.name, plane.y_at(cell)));
  return settings;
}

Json cell_motion(const PageSource& source, const MapRecord& record, const Scene& scene,
                 const CellMotion& motion) {
  const AttractorMapOptions& plane = record.map.options;
  try {
    return page_motion(source, assemble(scene_at(scene, plane, motion.cell)),
                       {record.map.cells[motion.cell].attractor, motion.start, std::nullopt,
                        settings_of(plane, motion.cell), "map"});
  } catch (const InputError&) {
    return nullptr;  // what cannot be followed again is not shown
  }
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
  const std::vector<CellMotion>& motions = record.map.motions;
  if (motions.empty()) return nullptr;
  PageSource source{record.info, "", record.map.options.closure_speed};
  const System system = assemble(scene);
  const std::size_t fit =
      kMostSamples / static_cast<std::size_t>(page_samples(system, 1, source.most_samples));
  const std::vector<std::size_t> kept = kept_of(motions.size(), fit);
  std::vector<Json> made(kept.size());
  for_each_index(kept.size(), 0, [&](std::size_t i) {
    made[i] = cell_motion(source, record, scene, motions[kept[i]]);
  });
  std::vector<std::int32_t> cells;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (made[i].is_null()) continue;
    cells.push_back(static_cast<std::int32_t>(motions[kept[i]].cell));
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
