// Known parameters are found again, and lie in the 95 % intervals as often as these promise: of 100
// noisy records at least 90 (with 95 the chance of fewer is 0.028 for one interval; the seeds are
// fixed).
#include <gtest/gtest.h>

#include <cmath>

#include "noisy.hpp"

namespace graze {
namespace {

constexpr int kSeeds = 100, kEnough = 90;

// How many of the fits' intervals hold the true value, for each parameter.
class Coverage {
 public:
  explicit Coverage(std::vector<double> truth) : truth_(std::move(truth)) {
    inside_.assign(truth_.size(), 0);
  }
  void add(const FitResult& result) {
    ASSERT_EQ(result.end, FitEnd::kFitted) << result.message;
    ASSERT_EQ(result.parameters.size(), truth_.size());
    for (std::size_t j = 0; j < truth_.size(); ++j) {
      const FittedParameter& parameter = result.parameters[j];
      ASSERT_TRUE(parameter.uncertainty.has_value()) << parameter.name;
      const bool in = parameter.interval_low <= truth_[j] && truth_[j] <= parameter.interval_high;
      inside_[j] += in ? 1 : 0;
      // Not by being wide.
      EXPECT_LT(*parameter.uncertainty, widest * std::abs(truth_[j])) << parameter.name;
    }
  }
  void expect() const {
    for (std::size_t j = 0; j < truth_.size(); ++j) {
      EXPECT_GE(inside_[j], kEnough) << "parameter " << j;
      // Intervals that always hold the truth are too wide: with 95 the chance of 100 is 0.006.
      EXPECT_LT(inside_[j], kSeeds) << "parameter " << j;
    }
  }

  double widest = 0.1;  // that an uncertainty may be, as a part of its value

 private:
  std::vector<double> truth_;
  std::vector<int> inside_;
};

Scene bouncing_ball(const std::string& stop) {
  return parse_scene(
      "[modal]\nfrequencies = [0.0]\ninertia = [1.0]\n[gravity]\nacceleration = 9.81\n[[stop]]\n"
      "shape = [1.0]\n" +
          stop,
      "ball");
}

TEST(Recovery, OfRestitutionCoefficients) {
  const Scene scene = bouncing_ball("gap = 0.5\nrestitution = [0.5, 0.0, 0.0]\n");
  const Vector speeds = Vector::LinSpaced(25, 0.1, 2.5);
  const Vector law = 0.9 - 0.15 * speeds.array() - 0.03 * speeds.array().square();
  Coverage coverage({0.9, 0.15, 0.03});
  coverage.widest = 0.5;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Noise noise(seed);
    Vector values = law;
    for (double& value : values) value += 0.01 * noise();
    coverage.add(fit(scene, restitutions(speeds, values), fit_options({})));
  }
  coverage.expect();
}

// The times of a ball that is dropped from h with restitution r, by hand: after the fall of t0 =
// sqrt(2 h/g) every flight lasts 2 t0 r^k.
Vector bounce_times(double h, double r, int count) {
  Vector times(count);
  double time = std::sqrt(2.0 * h / 9.81), flight = 2.0 * time;
  for (double& value : times) {
    value = time;
    flight *= r;
    time += flight;
  }
  return times;
}

TEST(Recovery, OfDropAndRestitutionFromImpactTimes) {
  const Scene scene = bouncing_ball("gap = 0.8\nrestitution = 0.7\n");
  const Vector exact = bounce_times(1.0, 0.8, 12);
  Coverage coverage({1.0, 0.8});
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Noise noise(seed);
    Vector times = exact;
    for (double& value : times) value += 1e-3 * noise();
    coverage.add(fit(scene, impacts(times),
                     fit_options({{"stop.gap", 0.2, 3.0}, {"stop.restitution", 0.3, 1.0}})));
  }
  coverage.expect();
}

// x'' + 2 zeta w x' + w^2 x = 0 from x = 0 at speed 1, far from its stop:
// x = e^{-zeta w t} sin(w_d t)/w_d.
TEST(Recovery, OfFrequencyAndDampingFromAResponse) {
  const Scene scene = parse_scene(
      "[modal]\nfrequencies = [9.0]\ndamping_ratios = [0.02]\n[[stop]]\nshape = [1.0]\ngap = 1.0\n"
      "restitution = 0.5\n[initial]\nqdot = [1.0]\n",
      "oscillator");
  const double w = 10.0, zeta = 0.05, damped = w * std::sqrt(1.0 - zeta * zeta);
  const Vector at = Vector::LinSpaced(120, 0.0, 2.0);
  const Vector exact = (-zeta * w * at.array()).exp() * (damped * at.array()).sin() / damped;
  Coverage coverage({w, zeta});
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Noise noise(seed);
    Vector values = exact;
    for (double& value : values) value += 0.003 * noise();
    coverage.add(fit(
        scene, response("displacement1", Quantity::kDisplacement, at, values),
        fit_options({{"modal.frequencies.1", 5.0, 20.0}, {"modal.damping_ratios.1", 0.0, 0.3}})));
  }
  coverage.expect();
}

// Between its impacts the ball falls: u = h - v s + g s^2/2, s the time since the last of them, v
// the speed that it left with, g t0 r^k.
Vector bouncing(const Vector& at, double h, double r) {
  const double fall = std::sqrt(2.0 * h / 9.81);
  return at.unaryExpr([&](double t) {
    if (t <= fall) return 4.905 * t * t;
    double since = t - fall, speed = 9.81 * fall * r;
    while (since > 2.0 * speed / 9.81) {
      since -= 2.0 * speed / 9.81;
      speed *= r;
    }
    return h - speed * since + 4.905 * since * since;
  });
}

// Kinks of the displacement at impacts that come and go between the samples.
TEST(Recovery, OfDropAndRestitutionFromADisplacement) {
  const Scene scene = bouncing_ball("gap = 0.9\nrestitution = 0.7\n");
  const Vector at = Vector::LinSpaced(150, 0.0, 3.0);
  const Vector exact = bouncing(at, 1.0, 0.8);
  Coverage coverage({1.0, 0.8});
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Noise noise(seed);
    Vector values = exact;
    for (double& value : values) value += 0.01 * noise();
    coverage.add(fit(scene, response("displacement1", Quantity::kDisplacement, at, values),
                     fit_options({{"stop.gap", 0.5, 2.0}, {"stop.restitution", 0.3, 1.0}})));
  }
  coverage.expect();
}

// A contact has no closed form with these laws: the force is integrated here, by Runge and Kutta's
// method with steps of 1/200 of a sample, an error below 1e-9 of the force.
struct ContactRecord {
  Vector at, force;
};
ContactRecord contact(double stiffness, double exponent, double coefficient, int samples,
                      double spacing) {
  ContactRecord record{Vector(samples), Vector(samples)};
  double x = 0.0, v = 0.5;
  const auto force = [&](double depth, double speed) {
    if (depth <= 0.0) return 0.0;
    return std::max(std::pow(depth, exponent) * (stiffness + coefficient * speed), 0.0);
  };
  constexpr int kSteps = 200;
  const double h = spacing / kSteps;
  for (int i = 0; i < samples; ++i) {
    record.at[i] = spacing * i;
    record.force[i] = force(x, v);
    for (int k = 0; k < kSteps; ++k) {
      const double k1x = v, k1v = -force(x, v);
      const double k2x = v + 0.5 * h * k1v, k2v = -force(x + 0.5 * h * k1x, v + 0.5 * h * k1v);
      const double k3x = v + 0.5 * h * k2v, k3v = -force(x + 0.5 * h * k2x, v + 0.5 * h * k2v);
      const double k4x = v + h * k3v, k4v = -force(x + h * k3x, v + h * k3v);
      x += h / 6.0 * (k1x + 2.0 * k2x + 2.0 * k3x + k4x);
      v += h / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
    }
  }
  return record;
}

Scene hammer() {
  return parse_scene(
      "[modal]\nfrequencies = [0.0]\n[[stop]]\nshape = [1.0]\ngap = 0.0\n[stop.spring]\n"
      "stiffness = 3e6\nexponent = 1.4\n"
      "damping = { model = \"hunt-crossley\", coefficient = 1e6 }\n[initial]\nqdot = [0.5]\n",
      "hammer");
}

const std::vector<SoughtParameter> kContactLaw = {{"stop.spring.stiffness", 1e5, 1e8},
                                                  {"stop.spring.exponent", 1.0, 2.0},
                                                  {"stop.spring.damping.coefficient", 0.0, 1e8}};

TEST(Recovery, OfStiffnessExponentAndDampingFromAForceRecord) {
  const double stiffness = 5e6, exponent = 1.5, coefficient = 3e6;
  const ContactRecord record = contact(stiffness, exponent, coefficient, 36, 3e-4);
  Coverage coverage({stiffness, exponent, coefficient});
  coverage.widest = 0.2;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Noise noise(seed);
    Vector values = record.force;
    for (double& value : values) value += 0.5 * noise();
    coverage.add(fit(hammer(), response("force1", Quantity::kForce, record.at, values),
                     fit_options(kContactLaw)));
  }
  coverage.expect();
}

// Impact times of a mass on a spring k with a stop at `gap`, thrown from u = 0 at `speed`: from the
// stop at the speed r v it comes back after the turn 2 pi - 2 arctan(r v/(w gap)).
Vector thrown_times(double mass, double k, double gap, double r, double speed, int count) {
  const double w = std::sqrt(k / mass);
  Vector times(count);
  times[0] = std::asin(gap * w / speed) / w;
  double v = std::sqrt(speed * speed - w * w * gap * gap);
  for (int i = 1; i < count; ++i) {
    v *= r;
    times[i] = times[i - 1] + (2.0 * M_PI - 2.0 * std::atan2(v / w, gap)) / w;
  }
  return times;
}

// Without noise there is nothing but rounding to blame.
TEST(Recovery, IsExactWithoutNoise) {
  const auto expect = [](const FitResult& result, const std::vector<double>& truth,
                         double tolerance) {
    ASSERT_EQ(result.end, FitEnd::kFitted) << result.message;
    for (std::size_t j = 0; j < truth.size(); ++j)
      EXPECT_NEAR(result.parameters[j].value, truth[j], tolerance * std::abs(truth[j]))
          << result.parameters[j].name;
  };
  const Vector speeds = Vector::LinSpaced(9, 0.2, 1.8);
  expect(fit(bouncing_ball("gap = 0.5\nrestitution = [0.5, 0.0]\n"),
             restitutions(speeds, 0.9 - 0.15 * speeds.array()), fit_options({})),
         {0.9, 0.15}, 1e-13);
  expect(fit(bouncing_ball("gap = 0.8\nrestitution = 0.7\n"), impacts(bounce_times(1.0, 0.8, 12)),
             fit_options({{"stop.gap", 0.2, 3.0}, {"stop.restitution", 0.3, 1.0}})),
         {1.0, 0.8}, 1e-12);
  // A mass on a spring that is thrown at a stop: what its start in m/s is in the modes depends on
  // the mass that is sought.
  expect(fit(parse_scene("[lumped]\nmasses = [1.7]\n[[lumped.spring]]\nbetween = [0, 1]\n"
                         "stiffness = 50.0\n[[stop]]\nmass = 1\ngap = 0.1\nrestitution = 0.8\n"
                         "[initial]\nvelocity = [2.0]\n",
                         "thrown"),
             impacts(thrown_times(2.0, 50.0, 0.1, 0.8, 2.0, 8)),
             fit_options({{"lumped.masses.1", 1.0, 4.0}})),
         {2.0}, 1e-12);
  // A mass of 1 kg meets a linear spring at 0.5 m/s: x = 0.5 sin(w t)/w until w t = pi, then it is
  // gone. With contact errors of 1e-12 of the speed.
  const double w = 300.0;
  const Vector at = Vector::LinSpaced(40, 0.0, 0.02);
  const Vector depth =
      (0.5 / w * (w * at.array()).sin()).max(0.0) * (w * at.array() < M_PI).cast<double>();
  const Scene spring = parse_scene(
      "[modal]\nfrequencies = [0.0]\n[[stop]]\nshape = [1.0]\ngap = 0.0\n[stop.spring]\n"
      "stiffness = 5e4\nexponent = 1.0\n[initial]\nqdot = [0.5]\n",
      "spring");
  expect(fit(spring, response("penetration1", Quantity::kPenetration, at, depth),
             fit_options({{"stop.spring.stiffness", 1e4, 1e6}})),
         {w * w}, 1e-10);
  // Of the integration above and of the contact itself, 1e-9 of the force.
  const ContactRecord record = contact(5e6, 1.5, 3e6, 60, 2e-4);
  expect(fit(hammer(), response("force1", Quantity::kForce, record.at, record.force),
             fit_options(kContactLaw)),
         {5e6, 1.5, 3e6}, 1e-6);
}

}  // namespace
}  // namespace graze
