// Options of a search for periodic orbits, of their branches and loci, and how they reach what does
// the work.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/bifurcation/problem/branch_options.hpp"
#include "graze/record/shown_quantity.hpp"
#include "options/shared.hpp"

namespace graze {

// A parameter and its range.
struct RangeOptions {
  std::string parameter;
  double from = 0.0, to = 0.0;
};

// The same of a second parameter; empty if there is none.
struct SecondRangeOptions {
  std::string second;
  std::optional<double> second_from, second_to;
};

// Which periodic orbits are sought, and from where.
struct OrbitSearchOptions : MotionOptions {
  int period = 1;
  bool period_given = false;  // then no orbit of another one is listed
  std::optional<int> impacts;
  bool any_impacts = false;  // asked for in so many words
  bool keep_virtual = false;
  std::vector<std::string> starts;  // empty: all
  unsigned long long random_seed = 1;
};

// Their branches over a parameter.
struct BranchingOptions : OrbitSearchOptions, RangeOptions {
  std::optional<double> max_step;
  bool amplitudes = false;             // how large the motions are, of orbits and rows
  std::optional<ShownQuantity> curve;  // what of that a picture shows; else impact speeds
  std::string curve_at;                // "probe.1", "stop.2"; empty: the first place
  bool measures() const { return amplitudes || curve; }
  bool follows = false;  // onto other branches at special points
  int depth = 2;
};

// Loci of special points over two.
struct LocusTracingOptions : BranchingOptions, SecondRangeOptions {
  std::vector<std::string> locus;  // LP, PD, NS, GR, all; empty: no loci
  int slices = 8;
};

// Numbers of orbits to be marked where they take values, or are extreme.
struct LevelOptions {
  std::vector<std::string> levels, extremes;  // "stop.1.peak-force=10"; "probe.1.amplitude"
  bool level_ends = false;                    // branches end at levels
};

// A special point of an earlier run to go on from.
struct RestartOptions {
  std::string folder, label;  // empty: none
  bool switched = false;      // onto the other branch there
  std::string orbit_folder;   // in place of a special point: an orbit of that run,
  int orbit = 1;              // by its number or the row of its branch point
  std::string state;          // or the state of a motion: a folder of a run, or a table
  bool is_given() const { return !folder.empty() || !orbit_folder.empty() || !state.empty(); }
};

// What is traced of the parameter's range.
inline void set_range(const BranchingOptions& command, BranchOptions& options) {
  options.from = command.from;
  options.to = command.to;
  options.max_step = command.max_step.value_or(0.0);
}

// `parts`: what else there is to say of the step.
void describe_range(auto& v, BranchingOptions& o, const auto&... parts) {
  v.heading("Parameter");
  v.option("parameter", o.parameter, "NAME", "Path of the parameter, e.g. forcing.frequency",
           kMandatory, kOfPieces);
  v.option("from", o.from, "A", "Start of the parameter's range", finite_number(), kMandatory,
           kOfPieces);
  v.option("to", o.to, "B", "End of the parameter's range", finite_number(), kMandatory, kOfPieces);
  v.option("max_step", o.max_step, "D",
           "Largest change of the parameter in one step of a branch (default: range/50)",
           above_zero(), kOfResult, parts...);
}

void describe_period(auto& v, OrbitSearchOptions& o, const char* what, const auto&... parts) {
  v.option("period", o.period, "P", what, whole_number("a whole number from 1", 1.0, kMostPeriods),
           Given{o.period_given}, parts...);
}

// From `least` impacts on, up to `most`.
void describe_impacts(auto& v, OrbitSearchOptions& o, int least, double most, const char* what,
                      const auto&... parts) {
  const auto read = [&o](const std::string& text) {
    o.any_impacts = text == "any";
    o.impacts.reset();
    if (!o.any_impacts) o.impacts = std::stoi(text);
  };
  v.text("impacts", read, "K|any", what, impacts_or_any(least, most), parts...);
}

// `recorded`: whether a result depends on them.
void describe_search(auto& v, OrbitSearchOptions& o, const Recorded& recorded = kOfResult) {
  describe_limits(v, o);
  v.heading("Search for orbits");
  describe_period(v, o, "Forcing periods p after which the orbit repeats", recorded);
  v.flag("virtual", o.keep_virtual,
         "Keep inadmissible solutions too: penetrating a stop, or impact speed < 0", kOfResult);
  v.option(
      "start", o.starts, "NAME",
      "Where the search starts, several, separated by commas: closed-form (k = 1, 2), simulation, "
      "random (quasi-random phases, deflation, then global minimisation) (default: all)",
      Choices{{"closed-form", "simulation", "random"}}, kWithCommas,
      o.starts.empty() ? recorded.as("all") : recorded);
  v.option("random_seed", o.random_seed, "N", "Seed: another one moves the quasi-random starts",
           whole_number("a whole number, 0 or more", 0.0, kMostCounted), recorded);
}

// Which orbits' branches are traced, and how far from the first; whether results record either.
void describe_branch_kind(auto& v, BranchingOptions& o, const Recorded& impacts,
                          const Recorded& following) {
  v.heading("Branches");
  describe_impacts(
      v, o, 0, 64,
      "Impacts per orbit, on all stops together; 0: the response that meets no stop, alone; any: "
      "1, and whatever motions settle on (default: 1, and orbits that stick)",
      impacts);
  v.text(
      "follow", [&o](const std::string& word) { o.follows = word == "all"; }, "WHAT",
      "Switch branches at special points: none, or all: doubled orbits at PD, crossing branches at "
      "BP, one impact more or less at GR, one stuck phase more or less at CH (default: none)",
      Choices{{"none", "all"}}, Default{"none"}, following.as(o.follows ? "all" : "none"));
  v.option("depth", o.depth, "D",
           "With --follow all: special points switched at one after the other (default: 2)",
           whole_number_within(1, 16), following.where(o.follows));
}

constexpr const char* kPlaceShown =
    "With --show: the place, e.g. probe.1 or stop.2 (default: the first probe, else the first "
    "stop)";

void describe_curve(auto& v, BranchingOptions& o) {
  v.heading("Response curves");
  v.flag("amplitudes", o.amplitudes,
         "Measure the motions: largest, smallest, mean and root mean square values at the probes "
         "and stops, peak velocities, forces; the response without impacts is a branch too",
         kOfPieces.where(o.measures()).as(true));
  v.choice(
      "show", o.curve, kShownQuantities, "WHAT",
      "With pictures and pages: a response curve in place of impact speeds; implies --amplitudes",
      kOfResult);
  v.option("at", o.curve_at, "PLACE", kPlaceShown, Needs{{"show"}}, kOfResult);
}

void describe_locus_kinds(auto& v, LocusTracingOptions& o, const char* what, const Choices& kinds,
                          const auto&... parts) {
  v.heading("Loci of special points");
  v.option("locus", o.locus, "KIND", what, kinds, kWithCommas, kOfResult, parts...);
}

void describe_levels(auto& v, LevelOptions& o) {
  v.heading("Levels");
  v.option("level", o.levels, "QUANTITY=VALUE",
           "Mark where a number of the orbits takes a value (UZ), with --locus UZ along curves: "
           "stop.1.peak-force=10, probe.1.amplitude=2e-3, speed=0.5; what --show shows, speed, "
           "phase, contact-duration, stuck-duration, impulse, clearance, multiplier, period; "
           "several, separated by commas",
           kWithCommas, kOfResult);
  v.flag("level_ends", o.level_ends, "With --level: branches end there", Needs{{"level"}},
         kOfResult.where(o.level_ends));
  v.option("extreme", o.extremes, "QUANTITY",
           "Mark where a number of the orbits is largest or smallest along the branch (EX), with "
           "--locus EX along curves; several, separated by commas",
           kWithCommas, kOfResult);
}

void describe_slices(auto& v, LocusTracingOptions& o, const Recorded& recorded) {
  v.option(
      "slices", o.slices, "N",
      "With --locus: values of either parameter, besides the scene's own, at which special points "
      "are sought to start from; a locus that crosses none and meets no other is missed",
      whole_number_within(0, 10'000), Needs{{"locus"}}, recorded.where(!o.locus.empty()));
}

void describe_restart(auto& v, RestartOptions& o) {
  v.heading("Restart");
  v.option("restart", o.folder, "DIR",
           "Start from a special point of the run that --out left in this folder, in the same "
           "parameter, another one, or as a locus",
           Excludes{{"period", "impacts", "start", "random_seed", "slices"}}, kOfResult);
  v.option("label", o.label, "ID", "With --restart: the special point's id, e.g. PD1",
           Needs{{"restart"}}, kOfResult);
  v.flag("switch", o.switched,
         "With --restart: onto the branch that begins or crosses there: doubled orbits at PD, the "
         "crossing branch at BP, one impact more or less at GR",
         Needs{{"restart"}}, Excludes{{"locus"}}, kOfResult.where(o.switched));
  v.option("from_orbit", o.orbit_folder, "DIR",
           "Start from an orbit of the run that --out left in this folder, of graze orbit, or any "
           "point of a branch of graze continue or diagram",
           Excludes{{"restart", "period", "impacts", "start", "random_seed", "slices", "locus"}},
           kOfResult);
  v.option("orbit", o.orbit, "N",
           "With --from-orbit: the orbit's number, or the row of branches.csv, from 1",
           whole_number_within(1, 100'000'000), Needs{{"from_orbit"}},
           kOfResult.where(!o.orbit_folder.empty()));
  v.option(
      "from_state", o.state, "FILE",
      "Start from the orbit of --period that goes through a state, stable or not: the end of the "
      "run that graze simulate --out left in a folder, or the first row of a table, at t = 0, of "
      "time, displacements and velocities",
      Excludes{{"restart", "from_orbit", "impacts", "start", "random_seed", "slices", "locus"}},
      kOfResult);
}

}  // namespace graze
