// Beyond CH: the orbits of the first windows, which hold one impact more each and crowd up to CH in
// the ratio of the closed form; inside its window an orbit that attracts is what a run settles on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "branch_checks.hpp"
#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/motion/simulation.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// By how much the distances of windows to CH shrink from one impact to the next: r^2/lambda^5,
// where a chatter that just completes shrinks by lambda in time, r = lambda^2 (2 + lambda)/(1 + 2
// lambda).
double crowding(double r) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 80; ++i) {
    const double at = 0.5 * (low + high);
    (at * at * (2.0 + at) / (1.0 + 2.0 * at) < r ? low : high) = at;
  }
  return r * r / std::pow(low, 5);
}

struct Window {
  const OrbitBranch* branch = nullptr;
  double nearest = 0.0;  // grazing to CH
};

// Those that the branches from a CH consist of, by their impacts.
std::map<int, Window> windows_at(const OrbitBranches& traced, const SpecialPoint& completion) {
  std::map<int, Window> windows;
  for (const OrbitBranch& branch : traced.branches) {
    if (branch.sticks()) continue;
    double nearest = INFINITY;
    for (const SpecialPoint& special : branch.special)
      if (special.kind == SpecialKind::kGrazing)
        nearest = std::min(nearest, std::abs(special.at.value - completion.at.value));
    Window& window = windows[branch.pattern.impacts()];
    if (branch.origin == completion.id) window = {&branch, nearest};
  }
  std::erase_if(windows, [](const auto& window) { return !window.second.branch; });
  return windows;
}

// Of the orbit of a window that attracts most: a run that begins beside it comes back to it.
int compare_with_run(const Scene& scene, const std::string& parameter, const OrbitBranch& window) {
  // Beside a grazing an orbit attracts on one side alone.
  const auto by_value = [](const OrbitBranchPoint& a, const OrbitBranchPoint& b) {
    return a.value < b.value;
  };
  const auto [low, high] =
      std::minmax_element(window.points.begin(), window.points.end(), by_value);
  const double near = 0.1 * (high->value - low->value);
  const auto largest = [&](const OrbitBranchPoint& point) {
    for (const SpecialPoint& special : window.special)
      if (special.kind == SpecialKind::kGrazing && std::abs(special.at.value - point.value) < near)
        return static_cast<double>(INFINITY);
    return std::abs(point.orbit.multipliers[0].value);
  };
  const OrbitBranchPoint& point =
      *std::min_element(window.points.begin(), window.points.end(),
                        [&](const auto& a, const auto& b) { return largest(a) < largest(b); });
  if (!(largest(point) < 0.8)) return 0;
  const OrbitImpact& first = point.orbit.impacts.front();
  const System system = assemble(
      with_parameter(with_parameter(scene, parameter, point.value), "forcing.phase", first.phase));
  const Vector& row = system.stops[0].row;
  // A little before its first impact, and a little slower.
  const State start{first.before.q - 1e-8 * row / row.squaredNorm(),
                    (1.0 - 1e-6) * first.before.qdot};
  SimulationOptions options;
  options.periods = 200;
  std::vector<double> speeds;
  RunListeners listeners;
  listeners.event = [&](const Event& event) {
    if (event.kind == EventKind::kImpact && event.period_index >= 158 && event.period_index < 198)
      speeds.push_back(event.speed);
  };
  simulate(system, start, options, listeners);
  // One may lie on the boundary of the periods.
  EXPECT_EQ((speeds.size() + 20) / 40, point.orbit.impacts.size()) << point.value;
  double fastest = 0.0;
  for (const OrbitImpact& impact : point.orbit.impacts) fastest = std::max(fastest, impact.speed);
  EXPECT_NEAR(*std::max_element(speeds.begin(), speeds.end()) / fastest, 1.0, 1e-8) << point.value;
  return 1;
}

struct WindowCase {
  std::string name;
  Scene scene;
  std::string parameter;
  BranchOptions range;
  double restitution;
  int windows, runs;  // at least
};

class ChatterWindows : public testing::TestWithParam<int> {};

WindowCase case_of(int which) {
  switch (which) {
    case 0:
      return {"oscillator",
              support::reference_scene(
                  "sticking/Z2b", {"forcing.frequency=0.5", "stop.gap=0.2", "initial.q=[0.2]"}),
              "stop.restitution",
              {.from = 0.2, .to = 0.54, .start_values = 1, .follow_depth = 1},
              0.5135,
              5,
              4};
    case 1:
      return {"two modes of a beam",
              support::shipped_scene("09_soft_stop_two_modes"),
              "forcing.frequency",
              {.from = 40.5, .to = 42.5, .start_values = 2, .follow_depth = 1},
              0.3,
              4,
              4};
    default:
      // Drawn at random.
      return {"drawn",
              parse_scene("[modal]\nfrequencies = [1.0, 4.37]\ndamping_ratios = [0.031, 0.017]\n"
                          "participation = [1.0, 0.23]\n"
                          "[forcing]\nkind = \"modal\"\namplitude = 1.0\nfrequency = 0.3\n"
                          "[[stop]]\nshape = [1.0, 0.41]\ngap = 0.17\nrestitution = 0.62\n",
                          "drawn.toml"),
              "stop.gap",
              {.from = 0.8, .to = 0.9, .start_values = 4, .follow_depth = 1},
              0.62,
              4,
              4};
  }
}

TEST_P(ChatterWindows, CrowdUpToTheCompletionInTheRatioOfTheClosedForm) {
  const WindowCase test = case_of(GetParam());
  SCOPED_TRACE(test.name);
  const OrbitBranches traced = support::trace_from_runs(test.scene, test.parameter, test.range);
  int completions = 0, runs = 0;
  for (const SpecialPoint* completion :
       support::special_points(traced, SpecialKind::kChatterCompletes)) {
    const std::map<int, Window> windows = windows_at(traced, *completion);
    if (windows.empty()) continue;
    ++completions;
    EXPECT_GE(static_cast<int>(windows.size()), test.windows) << completion->id;
    // One impact more in each.
    EXPECT_EQ(windows.rbegin()->first - windows.begin()->first + 1,
              static_cast<int>(windows.size()));
    const double ratio =
        std::next(windows.rbegin())->second.nearest / windows.rbegin()->second.nearest;
    EXPECT_NEAR(ratio / crowding(test.restitution), 1.0, 0.05) << completion->id;
    // Those of the narrowest windows are hardly apart.
    int wide = 4;
    for (auto window = windows.begin(); window != windows.end() && wide > 0; ++window, --wide)
      runs += compare_with_run(test.scene, test.parameter, *window->second.branch);
  }
  EXPECT_GE(completions, 1);
  EXPECT_GE(runs, test.runs);
  EXPECT_TRUE(std::any_of(traced.notes.begin(), traced.notes.end(), [](const std::string& note) {
    return note.find("infinitely many windows") != std::string::npos;
  }));
}

INSTANTIATE_TEST_SUITE_P(Scenes, ChatterWindows, testing::Range(0, 3));

}  // namespace
}  // namespace graze
