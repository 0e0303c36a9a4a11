// The commands that find periodic orbits and trace their branches: orbit, continue.
#pragma once

#include <string>

#include "graze/record/record_names.hpp"
#include "options/picture.hpp"
#include "options/search.hpp"

namespace graze {

struct OrbitCommand : OrbitSearchOptions {};

struct ContinueCommand : LocusTracingOptions, LevelOptions {
  int regions = 0;  // places each way; 0: none
  bool normal_forms = false;
  RestartOptions restart;
};

void describe(auto& v, OrbitCommand& o) {
  v.command("orbit", "Find periodic orbits, stable or not",
            "orbit data/scenes/05_wagg_one_mode.toml --set forcing.frequency=40");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<OrbitRecord>);
  describe_search(v, o);
  describe_closure_speed(v, o);
  v.heading("Search for orbits");
  const bool any = o.any_impacts || !o.impacts;
  describe_impacts(v, o, 0, kMostPeriods,
                   "Impacts k per orbit, on every sequence of stops; 0: orbits that meet no stop; "
                   "'any' (default): 1, then 2 "
                   "and 3 while the structure is small, and what the simulation settles on",
                   kOfResult.as(any ? "any" : std::to_string(*o.impacts)));
}

void describe(auto& v, ContinueCommand& o) {
  v.command("continue", "Trace branches of orbits over a parameter of the scene",
            "continue data/scenes/05_wagg_one_mode.toml --parameter forcing.frequency \\\n"
            "           --from 15 --to 120");
  describe_scene(v, o);
  describe(v, o.plot, kFeatures<BranchRecord>);
  describe_range(v, o);
  const Recorded recorded = kOfResult.where(!o.restart.is_given());
  describe_search(v, o, recorded);
  describe_branch_kind(
      v, o, recorded.as(o.any_impacts ? "any" : std::to_string(o.impacts.value_or(1))), kOfResult);
  describe_curve(v, o);
  describe_levels(v, o);
  v.flag(
      "normal_forms", o.normal_forms,
      "Compute the normal forms of folds (LP), doublings (PD) and tori (NS), and say on which side "
      "the orbits beside them exist and whether they are stable; with --locus mark where those of "
      "PD and NS vanish (GPD, GNS)",
      kOfResult.where(o.normal_forms));
  describe_closure_speed(v, o);
  describe_locus_kinds(
      v, o,
      "Trace loci of special points over two parameters instead of branches: LP, PD, NS, GR, CH, "
      "UZ and EX (levels), several, separated by commas, or all but those",
      Choices{{"LP", "PD", "NS", "GR", "CH", "UZ", "EX", "all"}},
      Excludes{{"amplitudes", "show", "at"}});
  v.option("second", o.second, "NAME", "With --locus: path of the second parameter, e.g. stop.gap",
           Needs{{"locus"}}, kOfResult);
  v.option("second_from", o.second_from, "C", "Start of the second parameter's range",
           finite_number(), Needs{{"second"}}, kOfResult);
  v.option("second_to", o.second_to, "D", "End of the second parameter's range", finite_number(),
           Needs{{"second"}}, kOfResult);
  describe_slices(v, o, kOfResult.where(!o.restart.is_given()));
  v.option("regions", o.regions, "N",
           "With --locus: say what is stable at N by N places of the plane, checked by simulation, "
           "and draw it behind the loci",
           whole_number_within(1, 400), kNoDefault, Needs{{"locus"}},
           kOfResult.where(o.regions > 0));
  describe_restart(v, o.restart);
}

}  // namespace graze
