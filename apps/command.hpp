// What the user asked for, parsed and checked, before anything is done about it: one struct a
// command, made of what it has in common with others and of its own.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "graze/base/default_budget.hpp"
#include "graze/record/detail/study_records.hpp"
#include "graze/record/run_picture.hpp"
#include "graze/record/section.hpp"
#include "graze/report/picture/picture_request.hpp"
#include "graze/report/text/text.hpp"
#include "graze/study/sweep/shared_work.hpp"
#include "graze/study/sweep/sweep.hpp"

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

// A parameter and its range.
struct RangeOptions {
  std::string parameter;
  double from = 0.0, to = 0.0;
};

// The same of a second one; nothing where there is none.
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

// How long motions are followed until they settle.
struct SettlingOptions {
  std::optional<long long> periods;  // the most at a value
  long long samples = 100;
  long long exponents = 0;  // forcing periods averaged over; 0: none
};

// Work in pieces that a folder keeps.
struct JournalOptions {
  bool goes_on = false;   // --resume: with the pieces that are in the folder
  bool restarts = false;  // --restart-work: they may be thrown away
  Share share;
  BlockWorkers* workers = &own_threads();  // who does them; not null
  std::string program = "graze";           // that goes on with it, as a shell has it
  std::vector<std::string> arguments{};    // and its own, where the command's are not
};

// A special point of an earlier run to go on from.
struct RestartOptions {
  std::string folder, label;  // empty: none
  bool switched = false;      // onto the other branch there
};

struct CheckCommand : SceneOptions {  // a picture shows the mode shapes
  bool parameters = false;            // list them and nothing else
};

struct ModesCommand : SceneOptions {
  std::string mac;  // a scene, or a file of shapes; empty: none
};

struct SimulateCommand : MotionOptions {
  std::optional<double> duration;  // s
  std::optional<long long> periods;
  std::string record = "events";      // none | events | samples
  std::optional<double> sample_rate;  // 1/s
  std::string sample_format = "csv";  // csv | npz
  bool energy = false;                // keep the energy balance
  // A picture of the motion shows the energy balance.
  bool keeps_balance() const { return energy || (!plot.empty() && !section); }
  bool amplitudes = false;                // measure the motion
  std::optional<double> amplitudes_from;  // s
  std::optional<int> force_windows;       // over which the forces of stops are averaged
  std::string resume;                     // file or folder; empty: from the scene's initial state
  std::optional<DiagramSection> section;
  std::optional<long long> transient;  // forcing periods that it leaves out
  RunPicture show = RunPicture::kMotion;
  std::vector<double> shape_times;  // s, of the shapes shown
};

struct OrbitCommand : OrbitSearchOptions {};

struct ContinueCommand : LocusTracingOptions {
  int regions = 0;  // places each way; 0: none
  RestartOptions restart;
};

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

struct MergeCommand : CommonOptions {
  std::vector<std::string> folders;
};

struct ViewCommand : CommonOptions {
  std::string result;    // folder, or the document in it
  std::string show, at;  // what a picture shows, in the words of the command; empty: as before
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
};

// A scene to begin with.
struct InitCommand : CommonOptions {
  std::string kind = "beam";  // beam | oscillator | matrices | hub
  std::string file;           // empty: onto stdout
};

using Command = std::variant<InitCommand, CheckCommand, ModesCommand, SimulateCommand, OrbitCommand,
                             ContinueCommand, DiagramCommand, MapCommand, MergeCommand, ViewCommand,
                             CostCommand, FitCommand, CompareCommand>;

struct ParsedCommand {
  std::optional<Command> command;
  int exit_code = 0;  // where there is no command: 0 after --help and --version, else 2
};

// Parses the command line. Help and version go to stdout, errors to stderr.
ParsedCommand parse_command_line(int argc, char** argv);

// Reads commands, one after the other.
class CommandReader {
 public:
  CommandReader();
  ~CommandReader();
  CommandReader(const CommandReader&) = delete;
  CommandReader& operator=(const CommandReader&) = delete;

  // Of the words after the program's name. Throws InputError with the sentence of the program.
  Command read(const std::vector<std::string>& words);
  // An option, or a file among the words of a command.
  struct Option {
    std::string name;           // without its dashes, "max-seconds"
    std::string what;           // what it says of itself
    std::string default_value;  // that it prints, if any
    bool is_flag = false, takes_several = false;
    std::string short_name;            // one letter; empty: none
    std::string placeholder;           // "DIR", of what has a value
    std::vector<std::string> choices;  // empty: any value
    std::string heading;               // of --help
    std::string help;                  // what --help prints of it, in one line
    bool is_required = false;
  };
  // The options of a command. Empty for an unknown one.
  std::vector<Option> options(const std::string& command) const;

  struct Description {
    std::string name, what, example;
    std::vector<Option> files, options;
  };
  // Of all commands, in the order of --help.
  std::vector<Description> descriptions() const;

 private:
  friend ParsedCommand parse_command_line(int argc, char** argv);
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace graze
