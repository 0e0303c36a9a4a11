// Instructions with and without an effect. Counts do not depend on what else the machine does.
#include <gtest/gtest.h>

#include <fstream>

#include "counted_instructions.hpp"
#include "noted_cost.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

using cost::Counted;
using cost::CountedRun;

// A structure of four modes that meets nothing.
constexpr const char* kFree = R"(
[modal]
frequencies = [20.0, 55.0, 110.0, 190.0]
participation = [1.0, 0.6, 0.3, 0.2]
inertia = [1.0, 0.5, 0.3, 0.2]
[forcing]
kind = "modal"
amplitude = 1.0
frequency = 17.0
)";

class Instructions : public testing::Test {
 protected:
  void SetUp() override {
    if (support::kSlowBuild) GTEST_SKIP() << "sanitizers do not run under valgrind";
  }
};

class SceneFile {
 public:
  explicit SceneFile(const std::string& text) { std::ofstream(path()) << text; }
  std::string path() const { return (folder_ / "scene.toml").string(); }

 private:
  ScratchFolder folder_;
};

double of_free_motion(const std::string& more) {
  const SceneFile file(kFree + more);
  return cost::per_period({file.path(), 50, 20});
}

// They are part of the modes: an assembled system has them in its numbers, not in more work.
TEST_F(Instructions, LinearEffectsCostNothing) {
  const double bare = of_free_motion("");
  struct Effect {
    const char *name, *text;
  };
  for (const Effect& effect :
       {Effect{"damping ratios", "[damping]\nratios = [0.01, 0.01, 0.02, 0.02]\n"},
        Effect{"Rayleigh damping", "[damping]\nrayleigh = { mass = 0.1, stiffness = 1e-4 }\n"},
        Effect{"gravity", "[gravity]\nacceleration = -9.81\n"},
        Effect{"both",
               "[damping]\nrayleigh = { mass = 0.1, stiffness = 1e-4 }\n[gravity]\nacceleration = "
               "9.81\n"}}) {
    const double with = of_free_motion(effect.text);
    EXPECT_NEAR(with / bare, 1.0, 0.01) << effect.name;
    cost::note("linear", effect.name, bare, with);
  }
}

TEST_F(Instructions, NothingIsLookedForWithoutAStop) {
  const SceneFile file(kFree);
  const Counted free = cost::count({file.path(), 50, 20});
  for (const char* name : {"first_zero_detail", "ArcCurve", "sum_terms"})
    EXPECT_FALSE(free.calls(name)) << name;
  EXPECT_TRUE(free.calls("Arc<double>::state"));
}

TEST_F(Instructions, WhatIsNotAskedForIsNotCalled) {
  const std::vector<std::string> wide = {"stop.gap=5e-3"};
  const Counted plain = cost::count({"02_wagg_momentum", 20, 0, false, wide});
  const Counted balance = cost::count({"02_wagg_momentum", 20, 0, true, wide});
  EXPECT_EQ(plain.answer, balance.answer);
  EXPECT_TRUE(plain.calls("ArcCurve"));
  for (const char* name : {"work_along", "mechanical_energy"}) {
    EXPECT_FALSE(plain.calls(name)) << name;
    EXPECT_TRUE(balance.calls(name)) << name;
  }
  // Contact forces, sticking, chatter: with the gap of the scene the beam comes to rest on its
  // stop.
  const Counted sticking = cost::count({"02_wagg_momentum", 4, 0, false, {}});
  for (const char* name : {"first_release", "solve_contacts", "decide_resting", "is_quiet"}) {
    EXPECT_FALSE(plain.calls(name)) << name;
    EXPECT_TRUE(sticking.calls(name)) << name;
  }
}

// Not asserted: what effects that are there cost, for the table.
TEST_F(Instructions, OfEffectsThatAreThere) {
  const CountedRun beam{"02_wagg_momentum", 40, 0, false, {"stop.gap=5e-3"}};
  const double plain = cost::per_period(beam);
  const auto note = [&](const std::string& effect, const CountedRun& run) {
    const double with = cost::per_period(run);
    EXPECT_GT(with, 0.0);
    cost::note("present", effect, plain, with);
  };
  CountedRun with = beam;
  with.samples = 20;
  note("20 samples a forcing period", with);
  with = beam;
  with.energy = true;
  note("the energy balance", with);
  with = beam;
  with.settings.push_back("stop.restitution=[0.8, 0.01]");
  note("r(v)", with);
  with = beam;
  with.settings.push_back("stop.impulse=\"collocation\"");
  note("the collocation impulse", with);
}

}  // namespace
}  // namespace graze
