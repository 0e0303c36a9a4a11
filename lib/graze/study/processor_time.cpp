#include "graze/study/processor_time.hpp"

#include <time.h>

#include <algorithm>

namespace graze {
namespace {

constexpr double kMeasured = 0.02;  // s
constexpr int kFewestRuns = 3;

}  // namespace

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double least_time(const std::function<void()>& work, double enough, const StopSignal& stop) {
  double least = 0.0, total = 0.0;
  for (int i = 0; i < kFewestRuns || total < kMeasured; ++i) {
    const double before = processor_time();
    work();
    const double seconds = processor_time() - before;
    least = i == 0 ? seconds : std::min(least, seconds);
    total += seconds;
    if (total > enough || stop.requested()) break;
  }
  return least;
}

}  // namespace graze
