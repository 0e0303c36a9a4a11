// Ranks as threads of one process, with mailboxes in place of MPI.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "graze/study/ranks/first_rank.hpp"
#include "graze/study/ranks/other_rank.hpp"

namespace graze {

class Mailboxes {
 public:
  explicit Mailboxes(int ranks) : boxes_(static_cast<std::size_t>(ranks)) {}
  int ranks() const { return static_cast<int>(boxes_.size()); }
  void put(int to, RankMessages::Received message) {
    const std::lock_guard lock(mutex_);
    boxes_[static_cast<std::size_t>(to)].push_back(std::move(message));
  }
  std::optional<RankMessages::Received> take(int of) {
    const std::lock_guard lock(mutex_);
    std::deque<RankMessages::Received>& box = boxes_[static_cast<std::size_t>(of)];
    if (box.empty()) return {};
    RankMessages::Received first = std::move(box.front());
    box.pop_front();
    return first;
  }

 private:
  std::mutex mutex_;
  std::vector<std::deque<RankMessages::Received>> boxes_;
};

class MailboxMessages : public RankMessages {
 public:
  MailboxMessages(Mailboxes& boxes, int rank) : boxes_(boxes), rank_(rank) {}
  int rank() const override { return rank_; }
  int ranks() const override { return boxes_.ranks(); }
  void send(int to, std::string bytes) override { boxes_.put(to, {rank_, std::move(bytes)}); }
  std::optional<Received> receive() override { return boxes_.take(rank_); }
  bool has_left() override { return true; }

 private:
  Mailboxes& boxes_;
  int rank_;
};

// Runs `first(workers, interrupted)` beside `other(rank, workers, interrupted)` of every other
// rank, and returns once all are over.
template <class First, class Other>
void run_ranks(int ranks, const First& first, const Other& other) {
  Mailboxes boxes(ranks);
  std::vector<std::thread> others;
  for (int rank = 1; rank < ranks; ++rank)
    others.emplace_back([&, rank] {
      MailboxMessages messages(boxes, rank);
      std::atomic<bool> interrupted{false};
      OtherRank workers(messages, interrupted);
      other(rank, workers, interrupted);
      workers.close();
    });
  {
    MailboxMessages messages(boxes, 0);
    std::atomic<bool> interrupted{false};
    FirstRank workers(messages, interrupted);
    first(workers, interrupted);
    workers.close();
  }
  for (std::thread& thread : others) thread.join();
}

}  // namespace graze
