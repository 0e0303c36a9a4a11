#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "graze/report/chart/charts.hpp"
#include "graze/report/json/detail/json_page_orbits.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/page/page_tables.hpp"

namespace graze {

void write_page(const std::string& file, const OrbitRecord& record, const Scene&) {
  const std::vector<Orbit>& found = record.found.orbits;
  Json orbits = Json::array();
  PageTable table{fmt::format("{} orbit{}", found.size(), found.size() == 1 ? "" : "s"),
                  {"orbit", "stability", "impacts", "fastest"},
                  {}};
  // There are few, so each is drawn finely.
  const PageSource source{record.info, "", std::nullopt, 8192};
  for (const Orbit& orbit : found) {
    table.opens.push_back(static_cast<int>(orbits.size()));
    orbits.push_back(page_orbit(source, record.system, orbit, std::nullopt));
    double fastest = 0.0;
    for (const OrbitImpact& impact : orbit.impacts) fastest = std::max(fastest, impact.speed);
    table.rows.push_back(
        {fmt::format("{}: {}", orbits.size(), orbits.back()["name"].get<std::string>()),
         orbits.back()["stability"].get<std::string>(), std::to_string(orbit.impacts.size()),
         orbit.impacts.empty() ? "–"
                               : measured_text(fastest, unit_in(record.info.units, "m/s"), 6)});
  }
  Json view = chart_view(explored_chart(record), record.info, record.outcome, record.warnings,
                         record.found.notes, {table});
  if (!found.empty()) {
    std::vector<std::int32_t> kept(found.size());
    std::iota(kept.begin(), kept.end(), 0);
    view["things"]["kept"] = packed(kept);
  }
  write_page_file(file, view, orbits);
}

}  // namespace graze
