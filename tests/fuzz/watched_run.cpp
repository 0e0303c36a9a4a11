#include "fuzz/watched_run.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace graze {
namespace {

using Clock = std::chrono::steady_clock;

std::string beginning_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(1 << 20, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

pid_t start(const std::vector<std::string>& arguments, const std::string& folder,
            const std::string& out, const std::string& err, bool limits_memory) {
  // 6 GiB of addresses, files of 256 MiB.
  const std::string limits =
      std::string(limits_memory ? "ulimit -v 6291456; " : "") + "ulimit -f 524288; ulimit -c 0; ";
  const std::string script = limits + "cd \"$0\" && exec \"$@\"";
  std::vector<std::string> words{"sh", "-c", script, folder};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), kNew, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), kNew, 0600);
  pid_t child = -1;
  const int error = ::posix_spawn(&child, "/bin/sh", &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("the program cannot be started");
  return child;
}

// Whether a signal would end the child in its own way: it has come as far as that.
bool catches_termination(pid_t child) {
  std::ifstream status("/proc/" + std::to_string(child) + "/status");
  for (std::string word; status >> word;) {
    if (word != "SigCgt:") continue;
    status >> word;
    return (std::stoull(word, nullptr, 16) >> (SIGTERM - 1) & 1U) != 0;
  }
  return false;
}

// s of processor time of a child that runs.
double busy_time(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(child, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Whether the child ended by then; `usage` is then what it used.
bool ends_by(pid_t child, Clock::time_point latest, int& status, rusage& usage) {
  while (::wait4(child, &status, WNOHANG, &usage) != child) {
    if (Clock::now() >= latest) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace

WatchedRun watched_run(const std::vector<std::string>& arguments, const std::string& folder,
                       const RunLimits& limits) {
  const std::string out = folder + "/stdout", err = folder + "/stderr";
  WatchedRun run;
  int status = 0;
  rusage usage{};
  const pid_t child = start(arguments, folder, out, err, limits.memory);
  // On a machine that is busy it may not have begun by then.
  const Clock::time_point begun = Clock::now(), latest = begun + limits.patience + limits.bound;
  bool ended = ends_by(child, begun + limits.patience, status, usage);
  while (!ended && !catches_termination(child) && Clock::now() < latest)
    ended = ends_by(child, Clock::now() + std::chrono::milliseconds(10), status, usage);
  double before = 0.0;
  if (!ended) {
    run.asked = true;
    before = busy_time(child);
    const Clock::time_point asked = Clock::now();
    ::kill(child, SIGTERM);
    if (!ends_by(child, asked + limits.bound, status, usage)) {
      run.killed = true;
      ::kill(child, SIGKILL);
      ::wait4(child, &status, 0, &usage);
    }
    run.ending = std::chrono::duration<double>(Clock::now() - asked).count();
  }
  run.busy = seconds(usage.ru_utime) + seconds(usage.ru_stime) - before;
  if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
  if (WIFEXITED(status)) run.code = WEXITSTATUS(status);
  run.out = beginning_of(out);
  run.err = beginning_of(err);
  return run;
}

}  // namespace graze
