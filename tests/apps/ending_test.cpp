// Whatever a command is at, it ends soon after it was asked to, with the exit code that says so.
#include <gtest/gtest.h>

#include "apps/program.hpp"

namespace graze {
namespace {

// Ten times the second within which a command is to end: who is still there hangs.
const std::string kHangs = "10";

const std::string kOneMode = scene("05_wagg_one_mode.toml");
// Some 1e10 oscillations of the beam in one forcing period.
const std::string kSlowForcing = kOneMode + " --set forcing.frequency=1e-8";
// Some 1e17 of them.
const std::string kStiffBeam = kOneMode + " --set beam.youngs_modulus=1e40";
const std::string kGaps = " --parameter stop.gap --from 1e-3 --to 2e-3";
const std::string kPlane =
    kGaps + " --second stop.restitution --second-from 0.5 --second-to 0.9 --points 4" +
    " --second-points 4";

struct Endless {
  const char* name;
  std::string arguments;
};

const std::vector<Endless> kEndless{
    {"a run of slow forcing", "simulate " + kSlowForcing},
    {"orbits under slow forcing", "orbit " + kSlowForcing},
    {"branches under slow forcing", "continue " + kSlowForcing + kGaps},
    {"a diagram under slow forcing", "diagram " + kSlowForcing + kGaps},
    {"a run of a stiff beam", "simulate " + kStiffBeam},
    {"orbits of a stiff beam", "orbit " + kStiffBeam},
    {"a map of a stiff beam", "map " + kStiffBeam + kPlane},
    {"costs of a stiff beam", "cost " + kStiffBeam},
    {"a comparison of stiff beams", "compare " + kStiffBeam + " --against stop.gap=1.2e-3"},
};

TEST(Program, EveryCommandEndsWhenItsTimeIsUp) {
  for (const Endless& endless : kEndless) {
    const Finished run =
        run_graze(endless.arguments + " --max-seconds 0.2", "timeout -s KILL " + kHangs + " ");
    EXPECT_EQ(run.code, 3) << endless.name << ": " << run.err;
  }
}

TEST(Program, EveryCommandEndsWhenAsked) {
  for (const Endless& endless : kEndless) {
    const Finished run =
        run_graze(endless.arguments, "timeout --preserve-status -s TERM -k " + kHangs + " 0.3 ");
    EXPECT_EQ(run.code, 130) << endless.name << ": " << run.err;
  }
}

}  // namespace
}  // namespace graze
