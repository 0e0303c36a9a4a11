// Commands that look at a scene or change it: init, check, modes, cost, fit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "first_scene.hpp"
#include "options/picture.hpp"
#include "options/shared.hpp"

namespace graze {

// A scene to begin with.
struct InitCommand : CommonOptions {
  std::string kind = "beam";  // beam | oscillator | matrices | hub
  std::string file;           // empty: onto stdout
};

struct CheckCommand : SceneOptions {  // a picture shows the mode shapes
  bool parameters = false;            // list them and nothing else
};

struct ModesCommand : SceneOptions {
  std::string mac;  // a scene, or a file of shapes; empty: none
};

struct CostCommand : MotionOptions {
  int impacts = 20;
  std::optional<double> duration;  // s
};

struct FitCommand : MotionOptions {
  std::string data;                       // file, or what stands for it
  std::optional<std::string> given_data;  // its text, where that is in no file
  std::vector<std::string> sought;        // "NAME=LOW:HIGH"
  std::vector<std::string> columns;       // empty: all
  std::vector<std::string> sigmas;        // "VALUE" or "COLUMN=VALUE"
  bool global = false;
  long long max_evaluations = 5000;
};

void describe(auto& v, InitCommand& o) {
  v.command("init", "Write a commented scene to begin with, onto stdout or into a file",
            "init beam my_beam.toml");
  v.heading(kSceneGroup);
  v.file("KIND", o.kind,
         "What the scene is of: beam against a stop, oscillator (modes given as numbers), matrices "
         "of a finite-element model, or hub (a beam that turns)",
         Choices{first_scene_kinds()});
  v.file("FILE", o.file, "File to write, which must not be there yet");
}

void describe(auto& v, CheckCommand& o) {
  v.command("check",
            "Read a scene and say what is simulated: modes, frequencies, conditioning, flow",
            "check data/scenes/02_wagg_momentum.toml --set beam.modes=8");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<CheckRecord>);
  v.heading("Parameters");
  v.flag("parameters", o.parameters,
         "List what --parameter may name, with values and units, and nothing else",
         Excludes{{"json", "out", "plot"}});
}

void describe(auto& v, ModesCommand& o) {
  v.command("modes", "Natural modes of the structure: frequencies, effective masses, shapes",
            "modes data/scenes/24_frame_from_matrices.toml --plot modes.png");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<ModesRecord>);
  v.heading("Comparison");
  v.option("mac", o.mac, "FILE",
           "Compare the shapes by the modal assurance criterion with those of another scene, or of "
           "a file with a degree of freedom and its displacements in a line");
}

void describe(auto& v, CostCommand& o) {
  v.command("cost", "What accuracy costs in time, flow by flow",
            "cost data/scenes/02_wagg_momentum.toml --set stop.gap=5e-3 --plot cost.png");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<CostRecord>);
  v.heading("Comparison");
  v.option("impacts", o.impacts, "K", "Impacts over which flows are compared (default 20)",
           whole_number_within(1, 1'000'000), kOfResult);
  v.option("duration", o.duration, "S",
           "Most simulated time, s (default: 100 forcing periods; without forcing, of the slowest "
           "oscillation)",
           above_zero(), kOfResult.named("longest"));
  describe_closure_speed(v, o);
  describe_limits(v, o, Recorded{});
}

void describe(auto& v, FitCommand& o) {
  v.command("fit", "Identify parameters of the scene from measurements",
            "fit data/measurements/restitution.toml data/measurements/restitution.csv\n"
            "         graze fit data/measurements/contact.toml data/measurements/contact.csv \\\n"
            "           --parameter stop.spring.stiffness=1e6:1e9");
  describe_scene(v, o);
  v.file("DATA", o.data,
         "Measurements (CSV): speed,restitution; time and stop of impacts; or time and force1, "
         "gap1, displacement1, velocity1, penetration1, q1, qdot1, ..",
         kMandatory, kOfResult.named("data"));
  describe(v, o.plot, kFeatures<FitRecord>);
  v.heading("Fit");
  v.option("parameter", o.sought, "NAME=LOW:HIGH",
           "A parameter that is fitted and the values between which it is sought; as often as "
           "wanted. Also record.start, initial.q.1, initial.qdot.1, .. Of restitutions all "
           "coefficients by default",
           kRepeated);
  v.option("column", o.columns, "NAME",
           "Columns of a response that are fitted, several, separated by commas (default: all)",
           kWithCommas, kOfResult);
  v.option("sigma", o.sigmas, "[COLUMN=]VALUE",
           "Standard uncertainty of the data in SI units, in place of a column sigma; of one "
           "column with its name (default: from the residuals)",
           kRepeated, kOfResult);
  v.text(
      "algorithm", [&o](const std::string& word) { o.global = word == "global"; }, "NAME",
      "local: from the scene's values on; global: search between all limits first",
      Choices{{"local", "global"}}, Default{"local"}, kOfResult.as(o.global ? "global" : "local"));
  v.option("max_evaluations", o.max_evaluations, "N",
           "Most evaluations of the model; the best values so far are then printed",
           whole_number("a whole number from 1", 1.0, 1e9), kOfResult);
  describe_closure_speed(v, o);
  describe_limits(v, o);
}

}  // namespace graze
