// Hertz's stiffness k of two elastic bodies that touch at a point, F = k x^(3/2).
//
// With 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 and the relative principal curvatures A <= B of the
// two surfaces, the bodies touch along an ellipse whose eccentricity e solves
//
//   B/A = [E(e)/(1 - e^2) - K(e)]/[K(e) - E(e)] = (K - D)/[D (1 - e^2)],
//   k = (2 pi E*/3) K(e)^(-3/2) sqrt(D(e)/A),   D = (K - E)/e^2,
//
// K and E the complete elliptic integrals; of two spheres k = (4/3) E* sqrt(R1 R2/(R1 + R2)).
//   K. L. Johnson, Contact Mechanics, Cambridge 1985, section 4.2.
#pragma once

#include <array>
#include <optional>

namespace graze {

struct ElasticBody {
  // m, > 0: of its surface in two planes at right angles; infinite: flat there. Negative: hollow.
  std::array<double, 2> radii{};
  double modulus = 0.0;        // Pa
  double poisson_ratio = 0.0;  // 1
};

// N/m^(3/2). `angle`: between the first planes of the two bodies, rad. Returns nullopt when they do
// not touch at a point (a flat pair, parallel cylinders, a ball in a tighter hollow).
std::optional<double> hertz_stiffness(const ElasticBody& first, const ElasticBody& second,
                                      double angle = 0.0);

}  // namespace graze
