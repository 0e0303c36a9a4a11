#include "graze/report/text/detail/text_amplitudes.hpp"

#include <fmt/format.h>

#include <complex>

#include "graze/report/text/detail/text_units.hpp"

namespace graze {
namespace {

constexpr int kDigits = 9;

}  // namespace

std::string amplitudes_text(const std::vector<MeasuredPlace>& places, const Amplitudes& measured,
                            Units units, const TextOptions& options) {
  const TextUnits in(units);
  Table rows({"at", "largest", "smallest", "rms", "first harmonic", "peak velocity"});
  for (std::size_t i = 0; i < measured.rows.size(); ++i) {
    const Amplitude& row = measured.rows[i];
    const double size = row.largest();
    const auto cell = [&](double value) { return digits_text(value, kDigits, size); };
    rows.add({in.head(places[i].name(), places[i].unit), cell(row.highest), cell(row.lowest),
              cell(row.rms), row.harmonic ? cell(std::abs(*row.harmonic)) : "-",
              digits_text(row.speed, kDigits)});
  }
  Table loads({"stop", in.head("impact rate", "1/s"), in.head("impulse", "N s"),
               in.head("time held", "s"), in.head("peak force", "N"), in.head("rms force", "N")});
  for (std::size_t i = 0; i < measured.stops.size(); ++i) {
    const StopLoad& load = measured.stops[i];
    const double rate =
        measured.duration > 0.0 ? static_cast<double>(load.impacts) / measured.duration : 0.0;
    loads.add({fmt::format("{}", i + 1), digits_text(rate, kDigits),
               digits_text(load.impulse, kDigits), digits_text(load.held, kDigits),
               digits_text(load.peak_force, kDigits), digits_text(load.rms_force, kDigits)});
  }
  std::string text;
  if (!rows.empty()) text += rows.text(options.width) + "\n";
  if (!loads.empty()) text += loads.text(options.width) + "\n";
  return text;
}

}  // namespace graze
