#include "graze/report/text/detail/text_amplitudes.hpp"

#include <fmt/format.h>

#include <complex>

#include "graze/report/text/detail/table.hpp"

namespace graze {
namespace {

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : "-";
}

std::vector<std::string> with_number(const std::string& numbered, std::vector<std::string> cells,
                                     const std::string& first) {
  if (!numbered.empty()) cells.insert(cells.begin(), first);
  return cells;
}

}  // namespace

std::string amplitudes_text(const std::vector<MeasuredPlace>& places,
                            const std::vector<Amplitudes>& measured, const std::string& numbered) {
  Table rows(with_number(
      numbered, {"at", "largest", "smallest", "rms", "first harmonic", "peak velocity"}, numbered));
  Table loads(with_number(
      numbered, {"stop", "impacts (1/s)", "impulse (N s)", "peak force (N)", "rms force (N)"},
      numbered));
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const std::string number = fmt::format("{}", k + 1);
    const double duration = measured[k].duration;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Amplitude& row = measured[k].rows[i];
      const std::string unit = places[i].unit.empty() ? "" : fmt::format(" ({})", places[i].unit);
      rows.add(
          with_number(numbered,
                      {places[i].name() + unit, cell(row.highest), cell(row.lowest), cell(row.rms),
                       row.harmonic ? cell(std::abs(*row.harmonic)) : "-", cell(row.speed)},
                      number));
    }
    for (std::size_t i = 0; i < measured[k].stops.size(); ++i) {
      const StopLoad& load = measured[k].stops[i];
      const double rate = duration > 0.0 ? static_cast<double>(load.impacts) / duration : 0.0;
      loads.add(with_number(numbered,
                            {fmt::format("{}", i + 1), cell(rate), cell(load.impulse),
                             cell(load.peak_force), cell(load.rms_force)},
                            number));
    }
  }
  std::string text;
  if (!rows.empty()) text += rows.text() + "\n";
  if (!loads.empty()) text += loads.text() + "\n";
  return text;
}

}  // namespace graze
