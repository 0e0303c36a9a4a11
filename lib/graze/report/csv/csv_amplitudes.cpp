#include "graze/report/csv/detail/csv_amplitudes.hpp"

#include <fmt/format.h>

#include <complex>

#include "graze/report/csv/csv.hpp"
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

std::string forces_csv(const StopForces& forces) {
  std::string text = "from,to";
  for (std::size_t i = 0; i < forces.means.size(); ++i) text += fmt::format(",force{}", i + 1);
  text += "\n";
  const std::size_t windows = forces.means.empty() ? 0 : forces.means.front().size();
  for (std::size_t k = 0; k < windows; ++k) {
    text += csv_cell(forces.from + static_cast<double>(k) * forces.length);
    text += "," + csv_cell(forces.from + static_cast<double>(k + 1) * forces.length);
    for (const std::vector<double>& means : forces.means) text += "," + csv_cell(means[k]);
    text += "\n";
  }
  return text;
}

}  // namespace graze
