// Results of scenes without units, and over frequencies in Hz.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

// One mode with two probes and a stop, in numbers that are pure.
std::string pure_scene(const ScratchFolder& folder,
                       const std::string& head = "units = \"none\"\n") {
  const std::string file = (folder / "pure.toml").string();
  std::ofstream(file) << head
                      << "[modal]\nfrequencies = [1.0]\nparticipation = [1.0]\n"
                         "damping_ratios = [0.05]\n[forcing]\namplitude = 1.0\nfrequency = 2.8\n"
                         "[[stop]]\nshape = [1.0]\ngap = 0.0\nrestitution = 0.8\n"
                         "[[probe]]\nshape = [1.0]\nquantity = \"velocity\"\n";
  return file;
}

TEST(UnitsNone, NothingPrintedHasAUnit) {
  const ScratchFolder folder;
  const std::string file = pure_scene(folder);
  const std::regex unit(R"((\((rad|m|s|1/s|N|J|kg|Hz)([ /^][^)]*)?\)|\d (rad|m|s|N|J|kg|Hz)\b))");
  for (const std::string& command :
       {std::string("check "), std::string("simulate --energy --amplitudes "),
        std::string("orbit "),
        std::string("continue --parameter forcing.frequency --from 2.5 --to 3 --amplitudes "),
        std::string("diagram --parameter stop.gap --from 0 --to 0.1 --points 5 --exponents 20 "),
        std::string("map --parameter forcing.frequency --from 2.5 --to 3 --points 3 "
                    "--second stop.gap --second-from 0 --second-to 0.1 --second-points 3 "),
        std::string("compare --against stop.restitution=0.7 ")}) {
    const Finished run = run_graze(command + file);
    EXPECT_TRUE(run.code == 0 || run.code == 3) << command << run.err;
    EXPECT_FALSE(std::regex_search(run.out, unit)) << command << "\n" << run.out;
    const json document = json::parse(run_graze(command + "--json " + file).out);
    EXPECT_FALSE(document.contains("units")) << command;
    EXPECT_EQ(document.dump().find("\"unit\":\"m"), std::string::npos) << command;
  }
  // The same scene with units prints them: the pattern finds what it is to find.
  const Finished run = run_graze("simulate --energy " + pure_scene(folder, ""));
  EXPECT_TRUE(std::regex_search(run.out, unit)) << run.out;
}

// What ends a run early, is refused or is told of an orbit is a sentence with numbers in it.
TEST(UnitsNone, NoSentenceHasAUnit) {
  const ScratchFolder folder;
  const std::string pure = pure_scene(folder), with_units = [] {
    static const ScratchFolder other;
    return pure_scene(other, "");
  }();
  const std::regex unit(R"(\d (rad|m|s|N|J|kg|Hz)\b)");
  for (const std::string& command :
       {std::string("simulate --max-impacts 5 "),
        std::string("simulate --set solver.flow=rk4 --set solver.step=100 "),
        std::string("orbit --verbose --set stop.restitution=0.1 --set forcing.frequency=1.1 ")}) {
    const Finished run = run_graze(command + pure), told = run_graze(command + with_units);
    EXPECT_EQ(run.code, told.code) << command;
    const std::string words = run.out + run.err, usual = told.out + told.err;
    EXPECT_FALSE(std::regex_search(words, unit)) << command << "\n" << words;
    EXPECT_TRUE(std::regex_search(usual, unit)) << command << "\n" << usual;
  }
}

// Of everything that is drawn: the scripts of the pictures, and the data of the pages.
TEST(UnitsNone, NothingDrawnHasAUnit) {
  const ScratchFolder folder;
  const std::string pure = pure_scene(folder);
  const std::regex unit(R"(\((µ|m|n|k|M)?(m|s|N|J|rad|Hz)([ /^][^)]*)?\))");
  const std::regex unit_of_page(R"("unit":"[^"]*[A-Za-z]|"hertz":true)");
  const std::string picture = (folder / "x.svg").string(), page = (folder / "x.html").string(),
                    script = (folder / "x.gp").string();
  const std::vector<std::string> commands = {
      "simulate --energy ",
      "simulate --section impact ",
      "simulate --record samples --show spectrum ",
      "orbit ",
      "continue --parameter forcing.frequency --from 2.5 --to 3 ",
      "continue --parameter forcing.frequency --from 2.5 --to 3 --show amplitude --at stop.1 ",
      "diagram --parameter forcing.frequency --from 2.5 --to 3 --points 5 --exponents 20 ",
      "map --parameter forcing.frequency --from 2.5 --to 3 --points 3 --second stop.gap"
      " --second-from 0 --second-to 0.1 --second-points 3 --show speed ",
      "compare --against stop.restitution=0.7 "};
  for (const std::string& command : commands) {
    const Finished run = run_graze(command + "--plot " + picture + " " + pure);
    ASSERT_TRUE(run.code == 0 || run.code == 3) << command << run.err;
    std::smatch found;
    const std::string text = read_text(script);
    ASSERT_FALSE(text.empty()) << command;
    EXPECT_FALSE(std::regex_search(text, found, unit)) << command << found.str();
    if (command.find("--section") != std::string::npos ||
        command.find("spectrum") != std::string::npos)
      continue;  // no page
    const Finished paged = run_graze(command + "--plot " + page + " " + pure);
    ASSERT_TRUE(paged.code == 0 || paged.code == 3) << command << paged.err;
    const std::string view = read_text(page);
    const std::size_t data = view.find("id=\"view\"");
    ASSERT_NE(data, std::string::npos) << command;
    const std::string drawn = view.substr(data, view.find("</script>", data) - data);
    EXPECT_FALSE(std::regex_search(drawn, found, unit_of_page)) << command << found.str();
  }
  // The patterns find what they are to find.
  const std::string with_units = pure_scene(folder, "");
  run_graze(commands[0] + "--plot " + picture + " " + with_units);
  EXPECT_TRUE(std::regex_search(read_text(script), unit));
  run_graze(commands[6] + "--plot " + picture + " " + with_units);
  EXPECT_NE(read_text(script).find("(Hz)"), std::string::npos);
}

// Over Hz the axis is one in Hz, and has no second one.
TEST(FrequencyInHertz, IsTheAxisOfPictures) {
  const ScratchFolder folder;
  const std::string picture = (folder / "x.svg").string();
  const Finished run =
      run_graze("continue " + scene("05_wagg_one_mode.toml") +
                " --parameter forcing.frequency_hz --from 2.5 --to 13 --plot " + picture);
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string script = read_text(folder / "x.gp");
  EXPECT_NE(script.find("forcing frequency (Hz)"), std::string::npos) << script;
  EXPECT_EQ(script.find("set x2label '"), std::string::npos) << script;
  EXPECT_EQ(script.find("rad/s"), std::string::npos) << script;
}

TEST(UnitsNone, ChangesNoNumber) {
  const ScratchFolder folder;
  const std::string command = "orbit --json ";
  const json pure = json::parse(run_graze(command + pure_scene(folder)).out),
             with_units = json::parse(run_graze(command + pure_scene(folder, "")).out);
  EXPECT_EQ(pure["orbits"], with_units["orbits"]);
}

// Orbits at 7 Hz are those at 14 pi rad/s.
TEST(FrequencyInHertz, OrbitsAreThoseOfTheSameFrequency) {
  const std::string command = "orbit --start closed-form --json " + scene("05_wagg_one_mode.toml");
  const json hertz =
      json::parse(run_graze(command + " --set forcing.frequency_hz=7").out)["orbits"];
  const json angular =
      json::parse(run_graze(command + " --set forcing.frequency=43.982297150257104").out)["orbits"];
  ASSERT_EQ(hertz.size(), 1U);
  ASSERT_EQ(angular.size(), 1U);
  EXPECT_NEAR(hertz[0]["phases"][0], angular[0]["phases"][0], 1e-12);
  EXPECT_NEAR(hertz[0]["speeds"][0], angular[0]["speeds"][0], 1e-12);
}

TEST(FrequencyInHertz, BranchesAreInHertz) {
  const std::string command = "continue " + scene("05_wagg_one_mode.toml") + " --parameter ";
  const Finished hertz = run_graze(command + "forcing.frequency_hz --from 2.5 --to 13 --json"),
                 angular = run_graze(command +
                                     "forcing.frequency --from 15.707963267948966"
                                     " --to 81.68140899333463 --json");
  ASSERT_EQ(hertz.code, 0) << hertz.err;
  const json document = json::parse(hertz.out), other = json::parse(angular.out);
  EXPECT_EQ(document["parameter"], "forcing.frequency_hz");
  EXPECT_EQ(document["units"]["value"], "Hz");
  std::vector<double> in_hertz, in_angular;
  for (const json& branch : document["branches"])
    for (const json& special : branch["special"]) in_hertz.push_back(special["value"]);
  for (const json& branch : other["branches"])
    for (const json& special : branch["special"]) in_angular.push_back(special["value"]);
  ASSERT_EQ(in_hertz.size(), in_angular.size());
  ASSERT_FALSE(in_hertz.empty());
  for (std::size_t i = 0; i < in_hertz.size(); ++i)
    EXPECT_NEAR(kTwoPi * in_hertz[i], in_angular[i], 1e-9 * in_angular[i]);
  const std::string text = run_graze(command + "forcing.frequency_hz --from 2.5 --to 13").out;
  EXPECT_NE(text.find("(Hz)"), std::string::npos) << text;
  EXPECT_EQ(text.find("rad/s"), std::string::npos) << text;
}

// Limits, value and uncertainty of a fit are in the unit of the name.
TEST(FrequencyInHertz, IsFittedInHertz) {
  const std::string data = std::string(GRAZE_SOURCE_DIR) + "/data/measurements/response";
  const std::string command = "fit --json --quiet " + data + ".toml " + data +
                              ".csv --parameter stop.gap=4e-3:6e-3"
                              " --parameter damping.viscous=0.001:0.2 --parameter ";
  // 27 and 29.5 rad/s.
  const Finished hertz =
      run_graze(command + "forcing.frequency_hz=4.29718346348117:4.69507082120350");
  const Finished angular = run_graze(command + "forcing.frequency=27:29.5");
  ASSERT_EQ(hertz.code, 0) << hertz.err;
  const json in_hertz = json::parse(hertz.out)["parameters"].back(),
             in_angular = json::parse(angular.out)["parameters"].back();
  ASSERT_EQ(in_hertz["name"], "forcing.frequency_hz");
  EXPECT_EQ(in_hertz["unit"], "Hz");
  // The data were made with 28.3 rad/s; both runs end where the sum of squares is flat.
  const double uncertainty = in_angular["uncertainty"];
  EXPECT_NEAR(kTwoPi * in_hertz["value"].get<double>(), in_angular["value"].get<double>(),
              1e-3 * uncertainty);
  EXPECT_NEAR(kTwoPi * in_hertz["uncertainty"].get<double>(), uncertainty, 1e-3 * uncertainty);
}

TEST(FrequencyInHertz, IsCheckedInBothUnits) {
  const Finished run =
      run_graze("check " + scene("05_wagg_one_mode.toml") + " --set forcing.frequency_hz=4.5");
  // 9 pi rad/s.
  EXPECT_NE(run.out.find("4.5 Hz = 28.2743 rad/s"), std::string::npos) << run.out;
}

// What a run leaves has the frequency as it was given.
TEST(FrequencyInHertz, IsKeptInTheFolder) {
  const ScratchFolder folder;
  const std::string out = (folder / "run").string();
  ASSERT_EQ(run_graze("orbit " + scene("05_wagg_one_mode.toml") +
                      " --set forcing.frequency_hz=7 --out " + out)
                .code,
            0);
  EXPECT_NE(read_text(out + "/scene.toml").find("\nfrequency_hz = 7"), std::string::npos);
}

// A special point over one of the units is gone on from over the other.
TEST(FrequencyInHertz, RestartsInEitherUnit) {
  const ScratchFolder folder;
  const std::string out = (folder / "run").string(), file = scene("05_wagg_one_mode.toml");
  ASSERT_EQ(run_graze("continue " + file +
                      " --parameter forcing.frequency_hz --from 8 --to 12 --out " + out)
                .code,
            0);
  const Finished restarted = run_graze("continue " + file + " --restart " + out +
                                       " --label PD1 --switch --parameter forcing.frequency"
                                       " --from 50 --to 75 --json");
  ASSERT_EQ(restarted.code, 0) << restarted.err;
  const json document = json::parse(restarted.out);
  ASSERT_FALSE(document["branches"].empty());
  EXPECT_EQ(document["branches"][0]["period"], 2);
}

}  // namespace
}  // namespace graze
