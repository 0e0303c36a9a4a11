// Beams of any section and support, strings and bars: frequencies and shapes against closed
// solutions, their rates against differences, what cannot be.
#include "graze/structure/detail/span_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "graze/scene/parameter.hpp"
#include "graze/structure/modal_model.hpp"
#include "support/differences.hpp"
#include "support/reference.hpp"

namespace graze {
namespace {

constexpr double kPi = std::numbers::pi;

const std::string kStrip =
    "[beam]\nlength = 0.8\nyoungs_modulus = 2e11\ndensity = 7800\n"
    "section = { shape = \"rectangle\", width = 0.02, height = 0.004 }\n";

Scene scene_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  return parse_scene(text, "test.toml", settings);
}

Vector omega_of(const Scene& scene) {
  return std::visit([](const auto& modes) { return modes.omega(); }, span_modes(scene));
}

// tests/reference/beams.py: closed solutions in 40 digits.
TEST(SpanModes, AreThoseOfTheClosedSolutions) {
  std::map<std::string, std::vector<support::TableRow>> cases;
  for (const auto& row : support::read_table("beams.csv")) cases[row.at("case")].push_back(row);
  EXPECT_EQ(cases.size(), 16u);
  for (const auto& [name, rows] : cases) {
    SCOPED_TRACE(name);
    const Scene scene = support::reference_scene("beams/" + name);
    const SpanModes modes = span_modes(scene);
    const Vector omega = std::visit([](const auto& has) { return has.omega(); }, modes);
    // The table has no rigid motions.
    const int rigid = name == "free_free" ? 2 : 0;
    EXPECT_TRUE(omega.head(rigid).isZero(0.0));
    ASSERT_EQ(omega.size(), 8);
    for (int j = rigid; j < omega.size(); ++j) {
      const auto& row = rows[static_cast<std::size_t>(j - rigid)];
      EXPECT_NEAR(omega[j] / support::number(row, "omega"), 1.0, 1e-11) << j;
      double size = 0.0;
      for (const char* place : {"at_013", "at_055", "at_071"})
        size = std::max(size, std::abs(support::number(row, place)));
      for (const auto& [place, x] : {std::pair{"at_013", 0.13}, {"at_055", 0.55}, {"at_071", 0.71}})
        EXPECT_NEAR(std::visit([x = x](const auto& has) { return has.shapes(x); }, modes)[j] / size,
                    support::number(row, place) / size, 1e-9)
            << j << " " << place;
    }
  }
}

// One piece makes elements of the beam that has a closed form.
TEST(SpanModes, ElementsGiveTheUniformBeam) {
  for (const int count : {1, 4, 32}) {
    const std::vector<std::string> number = {"beam.modes=" + std::to_string(count)};
    const Scene closed = scene_of(kStrip, number);
    const Scene pieced = scene_of(kStrip + "[[beam.piece]]\n", number);
    const SpanModes exact = span_modes(closed), found = span_modes(pieced);
    ASSERT_TRUE(std::holds_alternative<CantileverModes>(exact));
    ASSERT_TRUE(std::holds_alternative<ElementModes>(found));
    const auto& a = std::get<CantileverModes>(exact);
    const auto& b = std::get<ElementModes>(found);
    const double tip = a.shapes(0.8)[0];
    for (int j = 0; j < count; ++j) {
      EXPECT_NEAR(b.omega()[j] / a.omega()[j], 1.0, 1e-12) << j;
      for (const double x : {0.0, 0.1, 0.33, 0.8}) {
        EXPECT_NEAR(b.shapes(x)[j] / tip, a.shapes(x)[j] / tip, 1e-10) << j;
        // Of the size of the curvature at the clamp.
        const double bent = a.strains(0.0, 1.0)[j];
        EXPECT_NEAR(b.strains(x, 1.0)[j] / bent, a.strains(x, 1.0)[j] / bent, 1e-8) << j;
      }
      EXPECT_NEAR(b.inertia()[j] / a.inertia()[0], a.inertia()[j] / a.inertia()[0], 1e-10) << j;
      EXPECT_NEAR(b.load()[j] / a.load()[0], a.load()[j] / a.load()[0], 1e-10) << j;
    }
    EXPECT_LE(b.accuracy().change, 1e-10);
  }
}

TEST(SpanModes, OfUniformStringsAndBars) {
  const std::string string =
      "[string]\nlength = 0.863\ntension = 191.6\nmass_per_length = 0.0067\nmodes = 2000\n";
  const Vector omega = omega_of(scene_of(string));
  const double c = std::sqrt(191.6 / 0.0067);
  for (const int j : {1, 2, 862, 2000})
    EXPECT_NEAR(omega[j - 1] / (j * kPi * c / 0.863), 1.0, 1e-14) << j;
  const SpanModes modes = span_modes(scene_of(string));
  const double size = std::sqrt(2.0 / (0.0067 * 0.863));
  const Vector phi = std::get<UniformLineModes>(modes).shapes(0.863 / 6.0);
  for (const int j : {1, 2, 3, 2000})
    EXPECT_NEAR(phi[j - 1] / size, std::sin(j * kPi / 6.0), 1e-12) << j;
}

TEST(SpanModes, OfAStringWithMeasuredFrequencies) {
  const Scene scene = scene_of(
      "[string]\nlength = 0.863\nfrequencies = [615.6, 1234.4, 1851.3]\n"
      "mass_per_length = 0.0067\nmodes = 3\n");
  const Vector omega = omega_of(scene);
  EXPECT_EQ(omega[0], 615.6);
  EXPECT_EQ(omega[1], 1234.4);
  EXPECT_EQ(omega[2], 1851.3);
  // phi_j = sqrt(2/(m L)) sin(j pi x/L), whatever the frequencies.
  const double size = std::sqrt(2.0 / (0.0067 * 0.863));
  const Vector phi = std::get<UniformLineModes>(span_modes(scene)).shapes(0.2);
  for (const int j : {1, 2, 3})
    EXPECT_NEAR(phi[j - 1], size * std::sin(j * kPi * 0.2 / 0.863), 1e-13 * size) << j;
}

// Elements find what the closed forms of all four pairs of ends say; a light mass makes elements.
TEST(SpanModes, ElementsGiveTheUniformString) {
  for (const std::string ends :
       {"fixed\", \"fixed", "fixed\", \"free", "free\", \"fixed", "free\", \"free"}) {
    const std::string bar =
        "[bar]\nlength = 0.7\nyoungs_modulus = 2e11\ndensity = 7800\n"
        "area = 1e-4\nmodes = 12\nends = [\"" +
        ends + "\"]\n";
    const SpanModes closed = span_modes(scene_of(bar));
    const SpanModes pieced = span_modes(scene_of(bar + "[[bar.piece]]\n"));
    const auto& a = std::get<UniformLineModes>(closed);
    const auto& b = std::get<ElementModes>(pieced);
    const double scale = a.omega()[1];
    const double size = std::sqrt(2.0 / (7800 * 1e-4 * 0.7));
    for (int j = 0; j < 12; ++j) {
      EXPECT_NEAR(b.omega()[j] / scale, a.omega()[j] / scale, 1e-12 * (j + 1)) << ends << j;
      for (const double x : {0.0, 0.2, 0.45, 0.7}) {
        EXPECT_NEAR(b.shapes(x)[j] / size, a.shapes(x)[j] / size, 1e-9) << ends << j;
        EXPECT_NEAR(b.strains(x, 1.0)[j] / size, a.strains(x, 1.0)[j] / size, 1e-6) << ends << j;
      }
      EXPECT_NEAR(b.load()[j] / size, a.load()[j] / size, 1e-10) << ends << j;
      EXPECT_NEAR(b.inertia()[j] / size, a.inertia()[j] / size, 1e-10) << ends << j;
    }
  }
}

TEST(SpanModes, RigidMotionsAreCounted) {
  const auto rigid = [](const std::string& more) {
    const Scene scene = scene_of(kStrip + "modes = 4\n" + more);
    const int count = modal_model(scene).elements->rigid;
    const Vector omega = omega_of(scene);
    EXPECT_TRUE(omega.head(count).isZero(0.0)) << more;
    EXPECT_GT(omega[count], 0.0) << more;
    return count;
  };
  EXPECT_EQ(rigid("ends = [\"free\", \"free\"]\n"), 2);
  EXPECT_EQ(rigid("ends = [\"pinned\", \"free\"]\n"), 1);
  EXPECT_EQ(rigid("ends = [\"sliding\", \"sliding\"]\n"), 1);
  EXPECT_EQ(rigid("ends = [\"sliding\", \"pinned\"]\n"), 0);
  EXPECT_EQ(rigid("ends = [\"free\", \"free\"]\n[[beam.support]]\nposition = 0.3\nkind = "
                  "\"pinned\"\n"),
            1);
  // A soft spring is no null space.
  EXPECT_EQ(rigid("ends = [\"free\", \"free\"]\n[[beam.support]]\nposition = 0.3\ntranslational = "
                  "1e-6\nrotational = 1e-6\n"),
            0);
  // Tension keeps a free beam from turning.
  EXPECT_EQ(rigid("ends = [\"free\", \"free\"]\ntension = 10\n"), 1);
}

// A rigid bar on a pin and a stiff beam: frequency of turning against a spring at the end,
// w^2 = k L^2/(m L^3/3), up to what bends.
TEST(SpanModes, OfAStiffBeamOnASoftSpring) {
  const Scene scene = scene_of(kStrip +
                               "modes = 1\nends = [\"pinned\", \"free\"]\n"
                               "[[beam.support]]\ntranslational = 1e-5\n");
  const double mass = 7800 * 0.02 * 0.004 * 0.8;
  EXPECT_NEAR(omega_of(scene)[0] / std::sqrt(3.0 * 1e-5 / mass), 1.0, 1e-8);
}

// Stiffnesses of 12 decades: rods of a hundredth and ten thousandths of the thickness.
TEST(SpanModes, OfExtremeRatios) {
  // Half of the beam as good as rigid: a cantilever of the other half.
  const Scene scene = scene_of(
      "[beam]\nlength = 0.8\nyoungs_modulus = 2e11\ndensity = 7800\nmodes = 4\n"
      "[[beam.piece]]\nto = 0.4\nsection = { shape = \"rectangle\", width = 0.02, height = 10.0 }\n"
      "[[beam.piece]]\nsection = { shape = \"rectangle\", width = 0.02, height = 0.001 }\n");
  const double unit = std::sqrt(2e11 * 1e-6 / 12.0 / 7800.0) / (0.4 * 0.4);
  const double b[] = {1.8751040687119611664, 4.6940911329741745764, 7.8547574382376125649};
  for (int j = 0; j < 3; ++j) EXPECT_NEAR(omega_of(scene)[j] / (b[j] * b[j] * unit), 1.0, 1e-7);
}

TEST(SpanModes, CompressionLowersTheFrequenciesUntilItBuckles) {
  const std::string pinned = kStrip + "modes = 3\nends = [\"pinned\", \"pinned\"]\n";
  const double critical = kPi * kPi * 2e11 * 0.02 * std::pow(0.004, 3) / 12.0 / 0.64;
  const double mass = 7800 * 0.02 * 0.004;
  const auto loaded = [&](double part) {
    return scene_of(pinned, {"beam.tension=" + std::to_string(-part * critical)});
  };
  const double alone = std::sqrt(critical / mass) * kPi / 0.8;
  EXPECT_NEAR(omega_of(loaded(0.99))[0] / (alone * 0.1), 1.0, 1e-6);
  try {
    span_modes(loaded(1.01));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("buckles under a compression of 328.987"),
              std::string::npos)
        << error.what();
  }
}

// Rates of frequencies, shapes, inertia and load, against differences of sixth order.
void expect_rates(const Scene& scene, double tolerance, int least) {
  const auto numbers = [](const SpanModes& modes) {
    return std::visit(
        [](const auto& has) {
          const Vector omega = has.omega();
          Vector all(5 * omega.size());
          all << omega, has.shapes(0.55), has.shapes(0.71), has.inertia(), has.load();
          return all;
        },
        modes);
  };
  int moved = 0;
  for (const std::string& name : parameter_names(scene)) {
    const double value = *find_parameter(scene, name);
    const double h = 3e-4 * (value == 0.0 ? 1.0 : std::abs(value));
    Vector difference;
    try {
      const auto at = [&](double p) { return numbers(span_modes(with_parameter(scene, name, p))); };
      // Of sixth order: two frequencies that pass each other bend the shapes within a percent.
      difference = (16.0 * support::central_difference(at, value, 0.5 * h) -
                    support::central_difference(at, value, h)) /
                   15.0;
    } catch (const InputError&) {
      continue;
    }
    ++moved;
    const Scene direction = parameter_direction(scene, name);
    const Vector here = numbers(span_modes(scene));
    const Vector rate = std::visit(
        [](const auto& has) {
          const Vector omega = has.omega_rate();
          Vector all(5 * omega.size());
          all << omega, has.shape_rates(0.55, 0.0), has.shape_rates(0.71, 0.0), has.inertia_rate(),
              has.load_rate();
          return all;
        },
        span_modes(scene, &direction));
    for (Eigen::Index k = 0; k < 5; ++k) {
      const Eigen::Index n = here.size() / 5;
      const double size =
          here.segment(k * n, n).cwiseAbs().maxCoeff() / (value == 0.0 ? 1.0 : std::abs(value));
      EXPECT_LE((rate - difference).segment(k * n, n).cwiseAbs().maxCoeff(), tolerance * size)
          << name << ", quantity " << k << "\n"
          << rate.segment(k * n, n).transpose() << "\n"
          << difference.segment(k * n, n).transpose();
    }
  }
  EXPECT_GE(moved, least);
}

TEST(SpanRates, OfEveryNumber) {
  for (const char* name : {"tip_mass", "two_spans", "stepped", "on_springs", "tensioned",
                           "compressed", "wedge", "string_with_mass", "bar_on_spring"}) {
    SCOPED_TRACE(name);
    expect_rates(
        support::reference_scene(std::string("beams/") + name,
                                 {std::string(name).starts_with("string") ? "string.modes=4"
                                  : std::string(name).starts_with("bar")  ? "bar.modes=4"
                                                                          : "beam.modes=4"}),
        2e-8, 5);
  }
}

// Sections, pieces, supports, springs and masses in one; rigid motions whose centre moves.
TEST(SpanRates, OfAllTogether) {
  const std::string text =
      "[beam]\nlength = 0.9\nyoungs_modulus = 2e11\ndensity = 7800\nmodes = 5\ntension = 200\n"
      "ends = [\"pinned\", \"free\"]\n"
      "section = { shape = \"rectangle\", width = [0.02, 0.03], height = 0.006 }\n"
      "[[beam.piece]]\nto = 0.3\n"
      "[[beam.piece]]\nto = 0.6\nsection = { shape = \"tube\", diameter = [0.02, 0.01], "
      "inner_diameter = 0.008 }\nyoungs_modulus = 7e10\n"
      "[[beam.piece]]\ndensity = 3000\n"
      "[[beam.support]]\nposition = 0.25\nkind = \"pinned\"\n"
      "[[beam.support]]\nposition = 0.7\ntranslational = 4000\nrotational = 30\n"
      "[[beam.support]]\nposition = 0.45\nkind = \"sliding\"\n"
      "[[beam.mass]]\nmass = 0.2\ninertia = 1e-4\n"
      "[[beam.mass]]\nposition = 0.5\nmass = 0.1\n";
  expect_rates(scene_of(text), 2e-8, 20);
  expect_rates(scene_of(kStrip + "modes = 5\nends = [\"free\", \"free\"]\n"
                                 "[[beam.mass]]\nposition = 0.3\nmass = 0.2\ninertia = 1e-4\n"),
               2e-8, 7);
}

TEST(SpanRates, OfUniformStringsAndBars) {
  expect_rates(scene_of("[string]\nlength = 0.863\ntension = 191.6\nmass_per_length = 0.0067\n"
                        "modes = 5\n"),
               1e-8, 3);
  for (const std::string ends : {"fixed\", \"free", "free\", \"fixed", "free\", \"free"})
    expect_rates(
        scene_of("[bar]\nlength = 0.9\nyoungs_modulus = 2e11\ndensity = 7800\n"
                 "section = { shape = \"circle\", diameter = 0.01 }\nmodes = 5\nends = [\"" +
                 ends + "\"]\n"),
        1e-8, 4);
}

std::string refusal_of_rates(const Scene& scene, const std::string& name) {
  const Scene direction = parameter_direction(scene, name);
  try {
    span_modes(scene, &direction);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SpanRates, AreRefusedWhereThereAreNone) {
  // A mass on the joint of two pieces, of which only one moves.
  const Scene torn = scene_of(kStrip +
                              "modes = 2\n[[beam.piece]]\nto = 0.3\n[[beam.piece]]\n"
                              "density = 3000\n[[beam.mass]]\nposition = 0.3\nmass = 0.1\n");
  EXPECT_NE(refusal_of_rates(torn, "beam.mass.position").find("meet at one place"),
            std::string::npos);
  EXPECT_EQ(refusal_of_rates(torn, "beam.mass.mass"), "");
  // Two equal halves, parted by a clamp: pairs of one frequency, which a mass on one of them parts.
  const Scene twins = scene_of(kStrip +
                               "modes = 2\nends = [\"pinned\", \"pinned\"]\n"
                               "[[beam.support]]\nposition = 0.4\nkind = \"clamped\"\n"
                               "[[beam.mass]]\nposition = 0.4\nmass = 0.1\n");
  EXPECT_NEAR(omega_of(twins)[1] / omega_of(twins)[0], 1.0, 1e-12);
  EXPECT_EQ(refusal_of_rates(twins, "beam.youngs_modulus"), "");
}

}  // namespace
}  // namespace graze
