#include "graze/study/cost/step_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/flow/sprung/detail/linear_spring_phase.hpp"
#include "graze/system/scale.hpp"

namespace graze {
std::optional<StepMethod> step_method(FlowChoice flow) {
  switch (flow) {
    case FlowChoice::kAuto:
    case FlowChoice::kExact:
    case FlowChoice::kBulirschStoer:
      return {};
    case FlowChoice::kRk4:
      return StepMethod::kRk4;
    case FlowChoice::kDopri5:
      return StepMethod::kDopri5;
    case FlowChoice::kFehlberg78:
      return StepMethod::kFehlberg78;
  }
  return {};
}

double modal_speed(const System& system, const State& start) {
  double speed = std::hypot(start.qdot.norm(), system.omega.cwiseProduct(start.q).norm());
  if (system.forcing())
    speed = std::max(speed, system.forcing()->size().norm() / system.forcing()->frequency);
  const double at_stops = speed_scale(system, start);
  for (const Stop& stop : system.stops)
    if (stop.row.norm() > 0.0) speed = std::max(speed, at_stops / stop.row.norm());
  return speed > 0.0 ? speed : 1.0;
}

namespace {

bool is_linear(const Spring& spring) {
  const bool linear = spring.is_residual || (!spring.geometry && spring.exponent == 1.0);
  return linear && (!spring.damping || spring.damping->model == ContactModel::kKelvinVoigt);
}

bool has_closed_contacts(const Scene& scene) {
  return scene.modes() <= kMostModesOnLinearSprings &&
         std::all_of(scene.stops.begin(), scene.stops.end(),
                     [](const SceneStop& stop) { return !stop.spring || is_linear(*stop.spring); });
}

}  // namespace

FlowDecision flow_decision(const Scene& scene) {
  const Solver& solver = scene.solver;
  if (solver.flow != FlowChoice::kAuto) return {solver.flow, "the scene asks for it"};
  if (scene.hub)
    return {
        FlowChoice::kBulirschStoer,
        "the motion of a structure on a hub has no closed form; it is integrated to 1e-14 of its "
        "velocities a step, whatever the tolerance, and no step is longer than a quarter of the "
        "quickest oscillation, so that no gap falls and rises within one unseen"};
  const std::string why =
      "every effect in this scene is linear between impacts, so motion and first contact have "
      "closed forms: they ";
  // Rounding enters at every impact and grows from one to the next: after twenty on the shipped
  // scenes it is some 1e-13 of a forcing period.
  constexpr double kRoundingOfImpacts = 1e-12;
  if (solver.tolerance < kRoundingOfImpacts)
    return {FlowChoice::kExact,
            why + fmt::format("err by rounding alone, which may exceed the tolerance {:g}, and "
                              "nothing in double precision errs less",
                              solver.tolerance)};
  const bool compliant = std::any_of(scene.stops.begin(), scene.stops.end(),
                                     [](const SceneStop& stop) { return stop.spring.has_value(); });
  // The growth of these errors from contact to contact depends on the motion, and steps with a
  // tolerance of their own may cost less: no accuracy is promised.
  if (compliant && has_closed_contacts(scene))
    return {FlowChoice::kExact,
            "every effect in this scene is linear, between contacts and while the same springs are "
            "compressed, so motion and the ends of contacts have closed forms; they err by "
            "rounding, whatever the tolerance"};
  if (compliant)
    return {FlowChoice::kExact,
            "between contacts every effect in this scene is linear, so motion and first contact "
            "have closed forms; contacts with compliant stops are integrated to 1e-14 of their "
            "speed, whatever the tolerance"};
  return {FlowChoice::kExact,
          why + fmt::format("meet the tolerance {:g}, and cost less than steps that would",
                            solver.tolerance)};
}

StepSetting stable_steps(const System& system, const State& start, StepMethod method) {
  StepSetting setting;
  setting.method = method;
  setting.speed = modal_speed(system, start);
  setting.longest = longest_stable_step(system, method);
  for (const Stop& stop : system.stops)
    if (std::isinf(setting.longest) && speed_scale(system, start) > 0.0 &&
        reach_at(system, stop) > 0.0)
      setting.longest = reach_at(system, stop) / speed_scale(system, start);
  if (std::isinf(setting.longest)) setting.longest = system.repeats() ? system.period() : 1.0;
  return setting;
}

std::optional<StepSetting> step_choice(const Scene& scene, const System& system,
                                       const State& start) {
  const std::optional<StepMethod> method = step_method(flow_decision(scene).flow);
  if (!method) return {};
  StepSetting setting = stable_steps(system, start, *method);
  setting.step = scene.solver.step.value_or(0.0);
  setting.tolerance = scene.solver.tolerance;
  const double stable = longest_stable_step(system, *method);
  const std::string second = unit_behind(scene.units, "s");
  if (setting.step > stable)
    throw scene_error(
        scene, "solver.step",
        fmt::format("{:g}{} is not allowed, with {} it must be at most {:.6g}{}: "
                    "beyond that the quickest mode grows without bound",
                    setting.step, second, flow_name(scene.solver.flow), stable, second));
  return setting;
}

void require_clamp(const Scene& scene, const char* what) {
  if (!scene.hub) return;
  throw scene_error(scene, "hub",
                    fmt::format("{} under a forcing that repeats itself; a structure on a hub has "
                                "none, its torque is a pulse or a table",
                                what));
}

void require_exact_flow(const Scene& scene, const char* what) {
  require_clamp(scene, what);
  if (!step_method(flow_decision(scene).flow)) return;
  throw scene_error(scene, "solver.flow",
                    fmt::format("the flow \"{}\" is not allowed where {}, it must be \"auto\" or "
                                "\"exact\"",
                                flow_name(scene.solver.flow), what));
}

}  // namespace graze
