// What stands below charts: tables of the numbers behind them, in the units of the axes.
#pragma once

#include <string>
#include <vector>

#include "graze/record/record_names.hpp"
#include "graze/report/page/page.hpp"

namespace graze {

// "1.05 mm" of 1.05e-3 m; a dash of what is not finite.
std::string measured_text(double value, const std::string& si_unit, int digits = 6);

template <class Record>
std::vector<PageTable> page_tables(const Record&) {
  return {};
}
std::vector<PageTable> page_tables(const FitRecord& record);
std::vector<PageTable> page_tables(const CostRecord& record);
std::vector<PageTable> page_tables(const ComparisonRecord& record);
std::vector<PageTable> page_tables(const SensitivityRecord& record);
std::vector<PageTable> page_tables(const RunDiagramRecord& record);

}  // namespace graze
