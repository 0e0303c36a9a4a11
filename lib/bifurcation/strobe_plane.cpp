#include "graze/bifurcation/strobe_plane.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "graze/continuation/plane_curve.hpp"
#include "graze/flow/sprung_deviation.hpp"
#include "graze/orbit/shooting.hpp"

namespace graze {
namespace {

// Slopes of the map are known to about this, in its units: ten times what a step of
// the deviations is.
constexpr double kMapAccuracy = 10.0 * kDeviationTolerance;
// So differences of slopes err least over steps of its cube root, in units of the map and in ranges
// of the parameters.
const double kStep = std::cbrt(kMapAccuracy);
// The test for a multiplier is formed from slopes: it vanishes to what these are known to, times
// what solving with them costs.
constexpr double kResidual = 1e3 * kMapAccuracy;

System own_system(const Scene& scene, const std::string& parameter) {
  const SystemFamily family(scene, parameter);
  return *family.at(family.value());
}

}  // namespace

StrobePlane::StrobePlane(const Scene& scene, const std::string& first, const std::string& second,
                         const LocusOptions& options, const StrobeOptions& strobe)
    : systems_(scene, {first, second}),
      first_range_(graze::first_range(options)),
      second_range_(graze::second_range(options)),
      length_(motion_scale(own_system(scene, first)).length),
      speed_unit_(length_ * scene.forcing->frequency),
      map_(own_system(scene, first), strobe) {}

double StrobePlane::residual_tolerance() { return kResidual; }

const System* StrobePlane::system_at(double p, double q) const {
  return systems_.at(std::array{p, q});
}

const System* StrobePlane::tangent_at(double p, double q, std::size_t parameter) const {
  return systems_.tangent_at(std::array{p, q}, parameter);
}

std::optional<PlaneMapEvaluation> StrobePlane::evaluate(const Vector& x, double p, double q) const {
  const System* system = system_at(p, q);
  const System* by_first = system ? tangent_at(p, q, 0) : nullptr;
  const System* by_second = by_first ? tangent_at(p, q, 1) : nullptr;
  if (!by_second) return {};
  std::optional<StrobeMap::Image> image = map_.image(*system, x, by_first);
  std::optional<Vector> second = image ? map_.rate(*system, x, *by_second) : std::nullopt;
  if (!second) return {};
  return PlaneMapEvaluation{std::move(image->image), std::move(image->jacobian),
                            std::move(image->by_parameter), std::move(*second)};
}

std::optional<double> StrobePlane::product(const Vector& x, double p, double q, const Vector& left,
                                           const Vector& right) const {
  const System* system = system_at(p, q);
  const auto image = system ? map_.image(*system, x) : std::nullopt;
  return image ? std::optional(left.dot(image->jacobian * right)) : std::nullopt;
}

std::optional<Vector> StrobePlane::curvature(const Vector& x, double p, double q,
                                             const Vector& left, const Vector& right) const {
  Vector slopes(x.size() + 2);
  for (Eigen::Index j = 0; j < slopes.size(); ++j) {
    const bool of_state = j < x.size();
    const Vector shift =
        of_state ? Vector(kStep * Vector::Unit(x.size(), j)) : Vector(Vector::Zero(x.size()));
    const double dp = j == x.size() ? kStep * first_range_ : 0.0,
                 dq = j == x.size() + 1 ? kStep * second_range_ : 0.0;
    const auto ahead = product(x + shift, p + dp, q + dq, left, right),
               behind = product(x - shift, p - dp, q - dq, left, right);
    if (!ahead || !behind) return {};
    slopes[j] = (*ahead - *behind) / (2.0 * (of_state ? kStep : dp + dq));
  }
  return slopes;
}

const PlaneProblem& StrobePlane::problem(int period) {
  const auto known = problems_.find(period);
  if (known != problems_.end()) return known->second;
  PlaneMap map;
  map.evaluate = [this](const Vector& x, double p, double q) { return evaluate(x, p, q); };
  map.curvature = [this](const Vector& x, double p, double q, const Vector& left,
                         const Vector& right) { return curvature(x, p, q, left, right); };
  return problems_.emplace(period, periodic_points(map, period)).first->second;
}

}  // namespace graze
