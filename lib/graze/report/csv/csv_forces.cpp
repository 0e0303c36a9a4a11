#include <fmt/format.h>

#include "graze/report/csv/csv.hpp"

namespace graze {

ResultTable forces_table(const StopForces& forces) {
  std::string names = "from,to";
  for (std::size_t i = 1; i <= forces.means.size(); ++i) names += fmt::format(",force{}", i);
  ResultTable table(names);
  const std::size_t windows = forces.means.empty() ? 0 : forces.means.front().size();
  for (std::size_t k = 0; k < windows; ++k) {
    table.add(forces.from + static_cast<double>(k) * forces.length,
              forces.from + static_cast<double>(k + 1) * forces.length);
    for (const std::vector<double>& means : forces.means) table.add(means[k]);
  }
  return table;
}

}  // namespace graze
