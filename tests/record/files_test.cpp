#include "graze/record/file/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/file/run_info.hpp"

namespace graze {
namespace {

int entries_of(const ScratchFolder& folder) {
  int entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.string()))
    ++entries;
  return entries;
}

TEST(WriteFile, ReplacesWholeFilesAndLeavesNothingElse) {
  const ScratchFolder scratch;
  write_file(scratch / "a", "first");
  write_file(scratch / "a", "second");
  EXPECT_EQ(read_text(scratch / "a"), "second");
  EXPECT_EQ(entries_of(scratch), 1);
}

TEST(WriteFile, FailureLeavesTheFileAsItWas) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "taken");
  EXPECT_THROW(write_file(scratch / "taken", "text"), FileError);
  EXPECT_THROW(write_file(scratch / "no/such/folder", "text"), FileError);
  EXPECT_TRUE(std::filesystem::is_directory(scratch / "taken"));
}

TEST(PendingFile, TakesItsPlaceOnlyWhenItIsComplete) {
  const ScratchFolder scratch;
  write_file(scratch / "table", "old");
  {
    PendingFile file(scratch / "table");
    file.append("half ");
    file.sync();
    EXPECT_EQ(read_text(scratch / "table"), "old");
    EXPECT_EQ(entries_of(scratch), 2);
  }
  EXPECT_EQ(read_text(scratch / "table"), "old");
  EXPECT_EQ(entries_of(scratch), 1);
  std::string all;
  {
    PendingFile file(scratch / "table");
    for (int i = 0; i < 100'000; ++i) {
      file.append("row\n");
      all += "row\n";
    }
    PendingFile moved = std::move(file);
    moved.append("end\n");
    moved.commit();
  }
  EXPECT_EQ(read_text(scratch / "table"), all + "end\n");
  EXPECT_EQ(entries_of(scratch), 1);
}

// What a program that is killed leaves, too early for anything to be tidied up.
void begin_and_be_killed(const std::filesystem::path& file) {
  const pid_t child = ::fork();
  if (child == 0) {
    PendingFile pending(file);
    pending.append("a longer text than the one that follows\n");
    pending.sync();
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
}

TEST(PendingFile, WhatKilledProgramsLeftIsUsedAgain) {
  const ScratchFolder scratch;
  for (int i = 0; i < 3; ++i) begin_and_be_killed(scratch / "table");
  EXPECT_EQ(entries_of(scratch), 1);
  write_file(scratch / "table", "text\n");
  EXPECT_EQ(read_text(scratch / "table"), "text\n");
  EXPECT_EQ(entries_of(scratch), 1);
}

TEST(PendingFile, TwoOfOneNameDoNotMix) {
  const ScratchFolder scratch;
  PendingFile first(scratch / "table");
  {
    PendingFile second(scratch / "table");
    first.append("first");
    second.append("second");
    second.commit();
  }
  EXPECT_EQ(read_text(scratch / "table"), "second");
  first.commit();
  EXPECT_EQ(read_text(scratch / "table"), "first");
  EXPECT_EQ(entries_of(scratch), 1);
}

TEST(PendingFile, WritesOverNothingThatALinkLeadsTo) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "mine") << "precious";
  std::filesystem::create_symlink(scratch / "mine", scratch / "a.unfinished");
  std::filesystem::create_hard_link(scratch / "mine", scratch / "b.unfinished");
  std::filesystem::create_directory(scratch / "c.unfinished");
  ASSERT_EQ(::mkfifo((scratch / "d.unfinished").c_str(), 0600), 0);
  for (const char* name : {"a", "b", "c", "d"}) {
    write_file(scratch / name, "text");
    EXPECT_EQ(read_text(scratch / name), "text") << name;
  }
  EXPECT_EQ(read_text(scratch / "mine"), "precious");
}

// The umask belongs to all threads: a file that another one makes meanwhile would get the wrong
// rights.
TEST(PendingFile, LeavesTheUmaskAlone) {
  const mode_t old = ::umask(027);
  const ScratchFolder scratch;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    for (int i = 0; i < 300; ++i) write_file(scratch / "table", "text");
    done = true;
  });
  int wrong = 0;
  for (int i = 0; !done; ++i) {
    const std::string name = (scratch / "other").string();
    const int descriptor = ::open(name.c_str(), O_CREAT | O_WRONLY, 0666);
    struct stat status {};
    ::fstat(descriptor, &status);
    wrong += (status.st_mode & 0777) != 0640;
    ::close(descriptor);
    ::unlink(name.c_str());
  }
  writer.join();
  struct stat status {};
  ASSERT_EQ(::stat((scratch / "table").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
  EXPECT_EQ(wrong, 0);
  ::umask(old);
}

TEST(PendingFile, ALostFolderIsAnError) {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "results");
  PendingFile file(scratch / "results/table");
  file.append("row\n");
  std::filesystem::remove_all(scratch / "results");
  EXPECT_THROW(file.commit(), FileError);
}

TEST(ReadFile, ReadsNoMoreThanItIsAllowed) {
  const ScratchFolder scratch;
  write_file(scratch / "file", std::string(200'000, 'x'));
  EXPECT_EQ(read_file(scratch / "file", 200'000).size(), 200'000U);
  EXPECT_EQ(read_file(scratch / "file", 100).size(), 101U);
  EXPECT_EQ(read_file("/dev/zero", 1000).size(), 1001U);
  EXPECT_THROW(read_file(scratch / "missing", 1), FileError);
  EXPECT_THROW(read_file(scratch.string(), 1), FileError);
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
