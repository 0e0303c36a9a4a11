#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "graze/base/angle.hpp"
#include "graze/orbit/detail/orbit_curve.hpp"
#include "graze/record/records.hpp"
#include "graze/report/picture/detail/picture_column.hpp"
#include "graze/report/picture/picture_style.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostOrbits = 8;
constexpr int kSamplesPerPeriod = 400;
constexpr double kSmallJump = 0.15;  // of the velocity axis: too short for a head
constexpr std::array kColours = {kBlue, kVermillion, kGreen, kBlack, kOrange, kSky, kPurple, kGrey};

using Flights = std::vector<std::vector<CurveSample>>;

std::string stability(const Orbit& orbit) {
  if (!orbit.admissible) return "virtual";
  const std::string sticks = orbit.sticks() ? "sticks, " : "";
  if (!orbit.stable) return sticks + "stability open";
  return sticks + (*orbit.stable ? "stable" : "unstable");
}

std::string dashes(const Orbit& orbit) {
  if (!orbit.admissible) return "dt (2,4)";
  return orbit.stable.value_or(false) ? "dt solid" : "dt (8,4)";
}

// "(1,1) stable, v = 0.1353 m/s", with several impacts "(2,3) stable, v ≤ 0.1353 m/s"
std::string legend(const Orbit& orbit) {
  double fastest = orbit.impacts.front().speed;
  for (const OrbitImpact& impact : orbit.impacts) fastest = std::max(fastest, impact.speed);
  return fmt::format("({},{}) {}, v {} {}{:.4g} m/s", orbit.period, orbit.impacts.size(),
                     stability(orbit), orbit.impacts.size() == 1 ? "=" : "≤",
                     fastest < 0.0 ? "−" : "", std::abs(fastest));
}

class OrbitsPicture {
 public:
  explicit OrbitsPicture(const OrbitRecord& record) : record_(record) {
    for (const Orbit& orbit : record.found.orbits)
      if (!orbit.impacts.empty()) orbits_.push_back(&orbit);
    left_out_ = orbits_.size() - std::min(orbits_.size(), kMostOrbits);
    orbits_.resize(orbits_.size() - left_out_);
    if (!orbits_.empty()) stop_ = orbits_.front()->impacts.front().stop;
    AxisRange displacement, velocity;
    for (const Orbit* orbit : orbits_) {
      flights_.push_back(orbit_curve(record.system, *orbit,
                                     record.system.stops[static_cast<std::size_t>(stop_)].row,
                                     kSamplesPerPeriod));
      for (const auto& flight : flights_.back())
        for (const CurveSample& sample : flight) {
          displacement.include(sample.displacement);
          velocity.include(sample.velocity);
        }
    }
    const auto size = [](const AxisRange& range) {
      return range.empty() ? 0.0 : std::max(std::abs(range.low), std::abs(range.high));
    };
    if (orbits_.empty()) displacement.include(0.0), velocity = {-1.0, 1.0};
    if (has_stop()) displacement.include(record.system.stops[static_cast<std::size_t>(stop_)].gap);
    length_ = axis_unit("m", size(displacement));
    speed_ = axis_unit("m/s", size(velocity));
    x_ = {length_.factor * displacement.low, length_.factor * displacement.high};
    y_ = {speed_.factor * velocity.low, speed_.factor * velocity.high};
    x_.settle(0.06);
    y_.settle(0.08);
  }

  // Height over width.
  double proportion() const { return sticks() ? column_.proportion() : 0.75; }

  GnuplotScript script() {
    set_style(script_);
    for (std::size_t i = 0; i < orbits_.size(); ++i) write_data(i);
    if (sticks()) {
      column_.lay_out({PanelColumn::kPanel}, true, true, false);
      script_.command("set multiplot");
      draw_over_time();
      column_.begin_in_row(0, 1, x_, y_);
      script_.command("set format x '%h'");
      draw_stop();
      script_.command("set xlabel " + axis_label("displacement towards " + which(), length_.unit));
      column_.name_vertical("velocity\ntowards " + which(), speed_.unit);
      column_.end_in_row(layers());
      script_.command("unset multiplot");
      return script_;
    }
    draw_stop();
    Margins margins;
    margins.bottom += legend_height(orbits_.size(), 1);
    if (left_out_ > 0) margins.top += 0.04;
    set_margins(script_, margins);
    set_legend(script_, margins, 1);
    script_.command("set xrange " + x_.text());
    script_.command(fmt::format("set xtics {:.6g}", x_.tic_step(6)));
    script_.command("set yrange " + y_.text());
    script_.command(fmt::format("set ytics {:.6g}", y_.tic_step(8)));
    script_.command("set xlabel " + axis_label("displacement towards " + which(), length_.unit));
    name_vertical_axis(script_, "velocity towards " + which(), speed_.unit);
    if (orbits_.empty())
      script_.command("set label 'no orbit was found' at graph 0.45, graph 0.6 center");
    if (left_out_ > 0)
      script_.command(fmt::format("set label 'the first {} of {} orbits' at graph 0, graph 1.05",
                                  orbits_.size(), orbits_.size() + left_out_));
    script_.plot(layers());
    return script_;
  }

 private:
  bool has_stop() const { return !record_.system.stops.empty(); }
  bool sticks() const {
    return std::any_of(orbits_.begin(), orbits_.end(),
                       [](const Orbit* orbit) { return orbit->sticks(); });
  }
  std::string which() const {
    return record_.system.stops.size() > 1 ? fmt::format("stop {}", stop_ + 1) : "stop";
  }

  // The displacement of the orbits that stick over their periods, their stuck phases shaded.
  void draw_over_time() {
    const double frequency = record_.system.forcing()->frequency;
    int periods = 1;
    for (const Orbit* orbit : orbits_)
      if (orbit->sticks()) periods = std::max(periods, orbit->period);
    const AxisUnit time = axis_unit("s", kTurn * periods / frequency);
    const double unit = time.factor / frequency;  // of phase
    const AxisRange axis{0.0, unit * kTurn * periods};
    column_.set_time_axis(axis, time.unit);
    column_.begin_panel(x_, "displacement\ntowards " + which(), length_.unit);
    script_.command(
        fmt::format("set object rectangle from graph 0, first {:.9g} to graph 1, graph 1 behind "
                    "fillcolor rgb '{}' fillstyle solid noborder",
                    stop_place(), kStopShade));
    column_.set_legend();
    if (left_out_ > 0)
      column_.remark(fmt::format("{} of {}", orbits_.size(), orbits_.size() + left_out_));
    std::vector<std::string> shades, curves, names;
    for (std::size_t i = 0; i < orbits_.size(); ++i) {
      const Orbit& orbit = *orbits_[i];
      names.push_back(fmt::format("NaN with lines lw 1.6 {} lc rgb '{}' title '({},{}) {}'",
                                  dashes(orbit), kColours[i], orbit.period, orbit.impacts.size(),
                                  stability(orbit)));
      if (!orbit.sticks()) continue;
      write_over_time(i, unit);
      shades.push_back(
          fmt::format("$stuck{} using 1:({:.9g}):1:2:({:.9g}):({:.9g}) with boxxyerror fillstyle "
                      "solid border lc rgb '{}' lw 0.5 fc rgb '{}'",
                      i + 1, x_.low, x_.low, stop_place(), kStuckShade, kStuckShade));
      curves.push_back(fmt::format("$course{} with lines lw 1.6 {} lc rgb '{}'", i + 1,
                                   dashes(orbit), kColours[i]));
    }
    shades.insert(shades.end(), curves.begin(), curves.end());
    shades.insert(shades.end(), names.begin(), names.end());
    shades.push_back(fmt::format(
        "NaN with boxes fillstyle solid noborder fc rgb '{}' title 'stuck'", kStuckShade));
    column_.end_panel(shades);
  }

  // Both cut at the end of the orbit's last period and begun anew at its start.
  void write_over_time(std::size_t i, double unit) {
    const Orbit& orbit = *orbits_[i];
    const double whole = kTurn * orbit.period;
    PlotTable course, stuck;
    for (const double shift : {whole, 0.0}) {
      for (const auto& flight : flights_[i])
        for (const CurveSample& sample : flight) {
          const double theta = sample.theta - shift;
          if (theta >= 0.0 && theta <= whole)
            course.row({unit * theta, length_.factor * sample.displacement});
        }
      course.gap();
      for (const StickingPhase& sticking : orbit.sticking) {
        const double from = sticking.from.phase + kTurn * sticking.from.period_index - shift;
        const double to = from + sticking.duration * record_.system.forcing()->frequency;
        if (to > 0.0 && from < whole)
          stuck.row({unit * std::max(from, 0.0), unit * std::min(to, whole)});
      }
    }
    script_.data(fmt::format("course{}", i + 1), course);
    script_.data(fmt::format("stuck{}", i + 1), stuck);
  }

  double stop_place() const {
    return length_.factor * record_.system.stops[static_cast<std::size_t>(stop_)].gap;
  }

  void write_data(std::size_t i) {
    PlotTable curve, jumps, short_jumps;
    const Flights& flights = flights_[i];
    for (std::size_t k = 0; k < flights.size(); ++k) {
      for (const CurveSample& sample : flights[k])
        curve.row({length_.factor * sample.displacement, speed_.factor * sample.velocity});
      curve.gap();
      // The flight that ends here is followed, across an impact, by the next.
      const CurveSample& before = flights[k].back();
      const CurveSample& after = flights[(k + 1) % flights.size()].front();
      const double jump = speed_.factor * (after.velocity - before.velocity);
      const bool hop = orbits_[i]->sticks() && std::abs(jump) < kSmallJump * y_.span();
      (hop ? short_jumps : jumps)
          .row({length_.factor * before.displacement, speed_.factor * before.velocity, 0.0, jump});
    }
    script_.data(fmt::format("hops{}", i + 1), short_jumps);
    script_.data(fmt::format("orbit{}", i + 1), curve);
    script_.data(fmt::format("jumps{}", i + 1), jumps);
  }

  void draw_stop() {
    if (!has_stop()) return;
    script_.command(
        fmt::format("set object rectangle from first {:.9g}, graph 0 to graph 1, graph 1 behind "
                    "fillcolor rgb '{}' fillstyle solid noborder",
                    stop_place(), kStopShade));
    script_.command(
        fmt::format("set arrow from first {:.9g}, graph 0 to first {:.9g}, graph 1 "
                    "nohead back lw 0.8 lc rgb '{}'",
                    stop_place(), stop_place(), kGrey));
    script_.command(
        fmt::format("set arrow from graph 0, first 0 to graph 1, first 0 nohead back "
                    "lw 0.5 lc rgb '{}'",
                    kGrey));
  }

  std::vector<std::string> layers() const {
    std::vector<std::string> layers;
    for (std::size_t i = 0; i < orbits_.size(); ++i) {
      layers.push_back(fmt::format("$orbit{} with lines lw 1.6 {} lc rgb '{}' title {}", i + 1,
                                   dashes(*orbits_[i]), kColours[i],
                                   gnuplot_string(legend(*orbits_[i]))));
      // The head stands alone, because dashes would tear it.
      layers.push_back(fmt::format("$jumps{} with vectors nohead lw 1.6 dt (3,5) lc rgb '{}'",
                                   i + 1, kColours[i]));
      if (orbits_[i]->sticks())
        layers.push_back(fmt::format("$hops{} with vectors nohead lw 1.6 dt (3,5) lc rgb '{}'",
                                     i + 1, kColours[i]));
      layers.push_back(
          fmt::format("$jumps{} using 1:($2+0.99*$4):3:(0.01*$4) with vectors head "
                      "filled size screen 0.02,20 fixed lw 1 lc rgb '{}'",
                      i + 1, kColours[i]));
    }
    return layers;
  }

  const OrbitRecord& record_;
  std::vector<const Orbit*> orbits_;
  std::vector<Flights> flights_;
  std::size_t left_out_ = 0;
  int stop_ = 0;
  AxisUnit length_, speed_;
  AxisRange x_, y_;
  GnuplotScript script_;
  PanelColumn column_{script_};
};

}  // namespace

void draw_orbits(const PictureRequest& request, const OrbitRecord& record) {
  OrbitsPicture picture(record);
  const GnuplotScript script = picture.script();
  draw_picture(request, record.info, script, picture.proportion());
}

}  // namespace graze
