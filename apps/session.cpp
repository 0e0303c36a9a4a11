#include "session.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>

#include "graze/base/errors.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

void print(const Document& document) {
  const auto check = [](bool good) {
    if (!good) throw FileError("standard output: cannot write the result");
  };
  document.read([&](std::string_view piece) {
    check(std::fwrite(piece.data(), 1, piece.size(), stdout) == piece.size());
  });
  check(std::fflush(stdout) == 0);
}

}  // namespace

Scene scene_of(const Command& command) { return read_scene(command.scene, command.settings); }

void note_call(const Command& command, RunInfo& info) {
  info.arguments = command.arguments;
  info.settings = command.settings;
}

std::atomic<bool> interrupted{false};

StopSignal stop_signal(const Command& command) {
  using Clock = std::chrono::steady_clock;
  StopSignal signal;
  signal.interrupted = &interrupted;
  // Longer than the clock reaches is no limit.
  constexpr double kLongest = 1e9;
  if (command.max_seconds < kLongest)
    signal.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                         std::chrono::duration<double>(command.max_seconds));
  return signal;
}

void prepare_output(const Command& command) {
  if (!command.out.empty()) prepare_folder(command.out);
  if (command.plot.empty()) return;
  const std::filesystem::path folder = std::filesystem::path(command.plot).parent_path();
  check_folder(folder.empty() ? "." : folder);
}

void warn(const Command& command, const std::vector<std::string>& warnings) {
  if (command.quiet) return;
  for (const std::string& warning : warnings)
    std::fputs(fmt::format("warning: {}\n", warning).c_str(), stderr);
}

std::function<void(double)> progress_line(const Command& command) {
  if (command.quiet || ::isatty(STDERR_FILENO) == 0) return {};
  // Ten times a second is as often as a person reads.
  const std::chrono::milliseconds kPause{100};
  struct Line {
    std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
    bool shown = false;
    ~Line() {
      if (shown) std::fputs("\r\033[K", stderr);
    }
  };
  return [line = std::make_shared<Line>(), name = command.name, kPause](double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now - line->last < kPause) return;
    line->last = now;
    line->shown = true;
    std::fputs(fmt::format("\r{} {:3.0f} %", name, 100.0 * fraction).c_str(), stderr);
  };
}

int conclude(const Command& command, const RunInfo& info, const Outcome& outcome, Result result) {
  if (!command.out.empty()) {
    const std::filesystem::path folder = command.out;
    std::vector<PendingFile>& files = result.tables;
    const auto add = [&](const std::string& name, const Document& content) {
      files.emplace_back(folder / name);
      content.read([&](std::string_view piece) { files.back().append(piece); });
    };
    for (const auto& [name, content] : result.files) add(name, content);
    add("scene.toml", info.scene_text);
    add("result.json", result.json);
    // Where one of them does not fit on the disk, none takes its place.
    for (PendingFile& file : files) file.sync();
    for (PendingFile& file : files) file.commit();
  }
  print(command.json ? result.json : Document(result.text));
  if (!command.plot.empty()) result.draw();
  if (outcome.name == "interrupted") return 130;
  return outcome.message.empty() ? 0 : 3;
}

}  // namespace graze
