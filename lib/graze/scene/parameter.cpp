#include "graze/scene/parameter.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include "graze/scene/check.hpp"
#include "graze/scene/detail/suggestion.hpp"

namespace graze {
namespace {

// Const where Other is.
template <typename Other, typename T>
using Like = std::conditional_t<std::is_const_v<Other>, const T, T>;

// Calls f(name, number) for every entry of the list, names counted from 1.
template <typename List, typename F>
void visit_list(List& list, const std::string& name, F&& f) {
  std::size_t k = 0;
  for (auto& value : list) {
    f(fmt::format("{}.{}", name, ++k), value);
  }
}

template <typename S, typename F>
void visit_structure(S& scene, F&& f) {
  if (auto* beam = std::get_if<Beam>(&scene.structure)) {
    f("beam.length", beam->length);
    f("beam.youngs_modulus", beam->youngs_modulus);
    f("beam.second_moment", beam->second_moment);
    f("beam.density", beam->density);
    f("beam.area", beam->area);
    if (beam->thickness) f("beam.thickness", *beam->thickness);
    visit_list(beam->points, "beam.points", f);
  } else {
    auto& modal = std::get<ModalStructure>(scene.structure);
    visit_list(modal.frequencies, "modal.frequencies", f);
    visit_list(modal.damping_ratios, "modal.damping_ratios", f);
    visit_list(modal.participation, "modal.participation", f);
    visit_list(modal.inertia, "modal.inertia", f);
  }
}

template <typename H, typename F>
void visit_hub(H& hub, F&& f) {
  f("hub.radius", hub.radius);
  f("hub.inertia", hub.inertia);
  if (hub.torque) {
    if (auto* pulse = std::get_if<TorquePulse>(&*hub.torque)) {
      f("hub.torque.amplitude", pulse->amplitude);
      f("hub.torque.duration", pulse->duration);
    }
  }
  if (hub.friction) f("hub.friction.coulomb", *hub.friction);
}

template <typename D, typename F>
void visit_damping(D& damping, F&& f) {
  if (auto* viscous = std::get_if<ViscousDamping>(&damping)) {
    f("damping.viscous", viscous->coefficient);
  } else if (auto* ratios = std::get_if<DampingRatios>(&damping)) {
    visit_list(ratios->ratios, "damping.ratios", f);
  } else {
    auto& rayleigh = std::get<RayleighDamping>(damping);
    f("damping.rayleigh.mass", rayleigh.mass);
    f("damping.rayleigh.stiffness", rayleigh.stiffness);
  }
}

template <typename Sp, typename F>
void visit_spring(Sp& spring, const std::string& name, F&& f) {
  if (!spring.geometry) {
    f(name + ".stiffness", spring.stiffness);
    f(name + ".exponent", spring.exponent);
  }
  if (!spring.damping) {
    return;
  }
  const auto visit = [&](const char* key, auto& value) {
    if (value) {
      f(name + ".damping." + key, *value);
    }
  };
  auto& damping = *spring.damping;
  visit("coefficient", damping.coefficient);
  visit("ratio", damping.ratio);
  visit("alpha", damping.alpha);
  visit("restitution", damping.restitution);
  visit("speed", damping.speed);
  visit("mass", damping.mass);
  visit("onset", damping.onset);
  visit("sharpness", damping.sharpness);
}

// Calls f(name, number) for every continuous parameter of the scene: the one list of names.
template <typename S, typename F>
void visit_parameters(S& scene, F&& f) {
  visit_structure(scene, f);
  if (scene.hub) {
    visit_hub(*scene.hub, f);
  }
  if (scene.damping) {
    visit_damping(*scene.damping, f);
  }
  if (scene.forcing) {
    f("forcing.amplitude", scene.forcing->amplitude);
    f("forcing.frequency", scene.forcing->frequency);
    f("forcing.phase", scene.forcing->phase);
  }
  if (scene.gravity) {
    f("gravity.acceleration", scene.gravity->acceleration);
  }
  const bool beam = scene.beam() != nullptr;
  for (std::size_t k = 0; k < scene.stops.size(); ++k) {
    const std::string stop = k == 0 ? "stop" : fmt::format("stop.{}", k + 1);
    auto& values = scene.stops[k];
    if (beam) {
      f(stop + ".position", values.position);
    }
    f(stop + ".gap", values.gap);
    if (values.spring) {
      visit_spring(*values.spring, stop + ".spring", f);
    } else if (values.restitution.size() == 1) {
      f(stop + ".restitution", values.restitution.front());
    } else {
      visit_list(values.restitution, stop + ".restitution", f);
    }
    visit_list(values.shape, stop + ".shape", f);
  }
}

// "stop.1.gap" is "stop.gap".
std::string canonical(const std::string& path) {
  const std::string first = "stop.1.";
  return path.compare(0, first.size(), first) == 0 ? "stop." + path.substr(first.size()) : path;
}

template <typename S>
Like<S, double>* found_parameter(S& scene, const std::string& path) {
  Like<S, double>* result = nullptr;
  const std::string wanted = canonical(path);
  visit_parameters(scene, [&](const std::string& name, auto& value) {
    if (name == wanted) {
      result = &value;
    }
  });
  return result;
}

// "modal.frequencies.1..4" for the four entries, so that a message stays readable.
std::vector<std::string> shortened(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  std::string list;  // the list whose entries are being passed
  for (const std::string& name : names) {
    const std::size_t dot = name.rfind('.');
    const std::string number = name.substr(dot + 1);
    if (number.find_first_not_of("0123456789") != std::string::npos) {
      result.push_back(name);
      list.clear();
    } else if (name.substr(0, dot) != list) {
      list = name.substr(0, dot);
      result.push_back(name);
    } else {
      result.back() = fmt::format("{}.1..{}", list, number);
    }
  }
  return result;
}

// Entry k + 1 of a restitution is the factor of v^k, and a constant has no number.
std::string restitution_unit(const std::string& entry) {
  if (entry.empty() || entry == "1") {
    return "";
  }
  const long power = std::strtol(entry.c_str(), nullptr, 10) - 1;
  return power == 1 ? "s/m" : fmt::format("s^{0}/m^{0}", power);
}

// Of stop.spring.* and stop.N.spring.*
std::string spring_unit(const Scene& scene, const std::string& path) {
  const std::string key = path.substr(path.rfind('.') + 1);
  const long number = std::strtol(path.c_str() + 5, nullptr, 10);
  const auto stop = static_cast<std::size_t>(number > 0 ? number - 1 : 0);
  if (stop >= scene.stops.size() || !scene.stops[stop].spring) {
    return "";
  }
  const Spring& spring = *scene.stops[stop].spring;
  const double exponent = spring.geometry ? 1.5 : spring.exponent;
  const auto per_length = [](double power) {
    return power == 1.0 ? std::string("N s/m") : fmt::format("N s/m^{:g}", power);
  };
  if (key == "stiffness") {
    return exponent == 1.0 ? "N/m" : fmt::format("N/m^{:g}", exponent);
  }
  if (key == "coefficient") {
    switch (spring.damping->model) {
      case ContactModel::kKelvinVoigt:
      case ContactModel::kLeeWang2:
        return per_length(1.0);
      case ContactModel::kLeeWang1:
        return per_length(2.0);
      default:
        return per_length(exponent + 1.0);
    }
  }
  if (key == "alpha") return "s/m";
  if (key == "speed") return "m/s";
  if (key == "mass") return "kg";
  return key == "onset" ? "m" : "";
}

void zero_what_is_no_parameter(Scene& scene) {
  const auto zero = [](std::vector<double>& list) { list.assign(list.size(), 0.0); };
  if (scene.initial) {
    zero(scene.initial->q);
    zero(scene.initial->qdot);
    scene.initial->angle = scene.initial->rate = 0.0;
  }
  if (scene.hub && scene.hub->torque) {
    if (auto* table = std::get_if<TorqueTable>(&*scene.hub->torque)) {
      zero(table->times);
      zero(table->values);
    }
  }
  for (Probe& probe : scene.probes) {
    probe.position = 0.0;
    zero(probe.shape);
  }
  scene.solver.tolerance = 0.0;
}

InputError unknown_parameter(const Scene& scene, const std::string& path) {
  const std::vector<std::string> names = parameter_names(scene);
  const std::string meant = closest_name(path, names);
  const std::string question = meant.empty() ? "" : fmt::format(" Did you mean {}?", meant);
  return InputError(fmt::format("{}: the scene has no such continuous parameter.{} Allowed are {}.",
                                path.empty() ? "parameter" : path, question,
                                joined(shortened(names), "and")));
}

}  // namespace

double* find_parameter(Scene& scene, const std::string& path) {
  return found_parameter(scene, path);
}

const double* find_parameter(const Scene& scene, const std::string& path) {
  return found_parameter(scene, path);
}

std::vector<std::string> parameter_names(const Scene& scene) {
  std::vector<std::string> names;
  visit_parameters(scene, [&](const std::string& name, const double&) { names.push_back(name); });
  return names;
}

Scene with_parameter(const Scene& scene, const std::string& path, double value) {
  Scene changed = scene;
  double* parameter = find_parameter(changed, path);
  if (parameter == nullptr) {
    throw unknown_parameter(scene, path);
  }
  *parameter = value;
  // The value is not the one in the file, so no message may point there.
  changed.origins = nullptr;
  check_scene(changed);
  changed.origins = scene.origins;
  return changed;
}

Scene parameter_direction(const Scene& scene, const std::string& path) {
  Scene direction = scene;
  visit_parameters(direction, [](const std::string&, double& value) { value = 0.0; });
  zero_what_is_no_parameter(direction);
  double* parameter = find_parameter(direction, path);
  if (parameter == nullptr) {
    throw unknown_parameter(scene, path);
  }
  *parameter = 1.0;
  return direction;
}

bool leaves_structure(const std::string& path) {
  const auto begins = [&](const char* with) { return path.rfind(with, 0) == 0; };
  const auto contains = [&](const char* part) { return path.find(part) != std::string::npos; };
  return begins("forcing.") || begins("gravity.") || begins("hub.") || path == "beam.thickness" ||
         (begins("stop.") && (contains(".gap") || contains(".restitution") || contains(".spring")));
}

std::string parameter_unit(const Scene& scene, const std::string& path) {
  std::string name = canonical(path);
  // Entries of a list, and stops after the first, have the unit of the first.
  const std::size_t dot = name.rfind('.');
  std::string entry;
  if (dot != std::string::npos &&
      name.find_first_not_of("0123456789", dot + 1) == std::string::npos) {
    entry = name.substr(dot + 1);
    name.resize(dot);
  }
  if (name.compare(0, 5, "stop.") == 0) {
    name = "stop" + name.substr(name.rfind('.'));
  }
  if (path.find(".spring.") != std::string::npos) {
    return spring_unit(scene, path);
  }
  if (name == "stop.restitution") {
    return restitution_unit(entry);
  }
  if (name == "forcing.amplitude" && scene.forcing) {
    const ForcingKind kind = scene.forcing->kind;
    return kind == ForcingKind::kBase ? "m" : (kind == ForcingKind::kDistributed ? "N/m" : "");
  }
  // Mass-normalised coordinates q are in kg^1/2 m, so modal forces are in kg^1/2 m/s^2.
  static constexpr std::array<std::pair<const char*, const char*>, 24> kUnits = {{
      {"beam.length", "m"},
      {"beam.youngs_modulus", "Pa"},
      {"beam.second_moment", "m^4"},
      {"beam.density", "kg/m^3"},
      {"beam.area", "m^2"},
      {"beam.thickness", "m"},
      {"beam.points", "m"},
      {"hub.radius", "m"},
      {"hub.inertia", "kg m^2"},
      {"hub.torque.amplitude", "N m"},
      {"hub.torque.duration", "s"},
      {"hub.friction.coulomb", "N m"},
      {"modal.frequencies", "rad/s"},
      {"modal.participation", "kg^1/2 m/s^2"},
      {"modal.inertia", "kg^1/2"},
      {"damping.viscous", "N s/m^2"},
      {"damping.rayleigh.mass", "1/s"},
      {"damping.rayleigh.stiffness", "s"},
      {"forcing.frequency", "rad/s"},
      {"forcing.phase", "rad"},
      {"gravity.acceleration", "m/s^2"},
      {"stop.position", "m"},
      {"stop.gap", "m"},
      {"stop.shape", "kg^-1/2"},
  }};
  for (const auto& [known, unit] : kUnits) {
    if (name == known) {
      return unit;
    }
  }
  return "";
}

}  // namespace graze
