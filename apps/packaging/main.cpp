// Writes the manual pages, the completions of the shells and docs/commands.md from the tables of
// options that the program has.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "command.hpp"
#include "command_reference.hpp"
#include "completion.hpp"
#include "graze/record/file/run_info.hpp"
#include "man_page.hpp"

namespace {

bool write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) std::fprintf(stderr, "%s: cannot be written\n", file.c_str());
  return bool(stream);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: graze_shell_files FOLDER\n", stderr), 2;
  const std::filesystem::path folder = argv[1];
  const auto commands = graze::CommandReader().descriptions();
  bool good = write(folder / "man" / "graze.1", graze::man_page(commands, graze::version()));
  for (const auto& command : commands)
    good = write(folder / "man" / ("graze-" + command.name + ".1"),
                 graze::man_page(command, graze::version())) &&
           good;
  good = write(folder / "man_mpi" / "graze-mpi.1",
               graze::man_page_of_ranks(commands, graze::version())) &&
         good;
  good = write(folder / "graze.bash", graze::bash_completion(commands)) && good;
  good = write(folder / "_graze", graze::zsh_completion(commands)) && good;
  good = write(folder / "graze.fish", graze::fish_completion(commands)) && good;
  good = write(folder / "commands.md", graze::command_reference(commands)) && good;
  return good ? 0 : 4;
}
