#include "graze/structure/static_response.hpp"

#include <cmath>
#include <limits>

#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/detail/line_modes.hpp"
#include "graze/structure/detail/line_statics.hpp"

namespace graze {
namespace {

using Eigen::Index;

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
  const Matrix half = moved * rows.transpose();
  StaticResponse response{half + half.transpose(), {}};
  if (model.inertia.size() == 0) return response;
  const Vector load = share_of_load(model.inertia, model.omega);
  response.under_gravity =
      moved * load + rows * (share_of_load(rate.inertia, model.omega) - change.cwiseProduct(load));
  return response;
}

// Relative errors of the frequencies.
Vector frequency_errors(const Scene& scene, const ModalModel& model) {
  if (scene.matrices()) return scene.matrices()->solved->modes.residuals;
  Vector errors = Vector::Zero(model.omega.size());
  if (model.elements) {
    errors.setConstant(model.elements->change_beyond);
    const Index well = std::min<Index>(errors.size(), kWellResolved);
    errors.head(well).setConstant(model.elements->change);
  }
  return errors;
}

}  // namespace

std::optional<StaticResponse> static_response(const Scene& scene) {
  if (scene.hub) return {};
  if (const MatrixStructure* matrices = scene.matrices()) {
    StaticResponse response{matrices->solved->flexibility, {}};
    if (scene.gravity) response.under_gravity = matrices->solved->under_gravity;
    return response;
  }
  if (!scene.span()) return {};
  return split(
      scene,
      line_statics(line_of(scene, nullptr), stop_places(scene, nullptr), false).displacement);
}

StaticResponse static_response_of_modes(const ModalModel& model) {
  const Matrix rows = shares(model.shapes, model.omega);
  StaticResponse response{rows * rows.transpose(), {}};
  if (model.inertia.size() > 0)
    response.under_gravity = rows * share_of_load(model.inertia, model.omega);
  return response;
}

StaticResponse residual_response(const Scene& scene, const ModalModel& model) {
  return less(*static_response(scene), static_response_of_modes(model));
}

StaticResponse residual_response_rate(const Scene& scene, const Scene& direction,
                                      const ModalModel& model, const ModalModel& rate) {
  StaticResponse whole;
  if (scene.matrices()) {  // No parameter moves what matrices give.
    whole.flexibility.setZero(static_cast<Index>(scene.stops.size()),
                              static_cast<Index>(scene.stops.size()));
    if (scene.gravity) whole.under_gravity.setZero(static_cast<Index>(scene.stops.size()));
  } else {
    const LineStatics found =
        line_statics(line_of(scene, &direction), stop_places(scene, &direction), true);
    if (found.is_torn)
      throw scene_error(scene, "stop",
                        "there is no derivative: a stop whose stiffness is \"residual\" meets the "
                        "end of a piece, a support or a mass at one place, of which the parameter "
                        "moves only one; they must be a little apart");
    whole = split(scene, found.rate);
  }
  return less(whole, response_of_modes_rate(model, rate));
}

// Each of N terms is rounded, and each holds its frequency squared.
Vector residual_uncertainty(const Scene& scene, const ModalModel& model) {
  const double eps = std::numeric_limits<double>::epsilon();
  const Matrix squares = shares(model.shapes, model.omega).cwiseAbs2();
  const Vector errors = 2.0 * frequency_errors(scene, model).array() + 4.0 * eps;
  return squares * errors + 8.0 * eps * static_response(scene)->flexibility.diagonal();
}

}  // namespace graze
