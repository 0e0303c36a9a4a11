// A brute-force sweep: what the motion settles on at one value of a parameter after the other.
//
// Up and down, each value starts from the state that the one before handed on, so that an attractor
// is followed as far as it goes (hysteresis). The values are cut into blocks of kBlock that are run
// side by side, each from the scene's initial state; then the blocks are joined in order: the first
// value of each is run again from what the block before handed on, and the next ones too, until one
// settles on what the block had found there. That is the sweep in one go, up to the attractor that
// motions which never repeat are on (two of them count as the same), and it depends on nothing but
// its values, however many threads share the work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/system_family.hpp"
#include "graze/base/defaults.hpp"
#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/study/sweep/settled_row.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

enum class SweepDirection {
  kUp,    // from the smallest value, each handing its state on to the next
  kDown,  // from the largest
  kFresh  // every value from the scene's initial state
};

// Periods, impacts and exponents are those at a value. A share has some of the blocks, which are
// joined where all of them are; the memory is of the k-th row, "row k", and run again, "ahead k",
// "again k".
struct SweepOptions : RowOptions, SharedWork<SweepRow> {
  double from = 0.0, to = 0.0;
  int points = 400;  // values from `from` to `to`, both among them; at least 2
  SweepDirection direction = SweepDirection::kUp;
};

struct Sweep {
  static constexpr int kBlock = 16;  // values that are run one after the other

  std::string parameter;
  SweepOptions options;
  std::vector<SweepRow> rows;  // in the order of the values from `from` to `to`; the finished ones
  long long periods = 0;       // forcing periods run, all together
  long long impacts = 0;
  int run_again = 0;  // runs of rows once more, where blocks are joined
  StopReason stopped = StopReason::kNone;
};

// Sweeps the family's parameter. Requires forcing and a stop. Values that cannot be settled are
// rows that say so.
Sweep sweep(const SystemFamily& family, const SweepOptions& options);

// How many values in a row are run one after the other: a share has them together.
std::size_t sweep_block(SweepDirection direction);

// The value of the i-th of `points` from `from` to `to`.
double sweep_value(const SweepOptions& options, int i);

// Neighbouring rows of one class.
struct AttractorRange {
  AttractorClass attractor;
  std::size_t first = 0, last = 0;  // rows
};
std::vector<AttractorRange> attractor_ranges(const std::vector<SweepRow>& rows);

// What branches are traced from: the motion in the middle of each range of those that repeat and
// meet a stop, in order. Of neighbours that agree, over a fiftieth of the values at least: what is
// shorter lies between two points of a branch, and in chaos there is no end of it.
std::vector<SettledStart> settled_starts(const std::vector<SweepRow>& rows);

}  // namespace graze
