// A process that does blocks for the first rank and sends it the pieces, each as soon as it is
// finished.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "graze/study/ranks/first_rank.hpp"
#include "graze/study/ranks/listener.hpp"
#include "graze/study/ranks/rank_messages.hpp"
#include "graze/study/sweep/block_workers.hpp"

namespace graze {

class OtherRank : public BlockWorkers {
 public:
  // `interrupted` is polled by stop signals; it is set when the first rank asks for a stop.
  OtherRank(RankMessages& messages, std::atomic<bool>& interrupted);

  PieceStore* begin(const std::string& work, const std::string& processor,
                    PieceStore* kept) override;
  bool do_blocks(const BlockWork& work, int threads, const StopSignal& stop) override;
  bool serves_another() const override { return true; }

  // Reports to the first rank why this one does no more, with the corresponding exit code.
  void fail(const std::string& sentence, int exit_code);
  // Returns once the first rank has ended the work.
  void close();

 private:
  // Finds pieces that were sent along with blocks; sends added ones to the first rank.
  class Store : public PieceStore {
   public:
    explicit Store(RankMessages& messages) : messages_(messages) {}
    bool has(const std::string& name) const override { return known_.has(name); }
    std::optional<std::string> find(const std::string& name) const override {
      return known_.find(name);
    }
    void add(const std::string& name, const std::string& text) override;
    PieceTable& known() { return known_; }

   private:
    RankMessages& messages_;
    PieceTable known_;
  };

  void work_here(const BlockWork& work);
  std::optional<std::size_t> next_block(bool waits);
  void note_done(std::uint64_t block, bool is_finished, double seconds);
  std::uint64_t wish() const;
  void take(const RankMessage& message);
  bool look();
  void send(const RankMessage& message) { messages_.send(0, bytes_of(message)); }

  RankMessages& messages_;
  std::atomic<bool>& interrupted_;
  Store store_;

  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::uint64_t phase_ = 0, phase_over_ = 0;
  std::deque<std::uint64_t> blocks_;  // to be begun
  int threads_ = 1, busy_ = 0;        // threads, and how many of them are at a block
  bool has_asked_ = false;            // and was not answered
  double mean_seconds_ = 0.0;         // of the last blocks; 0: none yet
  bool is_over_ = false, has_failed_ = false, has_told_interrupt_ = false, is_closing_ = false;
  std::unique_ptr<Listener> listener_;
};

}  // namespace graze
