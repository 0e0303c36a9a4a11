// Structures whose damping couples their modes against tests/reference/coupled_damping.py (50
// digits, independent): impacts, exponents of the free motion, orbits and multipliers; energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/initial_state.hpp"
#include "graze/base/angle.hpp"
#include "graze/motion/energy_balance.hpp"
#include "graze/orbit/closed_form/response.hpp"
#include "graze/orbit/search/finder.hpp"
#include "support/reference.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

using support::number;
using support::TableRow;

std::map<std::string, std::vector<TableRow>> by_case(const std::string& table) {
  std::map<std::string, std::vector<TableRow>> cases;
  for (const TableRow& row : support::read_table(table)) cases[row.at("case")].push_back(row);
  return cases;
}

TEST(CoupledDamping, ImpactsAgreeWithTheReference) {
  const auto cases = by_case("coupled_impacts.csv");
  EXPECT_EQ(cases.size(), 4u);
  for (const auto& [name, rows] : cases) {
    SCOPED_TRACE(name);
    const Scene scene = support::reference_scene("coupled/" + name);
    const System system = assemble(scene);
    ASSERT_NE(system.coupling(), nullptr);
    const support::RecordedRun run =
        support::record_run(system, initial_state(scene, system),
                            support::for_seconds(number(rows.back(), "time") * (1.0 + 1e-9)));
    ASSERT_EQ(run.events.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(run.events[i].time, number(rows[i], "time"), 1e-11) << "impact " << i + 1;
      EXPECT_NEAR(run.events[i].speed / number(rows[i], "speed"), 1.0, 1e-10) << "impact " << i + 1;
    }
  }
}

// Multipliers of the motion that meets no stop are e^{l T} of the exponents l. Where two of these
// coincide an error e of the matrix moves them by its root.
TEST(CoupledDamping, ExponentsOfTheFreeMotion) {
  for (const auto& [name, rows] : by_case("coupled_rates.csv")) {
    SCOPED_TRACE(name);
    System system = assemble(support::reference_scene("coupled/" + name));
    if (!system.forcing())
      system.modal().forcing = HarmonicForcing{3.0, 0.0, Vector::Zero(system.modes())};
    const std::vector<Eigenvalue> multipliers = response_multipliers(system);
    ASSERT_EQ(multipliers.size(), rows.size());
    for (const TableRow& row : rows) {
      const Complex expected =
          std::exp(Complex(number(row, "re"), number(row, "im")) * system.period());
      const auto nearest = std::min_element(
          multipliers.begin(), multipliers.end(), [&](const Eigenvalue& a, const Eigenvalue& b) {
            return std::abs(a.value - expected) < std::abs(b.value - expected);
          });
      EXPECT_LT(std::abs(nearest->value - expected), name == "defective" ? 1e-9 : 1e-13);
    }
  }
}

TEST(CoupledDamping, OrbitsAndMultipliersAgreeWithTheReference) {
  int admissible = 0;
  for (const auto& [name, rows] : by_case("coupled_orbits.csv")) {
    SCOPED_TRACE(name);
    const Scene scene = support::reference_scene("coupled/" + name);
    const System system = assemble(scene);
    FinderOptions options;
    options.impacts = 1;
    const FoundOrbits found = find_orbits(system, initial_state(scene, system), options);
    for (const TableRow& row : rows) {
      if (number(row, "clearance") < 0.0 || number(row, "speed") < 0.0) continue;
      ++admissible;
      const auto orbit =
          std::find_if(found.orbits.begin(), found.orbits.end(), [&](const Orbit& one) {
            return one.impacts.size() == 1 &&
                   std::abs(one.impacts[0].speed - number(row, "speed")) < 1e-6;
          });
      ASSERT_NE(orbit, found.orbits.end()) << row.at("speed");
      EXPECT_NEAR(orbit->impacts[0].speed, number(row, "speed"), 1e-11);
      EXPECT_NEAR(std::remainder(orbit->impacts[0].phase - number(row, "phase"), kTurn), 0.0,
                  1e-10);
      ASSERT_EQ(orbit->multipliers.size(), 4u);
      for (int k = 1; k <= 4; ++k) {
        const Complex expected(number(row, "re" + std::to_string(k)),
                               number(row, "im" + std::to_string(k)));
        const auto nearest =
            std::min_element(orbit->multipliers.begin(), orbit->multipliers.end(),
                             [&](const Eigenvalue& a, const Eigenvalue& b) {
                               return std::abs(a.value - expected) < std::abs(b.value - expected);
                             });
        EXPECT_LT(std::abs(nearest->value - expected), 1e-10) << k;
      }
      EXPECT_EQ(orbit->stable, true);
    }
  }
  EXPECT_EQ(admissible, 3);
}

// On rigid and on compliant stops, in flights and in contact.
TEST(CoupledDamping, TheEnergyBalanceCloses) {
  for (const char* name : {"dashpot", "free", "gyroscopic", "spring"}) {
    SCOPED_TRACE(name);
    const Scene scene = support::reference_scene(std::string("coupled/") + name);
    const System system = assemble(scene);
    SimulationOptions options = support::for_seconds(12.0);
    options.energy = true;
    const Simulation run = simulate(system, initial_state(scene, system), options);
    ASSERT_EQ(run.outcome, RunOutcome::kReachedEnd);
    ASSERT_TRUE(run.energy);
    EXPECT_LT(std::abs(run.energy->defect()), 1e-11 * run.energy->size());
    EXPECT_GT(run.energy->work.dissipation, 0.0);
  }
}

// Step by step, by other means, through contacts with a spring that gives way.
TEST(CoupledDamping, OnACompliantStopTheSameMotionStepByStep) {
  const Scene scene = support::reference_scene("coupled/spring");
  const System system = assemble(scene);
  const State start = initial_state(scene, system);
  SimulationOptions options = support::for_seconds(6.0);
  const support::RecordedRun exact = support::record_run(system, start, options);
  StepSetting setting;
  setting.method = StepMethod::kFehlberg78;
  setting.tolerance = 1e-14;
  setting.speed = 1.0;
  setting.longest = longest_stable_step(system, setting.method);
  options.steps = setting;
  const support::RecordedRun stepped = support::record_run(system, start, options);
  ASSERT_EQ(exact.events.size(), stepped.events.size());
  ASSERT_GE(exact.events.size(), 8u);
  for (std::size_t i = 0; i < exact.events.size(); ++i)
    EXPECT_NEAR(exact.events[i].time, stepped.events[i].time, 1e-9) << i;
}

}  // namespace
}  // namespace graze
