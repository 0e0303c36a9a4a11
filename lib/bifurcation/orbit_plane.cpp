#include "graze/bifurcation/orbit_plane.hpp"

#include <utility>

#include "graze/orbit/orbit.hpp"
#include "graze/orbit/shooting_curvature.hpp"

namespace graze {
namespace {

bool is_real(const PlaneProduct& product) {
  return product.multiplier.imag() == 0.0 && product.left.imag().isZero(0.0) &&
         product.right.imag().isZero(0.0);
}

}  // namespace

OrbitPlane::OrbitPlane(const Scene& scene, const std::string& first, const std::string& second,
                       ImpactPattern pattern, const MotionScale& scale)
    : systems_(scene, {first, second}), shooting_(std::move(pattern), scale) {
  problem_.evaluate = [this](const Vector& u, double p, double q) { return evaluate(u, p, q); };
  problem_.curvature = [this](const Vector& u, double p, double q,
                              const std::vector<PlaneProduct>& products) {
    return curvature(u, p, q, products);
  };
  problem_.multipliers = [this](const Vector& u, double p, double q,
                                ErrorBounds errors) -> std::vector<Eigenvalue> {
    const System* system = system_at(p, q);
    if (!system) return {};
    return orbit_multipliers(*system, this->pattern(), shooting_.unpack(*system, u), errors);
  };
  problem_.wrap = shooting_.wrap();
}

const System* OrbitPlane::system_at(double first, double second) const {
  return systems_.at(std::array{first, second});
}

std::array<const System*, 2> OrbitPlane::tangents_at(double first, double second) const {
  const std::array values{first, second};
  return {systems_.tangent_at(values, 0), systems_.tangent_at(values, 1)};
}

std::optional<PlaneEvaluation> OrbitPlane::evaluate(const Vector& u, double first,
                                                    double second) const {
  const System* system = system_at(first, second);
  if (!system) return {};
  ShootingLinearisation at = shooting_.linearise(*system, u, tangents_at(first, second));
  return PlaneEvaluation{std::move(at.residual), std::move(at.jacobian), std::move(at.closing),
                         std::move(at.by_parameters[0]), std::move(at.by_parameters[1])};
}

std::optional<Eigen::MatrixXcd> OrbitPlane::curvature(
    const Vector& u, double first, double second, const std::vector<PlaneProduct>& products) const {
  const System* system = system_at(first, second);
  if (!system) return {};
  const std::array<const System*, 2> tangents = tangents_at(first, second);
  Eigen::MatrixXcd rows(static_cast<Eigen::Index>(products.size()), u.size() + 2);
  for (std::size_t i = 0; i < products.size(); ++i) {
    const PlaneProduct& product = products[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (is_real(product))
      rows.row(row) = shooting_curvature(shooting_, *system, u, tangents, product.left.real(),
                                         product.right.real(), product.multiplier.real())
                          .cast<Complex>();
    else
      rows.row(row) = shooting_curvature(shooting_, *system, u, tangents, product.left,
                                         product.right, product.multiplier);
  }
  return rows;
}

}  // namespace graze
