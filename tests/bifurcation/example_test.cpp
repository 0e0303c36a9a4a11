// The programs of docs/library.md: what they print agrees with closed forms and with the tables of
// tests/reference, and the page shows it.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "support/examples.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

using support::example_output;
using support::example_text;
using support::number;
using support::values_after;

// The numbers of data/scenes/05_wagg_one_mode.toml.
constexpr double kLineMass = 8500.0 * 12.4e-6;      // rho A, kg/m
constexpr double kLength = 0.3;                     // m
constexpr double kStiffness = 205e9 * 24.4e-14;     // EI, N m^2
constexpr double kDampingRate = 0.005 / kLineMass;  // eta/(rho A) = 2 delta, 1/s
constexpr double kBaseMotion = 0.0006;              // m
constexpr double kRestitution = 0.8;
constexpr double kDuration = 1.5;    // s, of the program that simulates
constexpr double kFrequency = 40.0;  // rad/s, of the programs that find and trace orbits

TEST(LibraryExamples, SimulateMeetsTheReference) {
  for (const std::string name : {"A", "B", "C", "D"}) {
    const std::string text = example_output("simulate", "tests/reference/cases/" + name + ".toml");
    const std::vector<double> times = values_after(text, "impact at ");
    const std::vector<double> speeds = values_after(text, " s, ");
    std::size_t compared = 0;
    for (const support::TableRow& row : support::read_table("impact_times.csv")) {
      if (row.at("case") != name || number(row, "time") >= kDuration) continue;
      ASSERT_LT(compared, times.size()) << name;
      EXPECT_NEAR(times[compared], number(row, "time"), 1e-9) << name;
      EXPECT_NEAR(speeds[compared], number(row, "speed"), 1e-9) << name;
      ++compared;
    }
    EXPECT_GT(compared, 0u) << name;
  }
}

// With one mode |phi(L)|^2 = 4/(rho A L), so that every impact takes (1 - r^2) v^2/2 of a quarter
// of the beam's mass.
TEST(LibraryExamples, SimulateCountsWhatImpactsTake) {
  const std::string text = example_output("simulate");
  const std::vector<double> speeds = values_after(text, " s, ");
  const std::vector<double> energies = values_after(text, " m/s, ");
  ASSERT_GT(speeds.size(), 2u);
  ASSERT_EQ(speeds.size(), energies.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double taken = (1.0 - kRestitution * kRestitution) * speeds[i] * speeds[i] / 2.0 *
                         kLineMass * kLength / 4.0;
    EXPECT_NEAR(-energies[i], taken, 2e-6 * taken) << i;
    sum += taken;
  }
  EXPECT_NE(text.find("\n" + std::to_string(speeds.size()) + " impacts took "), std::string::npos);
  EXPECT_NEAR(values_after(text, "took ").at(0), sum, 2e-6 * sum);
}

TEST(LibraryExamples, OrbitMeetsTheReference) {
  const std::string text = example_output("orbit");
  const std::vector<double> phases = values_after(text, "phase ");
  const std::vector<double> speeds = values_after(text, "speed ");
  const std::vector<double> multipliers = values_after(text, "multiplier ");
  std::size_t found = 0;
  for (const support::TableRow& row : support::read_table("closed_form_orbits.csv")) {
    if (row.at("case") != "beam_n1_40") continue;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      if (std::abs(phases[i] - number(row, "phase")) > 1e-6) continue;
      EXPECT_NEAR(phases[i], number(row, "phase"), 1e-9);
      EXPECT_NEAR(speeds.at(i), number(row, "speed"), 1e-9);
      EXPECT_NEAR(multipliers.at(2 * i), number(row, "mult_re1"), 1e-8);
      EXPECT_NEAR(multipliers.at(2 * i + 1), number(row, "mult_re2"), 1e-8);
      ++found;
    }
  }
  EXPECT_EQ(phases.size(), 2u);
  EXPECT_EQ(found, 2u);
  // One solution impacts forwards with both multipliers inside the unit circle; nothing else can
  // be stable and an orbit at once.
  EXPECT_NE(text.find("admissible, stable"), std::string::npos);
  EXPECT_NE(text.find("virtual, "), std::string::npos);
  EXPECT_EQ(text.find("virtual, stable"), std::string::npos);
}

// cos(b) cosh(b) = -1 next to 1.875, by bisection.
double first_wave_number() {
  double low = 1.8, high = 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2.0;
    (std::cos(middle) * std::cosh(middle) > -1.0 ? low : high) = middle;
  }
  return low;
}

// Free vibration of the tip on a base that moves by P cos(Omega t), as amplitude and phase behind
// it: each part of the beam feels rho A P Omega^2, the mode 2 s/b of it, the tip moves twice the
// mode.
std::complex<double> free_vibration() {
  const double b = first_wave_number();
  const double s = (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
  const double frequency = b * b * std::sqrt(kStiffness / kLineMass) / (kLength * kLength);
  return 2.0 * (2.0 * s / b) * kBaseMotion * kFrequency * kFrequency /
         std::complex<double>(frequency * frequency - kFrequency * kFrequency,
                              -kDampingRate * kFrequency);
}

TEST(LibraryExamples, BranchFoldsAndGrazesWhereTheClosedFormsSay) {
  const std::string text = example_output("branch");
  const std::vector<double> folds = values_after(text, "LP1 at ");
  const std::vector<double> grazings = values_after(text, "GR1 at ");
  const std::vector<double> phases = values_after(text, "phase ");
  ASSERT_EQ(folds.size(), 1u) << text;
  ASSERT_EQ(grazings.size(), 1u) << text;
  ASSERT_EQ(phases.size(), 2u) << text;
  for (const support::TableRow& row : support::read_table("closed_form_folds.csv")) {
    if (row.at("case") != "beam_n1_40") continue;
    EXPECT_NEAR(folds[0], number(row, "value"), 1e-11);
    EXPECT_NEAR(phases[0], number(row, "phase"), 1e-6);  // a fold: the root of 1e-12
  }
  // Where the impact speed vanishes the motion is free, and its amplitude is the gap.
  EXPECT_NEAR(grazings[0], std::abs(free_vibration()), 1e-11);
  EXPECT_NEAR(phases[1], std::arg(free_vibration()), 1e-6);
  EXPECT_NE(text.find("branch 1 from "), std::string::npos);
  EXPECT_EQ(text.find("branch 2 from "), std::string::npos);
}

TEST(LibraryExamples, SayWhatIsWrongWithAScene) {
  for (const std::string name : {"simulate", "orbit", "branch"}) {
    const std::string text =
        example_output(name, "no_such_scene.toml 2>&1; test $? -eq 2 && echo told");
    EXPECT_NE(text.find("no_such_scene.toml"), std::string::npos) << name;
    EXPECT_NE(text.find("told\n"), std::string::npos) << name;
  }
}

TEST(LibraryExamples, AreShortAndShownAsTheyAre) {
  const std::string page = support::docs_page("library.md");
  for (const std::string name : {"simulate", "orbit", "branch"}) {
    EXPECT_LE(support::lines_of_code(example_text(name)), 40) << name;
    EXPECT_NE(page.find("```text\n" + example_output(name) + "```"), std::string::npos) << name;
  }
  EXPECT_NE(page.find("```cpp\n" + example_text("orbit") + "```"), std::string::npos);
}

}  // namespace
}  // namespace graze
