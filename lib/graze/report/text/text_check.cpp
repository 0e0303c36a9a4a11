#include <fmt/format.h>

#include <cmath>

#include "graze/assembly/detail/requested_restitution.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/angle.hpp"
#include "graze/base/detail/terminal_text.hpp"
#include "graze/record/records.hpp"
#include "graze/report/text/detail/table.hpp"
#include "graze/report/text/text.hpp"
#include "graze/study/cost/detail/step_choice.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

std::string damping_text(const SceneStop& stop, const ContactForce& law) {
  if (!stop.spring->damping) return "without damping";
  return fmt::format("with {} damping {:g}", contact_model_name(stop.spring->damping->model),
                     law.coefficient);
}

// Asked and given, a line of each.
std::string requests_text(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    if (!scene.stops[i].spring) continue;
    const std::optional<RequestedRestitution> asked = requested_restitution(*scene.stops[i].spring);
    if (!asked) continue;
    text += fmt::format("stop {}: asked for restitution {:g}", i + 1, asked->requested);
    if (asked->speed) text += fmt::format(" at {:g} m/s", *asked->speed);
    if (asked->mass) text += fmt::format(" of {:g} kg", *asked->mass);
    text += fmt::format(", one such contact gives {:.6g}", asked->effective);
    text += asked->exact_coefficient
                ? fmt::format("; exact with the coefficient {:.6g}\n", *asked->exact_coefficient)
                : ", and more where it is not much deeper than the onset\n";
  }
  return text;
}

// 0.8, or 0.8 - 0.1 v - ..
std::string restitution_text(const std::vector<double>& coefficients) {
  std::string text = fmt::format("{:g}", coefficients.front());
  for (std::size_t i = 1; i < coefficients.size(); ++i) {
    text += fmt::format(" {} {:g} v", coefficients[i] < 0.0 ? "+" : "-", std::abs(coefficients[i]));
    if (i > 1) text += fmt::format("^{}", i);
  }
  return text;
}

std::string title(const Scene& scene) {
  return scene.title.empty() ? "" : terminal_line(scene.title) + "\n";
}

std::string damping_text(const Scene& scene) {
  if (!scene.damping)
    return scene.modal() && !scene.modal()->damping_ratios.empty() ? "a ratio for each mode"
                                                                   : "none";
  if (const auto* viscous = std::get_if<ViscousDamping>(&*scene.damping))
    return fmt::format("viscous, {:g} N s/m^2", viscous->coefficient);
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&*scene.damping))
    return fmt::format("Rayleigh, mass {:g} 1/s, stiffness {:g} s", rayleigh->mass,
                       rayleigh->stiffness);
  return "a ratio for each mode";
}

std::string flow_text(const CheckRecord& record) {
  const FlowDecision decision = flow_decision(record.scene);
  if (!record.steps) return fmt::format("{}: {}", flow_name(decision.flow), decision.reason);
  const Solver& solver = record.scene.solver;
  const std::string steps = solver.step
                                ? fmt::format("steps of {:g} s", *solver.step)
                                : fmt::format("steps by their error, {:g}", solver.tolerance);
  return fmt::format("{}: {}; stable up to {:.6g} s; a contact shows at the ends of steps only",
                     flow_name(solver.flow), steps, record.steps->longest);
}

// A line of the list of effects.
std::string effect(const std::string& what, const std::string& how) {
  return fmt::format("  {:<12} {}\n", what, how);
}

std::string structure_text(const Scene& scene) {
  const char* plural = scene.modes() == 1 ? "" : "s";
  if (const Beam* beam = scene.beam())
    return fmt::format("clamped-free beam, {} mode{}, {} projection", beam->modes, plural,
                       beam->discretisation == Projection::kGalerkin ? "Galerkin" : "collocation");
  return fmt::format("given by {} mode{}", scene.modes(), plural);
}

std::string torque_text(const std::optional<Torque>& torque) {
  if (!torque) return "none: nothing drives the hub";
  if (const auto* pulse = std::get_if<TorquePulse>(&*torque))
    return fmt::format("{:g} N m for {:g} s, then none", pulse->amplitude, pulse->duration);
  const auto& table = std::get<TorqueTable>(*torque);
  return fmt::format("{} points from {:g} to {:g} s, straight between them, none outside",
                     table.times.size(), table.times.front(), table.times.back());
}

std::string hub_effects(const Hub& hub) {
  return effect("hub",
                fmt::format("radius {:g} m, inertia {:g} kg m^2, {}", hub.radius, hub.inertia,
                            hub.equations == HubEquations::kConsistent
                                ? "equations that conserve energy"
                                : "equations as in the paper")) +
         effect("torque", torque_text(hub.torque)) +
         effect("centrifugal", hub.centrifugal ? "terms with the square of the rate" : "none") +
         effect("friction", hub.friction
                                ? fmt::format("Coulomb's at the joint, {:g} N m", *hub.friction)
                                : "none at the joint");
}

std::string forcing_text(const Forcing& forcing) {
  const bool base = forcing.kind == ForcingKind::kBase;
  const bool load = forcing.kind == ForcingKind::kDistributed;
  return fmt::format("{}, amplitude {:g}{}, {:g} rad/s = {:.6g} Hz, period {:.6g} s",
                     base ? "moving clamp" : (load ? "distributed load" : "modal"),
                     forcing.amplitude, base ? " m" : (load ? " N/m" : ""), forcing.frequency,
                     forcing.frequency / kTurn, kTurn / forcing.frequency);
}

std::string gravity_text(const Scene& scene) {
  if (!scene.gravity) return "none";
  return fmt::format("{:g} m/s^2 along {}", scene.gravity->acceleration,
                     scene.hub ? "-u at angle 0" : "+u");
}

std::string stop_text(const Scene& scene, const SceneStop& stop) {
  const std::string place = fmt::format(
      "{}{}, gap {:g} m, ", scene.beam() ? fmt::format("at x = {:g} m, ", stop.position) : "",
      stop.side == Side::kAbove ? "above" : "below", stop.gap);
  if (stop.spring) {
    const ContactForce law = spring_law(*stop.spring);
    return place + fmt::format("compliant: {:g} N/m^{:g} {}, parts where its {} is gone",
                               law.stiffness, law.exponent, damping_text(stop, law),
                               law.separation == Separation::kAtZeroForce ? "force" : "depth");
  }
  return place + fmt::format("restitution {}, {} impulse", restitution_text(stop.restitution),
                             stop.impulse == Impulse::kMomentum ? "momentum" : "collocation");
}

std::string probe_text(const Scene& scene, const Probe& probe) {
  const std::string unit = probe_unit(probe.quantity);
  return fmt::format("{}{}{}", probe_quantity_name(probe.quantity),
                     unit.empty() ? "" : fmt::format(" ({})", unit),
                     is_of_hub(probe.quantity) ? " of the hub"
                     : scene.beam()            ? fmt::format(" at x = {:g} m", probe.position)
                                               : std::string());
}

std::string simulated_effects(const CheckRecord& record) {
  const Scene& scene = record.scene;
  std::string text = effect("structure", structure_text(scene));
  if (scene.hub) text += hub_effects(*scene.hub);
  text += effect("damping", damping_text(scene));
  // A hub is driven by its torque.
  if (!scene.hub) text += effect("forcing", scene.forcing ? forcing_text(*scene.forcing) : "none");
  text += effect("gravity", gravity_text(scene));
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    text += effect(fmt::format("stop {}", i + 1), stop_text(scene, scene.stops[i]));
  if (scene.stops.empty()) text += effect("stop", "none: no contact is looked for");
  for (std::size_t i = 0; i < scene.probes.size(); ++i)
    text += effect(fmt::format("probe {}", i + 1), probe_text(scene, scene.probes[i]));
  return text + effect("flow", flow_text(record));
}

}  // namespace

std::string to_text(const CheckRecord& record) {
  std::string text = title(record.scene) + "Simulated:\n" + simulated_effects(record) + "\n";
  const System& system = record.system;
  Table modes({"mode", "frequency (rad/s)", "frequency (Hz)", "decay rate (1/s)", "damping ratio",
               "modal force (kg^1/2 m/s^2)"});
  const Vector decay = decay_rates(system);
  for (Eigen::Index j = 0; j < system.omega.size(); ++j)
    modes.add({fmt::format("{}", j + 1), fmt::format("{:.8g}", system.omega[j]),
               fmt::format("{:.6g}", system.omega[j] / kTurn), fmt::format("{:.6g}", decay[j]),
               system.omega[j] > 0.0 ? fmt::format("{:.4g}", decay[j] / system.omega[j]) : "-",
               system.forcing() ? fmt::format("{:.6g}", system.forcing()->amplitude[j]) : "-"});
  text += modes.text();
  if (!system.stops.empty()) text += "\n";
  for (std::size_t i = 0; i < system.stops.size(); ++i)
    text += fmt::format("stop {}: effective mass at the contact {:.6g} kg\n", i + 1,
                        1.0 / system.stops[i].row.squaredNorm());
  text += requests_text(record.scene);
  if (record.closure_speed)
    text += fmt::format("a chatter is summed once it is slower than {:.4g} m/s (--closure-speed)\n",
                        *record.closure_speed);
  if (record.collocation_condition > 0.0)
    text +=
        fmt::format("collocation matrix: condition number {:.4g}\n", record.collocation_condition);
  return text;
}

}  // namespace graze
