// A beam on a hub: inertia, coupling, stiffening, and the modes of both together.
#include "graze/structure/detail/hub_beam.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "graze/structure/detail/cantilever.hpp"
#include "graze/structure/modal_model.hpp"
#include "support/hub_scene.hpp"

namespace graze {
namespace {

// Simpson's rule on many points: another rule than the program's, on the shapes themselves.
template <class F>
double integral(const F& f) {
  constexpr int kIntervals = 4000;
  double sum = f(0.0) + f(1.0);
  for (int k = 1; k < kIntervals; ++k) sum += (k % 2 == 1 ? 4.0 : 2.0) * f(double(k) / kIntervals);
  return sum / (3.0 * kIntervals);
}

TEST(HubBeam, StiffeningOfTheFirstModeIsSouthwells) {
  // Southwell's coefficients of the first bending mode of a uniform turning beam: 1.193 and 1.571
  // times the ratio of hub to length (W. Carnegie, J. Mech. Eng. Sci. 1, 1959).
  Scene scene = support::strip_on_hub(1);
  scene.hub->radius = 0.0;
  EXPECT_NEAR(hub_beam(scene).stiffening(0, 0), 1.193, 0.0005);
  scene.hub->radius = scene.beam()->length;
  EXPECT_NEAR(hub_beam(scene).stiffening(0, 0), 1.193 + 1.571, 0.001);
}

TEST(HubBeam, StiffeningIsTheWorkOfTheTension) {
  const Scene scene = support::strip_on_hub(5);
  const Matrix c = hub_beam(scene).stiffening;
  const double ratio = scene.hub->radius / scene.beam()->length;
  for (int r = 0; r < 5; ++r)
    for (int j = 0; j < 5; ++j) {
      const double expected = integral([&](double x) {
        return (0.5 * (1.0 - x * x) + ratio * (1.0 - x)) * cantilever_slope(r + 1, x) *
               cantilever_slope(j + 1, x);
      });
      EXPECT_NEAR(c(r, j), expected, 1e-8 * std::sqrt(c(r, r) * c(j, j))) << r << " " << j;
    }
}

TEST(HubBeam, CouplingInertiaAndWeight) {
  const Scene scene = support::strip_on_hub(6);
  const HubBeam model = hub_beam(scene);
  const Beam& beam = *scene.beam();
  const double mass = beam.density * *beam.area * beam.length, l = beam.length;
  for (int j = 0; j < 6; ++j) {
    EXPECT_NEAR(model.coupling[j],
                std::sqrt(mass) * integral([&](double x) {
                  return (l * x + scene.hub->radius) * cantilever_shape(j + 1, x);
                }),
                1e-10);
    EXPECT_NEAR(model.pull[j],
                std::sqrt(mass) * integral([&](double x) { return cantilever_shape(j + 1, x); }),
                1e-10);
  }
  EXPECT_NEAR(model.inertia, 1e-3 + support::beam_inertia(scene), 1e-16);
  EXPECT_NEAR(model.moment, mass * (0.3 + 0.02), 1e-16);
}

TEST(HubBeam, WithoutHubTheBeamIsPinned) {
  // tan b = tanh b, and how far so many clamped modes and the turning of the whole come to it.
  const double pinned = 3.9266023120479187;
  const struct {
    int modes;
    double truncation;
  } cases[] = {{3, 7.7e-5}, {10, 2e-8}};
  for (const auto& [modes, truncation] : cases) {
    Scene scene = support::strip_on_hub(modes);
    scene.hub->radius = scene.hub->inertia = 0.0;
    const HubBeam model = hub_beam(scene);
    const HubModes found = hub_modes(modal_model(scene).omega, model.coupling, model.inertia);
    const Beam& beam = *scene.beam();
    const double unit =
        std::sqrt(beam.youngs_modulus * *beam.second_moment / (beam.density * *beam.area)) /
        (beam.length * beam.length);
    const double excess = found.omega[1] / (pinned * pinned * unit) - 1.0;
    EXPECT_GT(excess, 0.0);  // Rayleigh and Ritz err upwards
    EXPECT_NEAR(excess / truncation, 1.0, 0.1) << modes << " " << excess;
  }
}

TEST(HubBeam, AHubThatHardlyTurnsIsAClamp) {
  Scene scene = support::strip_on_hub(4);
  const Vector clamped = modal_model(scene).omega;
  const HubBeam light = hub_beam(scene);
  const HubModes modes = hub_modes(clamped, light.coupling, 1e9);
  for (int j = 0; j < 4; ++j) {
    // To first order w grows by s^2/(2 J).
    const double growth = 0.5 * light.coupling[j] * light.coupling[j] / 1e9;
    EXPECT_NEAR(modes.omega[j + 1] / clamped[j], 1.0 + growth, 1e-14);
  }
}

// The characteristic equation of one dyad: sum s_j^2 w^2/(w^2 - k_j) = J.
TEST(HubBeam, FrequenciesSolveTheSecularEquation) {
  for (const int modes : {1, 2, 5, 12, 32}) {
    const Scene scene = support::strip_on_hub(modes);
    const Vector clamped = modal_model(scene).omega;
    const HubBeam model = hub_beam(scene);
    const HubModes found = hub_modes(clamped, model.coupling, model.inertia);
    EXPECT_EQ(found.omega[0], 0.0);
    for (int r = 1; r <= modes; ++r) {
      const double w = found.omega[r];
      double sum = -model.inertia, slope = 0.0;
      for (int j = 0; j < modes; ++j) {
        const double s2 = model.coupling[j] * model.coupling[j], k = clamped[j];
        const double apart = (w - k) * (w + k);
        sum += s2 * w * w / apart;
        slope += 2.0 * s2 * w * k * k / (apart * apart);
      }
      EXPECT_LT(std::abs(sum / slope) / w, 1e-13) << modes << " " << r;
    }
  }
}

TEST(HubBeam, ModesAreNormalisedAndKeepTheMomentum) {
  const Scene scene = support::strip_on_hub(8);
  const Vector clamped = modal_model(scene).omega;
  const HubBeam model = hub_beam(scene);
  const HubModes modes = hub_modes(clamped, model.coupling, model.inertia);
  Matrix whole(9, 9), mass(9, 9);
  whole << modes.angle.transpose(), modes.beam;
  mass << model.inertia, model.coupling.transpose(), model.coupling, Matrix::Identity(8, 8);
  EXPECT_LT((whole.transpose() * mass * whole - Matrix::Identity(9, 9)).cwiseAbs().maxCoeff(),
            1e-13);
  const Matrix stiffness = modes.beam.transpose() * clamped.cwiseAbs2().asDiagonal() * modes.beam;
  EXPECT_LT((stiffness - Matrix(modes.omega.cwiseAbs2().asDiagonal())).cwiseAbs().maxCoeff(),
            1e-13 * modes.omega.cwiseAbs2().maxCoeff());
}

}  // namespace
}  // namespace graze
