#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "graze/assembly/probes.hpp"
#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/chart/detail/probe_panels.hpp"
#include "graze/report/json/detail/json_page.hpp"
#include "graze/report/page/detail/page.hpp"
#include "graze/report/page/detail/page_beam.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostRunPlaces = 4;  // as in the picture

struct PageCurve {
  std::string name, colour;
  const DrawnCurve& curve;
};

// The motion at the places of the stops, and panels over time that show it and what else is known
// of it.
class SimulationPage {
 public:
  explicit SimulationPage(const SimulationRecord& record)
      : record_(record), seen_(motion_seen(record)) {
    places_left_out_ = seen_.places.size() - std::min(seen_.places.size(), kMostRunPlaces);
    seen_.places.resize(seen_.places.size() - places_left_out_);
  }

  Json view() {
    Json view = page_view(record_.info, record_.outcome, record_.warnings, record_.notes);
    view["kind"] = "run";
    view["title"] = "Motion";
    const Units units = record_.info.units;
    view["time"] =
        page_axis("time", unit_in(units, "s"), {seen_.window.start, seen_.window.end}, 0.0);
    AxisRange displacement, velocity;
    Json places = Json::array();
    for (const SeenPlace& place : seen_.places) {
      for (const MotionPoint& point : place.motion) {
        displacement.include(point.displacement);
        velocity.include(point.velocity);
      }
      places.push_back(place_json(place));
    }
    view["length"] = page_axis(no_stops() ? "first mode q₁" : "displacement",
                               unit_in(units, no_stops() ? "kg^1/2 m" : "m"), displacement);
    view["speed"] = page_axis(no_stops() ? "rate of q₁" : "velocity",
                              unit_in(units, no_stops() ? "kg^1/2 m/s" : "m/s"), velocity);
    view["places"] = places;
    add_motion(view["length"], view["speed"]);
    add_curves();
    view["panels"] = panels_;
    view["beam"] = beam_json(record_);
    if (places_left_out_ > 0)
      view["notes"].push_back(fmt::format("the page shows the first {} of {} places with stops",
                                          seen_.places.size(),
                                          seen_.places.size() + places_left_out_));
    return view;
  }

 private:
  bool no_stops() const { return record_.system.stops.empty(); }
  bool several_stops() const { return record_.system.stops.size() > 1; }

  // "stop 1", "stops 1 and 2", "the stop"
  std::string name_of(const SeenPlace& place) const {
    if (!several_stops()) return no_stops() ? "" : "the stop";
    std::string name = place.stops.size() > 1 ? "stops" : "stop";
    for (const SeenStop& stop : place.stops)
      name += fmt::format("{} {}", &stop == &place.stops.front() ? "" : " and", stop.index + 1);
    return name;
  }

  Json place_json(const SeenPlace& place) const {
    std::vector<double> t, impact_t;
    std::vector<float> x, v, impact_place, before, after;
    for (const MotionPoint& point : place.motion) {
      t.push_back(point.time);
      x.push_back(static_cast<float>(point.displacement));
      v.push_back(static_cast<float>(point.velocity));
    }
    for (const SeenImpact& impact : place.impacts) {
      impact_t.push_back(impact.time);
      impact_place.push_back(static_cast<float>(impact.place));
      before.push_back(static_cast<float>(impact.before));
      after.push_back(static_cast<float>(impact.after));
    }
    Json stops = Json::array(), stuck = Json::array();
    for (const SeenStop& stop : place.stops)
      stops.push_back({{"index", stop.index + 1}, {"sense", stop.sense}, {"place", stop.place}});
    for (const StuckPhase& phase : place.stuck) stuck.push_back({phase.time.start, phase.time.end});
    return {{"name", name_of(place)},
            {"stops", stops},
            {"stuck", stuck},
            {"t", packed(t)},
            {"x", packed(x)},
            {"v", packed(v)},
            {"impacts",
             {{"t", packed(impact_t)},
              {"place", packed(impact_place)},
              {"before", packed(before)},
              {"after", packed(after)}}}};
  }

  void add_motion(const Json& length, const Json& speed) {
    for (std::size_t i = 0; i < seen_.places.size(); ++i) {
      const SeenPlace& place = seen_.places[i];
      AxisRange range;
      for (const MotionPoint& point : place.motion) range.include(point.displacement);
      // A stop far off the motion would press it flat.
      const AxisRange motion = range;
      for (const SeenStop& stop : place.stops)
        if (is_near(stop, motion)) range.include(stop.place);
      add_panel("displacement", length, range);
      set_place(i);
    }
    AxisRange range;
    for (const MotionPoint& point : seen_.places.front().motion) range.include(point.velocity);
    add_panel("velocity", speed, range);
    set_place(0);
  }

  // Of the panel added last: what is shown of a place counts towards its first stop.
  void set_place(std::size_t i) {
    panels_.back()["place"] = i;
    if (!no_stops())
      panels_.back()["more"] =
          "towards " + (several_stops()
                            ? fmt::format("stop {}", seen_.places[i].stops.front().index + 1)
                            : name_of(seen_.places[i]));
  }

  void add_curves() {
    for (const ProbePanel& panel : probe_panels(seen_.probes)) {
      std::vector<PageCurve> curves;
      for (const SeenProbe& probe : panel.probes)
        if (curves.size() < curve_colours().size())
          curves.push_back(
              {fmt::format("probe {}", probe.number), curve_colours()[curves.size()], probe.curve});
      std::string name = panel.name();
      std::replace(name.begin(), name.end(), '\n', ' ');
      add_curve_panel(name, unit_in(record_.info.units, panel.si_unit), curves, false);
    }
    std::vector<PageCurve> forces, energy;
    for (const SeenForce& seen : seen_.forces)
      forces.push_back(
          {several_stops() ? fmt::format("force at stop {}", seen.stop + 1) : "contact force",
           curve_colours()[static_cast<std::size_t>(seen.stop) % curve_colours().size()],
           seen.force});
    for (const EnergyTerm& term : seen_.energy)
      energy.push_back(
          {energy.empty() ? term.name : "work of " + term.name, term.colour, term.curve});
    if (!forces.empty())
      add_curve_panel("contact force", unit_in(record_.info.units, "N"), forces, true);
    if (energy.empty()) return;
    add_curve_panel(energy.size() > 1 ? "energy, work" : "energy", unit_in(record_.info.units, "J"),
                    energy, true);
    if (energy.size() > 1 && seen_.window.start > 0.0)
      panels_.back()["more"] =
          fmt::format("since {:.5g}{}", seen_.window.start, unit_behind(record_.info.units, "s"));
  }

  void add_curve_panel(const std::string& name, const std::string& unit,
                       const std::vector<PageCurve>& curves, bool from_zero) {
    AxisRange range;
    if (from_zero) range.include(0.0);
    Json list = Json::array();
    for (const PageCurve& shown : curves) {
      std::vector<double> t;
      std::vector<float> y;
      for (const DrawnPoint& point : shown.curve) {
        t.push_back(point.time);
        y.push_back(static_cast<float>(point.value));
      }
      range.include(range_of(shown.curve));
      list.push_back(
          {{"name", shown.name}, {"colour", shown.colour}, {"t", packed(t)}, {"y", packed(y)}});
    }
    add_panel("curves", page_axis(name, unit, range), range);
    panels_.back()["curves"] = list;
  }

  // In the unit of `quantity`.
  void add_panel(const char* kind, const Json& quantity, AxisRange range) {
    if (range.empty()) range.include(0.0);
    range.settle(0.08);
    Json panel = {{"kind", kind}};
    panel.update(quantity);
    panel["low"] = range.low;
    panel["high"] = range.high;
    panels_.push_back(panel);
  }

  const SimulationRecord& record_;
  MotionSeen seen_;
  std::size_t places_left_out_ = 0;
  Json panels_ = Json::array();
};

}  // namespace

void write_page(const std::string& file, const SimulationRecord& record) {
  write_page_file(file, SimulationPage(record).view(), Json::array());
}

}  // namespace graze
