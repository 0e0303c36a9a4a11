#include "graze/record/file/journal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"

namespace graze {
namespace {

JournalHead some_head() {
  JournalHead head;
  head.info.version = "0.1.0";
  head.info.command = "map";
  head.info.options = {{"from", 0.1}, {"points", 5LL}};
  head.pieces = 5;
  return head;
}

TEST(JournalFile, HoldsWhatWasAdded) {
  const ScratchFolder scratch;
  const auto file = scratch / "j";
  {
    Journal journal = Journal::begin(file, some_head());
    journal.add("row 3", "[1]");
    journal.add("row 0", "");
    EXPECT_EQ(journal.find("row 3"), "[1]");
    // Two runs in one folder would mix their lines.
    EXPECT_THROW(Journal::resume(file, some_head()), FileError);
  }
  const Journal journal = Journal::resume(file, some_head());
  EXPECT_EQ(journal.names(), (std::vector<std::string>{"row 3", "row 0"}));
  EXPECT_EQ(journal.find("row 0"), "");
  EXPECT_FALSE(journal.find("row 1"));
  EXPECT_EQ(missing_pieces(some_head(), {&journal}), (std::vector<std::size_t>{1, 2, 4}));
}

TEST(JournalFile, GivesUpFinishedPiecesOnlyWhereItMay) {
  const ScratchFolder scratch;
  const auto file = scratch / "j";
  const auto begun = [&](Journal::Unfinished unfinished) {
    try {
      Journal::begin(file, some_head(), unfinished);
      return std::string("begun");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  // Nothing is lost with a journal without pieces.
  for (int i = 0; i < 2; ++i) EXPECT_EQ(begun(Journal::Unfinished::kRefused), "begun");
  Journal::resume(file, some_head()).add("row 3", "[1]");
  const std::string unfinished = read_text(file);
  const std::string refusal = begun(Journal::Unfinished::kRefused);
  EXPECT_NE(refusal.find("1 of 5 rows are done; --resume"), std::string::npos) << refusal;
  EXPECT_EQ(read_text(file), unfinished);
  EXPECT_EQ(begun(Journal::Unfinished::kReplaced), "begun");
  {
    Journal journal = Journal::resume(file, some_head());
    EXPECT_FALSE(journal.has("row 3"));
    journal.add("row 3", "[1]");
    journal.end();
  }
  EXPECT_EQ(Journal::open(file).names(), (std::vector<std::string>{"row 3"}));
  EXPECT_EQ(begun(Journal::Unfinished::kRefused), "begun");
}

TEST(JournalFile, LosesNothingButTheLineThatWasCutOff) {
  const ScratchFolder scratch;
  const auto file = scratch / "j";
  Journal::begin(file, some_head());
  const std::size_t head = read_text(file).size();
  {
    Journal journal = Journal::resume(file, some_head());
    journal.add("row 0", "[0.5, \"a\"]");
    journal.add("row 1", "[0.25]");
  }
  const std::string whole = read_text(file);
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    std::ofstream(file, std::ios::binary) << whole.substr(0, size);
    Journal journal = Journal::resume(file, some_head());
    const std::size_t first_end = whole.find('\n', head) + 1;
    EXPECT_EQ(journal.has("row 0"), size >= first_end) << size;
    EXPECT_EQ(journal.has("row 1"), size == whole.size()) << size;
    if (!journal.has("row 0")) journal.add("row 0", "[0.5, \"a\"]");
    if (!journal.has("row 1")) journal.add("row 1", "[0.25]");
    EXPECT_EQ(read_text(file), whole) << size;
  }
}

TEST(JournalFile, TellsADamagedByte) {
  const ScratchFolder scratch;
  const auto file = scratch / "j";
  {
    Journal journal = Journal::begin(file, some_head());
    journal.add("row 0", "[0.5]");
    journal.add("row 1", "[0.25]");
  }
  std::string text = read_text(file);
  text[text.find("[0.5]") + 3] = '7';
  std::ofstream(file, std::ios::binary) << text;
  const Journal journal = Journal::resume(file, some_head());
  EXPECT_FALSE(journal.has("row 0"));
  EXPECT_EQ(journal.find("row 1"), "[0.25]");
}

TEST(JournalFile, WritesOverNothingThatALinkLeadsTo) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "mine") << "precious";
  std::filesystem::create_symlink(scratch / "mine", scratch / "soft");
  std::filesystem::create_hard_link(scratch / "mine", scratch / "hard");
  for (const char* name : {"soft", "hard"}) {
    EXPECT_THROW(Journal::begin(scratch / name, some_head()), FileError) << name;
    EXPECT_THROW(Journal::resume(scratch / name, some_head()), FileError) << name;
  }
  EXPECT_EQ(read_text(scratch / "mine"), "precious");
}

// A head with a right checksum, but not from this program: 1e9 pieces would take all memory.
TEST(JournalFile, RefusesHeadsThatContradictThemselves) {
  const ScratchFolder scratch;
  std::vector<JournalHead> heads(6, some_head());
  heads[0].pieces = 1'000'000'000;
  heads[1].pieces = 4;
  heads[2].info.options[1].second = 1'000'000'000LL;
  heads[2].pieces = 1'000'000'000;
  heads[3].share = {3, 2};
  heads[4].share = {0, 2};
  heads[5].block = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const auto file = scratch / ("j" + std::to_string(i));
    Journal::begin(file, heads[i]);
    for (const bool resumed : {false, true}) {
      std::string message = "accepted";
      try {
        if (resumed)
          Journal::resume(file, heads[i]);
        else
          Journal::open(file);
      } catch (const InputError& error) {
        message = error.what();
      }
      EXPECT_NE(message.find("it is damaged"), std::string::npos) << i << ": " << message;
    }
  }
}

TEST(JournalFile, RefusesOtherWork) {
  const ScratchFolder scratch;
  const auto file = scratch / "j";
  Journal::begin(file, some_head());
  JournalHead other = some_head();
  other.info.options[0].second = 0.2;
  EXPECT_THROW(Journal::resume(file, other), InputError);
  other = some_head();
  other.info.scene_sha256 = "other";
  EXPECT_THROW(Journal::resume(file, other), InputError);
  other = some_head();
  other.processor = "another";
  EXPECT_NO_THROW(Journal::resume(file, other));
}

TEST(PieceText, ReadsBackToTheLastBit) {
  const double inf = std::numeric_limits<double>::infinity();
  SweepRow row;
  row.value = 0.1 + 0.2;
  row.status = SweepStatus::kNotPeriodic;
  row.start = SweepStart::kHandedOn;
  row.message = "a \"line\"\nand \t another";
  row.motion.at_end = {Vector::Constant(2, -0.0), Vector::Constant(2, 5e-324)};
  row.motion.period_states = {row.motion.at_end, {Vector::Constant(1, 1.0 / 3.0), Vector(0)}};
  row.motion.impacts = {{7, 1, 0.5, 1e300}};
  row.exponents.emplace();
  row.exponents->values = Vector::Constant(1, -inf);
  row.exponents->errors = Vector::Constant(1, std::nan(""));
  SweepRow back;
  ASSERT_TRUE(read_piece(piece_text(row), back));
  EXPECT_EQ(back.value, row.value);
  EXPECT_EQ(back.status, row.status);
  EXPECT_EQ(back.start, row.start);
  EXPECT_EQ(back.message, row.message);
  EXPECT_EQ(back.motion.remaining, inf);
  EXPECT_TRUE(std::signbit(back.motion.at_end.q[0]));
  EXPECT_EQ(back.motion.at_end.qdot[1], 5e-324);
  EXPECT_EQ(back.motion.period_states.at(1).q[0], 1.0 / 3.0);
  EXPECT_EQ(back.motion.period_states.at(1).qdot.size(), 0);
  EXPECT_EQ(back.motion.impacts.at(0).speed, 1e300);
  EXPECT_EQ(back.exponents->values[0], -inf);
  EXPECT_TRUE(std::isnan(back.exponents->errors[0]));
  EXPECT_FALSE(back.exponents->end);
  EXPECT_EQ(piece_text(back), piece_text(row));
  EXPECT_FALSE(read_piece("[1, 2]", back));
  EXPECT_FALSE(read_piece("no text of ours", back));
}

}  // namespace
}  // namespace graze
