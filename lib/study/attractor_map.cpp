#include "graze/study/attractor_map.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/even_values.hpp"
#include "graze/base/parallel.hpp"
#include "graze/base/tally.hpp"
#include "graze/hybrid/simulation.hpp"
#include "graze/orbit/shooting.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/start_coordinate.hpp"

namespace graze {
namespace {

Scene with_value(Scene scene, const std::string& name, double value) {
  if (!names_start_coordinate(name)) return with_parameter(scene, name, value);
  start_coordinate(scene, name) = value;
  return scene;
}

class Mapper {
 public:
  Mapper(const Scene& scene, const AttractorMapOptions& options) : scene_(scene) {
    map_.options = options;
    map_.options.progress = nullptr;
    map_.options.memory = {};
    map_.is_of_starts =
        names_start_coordinate(options.x.name) && names_start_coordinate(options.y.name);
    const auto count =
        static_cast<std::size_t>(options.x.points) * static_cast<std::size_t>(options.y.points);
    map_.cells.resize(count);
    strobes_.resize(count);
    progress_ = options.progress;
    memory_ = options.memory;
  }

  AttractorMap finish() {
    const std::size_t count = map_.cells.size();
    Tally tally(progress_, map_.options.share.count(count));
    for_each_index(count, map_.options.threads, [&](std::size_t i) {
      if (!map_.options.share.has(i) || map_.options.stop.requested()) return;
      std::optional<SettledCell> settled =
          memory_.get(piece_name("cell", i), [&] { return run(i); });
      if (!settled) return;
      map_.cells[i] = std::move(settled->cell);
      strobes_[i] = std::move(settled->strobes);
      tally.add();
    });
    if (!tally.is_complete()) map_.stopped = map_.options.stop.reason();
    name_attractors();
    return std::move(map_);
  }

 private:
  // Nothing where it was stopped before it was settled.
  std::optional<SettledCell> run(std::size_t i) const {
    SettledCell settled;
    MapCell& cell = settled.cell;
    const auto columns = static_cast<std::size_t>(map_.options.x.points);
    SweepRow row;
    try {
      const double x = map_.options.x.value(static_cast<int>(i % columns));
      const double y = map_.options.y.value(static_cast<int>(i / columns));
      const Scene scene =
          with_value(with_value(scene_, map_.options.x.name, x), map_.options.y.name, y);
      const System system = assemble(scene);
      if (!settle_row(scene, system, initial_state(scene, system), map_.options, row)) return {};
      look_at(scene, system, row, cell);
    } catch (const InputError& error) {
      row.status = SweepStatus::kNoStart;
      row.message = error.what();
    }
    cell.attractor = attractor_class(row);
    cell.message = row.message;
    if (row.exponents && row.exponents->values.size() > 0) cell.exponent = row.exponents->values[0];
    cell.is_known = true;
    settled.strobes = std::move(row.motion.strobes);
    return settled;
  }

  // Over what is shown of the motion, once more, for what its events do not tell.
  void look_at(const Scene& scene, const System& system, const SweepRow& row, MapCell& cell) const {
    for (const MetImpact& impact : row.motion.impacts)
      cell.peak_speed = std::max(cell.peak_speed, impact.speed);
    const long long turns = row.motion.period > 0 ? row.motion.period : map_.options.samples;
    if (!row.motion.sticks)
      cell.impacts_per_period =
          static_cast<double>(row.motion.impacts.size()) / static_cast<double>(turns);
    if (row.motion.kind == SettledKind::kAtRest) cell.stuck_part = 1.0;
    if (!row.motion.sticks || row.motion.kind == SettledKind::kAtRest) return;
    SimulationOptions options;
    options.duration = static_cast<double>(turns) * system.period();
    options.max_impacts = map_.options.max_impacts;
    options.closure_speed = closure_speed_of(scene, system, map_.options);
    const Simulation again = simulate(system, row.motion.at_end, options, {});
    cell.stuck_part = again.totals.stuck_time / *options.duration;
  }

  static bool is_attractor(const MapCell& cell) {
    return cell.is_known && (cell.attractor.status == SweepStatus::kSettled ||
                             cell.attractor.status == SweepStatus::kNotPeriodic);
  }

  // In the order of the cells, so that the names do not depend on who was first to finish.
  void name_attractors() {
    std::optional<ShootingScale> scale;
    if (map_.is_of_starts) scale = shooting_scale(assemble(scene_));
    // Each is as near to its orbit as asked for, in its own way.
    const double apart = 16.0 * map_.options.nearness;
    std::multimap<AttractorClass, int> known;
    for (std::size_t i = 0; i < map_.cells.size(); ++i) {
      MapCell& cell = map_.cells[i];
      if (!is_attractor(cell)) continue;
      const auto [first, last] = known.equal_range(cell.attractor);
      const auto same = std::find_if(first, last, [&](const auto& entry) {
        const MapAttractor& other = map_.attractors[static_cast<std::size_t>(entry.second)];
        return !scale || cell.attractor.status != SweepStatus::kSettled ||
               are_same_strobes(*scale, strobes_[i], other.strobes, apart);
      });
      if (same != last) {
        cell.place = same->second;
      } else {
        cell.place = static_cast<int>(map_.attractors.size());
        known.emplace(cell.attractor, cell.place);
        map_.attractors.push_back({cell.attractor, i, 0, std::move(strobes_[i])});
      }
      ++map_.attractors[static_cast<std::size_t>(cell.place)].cells;
    }
    order_attractors();
  }

  void order_attractors() {
    std::vector<std::size_t> order(map_.attractors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return map_.attractors[a].cells > map_.attractors[b].cells;
    });
    std::vector<int> place(order.size());
    std::vector<MapAttractor> sorted;
    for (std::size_t k = 0; k < order.size(); ++k) {
      place[order[k]] = static_cast<int>(k);
      sorted.push_back(std::move(map_.attractors[order[k]]));
    }
    map_.attractors = std::move(sorted);
    for (MapCell& cell : map_.cells)
      if (cell.place >= 0) cell.place = place[static_cast<std::size_t>(cell.place)];
  }

  const Scene& scene_;
  AttractorMap map_;
  std::vector<std::vector<State>> strobes_;
  std::function<void(double)> progress_;
  PieceMemory<SettledCell> memory_;
};

}  // namespace

double MapAxis::value(int i) const { return even_value(from, to, i, points); }

AttractorMap map_attractors(const Scene& scene, const AttractorMapOptions& options) {
  for (const MapAxis* axis : {&options.x, &options.y}) {
    Scene copy = scene;
    if (names_start_coordinate(axis->name))
      start_coordinate(copy, axis->name);
    else
      parameter_direction(scene, axis->name);
  }
  if (options.x.name == options.y.name)
    throw InputError(options.y.name + ": both axes are this one; give two that differ");
  return Mapper(scene, options).finish();
}

std::string axis_unit_of(const Scene& scene, const std::string& name) {
  return names_start_coordinate(name) ? start_coordinate_unit(name) : parameter_unit(scene, name);
}

}  // namespace graze
