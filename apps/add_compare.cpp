#include "option_groups.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "graze/base/errors.hpp"
#include "graze/record/names/detail/comparison_names.hpp"
#include "option_values.hpp"

namespace graze {
namespace {

constexpr int kMostComparedModes = 64;

void add_what_is_compared(CLI::App* app, CompareCommand& command) {
  begin_group(app, "Comparison");
  app->add_option("--against", command.against,
                  "The other scene: this one with a key changed, as with --set; as often as wanted")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  app->add_option_function<std::string>(
         "--modes",
         [&command](const std::string& text) {
           int end = 0;
           const bool read = std::sscanf(text.c_str(), "%9d:%9d%n", &command.fewest_modes,
                                         &command.most_modes, &end) == 2 &&
                             end == static_cast<int>(text.size());
           if (!read || command.fewest_modes < 1 || command.most_modes <= command.fewest_modes ||
               command.most_modes > kMostComparedModes)
             throw InputError(
                 fmt::format("--modes: '{}' is not allowed; give the fewest and the most modes, "
                             "like 1:8, at most {}",
                             text, kMostComparedModes));
         },
         "Convergence: each number of modes compared with the next")
      ->type_name("A:B");
  app->add_flag("--sensitivity", command.sensitivity,
                "Largest size (s1) and end value (s2) of every probe over --parameter");
  app->add_option("--first", command.first_impacts, "First impacts that are compared")
      ->transform(whole_number_within(1, 10'000))
      ->capture_default_str()
      ->type_name("K");
  app->add_option("--within", command.within,
                  "First impacts agree while their times differ by no more than this part of a "
                  "forcing period, their speeds of the fastest one's")
      ->check(above_zero())
      ->capture_default_str()
      ->type_name("PART");
}

void add_ranges(CLI::App* app, CompareCommand& command) {
  begin_group(app, "Parameters");
  app->add_option("--parameter", command.parameter, "Path of the parameter, e.g. stop.gap")
      ->type_name("NAME");
  app->add_option("--from", command.from, "Start of the parameter's range")
      ->check(finite_number())
      ->type_name("A");
  app->add_option("--to", command.to, "End of the parameter's range")
      ->check(finite_number())
      ->type_name("B");
  app->add_option("--points", command.points, "Values from A to B, both among them")
      ->transform(whole_number_within(2, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  app->add_option("--second", command.second, "Path of another parameter")->type_name("NAME");
  app->add_option("--second-from", command.second_from, "Start of its range")
      ->check(finite_number())
      ->type_name("C");
  app->add_option("--second-to", command.second_to, "End of its range")
      ->check(finite_number())
      ->type_name("D");
  app->add_option("--second-points", command.second_points, "Values from C to D, both among them")
      ->transform(whole_number_within(2, 10'000))
      ->capture_default_str()
      ->type_name("M");
  add_choice(app, "--show", command.show, kComparedQuantities,
             "What the picture shows of every cell")
      ->type_name("WHAT");
}

void add_of_sensitivity(CLI::App* app, CompareCommand& command) {
  begin_group(app, "Sensitivity");
  app->add_option("--second-values", command.second_values,
                  "With --sensitivity: values of the other parameter, with commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("V1,V2,..");
  app->add_option("--reference", command.reference,
                  "With --sensitivity: value that ends are compared with (default: the middle of "
                  "the range)")
      ->check(finite_number())
      ->type_name("V");
}

// Which options go together.
void relate(CLI::App* app) {
  const auto option = [app](const char* name) { return app->get_option(name); };
  for (const char* end : {"--from", "--to"}) {
    option("--parameter")->needs(option(end));
    option(end)->needs(option("--parameter"));
  }
  for (const char* of_plane : {"--points", "--second", "--show"})
    option(of_plane)->needs(option("--parameter"));
  for (const char* of_second :
       {"--second-from", "--second-to", "--second-points", "--second-values"})
    option(of_second)->needs(option("--second"));
  for (const char* of_sensitivity : {"--second-values", "--reference"})
    option(of_sensitivity)->needs(option("--sensitivity"));
  for (const char* of_others :
       {"--first", "--within", "--second-from", "--second-to", "--second-points", "--show",
        "--last", "--periods", "--samples", "--resume", "--restart-work", "--shard"})
    option("--sensitivity")->excludes(option(of_others));
  option("--last")->excludes(option("--parameter"));
}

}  // namespace

void add_compare(CLI::App& graze, std::optional<Command>& parsed) {
  const auto [app, command] = add_command<CompareCommand>(
      graze, parsed, "compare",
      "Compare motions: with another choice, with more modes, over a parameter");
  app->footer(
      footer("compare data/scenes/01_wagg_2004.toml --against beam.discretisation=galerkin\n"
             "         graze compare data/scenes/02_wagg_momentum.toml --modes 1:8\n"
             "         graze compare data/scenes/20_yigit_sensitivity.toml --sensitivity \\\n"
             "           --duration 0.2 --parameter stop.spring.damping.coefficient --from 0 "
             "--to 1000"));
  add_shared(app, command);
  add_picture(app, command, kFeatures<ComparisonRecord>);
  add_what_is_compared(app, command);
  add_ranges(app, command);
  add_of_sensitivity(app, command);
  begin_group(app, "Motion");
  app->add_option("--duration", command.duration,
                  "Time of a run, s (default: 50 forcing periods, of which --plot shows the end)")
      ->check(above_zero())
      ->type_name("S");
  app->add_option("--last", command.last,
                  "End of the run that --plot shows, s (default: 4 forcing periods)")
      ->check(above_zero())
      ->type_name("S");
  add_following(app, command.settling);
  add_closure_speed(app, command);
  add_limits(app, command);
  add_journal(app, command.journal);
  relate(app);
}

}  // namespace graze
