// graze view: an earlier result, printed and drawn from its folder without computing it again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

#include "branch_options.hpp"
#include "graze/base/errors.hpp"
#include "graze/report/chart/charts.hpp"
#include "graze/report/names/detail/comparison_names.hpp"
#include "graze/report/names/detail/map_names.hpp"
#include "graze/report/page/detail/page.hpp"
#include "option_values.hpp"
#include "run_output.hpp"
#include "session.hpp"

namespace graze {
namespace {

// The one of `things` that --show names, if any does.
template <class List>
auto shown_in(const List& things, const std::string& word) {
  const auto found = std::find_if(std::begin(things), std::end(things),
                                  [&](const auto& thing) { return name_of(thing) == word; });
  return found == std::end(things) ? std::nullopt : std::optional(*found);
}

[[noreturn]] void refuse_word(const ViewCommand& command, std::vector<std::string> known) {
  throw InputError(fmt::format("--show: '{}' is not allowed for this result; give one of {}",
                               command.show, fmt::join(known, ", ")));
}

template <class List>
auto shown_among(const List& things, const ViewCommand& command) {
  const auto shown = shown_in(things, command.show);
  if (!shown) refuse_word(command, names_of(things));
  return *shown;
}

void refuse_place(const ViewCommand& command) {
  if (!command.at.empty())
    throw InputError("--at: what the picture of this result shows has no place to choose");
}

[[noreturn]] void refuse_to_show(const ViewCommand& command, const std::string& why) {
  throw InputError(fmt::format("--show {}: the run in {} {}", command.show, command.result, why));
}

// What was measured, as --show and --at name it.
Shown measured_as(const ViewCommand& command, ShownQuantity quantity,
                  const std::vector<MeasuredPlace>& places) {
  if (places.empty())
    refuse_to_show(command, "did not measure its motions; run it again with --amplitudes");
  return *shown_of(quantity, command.at, places);
}

// Lets the picture show what the options say.
template <class Record>
void show(const ViewCommand& command, Record&) {
  throw InputError(fmt::format("--show: the picture of the result in {} has nothing to choose from",
                               command.result));
}

// As many samples as a picture of the motion has, and the events among them.
void keep_end(SimulationRecord& record) {
  std::vector<Sample>& samples = record.samples;
  std::vector<Event>& events = record.events;
  if (samples.size() <= kPictureSamples) return;
  samples.erase(samples.begin(), samples.end() - kPictureSamples);
  events.erase(events.begin(), std::find_if(events.begin(), events.end(), [&](const Event& event) {
                 return event.time >= samples.front().time;
               }));
}

void show(const ViewCommand& command, SimulationRecord& record) {
  refuse_place(command);
  const RunPicture shown = shown_among(kRunPictures, command);
  const bool has_impacts = record.section && record.section->kind() == DiagramSection::kImpact;
  if (shown == RunPicture::kReturns && !has_impacts)
    refuse_to_show(command,
                   "kept no impacts for it; run it again with --section impact and --plot");
  if (shown == RunPicture::kSpectrum && record.shown != shown)
    refuse_to_show(command,
                   "kept too little of its motion; run it again with --show spectrum and --plot");
  if (shown == RunPicture::kShapes && record.shapes.empty())
    refuse_to_show(command,
                   "kept no shapes; run it again with --show shapes, --shapes-at and --plot");
  const bool has_means = record.run.amplitudes && record.run.amplitudes->forces;
  if (shown == RunPicture::kForces && record.system.stops.empty())
    refuse_to_show(command, "has no stops");
  if (shown == RunPicture::kForces && record.system.has_rigid_stop() && !has_means)
    refuse_to_show(command, "kept no forces; run it again with --forces N");
  if (shown == RunPicture::kMotion || shown == RunPicture::kForces) keep_end(record);
  record.shown = shown;
}

void show(const ViewCommand& command, BranchRecord& record) {
  const ShownQuantity quantity = shown_among(kShownQuantities, command);
  record.shown = measured_as(command, quantity, record.amplitudes.places);
}

void show(const ViewCommand& command, DiagramRecord& record) {
  show(command, record.branches);
  if (!record.curves.empty()) record.curves = {amplitude_curves(record.branches)};
}

void show(const ViewCommand& command, MapRecord& record) {
  record.measured.reset();
  if (const auto quantity = shown_in(kShownQuantities, command.show)) {
    record.measured = measured_as(command, *quantity, record.places);
    record.shown = MapQuantity::kMeasured;
    return;
  }
  refuse_place(command);
  const auto shown = shown_in(kMapQuantities, command.show);
  if (!shown) {
    std::vector<std::string> known = names_of(kMapQuantities);
    for (const std::string& name : names_of(kShownQuantities)) known.push_back(name);
    refuse_word(command, std::move(known));
  }
  record.shown = *shown;
  if (record.shown == MapQuantity::kExponent && record.map.options.exponent_periods == 0)
    refuse_to_show(command, "has no exponents; run it again with --exponents K");
}

void show(const ViewCommand& command, ComparisonMapRecord& record) {
  refuse_place(command);
  record.shown = shown_among(kComparedQuantities, command);
}

// Throws InputError where the record is not drawn into such a file, or at all.
template <class Record>
void check_drawable(const ViewCommand& command, const Record& record) {
  if (const std::string nothing = nothing_to_draw(record); !nothing.empty())
    throw InputError("--plot: " + nothing);
  check_plot<Record>(command);
}
void check_drawable(const ViewCommand& command, const SimulationRecord& record) {
  check_plot_of_run(command, record.section.has_value(), record.shown);
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
  if (!command.show.empty()) show(command, record);
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
  std::visit([&](auto& record) { view(command, result, record); }, result.record);
  return 0;
}

}  // namespace graze
