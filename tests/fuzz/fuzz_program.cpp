// The program against scenes, options and journals that are nearly right.
//
//   fuzz_program PROGRAM DATA FOLDER SEED SECONDS [CASE]
//
// Case after case for so many seconds, each drawn from SEED and its number: a scene of DATA/scenes,
// damaged as a rule, a command with options of its --help, and folders of earlier runs, damaged
// too; now and then an extreme scene (extreme_scenes.hpp) whose time is bounded. With CASE that one
// alone, whose folder is kept as those of failed ones. Held of every run:
//   - no signal ends it, and no sanitizer reports anything;
//   - its exit code is one of the contract's, and 130 only where it was sent SIGTERM;
//   - sent SIGTERM it ends: within 1 s where nothing else runs, 10 s are allowed; on extreme
//   scenes,
//     and there after its --max-seconds too, within kTooLate of processor time on one thread;
//   - exit code 2 leaves stdout empty; with --json there is one document on it or nothing;
//   - stderr holds no control characters.
// Failed cases are kept as FOLDER/failed_CASE, with the command as command.txt; exit 1 if there
// are.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "fuzz/command_lines.hpp"
#include "fuzz/damage.hpp"
#include "fuzz/extreme_scenes.hpp"
#include "fuzz/materials.hpp"
#include "fuzz/watched_run.hpp"

namespace graze {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// s, from SIGTERM to the end; what takes longer is told, but no fault: machines are busy.
constexpr double kLate = 1.0;
// s of processor time likewise, that is a fault: the longest piece that nothing ends, a decomposition
// of 200 modes (decision 55), and the grace take three quarters of a second; machines differ by two.
constexpr double kTooLate = 2.0;

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0x7F || (byte < 0x20 && byte != '\n' && byte != '\t');
  });
}

// What is wrong with a run; empty where nothing is.
std::string fault_of(const WatchedRun& run, const std::vector<std::string>& words) {
  if (run.killed) return "it did not end when asked";
  if (run.signal != 0) return "signal " + std::to_string(run.signal);
  for (const char* word : {"Sanitizer", "runtime error:", "terminate called", "Assertion"})
    if (run.err.find(word) != std::string::npos) return std::string("stderr says ") + word;
  const bool known = run.code == 0 || (run.code >= 2 && run.code <= 4) || run.code == 130;
  if (!known || (run.code == 130 && !run.asked)) return "exit code " + std::to_string(run.code);
  if (run.code == 2 && !run.out.empty()) return "exit code 2, and something on stdout";
  if (has_control_characters(run.err)) return "control characters on stderr";
  const bool is_whole = run.out.size() < (1U << 20);
  const bool helps = has(words, "--help") || has(words, "-h");
  if (has(words, "--json") && !helps && is_whole && !run.out.empty() &&
      !nlohmann::json::accept(run.out))
    return "what is on stdout is no JSON";
  return "";
}

// Of a command on an extreme scene: SIGTERM and --max-seconds are obeyed at once. Processor time,
// for machines are busy.
std::string lateness_of(const WatchedRun& run, double max_seconds) {
  const bool overslept = run.asked && max_seconds < kLate;
  const double late = run.busy - (run.asked ? 0.0 : max_seconds);
  if (overslept) return "--max-seconds passed without an end";
  if (late <= kTooLate) return "";
  char text[80];
  std::snprintf(text, sizeof text, "%.2f s of work %s", late,
                run.asked ? "after SIGTERM" : "after --max-seconds");
  return text;
}

struct ProgressCounter {
  std::mutex mutex;
  long cases = 0, failed = 0, asked = 0;
  double slowest = 0.0;  // s, from SIGTERM to the end
  long slowest_case = -1;
  std::map<int, long> codes;  // cases that ended so
};

class Fuzz {
 public:
  Fuzz(const std::string& program, const fs::path& data, const fs::path& folder, std::uint64_t seed)
      : program_(program), folder_(folder), seed_(seed), lines_(program) {
    fs::remove_all(folder / "materials");
    fs::create_directories(folder / "materials");
    materials_ = prepared_materials(program, data, folder / "materials");
#ifdef GRAZE_SANITIZED
    limits_.memory = false;
    limits_.bound *= 3;
#endif
  }

  void run_case(long number) {
    Draw draw(seed_ * 1000003U + static_cast<std::uint64_t>(number));
    const fs::path folder = folder_ / ("case_" + std::to_string(number));
    fs::remove_all(folder);
    fs::create_directories(folder);
    if (draw.once_in(4)) return run_extreme(number, folder, draw);
    const Materials materials = damaged_copy(materials_, folder, draw);
    const std::string scene = (folder / "scene.toml").string();
    const std::string text = text_of(draw.of(materials.scenes));
    std::ofstream(scene, std::ios::binary) << changed(text, draw);
    std::vector<std::string> words =
        lines_.drawn(draw.of(lines_.commands()), scene, folder.string(), materials, draw);
    words.insert(words.begin(), program_);
    RunLimits limits = limits_;
    if (draw.once_in(10)) limits.patience *= 8;  // what comes later is to be left as well
    const WatchedRun run = watched_run(words, folder.string(), limits);
    note(number, run, fault_of(run, words), words, folder);
  }

  void run_extreme(long number, const fs::path& folder, Draw& draw) {
    const std::string scene = (folder / "scene.toml").string();
    std::ofstream(scene, std::ios::binary) << extreme_scene(draw);
    std::vector<std::string> words = extreme_command(scene, draw);
    words.insert(words.begin(), program_);
    words.insert(words.end(), {"--threads", "1"});
    RunLimits limits = limits_;
    const double max_seconds = draw.once_in(2) ? 0.2 : 3600.0;
    if (max_seconds < 1.0) {
      words.insert(words.end(), {"--max-seconds", "0.2"});
      limits.patience = std::chrono::seconds(10);
    }
    const WatchedRun run = watched_run(words, folder.string(), limits);
    std::string fault = fault_of(run, words);
    if (fault.empty() && limits_.memory) fault = lateness_of(run, max_seconds);
    note(number, run, fault, words, folder);
  }

  void keep_all() { keeps_all_ = true; }
  ProgressCounter& counter() { return tally_; }

 private:
  static std::string changed(const std::string& text, Draw& draw) {
    const std::size_t what = draw.below(8);
    return what < 3 ? text : what < 6 ? stretched(text, draw) : damaged(text, draw);
  }

  void note(long number, const WatchedRun& run, const std::string& fault,
            const std::vector<std::string>& words, const fs::path& folder) {
    const std::lock_guard lock(tally_.mutex);
    ++tally_.cases;
    ++tally_.codes[run.code];
    tally_.asked += run.asked ? 1 : 0;
    if (run.ending > tally_.slowest) {
      tally_.slowest = run.ending;
      tally_.slowest_case = number;
    }
    if (run.ending > kLate)
      std::printf("case %ld: %s, %.2f s after SIGTERM\n", number, words[1].c_str(), run.ending);
    if (fault.empty() && !keeps_all_) {
      fs::remove_all(folder);
      return;
    }
    tally_.failed += fault.empty() ? 0 : 1;
    std::ofstream command(folder / "command.txt");
    for (const std::string& word : words) command << "'" << word << "' ";
    std::printf("case %ld: %s, %s (%s)\n", number, words[1].c_str(), fault.c_str(),
                (folder_ / ("failed_" + std::to_string(number))).c_str());
    std::fflush(stdout);
    fs::remove_all(folder_ / ("failed_" + std::to_string(number)));
    fs::rename(folder, folder_ / ("failed_" + std::to_string(number)));
  }

  std::string program_;
  fs::path folder_;
  std::uint64_t seed_;
  CommandLines lines_;
  Materials materials_;
  RunLimits limits_;
  bool keeps_all_ = false;
  ProgressCounter tally_;
};

void run_for(Fuzz& fuzz, double seconds) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(seconds));
  std::atomic<long> next{0};
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back([&] {
      while (Clock::now() < end) fuzz.run_case(next++);
    });
  for (std::thread& worker : workers) worker.join();
}

int run(const std::vector<std::string>& arguments) {
  Fuzz fuzz(arguments[0], arguments[1], arguments[2], std::stoull(arguments[3]));
  if (arguments.size() > 5) {
    fuzz.keep_all();
    fuzz.run_case(std::stol(arguments[5]));
  } else {
    run_for(fuzz, std::stod(arguments[4]));
  }
  const ProgressCounter& counter = fuzz.counter();
  std::printf(
      "seed %s: %ld cases, %ld failed; %ld were sent SIGTERM, the slowest, %ld, ended %.2f s "
      "later\n",
      arguments[3].c_str(), counter.cases, counter.failed, counter.asked, counter.slowest_case,
      counter.slowest);
  for (const auto& [code, cases] : counter.codes) std::printf("  exit code %d: %ld\n", code, cases);
  return counter.failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace graze

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 5 && arguments.size() != 6) {
    std::fputs("usage: fuzz_program PROGRAM DATA FOLDER SEED SECONDS [CASE]\n", stderr);
    return 2;
  }
  try {
    return graze::run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz_program: %s\n", error.what());
    return 2;
  }
}
