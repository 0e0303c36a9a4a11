// A thread that receives messages from other ranks for as long as it lives.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "graze/study/ranks/rank_messages.hpp"

namespace graze {

class Listener {
 public:
  // Calls `take` for each message, and `look` between them, some thousand times a second while
  // there are messages and every millisecond otherwise. The thread ends when `look` returns false.
  // Neither may throw.
  Listener(RankMessages& messages, std::function<void(int from, const RankMessage&)> take,
           std::function<bool()> look);
  ~Listener();  // waits for the end
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

 private:
  void listen();

  RankMessages& messages_;
  std::function<void(int, const RankMessage&)> take_;
  std::function<bool()> look_;
  std::thread thread_;
};

}  // namespace graze
