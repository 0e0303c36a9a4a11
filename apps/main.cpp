#include "program.hpp"

int main(int argc, char** argv) {
  return graze::run_program(argc, argv,
                            [](graze::Command& command) { return graze::run_command(command); });
}
