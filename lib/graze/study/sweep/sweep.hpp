// A brute-force sweep: what the motion settles on at each of a sequence of values of a parameter.
//
// Upwards and downwards, each value starts from the state that the previous one handed on, so that
// an attractor is followed as far as it exists (hysteresis). The values are cut into blocks of
// kBlock that are run side by side, each from the scene's initial state; then the blocks are joined
// in order: the first values of each are run again from the state of the previous block, until one
// settles on the same attractor as in the block. The result is that of one sweep, except that all
// attractors of motions which never repeat count as the same, and depends on its values alone,
// however many threads share the work.
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

// Periods, impacts and exponents are those at a value. A share consists of blocks, which are joined
// once all are there; pieces are named "row k" for the k-th row, and "ahead k", "again k" for those
// run again.
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
  int run_again = 0;  // number of rows run again to join blocks
  StopReason stopped = StopReason::kNone;
};

// Sweeps the family's parameter. Requires forcing and a stop. A row says so when its value cannot
// be settled.
Sweep sweep(const SystemFamily& family, const SweepOptions& options);

// Number of consecutive values that are run one after the other, and belong to one share.
std::size_t sweep_block(SweepDirection direction);

// The value of the i-th of `points` from `from` to `to`.
double sweep_value(const SweepOptions& options, int i);

// Neighbouring rows of one class.
struct AttractorRange {
  AttractorClass attractor;
  std::size_t first = 0, last = 0;  // rows
};
std::vector<AttractorRange> attractor_ranges(const std::vector<SweepRow>& rows);

// Starts for branches: the motion in the middle of each range of values with repeating motions that
// meet a stop, in order. A range consists of neighbours that agree, over at least a fiftieth of the
// values: shorter ranges lie between two points of a branch, and chaos has arbitrarily many.
std::vector<SettledStart> settled_starts(const std::vector<SweepRow>& rows);

}  // namespace graze
