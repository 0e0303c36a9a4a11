#include <fmt/format.h>

#include "graze/report/chart/charts.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page_beam.hpp"
#include "graze/report/page/detail/page_chart.hpp"
#include "graze/report/page/page.hpp"

namespace graze {
namespace {

// "stop 1", "stops 1 and 2", "the stop"
std::string name_of(const SeenPlace& place, std::size_t stops) {
  if (place.stops.empty())
    return place.is_modal() ? "" : fmt::format("friction {}", place.frictions.front() + 1);
  if (stops < 2) return "the stop";
  std::string name = place.stops.size() > 1 ? "stops" : "stop";
  for (const SeenStop& stop : place.stops)
    name += fmt::format("{} {}", &stop == &place.stops.front() ? "" : " and", stop.index + 1);
  return name;
}

// What the chart does not have of a place: the velocity at every point of its displacement, and the
// impacts with their velocities.
Json run_place_json(const SeenPlace& place, std::size_t stops) {
  std::vector<double> times;
  std::vector<float> v, at, before, after;
  for (const MotionPoint& point : place.motion) v.push_back(static_cast<float>(point.velocity));
  for (const SeenImpact& impact : place.impacts) {
    times.push_back(impact.time);
    at.push_back(static_cast<float>(impact.place));
    before.push_back(static_cast<float>(impact.before));
    after.push_back(static_cast<float>(impact.after));
  }
  Json list = Json::array();
  for (const SeenStop& stop : place.stops)
    list.push_back({{"index", stop.index + 1}, {"sense", stop.sense}, {"place", stop.place}});
  return {{"name", name_of(place, stops)},
          {"stops", list},
          {"v", packed(v)},
          {"impacts",
           {{"t", packed(times)},
            {"place", packed(at)},
            {"before", packed(before)},
            {"after", packed(after)}}}};
}

}  // namespace

void write_page(const std::string& file, const SimulationRecord& record) {
  const Chart chart = explored_chart(record);
  Json view = chart_view(chart, record.info, record.outcome, record.warnings, record.notes, {});
  view["kind"] = "run";
  view["places"] = Json::array();
  const std::size_t stops = record.system.stops.size();
  for (const SeenPlace& place : motion_seen(record).places)
    // As many as the chart shows.
    if (view["places"].size() < kMostRunPlaces)
      view["places"].push_back(run_place_json(place, stops));
  view["beam"] = beam_json(record);
  write_page_file(file, view, Json::array());
}

}  // namespace graze
