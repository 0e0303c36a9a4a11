#include "graze/scene/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "graze/scene/detail/choices.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/load_checks.hpp"
#include "graze/scene/detail/range_check.hpp"
#include "graze/scene/detail/section_numbers.hpp"
#include "graze/scene/detail/span_checks.hpp"
#include "graze/scene/detail/table_checks.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/suggestion.hpp"
#include "graze/scene/value_checker.hpp"

namespace graze {
namespace {

static_assert(kModeCount.high == kMostModes);

void check_points(const ValueChecker& checker, const Beam& beam) {
  if (beam.points.empty()) {
    return;
  }
  double before = 0.0;
  for (std::size_t k = 0; k < beam.points.size(); ++k) {
    const double point = beam.points[k];
    if (point <= before || point > beam.length) {
      checker.fail(fmt::format("points.{}", k + 1),
                   fmt::format("{} is not allowed, it must be greater than {} and at most the "
                               "beam's length {}",
                               point, before, beam.length));
    }
    before = point;
  }
}

// All other lists have this many entries.
void check_mode_count(const Scene& scene) {
  if (scene.modal() == nullptr || scene.discrete()) return;
  const std::size_t size = scene.modal()->frequencies.size();
  if (size < 1 || size > kMostModes)
    throw scene_error(
        scene, "modal.frequencies",
        fmt::format("the list has {} entries, it must have 1 to {}", size, kMostModes));
}

// The mass, and the stiffness over it, must be usable numbers. For a string, a bar and a beam whose
// pieces have sections of their own, those of the whole are checked.
void check_size(const ValueChecker& checker, const Beam& beam) {
  const bool sectioned = beam.section.has_value();
  if (!sectioned && !(beam.second_moment && beam.area)) return;
  const SectionNumbers<double> section =
      sectioned ? section_numbers(*beam.section)
                : SectionNumbers<double>{*beam.area, *beam.second_moment};
  checker.usable("density", beam.density * section.area * beam.length, "the mass of the beam, kg,");
  checker.usable("youngs_modulus",
                 beam.youngs_modulus * section.second_moment /
                     (beam.density * section.area * std::pow(beam.length, 4.0)),
                 "the square of its frequencies, 1/s^2,");
}

void check_structure(const Scene& scene) {
  check_span(scene);
  if (const TautString* string = scene.string()) {
    const ValueChecker checker(scene, "string");
    checker.usable("mass_per_length", string->mass_per_length * string->length,
                   "the mass of the string, kg,");
    if (string->tension)
      checker.usable("tension",
                     *string->tension / (string->mass_per_length * string->length * string->length),
                     "the square of its frequencies, 1/s^2,");
  }
  if (const Beam* beam = scene.beam()) {
    const ValueChecker checker(scene, "beam");
    check_size(checker, *beam);
    check_points(checker, *beam);
  }
}

void check_damping(const Scene& scene) {
  if (!scene.damping) {
    return;
  }
  const ModalStructure* modal = scene.modal();
  if (modal != nullptr && std::holds_alternative<ViscousDamping>(*scene.damping))
    throw scene_error(scene, "damping.viscous",
                      fmt::format("viscous damping is per length of a [beam], {} must have ratios "
                                  "or rayleigh",
                                  scene.matrices() ? "[matrices]"
                                  : scene.lumped() ? "[lumped]"
                                                   : "a [modal] structure"));
  if (damping_of_matrices(scene)) {
    const char* given = scene.lumped() ? "lumped.spring.damping" : "matrices.damping";
    throw scene_error(scene, "damping",
                      fmt::format("{0} is given already, the scene must have only one of {0} and "
                                  "[damping]",
                                  given));
  }
  if (modal != nullptr && !modal->damping_ratios.empty()) {
    throw scene_error(scene, "damping",
                      "modal.damping_ratios is given already, the scene must have only one of "
                      "modal.damping_ratios and [damping]");
  }
}

// The error for a matrix structure without the direction that `what` needs.
InputError missing_direction(const Scene& scene, const char* what) {
  return scene_error(scene, "matrices.direction",
                     fmt::format("{} needs the direction of its acceleration, it must be one that "
                                 "degrees of freedom have, 1, 2 or 3 (0 where they have none)",
                                 what));
}

void check_structure_of_matrices(const Scene& scene) {
  const DiscreteStructure* given = scene.discrete();
  if (!given) return;
  if (!given->solved)
    throw scene_error(scene, scene.structure_name(),
                      "its modes have not been computed, call solve_matrices");
  const bool is_based = scene.has_load(ForcingKind::kBase);
  if (given->modal.inertia.empty() && (is_based || scene.gravity))
    throw missing_direction(scene, is_based ? "forcing of the kind \"base\"" : "[gravity]");
  if (scene.has_load(ForcingKind::kModal) && given->modal.participation.empty())
    throw scene_error(scene, "matrices.load",
                      "the key is missing, forcing of the kind \"load\" needs degrees of freedom, "
                      "or load_file");
}

void check_positions(const Scene& scene) {
  double before = -1.0;
  for (const double x : scene.initial->positions) {
    if (!(x > before && x >= 0.0 && x <= scene.span()->length))
      throw scene_error(scene, "initial.positions",
                        fmt::format("{} is not allowed, positions must rise, from 0 to the {}'s "
                                    "length {}",
                                    x, scene.structure_name(), scene.span()->length));
    before = x;
  }
}

// As many numbers as the structure has coordinates, or the scene positions.
void check_start(const Scene& scene) {
  if (!scene.initial) return;
  const Initial& initial = *scene.initial;
  for (const auto& [key, list] : {std::pair("initial.displacement", &initial.displacement),
                                  std::pair("initial.velocity", &initial.velocity)}) {
    const std::size_t count =
        has_own_matrices(scene) ? static_cast<std::size_t>(own_coordinates(scene))
        : scene.discrete() ? static_cast<std::size_t>(scene.discrete()->solved->momenta.cols())
                         : initial.positions.size();
    if (!list->empty() && !scene.discrete() && count == 0)
      throw scene_error(scene, "initial.positions",
                        "the key is missing, it must be where the structure starts so");
    if (!list->empty() && list->size() != count)
      throw scene_error(scene, key,
                        fmt::format("the list has {} entries, it must have {}, one for each {}",
                                    list->size(), count,
                                    scene.lumped()     ? "mass"
                                    : scene.matrices() ? "degree of freedom"
                                                       : "of the positions"));
  }
  check_positions(scene);
  if (initial.speed && scene.modal() && scene.modal()->inertia.empty())
    throw scene_error(scene, "initial.speed",
                      "a speed of the whole structure needs its modal.inertia, or the direction of "
                      "[matrices]; it must be left out");
}

void check_gravity(const Scene& scene) {
  if (!scene.gravity) {
    return;
  }
  if (scene.modal() != nullptr && scene.modal()->inertia.empty()) {
    throw scene_error(scene, "modal.inertia",
                      "the key is missing, [gravity] needs a list of numbers, one per mode");
  }
}

// A point with 15 digits where these suffice (0.225 and not 0.22499999999999998).
std::string point_text(double point, double length) {
  const std::string text = fmt::format("{:.15g}", point);
  const bool same = std::abs(std::strtod(text.c_str(), nullptr) - point) <=
                    std::numeric_limits<double>::epsilon() * length;
  return same ? text : fmt::format("{}", point);
}

void check_collocation_impulse(const ValueChecker& checker, const Scene& scene,
                               const SceneStop& stop) {
  const Beam* beam = scene.beam();
  if (beam == nullptr) {
    checker.fail("impulse",
                 "the collocation impulse needs the collocation points of a [beam], it must be "
                 "\"momentum\"");
  }
  if (collocation_index(*beam, stop.position) >= 0) {
    return;
  }
  std::vector<std::string> points;
  for (const double point : collocation_points(*beam)) {
    points.push_back(point_text(point, beam->length));
  }
  checker.fail("position",
               fmt::format("{} is not allowed with the collocation impulse, it must be the "
                           "collocation point {}",
                           stop.position, joined(points, "or")));
}

void check_stop(const Scene& scene, const SceneStop& stop, std::size_t number) {
  const ValueChecker checker(scene, numbered_path("stop", number));
  if (const Span* span = scene.span()) {
    const bool held = span->ends[0] == Hold::kClamped || span->ends[0] == Hold::kPinned;
    if (!((held ? stop.position > 0.0 : stop.position >= 0.0) && stop.position <= span->length)) {
      checker.fail("position",
                   fmt::format("{} is not allowed, it must be {} 0 and at most the {}'s length {}",
                               stop.position, held ? "greater than" : "at least",
                               scene.structure_name(), span->length));
    }
  } else {
    const char* key = scene.matrices() ? "node" : scene.lumped() ? "mass" : "shape";
    if (std::all_of(stop.shape.begin(), stop.shape.end(), [](double phi) { return phi == 0.0; })) {
      checker.fail(key, scene.discrete() ? "none of the modes moves it"
                                         : "every entry is 0, at least one mode must move at the "
                                           "stop");
    }
    double square = 0.0;
    for (const double phi : stop.shape) square += phi * phi;
    checker.usable(key, 1.0 / square, "the effective mass at the stop, kg,");
  }
  if (stop.spring) {
    check_spring(scene, *stop.spring, numbered_path("stop", number) + ".spring");
    return;
  }
  if (stop.impulse == Impulse::kCollocation) {
    check_collocation_impulse(checker, scene, stop);
  }
}

void check_stops(const Scene& scene) {
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    check_stop(scene, scene.stops[k], k + 1);
    check_motion(scene, scene.stops[k], numbered_path("stop", k + 1));
  }
  // An impact at several stops at once is solved by one law for all of them.
  const SceneStop* rigid = nullptr;
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    if (scene.stops[k].spring) {
      continue;
    }
    if (rigid == nullptr) {
      rigid = &scene.stops[k];
    }
    const Impulse first = rigid->impulse;
    const Impulse here = scene.stops[k].impulse;
    if (here != first) {
      throw scene_error(scene, fmt::format("stop.{}.impulse", k + 1),
                        fmt::format("the law \"{}\" is not allowed beside \"{}\" of the first "
                                    "stop, all stops must have the same impulse law",
                                    name_among(kImpulses, here), name_among(kImpulses, first)));
    }
  }
}

void check_solver(const Scene& scene) {
  const Solver& solver = scene.solver;
  const ValueChecker checker(scene, "solver");
  const bool steps = solver.flow != FlowChoice::kAuto && solver.flow != FlowChoice::kExact &&
                     solver.flow != FlowChoice::kBulirschStoer;
  if (!solver.step) {
    if (solver.flow == FlowChoice::kRk4)
      checker.fail("flow",
                   fmt::format("the flow \"rk4\" needs solver.step, the length of its steps{}",
                               scene.units == Units::kSi ? " in s" : ""));
    return;
  }
  if (!steps)
    checker.fail("step", fmt::format("the flow \"{}\" takes no steps, it must be left out",
                                     flow_name(solver.flow)));
}

}  // namespace

void check_scene(const Scene& scene) {
  check_structure_of_matrices(scene);
  check_mode_count(scene);
  check_ranges(scene);
  check_structure(scene);
  check_hub(scene);
  check_damping(scene);
  check_forcing(scene);
  check_gravity(scene);
  check_loads(scene);
  check_frictions(scene);
  check_start(scene);
  check_stops(scene);
  check_probes(scene);
  check_on_span(scene);
  check_solver(scene);
}

std::vector<double> collocation_points(const Beam& beam) {
  if (!beam.points.empty()) {
    return beam.points;
  }
  std::vector<double> points(static_cast<std::size_t>(beam.modes), beam.length);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    points[k] = static_cast<double>(k + 1) * beam.length / beam.modes;
  }
  return points;
}

int collocation_index(const Beam& beam, double position) {
  const std::vector<double> points = collocation_points(beam);
  const double same = 4.0 * std::numeric_limits<double>::epsilon() * beam.length;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (std::abs(points[k] - position) <= same) {
      return static_cast<int>(k);
    }
  }
  return -1;
}

}  // namespace graze
