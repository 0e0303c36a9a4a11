// A thread that does one piece of work after another for the thread that it belongs to.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace graze {

class WorkThread {
 public:
  WorkThread() : thread_([this] { work(); }) {}
  WorkThread(const WorkThread&) = delete;
  WorkThread& operator=(const WorkThread&) = delete;
  ~WorkThread();

  // Requires that nothing is being done; `task` must not throw.
  void begin(std::function<void()> task);
  // Whether the task is done within that time.
  bool is_done_within(std::chrono::milliseconds time);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable given_, done_;
  std::function<void()> task_;  // empty: nothing to do
  bool ends_ = false;
  std::thread thread_;  // begins when all else is there
};

// Does the task in a thread that the calling one keeps for that, as to make one takes as long as a
// short simulation, and calls `while_waiting` every few hundredths of a second until it is done.
// Tasks may be given out from within `while_waiting`. Neither function may throw.
void do_beside(const std::function<void()>& task, const std::function<void()>& while_waiting);

}  // namespace graze
