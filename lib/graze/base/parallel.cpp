#include "graze/base/parallel.hpp"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "graze/base/detail/stop_scope.hpp"

namespace graze {

int thread_count(int threads) {
  const int cores = tbb::info::default_concurrency();
  return threads > 0 ? std::min(threads, cores) : cores;
}

void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  // More threads than cores gain nothing, and TBB complains of them on the terminal.
  const StopSignal stop = StopScope::current();
  tbb::task_arena arena(thread_count(threads));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& part) {
          const StopScope scope(stop);
          for (std::size_t i = part.begin(); i < part.end(); ++i) work(i);
        },
        tbb::simple_partitioner());
  });
}

}  // namespace graze
