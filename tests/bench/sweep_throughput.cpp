// Poincare returns per second of a sweep: an impact oscillator
//
//   u'' + 0.04 u' + u = A cos(w t),   u <= 1,   r = 0.9
//
// from rest at 30,720 values of A in [0.05, 0.55] x w in [0.6, 1.4], 1024 forcing periods left out
// and 32 kept; a return is one forcing period. And a cantilever's first four modes over as many.
//
//   sweep_throughput [THREADS] [CELLS]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

#include "graze/base/parallel.hpp"
#include "graze/orbit/search/settled.hpp"

namespace {

using namespace graze;

struct Grid {
  int modes = 1;
  std::size_t columns = 192, rows = 160;
  std::size_t cells() const { return columns * rows; }

  System system(std::size_t cell) const {
    const double x = static_cast<double>(cell % columns) / static_cast<double>(columns - 1);
    const double y = static_cast<double>(cell / columns) / static_cast<double>(rows - 1);
    System system;
    // Frequencies of a clamped and free beam over its first.
    const double ratios[] = {1.0, 6.2669, 17.5475, 34.3861};
    // Its modes at the tip are equally large, alternating in sign.
    system.omega = Vector::Map(ratios, modes);
    NaturalModes natural{Vector::Constant(modes, 0.02), HarmonicForcing{}, {}};
    natural.forcing->frequency = 0.6 + 0.8 * x;
    natural.forcing->amplitude = Vector::Zero(modes);
    natural.forcing->amplitude[0] = 0.05 + 0.5 * y;
    system.structure = natural;
    Vector row(modes);
    for (int j = 0; j < modes; ++j) row[j] = j % 2 == 0 ? 1.0 : -1.0;
    system.stops.push_back({row, 1.0, ImpactLaw{row / row.squaredNorm(), 0.9}});
    return system;
  }
};

class Cells : public SettleTasks {
 public:
  Cells(const Grid& grid, std::atomic<std::size_t>& next, std::size_t end)
      : grid_(grid), next_(next), end_(end) {}

  std::optional<SettleTask> next(std::size_t place) override {
    const std::size_t cell = next_++;
    if (cell >= end_) return {};
    systems_[place] = grid_.system(cell * grid_.cells() / end_);
    SettleTask task;
    task.system = &systems_[place];
    const Eigen::Index n = task.system->modes();
    task.start = {Vector::Zero(n), Vector::Zero(n)};
    task.options.periods = 1024 + 32;
    task.options.tail = 32;
    task.options.nearness = 0.0;
    return task;
  }
  void take(std::size_t, SettledMotion motion) override {
    periods += motion.periods;
    impacts += motion.impacts_met;
    if (motion.kind != SettledKind::kNotPeriodic && motion.kind != SettledKind::kClear) ++others;
  }

  long long periods = 0, impacts = 0, others = 0;

 private:
  const Grid& grid_;
  std::atomic<std::size_t>& next_;
  std::size_t end_;
  std::array<System, 64> systems_;
};

void measure(int modes, int threads, std::size_t cells, bool alone) {
  Grid grid;
  grid.modes = modes;
  std::atomic<std::size_t> next{0};
  std::atomic<long long> periods{0}, impacts{0}, others{0};
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t)
    workers.emplace_back([&] {
      Cells tasks(grid, next, cells);
      if (alone) {
        while (std::optional<SettleTask> task = tasks.next(0))
          tasks.take(0, settle(*task->system, task->start, task->options));
      } else {
        settle_side_by_side(tasks);
      }
      periods += tasks.periods;
      impacts += tasks.impacts;
      others += tasks.others;
    });
  for (std::thread& worker : workers) worker.join();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  fmt::print("{} mode(s), {} thread(s), {}: {:.3g} returns/s, {:.3g} us a return, {} impacts, {} others, {:.2f} s\n", modes,
             threads, alone ? "one by one" : "side by side",
             static_cast<double>(periods) / seconds, seconds / static_cast<double>(periods) * 1e6 * threads,
             impacts.load(), others.load(), seconds);
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::atoi(argv[1]) : 1;
  const std::size_t cells = argc > 2 ? static_cast<std::size_t>(std::atoi(argv[2])) : 30720;
  for (const int modes : {1, 4})
    for (const bool alone : {true, false})
      if (argc < 4 || (alone == (argv[3][0] == 'o'))) measure(modes, threads, alone ? std::min<std::size_t>(cells, 960) : cells, alone);
}
