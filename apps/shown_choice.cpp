#include "shown_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <variant>

#include "branch_options.hpp"
#include "graze/base/errors.hpp"
#include "graze/record/names/plane_names.hpp"
#include "options/option.hpp"
#include "run_output.hpp"

namespace graze {
namespace {

// The one of `things` that --show names, if any does.
template <class List>
auto shown_in(const List& things, const std::string& word) {
  const auto found = std::find_if(std::begin(things), std::end(things),
                                  [&](const auto& thing) { return name_of(thing) == word; });
  return found == std::end(things) ? std::nullopt : std::optional(*found);
}

[[noreturn]] void refuse_word(const ShownChoice& choice, std::vector<std::string> known) {
  throw InputError(fmt::format("--show: '{}' is not allowed for this result; give one of {}",
                               choice.show, fmt::join(known, ", ")));
}

template <class List>
auto shown_among(const List& things, const ShownChoice& choice) {
  const auto shown = shown_in(things, choice.show);
  if (!shown) refuse_word(choice, names_of(things));
  return *shown;
}

void refuse_place(const ShownChoice& choice) {
  if (!choice.at.empty())
    throw InputError("--at: what the picture of this result shows has no place to choose");
}

[[noreturn]] void refuse_to_show(const ShownChoice& choice, const std::string& why) {
  throw InputError(fmt::format("--show {}: {} {}", choice.show, choice.whose, why));
}

// What was measured, as --show and --at name it.
Shown measured_as(const ShownChoice& choice, ShownQuantity quantity,
                  const std::vector<MeasuredPlace>& places) {
  if (places.empty())
    refuse_to_show(choice, "did not measure its motions; run it again with --amplitudes");
  return *shown_of(quantity, choice.at, places);
}

// Lets the picture show what the options say.
template <class Record>
void show(const ShownChoice& choice, Record&) {
  throw InputError(
      fmt::format("--show: the picture of {} has nothing to choose from", choice.whose));
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

void show(const ShownChoice& choice, SimulationRecord& record) {
  refuse_place(choice);
  const RunPicture shown = shown_among(kRunPictures, choice);
  const bool has_impacts = record.section && record.section->kind() == DiagramSection::kImpact;
  if (shown == RunPicture::kReturns && !has_impacts)
    refuse_to_show(choice, "kept no impacts for it; run it again with --section impact and --plot");
  if (shown == RunPicture::kSpectrum && record.shown != shown)
    refuse_to_show(choice,
                   "kept too little of its motion; run it again with --show spectrum and --plot");
  if (shown == RunPicture::kPsd && !record.statistics)
    refuse_to_show(choice, "has no power spectral density; run it again with --statistics");
  if (shown == RunPicture::kShapes && record.shapes.empty())
    refuse_to_show(choice,
                   "kept no shapes; run it again with --show shapes, --shapes-at and --plot");
  const bool has_means = record.run.amplitudes && record.run.amplitudes->forces;
  if (shown == RunPicture::kForces && record.system.stops.empty())
    refuse_to_show(choice, "has no stops");
  if (shown == RunPicture::kForces && record.system.has_rigid_stop() && !has_means)
    refuse_to_show(choice, "kept no forces; run it again with --forces N");
  if (shown == RunPicture::kMotion || shown == RunPicture::kForces) keep_end(record);
  record.shown = shown;
}

void show(const ShownChoice& choice, BranchRecord& record) {
  const ShownQuantity quantity = shown_among(kShownQuantities, choice);
  record.shown = measured_as(choice, quantity, record.amplitudes.places);
}

void show(const ShownChoice& choice, DiagramRecord& record) {
  show(choice, record.branches);
  if (!record.curves.empty()) record.curves = {amplitude_curves(record.branches)};
}

void show(const ShownChoice& choice, MapRecord& record) {
  record.measured.reset();
  if (const auto quantity = shown_in(kShownQuantities, choice.show)) {
    record.measured = measured_as(choice, *quantity, record.places);
    record.shown = MapQuantity::kMeasured;
    return;
  }
  refuse_place(choice);
  const auto shown = shown_in(kMapQuantities, choice.show);
  if (!shown) {
    std::vector<std::string> known = names_of(kMapQuantities);
    for (const std::string& name : names_of(kShownQuantities)) known.push_back(name);
    refuse_word(choice, std::move(known));
  }
  record.shown = *shown;
  if (record.shown == MapQuantity::kExponent && record.map.options.exponent_periods == 0)
    refuse_to_show(choice, "has no exponents; run it again with --exponents K");
}

void show(const ShownChoice& choice, ComparisonMapRecord& record) {
  refuse_place(choice);
  record.shown = shown_among(kComparedQuantities, choice);
}

}  // namespace

void choose_shown(const ShownChoice& choice, AnyRecord& record) {
  std::visit([&](auto& one) { show(choice, one); }, record);
}

}  // namespace graze
