#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "command.hpp"
#include "graze/base/errors.hpp"
#include "session.hpp"

namespace {

extern "C" void on_interrupt(int) {
  // A second Ctrl-C ends the program at once.
  if (graze::interrupted.exchange(true)) std::_Exit(130);
}

// Without exceptions: stderr may be full or closed.
int complain(const std::string& sentence, int code) {
  std::fputs((sentence + "\n").c_str(), stderr);
  return code;
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
    return complain(error.what(), 2);
  } catch (const graze::FileError& error) {
    return complain(error.what(), 4);
  } catch (const std::bad_alloc&) {
    return complain("graze: out of memory", 4);
  } catch (const std::exception& error) {
    return complain(std::string("graze: ") + error.what(), 4);
  }
}
