#include <fmt/format.h>

#include <cmath>

#include "graze/assembly/detail/requested_restitution.hpp"
#include "graze/assembly/detail/spring_law.hpp"
#include "graze/assembly/probes.hpp"
#include "graze/base/angle.hpp"
#include "graze/base/terminal_text.hpp"
#include "graze/record/records.hpp"
#include "graze/report/text/detail/text_structure.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/detail/table_paths.hpp"
#include "graze/scene/ground_motion.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/study/cost/step_choice.hpp"
#include "graze/system/detail/hub_state.hpp"

namespace graze {
namespace {

std::string damping_text(const SceneStop& stop, const ContactForce& law) {
  if (!stop.spring->damping) return "without damping";
  return fmt::format("with {} damping {:g}", contact_model_name(stop.spring->damping->model),
                     law.coefficient);
}

// Requested and actual restitutions, a line for each.
std::string requests_text(const Scene& scene, const System& system) {
  const TextUnits in(scene.units);
  std::string text;
  for (std::size_t i = 0; i < scene.stops.size(); ++i) {
    if (!scene.stops[i].spring) continue;
    const std::optional<RequestedRestitution> asked =
        requested_restitution(as_given(*scene.stops[i].spring, system.stops[i].force().stiffness));
    if (!asked) continue;
    text += fmt::format("stop {}: requested restitution {:g}", i + 1, asked->requested);
    if (asked->speed) text += " at " + in.quantity(*asked->speed, 6, "m/s");
    if (asked->mass) text += " of " + in.quantity(*asked->mass, 6, "kg");
    text += fmt::format(", one contact gives {:.6g}", asked->effective);
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

// "0.1 1/s M + 0.002 s K"; a part that is rounding beside the other is left out.
std::string proportional_text(const Scene& scene, const ModalDamping& damping) {
  const TextUnits in(scene.units);
  const double fastest = std::ranges::max(scene.modal()->frequencies);
  const double of_mass = std::abs(damping.mass),
               of_stiffness = std::abs(damping.stiffness) * fastest * fastest;
  const double seen = kProportionalExactly * std::max(of_mass, of_stiffness);
  std::string text;
  if (of_mass > seen || of_stiffness == 0.0) text = in.quantity(damping.mass, 6, "1/s") + " M";
  if (!(of_stiffness > seen)) return text;
  const char* sign = damping.stiffness < 0.0 ? "-" : "+";
  const double size = text.empty() ? damping.stiffness : std::abs(damping.stiffness);
  return text + (text.empty() ? "" : fmt::format(" {} ", sign)) + in.quantity(size, 6, "s") + " K";
}

std::string damping_text(const Scene& scene) {
  const TextUnits in(scene.units);
  if (const ModalDamping* damping = damping_of_matrices(scene)) {
    const char* whose = scene.lumped() ? "of dashpots" : "of a matrix";
    return damping->coupling.size() > 0
               ? fmt::format("{}, which couple{} the modes", whose, scene.lumped() ? "" : "s")
           : damping->is_proportional
               ? fmt::format("{}, proportional: {}", whose, proportional_text(scene, *damping))
               : fmt::format("{}, of each mode alone", whose);
  }
  if (!scene.damping)
    return scene.modal() && !scene.modal()->damping_ratios.empty() ? "a ratio for each mode"
                                                                   : "none";
  if (const auto* viscous = std::get_if<ViscousDamping>(&*scene.damping))
    return "viscous, " + in.quantity(viscous->coefficient, 6, "N s/m^2");
  if (const auto* same = std::get_if<DampingRatio>(&*scene.damping))
    return fmt::format("the ratio {} of all modes", digits_text(same->ratio, 6));
  if (const auto* rayleigh = std::get_if<RayleighDamping>(&*scene.damping))
    return fmt::format("Rayleigh, mass {}, stiffness {}", in.quantity(rayleigh->mass, 6, "1/s"),
                       in.quantity(rayleigh->stiffness, 6, "s"));
  return "a ratio for each mode";
}

std::string flow_text(const CheckRecord& record) {
  const FlowDecision decision = flow_decision(record.scene);
  if (!record.steps) return fmt::format("{}: {}", flow_name(decision.flow), decision.reason);
  const Solver& solver = record.scene.solver;
  const TextUnits in(record.scene.units);
  const std::string steps = solver.step
                                ? "steps of " + in.quantity(*solver.step, 6, "s")
                                : fmt::format("steps by their error, {:g}", solver.tolerance);
  return fmt::format("{}: {}; stable up to {}; a contact shows at the ends of steps only",
                     flow_name(solver.flow), steps, in.quantity(record.steps->longest, 6, "s"));
}

// A line of the list of effects.
std::string effect(const std::string& what, const std::string& how) {
  return fmt::format("  {:<12} {}\n", what, how);
}

std::string torque_text(const std::optional<Torque>& torque, const TextUnits& in) {
  if (!torque) return "none: nothing drives the hub";
  if (const auto* pulse = std::get_if<TorquePulse>(&*torque))
    return fmt::format("{} for {}, then none", in.quantity(pulse->amplitude, 6, "N m"),
                       in.quantity(pulse->duration, 6, "s"));
  const auto& table = std::get<TorqueTable>(*torque);
  return fmt::format("{} points from {} to {}, straight between them, none outside",
                     table.times.size(), digits_text(table.times.front(), 6),
                     in.quantity(table.times.back(), 6, "s"));
}

std::string hub_effects(const Hub& hub, const TextUnits& in) {
  return effect("hub", fmt::format("radius {}, inertia {}, {}", in.quantity(hub.radius, 6, "m"),
                                   in.quantity(hub.inertia, 6, "kg m^2"),
                                   hub.equations == HubEquations::kConsistent
                                       ? "equations that conserve energy"
                                       : "equations as in the paper")) +
         effect("torque", torque_text(hub.torque, in)) +
         effect("centrifugal", hub.centrifugal ? "terms with the square of the rate" : "none") +
         effect("friction", hub.friction
                                ? "Coulomb's at the joint, " + in.quantity(*hub.friction, 6, "N m")
                                : "none at the joint");
}

// In both units where the scene has units, first in the one that it is written in.
std::string frequency_text(const Frequency& frequency, const TextUnits& in) {
  const double omega = frequency;
  if (in("Hz").empty()) return digits_text(omega, 6);
  const std::string angular = digits_text(omega, 6) + " rad/s";
  const std::string hertz = digits_text(omega / kTurn, 6) + " Hz";
  return frequency.in_hertz ? hertz + " = " + angular : angular + " = " + hertz;
}

// "at 12.3, ", or between two nodes; empty for modes that are given.
std::string node_text(const std::string& node, const std::string& against, const char* end) {
  if (node.empty()) return "";
  return (against.empty() ? "at " + node : fmt::format("of {} against {}", node, against)) + end;
}

// A number in the unit in which the scene writes it, else in `unit`.
std::string told(const Scene& scene, const std::string& key, double value, const char* unit) {
  return as_written(scene, key, value).value_or(TextUnits(scene.units).quantity(value, 6, unit));
}

std::string point_text(const Scene& scene, const StructurePoint& point) {
  if (!scene.span())
    return point.node.empty() ? "at a point" : node_text(point.node, point.against, "");
  return "at x = " + told(scene, "forcing.position", point.position, "m");
}

// `path`: of its table.
std::string load_text(const Scene& scene, const std::string& path, const HarmonicLoad& forcing) {
  const bool base = forcing.kind == ForcingKind::kBase;
  const bool load = forcing.kind == ForcingKind::kDistributed;
  const bool matrices = scene.discrete() != nullptr;
  const bool point = forcing.kind == ForcingKind::kPoint;
  if (forcing.kind == ForcingKind::kNone) return "no force";
  const bool timed = forcing.signal.has_value();
  const bool support = forcing.kind == ForcingKind::kSupport;
  return fmt::format("{}, {} {}",
                     base       ? std::string(matrices ? "moving base" : "moving clamp")
                     : load     ? "distributed load"
                     : support  ? "moving support " + point_text(scene, forcing.at)
                     : point    ? "force " + point_text(scene, forcing.at)
                     : matrices ? "load"
                                : "modal",
                     timed ? "factor" : "amplitude",
                     told(scene, path + ".amplitude", forcing.amplitude,
                          timed             ? ""
                          : base || support ? "m"
                          : load            ? "N/m"
                          : point           ? "N"
                                            : ""));
}

// When a harmonic load repeats.
std::string harmonic_text(const Scene& scene, const HarmonicLoad& load, const System& system,
                          const TextUnits& in) {
  const double order = load.order.value_or(1.0);
  Frequency frequency = load.own.value_or(scene.forcing->frequency);
  frequency.written *= order;
  return fmt::format("{}{}{}", in("Hz").empty() ? "frequency " : "", frequency_text(frequency, in),
                     scene.further.empty()
                         ? fmt::format(", period {}", in.quantity(system.period(), 6, "s"))
                     : order != 1.0 ? fmt::format(", order {:g}", order)
                                    : "");
}

std::string signal_text(const HarmonicLoad& load, const TextUnits& in) {
  const SignalSource& signal = *load.signal;
  const TimeCourse& course = *signal.course;
  std::string text = fmt::format("a signal of {} instants from {} to {}{}", course.times.size(),
                                 in.quantity(course.times.front(), 6, "s"),
                                 in.quantity(course.times.back(), 6, "s"),
                                 course.repeats ? ", again and again" : "");
  if (load.kind != ForcingKind::kBase) return text;
  if (signal.quantity == BaseRecord::kDisplacement) return text + ", of displacements";
  const Drift drift = drift_of(course);
  return text + fmt::format(", which drifts by {} and {}",
                            in.quantity(load.amplitude * drift.displacement, 4, "m"),
                            in.quantity(load.amplitude * drift.velocity, 4, "m/s"));
}

// A line for each load; the period is that of all of them.
std::string forcing_text(const Scene& scene, const System& system, const TextUnits& in) {
  if (!scene.forcing) return effect("forcing", "none");
  std::string text;
  std::size_t number = 0;
  for (const HarmonicLoad* load : scene.harmonic_loads()) {
    const std::string path = numbered_path("forcing", ++number);
    text += effect(
        scene.further.empty() ? "forcing" : fmt::format("forcing {}", number),
        load_text(scene, path, *load) + ", " +
            (load->signal ? signal_text(*load, in) : harmonic_text(scene, *load, system, in)));
  }
  if (!scene.further.empty())
    text += effect("period", scene.repeats() ? fmt::format("{}, of all loads together",
                                                           in.quantity(system.period(), 6, "s"))
                                             : "none: the loads do not repeat together");
  return text;
}

std::string gravity_text(const Scene& scene) {
  if (!scene.gravity) return "none";
  return fmt::format("{} along {}",
                     told(scene, "gravity.acceleration", scene.gravity->acceleration, "m/s^2"),
                     scene.hub ? "-u at angle 0" : "+u");
}

// How it moves; empty where it stands still.
std::string motion_text(const Scene& scene, const SceneStop& stop, const std::string& path) {
  std::string text = stop.frame == StopFrame::kSpace ? "fixed in space, " : "";
  std::size_t number = 0;
  for (const StopMotion& term : stop.motion) {
    const double order = term.order.value_or(1.0);
    text += fmt::format("{} {}{}", number == 0 ? "moves by" : "and",
                        told(scene, numbered_path(path + ".motion", number + 1) + ".amplitude",
                             term.amplitude, "m"),
                        order == 1.0 ? "" : fmt::format(" of order {:g}", order));
    text += ++number == stop.motion.size() ? ", " : " ";
  }
  return text;
}

// `path`: of its table.
std::string stop_text(const Scene& scene, const std::string& path, const SceneStop& stop,
                      const Stop& assembled) {
  const TextUnits in(scene.units);
  const std::string gap = told(scene, path + ".gap", stop.gap, "m");
  const std::string place = fmt::format(
      "{}{}, gap {}, {}",
      scene.span() ? fmt::format("at x = {}, ", told(scene, path + ".position", stop.position, "m"))
                   : node_text(stop.node, stop.against, ", "),
      stop.side == Side::kAbove ? "above" : "below", gap, motion_text(scene, stop, path));
  if (stop.spring) {
    const ContactForce& law = assembled.force();
    // Without units the exponent is given separately.
    const std::string exponent = fmt::format("{:g}", law.exponent);
    const std::string unit = in(law.exponent == 1.0 ? "N/m" : "N/m^" + exponent);
    const std::string met = in.quantity(assembled.gap, 6, "m");
    const std::string shifted = met == in.quantity(stop.gap, 6, "m")
                                    ? ""
                                    : ", met by the modes at " + met + " under the load";
    return place + fmt::format("compliant{}: {}{} {}, separates at zero {}{}",
                               stop.spring->is_residual ? " by the modes left out" : "",
                               as_written(scene, path + ".spring.stiffness", law.stiffness)
                                   .value_or(quantity_text(law.stiffness, 6, unit)),
                               unit.empty() ? " x^" + exponent : "", damping_text(stop, law),
                               law.separation == Separation::kAtZeroForce ? "force" : "depth",
                               shifted);
  }
  return place + fmt::format("restitution {}, {} impulse", restitution_text(stop.restitution),
                             stop.impulse == Impulse::kMomentum ? "momentum" : "collocation");
}

std::string probe_text(const Scene& scene, const Probe& probe) {
  const TextUnits in(scene.units);
  const std::string unit = in(probe_unit(probe.quantity));
  return fmt::format("{}{}{}", probe_quantity_name(probe.quantity),
                     unit.empty() ? "" : fmt::format(" ({})", unit),
                     is_of_hub(probe.quantity) ? " of the hub"
                     : scene.span()            ? " at x = " + in.quantity(probe.position, 6, "m")
                     : probe.node.empty()      ? std::string()
                                               : " " + node_text(probe.node, probe.against, ""));
}

std::string friction_text(const Scene& scene, std::size_t k, const TextUnits& in) {
  const DryFriction& friction = scene.frictions[k];
  const auto force = [&](double size) {
    return friction.stop == 0
               ? in.quantity(size, 6, "N")
               : fmt::format("{} of the force of stop {}", digits_text(size, 6), friction.stop);
  };
  std::string text = fmt::format("{} {}, slides against {}", scene.span() ? "at x =" : "at",
                                 scene.span()            ? in.quantity(friction.position, 6, "m")
                                 : friction.node.empty() ? "the shape given"
                                 : friction.against.empty()
                                     ? friction.node
                                     : friction.node + " against " + friction.against,
                                 force(friction.sliding()));
  if (friction.sticking() != friction.sliding())
    text += ", sticks up to " + force(friction.sticking());
  if (friction.series > 0.0)
    text += ", behind a spring of " + in.quantity(friction.series, 6, "N/m");
  if (friction.parallel > 0.0)
    text += ", beside a spring of " + in.quantity(friction.parallel, 6, "N/m");
  if (friction.speed != 0.0) text += ", from a belt at " + in.quantity(friction.speed, 6, "m/s");
  return text;
}

std::string simulated_effects(const CheckRecord& record) {
  const Scene& scene = record.scene;
  const TextUnits in(scene.units);
  std::string text;
  for (const auto& [name, what] : structure_effects(scene, record.model.elements))
    text += effect(name, what);
  if (scene.hub) text += hub_effects(*scene.hub, in);
  text += effect("damping", damping_text(scene));
  // A hub is driven by its torque.
  if (!scene.hub) text += forcing_text(scene, record.system, in);
  text += effect("gravity", gravity_text(scene));
  if (!scene.loads.empty())
    text += effect("loads", fmt::format("{} constant force{}", scene.loads.size(),
                                        scene.loads.size() == 1 ? "" : "s"));
  for (std::size_t i = 0; i < scene.stops.size(); ++i)
    text += effect(
        fmt::format("stop {}", i + 1),
        stop_text(scene, numbered_path("stop", i + 1), scene.stops[i], record.system.stops[i]));
  for (std::size_t i = 0; i < scene.frictions.size(); ++i)
    text += effect(fmt::format("friction {}", i + 1), friction_text(scene, i, in));
  if (scene.stops.empty()) text += effect("stop", "none: no contact is looked for");
  for (std::size_t i = 0; i < scene.probes.size(); ++i)
    text += effect(fmt::format("probe {}", i + 1), probe_text(scene, scene.probes[i]));
  return text + effect("flow", flow_text(record));
}

}  // namespace

std::string to_text(const CheckRecord& record, const TextOptions& options) {
  std::string text = title(record.scene) + "Simulated:\n" + simulated_effects(record) + "\n";
  const System& system = record.system;
  const TextUnits in(record.scene.units);
  const bool has_hertz = !in("Hz").empty();
  std::vector<std::string> header = {"mode", in.head("frequency", "rad/s")};
  if (has_hertz) header.emplace_back("frequency (Hz)");
  header.insert(header.end(), {in.head("decay rate", "1/s"), "damping ratio",
                               in.head("modal force", "kg^1/2 m/s^2")});
  Table modes(header);
  const Vector decay = decay_rates(system);
  const std::optional<Vector> forces = modal_forces(system);
  const double largest = forces ? forces->cwiseAbs().maxCoeff() : 0.0;
  for (Eigen::Index j = 0; j < system.omega.size(); ++j) {
    std::vector<std::string> row = {std::to_string(j + 1), digits_text(system.omega[j], 8)};
    if (has_hertz) row.push_back(digits_text(system.omega[j] / kTurn, 6));
    row.push_back(digits_text(decay[j], 6));
    row.push_back(system.omega[j] > 0.0 ? digits_text(decay[j] / system.omega[j], 4) : "-");
    row.push_back(forces ? digits_text((*forces)[j], 6, largest) : "-");
    modes.add(row);
  }
  text += modes.text(options.width);
  if (!system.stops.empty()) text += "\n";
  for (std::size_t i = 0; i < system.stops.size(); ++i)
    text += fmt::format("stop {}: effective mass at the contact {}\n", i + 1,
                        in.quantity(1.0 / system.stops[i].row.squaredNorm(), 6, "kg"));
  text += requests_text(record.scene, system);
  if (record.closure_speed)
    text += fmt::format(
        "closure speed {}: below it the rest of a chatter is computed at once (--closure-speed)\n",
        in.quantity(*record.closure_speed, 4, "m/s"));
  if (record.collocation_condition > 0.0)
    text +=
        fmt::format("collocation matrix: condition number {:.4g}\n", record.collocation_condition);
  return text;
}

}  // namespace graze
