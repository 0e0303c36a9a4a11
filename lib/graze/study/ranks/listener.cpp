#include "graze/study/ranks/listener.hpp"

#include <algorithm>
#include <chrono>

namespace graze {

Listener::Listener(RankMessages& messages, std::function<void(int, const RankMessage&)> take,
                   std::function<bool()> look)
    : messages_(messages),
      take_(std::move(take)),
      look_(std::move(look)),
      thread_([this] { listen(); }) {}

Listener::~Listener() { thread_.join(); }

// It sleeps between its looks, as it shares a core with a thread that computes: waiting in MPI
// would occupy that core. A look costs some microseconds; with traffic an answer is a twentieth of
// a millisecond late.
void Listener::listen() {
  using std::chrono::microseconds;
  constexpr microseconds kShortest{50}, kLongest{1000};
  for (microseconds pause = kShortest;;) {
    bool heard = false;
    while (const std::optional<RankMessages::Received> received = messages_.receive()) {
      heard = true;
      if (const std::optional<RankMessage> message = read_message(received->bytes))
        take_(received->from, *message);
    }
    if (!look_()) return;
    pause = heard ? kShortest : std::min(2 * pause, kLongest);
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace graze
