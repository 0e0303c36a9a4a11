#include "graze/structure/modal_model.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/detail/cantilever.hpp"

namespace graze {
namespace {

using ConstVectorMap = Eigen::Map<const Vector>;

ConstVectorMap as_vector(const std::vector<double>& list) {
  return {list.data(), static_cast<Eigen::Index>(list.size())};
}

// phi_j(x) = shape(x/L)/sqrt(rho A L)
double mass_scale(const Beam& beam) {
  return 1.0 / std::sqrt(beam.density * beam.area * beam.length);
}

// d ln(scale)
double mass_scale_rate(const Beam& beam, const Beam& rate) {
  return -0.5 * (rate.density / beam.density + rate.area / beam.area + rate.length / beam.length);
}

Vector shapes_at(const Beam& beam, double x) {
  Vector phi(beam.modes);
  for (int j = 0; j < beam.modes; ++j)
    phi[j] = mass_scale(beam) * cantilever_shape(j + 1, x / beam.length);
  return phi;
}

Vector shape_rates_at(const Beam& beam, const Beam& rate, double x, double x_rate) {
  const double xi_rate = (x_rate - x * rate.length / beam.length) / beam.length;
  Vector phi_rate = mass_scale_rate(beam, rate) * shapes_at(beam, x);
  for (int j = 0; j < beam.modes; ++j)
    phi_rate[j] += mass_scale(beam) * cantilever_slope(j + 1, x / beam.length) * xi_rate;
  return phi_rate;
}

Matrix collocation_matrix(const Beam& beam) {
  const std::vector<double> points = collocation_points(beam);
  Matrix phi(beam.modes, beam.modes);
  for (int i = 0; i < beam.modes; ++i)
    phi.row(i) = shapes_at(beam, points[static_cast<std::size_t>(i)]).transpose();
  return phi;
}

Matrix collocation_rate(const Beam& beam, const Beam& rate) {
  const std::vector<double> points = collocation_points(beam);
  Matrix phi_rate(beam.modes, beam.modes);
  for (int i = 0; i < beam.modes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    // The default points i L/N move with the length, given ones stay.
    const double x_rate =
        beam.points.empty() ? points[k] * rate.length / beam.length : rate.points[k];
    phi_rate.row(i) = shape_rates_at(beam, rate, points[k], x_rate).transpose();
  }
  return phi_rate;
}

Vector natural_frequencies(const Scene& scene) {
  if (const ModalStructure* modal = scene.modal()) return as_vector(modal->frequencies);
  const Beam& beam = *scene.beam();
  const double unit =
      std::sqrt(beam.youngs_modulus * beam.second_moment / (beam.density * beam.area)) /
      (beam.length * beam.length);
  Vector omega(beam.modes);
  for (int j = 0; j < beam.modes; ++j) {
    const double b = cantilever_wave_number(j + 1);
    omega[j] = b * b * unit;
  }
  return omega;
}

Vector natural_frequency_rates(const Scene& scene, const Vector& omega, const Scene& direction) {
  if (scene.matrices()) return Vector::Zero(omega.size());
  if (const ModalStructure* rate = direction.modal()) return as_vector(rate->frequencies);
  const Beam& beam = *scene.beam();
  const Beam& rate = *direction.beam();
  return omega * (0.5 * (rate.youngs_modulus / beam.youngs_modulus +
                         rate.second_moment / beam.second_moment - rate.density / beam.density -
                         rate.area / beam.area) -
                  2.0 * rate.length / beam.length);
}

// The damping that a modal structure carries itself counts as damping ratios.
Vector decay_rates(const Scene& scene, const Vector& omega) {
  if (const ModalDamping* damping = damping_of_matrices(scene)) return damping->delta;
  if (const ModalStructure* modal = scene.modal(); modal && !modal->damping_ratios.empty())
    return as_vector(modal->damping_ratios).cwiseProduct(omega);
  if (!scene.damping) return Vector::Zero(omega.size());
  if (const auto* ratios = std::get_if<DampingRatios>(&*scene.damping))
    return as_vector(ratios->ratios).cwiseProduct(omega);
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&*scene.damping))
    return 0.5 * (rayleigh->mass + rayleigh->stiffness * omega.array().square());
  const Beam& beam = *scene.beam();
  const double eta = std::get<ViscousDamping>(*scene.damping).coefficient;
  return Vector::Constant(omega.size(), 0.5 * eta / (beam.density * beam.area));
}

Vector decay_tangent(const Scene& scene, const ModalModel& model, const Vector& omega_rate,
                     const Scene& direction) {
  const auto of_ratios = [&](const std::vector<double>& ratios, const std::vector<double>& rates) {
    return Vector(as_vector(rates).cwiseProduct(model.omega) +
                  as_vector(ratios).cwiseProduct(omega_rate));
  };
  if (damping_of_matrices(scene)) return Vector::Zero(model.omega.size());
  if (const ModalStructure* modal = scene.modal(); modal && !modal->damping_ratios.empty())
    return of_ratios(modal->damping_ratios, direction.modal()->damping_ratios);
  if (!scene.damping) return Vector::Zero(model.omega.size());
  if (const auto* ratios = std::get_if<DampingRatios>(&*scene.damping))
    return of_ratios(ratios->ratios, std::get<DampingRatios>(*direction.damping).ratios);
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&*scene.damping)) {
    const auto& rate = std::get<RayleighDamping>(*direction.damping);
    const auto omega = model.omega.array();
    return 0.5 * (rate.mass + rate.stiffness * omega.square() +
                  2.0 * rayleigh->stiffness * omega * omega_rate.array());
  }
  const Beam& beam = *scene.beam();
  const Beam& rate = *direction.beam();
  const double eta_rate = std::get<ViscousDamping>(*direction.damping).coefficient;
  return Vector::Constant(model.omega.size(), 0.5 * eta_rate / (beam.density * beam.area)) -
         model.delta * (rate.density / beam.density + rate.area / beam.area);
}

// Modal force per unit of uniform acceleration. Galerkin: integral of rho A phi_j; collocation:
// Phi^-1 1.
Vector beam_inertia(const Beam& beam, const Matrix& phi) {
  if (beam.discretisation == Projection::kCollocation)
    return LuFactors(phi).solve(Vector::Ones(beam.modes));
  Vector g(beam.modes);
  for (int j = 0; j < beam.modes; ++j) g[j] = cantilever_mean(j + 1) / mass_scale(beam);
  return g;
}

// The rate of the inertia `g`, or of any multiple of it.
Vector beam_inertia_rate(const Beam& beam, const Beam& rate, const Vector& g, const Matrix& phi,
                         const Matrix& phi_rate) {
  return beam.discretisation == Projection::kCollocation
             ? Vector(-LuFactors(phi).solve(phi_rate * g))
             : Vector(-mass_scale_rate(beam, rate) * g);
}

// A load per length is an acceleration times rho A.
Vector beam_participation(const Beam& beam, ForcingKind kind, const Matrix& phi) {
  const Vector g = beam_inertia(beam, phi);
  return kind == ForcingKind::kDistributed ? Vector(g / (beam.density * beam.area)) : g;
}

Vector beam_participation_rate(const Beam& beam, const Beam& rate, ForcingKind kind,
                               const ModalModel& model, const Matrix& phi_rate) {
  const Vector& g = model.participation;
  Vector g_rate = beam_inertia_rate(beam, rate, g, model.collocation, phi_rate);
  if (kind == ForcingKind::kDistributed)
    g_rate -= g * (rate.density / beam.density + rate.area / beam.area);
  return g_rate;
}

}  // namespace

bool uses_collocation(const Scene& scene) {
  const Beam* beam = scene.beam();
  if (beam == nullptr) return false;
  return ((scene.forcing || scene.gravity) && beam->discretisation == Projection::kCollocation) ||
         std::any_of(scene.stops.begin(), scene.stops.end(),
                     [](const SceneStop& stop) { return stop.impulse == Impulse::kCollocation; });
}

ModalModel modal_model(const Scene& scene) {
  ModalModel model;
  model.omega = natural_frequencies(scene);
  model.delta = decay_rates(scene, model.omega);
  if (uses_collocation(scene)) model.collocation = collocation_matrix(*scene.beam());
  if (const ModalStructure* modal = scene.modal()) {
    if (scene.forcing)
      model.participation = as_vector(
          scene.forcing->kind == ForcingKind::kBase ? modal->inertia : modal->participation);
    if (scene.gravity) model.inertia = as_vector(modal->inertia);
    for (const SceneStop& stop : scene.stops) model.shapes.emplace_back(as_vector(stop.shape));
  } else {
    const Beam& beam = *scene.beam();
    if (scene.forcing)
      model.participation = beam_participation(beam, scene.forcing->kind, model.collocation);
    if (scene.gravity) model.inertia = beam_inertia(beam, model.collocation);
    for (const SceneStop& stop : scene.stops)
      model.shapes.push_back(shapes_at(beam, stop.position));
  }
  return model;
}

ModalModel modal_tangent(const Scene& scene, const ModalModel& model, const Scene& direction) {
  ModalModel rate;
  rate.omega = natural_frequency_rates(scene, model.omega, direction);
  rate.delta = decay_tangent(scene, model, rate.omega, direction);
  if (scene.matrices()) {
    // No parameter moves what matrices give.
    const Vector none = Vector::Zero(model.omega.size());
    if (scene.forcing) rate.participation = none;
    if (scene.gravity) rate.inertia = none;
    rate.shapes.assign(scene.stops.size(), none);
    return rate;
  }
  if (const ModalStructure* modal = direction.modal()) {
    if (scene.forcing)
      rate.participation = as_vector(
          scene.forcing->kind == ForcingKind::kBase ? modal->inertia : modal->participation);
    if (scene.gravity) rate.inertia = as_vector(modal->inertia);
    for (const SceneStop& stop : direction.stops) rate.shapes.emplace_back(as_vector(stop.shape));
    return rate;
  }
  const Beam& beam = *scene.beam();
  const Beam& beam_rate = *direction.beam();
  if (uses_collocation(scene)) rate.collocation = collocation_rate(beam, beam_rate);
  if (scene.forcing)
    rate.participation =
        beam_participation_rate(beam, beam_rate, scene.forcing->kind, model, rate.collocation);
  if (scene.gravity)
    rate.inertia =
        beam_inertia_rate(beam, beam_rate, model.inertia, model.collocation, rate.collocation);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    rate.shapes.push_back(
        shape_rates_at(beam, beam_rate, scene.stops[i].position, direction.stops[i].position));
  return rate;
}

}  // namespace graze
