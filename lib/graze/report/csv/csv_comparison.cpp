#include "graze/report/csv/csv.hpp"
#include "graze/report/names/detail/comparison_names.hpp"
#include "graze/report/names/detail/sweep_names.hpp"

namespace graze {
namespace {

std::string difference_columns() {
  std::string text;
  for (const ComparedQuantity quantity : kComparedQuantities) text += "," + name_of(quantity);
  return text;
}

void add_difference(const MotionDifference& difference, ResultTable& table) {
  for (const ComparedQuantity quantity : kComparedQuantities)
    table.add(compared_value(difference, quantity));
}

}  // namespace

ResultTable comparison_table(const ComparisonRecord& record) {
  ResultTable table("name,settles_on,mean_energy,taken_by_stops" + difference_columns());
  for (std::size_t i = 0; i < record.motions.size(); ++i) {
    const ComparedMotion& motion = record.motions[i];
    table.add(record.names[i], attractor_label(motion.attractor), motion.energy, motion.taken);
    if (i == 0)
      table.skip(std::size(kComparedQuantities));
    else
      add_difference(record.differences[i - 1], table);
  }
  return table;
}

ResultTable first_impacts_table(const ComparisonRecord& record) {
  ResultTable table("name,impact,time,stop,speed");
  for (std::size_t i = 0; i < record.motions.size(); ++i)
    for (std::size_t k = 0; k < record.motions[i].first.size(); ++k) {
      const RunImpact& impact = record.motions[i].first[k];
      table.add(record.names[i], k + 1, impact.time, impact.stop + 1, impact.speed);
    }
  return table;
}

ResultTable comparison_table(const ComparisonMapRecord& record) {
  const ComparisonMap& map = record.map;
  ResultTable table("x,y,one,other" + difference_columns());
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const ComparedCell& cell = map.cells[i];
    if (!cell.is_known) continue;
    table.add(map.options.x_at(i), map.options.y_at(i), attractor_label(cell.one),
              attractor_label(cell.other));
    if (is_comparable(cell))
      add_difference(cell.difference, table);
    else
      table.skip(std::size(kComparedQuantities));
  }
  return table;
}

}  // namespace graze
