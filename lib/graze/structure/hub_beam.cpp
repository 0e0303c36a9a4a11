#include "graze/structure/detail/hub_beam.hpp"

#include <Eigen/Cholesky>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "graze/base/linalg/detail/dense_factors.hpp"
#include "graze/structure/detail/cantilever.hpp"
#include "graze/structure/detail/line.hpp"

namespace graze {
namespace {

// integral of [(1 - x^2)/2 + ratio (1 - x)] f_r' f_j' over [0, 1], f the shapes of unit length and
// mass. Panels over which no shape turns by more than two radians; there 15 nodes integrate a
// product of two to rounding (the error is of order 4^30/2^30/30!).
Matrix stiffening_of(int modes, double ratio) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const auto& nodes = Rule::abscissa();
  const auto& weights = Rule::weights();
  const int panels = static_cast<int>(std::ceil(0.5 * cantilever_wave_number(modes)));
  const double half = 0.5 / panels;
  Matrix sum = Matrix::Zero(modes, modes);
  Matrix slopes(modes, 15);
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = (panel + 0.5) / panels;
    Eigen::Index column = 0;
    const auto add = [&](double x, double weight) {
      const double tension = (1.0 - x) * (0.5 * (1.0 + x) + ratio);
      for (int j = 0; j < modes; ++j)
        slopes(j, column) = std::sqrt(weight * half * tension) * cantilever_slope(j + 1, x);
      ++column;
    };
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      add(middle + half * nodes[k], weights[k]);
      if (nodes[k] > 0.0) add(middle - half * nodes[k], weights[k]);
    }
    sum.noalias() += slopes * slopes.transpose();
  }
  return sum;
}

}  // namespace

HubBeam hub_beam(const Scene& scene) {
  const Beam& beam = *scene.beam();
  const Hub& hub = *scene.hub;
  const double per_length = beam.density * even_section(beam, nullptr).area.value, l = beam.length,
               alpha = hub.radius;
  const double root = std::sqrt(per_length * l);
  HubBeam model;
  model.inertia = hub.inertia + per_length * l * (l * l / 3.0 + alpha * (l + alpha));
  model.coupling.resize(beam.modes);
  model.pull.resize(beam.modes);
  for (int j = 0; j < beam.modes; ++j) {
    // The first moment of a shape is shape''(0)/b^4 = 2/b^2.
    const double b = cantilever_wave_number(j + 1), mean = cantilever_mean(j + 1);
    model.coupling[j] = root * (2.0 * l / (b * b) + alpha * mean);
    model.pull[j] = root * mean;
  }
  model.moment = per_length * l * (alpha + 0.5 * l);
  if (hub.centrifugal) model.stiffening = stiffening_of(beam.modes, alpha / l);
  return model;
}

// With theta = -s.q/J in every elastic mode, K q = w^2 (1 - s s^T/J) q. The singular values of
// L^T K^-1/2, L L^T = 1 - s s^T/J, are 1/w: a matrix of which each column has one size, whose small
// ones Jacobi's method finds as well as its large ones.
HubModes hub_modes(const Vector& omega, const Vector& coupling, double inertia) {
  const Eigen::Index n = omega.size();
  const Matrix mass = Matrix::Identity(n, n) - coupling * (coupling / inertia).transpose();
  const Matrix factor = mass.llt().matrixU();
  const SingularValues<double> factors =
      singular_values<double>(factor * omega.cwiseInverse().asDiagonal());
  HubModes modes{Vector::Zero(n + 1), Vector::Zero(n + 1), Matrix::Zero(n, n + 1)};
  modes.angle[0] = 1.0 / std::sqrt(inertia);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double w = 1.0 / factors.values[j];
    modes.omega[j + 1] = w;
    modes.beam.col(j + 1) = w * factors.right.col(j).cwiseQuotient(omega);
    modes.angle[j + 1] = -coupling.dot(modes.beam.col(j + 1)) / inertia;
  }
  return modes;
}

}  // namespace graze
