// Blocks that several ranks share, each of which is a thread here: all are done, none twice, and
// whatever a rank finished is kept.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/study/sweep/shared_work.hpp"
#include "support/rank_threads.hpp"

namespace graze {
namespace {

// Pieces are texts: that of "cell 12" is "144", of "sum 12" the sum of the squares up to 12, made
// of "cell 12" and those before it in its block.
class Squares {
 public:
  static constexpr std::size_t kBlock = 4;

  explicit Squares(std::size_t count) : count_(count) {}
  std::size_t count() const { return count_; }

  // As every rank knows it; `interrupted` is the rank's own.
  BlockWork work(PieceStore& store, std::atomic<bool>& interrupted) {
    BlockWork blocks;
    for (std::size_t b = 0; b * kBlock < count_; ++b) blocks.blocks.push_back(b);
    blocks.pieces = [this](std::size_t b) {
      std::vector<std::string> names;
      for (std::size_t k = b * kBlock; k < end_of(b); ++k) names.push_back(piece_name("cell", k));
      return names;
    };
    blocks.run = one_by_one([this, &store, &interrupted](std::size_t b) {
      for (std::size_t k = b * kBlock; k < end_of(b); ++k) {
        if (interrupted) return false;
        const std::string name = piece_name("cell", k);
        if (store.find(name)) continue;
        if (before_make) before_make(k);
        {
          const std::lock_guard lock(mutex_);
          ++made_[name];
        }
        store.add(name, std::to_string(k * k));
      }
      return true;
    });
    return blocks;
  }

  std::map<std::string, int> made() const {
    const std::lock_guard lock(mutex_);
    return made_;
  }

  std::function<void(std::size_t)> before_make;

 private:
  std::size_t end_of(std::size_t b) const { return std::min((b + 1) * kBlock, count_); }

  std::size_t count_;
  mutable std::mutex mutex_;
  std::map<std::string, int> made_;
};

StopSignal watching(const std::atomic<bool>& interrupted) {
  StopSignal stop;
  stop.interrupted = &interrupted;
  return stop;
}

void pause(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

// What every other rank does.
auto helper(Squares& squares, const std::string& work = "squares", int threads = 1) {
  return [&squares, work, threads](int, OtherRank& workers, std::atomic<bool>& interrupted) {
    PieceStore& store = *workers.begin(work, "some processor", nullptr);
    EXPECT_TRUE(workers.serves_another());
    EXPECT_FALSE(
        workers.do_blocks(squares.work(store, interrupted), threads, watching(interrupted)));
  };
}

void expect_all_squares(const Squares& squares, const PieceStore& store) {
  for (std::size_t k = 0; k < squares.count(); ++k)
    EXPECT_EQ(store.find(piece_name("cell", k)), std::to_string(k * k)) << k;
}

TEST(RankMessage, IsReadBackAndNothingWhereItIsCutOrWrong) {
  const RankMessage message{RankMessage::Kind::kBlocks,
                            {0, 7, ~std::uint64_t{0}},
                            {"", "a\nb"},
                            {{"row 7", std::string("\0x", 2)}, {"", ""}}};
  const std::string bytes = bytes_of(message);
  const std::optional<RankMessage> back = read_message(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->kind, message.kind);
  EXPECT_EQ(back->numbers, message.numbers);
  EXPECT_EQ(back->names, message.names);
  EXPECT_EQ(back->texts, message.texts);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(read_message(bytes.substr(0, size))) << size;
  EXPECT_FALSE(read_message(bytes + "x"));
  std::string no_kind = bytes;
  no_kind[0] = 99;
  EXPECT_FALSE(read_message(no_kind));
  std::string too_many = bytes;
  too_many[8] = 'x';
  EXPECT_FALSE(read_message(too_many));
}

TEST(Ranks, DoEveryBlockOnce) {
  for (const int ranks : {1, 2, 3, 8})
    for (const int threads : {1, 2}) {
      SCOPED_TRACE(std::to_string(ranks) + " ranks of " + std::to_string(threads) + " threads");
      Squares squares(203);
      PieceTable kept;
      run_ranks(
          ranks,
          [&](FirstRank& workers, std::atomic<bool>& interrupted) {
            EXPECT_EQ(workers.begin("squares", "some processor", &kept), &kept);
            EXPECT_FALSE(workers.serves_another());
            EXPECT_TRUE(
                workers.do_blocks(squares.work(kept, interrupted), threads, watching(interrupted)));
            EXPECT_FALSE(interrupted);
            EXPECT_EQ(workers.processors(), std::set<std::string>{"some processor"});
          },
          helper(squares, "squares", threads));
      expect_all_squares(squares, kept);
      for (const auto& [name, count] : squares.made()) EXPECT_EQ(count, 1) << name;
    }
}

TEST(Ranks, AllWorkAndTheFirstToo) {
  std::mutex mutex;
  std::set<std::thread::id> at_work;
  Squares squares(160);
  squares.before_make = [&](std::size_t) {
    pause(1);
    const std::lock_guard lock(mutex);
    at_work.insert(std::this_thread::get_id());
  };
  PieceTable kept;
  run_ranks(
      3,
      [&](FirstRank& workers, std::atomic<bool>& interrupted) {
        workers.begin("squares", "", &kept);
        workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted));
      },
      helper(squares));
  EXPECT_EQ(at_work.size(), 3U);
}

TEST(Ranks, MakeNothingThatIsKnown) {
  Squares squares(100);
  PieceTable kept;
  std::size_t known = 0;
  for (std::size_t k = 0; k < 100; ++k)
    if (k < 30 || k % 3 == 0) kept.add(piece_name("cell", k), std::to_string(k * k)), ++known;
  run_ranks(
      3,
      [&](FirstRank& workers, std::atomic<bool>& interrupted) {
        workers.begin("squares", "", &kept);
        workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted));
      },
      helper(squares));
  expect_all_squares(squares, kept);
  EXPECT_EQ(squares.made().size(), 100 - known);
}

// A sweep has a second phase, which reads the pieces of the first one.
TEST(Ranks, FindThePiecesOfAnEarlierPhase) {
  Squares squares(64);
  PieceTable kept;
  const auto doubled = [&](PieceStore& store, std::atomic<bool>& interrupted) {
    BlockWork work = squares.work(store, interrupted);
    const auto cells = work.pieces;
    work.run = one_by_one([&store, cells](std::size_t b) {
      for (const std::string& name : cells(b)) {
        const std::optional<std::string> square = store.find(name);
        EXPECT_TRUE(square) << name;
        const std::string twice = "twice " + name;
        if (square && !store.has(twice)) store.add(twice, *square + *square);
      }
      return true;
    });
    work.pieces = [cells](std::size_t b) {
      std::vector<std::string> names = cells(b);
      for (const std::string& name : cells(b)) names.push_back("twice " + name);
      return names;
    };
    return work;
  };
  run_ranks(
      4,
      [&](FirstRank& workers, std::atomic<bool>& interrupted) {
        workers.begin("squares", "", &kept);
        workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted));
        workers.do_blocks(doubled(kept, interrupted), 1, watching(interrupted));
      },
      [&](int rank, OtherRank& workers, std::atomic<bool>& interrupted) {
        if (rank == 3) pause(30);  // comes when the first phase may be over
        PieceStore& store = *workers.begin("squares", "", nullptr);
        workers.do_blocks(squares.work(store, interrupted), 1, watching(interrupted));
        workers.do_blocks(doubled(store, interrupted), 1, watching(interrupted));
      });
  EXPECT_EQ(kept.find("twice cell 63"), "39693969");
  for (std::size_t k = 0; k < 64; ++k) EXPECT_TRUE(kept.has("twice " + piece_name("cell", k))) << k;
}

// Pieces are kept one by one, so that a rank that ends within a block loses only what it is at.
TEST(Ranks, KeepWhatWasFinishedBeforeAStop) {
  for (const int stopped : {0, 2}) {
    SCOPED_TRACE(stopped);
    Squares squares(4000);
    squares.before_make = [](std::size_t) { pause(1); };
    PieceTable kept;
    const auto stops = [&](std::atomic<bool>& interrupted) {
      return std::thread([&] {
        while (squares.made().size() < 20) pause(1);
        interrupted = true;
      });
    };
    run_ranks(
        3,
        [&](FirstRank& workers, std::atomic<bool>& interrupted) {
          workers.begin("squares", "", &kept);
          std::thread stop;
          if (stopped == 0) stop = stops(interrupted);
          EXPECT_TRUE(workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted)));
          if (stop.joinable()) stop.join();
          EXPECT_TRUE(interrupted);
        },
        [&](int rank, OtherRank& workers, std::atomic<bool>& interrupted) {
          std::thread stop;
          if (stopped == rank) stop = stops(interrupted);
          helper(squares)(rank, workers, interrupted);
          if (stop.joinable()) stop.join();
          EXPECT_TRUE(interrupted);
        });
    const auto made = squares.made();
    EXPECT_GE(made.size(), 20U);
    EXPECT_LT(made.size(), 4000U);
    for (const auto& [name, count] : made) EXPECT_TRUE(kept.has(name)) << name;
  }
}

// Its own time is over before that of the first rank.
TEST(Ranks, TheFirstFinishesWhatAnotherLeaves) {
  Squares squares(200);
  squares.before_make = [](std::size_t) { pause(1); };
  PieceTable kept;
  run_ranks(
      2,
      [&](FirstRank& workers, std::atomic<bool>& interrupted) {
        workers.begin("squares", "", &kept);
        EXPECT_TRUE(workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted)));
        EXPECT_FALSE(interrupted);
      },
      [&](int, OtherRank& workers, std::atomic<bool>& interrupted) {
        PieceStore& store = *workers.begin("squares", "", nullptr);
        std::atomic<bool> late{true};
        workers.do_blocks(squares.work(store, late), 1, watching(interrupted));
      });
  expect_all_squares(squares, kept);
}

// It takes blocks and goes without a word about them.
TEST(Ranks, TheFirstDoesWhatAnotherTookAndNeverDid) {
  Squares squares(200);
  squares.before_make = [](std::size_t) { pause(1); };
  PieceTable kept;
  Mailboxes boxes(2);
  std::size_t taken = 0;
  std::thread other([&] {
    MailboxMessages messages(boxes, 1);
    messages.send(0, bytes_of({RankMessage::Kind::kJoin, {}, {"squares", ""}}));
    messages.send(0, bytes_of({RankMessage::Kind::kWant, {1, 7}}));
    std::optional<RankMessages::Received> received;
    while (!(received = messages.receive())) pause(1);
    taken = read_message(received->bytes)->numbers.size();
    messages.send(0, bytes_of({RankMessage::Kind::kGone}));
  });
  MailboxMessages messages(boxes, 0);
  std::atomic<bool> interrupted{false};
  FirstRank workers(messages, interrupted);
  workers.begin("squares", "", &kept);
  EXPECT_TRUE(workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted)));
  workers.close();
  other.join();
  EXPECT_EQ(taken, 7U);
  expect_all_squares(squares, kept);
}

// The sentence that the first rank ends with.
template <class Error, class Other>
std::string failure(Squares& squares, const Other& other) {
  std::string sentence = "none";
  PieceTable kept;
  run_ranks(
      3,
      [&](FirstRank& workers, std::atomic<bool>& interrupted) {
        workers.begin("squares", "", &kept);
        try {
          workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted));
        } catch (const Error& error) {
          sentence = error.what();
        }
      },
      other);
  return sentence;
}

TEST(Ranks, TellWhichOfThemFailed) {
  Squares squares(4000);
  squares.before_make = [](std::size_t) { pause(1); };
  EXPECT_EQ(failure<FileError>(squares,
                               [&](int rank, OtherRank& workers, std::atomic<bool>& interrupted) {
                                 if (rank == 2) return workers.fail("no such scene", 4);
                                 helper(squares)(rank, workers, interrupted);
                               }),
            "rank 2: no such scene");
  EXPECT_EQ(failure<InputError>(squares,
                                [&](int rank, OtherRank& workers, std::atomic<bool>& interrupted) {
                                  PieceStore& store = *workers.begin("squares", "", nullptr);
                                  BlockWork work = squares.work(store, interrupted);
                                  if (rank == 1)
                                    work.run = one_by_one([](std::size_t) -> bool {
                                      throw InputError("a value is wrong");
                                    });
                                  workers.do_blocks(work, 1, watching(interrupted));
                                }),
            "rank 1: a value is wrong");
  const std::string other_work = failure<InputError>(
      squares, [&](int rank, OtherRank& workers, std::atomic<bool>& interrupted) {
        helper(squares, rank == 1 ? "cubes" : "squares")(rank, workers, interrupted);
      });
  EXPECT_NE(other_work.find("rank 1: its work is another one"), std::string::npos) << other_work;
}

// A disk that is full, say.
TEST(Ranks, EndWhereTheFirstOneFails) {
  class FullStore : public PieceTable {
   public:
    void add(const std::string& name, const std::string& text) override {
      if (++count_ > 10) throw FileError("the disk is full");
      PieceTable::add(name, text);
    }
    std::atomic<int> count_{0};
  };
  Squares squares(4000);
  squares.before_make = [](std::size_t) { pause(1); };
  FullStore kept;
  run_ranks(
      3,
      [&](FirstRank& workers, std::atomic<bool>& interrupted) {
        workers.begin("squares", "", &kept);
        EXPECT_THROW(workers.do_blocks(squares.work(kept, interrupted), 1, watching(interrupted)),
                     FileError);
      },
      helper(squares));
  EXPECT_LT(squares.made().size(), 100U);
}

}  // namespace
}  // namespace graze
