#include "graze/assembly/assembly.hpp"

#include <cmath>
#include <utility>

#include "graze/assembly/detail/hub_system.hpp"
#include "graze/assembly/detail/residual_springs.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/contact/detail/impulse.hpp"
#include "graze/scene/check.hpp"
#include "graze/scene/parameter.hpp"

namespace graze {
namespace {

double sign_of(Side side) { return side == Side::kAbove ? 1.0 : -1.0; }

// All of the forcing, and beside it its derivative along a direction of the scene.
struct RatedForcing {
  HarmonicForcing value, rate;
};

// A cos(k theta + phase) of a load is cosine cos(k theta) + sine sin(k theta). The phases of the
// others count from that of the first, whose force is the amplitude where it has the lowest order.
class ForcingSum {
 public:
  // `direction`, `rate`: null for the value alone.
  ForcingSum(const Scene& scene, const ModalModel& model, const Scene* direction,
             const ModalModel* rate)
      : frequency_(scene.forcing->frequency), common_(scene.common_order()) {
    const std::vector<const HarmonicLoad*> loads = scene.harmonic_loads();
    const HarmonicLoad& first = *loads.front();
    const int order = order_of(first);
    sum_.value = {common_ * frequency_, first.phase / order, {}};
    frequency_rate_ = direction ? direction->forcing->frequency : 0.0;
    sum_.rate = {common_ * frequency_rate_, direction ? direction->forcing->phase / order : 0.0, {}};
    sum_.value.amplitude = sum_.rate.amplitude = Vector::Zero(model.omega.size());
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const HarmonicLoad* moved = direction ? direction->harmonic_loads()[k] : nullptr;
      add(k == 0, *loads[k], model.participations[k], moved,
          rate ? &rate->participations[k] : nullptr);
    }
  }

  RatedForcing sum() && { return std::move(sum_); }

 private:
  int order_of(const HarmonicLoad& load) const {
    return static_cast<int>(std::lround(load.order.value_or(1.0) / common_));
  }

  void add(bool is_first, const HarmonicLoad& load, const Vector& participation,
           const HarmonicLoad* moved, const Vector* participation_rate) {
    const int order = order_of(load);
    // A moving clamp accelerates by the square of its frequency times its amplitude.
    const bool is_base = load.kind == ForcingKind::kBase;
    const double turns = load.order.value_or(1.0), frequency = turns * frequency_;
    const double factor = is_base ? frequency * frequency : 1.0;
    const Vector force = load.amplitude * factor * participation;
    Vector force_rate = Vector::Zero(force.size());
    if (moved) {
      const double factor_rate =
          is_base ? 2.0 * frequency * turns * frequency_rate_ * load.amplitude : 0.0;
      force_rate = (moved->amplitude * factor + factor_rate) * participation +
                   load.amplitude * factor * *participation_rate;
    }
    const double behind = load.phase - order * sum_.value.phase;
    const double behind_rate = moved ? moved->phase - order * sum_.rate.phase : 0.0;
    if (is_first && order == 1) {
      sum_.value.amplitude = force;
      sum_.rate.amplitude = force_rate;
      return;
    }
    const double c = std::cos(behind), n = std::sin(behind);
    Harmonic& value = of_order(order, sum_.value);
    value.cosine += c * force;
    value.sine -= n * force;
    Harmonic& rate = of_order(order, sum_.rate);
    rate.cosine += c * force_rate - n * behind_rate * force;
    rate.sine -= n * force_rate + c * behind_rate * force;
  }

  static Harmonic& of_order(int order, HarmonicForcing& forcing) {
    for (Harmonic& one : forcing.harmonics)
      if (one.order == order) return one;
    const Vector none = Vector::Zero(forcing.amplitude.size());
    return forcing.harmonics.emplace_back(Harmonic{order, none, none});
  }

  double frequency_, frequency_rate_ = 0.0, common_;
  RatedForcing sum_;
};

HarmonicForcing assemble_forcing(const Scene& scene, const ModalModel& model) {
  return ForcingSum(scene, model, nullptr, nullptr).sum().value;
}

HarmonicForcing forcing_tangent(const Scene& scene, const Scene& direction, const ModalModel& model,
                                const ModalModel& rate) {
  return ForcingSum(scene, model, &direction, &rate).sum().rate;
}

Stop assemble_stop(const Scene& scene, const SceneStop& stop, const Vector& shape,
                   const Matrix& phi, const ResidualSpring& residual) {
  const double sign = sign_of(stop.side);
  const Vector row = sign * shape;
  if (stop.spring)
    return {row, stop.gap - sign * residual.shift,
            spring_law(as_given(*stop.spring, residual.stiffness))};
  const Vector direction =
      stop.impulse == Impulse::kMomentum
          ? momentum_direction(row)
          : collocation_direction(phi, collocation_index(*scene.beam(), stop.position), sign);
  return {row, stop.gap, ImpactLaw{direction, Restitution(stop.restitution)}};
}

Stop stop_tangent(const SceneStop& stop, const SceneStop& rate, const Stop& assembled,
                  const Vector& shape_rate, const ResidualSpring& residual_rate, const Matrix& phi,
                  const Matrix& phi_rate) {
  const double sign = sign_of(stop.side);
  const Vector row_rate = sign * shape_rate;
  if (stop.spring)
    return {row_rate, rate.gap - sign * residual_rate.shift,
            spring_law_rate(as_given(*stop.spring, assembled.force().stiffness),
                            rate_as_given(*rate.spring, residual_rate.stiffness))};
  const Vector direction_rate =
      stop.impulse == Impulse::kMomentum
          ? momentum_direction_rate(assembled.row, row_rate)
          : collocation_direction_rate(phi, phi_rate, assembled.direction());
  return {row_rate, rate.gap, ImpactLaw{direction_rate, Restitution(rate.restitution)}};
}

// The constant modal force, by gravity and by loads; nullopt where there is neither.
std::optional<Vector> constant_load(const Scene& scene, const ModalModel& model) {
  std::optional<Vector> load;
  if (scene.gravity) load = scene.gravity->acceleration * model.inertia;
  for (std::size_t k = 0; k < scene.loads.size(); ++k) {
    const Vector push = scene.loads[k].force * model.loads[k];
    load = load ? Vector(*load + push) : push;
  }
  return load;
}

}  // namespace

System assemble(const Scene& scene) { return assemble(scene, modal_model(scene)); }

System assemble(const Scene& scene, const ModalModel& model) {
  if (scene.hub) return assemble_on_hub(scene, model);
  System system{model.omega, NaturalModes{model.delta}, {}, scene.units};
  if (scene.forcing) system.modal().forcing = assemble_forcing(scene, model);
  system.modal().load = constant_load(scene, model);
  if (model.coupling.size() > 0) system.modal().coupling = model.coupling;
  if (model.coordinates.size() > 0) system.modal().coordinates = model.coordinates;
  system.stops.reserve(scene.stops.size());
  const std::vector<ResidualSpring> residual = residual_springs(scene, model);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    system.stops.push_back(assemble_stop(scene, scene.stops[i], model.shapes[i], model.collocation,
                                         residual.empty() ? ResidualSpring{} : residual[i]));
  return system;
}

System system_tangent(const Scene& scene, const std::string& parameter) {
  const Scene direction = parameter_direction(scene, parameter);
  const ModalModel model = modal_model(scene);
  return system_tangent(scene, direction, model, modal_tangent(scene, model, direction),
                        assemble(scene, model));
}

System system_tangent(const Scene& scene, const Scene& direction, const ModalModel& model,
                      const ModalModel& rate, const System& system) {
  System tangent{rate.omega, NaturalModes{rate.delta}, {}};
  if (scene.forcing)
    tangent.modal().forcing = forcing_tangent(scene, direction, model, rate);
  // A product's derivative: once the forces move, once the shapes.
  tangent.modal().load = constant_load(direction, model);
  if (const std::optional<Vector> moved = constant_load(scene, rate))
    *tangent.modal().load += *moved;
  if (rate.coupling.size() > 0) tangent.modal().coupling = rate.coupling;
  if (rate.coordinates.size() > 0) tangent.modal().coordinates = rate.coordinates;
  tangent.stops.reserve(scene.stops.size());
  const std::vector<ResidualSpring> residual = residual_spring_rates(scene, direction, model, rate);
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    tangent.stops.push_back(stop_tangent(
        scene.stops[i], direction.stops[i], system.stops[i], rate.shapes[i],
        residual.empty() ? ResidualSpring{} : residual[i], model.collocation, rate.collocation));
  return tangent;
}

}  // namespace graze
