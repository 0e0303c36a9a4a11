#include "graze/study/ranks/other_rank.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <utility>

#include "graze/base/errors.hpp"
#include "graze/base/parallel.hpp"
#include "graze/motion/lanes/detail/lane_columns.hpp"

namespace graze {

using Kind = RankMessage::Kind;

void OtherRank::Store::add(const std::string& name, const std::string& text) {
  messages_.send(0, bytes_of({Kind::kPiece, {}, {}, {{name, text}}}));
}

OtherRank::OtherRank(RankMessages& messages, std::atomic<bool>& interrupted)
    : messages_(messages), interrupted_(interrupted), store_(messages) {
  listener_ = std::make_unique<Listener>(
      messages_, [this](int, const RankMessage& message) { take(message); },
      [this] { return look(); });
}

PieceStore* OtherRank::begin(const std::string& work, const std::string& processor, PieceStore*) {
  send({Kind::kJoin, {}, {work, processor}});
  return &store_;
}

bool OtherRank::do_blocks(const BlockWork& work, int threads, const StopSignal&) {
  {
    const std::lock_guard lock(mutex_);
    ++phase_;
    threads_ = thread_count(threads);
    mean_seconds_ = 0.0;
    has_asked_ = false;
  }
  for_each_index(static_cast<std::size_t>(threads_), threads,
                 [&](std::size_t) { work_here(work); });
  return false;
}

void OtherRank::work_here(const BlockWork& work) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point last = Clock::now();
  const auto done = [&](std::size_t block, bool is_finished) {
    const Clock::time_point begun = std::exchange(last, Clock::now());
    note_done(block, is_finished, std::chrono::duration<double>(last - begun).count());
  };
  const auto next = [&](bool waits) {
    const std::optional<std::size_t> block = next_block(waits);
    if (waits) last = Clock::now();  // what it waited for is no work
    return block;
  };
  try {
    work.run(
        {next, done,
         even_part(work.blocks.size(), static_cast<std::size_t>(messages_.ranks() * threads_))});
  } catch (const InputError& error) {
    fail(error.what(), 2);
  } catch (const std::bad_alloc&) {
    fail("out of memory", 4);
  } catch (const std::exception& error) {
    fail(error.what(), 4);
  }
}

// Asks the first rank when none is left, and waits; nullopt once the phase is over.
std::optional<std::size_t> OtherRank::next_block(bool waits) {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (is_over_ || has_failed_ || phase_over_ >= phase_) return {};
    if (!blocks_.empty()) {
      const std::uint64_t block = blocks_.front();
      blocks_.pop_front();
      ++busy_;
      return block;
    }
    if (!has_asked_) {
      has_asked_ = true;
      send({Kind::kWant, {phase_, wish()}});
    }
    if (!waits) return {};
    changed_.wait(lock);
  }
}

void OtherRank::note_done(std::uint64_t block, bool is_finished, double seconds) {
  send({Kind::kDone, {block, is_finished ? 1U : 0U}});
  const std::lock_guard lock(mutex_);
  // Recent blocks count most, as blocks of one corner of a plane take longer than those of another.
  mean_seconds_ = mean_seconds_ > 0.0 ? 0.8 * mean_seconds_ + 0.2 * seconds : seconds;
  if (--busy_ == 0 && blocks_.empty()) store_.known().clear();
}

// Number of blocks that take this long, so that waiting for an answer, a fraction of a millisecond,
// is negligible.
std::uint64_t OtherRank::wish() const {
  constexpr double kSeconds = 0.05;
  constexpr double kMost = 1000.0;
  // At first as many as threads can do side by side.
  if (mean_seconds_ <= 0.0) return kLanes * static_cast<std::uint64_t>(threads_);
  return static_cast<std::uint64_t>(std::clamp(kSeconds * threads_ / mean_seconds_, 1.0, kMost));
}

void OtherRank::take(const RankMessage& message) {
  const std::lock_guard lock(mutex_);
  switch (message.kind) {
    case Kind::kBlocks:
      for (const auto& [name, text] : message.texts) store_.known().add(name, text);
      blocks_.insert(blocks_.end(), message.numbers.begin(), message.numbers.end());
      has_asked_ = false;
      break;
    case Kind::kPhaseOver:
      if (!message.numbers.empty()) phase_over_ = std::max(phase_over_, message.numbers.front());
      break;
    case Kind::kOver:
      is_over_ = true;
      [[fallthrough]];
    case Kind::kStop:
      has_told_interrupt_ = true;  // the first rank knows of it
      interrupted_ = true;
      break;
    default:
      break;
  }
  changed_.notify_all();
}

bool OtherRank::look() {
  const std::lock_guard lock(mutex_);
  if (interrupted_ && !has_told_interrupt_) {
    has_told_interrupt_ = true;
    send({Kind::kInterrupted});
  }
  return !(is_over_ && is_closing_ && messages_.has_left());
}

void OtherRank::fail(const std::string& sentence, int exit_code) {
  send({Kind::kFailed, {static_cast<std::uint64_t>(exit_code)}, {sentence}});
  const std::lock_guard lock(mutex_);
  has_failed_ = true;
  changed_.notify_all();
}

void OtherRank::close() {
  send({Kind::kGone});
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
  }
  listener_.reset();
}

}  // namespace graze
