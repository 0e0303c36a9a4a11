#include "session.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "graze/base/errors.hpp"
#include "graze/base/terminal_text.hpp"
#include "graze/record/file/checksum.hpp"
#include "graze/record/file/spool.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// Updated by one thread at a time; redrawn by a thread of its own, as a piece of work may take
// long.
class ProgressLine {
 public:
  ProgressLine(std::string name, int count, std::string things)
      : name_(std::move(name)),
        count_(count),
        things_(std::move(things)),
        renewing_([this] { renew(); }) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    changed_.notify_one();
    renewing_.join();
    if (shown_) std::fputs("\r\033[K", stderr);
  }

  void show(double fraction) {
    // Ten times a second is as often as a person reads.
    constexpr std::chrono::milliseconds kPause{100};
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    fraction_ = fraction;
    if (now - last_ < kPause) return;
    // What an earlier run left is there at once and says nothing about the speed of this run.
    if (!first_) first_ = fraction, first_time_ = now;
    print(now);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void renew() {
    constexpr std::chrono::seconds kPause{1};
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kPause, [&] { return ended_; }))
      if (const auto now = Clock::now(); now - last_ >= kPause) print(now);
  }

  void print(Clock::time_point now) {
    last_ = now;
    shown_ = true;
    std::string text = fmt::format("\r{} {:3.0f} %", name_, 100.0 * fraction_);
    const double first = first_.value_or(0.0);
    const double seconds = std::chrono::duration<double>(now - first_time_).count();
    if (count_ > 0 && fraction_ > first && seconds > 1.0) {
      const double rate = (fraction_ - first) / seconds;
      text += fmt::format(", {:.3g} {} a second, {} left", rate * count_, things_,
                          duration_text((1.0 - fraction_) / rate));
    } else if (seconds > 1.0) {
      text += fmt::format(", {} so far", duration_text(seconds));
    }
    std::fputs((text + "\033[K").c_str(), stderr);
  }

  static std::string duration_text(double seconds) {
    if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
    if (seconds < 90.0 * 60.0) return fmt::format("{:.0f} min", seconds / 60.0);
    return fmt::format("{:.1f} h", seconds / 3600.0);
  }

  std::string name_;
  int count_;
  std::string things_;
  Clock::time_point last_ = Clock::now(), first_time_ = last_;
  double fraction_ = 0.0;
  std::optional<double> first_;
  bool shown_ = false, ended_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread renewing_;  // the last: it uses the others
};

}  // namespace

Scene scene_of(const SceneOptions& command, const std::vector<std::string>& further) {
  if (command.given)
    return further.empty() ? *command.given
                           : parse_scene(write_scene(*command.given), command.scene, further);
  if (command.scene_text) return parse_scene(*command.scene_text, command.scene, further);
  std::vector<std::string> settings = command.settings;
  settings.insert(settings.end(), further.begin(), further.end());
  return read_scene(command.scene, settings);
}

RunInfo info_of_call(const SceneOptions& command, const Scene& scene) {
  RunInfo info = run_info(command.name, command.scene, scene);
  info.arguments = command.arguments;
  info.settings = command.settings;
  info.folder = command.out;
  return info;
}

std::atomic<bool> interrupted{false}, has_begun{false};

StopSignal stop_signal(const CommonOptions& command) {
  using Clock = std::chrono::steady_clock;
  StopSignal signal;
  signal.interrupted = command.caller ? &command.caller->interrupted() : &interrupted;
  // Longer than the clock reaches is no limit.
  constexpr double kLongest = 1e9;
  if (command.max_seconds < kLongest)
    signal.deadline = command.called + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(command.max_seconds));
  return signal;
}

void prepare_output(const CommonOptions& command) {
  has_begun = true;
  if (!command.out.empty()) prepare_folder(command.out);
  if (command.plot.empty()) return;
  const std::filesystem::path folder = std::filesystem::path(command.plot.file).parent_path();
  check_folder(folder.empty() ? "." : folder);
}

void warn(const CommonOptions& command, const std::vector<std::string>& warnings) {
  if (command.quiet || command.caller) return;
  for (const std::string& warning : warnings)
    std::fputs(fmt::format("warning: {}\n", terminal_line(warning)).c_str(), stderr);
}

std::function<void(double)> progress_line(const CommonOptions& command, int count,
                                          const char* things) {
  if (command.caller)
    return [caller = command.caller](double fraction) { caller->hear_progress(fraction); };
  if (command.quiet || ::isatty(STDERR_FILENO) == 0) return {};
  return [line = std::make_shared<ProgressLine>(command.name, count, things)](double fraction) {
    line->show(fraction);
  };
}

std::string printed_text(const CommonOptions& command, const std::string& text) {
  return fitted_lines(terminal_text(text), command.text);
}

void print(const std::function<void(const TextSink&)>& read) {
  const auto check = [](bool good) {
    if (!good) throw FileError("standard output: cannot write the result");
  };
  read([&](std::string_view piece) {
    check(std::fwrite(piece.data(), 1, piece.size(), stdout) == piece.size());
  });
  check(std::fflush(stdout) == 0);
}

int conclude(const CommonOptions& command, const RunInfo& info, const Outcome& outcome,
             Result result) {
  const bool writes = !command.out.empty();
  const Document document = writes || command.json ? result.json() : Document();
  if (writes) {
    const std::filesystem::path folder = command.out;
    std::vector<PendingFile>& files = result.tables;
    Checksum sum;  // of what was added last
    const auto add = [&](const std::string& name, const Document& content) {
      sum = {};
      files.emplace_back(folder / name);
      content.read([&](std::string_view piece) {
        sum.add(piece);
        files.back().append(piece);
      });
    };
    for (const NamedTable& table :
         result.record_tables ? result.record_tables() : std::vector<NamedTable>()) {
      files.emplace_back(folder / (table.name + ".csv"));
      table.make().write_csv([&](std::string_view piece) { files.back().append(piece); });
    }
    if (result.files)
      for (const auto& [name, content] : result.files()) add(name, content);
    add(kSceneFile, info.scene_text);
    add(kDocumentFile, document);
    if (result.record) add(kRecordFile, result.record(sum.text()));
    // Where one of them does not fit on the disk, none takes its place.
    for (PendingFile& file : files) file.sync();
    for (PendingFile& file : files) file.commit();
  }
  if (!command.caller) {
    const Document printed =
        command.json ? document : Document(printed_text(command, result.text(command.text)));
    print([&](const TextSink& sink) { printed.read(sink); });
  }
  if (!command.plot.empty() && result.draw) result.draw();
  if (outcome.name == "interrupted") return 130;
  return outcome.message.empty() ? 0 : 3;
}

}  // namespace graze
