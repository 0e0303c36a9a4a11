#include <cmath>

#include "graze/record/names/detail/comparison_names.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_plane.hpp"
#include "graze/report/text/shell_word.hpp"

namespace graze {

void write_page(const std::string& file, const ComparisonMapRecord& record, const Scene& scene) {
  const ComparisonMap& map = record.map;
  Json view = page_view(record.info, record.outcome, record.warnings, {});
  view["kind"] = "map";
  view["title"] = "The scene against " + record.other;
  view["x"] = plane_axis_json(map.options.x, record.x_unit);
  view["y"] = plane_axis_json(map.options.y, record.y_unit);
  view["cells"] =
      cells_json({"attractor", comparison_legend(map),
                  [&](std::size_t i) -> const std::string& { return map.cells[i].message; }});
  view["shown"] = name_of(record.shown);
  view["is_of_starts"] = false;
  view["motions"] = packed(std::vector<std::int32_t>());
  Json numbers = Json::array();
  for (const ComparedQuantity quantity : kComparedQuantities) {
    if (quantity == ComparedQuantity::kAttractor) continue;
    const auto of = [&](std::size_t i) {
      const ComparedCell& cell = map.cells[i];
      return is_comparable(cell) ? compared_value(cell.difference, quantity) : std::nan("");
    };
    numbers.push_back(
        number_json({name_of(quantity), title_of(quantity), "",
                     is_signed(quantity) ? CellScale::kSigned : CellScale::kFromZero, of},
                    map.cells.size()));
  }
  view["numbers"] = numbers;
  std::string against;
  for (const std::string& setting : record.against) against += " --against " + shell_word(setting);
  view["command"] = cell_command_json(page_command(record.info, "compare", {}) + against,
                                      " --plot cell.html", map.options, scene);
  view["loci"] = nullptr;
  write_page_file(file, view, Json::array());
}

}  // namespace graze
