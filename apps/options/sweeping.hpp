// The commands that follow motions at many values: diagram, map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/record/names/motion_names.hpp"
#include "graze/record/names/plane_names.hpp"
#include "graze/record/section.hpp"
#include "graze/record/study_records.hpp"
#include "graze/study/sweep/sweep.hpp"
#include "options/picture.hpp"
#include "options/search.hpp"
#include "options/work.hpp"

namespace graze {

// Of which orbits a diagram shows branches.
enum class DiagramBranches {
  kNone,
  kFound,  // (1, 1), and whatever the sweep settles on
  kAll     // (p, k), all that a search leads to
};
inline constexpr DiagramBranches kDiagramBranches[] = {
    DiagramBranches::kFound, DiagramBranches::kAll, DiagramBranches::kNone};
inline std::string name_of(DiagramBranches branches) {
  if (branches == DiagramBranches::kNone) return "none";
  return branches == DiagramBranches::kFound ? "found" : "all";
}

struct DiagramCommand : BranchingOptions {
  int points = 400;
  SweepDirection direction = SweepDirection::kUp;
  DiagramSection section = DiagramSection::kImpact;
  std::optional<DiagramBranches> branches;
  std::optional<double> duration;  // s of a run where no forcing repeats the motion
  SettlingOptions settling;
  JournalOptions journal;
};

struct MapCommand : LocusTracingOptions {
  int first_points = 100, second_points = 100;
  MapQuantity show = MapQuantity::kAttractor;
  SettlingOptions settling;
  JournalOptions journal;
};

// The values of a sweep and what is reported at each.
void describe_sweep(auto& v, DiagramCommand& o, bool of_sweep) {
  v.heading("Sweep");
  v.option("points", o.points, "N", "Values from A to B, both among them",
           whole_number_within(2, 1'000'000), kOfPieces);
  v.choice(
      "direction", o.direction, kSweepDirections, "HOW",
      "up or down: each value goes on from the one before; fresh: each starts as the scene says",
      kOfPieces.where(of_sweep));
  v.choice("section", o.section, kDiagramSections, "WHAT",
           "What is shown of a motion: impact (phase and speed of every impact) or stroboscopic "
           "(displacement and velocity at the stops once a forcing period)",
           former_section_name(), kOfResult.where(of_sweep));
  describe_settling(v, o.settling, kOfPieces.where(of_sweep));
}

void describe(auto& v, DiagramCommand& o) {
  v.command("diagram",
            "Bifurcation diagram: sweep a parameter, with the branches of orbits over it",
            "diagram data/scenes/05_wagg_one_mode.toml --parameter forcing.frequency \\\n"
            "           --from 15 --to 120");
  // Without forcing there is one run at each value, and none of this.
  const bool of_sweep = !o.duration;
  const Recorded if_all = kOfResult.where(o.branches == DiagramBranches::kAll);
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<DiagramRecord>);
  describe_range(v, o, Excludes{{"duration"}});
  describe_sweep(v, o, of_sweep);
  describe_closure_speed(v, o);
  v.heading("Branches");
  v.choice("branches", o.branches, kDiagramBranches, "WHICH",
           "Branches over the sweep: found, of (1, 1) orbits and of whatever the sweep settles on; "
           "all (p, k) orbits that a search leads to; or none (default: found, with --period or "
           "--impacts all)",
           kOfResult.where(of_sweep));
  describe_period(v, o, "Forcing periods p of the branches' orbits", if_all);
  describe_branch_kind(v, o, if_all.as(static_cast<long long>(o.impacts.value_or(1))),
                       kOfResult.where(of_sweep && o.branches != DiagramBranches::kNone));
  describe_curve(v, o);
  v.heading("Sweep");
  v.option("duration", o.duration, "S",
           "Where no forcing repeats the motion: time of the one run at each value, s",
           above_zero(),
           Excludes{{"direction", "section", "periods", "samples", "branches", "exponents",
                     "period", "impacts", "follow", "depth", "amplitudes", "show", "at"}},
           kOfPieces);
  describe_limits(v, o);
  describe_journal(v, o.journal);
}

void describe_plane(auto& v, MapCommand& o) {
  v.heading("Parameters");
  v.option("parameter", o.parameter, "NAME",
           "Path of the parameter, e.g. forcing.frequency, or initial.q.1, initial.qdot.1, ..",
           kMandatory, kOfPieces);
  v.option("from", o.from, "A", "First value", finite_number(), kMandatory, kOfPieces);
  v.option("to", o.to, "B", "Last value", finite_number(), kMandatory, kOfPieces);
  v.option("points", o.first_points, "N", "Values from A to B, both among them",
           whole_number_within(2, 10'000), kOfPieces);
  v.option("second", o.second, "NAME", "Path of the second parameter, on the vertical axis",
           kMandatory, kOfPieces);
  v.option("second_from", o.second_from, "C", "Its first value", finite_number(), kMandatory,
           kOfPieces);
  v.option("second_to", o.second_to, "D", "Its last value", finite_number(), kMandatory, kOfPieces);
  v.option("second_points", o.second_points, "N", "Values from C to D, both among them",
           whole_number_within(2, 10'000), kOfPieces);
}

void describe_cells(auto& v, MapCommand& o) {
  v.heading("Cells");
  std::vector<std::string> words = names_of(kMapQuantities);
  for (const std::string& word : names_of(kShownQuantities)) words.push_back(word);
  const auto read = [&o](const std::string& word) {
    set_by_name(o.show, kMapQuantities, word);
    set_by_name(o.curve, kShownQuantities, word);
  };
  v.text(
      "show", read, "WHAT",
      "What the picture shows of every cell: what it settles on, or how large that is at a place",
      Choices{words}, Default{name_of(o.show)},
      kOfResult.as(o.curve ? name_of(*o.curve) : name_of(o.show)));
  v.flag("amplitudes", o.amplitudes,
         "Measure the motions of all cells at the probes and stops, as --show amplitude and the "
         "like do",
         kOfPieces.where(o.measures()).as(true));
  v.option("at", o.curve_at, "PLACE", kPlaceShown, Needs{{"show"}},
           kOfResult.where(o.curve.has_value()));
}

void describe(auto& v, MapCommand& o) {
  v.command(
      "map", "What the motion settles on over two parameters, or two coordinates of its start",
      "map data/scenes/05_wagg_one_mode.toml --parameter forcing.frequency \\\n"
      "           --from 15 --to 120 --second stop.gap --second-from 0.5e-3 --second-to 2e-3");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<MapRecord>);
  describe_plane(v, o);
  describe_cells(v, o);
  describe_locus_kinds(v, o,
                       "Draw the loci of special points over the map: LP, PD, NS, GR, CH, several, "
                       "separated by commas, or all",
                       Choices{{"LP", "PD", "NS", "GR", "CH", "all"}});
  describe_slices(v, o, kOfResult);
  const Recorded of_loci = kOfResult.where(!o.locus.empty());
  describe_period(v, o, "With --locus: forcing periods p of the orbits", Needs{{"locus"}}, of_loci);
  v.option("impacts", o.impacts, "K", "With --locus: impacts k of the orbits (default: 1)",
           whole_number_within(1, 64), Needs{{"locus"}},
           of_loci.as(static_cast<long long>(o.impacts.value_or(1))));
  describe_settling(v, o.settling);
  describe_closure_speed(v, o);
  describe_limits(v, o);
  describe_journal(v, o.journal);
}

}  // namespace graze
