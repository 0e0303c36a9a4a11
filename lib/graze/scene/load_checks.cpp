#include "graze/scene/detail/load_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "graze/scene/detail/table_paths.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

// A force may act on a node of a mode, but somewhere on the structure.
void check_load_point(const Scene& scene, const StructurePoint& point, const std::string& table) {
  const Span* span = scene.span();
  if (span && !(point.position >= 0.0 && point.position <= span->length))
    throw scene_error(scene, table + ".position",
                      fmt::format("{} is not allowed, it must be at least 0 and at most the {}'s "
                                  "length {}",
                                  point.position, scene.structure_name(), span->length));
}

// Of the springs that phases in closed form know.
bool is_linear(const Spring& spring) {
  return !spring.geometry && (spring.exponent == 1.0 || spring.is_residual) &&
         (!spring.damping || spring.damping->model == ContactModel::kKelvinVoigt);
}

void check_friction_at_stop(const ValueChecker& checker, const Scene& scene,
                            const DryFriction& friction) {
  const auto count = static_cast<int>(scene.stops.size());
  if (friction.stop < 1 || friction.stop > count)
    checker.fail("stop", fmt::format("there is no stop {}, it must be the number of one of {}",
                                     friction.stop, count));
  if (!scene.stops[static_cast<std::size_t>(friction.stop) - 1].spring)
    checker.fail("stop",
                 "what friction does to a body that hits a rigid stop needs a law of its own, the "
                 "stop must have a spring");
  if (friction.speed != 0.0)
    checker.fail("speed", "a belt at a stop is not known, it must be left out");
}

}  // namespace

// What springs beside friction, and in series with it, need.
void check_friction_springs(const ValueChecker& checker, const Scene& scene,
                            const DryFriction& friction) {
  const char* key = friction.series > 0.0 ? "series" : "parallel";
  if (!has_own_matrices(scene))
    checker.fail(key,
                 "it needs a structure of [lumped], or of [matrices] in the scene, whose "
                 "modes it changes; it must be left out");
  if (friction.series == 0.0) return;
  if (friction.speed != 0.0 || friction.stop != 0 || friction.sticking() != friction.sliding())
    checker.fail(key,
                 "behind a spring friction has one force, against the ground or another place "
                 "that carries it along (against); speed, stop and those at rest must be left "
                 "out");
  if (scene.discrete()->modes != 0)
    throw scene_error(scene, fmt::format("{}.modes", scene.structure_name()),
                      "a spring in series with friction needs all modes, it must be left out");
  if (scene.damping)
    throw scene_error(scene, "damping",
                      "damping of modes would act on what rubs behind a spring, which has no mass; "
                      "dashpots or a damping matrix must be in its place");
}

void check_frictions(const Scene& scene) {
  if (scene.frictions.empty()) return;
  if (scene.hub)
    throw scene_error(scene, "friction",
                      "a structure on a hub has friction at its joint alone, hub.friction; "
                      "[[friction]] must be left out");
  if (scene.solver.flow != FlowChoice::kAuto && scene.solver.flow != FlowChoice::kExact)
    throw scene_error(scene, "solver.flow",
                      "with dry friction a motion is followed exactly, it must be \"auto\" or "
                      "\"exact\"");
  for (std::size_t k = 0; k < scene.stops.size(); ++k)
    if (const std::optional<Spring>& spring = scene.stops[k].spring; spring && !is_linear(*spring))
      throw scene_error(scene, numbered_path("stop", k + 1) + ".spring",
                        "with dry friction a motion is followed exactly, and springs must be "
                        "linear, with \"kelvin-voigt\" damping or none");
  if (scene.has_moving_stop() || scene.has_load(ForcingKind::kSupport))
    throw scene_error(scene, "friction",
                      "beside stops or supports that move friction is not known, [[friction]] must "
                      "be left out");
  constexpr int kMostModes = 128;  // kMostModesOnLinearSprings
  const auto springs = [](const SceneStop& stop) { return stop.spring.has_value(); };
  if (scene.modes() > kMostModes && std::any_of(scene.stops.begin(), scene.stops.end(), springs))
    throw scene_error(
        scene, "friction",
        fmt::format("beside springs it is followed with at most {} modes", kMostModes));
  for (std::size_t k = 0; k < scene.frictions.size(); ++k) {
    const DryFriction& friction = scene.frictions[k];
    const std::string table = numbered_path("friction", k + 1);
    check_load_point(scene, friction, table);
    if (const Span* span = scene.span()) {
      const bool at_start = friction.position == 0.0, at_end = friction.position == span->length;
      if ((at_start && span->ends[0] != Hold::kFree && span->ends[0] != Hold::kSpring) ||
          (at_end && span->ends[1] != Hold::kFree && span->ends[1] != Hold::kSpring))
        throw scene_error(scene, table + ".position",
                          fmt::format("{} is not allowed, the {} is held there", friction.position,
                                      scene.structure_name()));
    }
    const ValueChecker checker(scene, table);
    if (!friction.force && !friction.coefficient)
      checker.fail("force",
                   "the key is missing, it must be given, or coefficient and normal_force");
    if (friction.coefficient && friction.stop == 0 && !friction.normal_force)
      checker.fail("normal_force", "the key is missing, it must be given, or stop");
    if (friction.stop != 0) check_friction_at_stop(checker, scene, friction);
    if (friction.series > 0.0 || friction.parallel > 0.0)
      check_friction_springs(checker, scene, friction);
    if (friction.sticking() < friction.sliding())
      checker.fail(friction.static_force ? "static_force" : "static_coefficient",
                   fmt::format("it gives {} at rest and {} in sliding, it must be at least as much "
                               "at rest",
                               friction.sticking(), friction.sliding()));
  }
}

void check_loads(const Scene& scene) {
  if (scene.loads.empty()) return;
  if (scene.hub)
    throw scene_error(scene, "load",
                      "a structure on a hub carries no point loads, [[load]] must be left out");
  for (std::size_t k = 0; k < scene.loads.size(); ++k)
    check_load_point(scene, scene.loads[k], numbered_path("load", k + 1));
}

namespace {

// Springs carry a displacement of their far end, dashpots its rate, which a course along straight
// lines has no more of than its slope.
void check_support(const Scene& scene, const HarmonicLoad& load, const std::string& table) {
  const ValueChecker checker(scene, table);
  // Those of matrices are checked where these are read.
  const std::array<double, 2> springs =
      scene.lumped() ? support_of(scene, load) : std::array<double, 2>{1.0, 0.0};
  if (springs[0] == 0.0 && springs[1] == 0.0)
    checker.fail("kind",
                 fmt::format("nothing connects mass {} with the ground, it must be a mass with "
                             "a spring to 0",
                             load.at.node));
  const auto* rayleigh = scene.damping ? std::get_if<RayleighDamping>(&*scene.damping) : nullptr;
  if (load.signal && (springs[1] != 0.0 || (rayleigh && rayleigh->stiffness != 0.0)))
    checker.fail("signal",
                 "the support has a dashpot, whose force would jump at each instant of the signal; "
                 "the dashpot must be left out, or the signal be one of forces");
  if (scene.has_load(ForcingKind::kBase))
    checker.fail(
        "kind",
        "displacements count from the base where that moves, and from where supports stand "
        "where these do; the loads must be of one of both kinds");
}

void check_load(const Scene& scene, const HarmonicLoad& load, const std::string& table) {
  const ValueChecker checker(scene, table);
  if (load.signal && !load.signal->course) checker.fail("signal", "it has not been read");
  if (load.signal && load.kind == ForcingKind::kNone)
    checker.fail("kind", "a signal is that of a load, it must not be \"none\"");
  if (scene.forcing->signal && !scene.forcing->signal->repeats && load.order)
    checker.fail(
        "order",
        "the first load is a signal that does not repeat, there must be a frequency in its "
        "place");
  if (load.kind == ForcingKind::kSupport) check_support(scene, load, table);
  const ModalStructure* modal = scene.modal();
  if (load.has_place()) check_load_point(scene, load.at, table);
  if (modal == nullptr && load.kind == ForcingKind::kModal) {
    checker.fail("kind", "modal forcing needs [modal], it must be base or distributed");
  }
  if (modal != nullptr && load.kind == ForcingKind::kDistributed) {
    checker.fail("kind", fmt::format("distributed forcing needs [beam], it must be {} or base",
                                     scene.matrices() ? "load"
                                     : scene.lumped() ? "point"
                                                      : "modal"));
  }
  if (modal != nullptr && load.kind == ForcingKind::kModal && modal->participation.empty()) {
    throw scene_error(scene, "modal.participation",
                      "the key is missing, forcing of the kind \"modal\" needs a list of numbers, "
                      "one per mode");
  }
  if (modal != nullptr && load.kind == ForcingKind::kBase && modal->inertia.empty()) {
    throw scene_error(scene, "modal.inertia",
                      "the key is missing, forcing of the kind \"base\" needs a list of numbers, "
                      "one per mode");
  }
}

}  // namespace

void check_forcing(const Scene& scene) {
  if (!scene.forcing) {
    return;
  }
  if (scene.forcing->frequency.in_hertz && scene.units == Units::kNone)
    ValueChecker(scene, "forcing")
        .fail("frequency_hz",
              "Hz is a unit and the scene has units = \"none\", it must be frequency");
  std::size_t number = 0;
  for (const HarmonicLoad* load : scene.harmonic_loads())
    check_load(scene, *load, numbered_path("forcing", ++number));
  if (!(scene.common_order() > 0.0))
    throw scene_error(
        scene,
        !scene.further.empty()    ? "forcing.2.order"
        : scene.has_moving_stop() ? "stop.motion"
                                  : "forcing.order",
        "the frequencies of loads and stops have no common period of up to 64 periods of "
        "the forcing, orders must be whole numbers or ratios of small ones");
}

// What moves in time needs a frequency, and what stays in space something that is shaken.
void check_motion(const Scene& scene, const SceneStop& stop, const std::string& table) {
  if (stop.motion.empty() && stop.frame == StopFrame::kClamp) return;
  if (stop.frame == StopFrame::kSpace && (!stop.against.empty() || scene.hub))
    throw scene_error(scene, table + ".frame",
                      "the stop is part of the structure, it must be left out");
  if (stop.frame == StopFrame::kSpace && !scene.has_load(ForcingKind::kBase))
    throw scene_error(scene, table + ".frame",
                      "no forcing of the kind \"base\" shakes anything, it must be left out");
  const auto is_base = [](const HarmonicLoad* load) { return load->kind == ForcingKind::kBase; };
  for (const HarmonicLoad* load : scene.harmonic_loads())
    if (stop.frame == StopFrame::kSpace && is_base(load) && (load->own || load->signal))
      throw scene_error(scene, table + ".frame",
                        "the clamp is shaken by a load that is no harmonic of the first; a stop "
                        "that stays in space meanwhile is not simulated, it must be left out");
  if (stop.motion.empty()) return;
  if (scene.forcing && scene.forcing->signal && !scene.forcing->signal->repeats)
    throw scene_error(
        scene, table + ".motion",
        "the first load is a signal that does not repeat, so there is no frequency for "
        "stops to move by; it must stand behind a harmonic one");
  if (scene.hub)
    throw scene_error(scene, table + ".motion",
                      "a stop of a structure on a hub does not move, it must be left out");
  if (!scene.forcing)
    throw scene_error(scene, "forcing",
                      "the table is missing, a stop that moves needs its frequency (with kind = "
                      "\"none\" where no force acts)");
}

}  // namespace graze
