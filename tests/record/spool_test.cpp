#include "graze/record/file/spool.hpp"

#include <gtest/gtest.h>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"

namespace graze {
namespace {

int files_in(const ScratchFolder& folder) {
  int entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.string()))
    ++entries;
  return entries;
}

std::string content_of(Spool& spool) {
  std::string text;
  spool.read([&](std::string_view piece) { text += piece; });
  return text;
}

TEST(Spool, GivesBackWhatItTookInMemoryAndOnDisk) {
  const ScratchFolder scratch;
  Spool spool(scratch.string());
  EXPECT_TRUE(spool.empty());
  EXPECT_EQ(content_of(spool), "");
  std::string all;
  // 0.3 MB, 3 MB and 9 MB: before, at and well after the move from memory to the disk.
  for (int i = 0; i < 300'000; ++i) {
    const std::string line = "line " + std::to_string(i) + " of some thirty bytes\n";
    spool.append(line);
    all += line;
    if (i == 10'000 || i == 100'000) {
      EXPECT_TRUE(content_of(spool) == all) << i;
    }
  }
  EXPECT_FALSE(spool.empty());
  EXPECT_TRUE(content_of(spool) == all);
  EXPECT_TRUE(content_of(spool) == all);
}

TEST(Spool, LeavesNothingInItsFolder) {
  const ScratchFolder scratch;
  Spool spool(scratch.string());
  spool.append(std::string(5'000'000, 'x'));
  EXPECT_EQ(files_in(scratch), 0);
}

TEST(Spool, NeedsItsFolderForLongTextsOnly) {
  const ScratchFolder scratch;
  Spool spool(scratch / "missing");
  spool.append("short");
  EXPECT_EQ(content_of(spool), "short");
  EXPECT_THROW(spool.append(std::string(5'000'000, 'x')), FileError);
}

TEST(Document, IsReadFromHeadToTail) {
  const ScratchFolder scratch;
  Spool spool(scratch.string());
  spool.append("middle, ");
  std::string text;
  Document("head, ", spool, "tail").read([&](std::string_view piece) { text += piece; });
  EXPECT_EQ(text, "head, middle, tail");
}

}  // namespace
}  // namespace graze
