#include "graze/report/csv/detail/csv_amplitudes.hpp"

#include <complex>

#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {
namespace {

constexpr const char* kOfPlaces[] = {"amplitude", "max", "min",      "half_range",
                                     "mean",      "rms", "harmonic", "peak_velocity"};
constexpr const char* kOfStops[] = {"impact_rate", "impulse", "peak_force", "rms_force"};

}  // namespace

std::string amplitude_columns(const std::vector<MeasuredPlace>& places) {
  std::string text;
  for (const MeasuredPlace& place : places)
    for (const char* name : kOfPlaces) text += "," + place.name('_') + "_" + name;
  for (const MeasuredPlace& place : places)
    if (place.stop)
      for (const char* name : kOfStops) text += "," + place.name('_') + "_" + name;
  return text;
}

std::string amplitude_cells(const std::vector<MeasuredPlace>& places, const Amplitudes* measured) {
  std::string text;
  const auto add = [&](const std::optional<double>& value) { text += "," + csv_cell(value); };
  const bool known = measured && measured->rows.size() == places.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!known) {
      text.append(std::size(kOfPlaces), ',');
      continue;
    }
    const Amplitude& row = measured->rows[i];
    for (const double value :
         {row.largest(), row.highest, row.lowest, row.half_range(), row.mean, row.rms})
      add(value);
    add(row.harmonic ? std::optional(std::abs(*row.harmonic)) : std::nullopt);
    add(row.speed);
  }
  for (const MeasuredPlace& place : places) {
    if (!place.stop) continue;
    if (!known) {
      text.append(std::size(kOfStops), ',');
      continue;
    }
    const StopLoad& load = measured->stops[static_cast<std::size_t>(*place.stop)];
    add(static_cast<double>(load.impacts) / measured->duration);
    add(load.impulse);
    add(load.peak_force);
    add(load.rms_force);
  }
  return text;
}

}  // namespace graze
