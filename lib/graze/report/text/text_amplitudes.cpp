#include "graze/report/text/detail/text_amplitudes.hpp"

#include <fmt/format.h>

#include <complex>

#include "graze/report/text/detail/table.hpp"

namespace graze {
namespace {

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : "-";
}

}  // namespace

std::string amplitudes_text(const std::vector<MeasuredPlace>& places, const Amplitudes& measured) {
  Table rows({"at", "largest", "smallest", "rms", "first harmonic", "peak velocity"});
  for (std::size_t i = 0; i < measured.rows.size(); ++i) {
    const Amplitude& row = measured.rows[i];
    rows.add({with_unit(places[i].name(), places[i].unit), cell(row.highest), cell(row.lowest),
              cell(row.rms), row.harmonic ? cell(std::abs(*row.harmonic)) : "-", cell(row.speed)});
  }
  Table loads({"stop", "impacts (1/s)", "impulse (N s)", "peak force (N)", "rms force (N)"});
  for (std::size_t i = 0; i < measured.stops.size(); ++i) {
    const StopLoad& load = measured.stops[i];
    const double rate =
        measured.duration > 0.0 ? static_cast<double>(load.impacts) / measured.duration : 0.0;
    loads.add({fmt::format("{}", i + 1), cell(rate), cell(load.impulse), cell(load.peak_force),
               cell(load.rms_force)});
  }
  std::string text;
  if (!rows.empty()) text += rows.text() + "\n";
  if (!loads.empty()) text += loads.text() + "\n";
  return text;
}

}  // namespace graze
