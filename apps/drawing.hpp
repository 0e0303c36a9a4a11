// What is drawn of each result, and as what: by the command that made it, and later from its
// folder.
#pragma once

#include <string>

#include "command.hpp"
#include "graze/record/record_names.hpp"
#include "graze/record/stored/record_file.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/page/page.hpp"
#include "graze/report/page/page_tables.hpp"
#include "graze/report/picture/pictures.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// What is drawn of a record, as its command asked. `scene`: the one in force.
template <class Record>
Chart chart_shown(const Record& record, const Scene&, bool multipliers = false) {
  if constexpr (requires { chart_of(record, multipliers); })
    return chart_of(record, multipliers);
  else
    return chart_of(record);
}
Chart chart_shown(const CheckRecord& record, const Scene& scene, bool multipliers = false);
Chart chart_shown(const ModesRecord& record, const Scene& scene, bool multipliers = false);
Chart chart_shown(const SimulationRecord& record, const Scene& scene, bool multipliers = false);

// A page of its own where that is more than the chart.
template <class Record>
void draw_page(const std::string& file, const Record& record, const Scene& scene) {
  if constexpr (requires { write_page(file, record, scene); })
    write_page(file, record, scene);
  else
    write_page(file, chart_shown(record, scene), record.info, record.outcome, record.warnings,
               page_tables(record));
}
void draw_page(const std::string& file, const SimulationRecord& record, const Scene& scene);

// Draws the picture or page that --plot names. Throws FileError.
template <class Record>
void draw(const CommonOptions& command, const Record& record, const Scene& scene) {
  const PictureRequest& plot = command.plot;
  if (is_page_name(plot.file))
    draw_page(plot.file, record, scene);
  else
    draw_chart(plot, info_of(record), chart_shown(record, scene, plot.multipliers));
}

// Why nothing is drawn of that record; empty where something is.
template <class Record>
std::string nothing_to_draw(const Record&) {
  return "";
}
std::string nothing_to_draw(const ComparisonRecord& record);
std::string nothing_to_draw(const SensitivityRecord& record);
std::string nothing_to_draw(const FitRecord& record);

// Throws InputError where --plot is given and is no name of what is drawn of such records, or is to
// show what their pictures do not have.
void check_plot(const CommonOptions& command, const PictureFeatures& features);
template <class Record>
void check_plot(const CommonOptions& command) {
  check_plot(command, kFeatures<Record>);
}

// Fills in where the beam's shape is shown, as far as a picture or page of the run shows it.
void place_beam(const CommonOptions& command, const Scene& scene, SimulationRecord& record);

}  // namespace graze
