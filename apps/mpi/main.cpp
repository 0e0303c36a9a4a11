// graze-mpi: the program as one rank of an MPI job. The first rank is the program; the others do
// blocks of its work and print and write nothing.
#include <fmt/format.h>
#include <mpi.h>

#include <cstdio>
#include <type_traits>
#include <variant>

#include "graze/base/errors.hpp"
#include "graze/study/ranks/first_rank.hpp"
#include "graze/study/ranks/other_rank.hpp"
#include "mpi_messages.hpp"
#include "program.hpp"
#include "session.hpp"

namespace graze {
namespace {

// Whether ranks have something to share in it.
template <class Any>
bool has_blocks(const Any& command) {
  if constexpr (std::is_same_v<Any, CompareCommand>)
    return !command.parameter.empty() && !command.sensitivity;
  else
    return requires { command.journal; };
}

// Sets who does the command's blocks, and what that means for its options.
void set_workers(Command& parsed, BlockWorkers& workers, int ranks) {
  std::visit(
      [&](auto& command) {
        if (ranks > 1 && !has_blocks(command))
          throw InputError(
              fmt::format("{}: it has no blocks for {} ranks to share, as diagram, map and compare "
                          "with --parameter have; run it with one",
                          command.name, ranks));
        // There is a rank for every core, unless the user says otherwise.
        if (command.threads == 0) command.threads = 1;
        if constexpr (requires { command.journal; }) {
          command.journal.workers = &workers;
          command.journal.program = fmt::format("mpirun -n {} graze-mpi", ranks);
        }
      },
      parsed);
}

// Makes a rank neither print nor keep anything: the first one does.
void silence(Command& parsed) {
  std::visit(
      [](auto& command) {
        command.json = false, command.quiet = true;
        command.out.clear();
        command.plot = {};
        if constexpr (requires { command.journal; })
          command.journal.goes_on = false, command.journal.share = {};
      },
      parsed);
}

int run_first(int argc, char** argv, MpiMessages& messages) {
  FirstRank workers(messages, interrupted);
  const int code = run_program(argc, argv, [&](Command& command) {
    set_workers(command, workers, messages.ranks());
    const int done = run_command(command);
    const std::size_t kinds = workers.processors().size();
    if (kinds > 1)
      std::visit(
          [&](const auto& common) {
            warn(common, {fmt::format("the ranks ran on {} kinds of processors; last digits may "
                                      "differ from those of a run on one kind",
                                      kinds)});
          },
          command);
    return done;
  });
  workers.close();
  return code;
}

void run_other(int argc, char** argv, MpiMessages& messages) {
  // The first rank reports errors of usage.
  for (std::FILE* stream : {stdout, stderr})
    if (!std::freopen("/dev/null", "w", stream)) std::fclose(stream);
  OtherRank workers(messages, interrupted);
  run_program(argc, argv, [&](Command& command) {
    return caught(
        [&] {
          set_workers(command, workers, messages.ranks());
          silence(command);
          return run_command(command);
        },
        [&](const std::string& sentence, int code) {
          workers.fail(sentence, code);
          return code;
        });
  });
  workers.close();
}

}  // namespace
}  // namespace graze

int main(int argc, char** argv) {
  int threads = MPI_THREAD_SINGLE;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &threads);
  int code = 0;
  {
    graze::MpiMessages messages;
    if (threads < MPI_THREAD_SERIALIZED) {
      if (messages.rank() == 0)
        std::fputs("graze-mpi: this MPI lets no second thread call it; it needs one that does\n",
                   stderr);
      code = 4;
    } else if (messages.rank() == 0) {
      code = graze::run_first(argc, argv, messages);
    } else {
      graze::run_other(argc, argv, messages);
    }
  }
  MPI_Finalize();
  return code;
}
