// The modes of masses and springs, and of matrices that stand in the scene, with their derivatives.
#include <gtest/gtest.h>

#include <cmath>

#include "graze/assembly/assembly.hpp"
#include "graze/assembly/system_family.hpp"
#include "graze/base/errors.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/structure/modal_model.hpp"
#include "graze/structure/static_response.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

// In the order of lumped_rates.csv: frequencies, Phi^T C Phi by rows, shapes at the stop, and at
// the force.
std::vector<double> listed(const ModalModel& model) {
  std::vector<double> list(model.omega.begin(), model.omega.end());
  const Eigen::Index n = model.omega.size();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      list.push_back(i == j ? 2.0 * model.delta[i] : model.coupling(i, j));
  list.insert(list.end(), model.shapes[0].begin(), model.shapes[0].end());
  for (const Vector& load : model.participations) list.insert(list.end(), load.begin(), load.end());
  return list;
}

TEST(LumpedModel, ItsNumbersAndDerivativesAreThoseOfTheReference) {
  const Scene scene = support::reference_scene("coupled/three_masses");
  const ModalModel model = modal_model(scene);
  const std::vector<double> here = listed(model);
  std::size_t compared = 0;
  std::string of;
  std::vector<double> rates;
  for (const support::TableRow& row : support::read_table("lumped_rates.csv")) {
    const std::string& name = row.at("parameter");
    if (name != of) rates = listed(modal_tangent(scene, model, parameter_direction(scene, name)));
    of = name;
    const auto k = static_cast<std::size_t>(std::stoi(row.at("number")));
    const double value = support::number(row, "value"), rate = support::number(row, "rate");
    EXPECT_NEAR(here[k], value, 1e-14 * (1.0 + std::abs(value))) << name << " " << k;
    EXPECT_NEAR(rates[k], rate, 1e-12 * (1.0 + std::abs(rate))) << name << " " << k;
    ++compared;
  }
  EXPECT_EQ(compared, 198u);
}

TEST(LumpedModel, IsTheSameByItsMatrices) {
  const ModalModel lumped = modal_model(support::reference_scene("coupled/three_masses"));
  const ModalModel rows = modal_model(parse_scene(R"(
    [matrices]
    mass = [[1.3, 0.0, 0.0], [0.0, 0.7, 0.0], [0.0, 0.0, 2.1]]
    stiffness = [[75, -20, 0], [-20, 53, -33], [0, -33, 45]]
    damping = [[1.3, -0.9, 0.0], [-0.9, 1.1, -0.2], [0.0, -0.2, 1.9]]
    [forcing]
    node = 2
    amplitude = 1.0
    frequency = 4.0
    [[stop]]
    node = 3
    against = 1
    gap = 0.1
    restitution = 0.6)",
                                                  "rows.toml"));
  const std::vector<double> a = listed(lumped), b = listed(rows);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-13) << k;
}

// All numbers of a system in one vector.
Vector lumped_numbers_of(const System& system) {
  std::vector<double> list(system.omega.begin(), system.omega.end());
  const Matrix damping = system.damping();
  for (Eigen::Index i = 0; i < damping.size(); ++i) list.push_back(damping.reshaped()[i]);
  for (const Vector* vector :
       {system.load(), system.forcing() ? &system.forcing()->amplitude : nullptr})
    if (vector) list.insert(list.end(), vector->begin(), vector->end());
  for (const Stop& stop : system.stops) {
    list.insert(list.end(), stop.row.begin(), stop.row.end());
    list.push_back(stop.is_compliant() ? stop.force().stiffness : 0.0);
  }
  return Eigen::Map<const Vector>(list.data(), static_cast<Eigen::Index>(list.size()));
}

void expect_lumped_tangents(const Scene& scene, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const double value = *parameter_value(scene, name), h = 1e-4 * std::abs(value);
    const auto at = [&](double p) { return lumped_numbers_of(assemble(with_parameter(scene, name, p))); };
    const Vector difference = support::central_difference(at, value, h);
    const Vector rate = lumped_numbers_of(system_tangent(scene, name));
    ASSERT_EQ(rate.size(), difference.size()) << name;
    for (Eigen::Index i = 0; i < rate.size(); ++i)
      EXPECT_NEAR(rate[i], difference[i], 2e-9 * std::max(1.0, std::abs(difference[i])))
          << name << ", number " << i;
  }
}

// A base that moves, gravity, a constant force, fewer modes than masses, a spring of what these
// leave out.
TEST(LumpedModel, TangentsOfTruncatedModesUnderEveryLoad) {
  const std::string text = R"(
    [lumped]
    masses = [1.3, 0.7, 2.1, 0.4]
    names = ["frame", "arm", "head", "tip"]
    modes = 2
    [[lumped.spring]]
    between = ["ground", "frame"]
    stiffness = 55.0
    damping = 0.4
    [[lumped.spring]]
    between = ["frame", "arm"]
    stiffness = 20.0
    [[lumped.spring]]
    between = ["arm", "head"]
    stiffness = 33.0
    damping = 0.2
    [[lumped.spring]]
    between = ["head", "tip"]
    stiffness = 12.0
    [forcing]
    kind = "base"
    amplitude = 0.01
    frequency = 4.0
    [gravity]
    acceleration = -9.81
    [[stop]]
    mass = "tip"
    gap = 0.1
    [stop.spring]
    stiffness = "residual")";
  const Scene scene = parse_scene(text, "four.toml");
  expect_lumped_tangents(scene, {"lumped.masses.1", "lumped.masses.4", "lumped.spring.1.stiffness",
                          "lumped.spring.4.stiffness", "lumped.spring.3.damping"});
  const Scene loaded =
      parse_scene(text + R"(
    [[load]]
    mass = "arm"
    force = 3.0)",
                  "loaded.toml", {"stop.spring.stiffness=500.0", "forcing.kind=base"});
  expect_lumped_tangents(loaded, {"lumped.masses.2", "lumped.spring.2.stiffness", "load.force"});
}

TEST(LumpedModel, EntriesOfMatricesAreParameters) {
  const Scene scene = parse_scene(R"(
    [matrices]
    mass = [[2.0, 0.1], [0.1, 1.0]]
    stiffness = [[30.0, -8.0], [-8.0, 20.0]]
    damping = [[0.3, 1.5], [-1.5, 0.2]]
    load = [1]
    [forcing]
    kind = "load"
    amplitude = 1.0
    frequency = 4.0
    [[stop]]
    node = 2
    gap = 0.1
    restitution = 0.6)",
                                  "rows.toml");
  expect_lumped_tangents(scene,
                  {"matrices.mass.1.1", "matrices.mass.1.2", "matrices.stiffness.1.2",
                   "matrices.stiffness.2.2", "matrices.damping.1.2", "matrices.damping.2.2"});
  EXPECT_EQ(find_parameter(scene, "matrices.mass.2.1"), nullptr);
  EXPECT_EQ(parameter_unit(scene, "matrices.stiffness.1.2"), "N/m");
}

// Two equal oscillators side by side have one frequency, and one of them alone moves with its
// spring; a spring between both turns their modes into each other.
TEST(LumpedModel, ModesOfOneFrequency) {
  const char* text = R"(
    [lumped]
    masses = [1.0, 1.0]
    [[lumped.spring]]
    between = [0, 1]
    stiffness = 9.0
    [[lumped.spring]]
    between = [0, 2]
    stiffness = 9.0
    [[lumped.spring]]
    between = [1, 2]
    stiffness = 0.0
    [[stop]]
    mass = 1
    gap = 0.1
    restitution = 0.6)";
  const Scene scene = parse_scene(text, "two.toml");
  const ModalModel model = modal_model(scene);
  EXPECT_THROW(modal_tangent(scene, model, parameter_direction(scene, "lumped.spring.3.stiffness")),
               InputError);
}

TEST(LumpedModel, FreeBodiesAndASpringThatBeginsToHold) {
  const Scene scene = parse_scene(R"(
    [lumped]
    masses = [1.0, 3.0]
    [[lumped.spring]]
    between = [1, 2]
    stiffness = 12.0
    [[lumped.spring]]
    between = [0, 1]
    stiffness = 0.0
    [[stop]]
    mass = 1
    gap = 0.1
    restitution = 0.6)",
                                  "free.toml");
  const ModalModel model = modal_model(scene);
  EXPECT_EQ(model.omega[0], 0.0);
  EXPECT_NEAR(model.omega[1], 4.0, 1e-14);  // sqrt(12 (1 + 1/3))
  EXPECT_THROW(modal_tangent(scene, model, parameter_direction(scene, "lumped.spring.2.stiffness")),
               InputError);
  const ModalModel rate =
      modal_tangent(scene, model, parameter_direction(scene, "lumped.spring.1.stiffness"));
  EXPECT_EQ(rate.omega[0], 0.0);
  EXPECT_NEAR(rate.omega[1], 4.0 / 24.0, 1e-14);
}

// Modes are coupled at all values of a family, the one among them at which damping happens to be
// proportional.
TEST(LumpedModel, AFamilyIsCoupledAtAllItsValues) {
  const Scene scene = parse_scene(R"(
    [lumped]
    masses = [1.0, 1.0]
    [[lumped.spring]]
    between = [0, 1]
    stiffness = 20.0
    damping = 0.2
    [[lumped.spring]]
    between = [1, 2]
    stiffness = 10.0
    damping = 0.1
    [forcing]
    mass = 1
    amplitude = 1.0
    frequency = 3.0
    [[stop]]
    mass = 2
    gap = 0.1
    restitution = 0.6)",
                                  "family.toml");
  EXPECT_EQ(assemble(scene).coupling(), nullptr);
  const SystemFamily family(scene, "lumped.spring.1.stiffness");
  ASSERT_NE(family.at(20.0)->coupling(), nullptr);
  EXPECT_TRUE(family.at(20.0)->coupling()->isZero(0.0));
  EXPECT_FALSE(family.at(21.0)->coupling()->isZero(0.0));
  EXPECT_EQ(SystemFamily(scene, "forcing.frequency").at(3.5)->coupling(), nullptr);
  SystemCursor cursor(family);
  ASSERT_NE(cursor.at(20.0)->coupling(), nullptr);
  EXPECT_NE(cursor.tangent_at(20.0)->coupling(), nullptr);
}

}  // namespace
}  // namespace graze
