#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "command.hpp"
#include "graze/base/errors.hpp"
#include "session.hpp"

namespace {

extern "C" void on_interrupt(int) {
  // A second Ctrl-C ends the program at once.
  if (graze::interrupted.exchange(true)) std::_Exit(130);
}

int run(const graze::Command& command) {
  if (command.name == "check") return graze::run_check(command);
  if (command.name == "simulate") return graze::run_simulate(command);
  if (command.name == "orbit") return graze::run_orbit(command);
  return graze::run_continue(command);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const graze::ParsedCommand parsed = graze::parse_command_line(argc, argv);
    return parsed.command ? run(*parsed.command) : parsed.exit_code;
  } catch (const graze::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  } catch (const graze::FileError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 4;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "graze: out of memory\n");
    return 4;
  } catch (const std::exception& error) {
    fmt::print(stderr, "graze: {}\n", error.what());
    return 4;
  }
}
