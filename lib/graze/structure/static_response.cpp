#include "graze/structure/static_response.hpp"

#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/products.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/detail/discrete_rates.hpp"
#include "graze/structure/detail/line_modes.hpp"
#include "graze/structure/detail/line_statics.hpp"

namespace graze {
namespace {

using Eigen::Index;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Roundings of each term and sum, and of entries that were rounded before.
constexpr double kRoundings = 8.0;

std::vector<Rated> stop_places(const Scene& scene, const Scene* direction) {
  std::vector<Rated> places;
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    places.push_back({scene.stops[i].position, direction ? direction->stops[i].position : 0.0});
  return places;
}

StaticResponse split(const Scene& scene, const Matrix& displacement) {
  const auto stops = static_cast<Index>(scene.stops.size());
  StaticResponse response{displacement.topLeftCorner(stops, stops), {}};
  if (scene.gravity) response.under_gravity = displacement.col(stops).head(stops);
  return response;
}

StaticResponse less(const StaticResponse& whole, const StaticResponse& share) {
  StaticResponse rest{whole.flexibility - share.flexibility, {}};
  if (whole.under_gravity.size() > 0)
    rest.under_gravity = whole.under_gravity - share.under_gravity;
  return rest;
}

// phi/w of every stop, stops by modes, without rigid modes; of the loads likewise.
Matrix shares(const std::vector<Vector>& shapes, const Vector& omega) {
  Matrix rows(static_cast<Index>(shapes.size()), omega.size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
    rows.row(static_cast<Index>(i)) = shapes[i].transpose();
  for (Index j = 0; j < omega.size(); ++j) rows.col(j) *= omega[j] > 0.0 ? 1.0 / omega[j] : 0.0;
  return rows;
}

Vector share_of_load(const Vector& load, const Vector& omega) {
  return shares({load}, omega).row(0);
}

StaticResponse response_of_modes_rate(const ModalModel& model, const ModalModel& rate) {
  const Matrix rows = shares(model.shapes, model.omega);
  const Vector change = share_of_load(rate.omega, model.omega);  // of the logarithm of w
  const Matrix moved = shares(rate.shapes, model.omega) - rows * change.asDiagonal();
  const Matrix half = product<double>(moved, rows.transpose());
  StaticResponse response{half + half.transpose(), {}};
  if (model.inertia.size() == 0) return response;
  const Vector load = share_of_load(model.inertia, model.omega);
  response.under_gravity =
      moved * load + rows * (share_of_load(rate.inertia, model.omega) - change.cwiseProduct(load));
  return response;
}

// Bounds on the relative error of (phi/w)^2, from that of each frequency.
Vector square_errors(const Scene& scene, const ModalModel& model) {
  Vector errors = Vector::Constant(model.omega.size(), kRoundings * kEpsilon);
  if (scene.discrete()) {
    const StructuralModes& modes = scene.discrete()->solved->modes;
    for (Index j = 0; j < errors.size(); ++j)
      if (modes.omega[j] > 0.0)
        errors[j] += kRoundings * modes.square_roundings[j] / (modes.omega[j] * modes.omega[j]);
  } else if (model.elements) {
    const Index well = std::min<Index>(errors.size(), kWellResolved);
    errors.head(well).array() += 2.0 * model.elements->change;
    errors.tail(errors.size() - well).array() += 2.0 * model.elements->change_beyond;
  }
  return errors;
}

}  // namespace

std::optional<StaticResponse> static_response(const Scene& scene) {
  if (scene.hub) return {};
  if (const DiscreteStructure* matrices = scene.discrete()) {
    StaticResponse response{matrices->solved->flexibility, {}};
    if (scene.gravity) response.under_gravity = matrices->solved->under_gravity;
    return response;
  }
  if (!scene.span() || (scene.string() && !scene.string()->frequencies.empty())) return {};
  return split(
      scene,
      line_statics(line_of(scene, nullptr), stop_places(scene, nullptr), false).displacement);
}

StaticResponse static_response_of_modes(const ModalModel& model) {
  const Matrix rows = shares(model.shapes, model.omega);
  StaticResponse response{product<double>(rows, rows.transpose()), {}};
  if (model.inertia.size() > 0)
    response.under_gravity = rows * share_of_load(model.inertia, model.omega);
  return response;
}

StaticResponse residual_response(const StaticResponse& whole, const ModalModel& model) {
  return less(whole, static_response_of_modes(model));
}

StaticResponse residual_response_rate(const Scene& scene, const Scene& direction,
                                      const ModalModel& model, const ModalModel& rate) {
  StaticResponse whole;
  if (has_own_matrices(scene)) {
    DiscreteRates rates = discrete_rates(scene, direction);
    whole.flexibility = std::move(rates.flexibility);
    if (scene.gravity) whole.under_gravity = std::move(rates.under_gravity);
  } else if (scene.matrices()) {  // No parameter moves what files give.
    whole.flexibility.setZero(static_cast<Index>(scene.stops.size()),
                              static_cast<Index>(scene.stops.size()));
    if (scene.gravity) whole.under_gravity.setZero(static_cast<Index>(scene.stops.size()));
  } else {
    const LineStatics found =
        line_statics(line_of(scene, &direction), stop_places(scene, &direction), true);
    if (found.is_torn)
      throw scene_error(scene, "stop",
                        "there is no derivative: a stop whose stiffness is \"residual\" meets an "
                        "end, a piece, a support, a mass or another stop at one place, of which "
                        "the parameter moves only one; they must be a little apart");
    whole = split(scene, found.rate);
  }
  return less(whole, response_of_modes_rate(model, rate));
}

Vector residual_uncertainty(const Scene& scene, const StaticResponse& whole,
                            const ModalModel& model) {
  const Matrix squares = shares(model.shapes, model.omega).cwiseAbs2();
  const Vector of_modes = squares * square_errors(scene, model);
  const Vector size = whole.flexibility.diagonal().cwiseAbs();
  if (!scene.discrete()) return of_modes + kRoundings * kEpsilon * size;
  const Vector& roundings = scene.discrete()->solved->modes.static_roundings;
  return of_modes + kRoundings * roundings.head(size.size());
}

int free_motions(const Scene& scene, const ModalModel& model) {
  if (scene.discrete()) return scene.discrete()->solved->modes.free_motions;
  if (model.elements) return model.elements->rigid;
  return static_cast<int>((model.omega.array() == 0.0).count());
}

}  // namespace graze
