#include "graze/report/json/detail/json_page_orbits.hpp"

#include "graze/report/page/page.hpp"

namespace graze {

void write_page(const std::string& file, const OrbitRecord& record, const Scene&) {
  Json view = page_view(record.info, record.outcome, record.warnings, record.found.notes);
  view["kind"] = "orbits";
  view["title"] = "Periodic orbits";
  Json orbits = Json::array();
  // There are few, so each is drawn finely.
  const PageSource source{record.info, "", std::nullopt, 8192};
  for (const Orbit& orbit : record.found.orbits)
    orbits.push_back(page_orbit(source, record.system, orbit, std::nullopt));
  write_page_file(file, view, orbits);
}

}  // namespace graze
