#include "graze/record/files.hpp"

#include <gtest/gtest.h>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/run_info.hpp"

namespace graze {
namespace {

TEST(WriteFile, ReplacesWholeFilesAndLeavesNothingElse) {
  const ScratchFolder scratch;
  write_file(scratch / "a", "first");
  write_file(scratch / "a", "second");
  EXPECT_EQ(read_text(scratch / "a"), "second");
  int entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(scratch.string()))
    ++entries;
  EXPECT_EQ(entries, 1);
}

TEST(WriteFile, FailureLeavesTheFileAsItWas) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "taken");
  EXPECT_THROW(write_file(scratch / "taken", "text"), FileError);
  EXPECT_THROW(write_file(scratch / "no/such/folder", "text"), FileError);
  EXPECT_TRUE(std::filesystem::is_directory(scratch / "taken"));
}

TEST(PrepareFolder, MakesParentsAndRefusesFiles) {
  const ScratchFolder scratch;
  prepare_folder(scratch / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(scratch / "a/b/c"));
  write_file(scratch / "file", "");
  EXPECT_THROW(prepare_folder(scratch / "file"), FileError);
  EXPECT_THROW(check_folder(scratch / "missing"), FileError);
}

// FIPS 180-4 test vectors.
TEST(Sha256, AgreesWithThePublishedVectors) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace graze
