#include "graze/report/text/detail/text_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "graze/report/text/detail/text_units.hpp"

namespace graze {
namespace {

constexpr int kDigits = 6;
constexpr int kLevelDigits = 4;             // a level is accurate to a thousandth of the range
constexpr std::size_t kMostHistograms = 4;  // that are printed, of one stop each

std::string text_of(const Table& table, const TextOptions& options) {
  return table.empty() ? "" : table.text(options.width) + "\n";
}

std::string places_text(const SimulationRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  const RunStatistics& statistics = *record.statistics;
  const std::vector<double> frequencies = statistics.frequencies();
  Table numbers({"at", "mean", "standard deviation", in.head("largest PSD at", "Hz")});
  std::vector<std::string> heads = {"exceeded for"};
  for (std::size_t i = 0; i < record.places.size(); ++i) {
    const Amplitude& measured = record.run.amplitudes->rows[i];
    const std::vector<double>& density = statistics.places[i].density;
    heads.push_back(in.head(record.places[i].name(), record.places[i].unit));
    const auto peak = std::max_element(density.begin(), density.end());
    const auto k = static_cast<std::size_t>(peak - density.begin());
    const bool has_peak = peak != density.end() && *peak > 0.0;
    numbers.add({heads.back(), digits_text(measured.mean, kDigits, measured.largest()),
                 digits_text(measured.standard_deviation(), kDigits),
                 has_peak ? digits_text(frequencies[k], kDigits) : "-"});
  }
  Table levels(heads);
  for (std::size_t k = 0; statistics.samples > 0 && k < std::size(kExceededShares); ++k) {
    std::vector<std::string> row = {fmt::format("{:g} %", 100.0 * kExceededShares[k])};
    for (std::size_t i = 0; i < record.places.size(); ++i)
      row.push_back(digits_text(statistics.places[i].levels[k], kLevelDigits,
                                record.run.amplitudes->rows[i].largest()));
    if (row.size() > 1) levels.add(std::move(row));
  }
  return text_of(numbers, options) + text_of(levels, options);
}

std::string stops_text(const SimulationRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  Table impacts({"stop", "impacts", in.head("mean speed", "m/s"), in.head("largest speed", "m/s"),
                 in.head("mean impulse", "N s"), in.head("mean force", "N"),
                 in.head("work rate", "W")});
  Table contacts(
      {"stop", "contacts", in.head("mean contact", "s"), in.head("longest contact", "s")});
  const double duration = record.run.amplitudes->duration;
  for (std::size_t i = 0; i < record.statistics->stops.size(); ++i) {
    const StopStatistics& stop = record.statistics->stops[i];
    const StopLoad& load = record.run.amplitudes->stops[i];
    const std::string number = fmt::format("{}", i + 1);
    const auto cell = [](bool exists, double value) {
      return exists ? digits_text(value, kDigits) : "-";
    };
    const bool met = load.impacts > 0, passed = duration > 0.0;
    impacts.add({number, fmt::format("{}", load.impacts), cell(met, stop.mean_speed),
                 cell(met, stop.largest_speed),
                 cell(met, load.impulse / static_cast<double>(load.impacts)),
                 cell(passed, load.impulse / duration), cell(passed, stop.energy_lost / duration)});
    if (stop.contacts > 0)
      contacts.add({number, fmt::format("{}", stop.contacts),
                    digits_text(stop.mean_contact, kDigits),
                    digits_text(stop.longest_contact, kDigits)});
  }
  return text_of(impacts, options) + text_of(contacts, options);
}

std::string histograms_text(const SimulationRecord& record, BinCounts StopStatistics::*of,
                            const std::string& name, const std::string& unit,
                            const TextOptions& options) {
  const TextUnits in(record.info.units);
  const std::vector<StopStatistics>& stops = record.statistics->stops;
  if (stops.size() > kMostHistograms) return "";
  Table table({"stop", in.head(name + " from", unit), in.head("to", unit), "how many"});
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const BinCounts& bins = stops[i].*of;
    for (std::size_t k = 0; k < bins.counts.size(); ++k)
      if (bins.counts[k] > 0)
        table.add({fmt::format("{}", i + 1),
                   digits_text(static_cast<double>(k) * bins.width, kDigits),
                   digits_text(static_cast<double>(k + 1) * bins.width, kDigits),
                   fmt::format("{}", bins.counts[k])});
  }
  return text_of(table, options);
}

}  // namespace

std::string statistics_text(const SimulationRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  const RunStatistics& statistics = *record.statistics;
  std::string text = places_text(record, options) + stops_text(record, options) +
                     histograms_text(record, &StopStatistics::speeds, "speed", "m/s", options) +
                     histograms_text(record, &StopStatistics::durations, "contact", "s", options);
  text += fmt::format("levels of {} samples, {} apart\n", statistics.samples,
                      in.quantity(1.0 / statistics.sample_rate, kDigits, "s"));
  if (statistics.segments == 0)
    return text + "too few samples for a power spectral density (PSD)\n";
  return text + fmt::format("power spectral density (PSD) of {} segments of {}\n",
                            statistics.segments, in.quantity(statistics.segment, kDigits, "s"));
}

}  // namespace graze
