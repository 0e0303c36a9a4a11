// Parts of records that are not written member by member (value_text.hpp): those that follow from
// the scene, those that only the run itself used, and types with private members.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graze/record/file/detail/fields.hpp"
#include "graze/record/records.hpp"
#include "graze/record/study_records.hpp"
#include "graze/scene/reader.hpp"

namespace graze {

// Follows from the scene, which is stored beside the record.
template <class Archive>
void fields(Archive&, System&) {}
template <class Archive>
void fields(Archive&, std::optional<BeamPlaces>&) {}
// Without the text of the scene, which is stored beside the record, and without the call, which
// stands at the beginning of the file.
template <class Archive>
void fields(Archive& archive, RunInfo& info) {
  RunInfo told = info;
  told.scene_text.clear(), told.arguments.clear(), told.settings.clear(), told.folder.clear();
  with_members(told, [&](auto&... members) { (archive(members), ...); });
  if constexpr (Archive::kReads) info = std::move(told);
}
template <class Archive>
void fields(Archive& archive, Scene& scene) {
  std::string text;
  if constexpr (!Archive::kReads) text = write_scene(scene);
  archive(text);
  if constexpr (Archive::kReads) scene = parse_scene(text, "scene");
}
template <class Archive>
void fields(Archive& archive, EventExcerpt& excerpt) {
  long long count = excerpt.count();
  std::vector<Event> first = excerpt.first();
  std::deque<Event> last = excerpt.last();
  archive(count), archive(first), archive(last);
  if constexpr (Archive::kReads) excerpt = EventExcerpt(count, std::move(first), std::move(last));
}
template <class Archive>
void fields(Archive& archive, RunSection& section) {
  DiagramSection kind = section.kind();
  double from = section.from();
  std::vector<SectionPoint> points = section.points();
  long long left_out = section.left_out();
  archive(kind), archive(from), archive(points), archive(left_out);
  if constexpr (Archive::kReads) section = RunSection(kind, from, std::move(points), left_out);
}

// Only the options that results report; how a run was stopped, shared and watched ends with it.
template <class Archive>
void row_fields(Archive& archive, RowOptions& options) {
  archive(options.periods), archive(options.samples), archive(options.nearness);
  archive(options.max_impacts), archive(options.closure_speed);
  archive(options.exponent_periods), archive(options.measure);
}
template <class Archive>
void fields(Archive& archive, SweepOptions& options) {
  row_fields(archive, options);
  archive(options.from), archive(options.to), archive(options.points), archive(options.direction);
}
template <class Archive>
void plane_fields(Archive& archive, Plane& plane) {
  archive(plane.x), archive(plane.y);
}
template <class Archive>
void fields(Archive& archive, AttractorMapOptions& options) {
  row_fields(archive, options), plane_fields(archive, options);
}
template <class Archive>
void fields(Archive& archive, CompareOptions& options) {
  row_fields(archive, options);
  archive(options.first), archive(options.within);
}
template <class Archive>
void fields(Archive& archive, ComparisonMapOptions& options) {
  fields(archive, static_cast<CompareOptions&>(options));
  plane_fields(archive, options);
}

template <class Record>
std::string record_text(const Record& record) {
  return value_text(record);
}
template <class Record>
bool read_record_text(std::string_view text, Record& record) {
  return read_value(text, record);
}

}  // namespace graze
