// Properties that hold for every scene, checked on random ones by rapidcheck. The environment says
// how many and how closely:
//
//   GRAZE_SCENES   scenes per property (default 300)
//   GRAZE_SAMPLES  samples per forcing period (default 2000)
//   GRAZE_SEED     of the scenes (default 1, so that every run draws the same)
//   GRAZE_PROGRESS any value: a line on stderr from time to time
//
// A failure prints the scene as TOML, made as simple as it still fails.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "graze/scene/parameter.hpp"
#include "graze/system/scale.hpp"
#include "support/random_scene.hpp"

namespace graze::property {

using support::Prepared;

inline std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

// The sanitizers make everything some 20 times slower.
#ifdef __SANITIZE_ADDRESS__
inline constexpr std::uint64_t kScenes = 60;
#else
inline constexpr std::uint64_t kScenes = 300;
#endif

inline double samples_per_period() {
  return static_cast<double>(from_environment("GRAZE_SAMPLES", 2000));
}

// Forcing periods (see time_unit) per scene; most that impact at all do so within two.
inline constexpr double kPeriods = 10.0;
// Impacts per scene: a chatter that never completes would spend any number.
inline constexpr long long kMostImpacts = 5000;

// value/size; what has decayed to where numbers lose their digits (1e-292) is nothing.
inline double relative(double value, double size) {
  constexpr double kLeast =
      std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  return value / std::max(size, kLeast);
}

// A length that the motion at a stop is rounded at, m: its gap, how far forcing and load move it.
inline double length_at(const System& system, const Stop& stop) {
  double length = reach_at(system, stop);
  if (system.load())
    for (Eigen::Index j = 0; j < system.omega.size(); ++j)
      if (system.omega[j] > 0.0)
        length += std::abs(stop.row[j] * (*system.load())[j]) / (system.omega[j] * system.omega[j]);
  return length;
}

// A scene, as rapidcheck draws and prints it.
struct Drawn {
  Scene scene;
};

inline void showValue(const Drawn& drawn, std::ostream& out) {
  const auto usable = support::prepared(drawn.scene);
  if (usable) out << fmt::format("# --duration {:.17g}\n", kPeriods * support::time_unit(*usable));
  out << write_scene(drawn.scene);
}

// The scene without mode j.
inline Scene without_mode(const Scene& scene, std::size_t j) {
  Scene simpler = scene;
  const auto drop = [j](std::vector<double>& list) {
    if (j < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(j));
  };
  if (auto* modal = std::get_if<ModalStructure>(&simpler.structure)) {
    drop(modal->frequencies);
    drop(modal->participation);
    drop(modal->inertia);
    for (SceneStop& stop : simpler.stops) drop(stop.shape);
  } else {
    --std::get<Beam>(simpler.structure).modes;
  }
  if (simpler.damping)
    if (auto* ratios = std::get_if<DampingRatios>(&*simpler.damping)) drop(ratios->ratios);
  if (simpler.initial) {
    drop(simpler.initial->q);
    drop(simpler.initial->qdot);
  }
  return simpler;
}

// To two digits.
inline double rounded(double value) { return std::stod(fmt::format("{:.1e}", value)); }

// Scenes with one thing less, then with one number rounded.
inline std::vector<Drawn> simpler_scenes(const Drawn& drawn) {
  const Scene& scene = drawn.scene;
  std::vector<Scene> list;
  const auto vary = [&](auto&& change) { change(list.emplace_back(scene)); };
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    vary([i](Scene& s) { s.stops.erase(s.stops.begin() + static_cast<std::ptrdiff_t>(i)); });
  const auto modes = static_cast<std::size_t>(scene.modes());
  for (std::size_t j = modes; modes > 1 && j-- > 0;) list.push_back(without_mode(scene, j));
  if (scene.gravity) vary([](Scene& s) { s.gravity.reset(); });
  if (scene.damping) vary([](Scene& s) { s.damping.reset(); });
  if (scene.initial) vary([](Scene& s) { s.initial.reset(); });
  if (scene.forcing) vary([](Scene& s) { s.forcing.reset(); });
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    if (scene.stops[i].restitution.size() > 1)
      vary([i](Scene& s) { s.stops[i].restitution.resize(1); });
  for (const std::string& name : parameter_names(scene)) {
    const double value = *find_parameter(scene, name);
    if (rounded(value) != value) vary([&](Scene& s) { *find_parameter(s, name) = rounded(value); });
  }
  if (scene.initial) {
    for (std::size_t j = 0; j < modes; ++j) {
      vary([j](Scene& s) { s.initial->q[j] = 0.0; });
      vary([j](Scene& s) { s.initial->qdot[j] = 0.0; });
      vary([j](Scene& s) { s.initial->q[j] = rounded(s.initial->q[j]); });
      vary([j](Scene& s) { s.initial->qdot[j] = rounded(s.initial->qdot[j]); });
    }
  }
  std::vector<Drawn> usable;
  const std::string text = write_scene(scene);
  for (const Scene& simpler : list)
    if (write_scene(simpler) != text && support::prepared(simpler)) usable.push_back({simpler});
  return usable;
}

inline rc::Gen<Drawn> random_scenes() {
  return [](const rc::Random& random, int) {
    rc::Random source(random);
    support::Dice dice(source.next());
    const Drawn drawn{support::RandomScene(dice).draw()};
    return rc::shrinkable::shrinkRecur(
        drawn, [](const Drawn& d) { return rc::seq::fromContainer(simpler_scenes(d)); });
  };
}

// What a property met: the worst value of each quantity and how often each thing came up; printed
// at the end.
class Summary {
 public:
  explicit Summary(std::string title) : title_(std::move(title)) {}
  ~Summary() {
    std::string text = fmt::format("{}:", title_);
    for (const auto& [name, value] : worst_) text += fmt::format("\n    {} {:.3g}", name, value);
    std::string counts;
    for (const auto& [name, count] : counts_)
      counts += fmt::format("{}{} {}", counts.empty() ? "\n    " : ", ", count, name);
    std::cout << text << counts << std::endl;
  }
  Summary(const Summary&) = delete;
  Summary& operator=(const Summary&) = delete;

  // Keeps the largest; what is no number counts as infinite.
  void note(const std::string& name, double value) {
    const double size = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
    const auto [at, first] = worst_.emplace(name, size);
    if (!first && size > at->second) at->second = size;
  }
  void count(const std::string& name, long long times = 1) { counts_[name] += times; }

  // Fails the property when `value`, noted under `name`, exceeds `limit`.
  void require(const std::string& name, double value, double limit, const std::string& where) {
    note(name, value);
    if (!(value <= limit))
      RC_FAIL(fmt::format("{}: {:.17g} exceeds {:.3g} {}", name, value, limit, where));
  }

 private:
  std::string title_;
  std::map<std::string, double> worst_;
  std::map<std::string, long long> counts_;
};

// Runs `property` on the random scenes of this test.
inline void for_random_scenes(const std::function<void(const Prepared&, Summary&)>& property) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const rc::detail::TestMetadata metadata{info->name(), info->name()};
  // Rapidcheck prints the configuration that it reads; one that is given comes first.
  const std::uint64_t seed = from_environment("GRAZE_SEED", 1);
  setenv("RC_PARAMS", fmt::format("seed={}", seed).c_str(), 0);
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = static_cast<int>(from_environment("GRAZE_SCENES", kScenes));
  const bool progress = std::getenv("GRAZE_PROGRESS") != nullptr;
  Summary summary(info->name());
  int tried = 0;
  double slowest = 1.0;  // s; quicker ones are not worth telling
  const auto check = [&]() {
    const Drawn drawn = *random_scenes();
    if (progress && ++tried % 20 == 0)
      std::cerr << fmt::format("{} {} of {}\n", info->name(), tried, params.maxSuccess);
    const auto start = std::chrono::steady_clock::now();
    property(*support::prepared(drawn.scene), summary);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    summary.note("seconds, slowest scene", spent.count());
    if (progress && spent.count() > slowest) {
      slowest = spent.count();
      std::ostringstream text;
      showValue(drawn, text);
      std::cerr << fmt::format("the slowest scene so far took {:.3g} s:\n{}\n", slowest,
                               text.str());
    }
  };
  const auto result = rc::detail::checkTestable(check, metadata, params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  ADD_FAILURE() << text.str();
}

}  // namespace graze::property
