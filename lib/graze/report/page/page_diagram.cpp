#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "graze/assembly/system_family.hpp"
#include "graze/base/parallel.hpp"
#include "graze/bifurcation/loci/restart.hpp"
#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/record/names/motion_names.hpp"
#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_observables.hpp"
#include "graze/report/chart/detail/motion_things.hpp"
#include "graze/report/json/detail/json_page_orbits.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/page/page_tables.hpp"

namespace graze {
namespace {

// Orbits that a page keeps, of branches and of sweeps, and samples of their curves, 12 bytes each:
// so that it stays below some ten megabytes.
constexpr std::size_t kMostOfBranches = 1200, kMostOfSweeps = 800;
constexpr std::size_t kMostSamples = 250'000;

// What the points of a diagram open: motions of some of its things (motion_things.hpp).
class DiagramOrbits {
 public:
  DiagramOrbits(const BranchRecord& record, const Scene& scene, std::size_t things,
                std::size_t rows)
      : record_(record),
        family_(scene, record.traced.parameter),
        source_{record.info, record.traced.parameter, closure_speed()},
        fit_(kMostSamples /
             static_cast<std::size_t>(page_samples(record.system, 1, source_.most_samples))),
        numbers_(record.traced.branches, rows),
        of_(things, -1) {
    if (record.info.folder.empty()) return;
    for (const SpecialOrbit& special : special_orbits(record.traced, record.system))
      restartable_.insert(special.id);
  }

  void add_sweep(const Sweep& swept) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < swept.rows.size(); ++i)
      if (has_dots(swept.rows[i])) shown.push_back(i);
    std::vector<std::size_t> kept;
    for (const std::size_t i : kept_of(shown.size(), std::min(fit_, kMostOfSweeps)))
      kept.push_back(shown[i]);
    keep(kept, 0, [&](std::size_t i) -> Json {
      const SweepRow& row = swept.rows[i];
      const std::optional<System> system = family_.at(row.value);
      if (!system) return nullptr;
      return page_motion(source_, *system, page_motion_of(source_, row));
    });
  }

  // Special points are titled as in the chart.
  void add_branches(const ChartThings& things) {
    const std::vector<OrbitBranch>& branches = record_.traced.branches;
    const std::size_t most = std::min(fit_, kMostOfBranches);
    std::size_t points = 0, row = 0;
    for (const OrbitBranch& branch : branches) points += branch.points.size();
    for (std::size_t b = 0; b < branches.size(); ++b) {
      const OrbitBranch& branch = branches[b];
      const std::size_t share = points > most ? most * branch.points.size() / points : points;
      keep(kept_of(branch.points.size(), std::max<std::size_t>(2, share)), numbers_.of(b, 0),
           [&, row](std::size_t k) {
             return orbit_at(branch.points[k],
                             fmt::format("--from-orbit {} --orbit {}", folder(), row + k + 1));
           });
      row += branch.points.size();
      for (std::size_t k = 0; k < branch.special.size(); ++k) {
        const int thing = numbers_.of(b, -1 - static_cast<int>(k));
        keep({0}, thing, [&](std::size_t) {
          const SpecialPoint& special = branch.special[k];
          Json orbit = orbit_at(special.at,
                                restartable_.count(special.id) == 0
                                    ? ""
                                    : fmt::format("--restart {} --label {}", folder(), special.id));
          const int kind = things.kind[static_cast<std::size_t>(thing)];
          if (orbit.is_object()) orbit["name"] = things.kinds[static_cast<std::size_t>(kind)].title;
          return orbit;
        });
      }
    }
  }

  PageTable special_table(const ChartThings& things) const {
    PageTable table{
        "",
        {"", "special point", plain_text(parameter_title(record_.traced.parameter)), "branch", ""},
        {}};
    for (std::size_t b = 0; b < record_.traced.branches.size(); ++b)
      for (std::size_t k = 0; k < record_.traced.branches[b].special.size(); ++k) {
        const OrbitBranch& branch = record_.traced.branches[b];
        const SpecialPoint& special = branch.special[k];
        const std::string label = label_of(special.kind), title = special_look(label).title;
        const int thing = numbers_.of(b, -1 - static_cast<int>(k));
        std::string more;
        for (const auto& [name, value] : things.more.at(thing))
          more += fmt::format("{}{} {}", more.empty() ? "" : ", ", name, value);
        table.rows.push_back({special.id, title.empty() ? label : title,
                              measured_text(special.at.value, record_.unit, 10),
                              std::to_string(branch.id), more});
        table.opens.push_back(of_[static_cast<std::size_t>(thing)] < 0 ? -1 : thing);
      }
    table.name = fmt::format("{} special points", table.rows.size());
    return table;
  }

  void write(const std::string& file, Json view) const {
    std::vector<std::int32_t> kept(orbits_.size());
    for (std::size_t thing = 0; thing < of_.size(); ++thing)
      if (of_[thing] >= 0) kept[static_cast<std::size_t>(of_[thing])] = static_cast<int>(thing);
    view["things"]["kept"] = packed(kept);
    write_page_file(file, view, orbits_);
  }

 private:
  std::optional<double> closure_speed() const {
    for (const auto& [name, value] : record_.info.options)
      if (name == "closure_speed") return std::get<double>(value);
    return {};
  }

  // `told(index)`: of things from `first` on.
  template <class Told>
  void keep(const std::vector<std::size_t>& kept, int first, const Told& told) {
    std::vector<Json> made(kept.size());
    for_each_index(kept.size(), 0, [&](std::size_t i) { made[i] = told(kept[i]); });
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (made[i].is_null()) continue;
      of_[static_cast<std::size_t>(first) + kept[i]] = static_cast<std::int32_t>(orbits_.size());
      orbits_.push_back(std::move(made[i]));
    }
  }

  std::string folder() const { return shell_word(record_.info.folder); }

  // `start`: the options that continue from there, where the result is in a folder; empty: none do.
  Json orbit_at(const OrbitBranchPoint& point, const std::string& start) const {
    const std::optional<System> system = family_.at(point.value);
    if (!system) return nullptr;
    Json json = page_orbit(source_, *system, point.orbit, point.value);
    if (!record_.info.folder.empty() && !start.empty())
      json["command"] =
          fmt::format("{} {} --parameter {} --from {} --to {}",
                      page_command(record_.info, "continue", {}), start,
                      shell_word(record_.traced.parameter), record_.from, record_.to) +
          (point.orbit.admissible ? "" : " --virtual");
    return json;
  }

  const BranchRecord& record_;
  SystemFamily family_;
  PageSource source_;
  std::size_t fit_;  // orbits of one period that have that many samples
  MotionNumbers numbers_;
  std::set<std::string> restartable_;  // ids of special points
  std::vector<std::int32_t> of_;       // of each thing, an index into the orbits; -1: none
  Json orbits_ = Json::array();
};

void write_diagram(const std::string& file, const Chart& chart, const BranchRecord& record,
                   const Sweep* swept, const Scene& scene) {
  const ChartThings& things = *chart.things;
  DiagramOrbits orbits(record, scene, things.kind.size(), swept ? swept->rows.size() : 0);
  if (swept) orbits.add_sweep(*swept);
  orbits.add_branches(things);
  orbits.write(file, chart_view(chart, record.info, record.outcome, record.warnings,
                                record.traced.notes, {orbits.special_table(things)}));
}

}  // namespace

void write_page(const std::string& file, const BranchRecord& record, const Scene& scene) {
  write_diagram(file, explored_chart(record), record, nullptr, scene);
}

void write_page(const std::string& file, const DiagramRecord& record, const Scene& scene) {
  write_diagram(file, explored_chart(record), record.branches, &record.swept, scene);
}

}  // namespace graze
