#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "graze/report/picture_style.hpp"
#include "graze/report/pictures.hpp"

namespace graze {
namespace {

// Past this many points a curve is drawn as the band between its extremes, one pair of them to
// every hair's breadth of the picture.
constexpr std::size_t kMostPoints = 12'000;
constexpr std::size_t kBands = 3'000;
constexpr std::size_t kMostMarks = 3'000;
constexpr std::size_t kMostJumps = 200;  // beyond, their lines fill the panel

struct CurvePoint {
  double time = 0.0;
  double value = 0.0;  // NaN: the curve breaks
};
using Curve = std::vector<CurvePoint>;

// A stop that the first stop's row sees: at `place` on the axis, approached towards `sense`.
struct SeenStop {
  int index = 0;
  double sense = 1.0;  // +1, or -1 for a stop on the other side
  double place = 0.0;  // m
};

struct SeenImpact {
  double time = 0.0, place = 0.0;    // s, m
  double before = 0.0, after = 0.0;  // velocity, m/s
};

// What the record shows along the row of its first stop, or along the first mode without stops.
struct MotionSeen {
  Vector row;
  std::vector<SeenStop> stops;
  std::vector<SeenImpact> impacts;
  Curve displacement, velocity;  // with the impacts themselves, between which samples may miss them
  double start = 0.0, end = 1.0;  // of the window, s
};

std::vector<SeenStop> stops_along(const System& system, const Vector& row) {
  std::vector<SeenStop> seen;
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const RigidStop& stop = system.stops[i];
    for (const double sense : {1.0, -1.0})
      if ((stop.row - sense * row).norm() <= 1e-9 * row.norm())
        seen.push_back({static_cast<int>(i), sense, sense * stop.gap});
  }
  return seen;
}

void set_window(const SimulationRecord& record, MotionSeen& seen) {
  if (record.samples.empty()) {
    seen.end = record.run.end_time;
    return;
  }
  seen.start = record.samples.front().time;
  seen.end = record.samples.back().time;
  // Samples stop short of an end between two of them, where the last impacts may be.
  const double spacing = (seen.end - seen.start) /
                         static_cast<double>(std::max<std::size_t>(record.samples.size(), 2) - 1);
  if (record.run.end_time - seen.end <= 1.5 * spacing)
    seen.end = std::max(seen.end, record.run.end_time);
}

void gather_impacts(const SimulationRecord& record, MotionSeen& seen) {
  for (const Event& event : record.events) {
    if (event.kind != EventKind::kImpact || event.time < seen.start || event.time > seen.end)
      continue;
    for (const SeenStop& stop : seen.stops) {
      if (stop.index != event.stop) continue;
      const double restitution =
          record.system.stops[static_cast<std::size_t>(event.stop)].restitution;
      const double before = stop.sense * event.speed;
      seen.impacts.push_back({event.time, stop.place, before, -restitution * before});
    }
  }
}

void gather_curves(const SimulationRecord& record, MotionSeen& seen) {
  auto next = seen.impacts.begin();
  const auto add_impacts_until = [&](double time) {
    for (; next != seen.impacts.end() && next->time <= time; ++next) {
      seen.displacement.push_back({next->time, next->place});
      seen.velocity.push_back({next->time, next->before});
      seen.velocity.push_back({next->time, std::nan("")});
      seen.velocity.push_back({next->time, next->after});
    }
  };
  for (const Sample& sample : record.samples) {
    add_impacts_until(sample.time);
    // A sample at the very time of an impact may stand on either side of the jump.
    if (!seen.velocity.empty() && next != seen.impacts.begin() &&
        std::prev(next)->time == sample.time)
      continue;
    seen.displacement.push_back({sample.time, seen.row.dot(sample.state.q)});
    seen.velocity.push_back({sample.time, seen.row.dot(sample.state.qdot)});
  }
  add_impacts_until(seen.end);
}

MotionSeen see(const SimulationRecord& record) {
  MotionSeen seen;
  const System& system = record.system;
  seen.row = system.stops.empty() ? Vector(Vector::Unit(system.modes(), 0)) : system.stops[0].row;
  seen.stops = stops_along(system, seen.row);
  set_window(record, seen);
  gather_impacts(record, seen);
  gather_curves(record, seen);
  return seen;
}

PlotTable table_of(const Curve& curve, double time_factor, double factor) {
  PlotTable table;
  const auto add = [&](const CurvePoint& p) {
    table.row({time_factor * p.time, factor * p.value});
  };
  if (curve.size() <= kMostPoints) {
    for (const CurvePoint& point : curve) add(point);
    return table;
  }
  for (std::size_t band = 0; band < kBands; ++band) {
    const auto first = curve.begin() + static_cast<std::ptrdiff_t>(band * curve.size() / kBands);
    const auto last =
        curve.begin() + static_cast<std::ptrdiff_t>((band + 1) * curve.size() / kBands);
    std::optional<CurvePoint> lowest, highest;
    for (auto point = first; point != last; ++point) {
      if (!std::isfinite(point->value)) continue;
      if (!lowest || point->value < lowest->value) lowest = *point;
      if (!highest || point->value > highest->value) highest = *point;
    }
    if (!lowest) continue;
    add(lowest->time <= highest->time ? *lowest : *highest);
    add(lowest->time <= highest->time ? *highest : *lowest);
  }
  return table;
}

AxisRange range_of(const Curve& curve) {
  AxisRange range;
  for (const CurvePoint& point : curve) range.include(point.value);
  return range;
}

double largest(const AxisRange& range) {
  return range.empty() ? 0.0 : std::max(std::abs(range.low), std::abs(range.high));
}

// The stop as a line with the space behind it shaded; a stop far off the motion is only named.
class StopMarks {
 public:
  StopMarks(const MotionSeen& seen, const AxisRange& motion, const AxisUnit& unit) : unit_(unit) {
    const double reach =
        4.0 * std::max(motion.empty() ? 0.0 : motion.span(), 0.25 * largest(motion));
    for (const SeenStop& stop : seen.stops) {
      const bool near =
          motion.empty() || (stop.place >= motion.low - reach && stop.place <= motion.high + reach);
      (near ? near_ : far_).push_back(stop);
    }
  }

  void include(AxisRange& range) const {
    for (const SeenStop& stop : near_) range.include(unit_.factor * stop.place);
  }

  // Into the panel's axes, whose range is settled.
  void draw(GnuplotScript& script, const AxisRange& range) const {
    for (const SeenStop& stop : near_) {
      const double at = unit_.factor * stop.place;
      const double edge = stop.sense > 0.0 ? range.high : range.low;
      script.command(fmt::format(
          "set object rectangle from graph 0, first {:.9g} to graph 1, first {:.9g} behind "
          "fillcolor rgb '{}' fillstyle solid noborder",
          at, edge, kStopShade));
      script.command(
          fmt::format("set arrow from graph 0, first {:.9g} to graph 1, first {:.9g} "
                      "nohead lw 2 lc rgb '{}'",
                      at, at, kBlack));
    }
  }

  // Their entries in the legend.
  void list(std::vector<std::string>& layers) const {
    if (!near_.empty())
      layers.push_back(fmt::format("NaN with lines lw 2 lc rgb '{}' title 'stop'", kBlack));
    for (const SeenStop& stop : far_)
      layers.push_back(fmt::format("NaN with dots lc rgb '#FFFFFF' title 'stop at {}{:.4g} {}'",
                                   stop.place < 0.0 ? "−" : "", unit_.factor * std::abs(stop.place),
                                   unit_.unit));
  }

 private:
  AxisUnit unit_;
  std::vector<SeenStop> near_, far_;
};

class SimulationPicture {
 public:
  explicit SimulationPicture(const SimulationRecord& record) : record_(record), seen_(see(record)) {
    time_ = axis_unit("s", std::max(std::abs(seen_.start), std::abs(seen_.end)));
    const AxisRange displacement = range_of(seen_.displacement);
    const AxisRange velocity = range_of(seen_.velocity);
    // Without a stop the picture shows a modal coordinate, which is no length.
    if (!seen_.stops.empty()) {
      length_ = axis_unit("m", largest(displacement));
      speed_ = axis_unit("m/s", largest(velocity));
    } else {
      length_ = axis_unit("kg^1/2 m", largest(displacement));
      speed_ = axis_unit("kg^1/2 m/s", largest(velocity));
    }
    if (record.samples.empty()) displacement_.include(0.0);
    displacement_.include(length_.factor * displacement.low);
    displacement_.include(length_.factor * displacement.high);
    velocity_.include(speed_.factor * velocity.low);
    velocity_.include(speed_.factor * velocity.high);
    velocity_.settle(0.08);
    window_ = {time_.factor * seen_.start, time_.factor * seen_.end};
    if (!(window_.span() > 0.0)) window_.high = window_.low + 1.0;
  }

  GnuplotScript script() {
    set_style(script_);
    write_data();
    script_.command("set multiplot");
    script_.command("set xrange " + window_.text());
    script_.command(fmt::format("set xtics {:.6g}", window_.tic_step(7)));
    draw_displacement();
    draw_velocity();
    script_.command("unset multiplot");
    return script_;
  }

 private:
  bool no_stops() const { return record_.system.stops.empty(); }

  std::string towards_stop() const {
    return record_.system.stops.size() > 1 ? "towards stop 1" : "towards stop";
  }

  void write_data() {
    script_.data("displacement", table_of(seen_.displacement, time_.factor, length_.factor));
    script_.data("velocity", table_of(seen_.velocity, time_.factor, speed_.factor));
    PlotTable touches, jumps;
    const std::size_t stride = seen_.impacts.size() / kMostMarks + 1;
    for (std::size_t i = 0; i < seen_.impacts.size(); i += stride) {
      const SeenImpact& impact = seen_.impacts[i];
      const double time = time_.factor * impact.time;
      touches.row({time, length_.factor * impact.place});
      jumps.row({time, speed_.factor * impact.before});
      jumps.row({time, speed_.factor * impact.after});
      jumps.gap();
    }
    script_.data("touches", touches);
    script_.data("jumps", jumps);
  }

  // Marks shrink as they crowd.
  double mark_size() const {
    const double count = static_cast<double>(seen_.impacts.size());
    return std::clamp(0.55 * std::sqrt(40.0 / std::max(count, 1.0)), 0.18, 0.55);
  }

  void draw_displacement() {
    const AxisRange motion = range_of(seen_.displacement);
    const StopMarks stops(seen_, motion, length_);
    stops.include(displacement_);
    displacement_.settle(0.1);
    stops.draw(script_, displacement_);
    set_panel(0.55, 0.08, displacement_);
    name_vertical_axis(script_,
                       no_stops() ? "first mode q_1\\n" : "displacement\\n" + towards_stop(),
                       length_.unit);
    script_.command("set format x ''");
    script_.command(
        "set key at screen 0.965, screen 0.96 right center horizontal Left reverse "
        "samplen 1.5 font ',9'");
    std::vector<std::string> layers;
    if (record_.samples.empty())
      script_.command("set label 'no samples were recorded' at graph 0.5, graph 0.4 center");
    else
      layers.push_back(fmt::format("$displacement with lines lw 1.2 lc rgb '{}'", kBlue));
    if (!seen_.impacts.empty())
      layers.push_back(
          fmt::format("$touches with points pt 7 ps {:.2f} lc rgb '{}'", mark_size(), kVermillion));
    stops.list(layers);
    if (!seen_.impacts.empty())
      layers.push_back(
          fmt::format("NaN with points pt 7 ps 0.55 lc rgb '{}' title 'impact'", kVermillion));
    mark_rest(layers);
    script_.plot(layers);
    script_.command("unset object\nunset arrow\nunset label\nunset key");
  }

  void mark_rest(std::vector<std::string>& layers) const {
    if (!record_.run.resting_stop) return;
    for (const SeenStop& stop : seen_.stops) {
      if (stop.index != *record_.run.resting_stop || record_.run.end_time > seen_.end) continue;
      const double time = time_.factor * record_.run.end_time;
      const double at = length_.factor * stop.place;
      layers.push_back(
          fmt::format("'+' using ({:.9g}):({:.9g}) every ::0::0 with points pt 5 "
                      "ps 0.6 lc rgb '{}' title 'at rest'",
                      time, at, kBlack));
    }
  }

  void draw_velocity() {
    set_panel(0.15, 0.49, velocity_);
    script_.command("set format x '%h'");
    script_.command("set xlabel " + axis_label("time", time_.unit));
    name_vertical_axis(script_, no_stops() ? "rate of q_1\\n" : "velocity", speed_.unit);
    script_.command(
        fmt::format("set arrow from graph 0, first 0 to graph 1, first 0 nohead back "
                    "lw 0.5 lc rgb '{}'",
                    kGrey));
    std::vector<std::string> layers;
    if (!record_.samples.empty())
      layers.push_back(fmt::format("$velocity with lines lw 1.2 lc rgb '{}'", kBlue));
    if (!seen_.impacts.empty() && seen_.impacts.size() <= kMostJumps)
      layers.push_back(fmt::format("$jumps with lines lw 0.8 dt (6,4) lc rgb '{}'", kVermillion));
    script_.plot(layers);
  }

  void set_panel(double bottom, double top, const AxisRange& range) {
    set_margins(script_, {.left = 0.2, .bottom = bottom, .top = top});
    script_.command("set yrange " + range.text());
    script_.command(fmt::format("set ytics {:.6g}", range.tic_step(6)));
  }

  const SimulationRecord& record_;
  MotionSeen seen_;
  AxisUnit time_, length_, speed_;
  AxisRange displacement_, velocity_;
  AxisRange window_;
  GnuplotScript script_;
};

}  // namespace

void draw_simulation(const std::string& file, const SimulationRecord& record) {
  draw_picture(file, SimulationPicture(record).script());
}

}  // namespace graze
