// Names and texts that are not meant well: what comes from files is shown, never obeyed, and
// options without a value are refused.
#include <gtest/gtest.h>

#include <fstream>

#include "apps/program.hpp"

namespace graze {
namespace {

// Nothing but UTF-8 whose characters a terminal shows; line feeds and tabs are allowed.
bool is_harmless(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == 0x7F || (byte < 0x20 && byte != '\n' && byte != '\t')) return false;
    // U+0080 to U+009F; no other character of these tests needs two bytes.
    if (byte >= 0x80) return false;
  }
  return true;
}

// ESC, CSI as one character, DEL, in TOML's spelling.
const std::string kHostile = "A\\u001b[2J\\u009b31m\\u007f\\nB";

std::string beam_with(const std::string& from, const std::string& to) {
  std::string text = read_text(kOneMode);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(HostileTexts, OfScenesAreNotObeyedByTheTerminal) {
  const ScratchFolder scratch;
  const std::string title = "title = \"Wagg's cantilever with its first mode alone\"";
  const std::vector<std::string> scenes{
      beam_with(title, "title = \"" + kHostile + "\""),
      beam_with("side = \"above\"", "side = \"" + kHostile + "\""),
      beam_with(title, title + "\n\"" + kHostile + "\" = 3"),
  };
  for (const std::string& text : scenes) {
    std::ofstream(scratch / "s.toml") << text;
    for (const char* json : {"", "--json "}) {
      const Finished run = run_graze("check " + std::string(json) + (scratch / "s.toml").string());
      EXPECT_TRUE(is_harmless(run.out)) << run.out;
      EXPECT_TRUE(is_harmless(run.err)) << run.err;
      EXPECT_TRUE(run.code == 0 || run.code == 2);
    }
  }
}

TEST(HostileTexts, OfTorqueFilesAreNotObeyedByTheTerminal) {
  const ScratchFolder scratch;
  std::string text = read_text(scene("17_yigit_lee_wang_1.toml"));
  const std::size_t at = text.find("torque = {");
  text.replace(at, text.find('\n', at) - at,
               "torque = { kind = \"table\", file = \"" + kHostile + ".csv\" }");
  std::ofstream(scratch / "s.toml") << text;
  const std::string check = "check " + (scratch / "s.toml").string();
  const Finished missing = run_graze(check);
  EXPECT_EQ(missing.code, 4) << missing.err;
  EXPECT_TRUE(is_harmless(missing.err)) << missing.err;
  // The names of its columns are shown as well.
  std::ofstream(scratch /
                "A\x1b[2J\xC2\x9B"
                "31m\x7f\nB.csv")
      << "time (s),\xC2\x9B"
         "31m (kg)\n0,1\n1,2\n";
  const Finished wrong = run_graze(check);
  EXPECT_EQ(wrong.code, 2) << wrong.err;
  EXPECT_TRUE(is_harmless(wrong.err)) << wrong.err;
  EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1) << wrong.err;
}

TEST(HostileTexts, OfMeasurementsAreNotObeyedByTheTerminal) {
  const ScratchFolder scratch;
  const std::string data = std::string(GRAZE_SOURCE_DIR) + "/data/measurements/";
  std::string table = read_text(data + "restitution.csv");
  table.replace(0, table.find('\n'),
                "\xC2\x9B"
                "31m,restitution");
  std::ofstream(scratch / "m.csv") << table;
  const Finished run =
      run_graze("fit " + data + "restitution.toml " + (scratch / "m.csv").string());
  EXPECT_NE(run.code, 4);
  EXPECT_TRUE(is_harmless(run.out + run.err)) << run.out << run.err;
}

TEST(EmptyValues, OfOptionsAreRefused) {
  const std::string range = "--parameter forcing.frequency --from 30 --to 40 ";
  for (const std::string& arguments :
       std::vector<std::string>{"check --out '' ", "simulate --periods 1 --plot '' ",
                                "simulate --periods 1 --resume '' ",
                                "orbit --plot= ", "diagram --points 3 --out '' " + range,
                                "continue --restart '' " + range, "continue --label '' " + range,
                                "cost --impacts 2 --out '' ", "orbit --start '' "}) {
    const Finished run = run_graze(arguments + kOneMode);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  EXPECT_EQ(run_graze("merge '' --out x").code, 2);
}

TEST(PictureNames, ThatGnuplotWouldRunAreRefused) {
  const ScratchFolder scratch;
  for (const char* name : {"<x.png", "|x.svg"}) {
    const Finished run =
        run_graze("simulate --periods 2 --plot '" + (scratch / name).string() + "' " + kOneMode);
    EXPECT_EQ(run.code, 2) << name;
    EXPECT_EQ(names_in(scratch.string()).size(), 0U) << name;
  }
}

}  // namespace
}  // namespace graze
