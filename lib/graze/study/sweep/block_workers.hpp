// Who does the blocks of long work: the threads of this process, or several processes that share
// it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/stop_signal.hpp"

namespace graze {

// Finished pieces as text, under their names. All may be called by several threads at once.
class PieceStore {
 public:
  virtual ~PieceStore() = default;
  virtual bool has(const std::string& name) const = 0;
  virtual std::optional<std::string> find(const std::string& name) const = 0;
  virtual void add(const std::string& name, const std::string& text) = 0;
};

// Where a thread gets its blocks from.
struct BlockSource {
  // The next block; nothing where none is left, or none for now, unless it `waits` for what others
  // may leave.
  std::function<std::optional<std::size_t>(bool waits)> next;
  // Called for each of them. Not finished where it was stopped before its end.
  std::function<void(std::size_t block, bool is_finished)> done;
  // So many at a time leave enough for the others.
  std::size_t at_once = 1;
};

// Blocks that depend on nothing but the work they belong to and the pieces that they name.
struct BlockWork {
  std::vector<std::size_t> blocks;  // their numbers, in the order in which they are begun
  // The names of the pieces that a block makes or reads.
  std::function<std::vector<std::string>(std::size_t block)> pieces;
  // Does blocks, or recalls their pieces, until no more come; several threads call it at once.
  std::function<void(const BlockSource& source)> run;
};

// Blocks done one after the other, by `run_block`, which returns whether it finished.
std::function<void(const BlockSource&)> one_by_one(
    std::function<bool(std::size_t block)> run_block);

// Whether the time of the work that this thread is at is over (StopScope): what is concluded then
// says less than it could.
bool is_work_over();

// So many at a time share `blocks` evenly out to `workers`.
std::size_t even_part(std::size_t blocks, std::size_t workers);

class BlockWorkers {
 public:
  virtual ~BlockWorkers() = default;

  // Called once before any blocks are done. `work` tells all that makes a difference to them, so
  // that processes which share them can see that they mean the same work; `processor` is the kind
  // of processor of this one; `kept` is where its finished pieces are to stand, or null. Returns
  // the store that pieces are recalled from and kept in; null where none is needed.
  virtual PieceStore* begin(const std::string& work, const std::string& processor,
                            PieceStore* kept) = 0;

  // Has all of the blocks done, on `threads` threads (0: all cores) of this process and by whoever
  // shares them, and returns once nobody is at them any more; throws the first exception on.
  // Returns false where another process goes on with what they found: here it is not, or in parts.
  virtual bool do_blocks(const BlockWork& work, int threads, const StopSignal& stop) = 0;

  // Whether another process has the results, so that nothing is left to do here after the blocks.
  virtual bool serves_another() const = 0;
};

// The threads of this process, which share nothing with others. Has no state.
BlockWorkers& own_threads();

}  // namespace graze
