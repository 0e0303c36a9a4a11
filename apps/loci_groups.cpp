// The options of loci and of special points to go on from.
#include "option_groups.hpp"
#include "option_values.hpp"

namespace graze {
namespace {

CLI::Option* add_locus_kinds(CLI::App* app, LocusTracingOptions& command, const char* what) {
  return app->add_option("--locus", command.locus, what)
      ->check(CLI::IsMember({"LP", "PD", "NS", "GR", "CH", "all"}))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("KIND");
}

void add_slices(CLI::App* app, LocusTracingOptions& command, CLI::Option* locus) {
  app->add_option("--slices", command.slices,
                  "With --locus: values of either parameter, besides the scene's own, at which "
                  "special points are sought to start from; a locus that crosses none and meets no "
                  "other is missed")
      ->transform(whole_number_within(0, 10'000))
      ->capture_default_str()
      ->type_name("N")
      ->needs(locus);
}

}  // namespace

void add_loci_over_map(CLI::App* app, MapCommand& command) {
  begin_group(app, "Loci of special points");
  CLI::Option* locus = add_locus_kinds(
      app, command,
      "Draw the loci of special points over the map: LP, PD, NS, GR, CH, several with commas, "
      "or all");
  add_slices(app, command, locus);
  app->add_option("--period", command.period, "With --locus: forcing periods p of the orbits")
      ->transform(whole_number("a whole number from 1", 1.0, kMostPeriods))
      ->capture_default_str()
      ->type_name("P")
      ->needs(locus);
  app->add_option("--impacts", command.impacts,
                  "With --locus: impacts k of the orbits (default: 1)")
      ->transform(whole_number_within(1, 64))
      ->type_name("K")
      ->needs(locus);
}

void add_locus(CLI::App* app, ContinueCommand& command) {
  begin_group(app, "Loci of special points");
  CLI::Option* locus = add_locus_kinds(
      app, command,
      "Trace loci of special points over two parameters instead of branches: LP, PD, NS, GR, "
      "CH, several with commas, or all");
  for (const char* of_branches : {"--amplitudes", "--show", "--at"})
    locus->excludes(app->get_option(of_branches));
  CLI::Option* second = app->add_option("--second", command.second,
                                        "With --locus: path of the second parameter, e.g. stop.gap")
                            ->type_name("NAME")
                            ->needs(locus);
  app->add_option("--second-from", command.second_from, "Start of the second parameter's range")
      ->check(finite_number())
      ->type_name("C")
      ->needs(second);
  app->add_option("--second-to", command.second_to, "End of the second parameter's range")
      ->check(finite_number())
      ->type_name("D")
      ->needs(second);
  add_slices(app, command, locus);
  app->add_option("--regions", command.regions,
                  "With --locus: say what is stable at N by N places of the plane, checked by "
                  "simulation, and draw it behind the loci")
      ->transform(whole_number_within(1, 400))
      ->type_name("N")
      ->needs(locus);
}

void add_restart(CLI::App* app, ContinueCommand& command) {
  begin_group(app, "Restart");
  CLI::Option* restart =
      app->add_option("--restart", command.restart.folder,
                      "Start from a special point of the run that --out left in this folder, in "
                      "the same parameter, another one, or as a locus")
          ->type_name("DIR");
  for (const char* of_search : {"--period", "--impacts", "--start", "--random-seed", "--slices"})
    restart->excludes(app->get_option(of_search));
  app->add_option("--label", command.restart.label,
                  "With --restart: the special point's id, e.g. PD1")
      ->type_name("ID")
      ->needs(restart);
  app->add_flag("--switch", command.restart.switched,
                "With --restart: onto the branch that begins or crosses there: doubled orbits at "
                "PD, the crossing branch at BP, one impact more or less at GR")
      ->needs(restart)
      ->excludes(app->get_option("--locus"));
}

}  // namespace graze
