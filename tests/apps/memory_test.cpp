// Nothing is read that was not written: commands under valgrind's memcheck.
#include <gtest/gtest.h>

#include "apps/program.hpp"
#include "support/reached.hpp"

namespace graze {
namespace {

TEST(Memory, IsReadOnlyAfterItWasWritten) {
  if (support::kSlowBuild) GTEST_SKIP() << "a sanitizer and valgrind exclude each other";
  // Contacts followed by extrapolation, on a spring and with a hub that turns, and their
  // derivatives.
  for (const std::string& arguments :
       {"simulate --duration 0.352 --record none " + scene("19_yigit_momentum.toml"),
        "orbit --impacts 1 --start closed-form " + scene("12_spring_dashpot_oscillator.toml")}) {
    const Finished run =
        run_graze(arguments, "LD_PRELOAD='" GRAZE_PRELOADED "' valgrind -q --error-exitcode=9 ");
    EXPECT_TRUE(run.code == 0 || run.code == 3) << arguments << "\n" << run.err.substr(0, 2000);
  }
}

}  // namespace
}  // namespace graze
