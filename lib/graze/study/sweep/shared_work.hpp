// Long work in pieces that do not depend on who does them or when: the pieces of an earlier run,
// the store of finished ones, and the share that is done here.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/base/progress_counter.hpp"
#include "graze/study/sweep/block_workers.hpp"

namespace graze {

// One of several shares of the work: blocks are assigned to shares in turn.
struct Share {
  int part = 1, of = 1;  // 1 <= part <= of

  bool is_all() const { return of == 1; }
  bool has(std::size_t block) const {
    return block % static_cast<std::size_t>(of) == static_cast<std::size_t>(part - 1);
  }
  // The number of pieces in this share, if blocks have `block` pieces each.
  std::size_t count(std::size_t pieces, std::size_t block = 1) const {
    std::size_t count = 0;
    for (std::size_t first = 0; first < pieces; first += block)
      if (has(first / block)) count += std::min(block, pieces - first);
    return count;
  }
  // The blocks of this share.
  std::vector<std::size_t> blocks(std::size_t count) const {
    std::vector<std::size_t> list;
    for (auto block = static_cast<std::size_t>(part - 1); block < count;
         block += static_cast<std::size_t>(of))
      list.push_back(block);
    return list;
  }
};

// "row 12"
inline std::string piece_name(const std::string& what, std::size_t i) {
  return what + " " + std::to_string(i);
}

// Both may be called by several threads at once, and either may be empty. A piece is identified
// within its work by its name ("row 12").
template <class Piece>
struct PieceMemory {
  std::function<std::optional<Piece>(const std::string& name)> recall{};
  std::function<void(const std::string& name, const Piece& piece)> keep{};

  // Whether the piece is complete; it is then kept.
  bool take(const std::string& name, const Piece& piece) const {
    if (is_work_over()) return false;
    if (keep) keep(name, piece);
    return true;
  }

  // The stored piece, or else the one that `make` makes; nullopt when that was stopped.
  template <class Make>
  std::optional<Piece> get(const std::string& name, const Make& make) const {
    if (recall)
      if (std::optional<Piece> known = recall(name)) return known;
    std::optional<Piece> made = make();
    if (made && !take(name, *made)) return {};
    return made;
  }
};

// Options of such work.
template <class Piece>
struct SharedWork {
  int threads = 0;                                  // 0: all cores
  std::function<void(double fraction)> progress{};  // called by one thread at a time
  Share share{};
  PieceMemory<Piece> memory{};
  BlockWorkers* workers = &own_threads();  // not null

  // Drops references to objects that do not outlive the work, before a result keeps these options.
  void let_go() {
    progress = nullptr;
    memory = {};
    workers = &own_threads();
  }
};

// Pieces 0 .. count - 1 of a kind ("cell") that depend only on themselves: those of the options'
// share, stored ones or as `make(i)` makes them, by its workers, with its progress. nullopt when a
// piece is not in the share, or was stopped.
template <class Piece>
struct MadePieces {
  std::vector<std::optional<Piece>> pieces;
  bool is_complete = false;  // of the share
};
// `run(made, counter)` returns the function that makes them (BlockWork::run), each in its place.
template <class Piece, class Options, class Run>
MadePieces<Piece> made_pieces(const std::string& kind, std::size_t count, const Options& options,
                              const Run& run) {
  MadePieces<Piece> made;
  made.pieces.resize(count);
  ProgressCounter counter(options.progress, options.share.count(count));
  BlockWork work;
  work.blocks = options.share.blocks(count);
  work.pieces = [&](std::size_t i) { return std::vector{piece_name(kind, i)}; };
  work.run = run(made.pieces, counter);
  options.workers->do_blocks(work, options.threads, options.stop);
  made.is_complete = counter.is_complete();
  return made;
}
template <class Piece, class Options, class Make>
MadePieces<Piece> make_pieces(const std::string& kind, std::size_t count, const Options& options,
                              const Make& make) {
  const auto run = [&](std::vector<std::optional<Piece>>& pieces, ProgressCounter& counter) {
    return one_by_one([&](std::size_t i) {
      if (options.stop.requested()) return false;
      pieces[i] = options.memory.get(piece_name(kind, i), [&] { return make(i); });
      if (pieces[i]) counter.add();
      return pieces[i].has_value();
    });
  };
  return made_pieces<Piece>(kind, count, options, run);
}

}  // namespace graze
