// What processes that share long work tell each other, and the way it takes between them.
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
    kWant,         // numbers: the phase, how many blocks it would like
    kPiece,        // texts: a finished piece
    kDone,         // numbers: a block, and whether it was finished (1) or stopped before (0)
    kInterrupted,  // the other one was asked to stop
    kFailed,       // names: a sentence; numbers: the exit code that it stands for
    kGone,         // it does no more
    // From the first to the others.
    kBlocks,     // numbers: blocks to do; texts: what is known of their pieces
    kPhaseOver,  // numbers: the phase of which no blocks are left
    kStop,       // leave what you are at
    kOver        // of no phase there will be any more
  };

  Kind kind = Kind::kGone;
  std::vector<std::uint64_t> numbers{};
  std::vector<std::string> names{};
  std::vector<std::pair<std::string, std::string>> texts{};  // of pieces, by their names
};

// As bytes, and back; both at the same program on processors of one byte order. Nothing where the
// bytes are no message.
std::string bytes_of(const RankMessage& message);
std::optional<RankMessage> read_message(std::string_view bytes);

// The way that messages take. All may be called by several threads at once, `receive` by one.
class RankMessages {
 public:
  virtual ~RankMessages() = default;
  virtual int rank() const = 0;   // of this process, from 0, which is the first
  virtual int ranks() const = 0;  // how many there are
  // Returns at once. What goes from one rank to another arrives in the order in which it was sent.
  virtual void send(int to, std::string bytes) = 0;
  struct Received {
    int from = 0;
    std::string bytes;
  };
  // What has arrived; nothing where nothing has.
  virtual std::optional<Received> receive() = 0;
  // Whether all that was sent is on its way without this process.
  virtual bool has_left() = 0;
};

}  // namespace graze
