#include <fmt/format.h>

#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"

namespace graze {

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
