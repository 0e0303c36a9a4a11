// Workers for the blocks of long work: the threads of this process, or several processes that share
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

// Source of the blocks of a thread.
struct BlockSource {
  // The next block; nullopt when none is left, or none for now. With `waits` it waits for blocks
  // that others may return unfinished.
  std::function<std::optional<std::size_t>(bool waits)> next;
  // Called for each block. Not finished when it was stopped before its end.
  std::function<void(std::size_t block, bool is_finished)> done;
  // Number of blocks at a time that leaves enough for the other threads.
  std::size_t at_once = 1;
};

// Blocks that depend only on their work and on the pieces that they name.
struct BlockWork {
  std::vector<std::size_t> blocks;  // their numbers, in the order in which they are begun
  // The names of the pieces that a block computes or reads.
  std::function<std::vector<std::string>(std::size_t block)> pieces;
  // Does blocks, or recalls their pieces, until no more come; several threads call it at once.
  std::function<void(const BlockSource& source)> run;
};

// Blocks done one after the other, by `run_block`, which returns whether it finished.
std::function<void(const BlockSource&)> one_by_one(
    std::function<bool(std::size_t block)> run_block);

// Whether the time of the work of this thread is over (StopScope): conclusions made then may be
// incomplete.
bool is_work_over();

// Number of blocks at a time with which `workers` share `blocks` evenly.
std::size_t even_part(std::size_t blocks, std::size_t workers);

class BlockWorkers {
 public:
  virtual ~BlockWorkers() = default;

  // Called once before any blocks are done. `work` describes everything that the blocks depend on,
  // so that processes which share them can check that they do the same work; `processor` is the
  // kind of processor of this one; `kept` is the store for finished pieces, or null. Returns the
  // store from which pieces are recalled and in which they are kept; null when none is needed.
  virtual PieceStore* begin(const std::string& work, const std::string& processor,
                            PieceStore* kept) = 0;

  // Has all blocks done, on `threads` threads (0: all cores) of this process and by others that
  // share them, and returns when all are finished; the first exception is thrown on. Returns false
  // when another process has the results: here they are absent or incomplete.
  virtual bool do_blocks(const BlockWork& work, int threads, const StopSignal& stop) = 0;

  // Whether another process has the results, so that nothing is left to do here after the blocks.
  virtual bool serves_another() const = 0;
};

// The threads of this process, which share nothing with others. Has no state.
BlockWorkers& own_threads();

}  // namespace graze
