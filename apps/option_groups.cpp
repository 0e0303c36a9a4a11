#include "option_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "graze/base/errors.hpp"
#include "graze/record/names/detail/map_names.hpp"
#include "option_values.hpp"

namespace graze {
namespace {

constexpr const char* kClosureSpeed =
    "Speed below which the rest of a chatter is summed, m/s (default: sqrt(solver.tolerance/100) "
    "of the motion's speed; graze check prints it)";

const std::string kExample = "Example: graze ";
const std::string kExitCodes =
    "\nExit codes: 0 done; 2 usage or scene error; 3 numerics could not do it, what was\n"
    "reached is printed; 4 file or system error; 130 interrupted.";

}  // namespace

void order_headings(std::vector<std::string>& headings) {
  const auto rank = [](const std::string& heading) {
    const auto shared = {kSceneGroup, kNumericsGroup, kLongWorkGroup, kOutputGroup, kPicturesGroup};
    const auto at = std::find(shared.begin(), shared.end(), heading);
    return at == shared.end() ? -1 : static_cast<int>(at - shared.begin());
  };
  std::stable_sort(headings.begin(), headings.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
}

void begin_group(CLI::App* app, const char* heading) { app->option_defaults()->group(heading); }

std::string footer(const std::string& example) { return kExample + example + kExitCodes; }

std::string example_in(const std::string& footer) {
  const std::size_t begin = footer.find(kExample);
  return begin == 0 ? footer.substr(kExample.size(), footer.find(kExitCodes) - kExample.size())
                    : "";
}

void add_shared(CLI::App* app, SceneOptions& command) {
  begin_group(app, kSceneGroup);
  app->add_option("SCENE", command.scene, "Scene file (TOML)")->required();
  app->add_option("-s,--set", command.settings,
                  "Replace or add one key of the scene, e.g. stop.gap=2e-3; as often as wanted")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->take_all();
  add_output(app, command);
}

void add_printing(CLI::App* app, CommonOptions& command) {
  begin_group(app, kOutputGroup);
  app->add_flag("-j,--json", command.json, "Print one JSON document and nothing else on stdout");
  app->add_flag("-q,--quiet", command.quiet, "No progress, no warnings");
  app->add_flag_callback(
      "--wide", [&command] { command.text.width = kAnyWidth; },
      fmt::format("Tables and sentences as wide as they are (default: {} characters)",
                  command.text.width));
  app->add_flag("-v,--verbose", command.text.verbose,
                "Also residuals, counts and notes that tell how the numerics went");
}

void add_output(CLI::App* app, CommonOptions& command) {
  add_printing(app, command);
  app->add_option(
         "-o,--out", command.out,
         "Write result.json, scene.toml, record.json (for graze view) and tables into this folder")
      ->type_name("DIR");
  begin_group(app, kNumericsGroup);
  app->add_option("--threads", command.threads,
                  "Threads to use, 0 (default) for all cores; results do not depend on it")
      ->transform(whole_number(
          fmt::format("a whole number from 1 to {:.0f}, or 0 for all cores", kMostThreads), 0.0,
          kMostThreads))
      ->type_name("N");
}

void add_closure_speed(CLI::App* app, MotionOptions& command) {
  begin_group(app, kNumericsGroup);
  app->add_option("--closure-speed", command.closure_speed, kClosureSpeed)
      ->check(at_least("a speed in m/s, 0 or more", 0.0))
      ->type_name("V");
}

void add_limits(CLI::App* app, MotionOptions& command) {
  begin_group(app, kNumericsGroup);
  app->add_option("--max-impacts", command.max_impacts,
                  "Most impacts of one simulated motion; it then ends and says so")
      ->transform(whole_number("a whole number from 1", 1.0, kMostCounted))
      ->capture_default_str()
      ->type_name("N");
  app->add_option("--max-seconds", command.max_seconds,
                  "Most computing time, s; what was reached by then is printed")
      ->check(above_zero())
      ->capture_default_str()
      ->type_name("S");
}

void add_period(CLI::App* app, OrbitSearchOptions& command, const char* what) {
  app->add_option("--period", command.period, what)
      ->transform(whole_number("a whole number from 1", 1.0, kMostPeriods))
      ->each([&command](const std::string&) { command.period_given = true; })
      ->capture_default_str()
      ->type_name("P");
}

void add_orbit_search(CLI::App* app, OrbitSearchOptions& command) {
  add_limits(app, command);
  begin_group(app, "Search for orbits");
  add_period(app, command, "Forcing periods p after which the orbit repeats");
  app->add_flag("--virtual", command.keep_virtual,
                "Keep solutions that are no orbits too: penetrating a stop, or impact speed < 0");
  app->add_option(
         "--start", command.starts,
         "Where the search starts, several with commas: closed-form (k = 1, 2), simulation, random "
         "(quasi-random phases, deflation, then global minimisation) (default: all)")
      ->check(CLI::IsMember({"closed-form", "simulation", "random"}))
      ->delimiter(',')
      ->type_name("NAME");
  app->add_option("--random-seed", command.random_seed,
                  "Seed: another one moves the quasi-random starts")
      ->transform(whole_number("a whole number, 0 or more", 0.0, kMostCounted))
      ->capture_default_str()
      ->type_name("N");
}

void add_range(CLI::App* app, BranchingOptions& command) {
  begin_group(app, "Parameter");
  app->add_option("--parameter", command.parameter, "Path of the parameter, e.g. forcing.frequency")
      ->required()
      ->type_name("NAME");
  app->add_option("--from", command.from, "Start of the parameter's range")
      ->required()
      ->check(finite_number())
      ->type_name("A");
  app->add_option("--to", command.to, "End of the parameter's range")
      ->required()
      ->check(finite_number())
      ->type_name("B");
  app->add_option("--max-step", command.max_step,
                  "Largest change of the parameter in one step of a branch (default: range/50)")
      ->check(above_zero())
      ->type_name("D");
}

void add_following(CLI::App* app, SettlingOptions& options) {
  begin_group(app, "Motions at each value");
  app->add_option("--periods", options.periods,
                  "Forcing periods run at a value, at most (default 1000); fewer once it settled")
      ->transform(whole_number("a whole number from 1", 1.0, kMostCounted))
      ->type_name("K");
  app->add_option("--samples", options.samples, "Forcing periods shown where nothing repeats")
      ->transform(whole_number_within(1, 1'000'000))
      ->capture_default_str()
      ->type_name("M");
}

void add_settling(CLI::App* app, SettlingOptions& options) {
  add_following(app, options);
  app->add_option("--exponents", options.exponents,
                  "Lyapunov exponents at every value: of the multipliers where the motion repeats, "
                  "else averaged over so many forcing periods")
      ->transform(whole_number("a whole number from 1", 1.0, kMostCounted))
      ->type_name("K");
}

void add_sweep(CLI::App* app, DiagramCommand& command) {
  begin_group(app, "Sweep");
  app->add_option("--points", command.points, "Values from A to B, both among them")
      ->transform(whole_number_within(2, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  add_choice(app, "--direction", command.direction, kSweepDirections,
             "up or down: each value goes on from the one before; fresh: each starts as the "
             "scene says")
      ->type_name("HOW");
  app->add_option_function<std::string>(
         "--section", set_by_name(command.section, kDiagramSections),
         "What is shown of a motion: impact (phase and speed of every impact) or "
         "stroboscopic (displacement and velocity at the stops once a forcing period)")
      ->transform(section_name())
      ->default_str(name_of(command.section))
      ->type_name("WHAT");
  add_settling(app, command.settling);
}

void add_plane(CLI::App* app, MapCommand& command) {
  begin_group(app, "Parameters");
  const auto points = [app](const char* name, int& number, const char* what) {
    app->add_option(name, number, what)
        ->transform(whole_number_within(2, 10'000))
        ->capture_default_str()
        ->type_name("N");
  };
  const auto number = [app](const char* name, auto& value, const char* what, const char* type) {
    app->add_option(name, value, what)->required()->check(finite_number())->type_name(type);
  };
  app->add_option(
         "--parameter", command.parameter,
         "Path of the parameter, e.g. forcing.frequency, or initial.q.1, initial.qdot.1, ..")
      ->required()
      ->type_name("NAME");
  number("--from", command.from, "First value", "A");
  number("--to", command.to, "Last value", "B");
  points("--points", command.first_points, "Values from A to B, both among them");
  app->add_option("--second", command.second, "Path of the other one, up the plane")
      ->required()
      ->type_name("NAME");
  number("--second-from", command.second_from, "Its first value", "C");
  number("--second-to", command.second_to, "Its last value", "D");
  points("--second-points", command.second_points, "Values from C to D, both among them");
}

void add_journal(CLI::App* app, JournalOptions& options) {
  begin_group(app, kLongWorkGroup);
  app->add_flag("--resume", options.goes_on,
                "Go on with what an earlier run left in the folder of --out, whatever ended it; "
                "what it finished is not done again");
  app->add_flag("--restart-work", options.restarts,
                "Throw away what unfinished work left in that folder, and begin anew")
      ->excludes("--resume");
  app->add_option_function<std::string>(
         "--shard",
         [&options](const std::string& text) {
           int end = 0;
           Share& share = options.share;
           const bool read =
               std::sscanf(text.c_str(), "%9d/%9d%n", &share.part, &share.of, &end) == 2 &&
               end == static_cast<int>(text.size());
           if (!read || share.part < 1 || share.of < share.part)
             throw InputError(fmt::format(
                 "--shard: '{}' is not allowed; give the share's number and how many there are, "
                 "like 3/8",
                 text));
         },
         "Do one of n shares of the work, for job arrays; graze merge joins them")
      ->type_name("k/n");
}

void add_curve(CLI::App* app, BranchingOptions& command) {
  begin_group(app, "Response curves");
  app->add_flag("--amplitudes", command.amplitudes,
                "Measure the motions: largest, smallest, mean and root mean square values at the "
                "probes and stops, peak velocities, forces; the response without impacts is a "
                "branch too");
  app->add_option_function<std::string>(
         "--show", set_by_name(command.curve, kShownQuantities),
         "With pictures and pages: a response curve in place of impact speeds; implies "
         "--amplitudes")
      ->check(CLI::IsMember(names_of(kShownQuantities)))
      ->type_name("WHAT");
  app->add_option("--at", command.curve_at,
                  "With --show: the place, e.g. probe.1 or stop.2 (default: the first probe, else "
                  "the first stop)")
      ->type_name("PLACE")
      ->needs("--show");
}

void add_map_show(CLI::App* app, MapCommand& command) {
  std::vector<std::string> names = names_of(kMapQuantities);
  for (const std::string& name : names_of(kShownQuantities)) names.push_back(name);
  app->add_option_function<std::string>(
         "--show",
         [&command](const std::string& word) {
           set_by_name(command.show, kMapQuantities)(word);
           set_by_name(command.curve, kShownQuantities)(word);
         },
         "What the picture shows of every cell: what it settles on, or how large that is at a "
         "place")
      ->check(CLI::IsMember(names))
      ->default_str(name_of(command.show))
      ->type_name("WHAT");
  app->add_flag("--amplitudes", command.amplitudes,
                "Measure the motions of all cells at the probes and stops, as --show amplitude and "
                "the like do");
  app->add_option("--at", command.curve_at,
                  "With --show: the place, e.g. probe.1 or stop.2 (default: the first probe, else "
                  "the first stop)")
      ->type_name("PLACE")
      ->needs("--show");
}

void add_impacts(CLI::App* app, OrbitSearchOptions& command, int least, double most,
                 const std::string& what) {
  const auto number =
      whole_number(fmt::format("a whole number from {}{}, or 'any'", least,
                               most < kMostPeriods ? fmt::format(" to {:g}", most) : std::string()),
                   least, most);
  app->add_option_function<std::string>(
         "--impacts",
         [&command](const std::string& text) {
           command.any_impacts = text == "any";
           command.impacts.reset();
           if (!command.any_impacts) command.impacts = std::stoi(text);
         },
         what)
      ->transform(CLI::Validator(
          [number](std::string& text) { return text == "any" ? std::string() : number(text); }, ""))
      ->type_name("K|any");
}

void add_branch_kind(CLI::App* app, BranchingOptions& command) {
  begin_group(app, "Branches");
  add_impacts(app, command, 0, 64,
              "Impacts per orbit, on all stops together; 0: the response that meets no stop, "
              "alone; any: 1, and whatever motions settle on (default: 1, and orbits that stick)");
  app->add_option_function<std::string>(
         "--follow", set_if(command.follows, "all"),
         "Switch branches at special points: none, or all: doubled orbits at PD, crossing "
         "branches at BP, one impact more or less at GR, one stuck phase more or less at "
         "CH (default: none)")
      ->check(CLI::IsMember({"none", "all"}))
      ->type_name("WHAT");
  app->add_option("--depth", command.depth,
                  "With --follow all: special points switched at one after the other (default: 2)")
      ->transform(whole_number_within(1, 16))
      ->type_name("D");
}

}  // namespace graze
