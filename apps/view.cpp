// graze view: an earlier result, printed and drawn from its folder without computing it again.
#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include "graze/base/errors.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/page/page.hpp"
#include "run_output.hpp"
#include "session.hpp"
#include "shown_choice.hpp"

namespace graze {
namespace {

// Throws InputError where the record is not drawn into such a file, or at all.
template <class Record>
void check_drawable(const ViewCommand& command, const Record& record) {
  if (const std::string nothing = nothing_to_draw(record); !nothing.empty())
    throw InputError("--plot: " + nothing);
  check_plot<Record>(command);
}
void check_drawable(const ViewCommand& command, const SimulationRecord& record) {
  check_plot<SimulationRecord>(command);
  const bool of_motion = record.shown == RunPicture::kSpectrum ||
                         (record.shown == RunPicture::kForces &&
                          record.system.has_compliant_stop() && !shows_force_means(record)) ||
                         (record.shown == RunPicture::kMotion && !record.section);
  if (of_motion && record.samples.empty())
    throw InputError("--plot: the run ended before the motion that a picture shows");
}
void check_drawable(const ViewCommand& command, const MapRecord& record) {
  check_plot<MapRecord>(command);
  if (is_page_name(command.plot.file)) check_map_page(command.plot.file, record.map.options);
}

template <class Record>
const std::vector<std::string>& warnings_of(const Record& record) {
  return record.warnings;
}
const std::vector<std::string>& warnings_of(const DiagramRecord& record) {
  return record.branches.warnings;
}

template <class Record>
void view(const ViewCommand& command, const StoredResult& result, Record& record) {
  if (!command.plot.empty()) check_drawable(command, record);
  prepare_output(command);
  warn(command, warnings_of(record));
  if (!command.caller)
    print([&](const TextSink& sink) {
      if (command.json)
        result.read_document(sink);
      else
        sink(printed_text(command, to_text(record, command.text)));
    });
  if constexpr (std::is_same_v<Record, SimulationRecord>) place_beam(command, result.scene, record);
  if (!command.plot.empty()) draw(command, record, result.scene);
  if (!command.caller) return;
  std::string document;
  result.read_document([&](std::string_view piece) { document += piece; });
  command.caller->take(std::move(record), result.scene, std::move(document));
}

}  // namespace

int run(const ViewCommand& command) {
  StoredResult result = read_result(command.result);
  if (!command.show.empty())
    choose_shown({command.show, command.at, "the run in " + command.result}, result.record);
  std::visit([&](auto& record) { view(command, result, record); }, result.record);
  return 0;
}

}  // namespace graze
