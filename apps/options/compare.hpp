// The command compare.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "graze/record/names/plane_names.hpp"
#include "graze/record/study_records.hpp"
#include "options/picture.hpp"
#include "options/search.hpp"
#include "options/work.hpp"

namespace graze {

struct CompareCommand : MotionOptions, RangeOptions, SecondRangeOptions {
  std::vector<std::string> against;      // "KEY=VALUE" of the other scene
  int fewest_modes = 0, most_modes = 0;  // of a series; 0: none
  long long first_impacts = 20;
  double within = 0.01;            // of a forcing period, of a speed
  std::optional<double> duration;  // s of a run
  std::optional<double> last;      // s of its end, in a picture
  int points = 21, second_points = 21;
  ComparedQuantity show = ComparedQuantity::kAttractor;
  bool sensitivity = false;
  std::vector<double> second_values;
  std::optional<double> reference;
  SettlingOptions settling;
  JournalOptions journal;

  bool is_over_plane() const { return !parameter.empty() && !sensitivity; }
};

// Reads "1:8", or throws InputError.
void read_modes(const std::string& text, CompareCommand& command);

void describe_what_is_compared(auto& v, CompareCommand& o, const Recorded& of_motions) {
  v.heading("Comparison");
  v.option("against", o.against, "KEY=VALUE",
           "The other scene: this one with a key changed, as with --set; as often as wanted",
           kRepeated, kOfPieces);
  v.text(
      "modes", [&o](const std::string& text) { read_modes(text, o); }, "A:B",
      "Convergence: each number of modes compared with the next",
      kOfPieces.where(o.most_modes > 0).as(fmt::format("{}:{}", o.fewest_modes, o.most_modes)));
  v.flag("sensitivity", o.sensitivity,
         "Sensitivity of the largest absolute value (s1) and of the final value (s2) of every "
         "probe to --parameter",
         Excludes{{"first", "within", "second_from", "second_to", "second_points", "show", "last",
                   "periods", "samples", "resume", "restart_work", "shard"}},
         kOfPieces.where(o.sensitivity));
  v.option("first", o.first_impacts, "K", "First impacts that are compared",
           whole_number_within(1, 10'000), of_motions);
  v.option("within", o.within, "PART",
           "First impacts agree while their times differ by no more than this part of a forcing "
           "period, their speeds of the fastest one's",
           above_zero(), of_motions);
}

void describe_ranges(auto& v, CompareCommand& o) {
  const Recorded if_range = kOfPieces.where(!o.parameter.empty());
  const Needs parameter{{"parameter"}}, second{{"second"}};
  v.heading("Parameters");
  v.option("parameter", o.parameter, "NAME", "Path of the parameter, e.g. stop.gap",
           Needs{{"from", "to"}}, kOfPieces);
  v.option("from", o.from, "A", "Start of the parameter's range", finite_number(), kNoDefault,
           parameter, if_range);
  v.option("to", o.to, "B", "End of the parameter's range", finite_number(), kNoDefault, parameter,
           if_range);
  v.option("points", o.points, "N", "Values from A to B, both among them",
           whole_number_within(2, 1'000'000), parameter, if_range);
  v.option("second", o.second, "NAME", "Path of another parameter", parameter, kOfPieces);
  v.option("second_from", o.second_from, "C", "Start of its range", finite_number(), second,
           kOfPieces);
  v.option("second_to", o.second_to, "D", "End of its range", finite_number(), second, kOfPieces);
  v.option("second_points", o.second_points, "M", "Values from C to D, both among them",
           whole_number_within(2, 10'000), second, kOfPieces.where(o.is_over_plane()));
  v.choice("show", o.show, kComparedQuantities, "WHAT", "What the picture shows of every cell",
           parameter, kOfResult.where(o.is_over_plane()));
}

void describe(auto& v, CompareCommand& o) {
  v.command(
      "compare", "Compare motions: with another choice, with more modes, over a parameter",
      "compare data/scenes/01_wagg_2004.toml --against beam.discretisation=galerkin\n"
      "         graze compare data/scenes/02_wagg_momentum.toml --modes 1:8\n"
      "         graze compare data/scenes/20_yigit_sensitivity.toml --sensitivity \\\n"
      "           --duration 0.2 --parameter stop.spring.damping.coefficient --from 0 --to 1000");
  const Recorded of_motions = kOfPieces.where(!o.sensitivity);
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<ComparisonRecord>);
  describe_what_is_compared(v, o, of_motions);
  describe_ranges(v, o);
  v.heading("Sensitivity");
  v.option("second_values", o.second_values, "V1,V2,..",
           "With --sensitivity: values of the other parameter, separated by commas", kWithCommas,
           Needs{{"second", "sensitivity"}}, kOfPieces);
  v.option(
      "reference", o.reference, "V",
      "With --sensitivity: value that ends are compared with (default: the middle of the range)",
      finite_number(), Needs{{"sensitivity"}}, kOfPieces);
  v.heading("Motion");
  v.option("duration", o.duration, "S",
           "Time of a run, s (default: 50 forcing periods, of which --plot shows the end)",
           above_zero(), kOfPieces.where(o.sensitivity));
  v.option("last", o.last, "S", "End of the run that --plot shows, s (default: 4 forcing periods)",
           above_zero(), Excludes{{"parameter"}});
  describe_following(v, o.settling, of_motions);
  describe_closure_speed(v, o, of_motions);
  describe_limits(v, o, of_motions, kOfResult.where(o.is_over_plane()));
  describe_journal(v, o.journal);
}

}  // namespace graze
