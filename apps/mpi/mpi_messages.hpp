// Messages between the ranks of an MPI job.
#pragma once

#include <mpi.h>

#include <list>
#include <mutex>

#include "graze/study/ranks/rank_messages.hpp"

namespace graze {

// Requires MPI to allow calls by several threads, one at a time (MPI_THREAD_SERIALIZED).
class MpiMessages : public RankMessages {
 public:
  MpiMessages();

  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }
  void send(int to, std::string bytes) override;
  std::optional<Received> receive() override;
  bool has_left() override;

 private:
  // MPI reads the bytes for as long as the request is not complete.
  struct Sent {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  void forget_complete();

  int rank_ = 0, ranks_ = 1;
  std::list<Sent> sent_;
  std::mutex mutex_;  // of all calls of MPI
};

}  // namespace graze
