// A caller of the library is told what the program tells its user.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/bifurcation/trace/orbit_branches.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

Scene one_mode() {
  return read_scene(std::string(GRAZE_SOURCE_DIR) + "/data/scenes/05_wagg_one_mode.toml");
}

struct Case {
  BranchOptions options;
  std::string sentence;
};

std::vector<Case> faulty() {
  const double infinity = std::numeric_limits<double>::infinity();
  const BranchOptions good{.from = 20.0, .to = 40.0};
  const auto with = [&](const auto& change, const std::string& sentence) {
    Case made{good, sentence};
    change(made.options);
    return made;
  };
  return {
      {BranchOptions{}, "from, to: the range must not be empty"},
      with([&](auto& o) { o.to = infinity; }, "from, to: the range must be of finite numbers"),
      with([](auto& o) { o.to = 20.0 + 1e-12; }, "from, to: the range must be wider than 2.22e-10"),
      with([](auto& o) { o.max_step = -1.0; }, "max_step: '-1' is not a number above 0"),
      with([](auto& o) { o.max_step = std::nan(""); }, "max_step: 'nan' is not a number above 0"),
      with([](auto& o) { o.max_step = 1e-5; }, "give at least 0.001"),
      with([](auto& o) { o.period = 0; }, "period: '0' is not a whole number from 1"),
      with([](auto& o) { o.impacts = -1; }, "impacts: '-1' is not a whole number from 0"),
      with([](auto& o) { o.impacts = 0, o.period = 2; }, "period: the response that meets no stop"),
      with([](auto& o) { o.start_values = -1; }, "start_values: '-1' is not"),
      with([](auto& o) { o.follow_depth = -1; }, "follow_depth: '-1' is not"),
  };
}

void expect_told(const std::string& sentence, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << "not told: " << sentence;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
  }
}

TEST(OptionFaults, AreToldToWhoTracesBranches) {
  const SystemFamily family(one_mode(), "forcing.frequency");
  for (const Case& wrong : faulty())
    expect_told(wrong.sentence, [&] { trace_orbits(family, wrong.options); });
}

TEST(OptionFaults, AreToldToWhoTracesLoci) {
  LociOptions options;
  options.second_from = 1e-3;
  options.second_to = 2e-3;
  options.kinds = {OrbitLocusKind::kFold};
  const auto trace = [&] { trace_loci(one_mode(), "forcing.frequency", "stop.gap", options); };
  for (const Case& wrong : faulty()) {
    options.branches = wrong.options;
    expect_told(wrong.sentence, trace);
  }
  options.branches = {.from = 20.0, .to = 40.0};
  options.second_to = options.second_from;
  expect_told("second_from, second_to: the range must not be empty", trace);
}

}  // namespace
}  // namespace graze
