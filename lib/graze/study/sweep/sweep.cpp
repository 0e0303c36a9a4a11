#include "graze/study/sweep/sweep.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/errors.hpp"
#include "graze/base/even_values.hpp"
#include "graze/base/progress_counter.hpp"
#include "graze/orbit/search/detail/random_start.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/sweep/detail/row_chains.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

class Sweeper {
 public:
  Sweeper(const SystemFamily& family, const SweepOptions& options)
      : family_(family), options_(options), rows_(static_cast<std::size_t>(options.points)) {}

  Sweep finish() {
    const std::size_t block = sweep_block(options_.direction);
    const std::size_t blocks = (rows_.size() + block - 1) / block;
    ProgressCounter counter(options_.progress, options_.share.count(rows_.size(), block));
    BlockWork work;
    work.blocks = options_.share.blocks(blocks);
    work.pieces = [&](std::size_t b) { return names("row", b * block, end_of(b, block)); };
    work.run =
        side_by_side(options_, [&](std::size_t b) { return block_chain(b, block, counter); });
    options_.workers->do_blocks(work, options_.threads, options_.stop);
    if (block > 1 && options_.share.is_all()) join_blocks(blocks, block);
    return collect(counter.is_complete());
  }

 private:
  // The row that is the k-th to be run.
  std::optional<SweepRow>& at(std::size_t k) { return rows_[place(k)]; }
  std::size_t place(std::size_t k) const {
    const bool grows = options_.from < options_.to;
    const bool backwards =
        options_.direction == (grows ? SweepDirection::kDown : SweepDirection::kUp);
    return backwards ? rows_.size() - 1 - k : k;
  }

  std::size_t end_of(std::size_t b, std::size_t block) const {
    return std::min((b + 1) * block, rows_.size());
  }
  static std::vector<std::string> names(const char* what, std::size_t first, std::size_t end) {
    std::vector<std::string> list;
    for (std::size_t k = first; k < end; ++k) list.push_back(piece_name(what, k));
    return list;
  }

  RowChain block_chain(std::size_t b, std::size_t block, ProgressCounter& counter) {
    for (std::size_t k = b * block; k < end_of(b, block); ++k) {
      const std::string name = piece_name("row", k);
      const SweepRow* before = k == b * block ? nullptr : &*at(k - 1);
      RowRun run;
      at(k) = at_once(name, k, before, run);
      if (!at(k)) {
        co_await run;
        at(k) = settled(name, run);
        if (!at(k)) co_return false;
      }
      counter.add();
    }
    co_return true;
  }

  // The k-th row if it is stored or has no start; else nullopt, and `run` is to be awaited.
  std::optional<SweepRow> at_once(const std::string& name, std::size_t k, const SweepRow* before,
                                  RowRun& run) const {
    if (options_.memory.recall)
      if (std::optional<SweepRow> known = options_.memory.recall(name)) return known;
    if (begin(k, before, run)) return {};
    return kept(name, std::move(run.row));
  }
  // To be called once `run` was awaited; nullopt when it was stopped.
  std::optional<SweepRow> settled(const std::string& name, RowRun& run) const {
    if (!end(run)) return {};
    return kept(name, std::move(run.row));
  }
  std::optional<SweepRow> kept(const std::string& name, SweepRow row) const {
    if (!options_.memory.take(name, row)) return {};
    return row;
  }

  // False where the row has no start, which it then says.
  bool begin(std::size_t k, const SweepRow* before, RowRun& run) const {
    run.row.value = sweep_value(options_, static_cast<int>(place(k)));
    try {
      run.scene = with_parameter(family_.scene(), family_.parameter(), run.row.value);
      run.system = assemble(run.scene);
      if (before && was_followed(before->status))
        run.start =
            run.system.coordinates()
                ? handed_on(*family_.at(before->value), run.system, before->motion.at_end)
                : before->motion.at_end;
      if (run.start.q.size() > 0 && is_clear(run.system, run.start)) {
        run.row.start = SweepStart::kHandedOn;
      } else {
        if (before) run.row.start = SweepStart::kAnew;
        run.start = initial_state(run.scene, run.system);
      }
    } catch (const InputError& error) {
      run.row.message = error.what();
      return false;
    }
    return true;
  }

  // Adds the remaining results once it has settled; false where it was stopped.
  bool end(RowRun& run) const {
    if (!run.is_finished) return false;
    run.row.motion.pattern.reset();
    run.row.motion.points.clear();
    keep_stop_states(run.system, run.row);
    return !options_.measure || measure_row(run.scene, run.system, options_, run.row);
  }

  static void keep_stop_states(const System& system, SweepRow& row) {
    for (const State& state : row.motion.period_states)
      for (std::size_t i = 0; i < system.stops.size(); ++i)
        row.stop_states.push_back({static_cast<int>(i), system.stops[i].row.dot(state.q),
                                   system.stops[i].row.dot(state.qdot)});
  }

  // Rows that replace a block's first ones.
  struct Joint {
    std::vector<SweepRow> rows;
    bool is_finished = false;
  };

  // Runs the rows of the block that begins with `first` again, from the state that the previous
  // block handed on, until one of them settles on the same attractor as in the block.
  RowChain joint_chain(const char* what, std::size_t first, std::size_t block, Joint& made) {
    const std::size_t end_row = std::min(first + block, rows_.size());
    made = {};
    made.rows.reserve(end_row - first);
    std::optional<SweepRow> recalled_before, recalled_there;
    for (std::size_t k = first; k < end_row && !made.is_finished; ++k) {
      const SweepRow* before = k > first ? &made.rows.back() : found(k - 1, recalled_before);
      const SweepRow* there = found(k, recalled_there);
      if (!before || !there) co_return false;
      const std::string name = piece_name(what, k);
      RowRun run;
      std::optional<SweepRow> again = at_once(name, k, before, run);
      if (!again) {
        co_await run;
        again = settled(name, run);
        if (!again) co_return false;
      }
      made.is_finished = k + 1 == end_row || is_same_attractor(*again, *there);
      made.rows.push_back(std::move(*again));
    }
    co_return made.is_finished;
  }

  // The same in this thread alone.
  Joint joint(const char* what, std::size_t first, std::size_t block) {
    Joint made;
    std::optional<std::size_t> left = first;
    side_by_side(options_, [&](std::size_t) { return joint_chain(what, first, block, made); })(
        {[&](bool) { return std::exchange(left, std::nullopt); }, [](std::size_t, bool) {}, 1});
    return made;
  }

  // The k-th row from its block; a row that another process made is recalled.
  const SweepRow* found(std::size_t k, std::optional<SweepRow>& recalled) {
    if (at(k)) return &*at(k);
    if (options_.memory.recall) recalled = options_.memory.recall(piece_name("row", k));
    return recalled ? &*recalled : nullptr;
  }

  // Most blocks keep their last row, so that the following blocks can be joined to them side by
  // side; where the last row of a block has changed, the next block is joined to the new one
  // instead.
  void join_blocks(std::size_t blocks, std::size_t block) {
    std::vector<Joint> ahead(blocks);
    BlockWork work;
    for (std::size_t b = 1; b < blocks; ++b) work.blocks.push_back(b);
    work.pieces = [&](std::size_t b) {
      std::vector<std::string> list = names("row", b * block - 1, end_of(b, block));
      for (std::string& name : names("ahead", b * block, end_of(b, block)))
        list.push_back(std::move(name));
      return list;
    };
    work.run = side_by_side(
        options_, [&](std::size_t b) { return joint_chain("ahead", b * block, block, ahead[b]); });
    // Nothing is run again here if another process joins them.
    if (!options_.workers->do_blocks(work, options_.threads, options_.stop)) return;
    for (const Joint& joint : ahead) run_again_ += static_cast<int>(joint.rows.size());
    bool ends_as_it_was = true;
    for (std::size_t b = 1; b < blocks; ++b) {
      const std::size_t first = b * block;
      Joint made = ends_as_it_was ? std::move(ahead[b]) : joint("again", first, block);
      is_joined_ = made.is_finished;
      if (!is_joined_) return;
      if (!ends_as_it_was) run_again_ += static_cast<int>(made.rows.size());
      ends_as_it_was = first + made.rows.size() < std::min(first + block, rows_.size());
      for (std::size_t i = 0; i < made.rows.size(); ++i) at(first + i) = std::move(made.rows[i]);
    }
  }

  // Orbits are the same in whichever of their periods they are seen first.
  bool is_same_attractor(const SweepRow& a, const SweepRow& b) const {
    if (attractor_class(a) != attractor_class(b)) return false;
    const std::vector<State>&left = a.motion.period_states, &right = b.motion.period_states;
    // Where nothing is handed on, the next value starts from the initial state in either case.
    if (a.status != SweepStatus::kSettled || left.size() != right.size()) return true;
    const std::optional<System> system = family_.at(a.value);
    if (!system) return false;
    // Both are within the nearness of their orbit, with different deviations.
    return are_same_period_states(motion_scale(*system), left, right, 16.0 * options_.nearness);
  }

  Sweep collect(bool is_complete) {
    Sweep result{family_.parameter(), options_, {}, 0, 0, run_again_, options_.stop.reason()};
    result.options.let_go();
    for (std::optional<SweepRow>& row : rows_) {
      if (!row) continue;
      result.periods += row->motion.periods;
      result.impacts += row->motion.impacts_met;
      row->motion.period_states = {};  // large, and contained in the row's own stop states
      result.rows.push_back(std::move(*row));
    }
    // A sweep with all its rows counts as not stopped, even if that was requested meanwhile.
    if (is_complete && is_joined_) result.stopped = StopReason::kNone;
    return result;
  }

  const SystemFamily& family_;
  const SweepOptions& options_;
  std::vector<std::optional<SweepRow>> rows_;
  int run_again_ = 0;
  bool is_joined_ = true;
};

}  // namespace

std::size_t sweep_block(SweepDirection direction) {
  return direction == SweepDirection::kFresh ? 1 : Sweep::kBlock;
}

double sweep_value(const SweepOptions& options, int i) {
  return even_value(options.from, options.to, i, options.points);
}

Sweep sweep(const SystemFamily& family, const SweepOptions& options) {
  return Sweeper(family, options).finish();
}

std::vector<AttractorRange> attractor_ranges(const std::vector<SweepRow>& rows) {
  std::vector<AttractorRange> ranges;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const AttractorClass attractor = attractor_class(rows[i]);
    if (!ranges.empty() && ranges.back().attractor == attractor)
      ranges.back().last = i;
    else
      ranges.push_back({attractor, i, i});
  }
  return ranges;
}

std::vector<SettledStart> settled_starts(const std::vector<SweepRow>& rows) {
  const std::size_t least = std::max<std::size_t>(2, rows.size() / 50);
  std::vector<SettledStart> starts;
  for (const AttractorRange& range : attractor_ranges(rows)) {
    const SettledKind kind = range.attractor.kind;
    const bool repeats = kind == SettledKind::kImpacts || kind == SettledKind::kSticks;
    const SweepRow& middle = rows[(range.first + range.last) / 2];
    if (repeats && range.last - range.first + 1 >= least)
      starts.push_back({middle.value, middle.motion.at_start});
  }
  return starts;
}

}  // namespace graze
