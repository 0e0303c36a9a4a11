// The process that owns the work and its results: it hands out blocks to the other ranks as they
// become free, keeps the pieces that they send, and does blocks itself.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "graze/study/ranks/rank_messages.hpp"
#include "graze/study/sweep/block_workers.hpp"

namespace graze {

// Pieces in memory, where no journal keeps them.
class PieceTable : public PieceStore {
 public:
  bool has(const std::string& name) const override;
  std::optional<std::string> find(const std::string& name) const override;
  void add(const std::string& name, const std::string& text) override;
  void clear();

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::string> texts_;
};

class FirstRank : public BlockWorkers {
 public:
  // `interrupted` is polled by stop signals; it is set when another rank was interrupted.
  FirstRank(RankMessages& messages, std::atomic<bool>& interrupted);

  PieceStore* begin(const std::string& work, const std::string& processor,
                    PieceStore* kept) override;
  // Throws InputError or FileError for a rank that failed, with its number and sentence.
  bool do_blocks(const BlockWork& work, int threads, const StopSignal& stop) override;
  bool serves_another() const override { return false; }

  // The kinds of processors of all ranks that have begun.
  const std::set<std::string>& processors() const { return processors_; }
  // Ends the others and returns once they are gone; do_blocks must not be called any more.
  void close();

 private:
  struct Other {
    std::uint64_t wanted_phase = 0, wish = 0;  // of the last request that was not answered
    std::set<std::uint64_t> blocks;            // that it is at
    bool is_gone = false;
  };

  void start_phase(const BlockWork& work, const StopSignal& stop);
  void work_here();
  std::optional<std::size_t> next_block(bool waits);
  bool is_ending() const { return failure_ || stop_.requested(); }
  void take(int from, const RankMessage& message) noexcept;
  void answer(int from, const RankMessage& message);
  void note_joined(int from, const RankMessage& message);
  void note_done(Other& other, std::uint64_t block, bool is_finished);
  void hand_out(int to, Other& other);
  std::vector<std::size_t> batch(const Other& other);
  bool look() noexcept;
  void tell_all(const RankMessage& message);
  void fail(std::exception_ptr failure);

  RankMessages& messages_;
  std::atomic<bool>& interrupted_;
  PieceTable table_;
  PieceStore* store_ = nullptr;
  std::string work_;
  std::set<std::string> processors_;

  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  const BlockWork* blocks_ = nullptr;  // of the phase
  int threads_ = 1;
  StopSignal stop_;
  std::uint64_t phase_ = 0;
  // Only for this process: blocks whose pieces are all known, or that another rank left.
  std::deque<std::size_t> own_;
  std::deque<std::size_t> open_;  // for whoever comes first
  std::size_t given_ = 0;         // blocks that other ranks are at
  bool has_told_stop_ = false, has_finished_here_ = false;
  std::exception_ptr failure_;
  std::vector<Other> others_;  // by their ranks; that of this one is not used
};

}  // namespace graze
