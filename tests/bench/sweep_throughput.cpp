// Poincare returns per second of a sweep, at a stated error: an impact oscillator
//
//   u'' + 0.04 u' + u = A cos(w t),   u <= 1,   r = 0.9
//
// from rest at 30,720 values of (w, A) in [0.6, 1.4] x [0.05, 0.55], 1024 forcing periods left out
// and 32 kept; a return is one forcing period, none is left out. And the same of four modes, those
// of a clamped and free beam that is met at its tip. Each also with a third harmonic a quarter as
// large; a stop that moves is flown as one more harmonic, too.
//
//   sweep_throughput [--threads N] [--cells N] [--avx2] [--check]
//
// --cells: so many of them, evenly spread. --avx2: by vectors of four numbers.
// --check: the impacts of the kept periods against 50 digits, in cells that repeat; of one
// harmonic, which alone has closed forms in them.
#include <fmt/format.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <thread>
#include <vector>

#include "graze/base/angle.hpp"
#include "graze/flow/exact/extended.hpp"
#include "graze/motion/detail/motion_walk.hpp"
#include "graze/motion/lanes/detail/lane_columns.hpp"
#include "graze/orbit/search/settled.hpp"

namespace {

using namespace graze;

constexpr long long kLeftOut = 1024, kKept = 32;
constexpr std::size_t kColumns = 192, kRows = 160;

struct Shape {
  int modes;
  bool has_third;
};
constexpr Shape kShapes[] = {{1, false}, {4, false}, {1, true}, {4, true}};

System system_at(Shape shape, std::size_t cell) {
  const int modes = shape.modes;
  const double x = static_cast<double>(cell % kColumns) / (kColumns - 1);
  const double y = static_cast<double>(cell / kColumns) / (kRows - 1);
  // Natural frequencies over the first; the modes are equally large at the tip, with signs in turn.
  const double ratios[] = {1.0, 6.2669, 17.5475, 34.3861};
  System system;
  system.omega = Vector::Map(ratios, modes);
  NaturalModes natural{
      Vector::Constant(modes, 0.02), HarmonicForcing{0.6 + 0.8 * x, 0.0, Vector::Zero(modes)}, {}};
  natural.forcing->amplitude[0] = 0.05 + 0.5 * y;
  if (shape.has_third)
    natural.forcing->harmonics.push_back(
        {3.0, Vector(natural.forcing->amplitude / 4.0), Vector::Zero(modes)});
  system.structure = natural;
  Vector row(modes);
  for (int j = 0; j < modes; ++j) row[j] = j % 2 == 0 ? 1.0 : -1.0;
  system.stops.push_back({row, 1.0, ImpactLaw{row / row.squaredNorm(), 0.9}});
  return system;
}

SettleOptions all_periods() {
  SettleOptions options;
  options.periods = kLeftOut + kKept;
  options.tail = kKept;
  options.nearness = 0.0;
  options.longest_period = 0;
  return options;
}

// Every so many cells of the grid, handed out to the threads one by one.
class Cells : public SettleTasks {
 public:
  Cells(Shape shape, std::size_t count, std::atomic<std::size_t>& next)
      : shape_(shape), count_(count), next_(next) {}

  std::optional<SettleTask> next(std::size_t place) override {
    const std::size_t i = next_++;
    if (i >= count_) return {};
    systems_[place] = system_at(shape_, i * (kColumns * kRows) / count_);
    const State rest{Vector::Zero(shape_.modes), Vector::Zero(shape_.modes)};
    return SettleTask{&systems_[place], rest, all_periods()};
  }
  void take(std::size_t, SettledMotion motion) override {
    returns += motion.periods;
    impacts += motion.impacts_met;
  }

  long long returns = 0, impacts = 0;

 private:
  Shape shape_;
  std::size_t count_;
  std::atomic<std::size_t>& next_;
  std::array<System, kLanes> systems_;
};

// Seconds a return, of one thread.
double measure(Shape shape, int threads, std::size_t cells, bool beside) {
  std::atomic<std::size_t> next{0};
  std::atomic<long long> returns{0}, impacts{0};
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t)
    workers.emplace_back([&] {
      Cells tasks(shape, cells, next);
      if (beside)
        settle_side_by_side(tasks);
      else
        while (const std::optional<SettleTask> task = tasks.next(0))
          tasks.take(0, settle(*task->system, task->start, task->options));
      returns += tasks.returns;
      impacts += tasks.impacts;
    });
  for (std::thread& worker : workers) worker.join();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto count = static_cast<double>(returns);
  fmt::print("{:6} {:9} {:13} {:12} {:14.3g} {:14.3g}\n", shape.modes, shape.has_third ? 2 : 1,
             beside ? "side by side" : "one by one", returns.load(), count / seconds,
             static_cast<double>(impacts) / seconds);
  return seconds * threads / count;
}

// Impact times, s since t = 0, of the kept periods in 50 digits.
std::vector<double> reference(const System& system) {
  RealVector<Extended> rest = RealVector<Extended>::Zero(system.modes());
  Motion<Extended> motion(system, {}, rest, rest);
  MotionWalk<Extended> walk(system, motion, Extended(0));
  std::vector<double> times;
  const Instant<Extended> end{kLeftOut + kKept, 0};
  for (WalkStep step = walk.next(end); step != WalkStep::kEnd && step != WalkStep::kFailure;
       step = walk.next(end))
    if (step == WalkStep::kImpact && motion.instant().period >= kLeftOut)
      times.push_back(static_cast<double>(motion.instant().local));
  return times;
}

// The largest error of an impact time, s within its period, over some cells that repeat.
bool check(Shape shape) {
  constexpr std::size_t kChecked = 12;
  double largest = 0.0;
  std::size_t told = 0, impacts = 0, others = 0;
  for (std::size_t i = 0; told < kChecked && i < kColumns * kRows; i += 97) {
    const System system = system_at(shape, i);
    const State rest{Vector::Zero(shape.modes), Vector::Zero(shape.modes)};
    SettleOptions options = all_periods();
    const SettledMotion motion = settle_in_lane(system, rest, options);
    options.longest_period = 16;
    const SettledMotion repeats = settle_in_lane(system, rest, options);
    if (repeats.period == 0 || motion.impacts.empty()) continue;
    const std::vector<double> exact = reference(system);
    if (exact.size() != motion.impacts.size()) {
      ++others;
      continue;
    }
    for (std::size_t k = 0; k < exact.size(); ++k)
      largest = std::max(
          largest, std::abs(motion.impacts[k].phase / system.forcing()->frequency - exact[k]));
    ++told;
    impacts += exact.size();
  }
  fmt::print(
      "{} mode(s), {} impacts of {} cells: largest error of an impact time {:.2g} s; with "
      "another "
      "number of impacts: {}\n",
      shape.modes, impacts, told, largest, others);
  return others == 0;
}

}  // namespace

int main(int argc, char** argv) {
  int threads = 1;
  std::size_t cells = kColumns * kRows;
  bool checks = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc)
      threads = std::atoi(argv[++i]);
    else if (std::strcmp(argv[i], "--cells") == 0 && i + 1 < argc)
      cells = static_cast<std::size_t>(std::atol(argv[++i]));
    else if (std::strcmp(argv[i], "--avx2") == 0)
      hwy::DisableTargets((std::int64_t{HWY_AVX3} << 1) - 1);
    else if (std::strcmp(argv[i], "--check") == 0)
      checks = true;
    else
      return std::fprintf(stderr,
                          "usage: sweep_throughput [--threads N] [--cells N] [--avx2] [--check]\n"),
             2;
  }
  if (checks) {
    bool all = true;
    for (const Shape shape : kShapes)
      if (!shape.has_third) all = check(shape) && all;
    return all ? 0 : 1;
  }
  fmt::print("{:>6} {:9} {:13} {:>12} {:>14} {:>14}   {} thread(s)\n", "modes", "harmonics", "",
             "returns", "returns/s", "impacts/s", threads);
  for (const Shape shape : kShapes) {
    const double beside = measure(shape, threads, cells, true);
    const double alone = measure(shape, threads, cells, false);
    fmt::print("{:6} {:.2f} times, {:.3f} us a return and core\n", "", alone / beside,
               beside * 1e6);
  }
  return 0;
}
