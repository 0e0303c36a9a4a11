// The tables of docs/contact_laws.md, as docs/examples/contact_laws.cpp prints them: against closed
// forms, and against a fixed-step integration of each law written out here. The page shows them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "support/examples.hpp"

namespace {

using graze::support::docs_page;
using graze::support::example_output;

constexpr double kMass = 0.1;                                // kg
constexpr std::array<double, 3> kSpeeds = {0.01, 0.1, 1.0};  // m/s
constexpr double kLinear = 1e7, kHertz = 3e9;                // N/m, N/m^1.5

// "law | spring | ends at" -> the cells behind it, of each table.
using Cells = std::vector<std::string>;
using Tables = std::vector<std::map<std::string, Cells>>;

Cells cells_of(const std::string& line) {
  Cells cells;
  std::stringstream stream(line);
  std::string cell;
  std::getline(stream, cell, '|');
  while (std::getline(stream, cell, '|')) {
    const std::size_t first = cell.find_first_not_of(' ');
    cells.push_back(cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return cells;
}

const std::string& printed() {
  static const std::string text = example_output("contact_laws");
  return text;
}

const Tables& tables() {
  static const Tables made = [] {
    Tables list;
    std::stringstream stream(printed());
    for (std::string line; std::getline(stream, line);) {
      if (line.rfind("| law", 0) == 0) list.emplace_back();
      if (line.rfind("| ", 0) != 0 || line.rfind("| law", 0) == 0) continue;
      const Cells cells = cells_of(line);
      list.back()[cells[0] + " | " + cells[1] + " | " + cells[2]] = {cells.begin() + 3,
                                                                     cells.end()};
    }
    return list;
  }();
  return made;
}

// As printed in the first table, at the i-th speed.
double restitution(const std::string& law, std::size_t i) {
  return std::stod(tables().at(0).at(law).at(1 + i));
}
double force(const std::string& law, std::size_t i) {
  return std::stod(tables().at(1).at(law).at(i));
}
double duration(const std::string& law, std::size_t i) {  // s
  return 1e-6 * std::stod(tables().at(1).at(law).at(3 + i));
}

void expect_digits(double value, double expected, int digits) {
  EXPECT_NEAR(value, expected, 0.51 * std::pow(10.0, 1 - digits) * std::abs(value));
}

TEST(ContactLaws, ThereAreThreeTablesOfAllLaws) {
  ASSERT_EQ(tables().size(), 3u);
  for (const auto& table : tables()) EXPECT_EQ(table.size(), 22u);
}

// Half a period pi sqrt(m/k) with the force v sqrt(k m); Hertz's: x_max = (5 m v^2/(4 k))^(2/5) and
// 2.9432751843247 x_max/v (Johnson, Contact Mechanics, section 11.4).
TEST(ContactLaws, SpringsAlone) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = kSpeeds[i], deepest = std::pow(1.25 * kMass * v * v / kHertz, 0.4);
    for (const char* spring : {"none | linear | force", "none | Hertz | force"})
      EXPECT_EQ(restitution(spring, i), 1.0);
    expect_digits(force("none | linear | force", i), v * std::sqrt(kLinear * kMass), 5);
    expect_digits(duration("none | linear | force", i),
                  std::numbers::pi * std::sqrt(kMass / kLinear), 5);
    expect_digits(force("none | Hertz | force", i), kHertz * std::pow(deepest, 1.5), 5);
    expect_digits(duration("none | Hertz | force", i), 2.9432751843247 * deepest / v, 5);
  }
}

// zeta = -ln e/sqrt(pi^2 + ln^2 e) is exact where the contact ends at zero depth; at zero force
// e = exp(-zeta/sqrt(1 - zeta^2) arccos(2 zeta^2 - 1)).
TEST(ContactLaws, SpringDashpot) {
  const double decrement = std::log(2.0), w = std::sqrt(kLinear / kMass);
  const double zeta =
      decrement / std::sqrt(std::numbers::pi * std::numbers::pi + decrement * decrement);
  const double turn = std::sqrt(1.0 - zeta * zeta), angle = std::acos(2.0 * zeta * zeta - 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(restitution("kelvin-voigt | linear | force", i), std::exp(-zeta / turn * angle),
                6e-7);
    EXPECT_EQ(restitution("kelvin-voigt | linear | position", i), 0.5);
    EXPECT_EQ(restitution("kelvin-voigt, exact | linear | force", i), 0.5);
    expect_digits(duration("kelvin-voigt | linear | force", i), angle / (w * turn), 5);
    expect_digits(duration("kelvin-voigt | linear | position", i), std::numbers::pi / (w * turn),
                  5);
  }
}

// e of A (1 + e) = ln[(1 + A)/(1 - A e)], by halving.
double restitution_by_halving(double a) {
  double low = 0.0, high = std::min(1.0, 1.0 / a);
  for (int pass = 0; pass < 200; ++pass) {
    const double e = 0.5 * (low + high);
    (a * (1.0 + e) > std::log((1.0 + a) / (1.0 - a * e)) ? low : high) = e;
  }
  return low;
}

// F = k x^n (1 + d v): e depends on A = d v alone. Each model's own A for 0.5 at 0.1 m/s, which
// grows with the speed; Lee and Wang's first is that law where n = 1, with half of Hunt and
// Crossley's A.
TEST(ContactLaws, DampingThatGrowsWithTheForce) {
  const std::map<std::string, double> asked = {{"lee-wang-1 | linear", 0.375},
                                               {"hunt-crossley | linear", 0.75},
                                               {"hunt-crossley | Hertz", 0.75},
                                               {"lankarani-nikravesh | linear", 0.5625},
                                               {"lankarani-nikravesh | Hertz", 0.5625},
                                               {"flores | linear", 1.6},
                                               {"flores | Hertz", 1.6}};
  for (const auto& [law, a] : asked)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(restitution(law + " | force", i),
                  restitution_by_halving(a * kSpeeds[i] / kSpeeds[1]), 6e-7)
          << law << " at " << kSpeeds[i];
  EXPECT_EQ(restitution("hunt-crossley, exact | Hertz | force", 1), 0.5);
  // Published: asked for 0.5.
  EXPECT_NEAR(restitution("hunt-crossley | Hertz | force", 1), 0.6629622, 6e-7);
  EXPECT_NEAR(restitution("lankarani-nikravesh | Hertz | force", 1), 0.72524111, 6e-7);
  EXPECT_NEAR(restitution("flores | Hertz | force", 1), 0.47044478, 6e-7);
}

enum class Factor { kConstant, kDepth, kOnset, kForce, kStep, kApproach, kCapped };

struct Law {
  double stiffness = 0.0, exponent = 1.0;
  Factor factor = Factor::kConstant;
  double coefficient = 0.0;
  bool to_zero_depth = false;

  double force(double x, double v) const {
    const double power = std::pow(std::max(x, 0.0), exponent);
    const double onset = 5e-6, part = std::min(std::max(x, 0.0) / onset, 1.0);
    if (factor == Factor::kCapped)
      return stiffness * power +
             std::min(std::max(coefficient * v, -stiffness * power), stiffness * power);
    if (factor == Factor::kApproach && v < 0.0) return stiffness * power;
    const double t = factor == Factor::kConstant ? 1.0
                     : factor == Factor::kDepth  ? x
                     : factor == Factor::kForce  ? power
                     : factor == Factor::kStep   ? part * part * (3.0 - 2.0 * part)
                     : factor == Factor::kApproach
                         ? std::pow(std::max(x, 0.0), 0.5 * (exponent - 1.0))
                     : x < onset ? std::exp(6.0 * (x - onset) / onset)
                                 : 1.0;
    return stiffness * power + coefficient * t * v;
  }
};

struct Encounter {
  double restitution = 0.0, peak = 0.0, duration = 0.0;
};

// Classical Runge-Kutta, the end by a straight line within the last step.
Encounter encounter(const Law& law, double speed) {
  const double unit = law.exponent == 1.0
                          ? std::sqrt(kMass / law.stiffness)
                          : std::pow(1.25 * kMass * speed * speed / law.stiffness, 0.4) / speed;
  const double h = 2e-5 * unit;
  const auto rate = [&](double x, double v) { return -law.force(x, v) / kMass; };
  Encounter found;
  double x = 0.0, v = speed, t = 0.0;
  found.peak = law.force(0.0, speed);
  for (int step = 0; step < 2000000; ++step) {
    const double a1 = rate(x, v), v2 = v + 0.5 * h * a1;
    const double a2 = rate(x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
    const double a3 = rate(x + 0.5 * h * v2, v3), v4 = v + h * a3;
    const double a4 = rate(x + h * v3, v4);
    const double next_x = x + h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    const double next_v = v + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    const double before = law.to_zero_depth ? x : law.force(x, v);
    const double after = law.to_zero_depth ? next_x : law.force(next_x, next_v);
    if (v < 0.0 && (after <= 0.0 || next_x <= 0.0)) {
      const double part =
          next_x <= 0.0 && after > 0.0 ? x / (x - next_x) : before / (before - after);
      found.restitution = -(v + part * (next_v - v)) / speed;
      found.duration = t + part * h;
      return found;
    }
    x = next_x;
    v = next_v;
    t += h;
    found.peak = std::max(found.peak, law.force(x, v));
  }
  return found;
}

// By halving; of a function that changes sign between the two.
double zero_of(const std::function<double(double)>& f, double low = 0.01, double high = 0.9) {
  const bool rises = f(high) > f(low);
  for (int pass = 0; pass < 100; ++pass) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == rises ? high : low) = middle;
  }
  return low;
}

const std::map<std::string, Law>& written_out() {
  const double root = std::sqrt(kLinear * kMass);
  const double zeta = std::log(2.0) / std::hypot(std::numbers::pi, std::log(2.0));
  // For e = 0.5 at 0.1 m/s, at zero force: -ln e = 2 zeta arccos(zeta)/sqrt(1 - zeta^2).
  const double ratio = zero_of(
      [](double z) { return 2.0 * z * std::acos(z) / std::sqrt(1.0 - z * z) - std::log(2.0); });
  const double power =
      zero_of([](double a) { return 1.5 * a - std::log((1.0 + a) / (1.0 - 0.5 * a)); }, 0.5, 1.9);
  static const std::map<std::string, Law> laws = {
      {"kelvin-voigt, exact | linear | force",
       {kLinear, 1.0, Factor::kConstant, 2.0 * ratio * root}},
      {"hunt-crossley, exact | Hertz | force", {kHertz, 1.5, Factor::kForce, power / 0.1 * kHertz}},
      {"kelvin-voigt | linear | force", {kLinear, 1.0, Factor::kConstant, 2.0 * zeta * root}},
      {"kelvin-voigt | linear | position",
       {kLinear, 1.0, Factor::kConstant, 2.0 * zeta * root, true}},
      {"kelvin-voigt | Hertz | force", {kHertz, 1.5, Factor::kConstant, 800.0}},
      {"kelvin-voigt | Hertz | position", {kHertz, 1.5, Factor::kConstant, 800.0, true}},
      {"lee-wang-1 | linear | force", {kLinear, 1.0, Factor::kDepth, 3.75 * kLinear}},
      {"lee-wang-1 | Hertz | force", {kHertz, 1.5, Factor::kDepth, 1.92e8}},
      {"lee-wang-1 | Hertz | position", {kHertz, 1.5, Factor::kDepth, 1.92e8, true}},
      {"lee-wang-2 | linear | position", {kLinear, 1.0, Factor::kOnset, 2.0 * zeta * root, true}},
      {"lee-wang-2 | Hertz | position", {kHertz, 1.5, Factor::kOnset, 800.0, true}},
      {"hunt-crossley | linear | force", {kLinear, 1.0, Factor::kForce, 7.5 * kLinear}},
      {"hunt-crossley | Hertz | force", {kHertz, 1.5, Factor::kForce, 7.5 * kHertz}},
      {"lankarani-nikravesh | linear | force", {kLinear, 1.0, Factor::kForce, 5.625 * kLinear}},
      {"lankarani-nikravesh | Hertz | force", {kHertz, 1.5, Factor::kForce, 5.625 * kHertz}},
      {"flores | linear | force", {kLinear, 1.0, Factor::kForce, 16.0 * kLinear}},
      {"flores | Hertz | force", {kHertz, 1.5, Factor::kForce, 16.0 * kHertz}},
      {"adams | linear | position", {kLinear, 1.0, Factor::kStep, 800.0, true}},
      // zeta = (9 sqrt 5/2) (1 - e^2)/(e (e (9 pi - 16) + 16)), e = 1/2 (Jankowski 2006).
      {"jankowski | Hertz | force",
       {kHertz, 1.5, Factor::kApproach,
        2.0 * 4.5 * std::sqrt(5.0) * 0.75 / (0.5 * (0.5 * (9.0 * std::numbers::pi - 16.0) + 16.0)) *
            std::sqrt(kHertz * kMass),
        true}},
      {"elasto-gap | linear | force", {kLinear, 1.0, Factor::kCapped, 800.0, true}}};
  return laws;
}

TEST(ContactLaws, EveryRowMeetsAnIntegrationOfItsLaw) {
  for (const auto& [name, law] : written_out())
    for (std::size_t i = 0; i < 3; ++i) {
      SCOPED_TRACE(name + " at " + std::to_string(kSpeeds[i]) + " m/s");
      if (tables().at(0).at(name).at(1 + i) == "-") continue;  // see below
      const Encounter expected = encounter(law, kSpeeds[i]);
      EXPECT_NEAR(restitution(name, i), expected.restitution, 2e-6);
      EXPECT_NEAR(force(name, i) / expected.peak, 1.0, 6e-5);
      EXPECT_NEAR(duration(name, i) / expected.duration, 1.0, 6e-5);
    }
}

// Constant damping outlives a Hertz spring near its surface: k x^(3/2) = -C x' has x = (2 C/(k
// t))^2, which never reaches zero. That is how the slowest body leaves.
TEST(ContactLaws, ASlowBodyCreepsOutOfADampedHertzContact) {
  int open = 0;
  for (const auto& [name, cells] : tables().at(0))
    for (const std::string& cell : cells) {
      if (&cell != &cells.front() && cell == "-") {
        ++open;
        EXPECT_EQ(name, "kelvin-voigt | Hertz | position");
        EXPECT_EQ(&cell, &cells[1]);
      }
    }
  EXPECT_EQ(open, 1);
  // After 40 units of the contact's time, when all others have parted, it is still inside.
  const Encounter never = encounter({kHertz, 1.5, Factor::kConstant, 800.0, true}, 0.01);
  EXPECT_EQ(never.duration, 0.0);
}

TEST(ContactLaws, ThePageShowsRowsOfTheTables) {
  std::stringstream page(docs_page("contact_laws.md"));
  bool in_table = false;
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| law")) in_table = true;
    if (line.empty()) in_table = false;
    if (!in_table) continue;
    ++rows;
    EXPECT_NE(printed().find(line + "\n"), std::string::npos) << line;
  }
  EXPECT_GE(rows, 20);
  for (const auto& [law, cells] : tables().at(2))
    for (std::size_t i = 0; i < 3; ++i) {
      if (cells[i] != "-") EXPECT_LT(std::stod(cells[i]), 10000.0) << law;
    }
}

TEST(ContactLaws, ThePictureShowsWhatTheCoefficientsGive) {
  std::stringstream stream(example_output("contact_laws", "--curve"));
  std::string model;
  double asked = 0.0, given = 0.0;
  int points = 0;
  while (stream >> model >> asked >> given) {
    ++points;
    const double a = model == "lee-wang-1"            ? 0.75 * (1.0 - asked)
                     : model == "hunt-crossley"       ? 1.5 * (1.0 - asked)
                     : model == "lankarani-nikravesh" ? 0.75 * (1.0 - asked * asked)
                                                      : 1.6 * (1.0 - asked) / asked;
    const double decrement = -std::log(asked);
    const double zeta = decrement / std::hypot(std::numbers::pi, decrement);
    const double expected =
        model == "kelvin-voigt"
            ? std::exp(-zeta / std::sqrt(1.0 - zeta * zeta) * std::acos(2.0 * zeta * zeta - 1.0))
        : asked > 0.999 ? 1.0
                        : restitution_by_halving(a);
    EXPECT_NEAR(given, expected, 1e-9) << model << " " << asked;
  }
  EXPECT_EQ(points, 250);
}

}  // namespace
