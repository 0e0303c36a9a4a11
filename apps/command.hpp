// What the user asked for, parsed and checked, before anything is done about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/base/default_budget.hpp"
#include "graze/study/sweep/shared_work.hpp"

namespace graze {

struct Command {
  std::string name;   // "check", "simulate", "orbit", "continue", "diagram"
  std::string scene;  // file
  std::vector<std::string> settings;
  std::vector<std::string> arguments;  // all of them, as they were given

  bool json = false;
  bool quiet = false;
  std::string out;   // folder; empty: none
  std::string plot;  // file; empty: none
  int threads = 0;   // 0: all cores

  // simulate
  std::optional<double> duration;  // s
  std::optional<long long> periods;
  std::string record = "events";      // none | events | samples
  std::optional<double> sample_rate;  // 1/s
  bool energy = false;                // keep the energy balance
  // A picture of the motion shows the energy balance.
  bool keeps_balance() const { return energy || (!plot.empty() && run_section.empty()); }
  std::optional<double> closure_speed;  // m/s
  std::string resume;                   // file or folder; empty: from the scene's initial state
  std::string run_section;              // impact | stroboscopic; empty: none
  std::optional<long long> transient;   // forcing periods that it leaves out

  // diagram, map
  bool goes_on = false;  // --resume: with the pieces that are in the folder
  Share share;
  std::optional<std::string> scene_text;  // in place of what the file holds now

  // merge
  std::vector<std::string> folders;

  // orbit, continue
  int period = 1;
  bool period_given = false;  // then no orbit of another one is listed
  std::optional<int> impacts;
  bool keep_virtual = false;
  std::vector<std::string> starts;  // empty: all
  unsigned long long random_seed = 1;

  // continue, diagram
  std::string parameter;
  double from = 0.0, to = 0.0;
  std::optional<double> max_step;
  std::vector<std::string> locus;  // LP, PD, NS, GR, all; empty: branches
  std::string second;
  std::optional<double> second_from, second_to;
  int slices = 8;
  std::string restart, label;   // folder of a run and a special point of it; empty: none
  bool switched = false;        // onto the other branch there
  int regions = 0;              // places each way; 0: none
  std::string follow = "none";  // none | all
  int depth = 2;

  // diagram, with `periods` the most at a value
  int points = 400;
  std::string direction = "up";    // up | down | fresh
  std::string section = "impact";  // impact | stroboscopic
  std::string branches = "all";    // none | all
  long long samples = 100;
  long long exponents = 0;  // forcing periods averaged over; 0: none

  // map, with the two ranges, `periods`, `samples` and `exponents`
  int first_points = 100, second_points = 100;
  std::string show = "attractor";  // attractor | impacts | exponent | speed | stuck

  // fit
  std::string data;                  // file
  std::vector<std::string> sought;   // "NAME=LOW:HIGH"
  std::vector<std::string> columns;  // empty: all
  std::vector<std::string> sigmas;   // "VALUE" or "COLUMN=VALUE"
  std::string algorithm = "local";   // local | global
  long long max_evaluations = 5000;

  // compare, with `parameter`, `from`, `to`, `second`, `second_from`, `second_to`, `show`,
  // `duration`
  std::vector<std::string> against;      // "KEY=VALUE" of the other scene
  int fewest_modes = 0, most_modes = 0;  // of a series; 0: none
  long long first_impacts = 20;
  double within = 0.01;        // of a forcing period, of a speed
  std::optional<double> last;  // s of the end of a run, in a picture
  int second_runs = 21;
  bool sensitivity = false;
  int runs = 21;
  std::vector<double> second_values;
  std::optional<double> reference;

  long long max_impacts = kDefaultImpactBudget;
  double max_seconds = 3600.0;
};

struct ParsedCommand {
  std::optional<Command> command;
  int exit_code = 0;  // where there is no command: 0 after --help and --version, else 2
};

// Parses the command line. Help and version go to stdout, errors to stderr.
ParsedCommand parse_command_line(int argc, char** argv);

}  // namespace graze
