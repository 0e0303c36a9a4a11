#include "graze/base/stop_scope.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace graze {

// A thread that sets is_over() when the grace after a signal has passed.
class StopScope::Watch {
 public:
  Watch(const StopSignal& stop, std::chrono::milliseconds grace)
      : stop_(stop), grace_(grace), thread_([this] { run(); }) {}
  ~Watch() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  const std::atomic<bool>* over() const { return &over_; }

 private:
  using Clock = std::chrono::steady_clock;

  void run() {
    // A signal handler can wake nobody.
    constexpr std::chrono::milliseconds kLook{20};
    std::unique_lock lock(mutex_);
    while (!stop_.requested()) {
      Clock::time_point next = Clock::now() + kLook;
      if (stop_.deadline && (!stop_.interrupted || *stop_.deadline < next)) next = *stop_.deadline;
      if (changed_.wait_until(lock, next, [&] { return ended_; })) return;
    }
    if (changed_.wait_for(lock, grace_, [&] { return ended_; })) return;
    over_.store(true, std::memory_order_relaxed);
  }

  StopSignal stop_;
  std::chrono::milliseconds grace_;
  std::atomic<bool> over_{false};
  bool ended_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;  // the last: it uses the others
};

StopScope::StopScope(const StopSignal& stop, std::chrono::milliseconds grace)
    : before_(of_this_thread()) {
  static const std::atomic<bool> kAtOnce{true};
  Handle now{stop, &kNever};
  if (grace.count() == 0 && stop.requested()) {
    now.over = &kAtOnce;
  } else if (stop.interrupted || stop.deadline) {
    watch_ = std::make_unique<Watch>(stop, grace);
    now.over = watch_->over();
  }
  of_this_thread() = now;
}

StopScope::StopScope(const Handle& other) : before_(of_this_thread()) { of_this_thread() = other; }

StopScope::~StopScope() { of_this_thread() = before_; }

}  // namespace graze
