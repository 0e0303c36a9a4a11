// Messages between processes that share long work, and their transport.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace graze {

struct RankMessage {
  enum class Kind : std::uint8_t {
    // From the others to the first.
    kJoin,         // names: the work, the kind of processor
    kWant,         // numbers: the phase, the number of blocks it would like
    kPiece,        // texts: a finished piece
    kDone,         // numbers: a block, and whether it was finished (1) or stopped before (0)
    kInterrupted,  // the other one was asked to stop
    kFailed,       // names: a sentence; numbers: the exit code that it stands for
    kGone,         // it does no more
    // From the first to the others.
    kBlocks,     // numbers: blocks to do; texts: their known pieces
    kPhaseOver,  // numbers: the phase of which no blocks are left
    kStop,       // leave what you are at
    kOver        // of no phase there will be any more
  };

  Kind kind = Kind::kGone;
  std::vector<std::uint64_t> numbers{};
  std::vector<std::string> names{};
  std::vector<std::pair<std::string, std::string>> texts{};  // of pieces, by their names
};

// Conversion to bytes and back; both for the same program on processors of one byte order. Returns
// nullopt when the bytes are no message.
std::string bytes_of(const RankMessage& message);
std::optional<RankMessage> read_message(std::string_view bytes);

// The transport of messages. Functions may be called by several threads at once, `receive` by one.
class RankMessages {
 public:
  virtual ~RankMessages() = default;
  virtual int rank() const = 0;   // of this process, from 0, which is the first
  virtual int ranks() const = 0;  // how many there are
  // Returns at once. Messages from one rank to another arrive in the order in which they were sent.
  virtual void send(int to, std::string bytes) = 0;
  struct Received {
    int from = 0;
    std::string bytes;
  };
  // The next message that has arrived; nullopt when there is none.
  virtual std::optional<Received> receive() = 0;
  // Whether all sent messages will arrive even if this process ends.
  virtual bool has_left() = 0;
};

}  // namespace graze
