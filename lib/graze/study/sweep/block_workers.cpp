#include "graze/study/sweep/block_workers.hpp"

#include "graze/base/parallel.hpp"

namespace graze {
namespace {

class OwnThreads : public BlockWorkers {
 public:
  PieceStore* begin(const std::string&, const std::string&, PieceStore* kept) override {
    return kept;
  }
  bool do_blocks(const BlockWork& work, int threads, const StopSignal&) override {
    for_each_index(work.blocks.size(), threads, [&](std::size_t i) { work.run(work.blocks[i]); });
    return true;
  }
  bool serves_another() const override { return false; }
};

}  // namespace

BlockWorkers& own_threads() {
  static OwnThreads workers;
  return workers;
}

}  // namespace graze
