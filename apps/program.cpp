#include "program.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <new>
#include <string>
#include <variant>

#include "graze/base/errors.hpp"
#include "graze/base/stop_scope.hpp"
#include "graze/base/terminal_text.hpp"
#include "session.hpp"

namespace graze {
namespace {

// Seconds on the clock; safe in a signal handler.
long seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<long>(now.tv_sec);
}

std::atomic<long> first_interrupt{0};

extern "C" void on_interrupt(int) {
  // While the scene is read and assembled nothing is finished.
  if (!has_begun) std::_Exit(130);
  // The first asks for what is finished, a later one ends the program at once. One that comes along
  // with the first (a shell or `timeout` may signal both process and group) is the same.
  if (!interrupted.exchange(true))
    first_interrupt = seconds_now();
  else if (seconds_now() > first_interrupt + 1)
    std::_Exit(130);
}

// Without exceptions: stderr may be full or closed.
int complain(const std::string& sentence, int code) {
  std::fputs((terminal_line(sentence) + "\n").c_str(), stderr);
  return code;
}

}  // namespace

int run_command(const Command& parsed) {
  return std::visit(
      [](const auto& command) {
        const StopScope scope(stop_signal(command));
        return run(command);
      },
      parsed);
}

int run_program(int argc, char** argv, const std::function<int(Command&)>& run) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  // The terminal is gone; under nohup that is none of the program's business.
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  // What cannot be written is an error like others, not the end at once.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  return caught(
      [&] {
        ParsedCommand parsed = parse_command_line(argc, argv);
        return parsed.command ? run(*parsed.command) : parsed.exit_code;
      },
      complain);
}

int caught(const std::function<int()>& work,
           const std::function<int(const std::string& sentence, int code)>& on_error) {
  try {
    return work();
  } catch (const InputError& error) {
    return on_error(error.what(), 2);
  } catch (const FileError& error) {
    return on_error(error.what(), 4);
  } catch (const std::bad_alloc&) {
    return on_error("graze: out of memory", 4);
  } catch (const std::exception& error) {
    return on_error(std::string("graze: ") + error.what(), 4);
  }
}

}  // namespace graze
