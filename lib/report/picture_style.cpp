#include "graze/report/picture_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace graze {

AxisUnit axis_unit(const std::string& si_unit, double largest) {
  if (!(largest > 0.0)) return {1.0, si_unit};
  if (si_unit == "m") {
    if (largest < 1e-4) return {1e6, "µm"};
    if (largest < 0.1) return {1e3, "mm"};
  }
  if (si_unit == "m/s" && largest < 0.01) return {1e3, "mm/s"};
  if (si_unit == "s") {
    if (largest < 1e-3) return {1e6, "µs"};
    if (largest < 0.5) return {1e3, "ms"};
  }
  return {1.0, si_unit};
}

std::string axis_label(const std::string& name, const std::string& unit) {
  std::string shown = unit;
  if (const std::size_t root = shown.find("^1/2"); root != std::string::npos)
    shown.replace(root, 4, "^{1/2}");
  return gnuplot_string(shown.empty() ? name : name + " (" + shown + ")");
}

void AxisRange::include(double value) {
  // A run that left double precision must not take the axis with it.
  if (!(std::abs(value) < 1e300)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void AxisRange::settle(double margin) {
  if (empty()) low = 0.0, high = 1.0;
  // Below this the tics of a double axis can no longer be told apart.
  const double size = std::max(std::abs(low), std::abs(high));
  const double least = size > 0.0 ? 1e-9 * size : 1.0;
  if (span() < least) {
    const double more = size > 0.0 ? 0.05 * size : 1.0;
    low -= more;
    high += more;
  }
  const double more = margin * span();
  low -= more;
  high += more;
}

std::string AxisRange::text() const { return fmt::format("[{:.12g}:{:.12g}]", low, high); }

double AxisRange::tic_step(int most) const {
  double step = std::pow(10.0, std::floor(std::log10(span() / most)));
  for (const double more : {2.0, 2.5, 2.0})
    if (span() / step > most) step *= more;
  return step;
}

void set_style(GnuplotScript& script) {
  script.command("set minussign\nset format '%h'");
  script.command("set border 3 lw 0.7 lc rgb '#808080'");
  script.command("set tics out nomirror scale 0.6 textcolor rgb '#000000'");
  script.command("set key noautotitle noopaque");
}

void set_margins(GnuplotScript& script, const Margins& margins) {
  script.command(fmt::format("set lmargin at screen {:.4g}", margins.left));
  script.command(fmt::format("set rmargin at screen {:.4g}", 1.0 - margins.right));
  script.command(fmt::format("set bmargin at screen {:.4g}", margins.bottom));
  script.command(fmt::format("set tmargin at screen {:.4g}", 1.0 - margins.top));
}

void name_vertical_axis(GnuplotScript& script, const std::string& name, const std::string& unit) {
  // A line break takes gnuplot's double quotes.
  script.command(fmt::format("set label \"{} ({})\" at screen 0.03, graph 0.5 center rotate", name,
                             unit));
}

double legend_height(std::size_t entries, std::size_t columns) {
  return 0.047 * static_cast<double>((entries + columns - 1) / columns);
}

void set_legend(GnuplotScript& script, const Margins& margins, std::size_t columns) {
  script.command(fmt::format("set key at screen {:.4g}, screen 0.01 center bottom horizontal "
                             "maxcols {} Left reverse samplen 2 font ',9'",
                             0.5 * (1.0 + margins.left - margins.right), columns));
}

std::string parameter_title(const std::string& path) {
  static const std::map<std::string, std::string> kTitles = {
      {"forcing.frequency", "forcing frequency Ω"},
      {"forcing.amplitude", "forcing amplitude"},
      {"forcing.phase", "forcing phase"},
      {"damping.viscous", "viscous damping η"},
      {"beam.length", "beam length"},
      {"beam.density", "density"},
      {"beam.area", "area of the cross-section"},
      {"beam.youngs_modulus", "Young’s modulus"},
      {"beam.second_moment", "second moment of area"},
      {"gap", "gap"},
      {"position", "position of the stop"},
      {"restitution", "coefficient of restitution"},
  };
  const auto known = kTitles.find(path);
  if (known != kTitles.end()) return known->second;
  if (path.starts_with("stop.")) {
    std::string key = path.substr(5), which;
    if (const std::size_t dot = key.find('.'); dot != std::string::npos) {
      which = ", stop " + key.substr(0, dot);
      key = key.substr(dot + 1);
    }
    const auto of_stop = kTitles.find(key);
    if (of_stop != kTitles.end()) return of_stop->second + which;
  }
  std::string title;
  for (char c : path) title += c == '_' ? std::string("\\_") : std::string(1, c);
  return title;
}

}  // namespace graze
