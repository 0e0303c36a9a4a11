// Any chart (report/chart) as a page, with tables below it.
#pragma once

#include <string>
#include <vector>

#include "graze/record/file/run_info.hpp"
#include "graze/record/records.hpp"
#include "graze/report/chart/chart.hpp"
#include "graze/report/json/detail/json_value.hpp"

namespace graze {

// Of cells as they are shown, numbers with their units or units in the names of the columns.
struct PageTable {
  std::string name;  // "Fitted parameters"
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> opens =
      {};  // the thing that the first cell of each row opens, -1: none; or none
};

// Throws FileError, leaving the file as it was, where it cannot be written.
void write_page(const std::string& file, const Chart& chart, const RunInfo& info,
                const Outcome& outcome, const std::vector<std::string>& warnings,
                const std::vector<PageTable>& tables = {});

// The same as a view, to which what its things open may be added.
Json chart_view(const Chart& chart, const RunInfo& info, const Outcome& outcome,
                const std::vector<std::string>& warnings, const std::vector<std::string>& notes,
                const std::vector<PageTable>& tables);

// As a view has them (view.tables).
Json tables_json(const std::vector<PageTable>& tables);

}  // namespace graze
