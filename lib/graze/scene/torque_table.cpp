#include "graze/scene/detail/torque_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "graze/scene/data_table.hpp"
#include "graze/scene/detail/text_check.hpp"
#include "graze/scene/detail/text_file.hpp"
#include "graze/scene/suggestion.hpp"

namespace graze {
namespace {

void check_columns(const DataTable& table) {
  if (table.columns() != 2)
    throw table.error(
        fmt::format("the table has {} column{}, it must have two, time (s) and torque (N m)",
                    table.columns(), table.columns() == 1 ? "" : "s"));
  table.check_unit(0, "s");
  table.check_unit(1, "N m");
}

}  // namespace

std::optional<TorqueFault> torque_fault(const TorqueTable& table) {
  const std::vector<double>& times = table.times;
  const auto fault = [&](std::size_t k, bool of_times, const std::string& what) {
    const double value = of_times ? times[k] : table.values[k];
    return TorqueFault{k, of_times, fmt::format("{} is not allowed, it must be {}", value, what)};
  };
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (!std::isfinite(times[k]) || times[k] < 0.0)
      return fault(k, true, "a finite number of at least 0");
    if (k > 0 && times[k] < times[k - 1])
      return fault(k, true, fmt::format("at least the time before it, {}", times[k - 1]));
    if (k > 1 && times[k] == times[k - 2])
      return fault(k, true, "later than the two before it, which make a jump already");
    if (!std::isfinite(table.values[k])) return fault(k, false, "a finite number");
  }
  if (times.back() == times.front())
    return fault(times.size() - 1, true, "later than the first time");
  return {};
}

TorqueTable read_torque_file(const std::filesystem::path& file) {
  const std::string text = read_text_file(file, "a table of a torque");
  if (text.size() > kLargestText)
    throw InputError({file.string(), 1, 1}, "data",
                     "the table is larger than 16 MiB, it must be smaller");
  const DataTable table(text, file.string(), ColumnNames::kOptional);
  check_columns(table);
  if (table.rows() < 2)
    throw table.error("the table has 1 row of numbers, it must have at least two");
  TorqueTable torque;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    torque.times.push_back(table.number(row, 0, "s"));
    torque.values.push_back(table.number(row, 1, "N m"));
  }
  if (const std::optional<TorqueFault> fault = torque_fault(torque)) {
    const std::size_t column = fault->of_times ? 0 : 1;
    throw table.cell_error(fault->entry, column,
                           fmt::format("{}: {}", table.column_name(column), fault->sentence));
  }
  return torque;
}

}  // namespace graze
