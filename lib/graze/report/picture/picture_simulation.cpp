#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/detail/picture_curve.hpp"
#include "graze/report/picture/detail/picture_probes.hpp"
#include "graze/report/picture/detail/picture_stops.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostMarks = 3'000;
constexpr std::size_t kMostJumps = 200;  // beyond, their lines fill the panel
constexpr std::size_t kMostPicturePlaces = 4;
constexpr std::size_t kMostPortrayed = 20'000;  // points, which no band can stand for

std::string line(const std::string& data, const char* colour, double width = 1.2) {
  return fmt::format("${} with lines lw {} lc rgb '{}'", data, width, colour);
}

// A column of panels over time, and below it the phase portrait.
class SimulationPicture {
 public:
  SimulationPicture(const PictureRequest& request, const SimulationRecord& record)
      : request_(request),
        record_(record),
        seen_(motion_seen(record)),
        probes_(seen_.probes, record.info.units) {
    places_left_out_ = seen_.places.size() - std::min(seen_.places.size(), kMostPicturePlaces);
    seen_.places.resize(seen_.places.size() - places_left_out_);
    measure_motion();
    for (const SeenForce& seen : seen_.forces) force_range_.include(range_of(seen.force));
    force_ = axis_unit(unit_in(record.info.units, "N"), largest(force_range_));
    for (const EnergyTerm& term : seen_.energy) energy_range_.include(range_of(term.curve));
    energy_ = axis_unit(unit_in(record.info.units, "J"), largest(energy_range_));
    time_ = axis_unit(unit_in(record.info.units, "s"),
                      std::max(std::abs(seen_.window.start), std::abs(seen_.window.end)));
    window_ = {time_.factor * seen_.window.start, time_.factor * seen_.window.end};
    if (!(window_.span() > 0.0)) window_.high = window_.low + 1.0;
    lay_out();
  }

  GnuplotScript script() {
    set_style(script_);
    for (std::size_t i = 0; i < seen_.places.size(); ++i) write_place(i);
    script_.command("set multiplot");
    column_.set_time_axis(window_, time_.unit);
    for (std::size_t i = 0; i < seen_.places.size(); ++i) draw_displacement(i);
    draw_velocity();
    for (std::size_t i = 0; i < probes_.count(); ++i)
      probes_.draw(i, script_, column_, time_.factor);
    if (shows_forces()) draw_forces();
    if (shows_energy()) draw_energy();
    const std::size_t portraits = std::min(seen_.places.size(), std::size_t{2});
    for (std::size_t i = 0; i < portraits && shows_portraits(); ++i) draw_portrait(i, portraits);
    script_.command("unset multiplot");
    return script_;
  }

  const Canvas& canvas() const { return column_.canvas(); }

 private:
  void lay_out() {
    gather_legend();
    std::vector<double> panels(seen_.places.size() + 1 + probes_.count(), PanelColumn::kPanel);
    if (shows_forces()) panels.push_back(PanelColumn::kLowPanel);
    if (shows_energy()) panels.push_back(PanelColumn::kPanel);
    column_.lay_out(request_, record_.info, panels, shows_portraits(), !legend_.empty(),
                    shows_energy() || several_stops() || probes_.labelled());
  }

  bool no_stops() const { return record_.system.stops.empty(); }
  bool several_stops() const { return record_.system.stops.size() > 1; }
  bool shows_forces() const { return !seen_.forces.empty(); }
  bool shows_energy() const { return !seen_.energy.empty(); }
  bool shows_portraits() const { return !record_.samples.empty(); }

  void measure_motion() {
    AxisRange displacement, velocity;
    for (const SeenPlace& place : seen_.places)
      for (const MotionPoint& point : place.motion) {
        displacement.include(point.displacement);
        velocity.include(point.velocity);
      }
    // Without a stop the picture shows a modal coordinate, which is no length.
    const Units units = record_.info.units;
    length_ = axis_unit(unit_in(units, no_stops() ? "kg^1/2 m" : "m"), largest(displacement));
    speed_ = axis_unit(unit_in(units, no_stops() ? "kg^1/2 m/s" : "m/s"), largest(velocity));
    for (const SeenPlace& place : seen_.places)
      stops_.emplace_back(place.stops, displacement_range(place.motion), length_, several_stops(),
                          units);
  }

  AxisRange displacement_range(std::span<const MotionPoint> motion) const {
    AxisRange range;
    for (const MotionPoint& point : motion) range.include(length_.factor * point.displacement);
    return range;
  }

  AxisRange velocity_range(std::span<const MotionPoint> motion) const {
    AxisRange range;
    for (const MotionPoint& point : motion) range.include(speed_.factor * point.velocity);
    range.settle(0.08);
    return range;
  }

  // What a portrait shows: the end of a long motion, whose beginning would only be drawn over.
  static std::span<const MotionPoint> portrayed(const SeenPlace& place) {
    return std::span(place.motion).last(std::min(place.motion.size(), kMostPortrayed));
  }

  // One entry for every kind of mark.
  void gather_legend() {
    const auto any = [&](const auto& has) {
      return std::any_of(seen_.places.begin(), seen_.places.end(), has);
    };
    if (std::any_of(stops_.begin(), stops_.end(), [](const StopMarks& s) { return s.drawn(); }))
      legend_.push_back(fmt::format("NaN with lines lw 2 lc rgb '{}' title 'stop'", kBlack));
    if (any([](const SeenPlace& place) { return !place.stuck.empty(); }))
      legend_.push_back(fmt::format(
          "NaN with boxes fillstyle solid noborder fc rgb '{}' title 'stuck'", kStuckShade));
    if (any([](const SeenPlace& place) { return !place.impacts.empty(); }))
      legend_.push_back(
          fmt::format("NaN with points pt 7 ps mark*0.55 lc rgb '{}' title 'impact'", kVermillion));
  }

  // "stop", or "stop 2" where there are several: the first one at the place.
  std::string stop_name(const SeenPlace& place) const {
    return several_stops() ? fmt::format("stop {}", place.stops.front().index + 1) : "stop";
  }

  // Towards the stop, as all that is shown of a place, in the few letters that a low panel is high;
  // probes show u and u'.
  std::string velocity_name(const SeenPlace& place) const {
    return no_stops() ? "rate of q_1\n" : "velocity\n→ " + stop_name(place);
  }

  void write_place(std::size_t i) {
    const SeenPlace& place = seen_.places[i];
    DrawnCurve displacement, velocity;
    for (const MotionPoint& point : place.motion) {
      displacement.push_back({point.time, point.displacement});
      velocity.push_back({point.time, point.velocity});
    }
    script_.data(fmt::format("displacement{}", i + 1),
                 table_of(displacement, time_.factor, length_.factor));
    script_.data(fmt::format("velocity{}", i + 1), table_of(velocity, time_.factor, speed_.factor));
    PlotTable portrait, touches, approaches, jumps, stuck, rest;
    for (const MotionPoint& point : portrayed(place))
      portrait.row({length_.factor * point.displacement, speed_.factor * point.velocity});
    const std::size_t stride = place.impacts.size() / kMostMarks + 1;
    for (std::size_t k = 0; k < place.impacts.size(); k += stride) {
      const SeenImpact& impact = place.impacts[k];
      const double time = time_.factor * impact.time, at = length_.factor * impact.place;
      touches.row({time, at});
      if (impact.time >= portrayed(place).front().time)
        approaches.row({at, speed_.factor * impact.before});
      jumps.row({time, speed_.factor * impact.before});
      jumps.row({time, speed_.factor * impact.after});
      jumps.gap();
    }
    std::set<double> rests;
    for (const StuckPhase& phase : place.stuck) {
      stuck.row({time_.factor * phase.time.start, time_.factor * phase.time.end});
      rests.insert(length_.factor * phase.place);
    }
    for (const double at : rests) rest.row({at, 0.0});
    script_.data(fmt::format("portrait{}", i + 1), portrait);
    script_.data(fmt::format("touches{}", i + 1), touches);
    script_.data(fmt::format("approaches{}", i + 1), approaches);
    script_.data(fmt::format("jumps{}", i + 1), jumps);
    script_.data(fmt::format("stuck{}", i + 1), stuck);
    script_.data(fmt::format("rest{}", i + 1), rest);
  }

  void add_stuck(std::vector<std::string>& layers, std::size_t i, const AxisRange& range) const {
    if (seen_.places[i].stuck.empty()) return;
    layers.push_back(
        fmt::format("$stuck{} using 1:({:.9g}):1:2:({:.9g}):({:.9g}) with boxxyerror "
                    "fillstyle solid border lc rgb '{}' lw 0.5 fc rgb '{}'",
                    i + 1, range.low, range.low, range.high, kStuckShade, kStuckShade));
  }

  // Marks shrink as they crowd.
  double mark_size(const SeenPlace& place) const {
    const double count = static_cast<double>(place.impacts.size());
    return std::clamp(0.55 * std::sqrt(40.0 / std::max(count, 1.0)), 0.18, 0.55);
  }

  void set_legend_at_head(std::vector<std::string>& layers) {
    if (legend_.empty()) return;
    column_.set_legend();
    layers.insert(layers.end(), legend_.begin(), legend_.end());
    if (places_left_out_ > 0)
      column_.remark(fmt::format("the first {} of {} places", seen_.places.size(),
                                 seen_.places.size() + places_left_out_));
  }

  void draw_displacement(std::size_t i) {
    const SeenPlace& place = seen_.places[i];
    const StopMarks& stops = stops_[i];
    AxisRange range = displacement_range(place.motion);
    if (record_.samples.empty()) range.include(0.0);
    stops.include(range);
    range.settle(0.1);
    stops.make_room(range);
    column_.begin_panel(range,
                        no_stops() ? "first mode q_1\n" : "displacement\n→ " + stop_name(place),
                        length_.unit);
    std::vector<std::string> layers;
    if (i == 0) set_legend_at_head(layers);
    add_stuck(layers, i, stops.between(range));
    stops.draw(script_, range, column_.label_line(), layers);
    if (record_.samples.empty())
      script_.command("set label 'no samples were recorded' at graph 0.5, graph 0.4 center");
    else
      layers.push_back(line(fmt::format("displacement{}", i + 1), kBlue));
    if (!place.impacts.empty())
      layers.push_back(fmt::format("$touches{} with points pt 7 ps mark*{:.2f} lc rgb '{}'", i + 1,
                                   mark_size(place), kVermillion));
    column_.end_panel(layers);
  }

  // Above the panel, unless what it shows begins with the run.
  void note_start(const char* what, double start) {
    if (start > 0.0)
      column_.note(fmt::format("{} {:.5g} {}", what, time_.factor * start, time_.unit));
  }

  void draw_velocity() {
    const AxisRange range = velocity_range(seen_.places[0].motion);
    column_.begin_panel(range, velocity_name(seen_.places[0]), speed_.unit);
    column_.draw_zero_line();
    std::vector<std::string> layers;
    add_stuck(layers, 0, range);
    if (!record_.samples.empty()) layers.push_back(line("velocity1", kBlue));
    const std::size_t jumps = seen_.places[0].impacts.size();
    if (jumps > 0 && jumps <= kMostJumps)
      layers.push_back(fmt::format("$jumps1 with lines lw 0.8 dt (6,4) lc rgb '{}'", kVermillion));
    column_.end_panel(layers);
  }

  void draw_forces() {
    AxisRange range{force_.factor * force_range_.low, force_.factor * force_range_.high};
    range.include(0.0);
    range.settle(0.08);
    range.low = std::min(range.low, 0.0);
    column_.begin_panel(range, "contact\nforce", force_.unit);
    column_.draw_zero_line();
    std::vector<std::string> layers;
    std::vector<CurveLabel> labels;
    for (const SeenForce& seen : seen_.forces) {
      const char* colour =
          curve_colours()[static_cast<std::size_t>(seen.stop) % curve_colours().size()];
      const std::string name = fmt::format("force{}", seen.stop + 1);
      script_.data(name, table_of(seen.force, time_.factor, force_.factor));
      layers.push_back(line(name, colour));
      if (several_stops())
        labels.push_back(
            {0.5 * (range.low + range.high), fmt::format("stop {}", seen.stop + 1), colour});
    }
    label_curves(script_, labels, range, column_.label_line());
    column_.end_panel(layers);
  }

  void draw_energy() {
    AxisRange range{energy_.factor * energy_range_.low, energy_.factor * energy_range_.high};
    range.include(0.0);
    range.settle(0.06);
    column_.begin_panel(range, seen_.energy.size() > 1 ? "energy,\nwork" : "energy", energy_.unit);
    column_.draw_zero_line();
    std::vector<std::string> layers;
    std::vector<CurveLabel> labels;
    for (const EnergyTerm& term : seen_.energy) {
      const std::string name = term.name;
      script_.data(name, table_of(term.curve, time_.factor, energy_.factor));
      // The first, the energy, shows from below a term that coincides with it.
      layers.push_back(line(name, term.colour.c_str(), layers.empty() ? 2.0 : 1.2));
      labels.push_back({energy_.factor * term.curve.back().value, name, term.colour});
    }
    if (seen_.energy.size() > 1) note_start("work since", seen_.window.start);
    label_curves(script_, labels, range, column_.label_line());
    column_.end_panel(layers);
  }

  void draw_portrait(std::size_t i, std::size_t count) {
    const SeenPlace& place = seen_.places[i];
    AxisRange x = displacement_range(portrayed(place));
    stops_[i].include(x);
    x.settle(0.06);
    column_.begin_in_row(i, count, x, velocity_range(portrayed(place)));
    const bool alone = count == 1;
    const std::string axis =
        no_stops() ? "first mode q_1"
                   : (alone ? "displacement " : "") + std::string("towards ") + stop_name(place);
    script_.command("set xlabel " + axis_label(axis, length_.unit));
    if (i == 0)
      column_.name_vertical(alone || no_stops() ? velocity_name(place) : "velocity\n→ stop",
                            speed_.unit);
    if (portrayed(place).size() < place.motion.size())
      note_start("since", portrayed(place).front().time);
    column_.draw_zero_line();
    stops_[i].draw_across(script_, x);
    std::vector<std::string> layers{line(fmt::format("portrait{}", i + 1), kBlue, 1.0)};
    if (!place.impacts.empty())
      layers.push_back(fmt::format("$approaches{} with points pt 7 ps mark*{:.2f} lc rgb '{}'",
                                   i + 1, mark_size(place), kVermillion));
    if (!place.stuck.empty())
      for (const auto& [type, colour] : {std::pair{7, kStuckShade}, {6, kBlack}})
        layers.push_back(fmt::format("$rest{} with points pt {} ps mark lw 0.5 lc rgb '{}'", i + 1,
                                     type, colour));
    column_.end_in_row(layers);
  }

  const PictureRequest& request_;
  const SimulationRecord& record_;
  MotionSeen seen_;
  ProbePanels probes_;
  std::size_t places_left_out_ = 0;
  std::vector<StopMarks> stops_;     // of every place
  std::vector<std::string> legend_;  // layers that draw nothing but their entry
  AxisUnit time_, length_, speed_, force_, energy_;
  AxisRange window_;                      // in the axis' unit
  AxisRange force_range_, energy_range_;  // SI
  GnuplotScript script_;
  PanelColumn column_{script_};
};

}  // namespace

void draw_simulation(const PictureRequest& request, const SimulationRecord& record) {
  SimulationPicture picture(request, record);
  const GnuplotScript script = picture.script();
  draw_picture(request, record.info, script, picture.canvas());
}

}  // namespace graze
