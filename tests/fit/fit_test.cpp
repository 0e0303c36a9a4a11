// The fit as a whole: its numbers against formulas by hand, and what it says where it cannot.
#include "graze/fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/scene/parameter.hpp"
#include "noisy.hpp"

namespace graze {
namespace {

Scene ball(const std::string& restitution) {
  return parse_scene(
      "[modal]\nfrequencies = [0.0]\ninertia = [1.0]\n[gravity]\nacceleration = 9.81\n[[stop]]\n"
      "shape = [1.0]\ngap = 1.0\nrestitution = " +
          restitution + "\n",
      "ball");
}

// A free oscillation far from its stop.
Scene oscillator() {
  return parse_scene(
      "[modal]\nfrequencies = [10.0]\ndamping_ratios = [0.05]\n[[stop]]\nshape = [1.0]\ngap = 1.0\n"
      "restitution = 0.5\n[initial]\nqdot = [1.0]\n",
      "oscillator");
}

Vector oscillation(const Vector& at, double w, double zeta) {
  const double damped = w * std::sqrt(1.0 - zeta * zeta);
  return (-zeta * w * at.array()).exp() * (damped * at.array()).sin() / damped;
}

Measurements oscillation_data(double w = 10.0, double zeta = 0.05, double noise_size = 0.0) {
  const Vector at = Vector::LinSpaced(60, 0.02, 1.2);
  Vector values = oscillation(at, w, zeta);
  Noise noise(7);
  for (double& value : values) value += noise_size * noise();
  return response("displacement1", Quantity::kDisplacement, at, values);
}

bool says(const std::vector<std::string>& sentences, const std::string& part) {
  return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
    return sentence.find(part) != std::string::npos;
  });
}

std::string error_of(const Scene& scene, const Measurements& data,
                     std::vector<SoughtParameter> parameters) {
  try {
    fit(scene, data, fit_options(std::move(parameters)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// r = a0 - a1 v through (1, 0.8), (2, 0.7), (4, 0.45), (5, 0.4): with mean speed 3 and mean 0.5875,
// S_vv = 10, S_ve = (-2)(0.2125) + (-1)(0.1125) + (1)(-0.1375) + (2)(-0.1875) = -1.05, so a1 =
// 0.105, a0 = 0.5875 + 0.315 = 0.9025; residuals 0.0025, 0.0075, -0.0325, 0.0225 (e - r), sum of
// squares 0.001625, s^2 = 0.0008125. Var a1 = s^2/10, var a0 = s^2 (1/4 + 9/10), cov(a0, a1) = 3
// s^2/10.
TEST(Fit, OfAStraightLineIsThatByHand) {
  const FitResult result =
      fit(ball("[0.5, 0.0]"),
          restitutions(Eigen::Vector4d(1, 2, 4, 5), Eigen::Vector4d(0.8, 0.7, 0.45, 0.4)),
          fit_options({}));
  ASSERT_EQ(result.end, FitEnd::kFitted);
  EXPECT_NEAR(result.parameters[0].value, 0.9025, 1e-14);
  EXPECT_NEAR(result.parameters[1].value, 0.105, 1e-14);
  EXPECT_EQ(result.freedom, 2);
  EXPECT_NEAR(result.series[0].noise, std::sqrt(0.0008125), 1e-14);
  const double a0 = std::sqrt(0.0008125 * 1.15), a1 = std::sqrt(0.00008125);
  EXPECT_NEAR(*result.parameters[0].uncertainty, a0, 1e-14);
  EXPECT_NEAR(*result.parameters[1].uncertainty, a1, 1e-14);
  EXPECT_NEAR(result.correlations(0, 1), 0.3 / std::sqrt(1.15 * 0.1), 1e-13);
  // Student's t with two degrees of freedom: 4.303.
  EXPECT_NEAR(result.parameters[1].interval_high, 0.105 + 4.303 * a1, 1e-3 * a1);
  EXPECT_NEAR(result.series[0].measured[2] - result.series[0].predicted[2], -0.0325, 1e-14);
  EXPECT_EQ(result.parameters[1].unit, "s/m");
  ASSERT_TRUE(result.fitted.has_value());
  EXPECT_NEAR(result.fitted->stops[0].restitution[1], 0.105, 1e-14);
}

// With weights w = 1/sigma^2 = 1, 1, 4, 4: S = 10, S_v = 39, S_vv = 169, S_e = 4.9, S_ve = 17.4
// (0.8 + 1.4 + 7.2 + 8.0), determinant 10*169 - 39^2 = 169. a0 = (169*4.9 - 39*17.4)/169, slope =
// (10*17.4 - 39*4.9)/169; variances 169/169 and 10/169, covariance -39/169 with the slope.
TEST(Fit, WeighsByKnownUncertainties) {
  Measurements data =
      restitutions(Eigen::Vector4d(1, 2, 4, 5), Eigen::Vector4d(0.8, 0.7, 0.45, 0.4));
  data.series[0].uncertainty = Eigen::Vector4d(1, 1, 0.5, 0.5);
  const FitResult result = fit(ball("[0.5, 0.0]"), data, fit_options({}));
  ASSERT_EQ(result.end, FitEnd::kFitted);
  EXPECT_NEAR(result.parameters[0].value, (169.0 * 4.9 - 39.0 * 17.4) / 169.0, 1e-14);
  EXPECT_NEAR(result.parameters[1].value, -(10.0 * 17.4 - 39.0 * 4.9) / 169.0, 1e-14);
  EXPECT_NEAR(*result.parameters[0].uncertainty, 1.0, 1e-14);
  EXPECT_NEAR(*result.parameters[1].uncertainty, std::sqrt(10.0 / 169.0), 1e-14);
  EXPECT_NEAR(result.correlations(0, 1), 39.0 / std::sqrt(1690.0), 1e-13);
  EXPECT_NEAR(result.quantile, 1.959964, 5e-7);
  // Uncertainties of 1 for values that agree to hundredths are too large.
  EXPECT_TRUE(says(result.warnings, "these are too large")) << result.warnings.size();
}

TEST(Fit, OfOneCoefficientKeepsTheOthers) {
  const FitResult result = fit(
      ball("[0.9, 0.0]"), restitutions(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(0.8, 0.7, 0.6)),
      fit_options({{"stop.restitution.2", 0.0, 1.0}}));
  // The slope through (0, 0.9): (1 * 0.1 + 2 * 0.2 + 3 * 0.3)/14.
  EXPECT_NEAR(result.parameters[0].value, 0.1, 1e-14);
}

TEST(Fit, HoldsARestitutionAtItsLimitAndSaysSo) {
  const FitResult result =
      fit(ball("0.5"), restitutions(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1.1, 0.99, 1.0)),
          fit_options({}));
  EXPECT_EQ(result.end, FitEnd::kFitted);
  EXPECT_EQ(result.parameters[0].value, 1.0);
  EXPECT_TRUE(result.parameters[0].at_limit);
  EXPECT_FALSE(result.parameters[0].uncertainty.has_value());
  EXPECT_TRUE(says(result.warnings, "stop.restitution is held at its limit 1"));
}

// u = q, whichever side the stop is on; its gap is 1 - u above and 1 + u below.
TEST(Fit, KnowsEveryColumnOfAResponse) {
  const double w = 10.0, zeta = 0.05;
  const Vector at = Vector::LinSpaced(60, 0.02, 1.2), u = oscillation(at, w, zeta);
  const double damped = w * std::sqrt(1.0 - zeta * zeta);
  const Vector rate =
      (-zeta * w * at.array()).exp() * (damped * at.array()).cos() - zeta * w * u.array();
  for (const double side : {1.0, -1.0}) {
    Scene scene = with_parameter(oscillator(), "modal.frequencies.1", 9.0);
    scene.stops[0].side = side > 0.0 ? Side::kAbove : Side::kBelow;
    const std::vector<std::pair<Quantity, Vector>> columns = {
        {Quantity::kCoordinate, u},
        {Quantity::kRate, rate},
        {Quantity::kDisplacement, u},
        {Quantity::kVelocity, rate},
        {Quantity::kGap, 1.0 - side * u.array()}};
    for (const auto& [quantity, values] : columns) {
      const FitResult result = fit(scene, response("column", quantity, at, values),
                                   fit_options({{"modal.frequencies.1", 8.0, 12.0}}));
      ASSERT_EQ(result.end, FitEnd::kFitted) << result.message;
      EXPECT_NEAR(result.parameters[0].value, w, 1e-10) << static_cast<int>(quantity) << side;
    }
  }
}

TEST(Fit, FindsWhereTheClockOfTheRecordBegan) {
  Measurements data = oscillation_data();
  // The clock began 0.01 s late.
  data.at.array() -= 0.01;
  const FitResult result = fit(oscillator(), data, fit_options({{"record.start", 0.0, 0.05}}));
  ASSERT_EQ(result.end, FitEnd::kFitted) << result.message;
  EXPECT_NEAR(result.parameters[0].value, 0.01, 1e-12);
  EXPECT_EQ(result.parameters[0].unit, "s");
}

TEST(Fit, FindsTheStartOfTheMotion) {
  Measurements data = oscillation_data();
  data.series[0].values *= 1.5;
  const FitResult result = fit(oscillator(), data, fit_options({{"initial.qdot.1", 0.5, 3.0}}));
  ASSERT_EQ(result.end, FitEnd::kFitted) << result.message;
  EXPECT_NEAR(result.parameters[0].value, 1.5, 1e-11);
  EXPECT_NEAR(result.fitted->initial->qdot[0], 1.5, 1e-11);
}

// Neither the gap of a stop that is not met nor its restitution changes anything.
TEST(Fit, SaysWhatTheDataDoNotDetermine) {
  const FitResult result =
      fit(oscillator(), oscillation_data(10.0, 0.05, 1e-3),
          fit_options({{"modal.frequencies.1", 8.0, 12.0}, {"stop.restitution", 0.1, 0.9}}));
  EXPECT_EQ(result.end, FitEnd::kNotDetermined);
  EXPECT_EQ(result.message, "the data do not determine stop.restitution");
  EXPECT_FALSE(result.parameters[1].uncertainty.has_value());
  EXPECT_TRUE(result.parameters[0].uncertainty.has_value());
}

// u = shape q, and q goes as the initial rate: only their product shows.
TEST(Fit, NamesTheCombinationThatTheDataDetermine) {
  const FitResult result =
      fit(oscillator(), oscillation_data(10.0, 0.05, 1e-3),
          fit_options({{"stop.shape.1", 0.5, 2.0}, {"initial.qdot.1", 0.5, 2.0}}));
  EXPECT_EQ(result.end, FitEnd::kNotDetermined);
  EXPECT_EQ(result.message,
            "the data determine only a combination of stop.shape.1 and initial.qdot.1");
}

TEST(Fit, WarnsOfWhatTheModelDoesNotHave) {
  Measurements data = oscillation_data(10.0, 0.05, 1e-3);
  // A slow drift.
  data.series[0].values.array() += 0.02 * data.at.array();
  const FitResult result =
      fit(oscillator(), data, fit_options({{"modal.frequencies.1", 8.0, 12.0}}));
  EXPECT_EQ(result.end, FitEnd::kFitted);
  EXPECT_TRUE(says(result.warnings, "residuals follow one another"));
  data.series[0].uncertainty = Vector::Constant(data.at.size(), 1e-3);
  EXPECT_TRUE(
      says(fit(oscillator(), data, fit_options({{"modal.frequencies.1", 8.0, 12.0}})).warnings,
           "times as large as the uncertainties"));
  const FitResult clean = fit(oscillator(), oscillation_data(10.0, 0.05, 1e-3),
                              fit_options({{"modal.frequencies.1", 8.0, 12.0}}));
  EXPECT_TRUE(clean.warnings.empty()) << clean.warnings.front();
}

TEST(Fit, IsTheSameEveryTime) {
  const auto parameters =
      fit_options({{"modal.frequencies.1", 5.0, 20.0}, {"modal.damping_ratios.1", 0.0, 0.3}});
  const FitResult one = fit(oscillator(), oscillation_data(11.0, 0.1, 1e-3), parameters);
  const FitResult two = fit(oscillator(), oscillation_data(11.0, 0.1, 1e-3), parameters);
  for (int j = 0; j < 2; ++j) {
    EXPECT_EQ(one.parameters[j].value, two.parameters[j].value);
    EXPECT_EQ(one.parameters[j].uncertainty, two.parameters[j].uncertainty);
  }
}

// From 34 rad/s the nearest valley of the sum of squares is not that of 10.
TEST(Fit, SearchesTheBoxIfAsked) {
  const Scene far = with_parameter(oscillator(), "modal.frequencies.1", 34.0);
  FitOptions options = fit_options({{"modal.frequencies.1", 3.0, 40.0}});
  const FitResult local = fit(far, oscillation_data(10.0, 0.05, 1e-4), options);
  EXPECT_GT(std::abs(local.parameters[0].value - 10.0), 1.0);
  options.global = true;
  const FitResult global = fit(far, oscillation_data(10.0, 0.05, 1e-4), options);
  EXPECT_EQ(global.end, FitEnd::kFitted) << global.message;
  EXPECT_NEAR(global.parameters[0].value, 10.0, 0.01);
}

TEST(Fit, SaysHowManyImpactsAreMissing) {
  // A ball that stays on the floor.
  const FitResult result = fit(ball("0.2"), impacts(Eigen::Vector3d(0.45, 1.1, 4.0)),
                               fit_options({{"stop.restitution", 0.0, 1e-9}}));
  EXPECT_EQ(result.end, FitEnd::kNotConverged);
  EXPECT_NE(result.message.find("of 3 measured impacts the motion has"), std::string::npos)
      << result.message;
}

TEST(Fit, EndsAtItsBudgetWithTheBestSoFar) {
  FitOptions options = fit_options({{"modal.frequencies.1", 5.0, 20.0}});
  options.max_evaluations = 5;
  const FitResult result = fit(oscillator(), oscillation_data(12.0), options);
  EXPECT_EQ(result.end, FitEnd::kBudget);
  EXPECT_EQ(result.message, "the budget of 5 evaluations of the model was spent");
  EXPECT_EQ(result.series.size(), 1u);
}

TEST(Fit, RefusesParametersThatCannotBeSought) {
  const Measurements data = oscillation_data();
  EXPECT_NE(error_of(oscillator(), data, {}).find("name at least one parameter"),
            std::string::npos);
  EXPECT_NE(error_of(oscillator(), data, {{"modal.frequency", 1, 2}})
                .find("modal.frequency: the scene has no such continuous parameter"),
            std::string::npos);
  EXPECT_NE(error_of(oscillator(), data, {{"initial.q.2", 1, 2}}).find("allowed are initial.q.1"),
            std::string::npos);
  EXPECT_EQ(error_of(oscillator(), data, {{"stop.gap", 2, 1}}),
            "--parameter stop.gap: LOW must be below HIGH, not 2:1");
  EXPECT_EQ(error_of(oscillator(), data, {{"stop.gap", 1, 2}, {"stop.gap", 1, 2}}),
            "--parameter stop.gap: it is named twice");
  EXPECT_NE(error_of(oscillator(), data, {{"stop.gap", -HUGE_VAL, HUGE_VAL}})
                .find("give the values between which it is sought"),
            std::string::npos);
  EXPECT_NE(error_of(oscillator(), data, {{"stop.restitution", 0.5, 1.5}})
                .find("the scene does not allow the limit 1.5"),
            std::string::npos);
  EXPECT_NE(error_of(oscillator(), data, {{"record.start", -0.03, 1}})
                .find("the record would begin before the motion does; allowed is -0.02 s or more"),
            std::string::npos);
  EXPECT_NE(error_of(ball("0.5"), restitutions(Eigen::Vector2d(1, 2), Eigen::Vector2d(0.5, 0.5)),
                     {{"stop.gap", 0, 1}})
                .find("pairs of speed and restitution say nothing of it"),
            std::string::npos);
}

TEST(Fit, RefusesMeasurementsThatAreTooFew) {
  EXPECT_EQ(error_of(ball("[0.5, 0.0]"),
                     restitutions(Eigen::Vector2d(1, 2), Eigen::Vector2d(0.5, 0.5)), {}),
            "made.csv:2:1: data: 2 values are too few for 2 parameters; at least 3 are needed "
            "where their uncertainty is to be told from them");
  EXPECT_NE(error_of(ball("[0.5, 0.0]"),
                     restitutions(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.5, 0.6, 0.5)), {})
                .find("1 different speed tell no 2 coefficients"),
            std::string::npos);
}

TEST(Fit, RefusesMeasurementsInAnotherUnit) {
  Measurements data = oscillation_data();
  data.series[0].values *= 1000.0;  // mm
  data.places[7] = {"made.csv", 9, 3};
  const std::string message = error_of(oscillator(), data, {{"modal.frequencies.1", 8, 12}});
  // The largest is the eighth, at 0.16 s, a quarter of a period.
  EXPECT_EQ(message.rfind("made.csv:9:3: data: displacement1: the values reach", 0), 0u) << message;
  EXPECT_NE(message.find("units are SI"), std::string::npos) << message;
  data.series[0].values *= 1e-6;
  EXPECT_NE(error_of(oscillator(), data, {{"modal.frequencies.1", 8, 12}}).find("reach only"),
            std::string::npos);
  // A force where nothing is touched.
  data = response("force1", Quantity::kForce, data.at, data.series[0].values);
  EXPECT_NE(error_of(oscillator(), data, {{"stop.gap", 0.5, 1}}).find("zero over the whole record"),
            std::string::npos);
  // Impact times in ms, and where there are no impacts.
  EXPECT_NE(error_of(ball("0.8"), impacts(Eigen::Vector3d(452, 1174, 1752)),
                     {{"stop.restitution", 0.5, 1}})
                .find("units are SI"),
            std::string::npos);
  EXPECT_NE(error_of(oscillator(), impacts(Eigen::Vector3d(1, 2, 3)), {{"stop.gap", 0.5, 1}})
                .find("the model has no impact up to 6 s"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
