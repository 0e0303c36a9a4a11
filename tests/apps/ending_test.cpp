// Whatever a command is at, it ends soon after it was asked to, with the exit code that says so.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "apps/program.hpp"

namespace graze {
namespace {

// Ten times the second within which a command is to end: who is still there hangs.
const std::string kHangs = "10";
const std::string kUntilItHangs = "timeout -s KILL " + kHangs + " ";

// Some 1e10 oscillations of the beam in one forcing period.
const std::string kSlowForcing = kOneMode + " --set forcing.frequency=1e-8";
// Some 1e17 of them.
const std::string kStiffBeam = kOneMode + " --set beam.youngs_modulus=1e40";
const std::string kGaps = " --parameter stop.gap --from 1e-3 --to 2e-3";
const std::string kEndingPlane =
    kGaps + " --second stop.restitution --second-from 0.5 --second-to 0.9 --points 4" +
    " --second-points 4";

struct Endless {
  const char* name;
  std::string arguments;
};

// Each mode of the held beam is one of a matrix of 400 by 400.
const std::string kManyModes = scene("02_wagg_momentum.toml") + " --set beam.modes=400";

const std::vector<Endless> kEndless{
    {"a run of slow forcing", "simulate " + kSlowForcing},
    {"orbits under slow forcing", "orbit " + kSlowForcing},
    {"branches under slow forcing", "continue " + kSlowForcing + kGaps},
    {"a diagram under slow forcing", "diagram " + kSlowForcing + kGaps},
    {"a run of a stiff beam", "simulate " + kStiffBeam},
    {"orbits of a stiff beam", "orbit " + kStiffBeam},
    {"a map of a stiff beam", "map " + kStiffBeam + kEndingPlane},
    {"costs of a stiff beam", "cost " + kStiffBeam},
    {"costs of 200 modes held in 50 digits",
     "cost " + scene("02_wagg_momentum.toml") + " --set beam.modes=200 --set stop.gap=0"},
    {"orbits of 400 modes", "orbit " + kManyModes},
    {"branches of 400 modes", "continue " + kManyModes + kGaps},
    {"orbits of 400 slow periods, solved by the dozen",
     "orbit " + kOscillator + " --set forcing.frequency=1e-3 --period 400 --impacts 3"},
    {"bounds on orbits under quick forcing",
     "continue " + kOscillator + " --set forcing.frequency=1e8 --parameter stop.gap" +
         " --from 1e-9 --to 1.5"},
    {"a comparison of stiff beams", "compare " + kStiffBeam + " --against stop.gap=1.2e-3"},
};

TEST(Program, EveryCommandEndsWhenItsTimeIsUp) {
  for (const Endless& endless : kEndless) {
    const Finished run = run_graze(endless.arguments + " --max-seconds 0.2", kUntilItHangs);
    EXPECT_EQ(run.code, 3) << endless.name << ": " << run.err;
  }
}

// What a command writes on a terminal.
std::string on_terminal(const std::string& arguments) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    const std::string line =
        "exec " + kUntilItHangs + std::string(GRAZE_PROGRAM) + " " + arguments + " >/dev/null";
    ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  std::string text(1 << 16, '\0');
  std::size_t size = 0;
  for (ssize_t some = 0; (some = ::read(terminal, text.data() + size, text.size() - size)) > 0;)
    size += static_cast<std::size_t>(some);
  ::close(terminal);
  ::waitpid(child, nullptr, 0);
  text.resize(size);
  return text;
}

// No value is done in that time.
TEST(Program, TellsThatItIsAtWorkWhereAPieceTakesLong) {
  const std::string text =
      on_terminal("diagram --max-seconds 1.4 --points 2 --threads 1 " + kSlowForcing + kGaps);
  EXPECT_NE(text.find("diagram   0 %"), std::string::npos) << text;
  EXPECT_NE(text.find(" so far"), std::string::npos) << text;
}

TEST(Program, EveryCommandEndsWhenAsked) {
  for (const Endless& endless : kEndless) {
    const Finished run =
        run_graze(endless.arguments, "timeout --preserve-status -s TERM -k " + kHangs + " 0.3 ");
    EXPECT_EQ(run.code, 130) << endless.name << ": " << run.err;
  }
}

// Of commands that end by themselves any moment is one to end at: what was being found stays found,
// or is let go.
TEST(Program, AnyMomentIsOneToEndAt) {
  const std::string slow = kOscillator + " --parameter forcing.frequency --from 0.4 --to 1.2";
  const std::string gaps = " --second stop.gap --second-from 1e-3 --second-to 0.5 ";
  for (const std::string& command :
       {"continue --locus all --slices 2" + gaps + slow,
        "continue --regions 8 --locus all --slices 0" + gaps + slow,
        "continue --set stop.restitution=0 " + slow, "orbit --impacts any " + kOscillator,
        "diagram --points 20 --exponents 50 " + slow,
        "map --points 8 --second-points 6 --locus all" + gaps + slow})
    for (const char* seconds : {"0.02", "0.05", "0.1", "0.15", "0.2", "0.3", "0.5"}) {
      const Finished run = run_graze(command + " --max-seconds " + seconds, kUntilItHangs);
      EXPECT_TRUE(run.code == 0 || run.code == 3)
          << command << " after " << seconds << " s: " << run.code << " " << run.err;
    }
}

// 2,000 stops along one oscillator, the orbits of each to be sought by itself.
std::string many_stops(int count) {
  std::string text =
      "[modal]\nfrequencies = [1.0]\nparticipation = [1.0]\n"
      "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 1.1\n";
  for (int i = 0; i < count; ++i)
    text += "[[stop]]\nshape = [1.0]\nrestitution = 0.8\ngap = " + std::to_string(1.0 + 1e-5 * i) +
            "\n";
  return text;
}

TEST(Program, EndsWhenAskedAmongManyStops) {
  const ScratchFolder scratch;
  const std::string file = (scratch / "many.toml").string();
  std::ofstream(file) << many_stops(2000);
  for (const std::string& command :
       {"orbit " + file, "continue " + file + " --parameter stop.gap --from 0.9 --to 1.1"}) {
    const Finished run = run_graze(command + " --max-seconds 0.2", kUntilItHangs);
    EXPECT_EQ(run.code, 3) << command << ": " << run.err;
  }
}

// A thousandth of a second each, or less: what is done for one stop asks no other.
TEST(Program, ChecksManyStops) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "many.toml") << many_stops(20000);
  const Finished run = run_graze("check " + (scratch / "many.toml").string(), kUntilItHangs);
  EXPECT_EQ(run.code, 0) << run.err;
}

// Steps through a contact become as short as rounding and end there; what lies beyond is not
// sought.
TEST(Program, EndsAContactInWhichTimeStandsStill) {
  const Finished run = run_graze(
      "simulate " + scene("14_beam_against_a_ball.toml") + " --set forcing.amplitude=6e12",
      kUntilItHangs);
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE((run.out + run.err).find("the motion left the range of double precision"),
            std::string::npos)
      << run.out << run.err;
}

// Nothing is finished before the scene is assembled, so nothing is waited for.
TEST(Program, EndsWhenAskedWhileItChecks) {
  const Finished run = run_graze("check " + scene("03_wagg_fig4.toml") + " --set beam.modes=400",
                                 "timeout --preserve-status -s TERM -k " + kHangs + " 0.3 ");
  EXPECT_EQ(run.code, 130) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(Program, WaitsForNoOneToWriteItsScene) {
  const ScratchFolder scratch;
  const std::string pipe = (scratch / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& command :
       {"check " + pipe, "fit " + scene("../measurements/restitution.toml") + " " + pipe}) {
    const Finished run = run_graze(command, kUntilItHangs);
    EXPECT_EQ(run.code, 2) << command << ": " << run.err;
    EXPECT_NE(run.err.find("pipe"), std::string::npos) << run.err;
  }
  // What a shell hands over is a pipe as well.
  EXPECT_EQ(run_graze("check /dev/stdin", "cat " + kOneMode + " | " + kUntilItHangs).code, 0);
}

}  // namespace
}  // namespace graze
