#include "work_thread.hpp"

#include <pthread.h>

#include <memory>

namespace graze {
namespace {

// As often as a person who pressed Ctrl-C expects an answer.
constexpr std::chrono::milliseconds kPause{50};

thread_local std::unique_ptr<WorkThread> idle;

// A process that was forked has the memory of its threads, but not them.
void forget_in_forked() { static_cast<void>(idle.release()); }

}  // namespace

WorkThread::~WorkThread() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  given_.notify_one();
  thread_.join();
}

void WorkThread::begin(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = std::move(task);
  }
  given_.notify_one();
}

bool WorkThread::is_done_within(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  return done_.wait_for(lock, time, [this] { return !task_; });
}

void WorkThread::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    given_.wait(lock, [this] { return ends_ || task_; });
    if (ends_) return;
    lock.unlock();
    task_();
    lock.lock();
    task_ = nullptr;
    done_.notify_one();
  }
}

void do_beside(const std::function<void()>& task, const std::function<void()>& while_waiting) {
  static const int watched = pthread_atfork(nullptr, nullptr, forget_in_forked);
  static_cast<void>(watched);
  // Taken, so that work within `while_waiting` has another one.
  std::unique_ptr<WorkThread> thread = std::move(idle);
  if (!thread) thread = std::make_unique<WorkThread>();
  thread->begin(task);
  while (!thread->is_done_within(kPause)) while_waiting();
  idle = std::move(thread);
}

}  // namespace graze
