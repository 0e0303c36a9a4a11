#include "graze/scene/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "graze/scene/check.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/numbers.hpp"
#include "graze/scene/detail/quantity_text.hpp"
#include "graze/scene/discrete_matrices.hpp"
#include "graze/scene/matrix_structure.hpp"
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
    const bool plain = model == ContactModel::kKelvinVoigt || model == ContactModel::kLeeWang2 ||
                       model == ContactModel::kAdams || model == ContactModel::kElastoGap;
    power = plain                               ? 1.0
            : model == ContactModel::kLeeWang1  ? 2.0
            : model == ContactModel::kJankowski ? 0.5 * (exponent + 1.0)
                                                : exponent + 1.0;
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

std::vector<std::string> split_at(const std::string& text, char where) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == where)
      parts.emplace_back();
    else if (c != ' ')
      parts.back() += c;
  return parts;
}

struct TiedPath {
  std::string path;
  double factor = 1.0;
};

// The paths that "stop.*.gap" stands for, in a scene; the path itself where it has no star.
std::vector<std::string> without_star(const Scene& scene, const std::string& path) {
  const std::size_t star = path.find(".*");
  if (star == std::string::npos) return {path};
  std::vector<std::string> paths;
  for (std::size_t k = 1;; ++k) {
    const std::string one = fmt::format("{}.{}{}", path.substr(0, star), k, path.substr(star + 2));
    if (!parameter_value(scene, one)) return paths;
    paths.push_back(one);
  }
}

// "2*forcing.frequency" of a first name "forcing.frequency" is the factor 2; nullopt otherwise.
std::optional<double> factor_of(const std::string& text, const std::string& first) {
  if (text == first) return 1.0;
  const std::size_t behind = text.size() - std::min(text.size(), first.size() + 1);
  if (text.substr(behind) != "*" + first || behind == 0) return {};
  char* end = nullptr;
  const double factor = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + behind || !std::isfinite(factor)) return {};
  return factor;
}

// Throws InputError where a tie does not say what it must.
std::vector<TiedPath> tied_paths(const Scene& scene, const std::string& name) {
  std::vector<TiedPath> tied;
  std::string first;
  for (const std::string& part : split_at(name, ',')) {
    const std::size_t equals = part.find('=');
    const std::string path = part.substr(0, equals);
    if (path.empty()) throw InputError(fmt::format("{}: a name is missing beside a comma", name));
    double factor = 1.0;
    if (equals != std::string::npos) {
      const std::optional<double> found = factor_of(part.substr(equals + 1), first);
      if (!found || first.empty())
        throw InputError(fmt::format(
            "{}: \"{}\" is not allowed, {} like {}=2*{}", name, part,
            first.empty() ? "the first number is set as it is, further ones may be tied to it"
                          : "it must be a multiple of the first number",
            path, first.empty() ? path : first));
      factor = *found;
    }
    if (first.empty()) first = path;
    for (const std::string& one : without_star(scene, path)) tied.push_back({one, factor});
  }
  return tied;
}

}  // namespace

bool are_same_parameter(const std::string& first, const std::string& second) {
  const auto plain = [](const std::string& path) -> std::string {
    if (path == "forcing.frequency_hz") return "forcing.frequency";
    return first_unnumbered(path);
  };
  for (const std::string& one : split_at(first, ','))
    for (const std::string& other : split_at(second, ','))
      if (plain(one.substr(0, one.find('='))) == plain(other.substr(0, other.find('='))))
        return true;
  return false;
}

std::vector<TiedNumber> parameter_numbers(Scene& scene, const std::string& name) {
  std::vector<TiedNumber> numbers;
  for (const TiedPath& tied : tied_paths(scene, name)) {
    double* number = find_parameter(scene, tied.path);
    if (number == nullptr) throw unknown_parameter(scene, tied.path);
    if (std::ranges::any_of(numbers, [&](const auto& one) { return one.number == number; }))
      throw InputError(
          fmt::format("{}: {} is meant twice, it must be named once", name, tied.path));
    numbers.push_back({number, tied.factor});
  }
  if (numbers.empty()) throw unknown_parameter(scene, name);
  return numbers;
}

void set_parameter(Scene& scene, const std::string& name, double value) {
  for (const TiedNumber& tied : parameter_numbers(scene, name)) *tied.number = tied.factor * value;
  if (!leaves_structure(name)) renew_structure(scene);
}

void renew_structure(Scene& scene) {
  if (has_own_matrices(scene)) solve_matrices(scene);
}

double* find_parameter(Scene& scene, const std::string& path) {
  if (const std::optional<bool> in_hertz = written_in_hertz(scene, path))
    scene.forcing->frequency.write_in_hertz(*in_hertz);
  return found_number(scene, path, false);
}

std::optional<double> parameter_value(const Scene& scene, const std::string& name) {
  if (name.find_first_of(",*=") != std::string::npos) {
    const std::vector<TiedPath> tied = tied_paths(scene, name);
    return tied.empty() ? std::nullopt : parameter_value(scene, tied.front().path);
  }
  if (const std::optional<bool> in_hertz = written_in_hertz(scene, name)) {
    Frequency frequency = scene.forcing->frequency;
    frequency.write_in_hertz(*in_hertz);
    return frequency.written;
  }
  const double* number = found_number(scene, name, false);
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

Scene with_parameter(const Scene& scene, const std::string& name, double value) {
  Scene changed = scene;
  // The value is not the one in the file, so no message may point there.
  changed.origins = nullptr;
  set_parameter(changed, name, value);
  check_scene(changed);
  changed.origins = scene.origins;
  return changed;
}

Scene parameter_direction(const Scene& scene, const std::string& name) {
  Scene direction = scene;
  visit_numbers(
      direction, [](const std::string&, double& value) { value = 0.0; }, true);
  // In the scene itself, whose lists of tables are those of its direction.
  for (const TiedNumber& tied : parameter_numbers(direction, name)) *tied.number = tied.factor;
  return direction;
}

bool leaves_structure(const std::string& name) {
  const auto leaves = [](const std::string& numbered) {
    const std::string path = without_number(numbered);
    const auto begins = [&](const char* with) { return path.rfind(with, 0) == 0; };
    const auto contains = [&](const char* part) { return path.find(part) != std::string::npos; };
    return (begins("forcing.") && !begins("forcing.position") && !begins("forcing.shape")) ||
           begins("gravity.") || begins("hub.") || path == "beam.thickness" ||
           (begins("load.") && contains(".force")) ||
           (begins("stop.") &&
            (contains(".gap") || contains(".restitution") || contains(".spring") ||
             contains(".motion")));
  };
  const std::vector<std::string> parts = split_at(name, ',');
  return std::all_of(parts.begin(), parts.end(), leaves);
}

namespace {

std::string si_unit(const Scene& scene, const std::string& path) {
  // The unit of some keys depends on other keys.
  const std::string name = without_number(path);
  if (name.starts_with("stop.restitution"))
    return restitution_unit(name.substr(std::min(name.size(), sizeof "stop.restitution")));
  if (name == "forcing.amplitude") {
    const long number = std::strtol(path.c_str() + sizeof "forcing", nullptr, 10);
    const std::vector<const HarmonicLoad*> loads = scene.harmonic_loads();
    const auto place = static_cast<std::size_t>(number > 0 ? number - 1 : 0);
    if (place >= loads.size()) return "";
    const ForcingKind kind = loads[place]->kind;
    if (loads[place]->signal) return "";
    return kind == ForcingKind::kSupport       ? "m"
           : kind == ForcingKind::kBase        ? "m"
           : kind == ForcingKind::kPoint       ? "N"
           : kind == ForcingKind::kDistributed ? "N/m"
                                               : "";
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

std::string parameter_unit(const Scene& scene, const std::string& name) {
  std::string path = name.substr(0, name.find(','));
  if (const std::size_t star = path.find(".*"); star != std::string::npos) path.erase(star, 2);
  return unit_in(scene.units, si_unit(scene, path));
}

std::optional<std::string> as_written(const Scene& scene, const std::string& path, double value) {
  if (!scene.written) return {};
  const auto found = scene.written->find(first_unnumbered(path));
  if (found == scene.written->end()) return {};
  const auto one = quantity_in("1 " + found->second, si_unit(scene, path));
  const auto* factor = std::get_if<double>(&one);
  if (!factor) return {};  // another key has changed what it is measured in
  return fmt::format("{:.6g} {}", value / *factor, found->second);
}

}  // namespace graze
