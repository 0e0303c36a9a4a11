// Rows of sweeps and cells of maps settled side by side. A chain is a coroutine that makes one row
// after the other, each possibly from the end of the previous one; while it awaits a row, other
// chains go on.
#pragma once

#include <coroutine>
#include <exception>
#include <functional>
#include <utility>

#include "graze/study/sweep/block_workers.hpp"
#include "graze/study/sweep/settled_row.hpp"

namespace graze {

// A row to be settled from a start.
struct RowRun {
  Scene scene;
  System system;
  State start;
  SweepRow row;
  bool is_finished = false;  // valid once it was awaited; false when it was stopped
};

// co_await run;            the row is settled, and its exponents are known
// co_return is_finished;   false where the chain was stopped before its end
class RowChain {
 public:
  struct promise_type {
    RowRun* awaited = nullptr;
    bool is_finished = false;
    std::exception_ptr failure{};

    RowChain get_return_object() {
      return RowChain(std::coroutine_handle<promise_type>::from_promise(*this));
    }
    std::suspend_always initial_suspend() noexcept { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    std::suspend_always await_transform(RowRun& run) {
      awaited = &run;
      return {};
    }
    void return_value(bool finished) { is_finished = finished; }
    void unhandled_exception() { failure = std::current_exception(); }
  };

  RowChain(RowChain&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  RowChain& operator=(RowChain&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~RowChain() {
    if (handle_) handle_.destroy();
  }

  // Continues to the next row that it awaits; null once it is over. Throws what the chain throws.
  RowRun* go_on();
  // Requires that it is over.
  bool is_finished() const { return handle_.promise().is_finished; }

 private:
  explicit RowChain(std::coroutine_handle<promise_type> handle) : handle_(handle) {}

  std::coroutine_handle<promise_type> handle_;
};

// A worker function for BlockWork::run: runs the chains of several blocks side by side. Objects
// that `chain` refers to must outlive it.
std::function<void(const BlockSource&)> side_by_side(
    const RowOptions& options, std::function<RowChain(std::size_t block)> chain);

}  // namespace graze
