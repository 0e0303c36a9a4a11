#include "graze/record/orbit_quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/angle.hpp"
#include "graze/base/errors.hpp"
#include "graze/orbit/orbit_amplitudes.hpp"

namespace graze {
namespace {

// A number of an orbit, or of its motion at one stop.
struct OrbitQuantity {
  const char* name;
  bool of_stop;
  double turn;
  // `stop`: that of the place; nullopt of the orbit, or where any stop will do.
  std::optional<double> (*of)(const System& system, const Orbit& orbit, std::optional<int> stop);
};

// Of the first impact on the stop.
template <double OrbitImpact::*number>
std::optional<double> of_first_impact(const System&, const Orbit& orbit, std::optional<int> stop) {
  for (const OrbitImpact& impact : orbit.impacts)
    if (!stop || impact.stop == *stop) return impact.*number;
  return {};
}

// The longest of those on the stop; none without any.
template <class List, class Duration>
std::optional<double> longest_on(const List& list, std::optional<int> stop,
                                 const Duration& duration) {
  std::optional<double> longest;
  for (const auto& one : list)
    if (!stop || one.stop == *stop)
      longest = std::max(longest.value_or(0.0), std::optional<double>(duration(one)).value_or(0.0));
  return longest;
}

std::optional<double> contact_duration(const System&, const Orbit& orbit, std::optional<int> stop) {
  return longest_on(orbit.impacts, stop, [](const OrbitImpact& impact) {
    return impact.contact ? std::optional<double>(impact.contact->duration)
                          : std::optional<double>();
  });
}

std::optional<double> stuck_duration(const System&, const Orbit& orbit, std::optional<int> stop) {
  return longest_on(orbit.sticking, stop,
                    [](const StickingPhase& phase) { return phase.duration; });
}

std::optional<double> impulse(const System& system, const Orbit& orbit, std::optional<int> stop) {
  return orbit_amplitudes(system, orbit, {}).stops[static_cast<std::size_t>(*stop)].impulse;
}

std::optional<double> clearance(const System& system, const Orbit& orbit, std::optional<int>) {
  if (orbit.clearance || orbit.section || orbit.impacts.empty()) return orbit.clearance;
  return admissibility(system, orbit.pattern(), orbit.points()).clearance();
}

std::optional<double> largest_multiplier(const System&, const Orbit& orbit, std::optional<int>) {
  return orbit.multipliers.empty()
             ? std::optional<double>()
             : std::optional<double>(std::abs(orbit.multipliers.front().value));
}

std::optional<double> period(const System& system, const Orbit& orbit, std::optional<int>) {
  return orbit.period * system.period();
}

constexpr OrbitQuantity kOfOrbits[] = {{"speed", true, 0.0, of_first_impact<&OrbitImpact::speed>},
                                       {"phase", true, kTurn, of_first_impact<&OrbitImpact::phase>},
                                       {"contact-duration", true, 0.0, contact_duration},
                                       {"stuck-duration", true, 0.0, stuck_duration},
                                       {"impulse", true, 0.0, impulse},
                                       {"clearance", false, 0.0, clearance},
                                       {"multiplier", false, 0.0, largest_multiplier},
                                       {"period", false, 0.0, period}};

std::string allowed(const std::vector<MeasuredPlace>& places) {
  std::string list;
  for (const ShownQuantity quantity : kShownQuantities)
    list += (list.empty() ? "" : ", ") + std::string(name_of(quantity));
  for (const OrbitQuantity& one : kOfOrbits) list += std::string(", ") + one.name;
  std::string names;
  for (const MeasuredPlace& place : places) names += (names.empty() ? "" : ", ") + place.name('.');
  return fmt::format("give one of {}{}", list,
                     names.empty() ? "" : fmt::format(", behind a place and a dot: {}", names));
}

// "stop.1" and "peak-force"; of "speed" no place.
struct Words {
  std::string place, quantity;
};
Words words_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {"", name};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

// The value behind the sign; nullopt where it is no number.
std::optional<double> value_in(const std::string& text) {
  try {
    std::size_t used = 0;
    const double value = std::stod(text, &used);
    return used == text.size() && std::isfinite(value) ? std::optional<double>(value)
                                                       : std::optional<double>();
  } catch (const std::exception&) {
    return {};
  }
}

class LevelReader {
 public:
  LevelReader(const std::string& option, const std::string& text, const std::string& at,
              const std::vector<MeasuredPlace>& places)
      : option_(option), text_(text), at_(at), places_(places) {}

  void give_number(OrbitLevel& level, const std::string& name) const {
    const Words words = words_of(name);
    for (const OrbitQuantity& one : kOfOrbits)
      if (words.quantity == one.name) return give_of_orbit(level, one, words.place);
    for (const ShownQuantity quantity : kShownQuantities)
      if (words.quantity == name_of(quantity)) return give_shown(level, quantity, words.place);
    throw InputError(fmt::format("{}: '{}' is not allowed; {}", option_, text_, allowed(places_)));
  }

 private:
  void give_of_orbit(OrbitLevel& level, const OrbitQuantity& one, const std::string& name) const {
    std::optional<int> stop;
    const bool needs = one.of == impulse;
    const std::string wanted = name.empty() && one.of_stop ? at_ : name;
    if (!wanted.empty() || needs) {
      const MeasuredPlace* place = place_called(
          wanted, [&](const MeasuredPlace& has) { return one.of_stop && has.stop.has_value(); });
      stop = place->stop;
    }
    level.turn = one.turn;
    level.number = [of = one.of, stop](const Scene&, const System& system, const Orbit& orbit) {
      return of(system, orbit, stop);
    };
  }

  void give_shown(OrbitLevel& level, ShownQuantity quantity, const std::string& name) const {
    const MeasuredPlace* place =
        place_called(name.empty() ? at_ : name,
                     [&](const MeasuredPlace& has) { return exists_at(quantity, has); });
    level.number = number_of(Shown{quantity, static_cast<std::size_t>(place - places_.data())});
  }

  // The first one that has the number where the name is empty.
  template <class Has>
  const MeasuredPlace* place_called(const std::string& name, const Has& has) const {
    std::string known;
    for (const MeasuredPlace& place : places_) {
      if (!has(place)) continue;
      if (name.empty() || place.name('.') == name) return &place;
      known += (known.empty() ? "" : ", ") + place.name('.');
    }
    if (known.empty())
      throw InputError(fmt::format("{}: '{}' is not allowed; no place of the scene has that number",
                                   option_, text_));
    throw InputError(
        fmt::format("{}: '{}' is not allowed; the place must be one of {}", option_, text_, known));
  }

  const std::string &option_, &text_, &at_;
  const std::vector<MeasuredPlace>& places_;
};

}  // namespace

OrbitNumber number_of(const Shown& shown) {
  return [shown](const Scene& scene, const System& system, const Orbit& orbit) {
    const std::vector<MeasuredPlace> one = {measured_places(scene, system)[shown.place]};
    return shown_value({shown.quantity, 0}, one, orbit_amplitudes(system, orbit, rows_of(one)));
  };
}

OrbitLevel level_named(const std::string& text, bool is_extreme, const std::string& at,
                       const std::vector<MeasuredPlace>& places) {
  const std::string option = is_extreme ? "--extreme" : "--level";
  OrbitLevel level;
  level.name = text;
  std::string name = text;
  const std::size_t sign = text.find('=');
  if (!is_extreme) {
    if (sign != std::string::npos) level.value = value_in(text.substr(sign + 1));
    if (!level.value)
      throw InputError(fmt::format(
          "{}: '{}' is not allowed; give a number of orbits and its value, stop.1.speed=0.5",
          option, text));
    name = text.substr(0, sign);
  }
  LevelReader(option, text, at, places).give_number(level, name);
  return level;
}

}  // namespace graze
