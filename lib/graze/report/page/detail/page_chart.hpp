// Charts (report/chart) as pages hold them.
#pragma once

#include <string>
#include <vector>

#include "graze/report/json/detail/json_value.hpp"
#include "graze/report/page/page.hpp"

namespace graze {

// A chart as a view, with tables below it, to which what its things open may be added.
Json chart_view(const Chart& chart, const RunInfo& info, const Outcome& outcome,
                const std::vector<std::string>& warnings, const std::vector<std::string>& notes,
                const std::vector<PageTable>& tables);

// As a view has them (view.tables).
Json tables_json(const std::vector<PageTable>& tables);

}  // namespace graze
