// Long work that is killed, resumed, shared out and merged gives the bytes of the work in one go.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "apps/program.hpp"

namespace graze {
namespace {

const std::string kSweep =
    "diagram --quiet --branches none --parameter forcing.frequency --from 15 "
    "--to 120 --points 300 " +
    scene("05_wagg_one_mode.toml");
const std::string kMap =
    "map --quiet --parameter forcing.frequency --from 15 --to 120 --points 12 --second stop.gap "
    "--second-from 0.5e-3 --second-to 2e-3 --second-points 9 " +
    scene("05_wagg_one_mode.toml");
const std::string kBalls =
    "diagram --quiet --duration 3 --parameter stop.restitution --from 0 --to 0.8 --points 17 " +
    scene("06_bouncing_ball.toml");

// The first line of record.json tells how the program was called.
std::string compared_text(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  return file.filename() == "record.json" ? text.substr(text.find('\n')) : text;
}

void expect_same(const ScratchFolder& scratch, const std::string& a, const std::string& b) {
  for (const std::string& file : names_in(scratch / a))
    if (file != "rows.journal") {
      EXPECT_TRUE(compared_text(scratch / a / file) == compared_text(scratch / b / file)) << file;
    }
}

// Whether the program came to its end before it was killed.
bool ends_within(const std::string& arguments, std::chrono::microseconds time) {
  const std::string line = "exec " + std::string(GRAZE_PROGRAM) + " " + arguments + " >/dev/null";
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  std::this_thread::sleep_for(time);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) {
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
  return WIFEXITED(status);
}

TEST(Journal, GivesTheSameBytesAfter200Kills) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_graze(kSweep + " --out " + (scratch / "whole").string()).code, 0);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> microseconds(0, 60'000);
  int kills = 0, ends = 0;
  const std::string cut = (scratch / "cut").string();
  while (kills < 200) {
    const bool ended = ends_within(kSweep + " --resume --out " + cut,
                                   std::chrono::microseconds(microseconds(random)));
    if (!ended) {
      ++kills;
      continue;
    }
    ++ends;
    expect_same(scratch, "whole", "cut");
    std::filesystem::remove_all(cut);
  }
  EXPECT_EQ(run_graze(kSweep + " --resume --out " + cut).code, 0);
  expect_same(scratch, "whole", "cut");
}

TEST(Journal, SharesMergeToTheWhole) {
  for (const std::string& work : {kSweep, kSweep + " --direction down", kMap, kBalls}) {
    SCOPED_TRACE(work);
    const ScratchFolder scratch;
    ASSERT_EQ(run_graze(work + " --out " + (scratch / "whole").string()).code, 0);
    for (const char* share : {"2/3", "1/3", "3/3"}) {
      const Finished run =
          run_graze(work + " --shard " + share + " --out " + (scratch / "shares").string());
      ASSERT_EQ(run.code, 0) << run.err;
    }
    const std::string merge = "merge --quiet --json " + (scratch / "shares").string() + " --out " +
                              (scratch / "merged").string();
    const Finished late = run_graze(merge + " --max-seconds 1e-9");
    EXPECT_EQ(late.code, 3);
    EXPECT_NE(late.out.find("to go on: graze merge "), std::string::npos) << late.out;
    const Finished merged = run_graze(merge);
    ASSERT_EQ(merged.code, 0) << merged.err;
    expect_same(scratch, "whole", "merged");
    EXPECT_EQ(merged.out, read_text(scratch / "whole" / "result.json"));
  }
}

TEST(Journal, CompleteFoldersAreShownAgainWithoutWork) {
  const ScratchFolder scratch;
  const std::string out = " --out " + (scratch / "run").string();
  const Finished first = run_graze(kMap + out);
  const std::string journal = read_text(scratch / "run" / "rows.journal");
  const Finished again = run_graze(kMap + out + " --resume --show speed --max-seconds 100");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(read_text(scratch / "run" / "rows.journal"), journal);
}

// The sentence that a stopped command ends with names the one that goes on, to the same bytes.
TEST(Journal, OfUnfinishedWorkIsKept) {
  for (const std::string& work : {kSweep, kBalls}) {
    SCOPED_TRACE(work);
    const ScratchFolder scratch;
    const std::string folder = (scratch / "cut").string();
    const std::string out = " --out " + folder;
    ASSERT_EQ(run_graze(work + " --max-seconds 100 --out " + (scratch / "whole").string()).code, 0);
    ASSERT_EQ(run_graze(work + out).code, 0);
    std::string journal = read_text(folder + "/rows.journal");
    journal.erase(journal.find('\n', journal.size() / 2) + 1);
    std::ofstream(folder + "/rows.journal") << journal;
    const Finished again = run_graze(work + out);
    EXPECT_EQ(again.code, 2);
    EXPECT_NE(again.err.find("--resume goes on with it, --restart-work throws it away"),
              std::string::npos)
        << again.err;
    EXPECT_EQ(read_text(folder + "/rows.journal"), journal);
    EXPECT_EQ(run_graze(work + out + " --resume --restart-work").code, 2);
    const Finished other = run_graze(work + out + " --set stop.gap=0.0123");
    EXPECT_EQ(other.code, 2);
    EXPECT_NE(other.err.find("the scene"), std::string::npos) << other.err;
    const Finished late = run_graze(work + out + " --resume --json --max-seconds 1e-9");
    const std::string told = nlohmann::json::parse(late.out)["message"];
    const std::size_t at = told.find("to go on: graze ");
    ASSERT_NE(at, std::string::npos) << told;
    std::string on = told.substr(at + 16);
    on.replace(on.find("1e-9"), 4, "100");
    ASSERT_EQ(run_graze(on).code, 0) << on;
    EXPECT_EQ(read_text(folder + "/rows.journal").rfind(journal, 0), 0U);
    expect_same(scratch, "whole", "cut");
    EXPECT_EQ(run_graze(work + out).code, 0);
  }
}

TEST(Journal, SaysWhatIsMissingOrOther) {
  const ScratchFolder scratch;
  const std::string out = " --out " + (scratch / "run").string();
  ASSERT_EQ(run_graze(kMap + out + " --shard 2/3").code, 0);
  const Finished merged =
      run_graze("merge " + (scratch / "run").string() + " --out " + (scratch / "m").string());
  EXPECT_EQ(merged.code, 2);
  EXPECT_NE(merged.err.find("--shard 1/3, 3/3"), std::string::npos) << merged.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "m"));
  const Finished other = run_graze(kMap + out + " --shard 2/3 --resume --set stop.restitution=0.5");
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("the scene"), std::string::npos) << other.err;
  const Finished more = run_graze(kMap + out + " --shard 2/3 --resume --periods 500");
  EXPECT_EQ(more.code, 2);
  EXPECT_NE(more.err.find("periods was 1000 there and is 500 here"), std::string::npos) << more.err;
  EXPECT_EQ(run_graze(kMap + " --resume").code, 2);
  EXPECT_EQ(run_graze(kMap + out + " --shard 4/3").code, 2);
  EXPECT_EQ(run_graze(kMap + out + " --shard 1").code, 2);
  EXPECT_EQ(run_graze(kMap + out + " --shard 1/2 --plot a.svg").code, 2);
  EXPECT_EQ(run_graze("merge " + (scratch / "none").string() + out).code, 4);
}

}  // namespace
}  // namespace graze
