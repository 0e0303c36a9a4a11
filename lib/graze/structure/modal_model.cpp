#include "graze/structure/modal_model.hpp"

#include <algorithm>
#include <cmath>

#include "graze/base/linalg/detail/linear_equations.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/closed_modes.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/structure/detail/discrete_rates.hpp"
#include "graze/structure/detail/span_modes.hpp"

namespace graze {
namespace {

using ConstVectorMap = Eigen::Map<const Vector>;

ConstVectorMap as_vector(const std::vector<double>& list) {
  return {list.data(), static_cast<Eigen::Index>(list.size())};
}

// What modes along a span are asked for.
Vector omega_of(const SpanModes& modes) {
  return std::visit([](const auto& has) { return has.omega(); }, modes);
}
Vector shapes_of(const SpanModes& modes, double x) {
  return std::visit([&](const auto& has) { return has.shapes(x); }, modes);
}
Vector inertia_of(const SpanModes& modes) {
  return std::visit([](const auto& has) { return has.inertia(); }, modes);
}

Vector shape_rates_at(const SpanModes& modes, const StructurePoint& point,
                      const StructurePoint& rate) {
  return std::visit([&](const auto& has) { return has.shape_rates(point.position, rate.position); },
                    modes);
}

Matrix collocation_matrix(const Beam& beam, const SpanModes& modes) {
  const std::vector<double> points = collocation_points(beam);
  Matrix phi(beam.modes, beam.modes);
  for (int i = 0; i < beam.modes; ++i)
    phi.row(i) = shapes_of(modes, points[static_cast<std::size_t>(i)]).transpose();
  return phi;
}

Matrix collocation_rate(const Beam& beam, const Beam& rate, const SpanModes& modes) {
  const std::vector<double> points = collocation_points(beam);
  Matrix phi_rate(beam.modes, beam.modes);
  for (int i = 0; i < beam.modes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    // The default points i L/N move with the length, given ones stay.
    const double x_rate =
        beam.points.empty() ? points[k] * rate.length / beam.length : rate.points[k];
    phi_rate.row(i) =
        std::visit([&](const auto& has) { return has.shape_rates(points[k], x_rate); }, modes)
            .transpose();
  }
  return phi_rate;
}

// Requires that it is the same everywhere.
Rated mass_per_length(const Scene& scene, const Scene* direction) {
  return line_of(scene, direction).pieces.front().mass.front();
}

// The damping that a modal structure carries itself counts as damping ratios.
Vector decay_rates(const Scene& scene, const Vector& omega) {
  if (const ModalDamping* damping = damping_of_matrices(scene)) return damping->delta;
  if (const ModalStructure* modal = scene.modal(); modal && !modal->damping_ratios.empty())
    return as_vector(modal->damping_ratios).cwiseProduct(omega);
  if (!scene.damping) return Vector::Zero(omega.size());
  if (const auto* ratios = std::get_if<DampingRatios>(&*scene.damping))
    return as_vector(ratios->ratios).cwiseProduct(omega);
  if (const auto* same = std::get_if<DampingRatio>(&*scene.damping)) return same->ratio * omega;
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&*scene.damping))
    return 0.5 * (rayleigh->mass + rayleigh->stiffness * omega.array().square());
  const double eta = std::get<ViscousDamping>(*scene.damping).coefficient;
  return Vector::Constant(omega.size(), 0.5 * eta / mass_per_length(scene, nullptr).value);
}

const RayleighDamping* rayleigh_of(const Scene& scene) {
  return scene.damping ? std::get_if<RayleighDamping>(&*scene.damping) : nullptr;
}

Vector decay_tangent(const Scene& scene, const ModalModel& model, const Vector& omega_rate,
                     const Scene& direction) {
  const auto of_ratios = [&](const std::vector<double>& ratios, const std::vector<double>& rates) {
    return Vector(as_vector(rates).cwiseProduct(model.omega) +
                  as_vector(ratios).cwiseProduct(omega_rate));
  };
  if (scene.matrices() && damping_of_matrices(scene)) return Vector::Zero(model.omega.size());
  if (const ModalStructure* modal = scene.modal(); modal && !modal->damping_ratios.empty())
    return of_ratios(modal->damping_ratios, direction.modal()->damping_ratios);
  if (!scene.damping) return Vector::Zero(model.omega.size());
  if (const auto* ratios = std::get_if<DampingRatios>(&*scene.damping))
    return of_ratios(ratios->ratios, std::get<DampingRatios>(*direction.damping).ratios);
  if (const auto* same = std::get_if<DampingRatio>(&*scene.damping))
    return std::get<DampingRatio>(*direction.damping).ratio * model.omega +
           same->ratio * omega_rate;
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&*scene.damping)) {
    const auto& rate = std::get<RayleighDamping>(*direction.damping);
    const auto omega = model.omega.array();
    return 0.5 * (rate.mass + rate.stiffness * omega.square() +
                  2.0 * rayleigh->stiffness * omega * omega_rate.array());
  }
  const double eta_rate = std::get<ViscousDamping>(*direction.damping).coefficient;
  const Rated mass = mass_per_length(scene, &direction);
  return Vector::Constant(model.omega.size(), 0.5 * eta_rate / mass.value) -
         model.delta * (mass.rate / mass.value);
}

bool collocates(const Scene& scene) {
  return scene.beam() && scene.beam()->discretisation == Projection::kCollocation;
}

// Modal force per unit of uniform acceleration. Galerkin: integral of mass times phi_j;
// collocation: Phi^-1 1.
Vector span_inertia(const Scene& scene, const SpanModes& modes, const Matrix& phi) {
  if (collocates(scene)) return LuFactors(phi).solve(Vector::Ones(scene.modes()));
  return inertia_of(modes);
}

// The rate of the inertia `g`, or of any multiple of it that depends on nothing else.
Vector span_inertia_rate(const Scene& scene, const SpanModes& modes, const Vector& g,
                         const Matrix& phi, const Matrix& phi_rate) {
  if (collocates(scene)) return -LuFactors(phi).solve(phi_rate * g);
  return std::visit([](const auto& has) { return has.inertia_rate(); }, modes);
}

// By collocation a load per length is an acceleration times rho A.
Vector span_participation(const Scene& scene, const HarmonicLoad& load, const SpanModes& modes,
                          const Matrix& phi) {
  if (load.has_place()) return shapes_of(modes, load.at.position);
  if (load.kind == ForcingKind::kNone) return Vector::Zero(scene.modes());
  if (load.kind != ForcingKind::kDistributed) return span_inertia(scene, modes, phi);
  if (collocates(scene))
    return span_inertia(scene, modes, phi) / mass_per_length(scene, nullptr).value;
  return std::visit([](const auto& has) { return has.load(); }, modes);
}

// `k`: of the harmonic load.
Vector span_participation_rate(const Scene& scene, const Scene& direction, std::size_t k,
                               const SpanModes& modes, const ModalModel& model,
                               const Matrix& phi_rate) {
  const HarmonicLoad& load = *scene.harmonic_loads()[k];
  if (load.has_place()) return shape_rates_at(modes, load.at, direction.harmonic_loads()[k]->at);
  const Vector& g = model.participations[k];
  if (load.kind == ForcingKind::kNone) return Vector::Zero(g.size());
  const bool distributed = load.kind == ForcingKind::kDistributed;
  if (distributed && !collocates(scene))
    return std::visit([](const auto& has) { return has.load_rate(); }, modes);
  Vector rate = span_inertia_rate(scene, modes, g, model.collocation, phi_rate);
  if (!distributed) return rate;
  const Rated mass = mass_per_length(scene, &direction);
  return rate - g * (mass.rate / mass.value);
}

// The given numbers `of` a scene or its direction, without the damping.
ModalModel given_numbers(const Scene& scene, const Scene& of) {
  const ModalStructure& modal = *of.modal();
  ModalModel model;
  model.omega = as_vector(modal.frequencies);
  for (const HarmonicLoad* load : of.harmonic_loads())
    model.participations.emplace_back(
        load->kind == ForcingKind::kNone   ? Vector(Vector::Zero(model.omega.size()))
        : load->kind == ForcingKind::kBase ? Vector(as_vector(modal.inertia))
        : load->has_place()                ? Vector(as_vector(load->at.shape))
                                           : Vector(as_vector(modal.participation)));
  if (scene.gravity) model.inertia = as_vector(modal.inertia);
  for (const SceneStop& stop : of.stops) model.shapes.emplace_back(as_vector(stop.shape));
  for (const PointLoad& load : of.loads) model.loads.emplace_back(as_vector(load.shape));
  for (const DryFriction& at : of.frictions) {
    model.frictions.emplace_back(as_vector(at.shape));
    model.springs.emplace_back(as_vector(at.spring_shape));
  }
  return model;
}

// Modal forces of each support that moves, per unit of displacement, velocity and acceleration, N x
// 3 each.
std::vector<Matrix> support_forces(const Scene& scene) {
  std::vector<Matrix> list;
  if (!scene.has_load(ForcingKind::kSupport)) return list;
  const MatrixModes& modes = *scene.discrete()->solved;
  for (const MovedSupport& support : modes.supports)
    list.emplace_back(modes.modes.shapes.transpose() * support.forces);
  return list;
}

// What Rayleigh's damping adds to those per unit of velocity.
Vector rayleigh_force(const Matrix& forces, const RayleighDamping* rayleigh) {
  if (!rayleigh) return Vector::Zero(forces.rows());
  return rayleigh->mass * forces.col(2) + rayleigh->stiffness * forces.col(0);
}

ModalModel given_model(const Scene& scene) {
  ModalModel model = given_numbers(scene, scene);
  model.delta = decay_rates(scene, model.omega);
  if (const ModalDamping* damping = damping_of_matrices(scene)) model.coupling = damping->coupling;
  for (const Matrix& forces : support_forces(scene)) {
    model.following.emplace_back(forces.rightCols(2));
    model.following.back().col(0) += rayleigh_force(forces, rayleigh_of(scene));
  }
  if (has_own_matrices(scene)) {
    const Matrix& shapes = scene.discrete()->solved->modes.shapes;
    if (shapes.rows() == shapes.cols()) model.coordinates = shapes;
  }
  return model;
}

// Of a structure whose matrices stand in the scene.
ModalModel discrete_tangent(const Scene& scene, const ModalModel& model, const Scene& direction) {
  const DiscreteRates rates = discrete_rates(scene, direction);
  const MatrixModes& modes = *scene.discrete()->solved;
  ModalModel rate;
  rate.omega = rates.omega;
  rate.delta = 0.5 * rates.damping.diagonal();
  if (scene.damping) rate.delta = decay_tangent(scene, model, rate.omega, direction);
  if (model.coordinates.size() > 0) rate.coordinates = rates.shapes;
  Matrix coupling = rates.damping;
  coupling.diagonal().setZero();
  if (model.coupling.size() > 0 || coupling.norm() > kProportionalExactly * rates.damping.norm())
    rate.coupling = std::move(coupling);
  const auto of_point = [&](Eigen::Index k) -> Vector {
    return rates.shapes.transpose() * modes.points.col(k);
  };
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < scene.stops.size(); ++i) rate.shapes.push_back(of_point(next++));
  for (std::size_t i = 0; i < scene.loads.size(); ++i) rate.loads.push_back(of_point(next++));
  for (const DryFriction& friction : scene.frictions) {
    rate.frictions.push_back(of_point(next++));
    rate.springs.push_back(friction.series > 0.0 ? of_point(next++) : Vector());
  }
  const int along = scene.matrices() ? scene.matrices()->direction : 0;
  if (scene.gravity) rate.inertia = rates.inertia.at(along);
  const std::vector<Matrix> forces = support_forces(scene);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    rate.following.emplace_back(rates.supports[i].rightCols(2));
    rate.following.back().col(0) += rayleigh_force(rates.supports[i], rayleigh_of(scene)) +
                                    rayleigh_force(forces[i], rayleigh_of(direction));
  }
  std::size_t support = 0;
  for (const HarmonicLoad* load : scene.harmonic_loads())
    rate.participations.push_back(
        load->kind == ForcingKind::kSupport ? (++next, Vector(rates.supports[support++].col(0)))
        : load->has_place()                 ? of_point(next++)
        : load->kind == ForcingKind::kBase  ? rates.inertia.at(along)
        : load->kind == ForcingKind::kNone  ? Vector(Vector::Zero(rates.omega.size()))
                                            : Vector(rates.shapes.transpose() * modes.load));
  return rate;
}

ModalModel given_tangent(const Scene& scene, const ModalModel& model, const Scene& direction) {
  if (has_own_matrices(scene)) return discrete_tangent(scene, model, direction);
  ModalModel rate = given_numbers(scene, direction);
  if (scene.matrices()) {  // No parameter moves what files give.
    rate.omega.setZero();
    for (Vector& load : rate.participations) load.setZero();
    for (const Matrix& forces : support_forces(scene)) {
      rate.following.emplace_back(Matrix::Zero(forces.rows(), 2));
      rate.following.back().col(0) = rayleigh_force(forces, rayleigh_of(direction));
    }
    rate.inertia.setZero();
    for (Vector& shape : rate.shapes) shape.setZero();
    for (Vector& shape : rate.loads) shape.setZero();
    for (Vector& shape : rate.frictions) shape.setZero();
  }
  rate.delta = decay_tangent(scene, model, rate.omega, direction);
  if (model.coupling.size() > 0)
    rate.coupling = Matrix::Zero(model.coupling.rows(), model.coupling.cols());
  return rate;
}

}  // namespace

double total_mass(const Scene& scene) {
  const Line line = line_of(scene, nullptr);
  double mass = 0.0;
  for (const LinePiece& piece : line.pieces)
    for (std::size_t k = 0; k < piece.mass.size(); ++k)
      mass +=
          (piece.end.value - piece.start.value) * piece.mass[k].value / static_cast<double>(k + 1);
  for (const LineMass& point : line.masses) mass += point.mass.value;
  return mass;
}

bool uses_collocation(const Scene& scene) {
  const Beam* beam = scene.beam();
  if (beam == nullptr) return false;
  return ((scene.forcing || scene.gravity) && beam->discretisation == Projection::kCollocation) ||
         std::any_of(scene.stops.begin(), scene.stops.end(),
                     [](const SceneStop& stop) { return stop.impulse == Impulse::kCollocation; });
}

ModalModel modal_model(const Scene& scene) {
  if (scene.modal()) return given_model(scene);
  const SpanModes modes = span_modes(scene);
  ModalModel model;
  model.omega = omega_of(modes);
  model.delta = decay_rates(scene, model.omega);
  if (uses_collocation(scene)) model.collocation = collocation_matrix(*scene.beam(), modes);
  for (const HarmonicLoad* load : scene.harmonic_loads())
    model.participations.push_back(span_participation(scene, *load, modes, model.collocation));
  if (scene.gravity) model.inertia = span_inertia(scene, modes, model.collocation);
  for (const SceneStop& stop : scene.stops) model.shapes.push_back(shapes_of(modes, stop.position));
  for (const PointLoad& load : scene.loads) model.loads.push_back(shapes_of(modes, load.position));
  for (const DryFriction& at : scene.frictions)
    model.frictions.push_back(shapes_of(modes, at.position));
  model.springs.resize(scene.frictions.size());
  if (const auto* found = std::get_if<ElementModes>(&modes)) model.elements = found->accuracy();
  return model;
}

ModalModel modal_tangent(const Scene& scene, const ModalModel& model, const Scene& direction) {
  if (scene.modal()) return given_tangent(scene, model, direction);
  const SpanModes modes = span_modes(scene, &direction);
  ModalModel rate;
  rate.omega = std::visit([](const auto& has) { return has.omega_rate(); }, modes);
  rate.delta = decay_tangent(scene, model, rate.omega, direction);
  if (uses_collocation(scene))
    rate.collocation = collocation_rate(*scene.beam(), *direction.beam(), modes);
  for (std::size_t k = 0; k < model.participations.size(); ++k)
    rate.participations.push_back(
        span_participation_rate(scene, direction, k, modes, model, rate.collocation));
  if (scene.gravity)
    rate.inertia =
        span_inertia_rate(scene, modes, model.inertia, model.collocation, rate.collocation);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    rate.shapes.push_back(shape_rates_at(modes, scene.stops[i], direction.stops[i]));
  for (std::size_t i = 0; i < scene.loads.size(); ++i)
    rate.loads.push_back(shape_rates_at(modes, scene.loads[i], direction.loads[i]));
  for (std::size_t i = 0; i < scene.frictions.size(); ++i)
    rate.frictions.push_back(shape_rates_at(modes, scene.frictions[i], direction.frictions[i]));
  return rate;
}

std::vector<Vector> shapes_at(const Scene& scene, const std::vector<double>& places) {
  const SpanModes modes = span_modes(scene);
  std::vector<Vector> rows;
  for (const double x : places) rows.push_back(shapes_of(modes, x));
  return rows;
}

Vector strain_row(const Scene& scene, double x) {
  const SpanModes modes = span_modes(scene);
  const double factor = scene.beam() ? -0.5 * thickness_at(*scene.beam(), x) : 1.0;
  return std::visit([&](const auto& has) { return has.strains(x, factor); }, modes);
}

}  // namespace graze
