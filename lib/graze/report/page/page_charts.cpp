#include "graze/record/detail/comparison_record.hpp"
#include "graze/record/detail/cost_record.hpp"
#include "graze/record/detail/fit_record.hpp"
#include "graze/record/detail/run_diagram_record.hpp"
#include "graze/record/detail/sensitivity_record.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/report/page/detail/page_tables.hpp"

namespace graze {
namespace {

template <class Record>
void write_chart_page(const std::string& file, const Record& record) {
  write_page(file, chart_of(record), record.info, record.outcome, record.warnings,
             page_tables(record));
}

}  // namespace

void write_page(const std::string& file, const FitRecord& record) {
  write_chart_page(file, record);
}
void write_page(const std::string& file, const CostRecord& record) {
  write_chart_page(file, record);
}
void write_page(const std::string& file, const ComparisonRecord& record) {
  write_chart_page(file, record);
}
void write_page(const std::string& file, const SensitivityRecord& record) {
  write_chart_page(file, record);
}
void write_page(const std::string& file, const RunDiagramRecord& record) {
  write_chart_page(file, record);
}

}  // namespace graze
