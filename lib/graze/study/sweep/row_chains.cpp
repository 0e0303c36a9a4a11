#include "graze/study/sweep/detail/row_chains.hpp"

#include <optional>
#include <vector>

namespace graze {

RowRun* RowChain::go_on() {
  promise_type& promise = handle_.promise();
  promise.awaited = nullptr;
  handle_.resume();
  if (promise.failure) std::rethrow_exception(promise.failure);
  return promise.awaited;
}

namespace {

class ChainTasks : public SettleTasks {
 public:
  ChainTasks(const RowOptions& options, const std::function<RowChain(std::size_t)>& chain,
             const BlockSource& source)
      : options_(options), chain_(chain), source_(source) {}

  std::optional<SettleTask> next(std::size_t place) override {
    if (places_.size() <= place) places_.resize(place + 1);
    std::optional<Busy>& busy = places_[place];
    for (;;) {
      if (!busy) {
        if (in_flight_ >= source_.at_once) return {};
        const std::optional<std::size_t> block = source_.next(in_flight_ == 0);
        if (!block) return {};
        busy.emplace(Busy{*block, chain_(*block), nullptr});
        ++in_flight_;
      }
      busy->run = busy->chain.go_on();
      if (busy->run) {
        const RowRun& run = *busy->run;
        return SettleTask{&run.system, run.start,
                          settle_options(run.scene, run.system, options_, run.row)};
      }
      source_.done(busy->block, busy->chain.is_finished());
      busy.reset();
      --in_flight_;
    }
  }

  void take(std::size_t place, SettledMotion motion) override {
    RowRun& run = *places_[place]->run;
    run.is_finished = conclude_row(run.scene, run.system, options_, std::move(motion), run.row);
  }

 private:
  struct Busy {
    std::size_t block;
    RowChain chain;
    RowRun* run;  // that it awaits
  };

  const RowOptions& options_;
  const std::function<RowChain(std::size_t)>& chain_;
  const BlockSource& source_;
  std::vector<std::optional<Busy>> places_;
  std::size_t in_flight_ = 0;
};

}  // namespace

std::function<void(const BlockSource&)> side_by_side(
    const RowOptions& options, std::function<RowChain(std::size_t block)> chain) {
  return [&options, chain = std::move(chain)](const BlockSource& source) {
    ChainTasks tasks(options, chain, source);
    settle_side_by_side(tasks);
  };
}

}  // namespace graze
