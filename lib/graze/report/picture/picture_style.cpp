#include "graze/report/picture/detail/picture_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

// gnuplot raises one character only, unless braces hold more.
std::string unit_markup(std::string unit) {
  if (const std::size_t root = unit.find("^1/2"); root != std::string::npos)
    unit.replace(root, 4, "^{1/2}");
  return unit;
}

}  // namespace

std::string axis_label(const std::string& name, const std::string& unit) {
  return gnuplot_string(unit.empty() ? name : name + " (" + unit_markup(unit) + ")");
}

void set_style(GnuplotScript& script) {
  script.command("set minussign\nset format '%h'");
  script.command("set border 3 lw 0.7 lc rgb '#808080'");
  script.command("set tics out nomirror scale 0.6 font small textcolor rgb '#000000'");
  script.command("set key noautotitle noopaque");
}

void set_margins(GnuplotScript& script, const Margins& margins) {
  script.command(fmt::format("set lmargin at screen {:.4g}*across", margins.left));
  script.command(fmt::format("set rmargin at screen 1-{:.4g}*across", margins.right));
  script.command(fmt::format("set bmargin at screen {:.4g}*upward*body", margins.bottom));
  script.command(fmt::format("set tmargin at screen (1-{:.4g}*upward)*body", margins.top));
}

void name_vertical_axis(GnuplotScript& script, const std::string& name, const std::string& unit,
                        double place) {
  // Lines far enough apart for a subscript above an exponent, unlike gnuplot's own.
  constexpr double kLine = 0.039;
  const std::string text = unit.empty() ? name : name + " (" + unit_markup(unit) + ")";
  for (std::size_t start = 0; start < text.size(); place += kLine) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    script.command(fmt::format("set label {} at screen {:.4g}*across, graph 0.5 center rotate",
                               gnuplot_string(text.substr(start, end - start)), place));
    start = end + 1;
  }
}

std::string in_two_lines(std::string name, std::size_t most) {
  if (name.size() <= most || name.find('\n') != std::string::npos) return name;
  if (const std::size_t way = name.find(" towards "); way != std::string::npos) {
    name[way] = '\n';
    return name;
  }
  const std::size_t middle = name.size() / 2;
  const std::size_t before = name.rfind(' ', middle), after = name.find(' ', middle);
  const std::size_t none = std::string::npos;
  if (before == none && after == none) return name;
  const bool is_before = after == none || (before != none && middle - before <= after - middle);
  name[is_before ? before : after] = '\n';
  return name;
}

int tics_within(double length, int most) {
  constexpr double kTic = 0.55;  // cm, height of a number with its spacing
  return std::clamp(static_cast<int>(length / kTic), 2, most);
}

namespace {

bool has_power_tics(const AxisRange& range) { return range.high / range.low >= 100.0; }

// Tics of a logarithmic axis: labelled powers of ten if there are several, else 1, 2 and 5 times
// them.
std::string log_tics(const AxisRange& range, const std::string& axis) {
  if (has_power_tics(range))
    return fmt::format("set logscale {0}\nset {0}tics auto\nset format {0} '10^{{%L}}'", axis);
  std::string tics;
  for (double power = std::pow(10.0, std::floor(std::log10(range.low))); power <= range.high;
       power *= 10.0)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * power >= range.low && step * power <= range.high)
        tics += fmt::format("{}{:.6g}", tics.empty() ? "" : ", ", step * power);
  return fmt::format("set logscale {0}\nset format {0} '%h'\nset {0}tics ({1})", axis, tics);
}

}  // namespace

void set_parameter_axis(GnuplotScript& script, const std::string& parameter, const AxisRange& range,
                        const std::string& unit, AxisNames names, bool is_log) {
  script.command("set xrange " + range.text());
  script.command(is_log ? log_tics(range, "x")
                        : fmt::format("set xtics {:.6g}\nset format x '%h'", range.tic_step(7)));
  if (!names.below) script.command("set format x ''");
  script.command(names.below ? "set xlabel " + axis_label(parameter_title(parameter), unit)
                             : "unset xlabel");
  if (!has_hertz_axis(parameter, unit)) return;
  script.command(names.above ? "set border 7" : "set border 3\nunset x2tics\nunset x2label");
  if (!names.above) return;
  const AxisRange hertz{range.low / kTurn, range.high / kTurn};
  script.command("set x2range " + hertz.text());
  script.command(is_log ? log_tics(hertz, "x2")
                        : fmt::format("set x2tics {:.6g}", hertz.tic_step(9)));
  script.command("set x2label 'forcing frequency (Hz)'");
}

ShownAxis::ShownAxis(const AxisRequest& request, const std::string& si_unit,
                     const std::vector<double>& values, double margin, bool from_zero)
    : scale_(request.scale) {
  // Six decades are enough for comparison by eye; smaller values are drawn at the low end.
  constexpr double kSmallest = 1e-6;
  AxisRange shown;
  for (const double value : values) {
    const double size = scale_ == AxisScale::kDecibel ? std::abs(value) : value;
    if (scale_ == AxisScale::kLinear || size > 0.0) shown.include(size);
  }
  if (scale_ == AxisScale::kLinear && (from_zero || shown.empty())) shown.include(0.0);
  if (request.low) shown.low = *request.low;
  if (request.high) shown.high = *request.high;
  if (scale_ == AxisScale::kLinear) {
    unit_ = axis_unit(si_unit, std::max(std::abs(shown.low), std::abs(shown.high)));
    range_ = {unit_.factor * shown.low, unit_.factor * shown.high};
    range_.settle(margin);
    if (request.low) range_.low = unit_.factor * *request.low;
    if (request.high) range_.high = unit_.factor * *request.high;
    return;
  }
  if (!(shown.high > 0.0)) shown.high = 1.0;
  if (!request.low) shown.low = std::max(shown.low, kSmallest * shown.high);
  if (!(shown.low > 0.0 && shown.low < shown.high)) shown.low = 0.1 * shown.high;
  // Smaller values are drawn at the bottom, with space for their mark.
  least_ = request.low ? 0.0 : shown.low;
  const double room = std::pow(shown.high / shown.low, margin);
  if (!request.low) shown.low /= room;
  if (!request.high) shown.high *= room;
  if (scale_ == AxisScale::kLog) {
    // With tics that are powers of ten the unit has none.
    unit_ = has_power_tics({shown.low, shown.high}) ? AxisUnit{1.0, si_unit}
                                                    : axis_unit(si_unit, shown.high);
    range_ = {unit_.factor * shown.low, unit_.factor * shown.high};
    return;
  }
  unit_ = {1.0, si_unit.empty() ? "dB" : "dB re 1 " + si_unit};
  range_ = {20.0 * std::log10(shown.low), 20.0 * std::log10(shown.high)};
}

double ShownAxis::of(double value) const {
  if (scale_ == AxisScale::kLinear) return unit_.factor * value;
  const double size = scale_ == AxisScale::kDecibel ? std::abs(value) : value;
  if (std::isnan(size)) return size;
  if (!(size > 0.0) && !(least_ > 0.0)) return range_.low;
  const double shown = std::max(size, least_);
  return scale_ == AxisScale::kDecibel ? 20.0 * std::log10(shown) : unit_.factor * shown;
}

void ShownAxis::set_horizontal(GnuplotScript& script, int most_tics) const {
  script.command("set xrange " + range_.text());
  script.command(is_log() ? log_tics(range_, "x")
                          : fmt::format("unset logscale x\nset format x '%h'\nset xtics {:.6g}",
                                        range_.tic_step(most_tics)));
}

void ShownAxis::set_vertical(GnuplotScript& script, int most_tics) const {
  script.command("set yrange " + range_.text());
  script.command(is_log() ? log_tics(range_, "y")
                          : fmt::format("unset logscale y\nset format y '%h'\nset ytics {:.6g}",
                                        range_.tic_step(most_tics)));
}

}  // namespace graze
