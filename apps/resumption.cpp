#include "resumption.hpp"

#include <fmt/format.h>

#include <limits>

#include "graze/base/errors.hpp"
#include "graze/record/stored/record_file.hpp"
#include "graze/report/text/shell_word.hpp"
#include "run_folder.hpp"

namespace graze {

CutRun read_cut_run(const SimulateCommand& command, const RunInfo& info) {
  const StoredResult before = read_result(command.resume);
  const std::string folder = before.folder.string();
  refuse_own_folder(command, before.folder, "--resume");
  const auto* run = std::get_if<SimulationRecord>(&before.record);
  if (!run) throw InputError(fmt::format("--resume: {} holds no run of graze simulate", folder));
  if (run->info.scene_sha256 != info.scene_sha256)
    throw InputError(
        fmt::format("--resume: the run in {} is of another scene; go on with the scene that was "
                    "simulated, with the same --set (it is {})",
                    folder, (before.folder / kSceneFile).string()));
  if (run->outcome.name == "refused")
    throw InputError(fmt::format(
        "--resume: the run in {} ended on a stop on which it cannot be followed, it cannot go on",
        folder));
  if (run->outcome.name == "not_finite")
    throw InputError(fmt::format(
        "--resume: the motion in {} left the range of double precision, it cannot go on", folder));
  CutRun cut{run->run.end_time, {}, run->run.state};
  for (const auto& [name, value] : run->info.options)
    if (name == "sample_rate") cut.sample_rate = std::get<double>(value);
  return cut;
}

void check_end(const CutRun& cut, const SimulationOptions& options, const System& system) {
  const double end =
      options.duration ? *options.duration : static_cast<double>(options.periods) * system.first_period();
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * cut.time;
  if (end < cut.time - rounding)
    throw InputError(
        fmt::format("{}: the end, t = {:.9g} s, lies before t = {:.9g} s, to which the "
                    "run went already; both count from t = 0",
                    options.duration ? "--duration" : "--periods", end, cut.time));
}

void tell_how_to_go_on(const SimulateCommand& command, RunOutcome ended, Outcome& outcome) {
  const bool stopped = ended == RunOutcome::kInterrupted || ended == RunOutcome::kTimeBudget;
  if (!stopped || command.out.empty() || command.caller) return;
  std::vector<std::string> words = words_without(command.arguments, {"--resume", "--out"});
  for (const char* option : {"--resume", "--out"}) {
    words.emplace_back(option);
    words.push_back(command.out);
  }
  // The tables of a run are those of its folder.
  words.back().erase(words.back().find_last_not_of('/') + 1);
  words.back() += "-on";
  outcome.message += "; to go on: " + shell_command(words);
}

void place_samples(CutRun& cut, double rate, long long stride) {
  long long& samples = cut.state.samples;
  if (cut.sample_rate != rate)
    samples = samples_before(cut.time, rate * static_cast<double>(stride));
  else if (samples > 0)
    samples = (samples - 1) * stride + 1;
}

}  // namespace graze
