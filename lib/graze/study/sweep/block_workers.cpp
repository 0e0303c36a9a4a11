#include "graze/study/sweep/block_workers.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "graze/base/parallel.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {
namespace {

class OwnThreads : public BlockWorkers {
 public:
  PieceStore* begin(const std::string&, const std::string&, PieceStore* kept) override {
    return kept;
  }
  bool do_blocks(const BlockWork& work, int threads, const StopSignal&) override {
    const auto workers = static_cast<std::size_t>(thread_count(threads));
    std::atomic<std::size_t> taken{0};
    const auto next = [&](bool) -> std::optional<std::size_t> {
      const std::size_t i = taken++;
      if (i >= work.blocks.size()) return {};
      return work.blocks[i];
    };
    const BlockSource source{next, [](std::size_t, bool) {},
                             even_part(work.blocks.size(), workers)};
    for_each_index(std::min(workers, work.blocks.size()), threads, [&](std::size_t) {
      try {
        work.run(source);
      } catch (...) {
        taken = work.blocks.size();  // the others need not go on
        throw;
      }
    });
    return true;
  }
  bool serves_another() const override { return false; }
};

}  // namespace

std::function<void(const BlockSource&)> one_by_one(
    std::function<bool(std::size_t block)> run_block) {
  return [run_block = std::move(run_block)](const BlockSource& source) {
    while (const std::optional<std::size_t> block = source.next(true))
      source.done(*block, run_block(*block));
  };
}

bool is_work_over() { return StopScope::is_over(); }

std::size_t even_part(std::size_t blocks, std::size_t workers) {
  return std::max<std::size_t>((blocks + workers - 1) / std::max<std::size_t>(workers, 1), 1);
}

BlockWorkers& own_threads() {
  static OwnThreads workers;
  return workers;
}

}  // namespace graze
