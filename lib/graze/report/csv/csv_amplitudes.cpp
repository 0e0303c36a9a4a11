#include "graze/report/csv/detail/csv_amplitudes.hpp"

#include <complex>

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

void add_amplitudes(const std::vector<MeasuredPlace>& places, const Amplitudes* measured,
                    ResultTable& table) {
  const bool known = measured && measured->rows.size() == places.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!known) {
      table.skip(std::size(kOfPlaces));
      continue;
    }
    const Amplitude& row = measured->rows[i];
    table.add(row.largest(), row.highest, row.lowest, row.half_range(), row.mean, row.rms);
    table.add(row.harmonic ? std::optional(std::abs(*row.harmonic)) : std::nullopt, row.speed);
  }
  for (const MeasuredPlace& place : places) {
    if (!place.stop) continue;
    if (!known) {
      table.skip(std::size(kOfStops));
      continue;
    }
    const StopLoad& load = measured->stops[static_cast<std::size_t>(*place.stop)];
    table.add(static_cast<double>(load.impacts) / measured->duration, load.impulse, load.peak_force,
              load.rms_force);
  }
}

}  // namespace graze
