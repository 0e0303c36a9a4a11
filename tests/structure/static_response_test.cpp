// What structures give way under constant loads: closed forms of statics, moments integrated by
// another rule, sums over many modes, rates against differences.
#include "graze/structure/static_response.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <functional>

#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/differences.hpp"

namespace graze {
namespace {

// E I = 3, rho A = 0.5 without gravity's sign, L = 2 in simple numbers.
const std::string kBeam =
    "[beam]\nlength = 2.0\nyoungs_modulus = 6.0\nsecond_moment = 0.5\ndensity = 2.0\narea = 0.25\n";
constexpr double kStiffness = 3.0, kMass = 0.5, kStaticLength = 2.0;
const std::string kGravity = "[gravity]\nacceleration = 1.0\n";

std::string stops_at(std::initializer_list<double> places) {
  std::string text;
  for (const double x : places)
    text += fmt::format("[[stop]]\nposition = {:.17g}\ngap = 1.0\nrestitution = 0.5\n", x);
  return text;
}

StaticResponse response(const std::string& text) {
  return *static_response(parse_scene(text + kGravity, "test.toml"));
}

// Of two places x <= y.
void expect_flexibility(const StaticResponse& found, const std::vector<double>& places,
                        const std::function<double(double, double)>& closed) {
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double expected =
          closed(std::min(places[i], places[k]), std::max(places[i], places[k]));
      const double size = found.flexibility.cwiseAbs().maxCoeff();
      EXPECT_NEAR(found.flexibility(Eigen::Index(i), Eigen::Index(k)) / size, expected / size,
                  1e-13)
          << places[i] << " " << places[k];
    }
}

TEST(StaticResponse, OfACantilever) {
  const StaticResponse found = response(kBeam + "modes = 2\n" + stops_at({0.3, 1.1, 2.0}));
  expect_flexibility(found, {0.3, 1.1, 2.0},
                     [](double x, double y) { return x * x * (3.0 * y - x) / (6.0 * kStiffness); });
  int i = 0;
  for (const double x : {0.3, 1.1, 2.0})
    EXPECT_NEAR(found.under_gravity[i++] /
                    (kMass * x * x *
                     (6.0 * kStaticLength * kStaticLength - 4.0 * kStaticLength * x + x * x) /
                     (24.0 * kStiffness)),
                1.0, 1e-13);
}

TEST(StaticResponse, OfAPinnedBeam) {
  const StaticResponse found =
      response(kBeam + "modes = 2\nends = [\"pinned\", \"pinned\"]\n" + stops_at({0.4, 1.3}));
  expect_flexibility(found, {0.4, 1.3}, [](double x, double y) {
    return x * (kStaticLength - y) *
           (kStaticLength * kStaticLength - x * x - (kStaticLength - y) * (kStaticLength - y)) /
           (6.0 * kStiffness * kStaticLength);
  });
}

// Tip of a cantilever under tension T: [L - tanh(kL)/k]/T, k^2 = T/EI; under compression tan.
TEST(StaticResponse, OfABeamUnderTension) {
  for (const double tension : {0.8, -0.8}) {
    const StaticResponse found =
        response(kBeam + fmt::format("modes = 2\ntension = {}\n", tension) + stops_at({2.0}));
    const double k = std::sqrt(std::abs(tension) / kStiffness);
    const double turned =
        tension > 0.0 ? std::tanh(k * kStaticLength) : std::tan(k * kStaticLength);
    EXPECT_NEAR(found.flexibility(0, 0) / ((kStaticLength - turned / k) / tension), 1.0, 1e-12);
  }
}

TEST(StaticResponse, OfStringsAndBars) {
  const std::string string = "[string]\nlength = 2.0\ntension = 7.0\nmass_per_length = 0.5\n";
  expect_flexibility(
      response(string + "modes = 3\n" + stops_at({0.25, 1.5})), {0.25, 1.5},
      [](double x, double y) { return x * (kStaticLength - y) / (7.0 * kStaticLength); });
  const std::string bar =
      "[bar]\nlength = 2.0\nyoungs_modulus = 7.0\ndensity = 0.5\narea = 1.0\nmodes = 3\n";
  const StaticResponse hanging = response(bar + stops_at({0.25, 2.0}));
  expect_flexibility(hanging, {0.25, 2.0}, [](double x, double) { return x / 7.0; });
  EXPECT_NEAR(hanging.under_gravity[1] / (0.5 * kStaticLength * kStaticLength / (2.0 * 7.0)), 1.0,
              1e-13);
  // Free: held by its own inertia, which does not bend it under gravity.
  const StaticResponse free =
      response(bar + "ends = [\"free\", \"free\"]\n" + stops_at({0.0, 0.5, 2.0}));
  expect_flexibility(free, {0.0, 0.5, 2.0}, [](double x, double y) {
    return kStaticLength / 7.0 *
           ((x * x + y * y) / (2.0 * kStaticLength * kStaticLength) - y / kStaticLength +
            1.0 / 3.0);
  });
  EXPECT_LT(free.under_gravity.cwiseAbs().maxCoeff(), 1e-15);
}

// Deflection at the tip of a wedge: integral of the moment squared over E I, by another rule.
TEST(StaticResponse, OfATaperedBeam) {
  const StaticResponse found = response(
      "[beam]\nlength = 2.0\nyoungs_modulus = 6.0\ndensity = 2.0\nmodes = 2\n"
      "section = { shape = \"rectangle\", width = 0.5, height = [0.6, 0.05] }\n" +
      stops_at({2.0}));
  boost::math::quadrature::tanh_sinh<double> rule;
  const double expected = rule.integrate(
      [](double x) {
        const double height = 0.6 - 0.55 * x / kStaticLength;
        return std::pow(kStaticLength - x, 2.0) / (6.0 * 0.5 * std::pow(height, 3.0) / 12.0);
      },
      0.0, kStaticLength);
  EXPECT_NEAR(found.flexibility(0, 0) / expected, 1.0, 1e-11);
}

// Everything at once: what all modes make of it, whose rest falls like 1/N^3.
TEST(StaticResponse, IsTheSumOverAllModes) {
  for (const std::string more :
       {"ends = [\"free\", \"free\"]\n", "ends = [\"pinned\", \"free\"]\n",
        "ends = [\"free\", \"free\"]\n[[beam.support]]\nposition = 0.3\ntranslational = 2.0\n"
        "[[beam.mass]]\nposition = 1.2\nmass = 0.2\ninertia = 0.1\n",
        "ends = [\"free\", \"sliding\"]\ntension = 2.0\n"}) {
    SCOPED_TRACE(more);
    const Scene scene =
        parse_scene(kBeam + "modes = 60\n" + more + stops_at({0.1, 1.7}) + kGravity, "test.toml");
    const StaticResponse whole = *static_response(scene);
    const StaticResponse sum = static_response_of_modes(modal_model(scene));
    const double size = whole.flexibility.cwiseAbs().maxCoeff();
    EXPECT_LT((whole.flexibility - sum.flexibility).cwiseAbs().maxCoeff() / size, 1e-5);
    EXPECT_GT(whole.flexibility(0, 0), sum.flexibility(0, 0));
    EXPECT_GT(whole.flexibility(1, 1), sum.flexibility(1, 1));
    EXPECT_LT((whole.under_gravity - sum.under_gravity).cwiseAbs().maxCoeff(), 1e-6 * size);
  }
}

TEST(StaticResponse, OfModesAloneIsNotKnown) {
  EXPECT_FALSE(static_response(parse_scene("[modal]\nfrequencies = [1.0]\n", "test.toml")));
  EXPECT_FALSE(static_response(
      parse_scene("[string]\nlength = 2.0\nfrequencies = [3.0, 6.1]\nmass_per_length = 0.5\n"
                  "modes = 2\n" +
                      stops_at({0.5}),
                  "test.toml")));
}

// What the modes leave out, and how it changes with every number that can be moved both ways.
int expect_rates(const Scene& scene) {
  const auto numbers = [](const StaticResponse& all) {
    Vector list(all.flexibility.size() + all.under_gravity.size());
    list << all.flexibility.reshaped(), all.under_gravity;
    return list;
  };
  int moved = 0;
  for (const std::string& name : parameter_names(scene)) {
    if (leaves_structure(name)) continue;
    const double value = *find_parameter(scene, name), h = 5e-4 * std::abs(value);
    const auto at = [&](double p) {
      const Scene there = with_parameter(scene, name, p);
      return numbers(residual_response(*static_response(there), modal_model(there)));
    };
    const Scene direction = parameter_direction(scene, name);
    const ModalModel model = modal_model(scene);
    Vector difference;
    try {
      difference = support::central_difference(at, value, h);
    } catch (const InputError&) {
      continue;  // at the edge of its range
    }
    ++moved;
    const Vector rate = numbers(
        residual_response_rate(scene, direction, model, modal_tangent(scene, model, direction)));
    const double size = std::max(rate.cwiseAbs().maxCoeff(), at(value).cwiseAbs().maxCoeff());
    // The difference rounds by 1e-11 of the frequencies over the step.
    EXPECT_LT((rate - difference).cwiseAbs().maxCoeff() / size, 2e-8) << name;
  }
  return moved;
}

TEST(StaticResponse, HasRatesByEveryNumber) {
  EXPECT_EQ(expect_rates(
                parse_scene(kBeam + "modes = 3\n" + stops_at({0.7, 1.6}) + kGravity, "test.toml")),
            7);
  EXPECT_EQ(expect_rates(parse_scene(
                kBeam +
                    "modes = 3\nends = [\"free\", \"free\"]\ntension = 0.4\n[[beam.support]]\n"
                    "position = 0.35\nkind = \"pinned\"\n[[beam.support]]\nposition = 1.8\n"
                    "translational = 5.0\nrotational = 0.5\n[[beam.mass]]\nposition = 1.2\n"
                    "mass = 0.2\ninertia = 0.1\n" +
                    stops_at({0.7, 1.6}) + kGravity,
                "test.toml")),
            15);
  // A turn about a pin that moves.
  EXPECT_EQ(expect_rates(parse_scene(kBeam +
                                         "modes = 3\nends = [\"free\", \"free\"]\n"
                                         "[[beam.support]]\nposition = 0.35\nkind = \"pinned\"\n" +
                                         stops_at({0.7, 1.6}) + kGravity,
                                     "test.toml")),
            8);
  EXPECT_EQ(expect_rates(parse_scene("[bar]\nlength = 2.0\nyoungs_modulus = 7.0\ndensity = 0.5\n"
                                     "area = 1.0\nmodes = 3\nends = [\"free\", \"free\"]\n" +
                                         stops_at({0.25, 1.5}) + kGravity,
                                     "test.toml")),
            6);
}

// A stop at the end of a beam, which a length leaves behind, and at the end of a piece and on a
// mass that stay: differences to the side on which the stop may be.
TEST(StaticResponse, HasRatesWhereElementsMeetAnyway) {
  const auto expect = [](const std::string& text, const char* name, double h) {
    const Scene scene = parse_scene(text, "test.toml");
    const double value = *find_parameter(scene, name);
    const auto at = [&](int steps) {
      const Scene there = with_parameter(scene, name, value + steps * h);
      return residual_response(*static_response(there), modal_model(there)).flexibility(0, 0);
    };
    const double difference =
        (-25.0 * at(0) + 48.0 * at(1) - 36.0 * at(2) + 16.0 * at(3) - 3.0 * at(4)) / (12.0 * h);
    const ModalModel model = modal_model(scene);
    const Scene direction = parameter_direction(scene, name);
    const double rate =
        residual_response_rate(scene, direction, model, modal_tangent(scene, model, direction))
            .flexibility(0, 0);
    EXPECT_NEAR(rate / difference, 1.0, 1e-6) << name;
  };
  expect(kBeam + "modes = 2\n" + stops_at({2.0}), "beam.length", 1e-3);
  expect(kBeam + "modes = 2\n" + stops_at({2.0}), "stop.position", -1e-3);
  expect(kBeam + "modes = 2\nends = [\"free\", \"free\"]\n" + stops_at({0.0}), "stop.position",
         1e-3);
  const std::string more =
      "modes = 2\n[[beam.mass]]\nposition = 1.2\nmass = 0.2\n" + stops_at({1.2});
  expect(kBeam + more, "stop.position", 1e-3);
  expect(kBeam + more, "beam.mass.position", 1e-3);
}

}  // namespace
}  // namespace graze
