#include <fmt/format.h>

#include <cmath>

#include "graze/assembly/probes.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/text/detail/text_units.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

std::string percent(double part) {
  return std::isfinite(part) ? decimals_text(100.0 * part, 3) : "-";
}

std::string largest_of(const Matrix& part, Eigen::Index probe) {
  double most = 0.0;
  for (const double value : part.col(probe))
    if (std::isfinite(value)) most = std::fmax(most, std::abs(value));
  return decimals_text(100.0 * most, 2) + " %";
}

}  // namespace

std::string to_text(const SensitivityRecord& record, const TextOptions& options) {
  const TextUnits in(record.info.units);
  std::vector<std::string> header;
  if (!record.second.empty()) header.push_back(with_unit(record.second, record.second_unit));
  header.push_back(with_unit(record.parameter, record.unit));
  header.emplace_back("impacts");
  TableColumns columns{header.size(), {}};
  for (std::size_t i = 0; i < record.probes.size(); ++i) {
    const std::string unit = probe_unit(record.probes[i].quantity);
    columns.parts.push_back(header.size());
    header.push_back(in.head(fmt::format("peak {}", i + 1), unit));
    header.emplace_back("s1 (%)");
    header.push_back(in.head(fmt::format("end {}", i + 1), unit));
    header.emplace_back("s2 (%)");
  }
  Table table(header, columns);
  for (const SensitivityCurve& curve : record.curves)
    for (std::size_t k = 0; k < curve.runs.size(); ++k) {
      const ValueRun& run = curve.runs[k];
      std::vector<std::string> row;
      if (!record.second.empty()) row.push_back(digits_text(curve.second, 6));
      row.push_back(digits_text(run.value, 6));
      row.push_back(std::to_string(run.impacts.size()));
      for (std::size_t i = 0; i < record.probes.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(k), probe = static_cast<Eigen::Index>(i);
        row.push_back(digits_text(run.peaks[i], 6));
        row.push_back(percent(curve.s1(at, probe)));
        row.push_back(digits_text(run.ends[i], 6));
        row.push_back(percent(curve.s2(at, probe)));
      }
      table.add(row);
    }
  std::string text = table.text(options.width) + "\n";
  for (const SensitivityCurve& curve : record.curves)
    for (std::size_t i = 0; i < record.probes.size(); ++i) {
      const auto probe = static_cast<Eigen::Index>(i);
      text += fmt::format(
          "{}probe {} ({}): |s1| up to {}, |s2| up to {} against {} = {:g}\n",
          record.second.empty() ? "" : fmt::format("{} = {:g}, ", record.second, curve.second),
          i + 1, probe_quantity_name(record.probes[i].quantity), largest_of(curve.s1, probe),
          largest_of(curve.s2, probe), record.parameter, record.reference);
    }
  if (!record.outcome.message.empty()) text += record.outcome.message + "\n";
  return text;
}

}  // namespace graze
