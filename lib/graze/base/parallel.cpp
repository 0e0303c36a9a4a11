#include "graze/base/parallel.hpp"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

// An arena of so many threads that nobody else uses meanwhile. TBB does not give back all memory of
// an arena, some seven kilobytes, so that idle arenas are used again.
class LentArena {
 public:
  explicit LentArena(int threads) : threads_(threads) {
    {
      const std::lock_guard lock(mutex());
      std::vector<Arena>& known = idle()[threads];
      if (!known.empty()) {
        arena_ = std::move(known.back());
        known.pop_back();
      }
    }
    if (!arena_) arena_ = std::make_unique<tbb::task_arena>(threads);
  }
  ~LentArena() {
    const std::lock_guard lock(mutex());
    idle()[threads_].push_back(std::move(arena_));
  }
  LentArena(const LentArena&) = delete;
  LentArena& operator=(const LentArena&) = delete;

  tbb::task_arena& operator*() { return *arena_; }

 private:
  using Arena = std::unique_ptr<tbb::task_arena>;
  // Never destroyed, as TBB may end before what is static here.
  static std::map<int, std::vector<Arena>>& idle() {
    static auto& arenas = *new std::map<int, std::vector<Arena>>;
    return arenas;
  }
  static std::mutex& mutex() {
    static auto& only = *new std::mutex;
    return only;
  }

  int threads_;
  Arena arena_;
};

}  // namespace

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
  const StopScope::Handle stop = StopScope::handle();
  LentArena arena(thread_count(threads));
  (*arena).execute([&] {
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
