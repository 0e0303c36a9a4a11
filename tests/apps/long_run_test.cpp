// Long runs: memory that does not grow, files that appear whole or not at all, interrupts.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "graze/fem/detail/numpy_array.hpp"

namespace graze {
namespace {

using nlohmann::json;

// No end within the time of a test, and neither samples nor pictures in the way.
const std::string kEndlessRun = "simulate --periods 1000000000 ";

TEST(LongRun, MemoryDoesNotGrowWithTheRun) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer keeps what is freed";
#endif
  const ScratchFolder scratch;
  const std::string folder = scratch.string();
  const auto expect_level = [](const std::string& options, int few, int many, double allowed) {
    const auto peak = [&](int periods) {
      return peak_memory("simulate --periods " + std::to_string(periods) + " " + options +
                         kOneMode);
    };
    const double brief = peak(few);
    EXPECT_GT(brief, 0.0) << options;
    EXPECT_LT(peak(many), brief + allowed) << options;
  };
  // Buffers are full after 5000 periods; 20000 events more would be 3.6 MiB of JSON.
  for (const std::string& options : std::vector<std::string>{
           "", "--json ", "--out " + folder + "/run ",
           "--record samples --sample-rate 5 --out " + folder + "/samples ",
           "--record samples --sample-rate 200 --sample-format npz --out " + folder + "/arrays "})
    expect_level(options, 5000, 25000, 2.0);
  // A picture is ten times as long in the making as the run.
  expect_level("--plot " + folder + "/picture.svg ", 2000, 10000, 1.0);
}

TEST(LongRun, InterruptKeepsWhatWasFinishedAndExitsWith130) {
  const ScratchFolder scratch;
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    const std::string folder = (scratch / signal).string();
    const Finished run = run_graze(kEndlessRun + "--json --out " + folder + " " + kOneMode,
                                   "timeout --preserve-status -s " + std::string(signal) + " 0.5 ");
    EXPECT_EQ(run.code, 130);
    const json document = json::parse(run.out);
    EXPECT_EQ(document["outcome"], "interrupted");
    EXPECT_GT(document["totals"]["impacts"].get<long long>(), 0);
    EXPECT_EQ(document["totals"]["impacts"], document["events"].size());
    EXPECT_EQ(names_in(folder),
              (std::vector<std::string>{"events.csv", "record.json", "result.json", "scene.toml"}));
    EXPECT_TRUE(read_text(folder + "/result.json") == run.out);
    EXPECT_EQ(lines_of(folder + "/events.csv").size(), document["events"].size() + 1);
  }
}

TEST(LongRun, InterruptKeepsTheSamplesUntilThen) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  const Finished run = run_graze(
      kEndlessRun + "--record samples --sample-format npz --out " + folder + " --json " + kOneMode,
      "timeout --preserve-status -s INT 0.5 ");
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_EQ(names_in(folder), (std::vector<std::string>{"events.csv", "record.json", "result.json",
                                                        "samples.npz", "scene.toml"}));
  const NumpyArray time = numpy_array("time", zip_members(folder + "/samples.npz").at("time.npy"));
  // The run ends at an event, its samples before the next one.
  const double end = json::parse(run.out)["final"]["time"], period = 2.0 * M_PI / 28.3;
  ASSERT_GT(time.values.size(), 100U);
  EXPECT_NEAR(time.values.back(), end, 2.0 * period);
}

TEST(LongRun, UnderNohupTheRunOutlivesItsTerminal) {
  // A shell that ignores SIGHUP hands that on, as nohup does.
  const std::string line = "trap '' HUP; '" GRAZE_PROGRAM
                           "' simulate --max-seconds 0.6 --duration 1e9 --record none " +
                           kOneMode + " > /dev/null & sleep 0.2; kill -HUP $!; wait $!";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 3);
}

TEST(LongRun, MotionIntegratedByStepsIsStoppedWhereThereIsNoStop) {
  for (const char* command : {"simulate --duration 1000 ", "cost "})
    EXPECT_EQ(run_graze(command + std::string("--max-seconds 0.2 --json ") + GRAZE_SOURCE_DIR +
                        "/data/measurements/vibration.toml")
                  .code,
              3)
        << command;
}

TEST(LongRun, RangesWhoseSquaresOverflowAreRefused) {
  const Finished run = run_graze("continue --parameter stop.gap --from 0 --to 1e160 " + kOneMode,
                                 "timeout -s KILL 60 ");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("--to: '1e160' is not a number of at most 6.7e+153"), std::string::npos)
      << run.err;
}

TEST(LongRun, StoppedRunsKeepTheirFilesToo) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  EXPECT_EQ(run_graze("simulate --max-impacts 7 --out " + folder + " " + kOneMode).code, 3);
  EXPECT_EQ(json::parse(read_text(folder + "/result.json"))["outcome"], "event_budget");
  EXPECT_EQ(lines_of(folder + "/events.csv").size(), 8U);
}

TEST(LongRun, AFullDiskLeavesNothingBehind) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  ASSERT_EQ(run_graze("simulate --periods 5 --out " + folder + " " + kOneMode).code, 0);
  const std::string before = read_text(folder + "/events.csv");
  // In blocks of 512 bytes: the table, the document, or their end do not fit.
  for (const char* blocks : {"100", "1000", "2500"}) {
    for (const char* samples : {"", "--record samples --sample-format npz "}) {
      const Finished run =
          run_graze("simulate --periods 10000 " + (samples + ("--out " + folder)) + " " + kOneMode,
                    "ulimit -f " + std::string(blocks) + "; ");
      EXPECT_EQ(run.code, 4) << blocks;
      EXPECT_EQ(run.out, "") << blocks;
      EXPECT_NE(run.err.find("cannot write"), std::string::npos) << run.err;
      EXPECT_EQ(names_in(folder).size(), 4U) << blocks;
      EXPECT_TRUE(read_text(folder + "/events.csv") == before) << blocks;
    }
  }
}

TEST(LongRun, AFolderThatIsLostExitsWith4) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "run").string();
  const Finished run = run_graze(kEndlessRun + "--max-seconds 1.5 --out " + folder + " " + kOneMode,
                                 "(sleep 0.5; rm -r " + folder + ") & ");
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(names_in(scratch.string()), std::vector<std::string>{});
}

}  // namespace
}  // namespace graze
