#include "graze/study/plane/attractor_map.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/orbit/problem/detail/shooting.hpp"
#include "graze/scene/start_coordinate.hpp"
#include "graze/study/sweep/detail/row_chains.hpp"

namespace graze {
namespace {

// At most `most` cells spread over a plane, in columns and rows at equal distances, about as many
// of either.
class SpreadCells {
 public:
  SpreadCells(const Plane& plane, std::size_t most)
      : columns_{plane.x.points}, rows_{plane.y.points} {
    while (columns_.count() * rows_.count() > most)
      ++(columns_.count() >= rows_.count() ? columns_ : rows_).stride;
  }

  bool has(std::size_t cell) const {
    const auto columns = static_cast<std::size_t>(columns_.points);
    return columns_.has(static_cast<int>(cell % columns)) &&
           rows_.has(static_cast<int>(cell / columns));
  }

 private:
  // Takes every stride-th, starting from the middle of the first stride.
  struct Axis {
    int points = 0, stride = 1;
    int first() const { return (std::min(stride, points) - 1) / 2; }
    std::size_t count() const {
      return static_cast<std::size_t>((points - 1 - first()) / stride + 1);
    }
    bool has(int i) const { return i >= first() && (i - first()) % stride == 0; }
  };

  Axis columns_, rows_;
};

class Mapper {
 public:
  Mapper(const Scene& scene, const AttractorMapOptions& options)
      : scene_(scene), kept_(options, AttractorMap::kMostMotions) {
    map_.options = options;
    map_.options.let_go();
    map_.is_of_starts =
        names_start_coordinate(options.x.name) && names_start_coordinate(options.y.name);
  }

  AttractorMap finish(const AttractorMapOptions& options) {
    const auto run = [&](Cells& cells, ProgressCounter& counter) {
      return side_by_side(options,
                          [&](std::size_t i) { return cell_chain(i, options, cells, counter); });
    };
    MadePieces<SettledCell> made = made_pieces<SettledCell>("cell", options.cells(), options, run);
    for (std::optional<SettledCell>& settled : made.pieces) {
      if (!settled) settled.emplace();
      map_.cells.push_back(std::move(settled->cell));
      period_states_.push_back(std::move(settled->period_states));
    }
    if (!made.is_complete) map_.stopped = options.stop.reason();
    name_attractors();
    list_motions();
    return std::move(map_);
  }

 private:
  using Cells = std::vector<std::optional<SettledCell>>;

  RowChain cell_chain(std::size_t i, const AttractorMapOptions& options, Cells& cells,
                      ProgressCounter& counter) const {
    const std::string name = piece_name("cell", i);
    if (options.memory.recall) cells[i] = options.memory.recall(name);
    if (!cells[i]) {
      if (options.stop.requested()) co_return false;
      SettledCell settled;
      RowRun run;
      if (begin(i, run)) {
        co_await run;
        if (!run.is_finished || !end(run, settled.cell)) co_return false;
      }
      describe(i, run.row, settled);
      if (!options.memory.take(name, settled)) co_return false;
      cells[i] = std::move(settled);
    }
    counter.add();
    co_return true;
  }

  // False where the cell has no start, which it then says.
  bool begin(std::size_t i, RowRun& run) const {
    try {
      run.scene = scene_at(scene_, map_.options, i);
      run.system = assemble(run.scene);
      run.start = initial_state(run.scene, run.system);
    } catch (const InputError& error) {
      run.row.status = SweepStatus::kNoStart;
      run.row.message = error.what();
      return false;
    }
    return true;
  }

  // Adds to a settled cell what its row does not contain; false where it was stopped.
  bool end(RowRun& run, MapCell& cell) const {
    if (map_.options.measure && !measure_row(run.scene, run.system, map_.options, run.row))
      return false;
    look_at(run.scene, run.system, run.row, cell);
    cell.amplitudes = run.row.amplitudes;
    return true;
  }

  void describe(std::size_t i, SweepRow& row, SettledCell& settled) const {
    MapCell& cell = settled.cell;
    cell.attractor = attractor_class(row);
    cell.message = row.message;
    if (row.exponents && row.exponents->values.size() > 0) cell.exponent = row.exponents->values[0];
    cell.is_known = true;
    std::vector<State>& period_states = row.motion.period_states;
    if (map_.is_of_starts)
      settled.period_states = std::move(period_states);
    else if (kept_.has(i) && !period_states.empty())
      settled.period_states = {period_states.front()};
  }

  // Runs over the shown periods once more, for quantities that the recorded impacts do not give.
  void look_at(const Scene& scene, const System& system, const SweepRow& row, MapCell& cell) const {
    for (const MetImpact& impact : row.motion.impacts)
      cell.peak_speed = std::max(cell.peak_speed, impact.speed);
    const long long turns = shown_periods(row, map_.options);
    if (!row.motion.sticks)
      cell.impacts_per_period =
          static_cast<double>(row.motion.impacts.size()) / static_cast<double>(turns);
    if (row.motion.kind == SettledKind::kAtRest) cell.stuck_part = 1.0;
    if (!row.motion.sticks || row.motion.kind == SettledKind::kAtRest) return;
    const Simulation again =
        simulate(system, row.motion.at_end, on_from_settled(scene, system, row, map_.options), {});
    cell.stuck_part = again.totals.stuck_time / (static_cast<double>(turns) * system.period());
  }

  static bool is_attractor(const MapCell& cell) {
    return cell.is_known && (cell.attractor.status == SweepStatus::kSettled ||
                             cell.attractor.status == SweepStatus::kNotPeriodic);
  }

  // In the order of the cells, so that names do not depend on which thread finished first.
  void name_attractors() {
    std::optional<MotionScale> scale;
    if (map_.is_of_starts) scale = motion_scale(assemble(scene_));
    // Each is within the requested nearness of its orbit, with different deviations.
    const double apart = 16.0 * map_.options.nearness;
    std::multimap<AttractorClass, int> known;
    for (std::size_t i = 0; i < map_.cells.size(); ++i) {
      MapCell& cell = map_.cells[i];
      if (!is_attractor(cell)) continue;
      const auto [first, last] = known.equal_range(cell.attractor);
      const auto same = std::find_if(first, last, [&](const auto& entry) {
        const MapAttractor& other = map_.attractors[static_cast<std::size_t>(entry.second)];
        return !scale || cell.attractor.status != SweepStatus::kSettled ||
               are_same_period_states(*scale, period_states_[i], other.period_states, apart);
      });
      if (same != last) {
        cell.place = same->second;
      } else {
        cell.place = static_cast<int>(map_.attractors.size());
        known.emplace(cell.attractor, cell.place);
        map_.attractors.push_back({cell.attractor, i, 0, {}});
        if (map_.is_of_starts) map_.attractors.back().period_states = std::move(period_states_[i]);
      }
      ++map_.attractors[static_cast<std::size_t>(cell.place)].cells;
    }
    order_attractors();
  }

  void list_motions() {
    const auto list = [&](std::size_t cell, const std::vector<State>& period_states) {
      if (!period_states.empty()) map_.motions.push_back({cell, period_states.front()});
    };
    if (map_.is_of_starts)
      for (const MapAttractor& attractor : map_.attractors)
        list(attractor.first, attractor.period_states);
    else
      for (std::size_t i = 0; i < period_states_.size(); ++i) list(i, period_states_[i]);
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
  SpreadCells kept_;
  AttractorMap map_;
  std::vector<std::vector<State>> period_states_;
};

}  // namespace

AttractorMap map_attractors(const Scene& scene, const AttractorMapOptions& options) {
  require_plane(scene, options);
  return Mapper(scene, options).finish(options);
}

}  // namespace graze
