// Results as pages: one HTML file that holds a picture to look into and what is behind its
// points, with all that draws it. It opens from a disk and fetches nothing.
#pragma once

#include <string>
#include <vector>

#include "graze/record/file/run_info.hpp"
#include "graze/record/records.hpp"
#include "graze/record/study_records.hpp"
#include "graze/report/chart/chart.hpp"

namespace graze {

// Throws InputError unless `file` ends in .svg, .png, .pdf or .html, and for .html where this
// program was built without its page.
void check_picture_or_page_name(const std::string& file);

// Whether that name asks for a page.
bool is_page_name(const std::string& file);

// Throws InputError for a map of more cells than a page holds.
void check_map_page(const std::string& file, const Plane& plane);

// All throw FileError, leaving the file as it was, where it cannot be written.

// `scene`: the one in force.

// The phase portraits of the orbits found; behind each its motion and multipliers.
void write_page(const std::string& file, const OrbitRecord& record, const Scene& scene);

// The branches over the parameter.
void write_page(const std::string& file, const BranchRecord& record, const Scene& scene);

// The sweep, and the branches over it.
void write_page(const std::string& file, const DiagramRecord& record, const Scene& scene);

// The cells of the map, each with what it settles on and the command that follows it, the motions
// of some, and the loci over them.
void write_page(const std::string& file, const MapRecord& record, const Scene& scene);

// The recorded samples over time, as motion_chart (charts.hpp) shows them.
void write_page(const std::string& file, const SimulationRecord& record);

// The plane of two parameters with the loci, over what is stable where, if that was looked for.
void write_page(const std::string& file, const LociRecord& record, const Scene& scene);

// What two scenes have in common over a plane. `scene`: the first of them.
void write_page(const std::string& file, const ComparisonMapRecord& record, const Scene& scene);

// Of cells as they are shown, numbers with their units or units in the names of the columns.
struct PageTable {
  std::string name;  // "Fitted parameters"
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> opens =
      {};  // the thing that the first cell of each row opens, -1: none; or none
};

// Any chart, with tables below it.
void write_page(const std::string& file, const Chart& chart, const RunInfo& info,
                const Outcome& outcome, const std::vector<std::string>& warnings,
                const std::vector<PageTable>& tables = {});

}  // namespace graze
