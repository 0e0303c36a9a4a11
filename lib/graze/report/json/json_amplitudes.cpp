#include "graze/report/json/detail/json_amplitudes.hpp"

#include <complex>

namespace graze {
namespace {

Json harmonic_json(const std::optional<Complex>& harmonic) {
  if (!harmonic) return nullptr;
  return {{"amplitude", json_number(std::abs(*harmonic))},
          {"phase", json_number(std::arg(*harmonic))}};
}

Json amplitude_json(const MeasuredPlace& place, const Amplitude& measured) {
  Json json = {{place.probe ? "probe" : "stop", (place.probe ? *place.probe : *place.stop) + 1}};
  json.update({{"amplitude", json_number(measured.largest())},
               {"max", json_number(measured.highest)},
               {"min", json_number(measured.lowest)},
               {"half_range", json_number(measured.half_range())},
               {"mean", json_number(measured.mean)},
               {"rms", json_number(measured.rms)},
               {"harmonic", harmonic_json(measured.harmonic)},
               {"peak_velocity", json_maybe(measured.speed)}});
  return json;
}

Json load_json(std::size_t index, const StopLoad& load, double duration) {
  const auto each_second = [&](double amount) {
    return duration > 0.0 ? json_number(amount / duration) : Json(nullptr);
  };
  return {{"stop", index + 1},
          {"impacts", load.impacts},
          {"impact_rate", each_second(static_cast<double>(load.impacts))},
          {"impulse", json_number(load.impulse)},
          {"mean_force", each_second(load.impulse)},
          {"time_held", json_number(load.held)},
          {"peak_force", json_maybe(load.peak_force)},
          {"rms_force", json_maybe(load.rms_force)}};
}

}  // namespace

void add_amplitudes(const std::vector<MeasuredPlace>& places, const Amplitudes& measured,
                    Json& json) {
  Json amplitudes = Json::array(), loads = Json::array();
  for (std::size_t i = 0; i < measured.rows.size(); ++i)
    amplitudes.push_back(amplitude_json(places[i], measured.rows[i]));
  for (std::size_t i = 0; i < measured.stops.size(); ++i)
    loads.push_back(load_json(i, measured.stops[i], measured.duration));
  json["amplitudes"] = amplitudes;
  json["loads"] = loads;
  if (const auto& forces = measured.forces)
    json["forces"] = {{"from", json_number(forces->from)},
                      {"window", json_number(forces->length)},
                      {"means", forces->means}};
}

void add_amplitude_units(const std::vector<MeasuredPlace>& places, Json& units) {
  if (places.empty()) return;
  for (const MeasuredPlace& place : places)
    if (place.probe) units["probe_" + std::to_string(*place.probe + 1)] = place.unit;
  units.update({{"amplitude", "m"}, {"peak_velocity", "m/s"}});
  add_load_units(units);
}

void add_load_units(Json& units) {
  units.update({{"impact_rate", "1/s"}, {"impulse", "N s"}, {"time_held", "s"}, {"force", "N"}});
}

}  // namespace graze
