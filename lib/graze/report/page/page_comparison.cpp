#include "graze/record/study_records.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page_plane.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/text/shell_word.hpp"

namespace graze {

void write_page(const std::string& file, const ComparisonMapRecord& record, const Scene& scene) {
  const ComparisonMap& map = record.map;
  PageCells cells;
  cells.message = [&](std::size_t i) -> const std::string& { return map.cells[i].message; };
  std::string against;
  for (const std::string& setting : record.against) against += " --against " + shell_word(setting);
  cells.command = cell_command_json(page_command(record.info, "compare", {}) + against,
                                    " --plot cell.html", map.options, scene);
  const Chart chart = explored_chart(record);
  write_plane(file, chart, chart_view(chart, record.info, record.outcome, record.warnings, {}, {}),
              &cells, nullptr);
}

}  // namespace graze
