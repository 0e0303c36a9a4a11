#include "graze/report/picture/detail/picture_contact_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graze/report/picture/picture_style.hpp"

namespace graze {
namespace {

// cm, from the foot: of the panels, and of the row's first panel and the second one from the left.
constexpr double kFoot = 3.3, kHead = 8.2;
constexpr double kWidth = 12.0, kFirst = 2.1, kFirstEnd = 6.4, kSecond = 7.3, kSecondEnd = 11.6;
// Errors below are rounding, and drawn at it.
constexpr double kLeastError = 1e-16;

// Springs by colour; located: full marks on full lines.
const char* colour(const ContactOrder& line) {
  if (line.contact.exponent == 1.0) return kBlue;
  return line.contact.exponent == 1.5 ? kVermillion : kGreen;
}

bool is_exact(const ContactOrder& line) { return line.method == "exact"; }

std::string look(const ContactOrder& line) {
  if (is_exact(line)) return fmt::format("points pt 12 ps 1.1*mark lw 2 lc rgb '{}'", colour(line));
  const bool located = line.method == "rk4, located";
  return fmt::format("linespoints lw 1.5 dt {} pt {} ps 0.6*mark lc rgb '{}'",
                     located ? "solid" : "(8,4)", located ? 7 : 6, colour(line));
}

std::string title(const ContactOrder& line) {
  if (is_exact(line)) return line.spring + ", exact flow";
  return fmt::format("{}{}: order {:.2f}", line.spring, line.method.substr(3), line.order);
}

// With room for the marks.
AxisRange span_of(const std::vector<ContactOrder>& lines,
                  double (*of)(const ContactOrder&, const ContactOrderRow&)) {
  AxisRange range;
  for (const ContactOrder& line : lines)
    for (const ContactOrderRow& row : line.rows)
      if (const double value = of(line, row); value > 0.0) {
        range.include(0.5 * value);
        range.include(2.0 * value);
      }
  return range;
}

double error(const ContactOrder& /*line*/, const ContactOrderRow& row) {
  return std::max(row.error, kLeastError);
}
double step(const ContactOrder& line, const ContactOrderRow& row) {
  return row.step / line.contact.duration();
}
double seconds(const ContactOrder& /*line*/, const ContactOrderRow& row) { return row.seconds; }

void set_panel(GnuplotScript& script, double left, double right, double height,
               const AxisRange& x) {
  set_margins(script, {.left = left / kWidth,
                       .right = 1.0 - right / kWidth,
                       .bottom = kFoot / height,
                       .top = 1.0 - kHead / height});
  script.command(fmt::format("set xrange [{:g}:{:g}]", x.low, x.high));
}

std::vector<std::string> layers(const std::vector<ContactOrder>& lines, int column, bool titled) {
  std::vector<std::string> layers;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string name = titled ? gnuplot_string(title(lines[i])) : "''";
    // The exact flow takes no steps of one length.
    if (is_exact(lines[i]) && column == 1)
      layers.push_back(fmt::format("keyentry with {} title {}", look(lines[i]), name));
    else
      layers.push_back(fmt::format("$contact{} using {}:3 with {}{}", i, column, look(lines[i]),
                                   titled ? " title " + name : " notitle"));
  }
  return layers;
}

}  // namespace

void draw_contact_orders(GnuplotScript& script, const std::vector<ContactOrder>& lines,
                         double picture_height) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    PlotTable table;
    for (const ContactOrderRow& row : lines[i].rows)
      table.row({step(lines[i], row), row.seconds, error(lines[i], row)});
    script.data(fmt::format("contact{}", i), table);
  }
  const AxisRange errors = span_of(lines, error);
  script.command("unset label\nset logscale xy");
  script.command("set format xy '10^{%L}'\nset xtics 10\nset ytics 100");
  script.command(fmt::format("set yrange [{:g}:{:g}]", errors.low, errors.high));
  set_panel(script, kFirst, kFirstEnd, picture_height, span_of(lines, step));
  script.command(
      fmt::format("set key at screen 0.5, screen {:.4g} center bottom vertical maxcols 1 Left "
                  "reverse samplen 2 font ',9'",
                  0.15 / picture_height));
  script.command("set xlabel 'step / duration of the contact'");
  name_vertical_axis(script, "error of speed or duration, relative", "");
  script.plot(layers(lines, 1, true));
  script.command("unset label\nunset key\nset format y ''");
  set_panel(script, kSecond, kSecondEnd, picture_height, span_of(lines, seconds));
  script.command("set xlabel " + axis_label("computing time of the contact", "s"));
  script.plot(layers(lines, 2, false));
}

}  // namespace graze
