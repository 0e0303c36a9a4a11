// What a shell is told: help, version, scenes to begin with, short options, sentences about the
// usage.
#include <gtest/gtest.h>

#include "apps/program.hpp"

namespace graze {
namespace {

std::vector<std::string> listed_commands() {
  std::vector<std::string> names;
  std::istringstream lines(run_graze("help").out);
  bool below = false;
  for (std::string line; std::getline(lines, line);) {
    if (below && line.substr(0, 2) == "  " && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    below = (below && !line.empty()) || line == "Subcommands:";
  }
  return names;
}

TEST(Shell, HelpOfACommandIsWhatItsOptionPrints) {
  EXPECT_EQ(run_graze("help").out, run_graze("--help").out);
  const std::vector<std::string> names = listed_commands();
  EXPECT_GT(names.size(), 13u);
  for (const std::string& name : names) {
    const Finished help = run_graze("help " + name);
    EXPECT_EQ(help.code, 0) << name;
    EXPECT_EQ(help.err, "") << name;
    EXPECT_NE(help.out.find("Usage: graze " + name), std::string::npos) << help.out;
    EXPECT_EQ(help.out, run_graze(name + " --help").out);
  }
  const Finished none = run_graze("help chek");
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.out, "");
  EXPECT_EQ(none.err, "graze: 'chek' is no command; did you mean 'check'?\n");
}

TEST(Shell, VersionIsAWordToo) {
  EXPECT_EQ(run_graze("version").out, run_graze("--version").out);
  EXPECT_EQ(run_graze("version").code, 0);
}

TEST(Shell, WhatCannotBePrintedExitsWith4) {
  for (const char* words : {"help", "version", "init"}) {
    const std::string line = std::string(GRAZE_PROGRAM) + " " + words + " >/dev/full 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 4) << words;
  }
}

// Every scene is whole: it passes the check, and the listed_commands it names run.
TEST(Shell, InitWritesScenesThatPassTheCheck) {
  for (const std::string kind : {"beam", "lumped", "oscillator", "matrices", "hub"}) {
    const ScratchFolder scratch;
    const std::string file = (scratch / "scene.toml").string();
    const Finished written = run_graze("init " + kind + " " + file);
    EXPECT_EQ(written.code, 0) << written.err;
    EXPECT_EQ(written.out, "");
    EXPECT_EQ(read_text(file), run_graze("init " + kind).out);
    const Finished checked = run_graze("check " + file);
    EXPECT_EQ(checked.code, 0) << kind << checked.err;
    EXPECT_EQ(checked.err, "") << kind;
    std::size_t named = 0;
    for (const std::string& line : lines_of(file)) {
      const std::string begin = "#   graze ";
      if (line.substr(0, begin.size()) != begin) continue;
      std::string command = line.substr(begin.size());
      command = command.substr(0, command.find("    "));  // what it does stands behind
      command.replace(command.find("FILE"), 4, file);
      const Finished run = run_graze(command + " -q", "cd " + scratch.string() + " && ");
      EXPECT_EQ(run.code, 0) << kind << ": " << command << run.err;
      ++named;
    }
    EXPECT_GE(named, 3u) << kind;
  }
}

TEST(Shell, InitWritesOverNothing) {
  const ScratchFolder scratch;
  const std::string file = (scratch / "scene.toml").string();
  std::ofstream(file) << "mine";
  const Finished run = run_graze("init beam " + file);
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.err, file + ": it is there already; nothing was written\n");
  EXPECT_EQ(read_text(file), "mine");
  EXPECT_EQ(run_graze("init beam " + scratch.string() + "/none/scene.toml").code, 4);
  EXPECT_EQ(run_graze("init beem").err,
            "graze: KIND: 'beem' is not allowed; give beam, lumped, oscillator, matrices or hub (see graze "
            "init --help)\n");
}

TEST(Shell, ShortOptionsAreTheLongOnes) {
  const ScratchFolder scratch;
  const auto out = [&](const char* name) { return (scratch / name).string(); };
  const std::string simulate = "simulate " + kOneMode + " --periods 5 ";
  const Finished with_long = run_graze(simulate + "--set stop.gap=2e-3 --json --quiet --out " +
                                       out("a") + " --plot " + out("a.svg"));
  const Finished with_short =
      run_graze(simulate + "-s stop.gap=2e-3 -jq -o" + out("b") + " -p " + out("b.svg"));
  EXPECT_EQ(with_long.code, 0) << with_long.err;
  EXPECT_EQ(with_short.code, 0) << with_short.err;
  EXPECT_EQ(with_short.out, with_long.out);
  EXPECT_EQ(names_in(out("b")), names_in(out("a")));
  EXPECT_TRUE(std::filesystem::exists(out("b.svg")));
  EXPECT_EQ(run_graze("check -v " + kOneMode).out, run_graze("check --verbose " + kOneMode).out);
}

// A share is joined by the words that it was made with, less the folder it was written to.
TEST(Shell, SharesWithShortOptionsAreJoined) {
  const ScratchFolder scratch;
  const std::string diagram = "diagram " + kOneMode +
                              " --parameter stop.gap --from 1e-3 --to 2e-3 --points 4 -q "
                              "--branches none --periods 20 ";
  const auto out = [&](const char* name) { return (scratch / name).string(); };
  EXPECT_EQ(run_graze(diagram + "--shard 1/2 -o" + out("a")).code, 0);
  EXPECT_EQ(run_graze(diagram + "--shard 2/2 -o " + out("b")).code, 0);
  const Finished joined = run_graze("merge " + out("a") + " " + out("b") + " -qo " + out("c"));
  EXPECT_EQ(joined.code, 0) << joined.err;
  EXPECT_EQ(run_graze(diagram + "--out " + out("d")).code, 0);
  EXPECT_EQ(read_text(out("c") + "/sweep.csv"), read_text(out("d") + "/sweep.csv"));
}

TEST(Shell, UsageIsToldInItsOwnWords) {
  const std::string simulate = "simulate " + kOneMode, diagram = "diagram " + kOneMode;
  for (const auto& [arguments, sentence] : std::vector<std::pair<std::string, std::string>>{
           {diagram + " --points 3 --points 4", "--points was given twice; it takes one value"},
           {simulate + " -o a -o b --out c", "--out was given 3 times; it takes one value"},
           {simulate + " -qo", "--out: the value is missing; give --out DIR"},
           {simulate + " --out=", "--out: the value is missing; give --out DIR"},
           {diagram + " --points", "--points: the value is missing; give --points N"},
           {diagram, "--parameter NAME, --from A and --to B are missing"},
           {"simulate", "SCENE is missing"},
           {simulate + " --periods 3 --duration 2", "--duration and --periods do not go together"},
           {simulate + " --show returns", "--show needs --plot FILE"},
           {"compare " + kOneMode + " --reference 3", "--reference needs --sensitivity"},
           {simulate + " x", "simulate takes SCENE; 'x' is too many"},
           {simulate + " --set stop.gap=1 beam.modes=2",
            "simulate takes SCENE; 'beam.modes=2' is too many, each setting has a --set of its "
            "own"},
           {simulate + " --recrod none",
            "'--recrod' is no option of simulate; did you mean "
            "'--record'?"},
           {simulate + " --record all",
            "--record: 'all' is not allowed; give none, events or "
            "samples"},
           {simulate + " --json=1 --json=x", "--json takes no value"}}) {
    const Finished run = run_graze(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    const std::string command = arguments.substr(0, arguments.find(' '));
    EXPECT_EQ(run.err, "graze: " + sentence + " (see graze " + command + " --help)\n");
  }
}

}  // namespace
}  // namespace graze
