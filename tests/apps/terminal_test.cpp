// What the program prints is made for a terminal of 100 columns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

constexpr std::size_t kWidth = 100;

std::string validation(const std::string& name) {
  return std::string(GRAZE_SOURCE_DIR) + "/data/validation/" + name;
}

std::vector<std::string> printed_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// Characters, of which UTF-8 has one for every byte that does not go on with one before it.
std::size_t characters(const std::string& line) {
  std::size_t count = 0;
  for (const char c : line) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
  return count;
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// Lines of which the first words are these.
std::vector<std::string> lines_beginning(const std::string& text, const std::string& words) {
  std::vector<std::string> found;
  for (const std::string& line : printed_lines(text)) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != std::string::npos && line.compare(begin, words.size(), words) == 0)
      found.push_back(line);
  }
  return found;
}

const std::string kNlvib = "continue " + validation("nlvib_oscillator.toml") +
                           " --parameter forcing.frequency --from 0.5 --to 1.7 --amplitudes";
const std::string kOneModeBranches = "continue " + scene("05_wagg_one_mode.toml") +
                                     " --parameter forcing.frequency --from 15 --to 120";
const std::string kSmallMap = "map " + scene("05_wagg_one_mode.toml") +
                              " --parameter forcing.frequency --from 15 --to 120 --points 30"
                              " --second stop.gap --second-from 0.5e-3 --second-to 2e-3"
                              " --second-points 20";

std::vector<std::string> commands() {
  std::vector<std::string> list;
  for (const char* name :
       {"01_wagg_2004", "07_two_stops", "09_soft_stop_two_modes", "11_body_meets_stop",
        "14_beam_against_a_ball", "15_sphere_on_a_beam", "16_strain_gauge", "17_yigit_lee_wang_1"})
    list.push_back("check " + scene(std::string(name) + ".toml"));
  for (const char* name : {"masri_caughey", "coexisting_orbits", "bouncing_bar", "ansys_vm65"})
    list.push_back("check " + validation(std::string(name) + ".toml"));
  list.insert(
      list.end(),
      {"simulate " + scene("07_two_stops.toml") + " --energy --amplitudes",
       "simulate " + scene("14_beam_against_a_ball.toml") + " --duration 0.1 --amplitudes",
       "simulate " + scene("17_yigit_lee_wang_1.toml") + " --duration 0.05 --energy",
       "simulate " + validation("siconos_bouncing_ball.toml") + " --duration 3",
       "orbit " + scene("05_wagg_one_mode.toml") + " --set forcing.frequency=40",
       "orbit " + scene("05_wagg_one_mode.toml") + " --set forcing.frequency=40 --verbose",
       "orbit " + scene("07_two_stops.toml") + " --virtual --start random",
       "orbit " + scene("09_soft_stop_two_modes.toml"),
       "orbit " + validation("coexisting_orbits.toml") + " --verbose",
       kOneModeBranches,
       kOneModeBranches + " --follow all --verbose",
       kNlvib,
       kOneModeBranches +
           " --locus PD --second stop.gap --second-from 0.5e-3 --second-to 2e-3 --slices 2",
       kOneModeBranches +
           " --locus LP --second stop.gap --second-from 0.5e-3 --second-to 2e-3 --slices 1"
           " --regions 4 --verbose",
       "diagram " + scene("05_wagg_one_mode.toml") +
           " --parameter forcing.frequency --from 15 --to 120 --points 60 --exponents 100",
       "diagram " + scene("20_yigit_sensitivity.toml") +
           " --parameter stop.spring.damping.coefficient --from 0 --to 1000 --points 5"
           " --duration 0.05",
       kSmallMap,
       "cost " + scene("04_impact_oscillator.toml") + " --impacts 3",
       "fit " + measured("restitution.toml") + " " + measured("restitution.csv") + " --verbose",
       "fit " + measured("contact.toml") + " " + measured("contact.csv") +
           " --parameter stop.spring.stiffness=1e6:1e9",
       "compare " + scene("01_wagg_2004.toml") + " --against beam.discretisation=galerkin",
       "compare " + scene("02_wagg_momentum.toml") + " --modes 1:3 --duration 2",
       "compare " + scene("20_yigit_sensitivity.toml") +
           " --sensitivity --duration 0.05 --parameter stop.spring.damping.coefficient"
           " --from 0 --to 1000 --points 5"});
  return list;
}

TEST(Terminal, NoLineIsWiderThanAHundredCharacters) {
  for (const std::string& command : commands()) {
    const Finished run = run_graze(command);
    EXPECT_TRUE(run.code == 0 || run.code == 3) << command << "\n" << run.err;
    EXPECT_FALSE(run.out.empty()) << command;
    for (const std::string& line : printed_lines(run.out))
      EXPECT_LE(characters(line), kWidth) << command << "\n" << line;
  }
}

TEST(Terminal, HelpFitsToo) {
  for (const char* command : {"", "check ", "simulate ", "orbit ", "continue ", "diagram ", "map ",
                              "merge ", "cost ", "fit ", "compare ", "view "}) {
    const Finished help = run_graze(std::string(command) + "--help");
    EXPECT_EQ(help.code, 0);
    for (const std::string& line : printed_lines(help.out))
      EXPECT_LE(characters(line), kWidth) << command << "\n" << line;
  }
}

std::vector<std::string> headings_of(const std::string& command) {
  std::vector<std::string> headings;
  for (const std::string& line : printed_lines(run_graze(command + " --help").out))
    if (!line.empty() && line[0] != ' ' && line.back() == ':' && line != "Positionals:")
      headings.push_back(line.substr(0, line.size() - 1));
  return headings;
}

// Long lists of options are read by their headings: what the command alone has comes first.
TEST(Terminal, HelpHasHeadings) {
  EXPECT_EQ(
      headings_of("continue"),
      (std::vector<std::string>{"Parameter", "Search for orbits", "Branches", "Response curves",
                                "Levels", "Loci of special points", "Restart", "Scene",
                                "Numerics and limits", "Output", "Pictures"}));
}

TEST(Terminal, HelpOfEveryCommandBeginsWithItsOwnOptions) {
  const std::vector<std::string> shared = {"Scene", "Numerics and limits", "Long work", "Output",
                                           "Pictures"};
  for (const char* command : {"init", "check", "modes", "simulate", "orbit", "continue", "diagram",
                              "map", "merge", "view", "cost", "fit", "compare"}) {
    const std::vector<std::string> headings = headings_of(command);
    std::vector<std::string> last;
    for (const std::string& heading : shared)
      if (std::find(headings.begin(), headings.end(), heading) != headings.end())
        last.push_back(heading);
    ASSERT_GE(headings.size(), last.size()) << command;
    EXPECT_EQ(
        std::vector<std::string>(headings.end() - static_cast<long>(last.size()), headings.end()),
        last)
        << command;
  }
}

// The rows of a map, of a comparison of maps and of regions are parts of a whole.
TEST(Terminal, SharesAddUp) {
  const Finished run = run_graze(kSmallMap);
  ASSERT_EQ(run.code, 0) << run.err;
  double sum = 0.0;
  int rows = 0;
  const std::regex share(R"((\d+\.\d\d) %)");
  for (const std::string& line : printed_lines(run.out)) {
    std::smatch match;
    if (std::regex_search(line, match, share)) sum += std::stod(match[1].str()), ++rows;
  }
  EXPECT_NE(run.out.find("\n  and "), std::string::npos) << run.out;
  EXPECT_NEAR(sum, 100.0, 0.005 * rows) << run.out;
  // Each row by itself is no less than a hundredth; what is less is in the last line.
  for (const std::string& line : printed_lines(run.out)) {
    std::smatch match;
    if (line.find("and ") == std::string::npos && std::regex_search(line, match, share)) {
      EXPECT_GE(std::stod(match[1].str()), 1.0) << line;
    }
  }
}

// The stop of every impact stands in the table where the scene has several stops.
TEST(Terminal, OrbitTellsItsStops) {
  const std::string command = "orbit " + scene("07_two_stops.toml") + " --start random";
  const Finished run = run_graze(command);
  const json document = json::parse(run_graze(command + " --json").out);
  std::vector<int> told;
  bool is_below_head = false;
  for (const std::string& line : printed_lines(run.out)) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) break;
    if (is_below_head)  // "1 (1, 2) 2 0.038 0.0992 no ..", and of a further impact "1 3.18 0.0992"
      told.push_back(std::stoi(words.size() == 3 ? words[0] : words[3]));
    if (words[0] == "orbit") {
      is_below_head = true;
      ASSERT_EQ(words[3], "stop") << line;  // "orbit (p, k) stop .."
    }
  }
  std::vector<int> expected;
  for (const json& orbit : document["orbits"])
    for (const json& impact : orbit["at"]) expected.push_back(impact["stop"]);
  EXPECT_EQ(told, expected) << run.out;
  EXPECT_EQ(std::set<int>(told.begin(), told.end()), (std::set<int>{1, 2}));
}

// And the forcing period of every impact where orbits take several.
TEST(Terminal, OrbitTellsItsPeriods) {
  const Finished run = run_graze("orbit " + scene("05_wagg_one_mode.toml") +
                                 " --set forcing.frequency=59.6 --period 2 --impacts 2");
  ASSERT_EQ(run.code, 0) << run.err;
  std::vector<std::vector<std::string>> rows;  // from the head's last line on
  for (const std::string& line : printed_lines(run.out)) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) break;
    if (words[0] == "orbit" || !rows.empty()) rows.push_back(words);
  }
  ASSERT_EQ(rows.size(), 3U) << run.out;
  EXPECT_EQ(rows[0][3], "period") << run.out;
  EXPECT_EQ(rows[1][3], "0") << run.out;  // "1 (2, 2) 0 .."
  EXPECT_EQ(rows[2][0], "1") << run.out;
  const Finished one =
      run_graze("orbit " + scene("05_wagg_one_mode.toml") + " --set forcing.frequency=40");
  EXPECT_EQ(one.out.find("period  "), std::string::npos) << one.out;
  EXPECT_EQ(one.out.find("stop  "), std::string::npos) << one.out;
}

TEST(Terminal, ZeroIsWrittenAsZero) {
  const std::regex slip(R"((^|[ (])(-0(\.0*)?|0\.0+|-?\d(\.\d+)?e-(1[7-9]|2\d))(?![\d.e]))");
  for (const std::string& command :
       {kOneModeBranches, kNlvib, "check " + scene("07_two_stops.toml"),
        "orbit " + scene("07_two_stops.toml") + " --start random",
        "simulate " + scene("14_beam_against_a_ball.toml") + " --duration 0.1 --amplitudes",
        "compare " + scene("20_yigit_sensitivity.toml") +
            " --sensitivity --duration 0.05 --parameter stop.spring.damping.coefficient"
            " --from 0 --to 1000 --points 5"})
    for (const std::string& line : printed_lines(run_graze(command).out))
      EXPECT_FALSE(std::regex_search(line, slip)) << command << "\n" << line;
  // The speed of a grazing impact.
  const Finished run = run_graze(kOneModeBranches);
  const std::vector<std::string> grazing = lines_beginning(run.out, "GR2 ");
  ASSERT_EQ(grazing.size(), 1U) << run.out;
  EXPECT_EQ(words_of(grazing[0])[4], "0") << grazing[0];
}

// The response without impacts ends at the grazings at which the (1, 1) orbits do. They are one
// point of the diagram and stand there once; the document has them for each of their branches.
TEST(Terminal, AGrazingThatTwoBranchesShareStandsOnce) {
  const Finished run = run_graze(kNlvib);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run_graze(kNlvib + " --json").out);
  std::map<int, std::vector<double>> values;  // of grazings, by the branch
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"])
      if (special["label"] == "GR") values[branch["id"]].push_back(special["value"]);
  ASSERT_EQ(values.size(), 3U);
  ASSERT_EQ(values[1].size(), 2U);
  int shared = 0;
  for (const std::string& line : printed_lines(run.out)) {
    if (words_of(line).empty() || words_of(line)[0].rfind("GR", 0) != 0) continue;
    ++shared;
    EXPECT_TRUE(std::regex_search(line, std::regex(R"(GR\d, GR\d +1, [23] )"))) << line;
  }
  EXPECT_EQ(shared, 2) << run.out;
}

// How the numerics went is told to those who ask.
TEST(Terminal, VerboseTellsOfTheNumerics) {
  const std::string orbit =
      "orbit " + scene("05_wagg_one_mode.toml") + " --set forcing.frequency=40";
  EXPECT_EQ(run_graze(orbit).out.find("residual"), std::string::npos);
  EXPECT_NE(run_graze(orbit + " --verbose").out.find("residual"), std::string::npos);
  const std::string brief = run_graze(kOneModeBranches).out,
                    verbose = run_graze(kOneModeBranches + " --verbose").out;
  for (const char* detail : {"evaluations of the shooting equations", "note: the closed form of"}) {
    EXPECT_EQ(brief.find(detail), std::string::npos) << brief;
    EXPECT_NE(verbose.find(detail), std::string::npos) << verbose;
  }
}

// One line a row and a head, however long.
TEST(Terminal, WideTablesStayInOnePiece) {
  const std::string command = "check " + scene("07_two_stops.toml");
  EXPECT_TRUE(lines_beginning(run_graze(command).out, "mode   frequency (rad/s)").empty());
  const Finished wide = run_graze(command + " --wide");
  const std::vector<std::string> heads = lines_beginning(wide.out, "mode   frequency (rad/s)");
  ASSERT_EQ(heads.size(), 1U) << wide.out;
  EXPECT_GT(characters(heads[0]), kWidth);
}

}  // namespace
}  // namespace graze
