// The options of pictures, by what the scripts and their data say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "picture_script.hpp"

namespace graze {
namespace {

const std::string kDrawnOscillator = std::string(GRAZE_SOURCE_DIR) +
                                     "/data/validation/nlvib_oscillator.toml"
                                     " --parameter forcing.frequency --from 0.5 --to 1.7 ";
const std::string kDrawnBranch =
    scene("05_wagg_one_mode.toml") + " --parameter forcing.frequency --from 15 --to 120 ";

class PictureOptions : public PictureScripts {};

TEST_F(PictureOptions, TheTitleIsTheSceneAndWhatWasSet) {
  const std::string command = "continue " + kDrawnBranch + "--set stop.gap=2e-3 ";
  EXPECT_NE(script(command).find("caption = 'Wagg''s cantilever with its first mode alone · "
                                 "stop.gap=2e-3'"),
            std::string::npos);
  EXPECT_NE(script(command + "--title 'a_b {c}'").find("caption = 'a\\_b \\{c\\}'"),
            std::string::npos);
  const std::string none = script(command + "--title none");
  EXPECT_NE(none.find("body = 1\ncaption = ''"), std::string::npos);
}

// Whatever command drew it: a setting that a head leaves out makes its title false.
TEST_F(PictureOptions, EveryPictureTellsWhatWasSet) {
  const std::string wagg = scene("05_wagg_one_mode.toml"),
                    data = std::string(GRAZE_SOURCE_DIR) + "/data/measurements/restitution.";
  const std::string over = " --parameter forcing.frequency --from 30 --to 40 ";
  const std::string plane =
      over + "--second stop.gap --second-from 1e-3 --second-to 2e-3 --max-seconds 20 ";
  for (const std::string& command :
       {"check " + wagg, "modes " + wagg, "simulate " + wagg + " --periods 3",
        "orbit " + wagg + " --start closed-form", "continue " + wagg + over,
        "continue " + wagg +
            " --parameter forcing.frequency --from 20 --to 120 --second stop.gap --second-from "
            "5e-4 "
            "--second-to 0.01 --locus LP --slices 0",
        "diagram " + scene("17_yigit_lee_wang_1.toml") +
            " --parameter hub.torque.amplitude --from 0.05 --to 0.4 --points 2 --duration 0.02",
        "map " + wagg + plane + "--points 2 --second-points 2 --periods 20 --samples 5",
        "compare " + wagg + " --against beam.modes=2 --duration 1 --last 0.5 --periods 20",
        "compare " + wagg + plane +
            "--against stop.restitution=0.5 --points 2 --second-points 2 --periods 5 --first 1",
        "compare " + scene("20_yigit_sensitivity.toml") +
            " --sensitivity --parameter stop.spring.damping.coefficient --from 300 --to 800 "
            "--points 2 --duration 0.02",
        "fit " + data + "toml " + data + "csv"}) {
    run_graze(command + " --set title=altered --quiet --plot " + (scratch / "x.svg").string());
    EXPECT_NE(read_text(scratch / "x.gp").find("caption = 'altered · title=altered'"),
              std::string::npos)
        << command;
  }
}

TEST_F(PictureOptions, RangesAreThoseAskedFor) {
  const std::string text =
      script("continue " + kDrawnBranch + "--x-range 20:60 --y-range :0.3 --labels none");
  EXPECT_NE(text.find("set xrange [20:60]"), std::string::npos);
  EXPECT_TRUE(std::regex_search(text, std::regex(R"(set yrange \[-[0-9.e-]+:0.3\])"))) << text;
}

// Clear of the stop the oscillator's amplitude is |A / (1 - w^2 + i c w)|, with A = .02, c = .05.
TEST_F(PictureOptions, DecibelsAndLogarithmsAreOfTheAmplitude) {
  const auto closed_form = [](double w) { return 0.02 / std::hypot(1.0 - w * w, 0.05 * w); };
  const std::string command = "continue " + kDrawnOscillator + "--impacts 0 --show amplitude ";
  EXPECT_NE(script(command + "--y-scale dB").find("(dB re 1 m)"), std::string::npos);
  int compared = 0;
  for (const auto& [w, height] : data("stable"))
    if (closed_form(w) < 0.0999) {
      EXPECT_NEAR(height, 20.0 * std::log10(closed_form(w)), 1e-6) << w;
      ++compared;
    }
  EXPECT_GT(compared, 20);
  const std::string text = script(command + "--y-scale log --x-scale log");
  EXPECT_NE(text.find("set logscale y"), std::string::npos);
  EXPECT_NE(text.find("set logscale x"), std::string::npos);
  EXPECT_NE(refusal(command + "--x-scale dB").find("dB"), std::string::npos);
}

// Two modes of 1 and 2 rad/s that act on the stop alike cancel near sqrt(2.5) rad/s, in an
// antiresonance that the steps along the branch, by its unknowns, do not see. The amplitude is
// A |sum 1 / (w_j^2 - w^2 + 2 i z w_j w)|.
TEST_F(PictureOptions, AResponseIsRightToAPixelAtItsAntiresonance) {
  std::ofstream(scratch / "two.toml")
      << "[modal]\nfrequencies = [1.0, 2.0]\ndamping_ratios = [0.01, 0.01]\nparticipation = [1.0, "
         "1.0]\n[forcing]\nkind = \"modal\"\namplitude = 0.01\nfrequency = 1.5\n[[stop]]\nshape = "
         "[1.0, 1.0]\ngap = 1000.0\nside = \"above\"\nrestitution = 0.8\n";
  const auto closed_form = [](double w) {
    std::complex<double> sum = 0.0;
    for (const double own : {1.0, 2.0})
      sum += 1.0 / std::complex<double>(own * own - w * w, 0.02 * own * w);
    return 0.01 * std::abs(sum);
  };
  script("continue " + (scratch / "two.toml").string() +
         " --parameter forcing.frequency --from 0.5 --to 2.5 --impacts 0 --show amplitude");
  const std::vector<std::pair<double, double>> curve = data("stable");
  double largest = 0.0, least = 1.0, exact = 1.0;
  for (const auto& [w, height] : curve) {
    // Of nine digits of w, where the resonance rises by 20 m a rad/s.
    EXPECT_NEAR(height, closed_form(w), 1.2e-7) << w;
    largest = std::max(largest, height);
    least = std::min(least, height);
  }
  // The axes are some thousand pixels long; where the curve is steep its distance counts.
  const double across = 2.0 / 1000.0, up = largest / 1000.0;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    for (const double part : {0.25, 0.5, 0.75}) {
      const double dw = curve[i + 1].first - curve[i].first,
                   dy = curve[i + 1].second - curve[i].second;
      const double w = curve[i].first + part * dw;
      exact = std::min(exact, closed_form(w));
      const double off = curve[i].second + part * dy - closed_form(w);
      EXPECT_LT(std::abs(off) / up / std::hypot(1.0, dy / up / (dw / across)), 1.0) << w;
    }
  EXPECT_LT(least, 1.01 * exact);
  EXPECT_GT(largest, 0.99 * closed_form(std::sqrt(1.0 - 2.0 * 1e-4)));
}

// A column of 84 mm with words of 8 points keeps their room; a script says it in cm.
TEST_F(PictureOptions, SizesAndFontsAreThoseAskedFor) {
  const auto drawn = [&](const std::string& file, const std::string& more) {
    const Finished run = run_graze("continue " + kDrawnBranch + "--quiet --plot " +
                                   (scratch / file).string() + more);
    EXPECT_EQ(run.code, 0) << run.err;
    return read_text(scratch / "x.gp");
  };
  const std::string column = drawn("x.pdf", " --size 84:60 --font 'DejaVu Serif,8'");
  EXPECT_NE(column.find("font 'DejaVu Serif,11' fontscale 0.726 "), std::string::npos);
  EXPECT_NE(column.find("size 8.4cm,6cm"), std::string::npos);
  // Real fonts, not outlines of letters.
  const std::string pdf = read_text(scratch / "x.pdf");
  EXPECT_NE(pdf.find("/FontFile"), std::string::npos);
  EXPECT_EQ(pdf.find("/Type3"), std::string::npos);
  // Twice as wide is twice as large, words too; 640 pixels are 120 mm.
  EXPECT_NE(drawn("x.svg", " --size 240")
                .find("Sans,22' fontscale 1.59 linewidth 2.8 dashlength "
                      "0.7 size 1280,"),
            std::string::npos);
  EXPECT_NE(drawn("x.svg", " --size 120:200 --font ,4")
                .find("Sans,5.5' fontscale 1.59 linewidth "
                      "0.7 dashlength 0.7 size 640,1067"),
            std::string::npos);
  for (const char* wrong : {"--size 5", "--size 84x60", "--size 84:", "--font ,1", "--font x,y"})
    EXPECT_NE(refusal("continue " + kDrawnBranch + wrong).find("is not allowed; give"),
              std::string::npos)
        << wrong;
}

// Letters of a label are measured to be .167 cm wide at most, in a panel of 8.96 cm.
TEST_F(PictureOptions, LabelsCoverNoMarkAndNoOtherLabel) {
  const std::string text = script("continue " + kDrawnBranch + "--follow all --max-step 0.5");
  struct Box {
    double left, right, low, high;
    std::string name;
  };
  const double width = 8.96;
  double low = 0.0, high = 0.0, from = 15.0, to = 120.0;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, std::regex(R"(set yrange \[([^:]+):([^\]]+)\])")));
  low = std::stod(found[1]), high = std::stod(found[2]);
  // The panel is as high as the margins leave it, of a picture 12 cm wide.
  ASSERT_TRUE(std::regex_search(text, found, std::regex(R"(set terminal svg.* size (\d+),(\d+))")));
  const double picture = 12.0 * std::stod(found[2]) / std::stod(found[1]);
  ASSERT_TRUE(std::regex_search(text, found, std::regex(R"(body = ([0-9.]+))")));
  const double body = picture * std::stod(found[1]);
  const auto margin = [&](const std::string& name) {
    EXPECT_TRUE(std::regex_search(text, found,
                                  std::regex("set " + name + " at screen [(]?(?:1-)?([0-9.]+)")));
    return std::stod(found[1]);
  };
  const double height = body * (1.0 - margin("tmargin") - margin("bmargin"));
  std::vector<Box> boxes;
  std::istringstream lines(text);
  const std::regex label(R"(set label '([^']+)' at graph ([0-9.]+), graph ([0-9.]+) center)");
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_search(line, found, label)) continue;
    const double x = width * std::stod(found[2]), y = height * std::stod(found[3]);
    const double half = 0.5 * 0.167 * static_cast<double>(found[1].length());
    boxes.push_back({x - half, x + half, y - 0.12, y + 0.12, found[1]});
  }
  ASSERT_GE(boxes.size(), 4U);
  const auto apart = [](const Box& a, const Box& b) {
    constexpr double kCell = 0.05;  // labels are placed by cells
    return a.right <= b.left + kCell || b.right <= a.left + kCell || a.high <= b.low + kCell ||
           b.high <= a.low + kCell;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      EXPECT_TRUE(apart(boxes[i], boxes[j])) << boxes[i].name << " and " << boxes[j].name;
  for (const char* kind : {"LP", "PD", "GR"})
    for (const auto& [x, y] : data(kind)) {
      const double at_x = width * (x - from) / (to - from),
                   at_y = height * (y - low) / (high - low);
      for (const Box& box : boxes)
        EXPECT_FALSE(at_x > box.left && at_x < box.right && at_y > box.low && at_y < box.high)
            << box.name << " covers the " << kind << " at " << x;
    }
  // Nor does a curve run through one.
  for (const char* line : {"stable", "unstable"})
    for (const auto& [x, y] : data(line)) {
      const double at_x = width * (x - from) / (to - from),
                   at_y = height * (y - low) / (high - low);
      for (const Box& box : boxes)
        EXPECT_FALSE(at_x > box.left && at_x < box.right && at_y > box.low && at_y < box.high)
            << box.name << " is crossed at " << x;
    }
  EXPECT_EQ(script("continue " + kDrawnBranch + "--labels none").find("'PD2'"), std::string::npos);
  const std::string special = script("continue " + kDrawnBranch + "--labels special");
  EXPECT_NE(special.find("'PD2'"), std::string::npos);
  EXPECT_EQ(special.find("'(1,1)'"), std::string::npos);
}

TEST_F(PictureOptions, ASlideIsTwiceAsLargeWithHeavierLines) {
  const std::string paper = script("continue " + kDrawnBranch);
  const std::string slide = script("continue " + kDrawnBranch + "--style slide");
  EXPECT_NE(paper.find("Sans,11' fontscale 1.59 linewidth 1.4 dashlength 0.7 size 640,"),
            std::string::npos);
  EXPECT_NE(slide.find("Sans,22' fontscale 1.59 linewidth 4.2 dashlength 0.7 size 1280,"),
            std::string::npos);
}

// The script and the data that are kept draw the picture again.
TEST_F(PictureOptions, ThePictureIsDrawnAgainByItsScript) {
  for (const std::string& command : std::vector<std::string>{
           "continue " + kDrawnBranch, "diagram " + kDrawnBranch + "--points 20 --exponents 50"}) {
    script(command);
    const std::string before = read_text(scratch / "x.svg");
    std::filesystem::remove(scratch / "x.svg");
    ASSERT_EQ(std::system(("cd " + scratch.string() + " && gnuplot x.gp").c_str()), 0);
    EXPECT_EQ(read_text(scratch / "x.svg"), before);
  }
}

TEST_F(PictureOptions, AreRefusedWithAReason) {
  const std::string command = "continue " + kDrawnBranch;
  EXPECT_NE(refusal(command + "--x-range 5").find("--x-range: '5' is not allowed"),
            std::string::npos);
  EXPECT_NE(refusal(command + "--y-range 2:1").find("the smaller one first"), std::string::npos);
  EXPECT_EQ(run_graze(command + "--labels all").code, 2);  // no picture
}

// Names beside a picture are none that a user's own files have.
TEST_F(PictureOptions, MeasurementsNamedLikeThePictureAreKept) {
  const std::string folder = std::string(GRAZE_SOURCE_DIR) + "/data/measurements/";
  std::filesystem::copy_file(folder + "restitution.csv", scratch / "x.dat");
  const std::string before = read_text(scratch / "x.dat");
  script("fit " + folder + "restitution.toml " + (scratch / "x.dat").string());
  EXPECT_EQ(read_text(scratch / "x.dat"), before);
}

TEST_F(PictureOptions, ALineBreakInATitleIsABlank) {
  EXPECT_NE(script("continue " + kDrawnBranch + "--title 'one\ntwo'").find("caption = 'one two'"),
            std::string::npos);
}

// From 0.5 to 1.7 rad/s a logarithmic axis has the tics 0.5 and 1, and 0.1 and 0.2 Hz.
TEST_F(PictureOptions, ALogarithmicAxisWithinADecadeHasTics) {
  const std::string text = script("continue " + kDrawnOscillator + "--x-scale log");
  EXPECT_NE(text.find("set xtics (0.5, 1)"), std::string::npos);
  EXPECT_NE(text.find("set x2tics (0.1, 0.2)"), std::string::npos);
}

TEST_F(PictureOptions, APageHasNoUseForThem) {
  for (const char* option :
       {"--title x", "--style slide", "--size 84", "--font ,9", "--labels none", "--x-range 20:60",
        "--y-scale log", "--multipliers"}) {
    const std::string page = (scratch / "x.html").string();
    const Finished run = run_graze("continue " + kDrawnBranch + option + " --plot " + page);
    EXPECT_EQ(run.code, 2) << option;
    EXPECT_NE(run.err.find("are options of pictures"), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(page));
  }
  EXPECT_NE(refusal("continue " + kDrawnBranch + "--y-scale log --y-range -1:2")
                .find("give ends above zero"),
            std::string::npos);
}

TEST_F(PictureOptions, APlaneHasTwoParameters) {
  for (const std::string& axes : std::vector<std::string>{
           "--parameter forcing.frequency --from 20 --to 40 --second forcing.frequency_hz "
           "--second-from 3 --second-to 6",
           "--parameter stop.gap --from 1e-3 --to 2e-3 --second stop.1.gap --second-from 1e-3 "
           "--second-to 2e-3"})
    for (const std::string& command : std::vector<std::string>{"map ", "continue --locus LP "})
      EXPECT_EQ(run_graze(command + scene("05_wagg_one_mode.toml") + " " + axes +
                          (command == "map " ? " --points 2 --second-points 2" : ""))
                    .code,
                2)
          << command << axes;
}

}  // namespace
}  // namespace graze
