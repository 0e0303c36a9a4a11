// Reports which fraction of a known number of pieces of work is done.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

namespace graze {

// Pieces may be added by several threads; `tell`, which may be empty, is called by one at a time.
class ProgressCounter {
 public:
  ProgressCounter(std::function<void(double fraction)> tell, std::size_t due)
      : tell_(std::move(tell)), due_(due) {}

  void add() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (tell_) tell_(static_cast<double>(done_) / static_cast<double>(due_));
  }
  // To be asked once no thread adds any more.
  bool is_complete() const { return done_ == due_; }

 private:
  std::function<void(double)> tell_;
  std::size_t due_, done_ = 0;
  std::mutex mutex_;
};

}  // namespace graze
