#include "graze/scene/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "graze/scene/check.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/numbers.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

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

// The unit of the stiffness or, where there is damping, of its coefficient.
std::string spring_unit(const Spring& spring, bool of_stiffness) {
  const double exponent = spring.geometry ? 1.5 : spring.is_residual ? 1.0 : spring.exponent;
  double power = exponent;
  if (!of_stiffness) {
    const ContactModel model = spring.damping->model;
    const bool plain = model == ContactModel::kKelvinVoigt || model == ContactModel::kLeeWang2;
    power = plain ? 1.0 : model == ContactModel::kLeeWang1 ? 2.0 : exponent + 1.0;
  }
  const char* of_one = of_stiffness ? "N/m" : "N s/m";
  return power == 1.0 ? std::string(of_one) : fmt::format("{}^{:g}", of_one, power);
}

InputError unknown_parameter(const Scene& scene, const std::string& path) {
  const std::vector<std::string> names = parameter_names(scene);
  const std::string meant = closest_name(path, names);
  const std::string question = meant.empty() ? "" : fmt::format(" Did you mean {}?", meant);
  return InputError(fmt::format("{}: the scene has no such continuous parameter.{} Allowed are {}.",
                                path.empty() ? "parameter" : path, question,
                                joined(shortened(names), "and")));
}

// Whether a path names the forcing frequency in Hz; nullopt when it names another number.
std::optional<bool> written_in_hertz(const Scene& scene, const std::string& path) {
  const bool in_hertz = path == "forcing.frequency_hz";
  if (!scene.forcing || (!in_hertz && path != "forcing.frequency")) return {};
  if (in_hertz && scene.units == Units::kNone) return {};
  return in_hertz;
}

}  // namespace

bool are_same_parameter(const std::string& first, const std::string& second) {
  const auto plain = [](const std::string& path) -> std::string {
    if (path == "forcing.frequency_hz") return "forcing.frequency";
    return first_unnumbered(path);
  };
  return plain(first) == plain(second);
}

double* find_parameter(Scene& scene, const std::string& path) {
  if (const std::optional<bool> in_hertz = written_in_hertz(scene, path))
    scene.forcing->frequency.write_in_hertz(*in_hertz);
  return found_number(scene, path, false);
}

std::optional<double> parameter_value(const Scene& scene, const std::string& path) {
  if (const std::optional<bool> in_hertz = written_in_hertz(scene, path)) {
    Frequency frequency = scene.forcing->frequency;
    frequency.write_in_hertz(*in_hertz);
    return frequency.written;
  }
  const double* number = found_number(scene, path, false);
  return number ? std::optional<double>(*number) : std::nullopt;
}

const double* find_parameter(const Scene& scene, const std::string& path) {
  return found_number(scene, path, false);
}

std::vector<std::string> parameter_names(const Scene& scene) {
  std::vector<std::string> names;
  visit_numbers(
      scene, [&](const std::string& name, const double&) { names.push_back(name); }, false);
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
  visit_numbers(
      direction, [](const std::string&, double& value) { value = 0.0; }, true);
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

namespace {

std::string si_unit(const Scene& scene, const std::string& path) {
  // The unit of some keys depends on other keys.
  const std::string name = without_number(path);
  if (name.starts_with("stop.restitution"))
    return restitution_unit(name.substr(std::min(name.size(), sizeof "stop.restitution")));
  if (name == "forcing.amplitude") {
    if (!scene.forcing) return "";
    const ForcingKind kind = scene.forcing->kind;
    return kind == ForcingKind::kBase ? "m" : (kind == ForcingKind::kDistributed ? "N/m" : "");
  }
  const bool of_stiffness = name == "stop.spring.stiffness";
  if (of_stiffness || name == "stop.spring.damping.coefficient") {
    const long number = std::strtol(path.c_str() + 5, nullptr, 10);
    const auto stop = static_cast<std::size_t>(number > 0 ? number - 1 : 0);
    if (stop >= scene.stops.size() || !scene.stops[stop].spring) return "";
    const Spring& spring = *scene.stops[stop].spring;
    return of_stiffness || spring.damping ? spring_unit(spring, of_stiffness) : "";
  }
  const KeyRow* row = key_row(path);
  return row ? row->unit : "";
}

}  // namespace

std::string parameter_unit(const Scene& scene, const std::string& path) {
  return unit_in(scene.units, si_unit(scene, path));
}

}  // namespace graze
