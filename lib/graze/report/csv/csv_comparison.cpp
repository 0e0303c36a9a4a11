#include <fmt/format.h>

#include "graze/report/csv/csv.hpp"
#include "graze/report/csv/detail/csv_cell.hpp"
#include "graze/report/names/detail/comparison_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {
namespace {

// Names hold commas and quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) result += letter == '"' ? "\"\"" : std::string(1, letter);
  return result + "\"";
}

std::string difference_header() {
  std::string text;
  for (const ComparedQuantity quantity : kComparedQuantities) text += "," + name_of(quantity);
  return text;
}

std::string difference_cells(const MotionDifference& difference) {
  std::string text;
  for (const ComparedQuantity quantity : kComparedQuantities)
    text += "," + csv_cell(compared_value(difference, quantity));
  return text;
}

}  // namespace

std::string comparison_csv(const ComparisonRecord& record) {
  std::string text = "name,settles_on,mean_energy,taken_by_stops" + difference_header() + "\n";
  for (std::size_t i = 0; i < record.motions.size(); ++i) {
    const ComparedMotion& motion = record.motions[i];
    text += fmt::format("{},{},{},{}", quoted(record.names[i]),
                        quoted(attractor_label(motion.attractor)), csv_cell(motion.energy),
                        csv_cell(motion.taken));
    text += i == 0 ? std::string(std::size(kComparedQuantities), ',')
                   : difference_cells(record.differences[i - 1]);
    text += "\n";
  }
  return text;
}

std::string first_impacts_csv(const ComparisonRecord& record) {
  std::string text = "name,impact,time,stop,speed\n";
  for (std::size_t i = 0; i < record.motions.size(); ++i)
    for (std::size_t k = 0; k < record.motions[i].first.size(); ++k) {
      const RunImpact& impact = record.motions[i].first[k];
      text += fmt::format("{},{},{},{},{}\n", quoted(record.names[i]), k + 1, csv_cell(impact.time),
                          impact.stop + 1, csv_cell(impact.speed));
    }
  return text;
}

std::string comparison_csv(const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  std::string text = "x,y,one,other" + difference_header() + "\n";
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const ComparedCell& cell = map.cells[i];
    if (!cell.is_known) continue;
    text += fmt::format("{},{},{},{}", csv_cell(map.options.x_at(i)), csv_cell(map.options.y_at(i)),
                        quoted(attractor_label(cell.one)), quoted(attractor_label(cell.other)));
    text += is_comparable(cell) ? difference_cells(cell.difference)
                                : std::string(std::size(kComparedQuantities), ',');
    text += "\n";
  }
  return text;
}

}  // namespace graze
