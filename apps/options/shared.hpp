// Options that all commands have, or all that work on a scene.
#pragma once

#include <fmt/format.h>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/base/defaults.hpp"
#include "graze/report/picture/picture_request.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/scene.hpp"
#include "option_values.hpp"
#include "options/option.hpp"

namespace graze {

class Caller;

struct CommonOptions {
  std::string name;                    // of the command
  std::vector<std::string> arguments;  // all of them, as they were given
  bool json = false;
  bool quiet = false;
  TextOptions text;  // of what is printed
  std::string out;   // folder; empty: none
  PictureRequest plot;
  int threads = 0;  // 0: all cores
  double max_seconds = 3600.0;
  std::chrono::steady_clock::time_point called = std::chrono::steady_clock::now();
  Caller* caller = nullptr;  // null: a shell, which reads what is printed
};

struct SceneOptions : CommonOptions {
  std::string scene;  // file
  std::vector<std::string> settings;
  std::optional<std::string> scene_text;  // in place of what the file holds now
  std::shared_ptr<const Scene> given;     // the same with its settings, where it was read already
};

struct MotionOptions : SceneOptions {
  std::optional<double> closure_speed;  // m/s
  long long max_impacts = kDefaultImpactBudget;
};

void describe_printing(auto& v, CommonOptions& o) {
  v.heading(kOutputGroup);
  v.flag("json", o.json, "Print one JSON document and nothing else on stdout", Letter{'j'});
  v.flag("quiet", o.quiet, "No progress, no warnings", Letter{'q'});
  v.flag(
      "wide", [&o] { o.text.width = kAnyWidth; },
      fmt::format("Tables and sentences as wide as they are (default: {} characters)",
                  TextOptions{}.width));
  v.flag("verbose", o.text.verbose,
         "Also residuals, counts and notes that tell how the numerics went", Letter{'v'});
}

void describe_output(auto& v, CommonOptions& o, const auto&... of_folder) {
  describe_printing(v, o);
  v.option(
      "out", o.out, "DIR",
      "Write result.json, scene.toml, record.json (for graze view) and tables into this folder",
      Letter{'o'}, of_folder...);
  v.heading(kNumericsGroup);
  v.option(
      "threads", o.threads, "N",
      "Threads to use, 0 (default) for all cores; results do not depend on it",
      whole_number(fmt::format("a whole number from 1 to {:.0f}, or 0 for all cores", kMostThreads),
                   0.0, kMostThreads));
}

void describe_scene(auto& v, SceneOptions& o) {
  v.heading(kSceneGroup);
  v.file("SCENE", o.scene, "Scene file (TOML)", kMandatory);
  v.option("set", o.settings, "NAME=VALUE",
           "Replace or add one key of the scene, e.g. stop.gap=2e-3; as often as wanted",
           Letter{'s'}, kRepeated);
  describe_output(v, o);
}

void describe_closure_speed(auto& v, MotionOptions& o, const Recorded& recorded = kOfPieces) {
  v.heading(kNumericsGroup);
  v.option(
      "closure_speed", o.closure_speed, "V",
      "Impact speed below which the rest of a chatter is computed at once, as a geometric series, "
      "m/s (default: sqrt(solver.tolerance/100) of the motion's speed; graze check prints it)",
      at_least("a speed in m/s, 0 or more", 0.0), recorded);
}

void describe_max_seconds(auto& v, CommonOptions& o, const Recorded& recorded = kOfResult) {
  v.heading(kNumericsGroup);
  v.option("max_seconds", o.max_seconds, "S",
           "Most computing time, s; what was reached by then is printed", above_zero(), recorded);
}

void describe_limits(auto& v, MotionOptions& o, const Recorded& impacts = kOfPieces,
                     const Recorded& seconds = kOfResult) {
  v.heading(kNumericsGroup);
  v.option("max_impacts", o.max_impacts, "N",
           "Most impacts of one simulated motion; it then ends and says so",
           whole_number("a whole number from 1", 1.0, kMostCounted), impacts);
  describe_max_seconds(v, o, seconds);
}

}  // namespace graze
