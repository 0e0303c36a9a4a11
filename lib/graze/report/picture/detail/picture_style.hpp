// Common parts of pictures: axes, margins, legends.
#pragma once

#include <string>
#include <vector>

#include "graze/report/appearance/looks.hpp"
#include "graze/report/chart/axis.hpp"
#include "graze/report/picture/detail/gnuplot.hpp"

namespace graze {

// "gap (mm)", or the name alone for a pure number; the name may use gnuplot's markup.
std::string axis_label(const std::string& name, const std::string& unit);

// Axes, fonts and line ends that all pictures share.
void set_style(GnuplotScript& script);

// Places the axes: the free margin on each side, as parts of a picture of 12 cm and of the height
// of its layout (GnuplotScript).
struct Margins {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
};
void set_margins(GnuplotScript& script, const Margins& margins);

// Names the vertical axis at a set place, a part of 12 cm from its left edge, however
// wide the axis' numbers are; \n in the name begins a new line.
void name_vertical_axis(GnuplotScript& script, const std::string& name, const std::string& unit,
                        double place);

// A name that is longer than `most` letters in two lines, broken before its direction, else near
// its middle.
std::string in_two_lines(std::string name, std::size_t most);

// The number of distinguishable tics on a vertical axis of this length, cm, `most` at most.
int tics_within(double length, int most);

// The horizontal axis of a picture over a parameter: its range, in the axis' unit, and its tics;
// over a forcing frequency (rad/s) also one in Hz above the axes, which takes space there. Names
// are left out where another panel has them.
struct AxisNames {
  bool below = true, above = true;
};
void set_parameter_axis(GnuplotScript& script, const std::string& parameter, const AxisRange& range,
                        const std::string& unit, AxisNames names = {}, bool is_log = false);

// How SI values are shown on an axis: transformed by `of`, in `unit`. Logarithmic axes show
// positive values, decibels (20 log10, re 1 of the SI unit) absolute values; others are at the
// axis' low end.
class ShownAxis {
 public:
  // `values`: those that the axis has to show, SI. On a linear axis `margin`, a part of its span,
  // is left free on both sides, and zero is included if `from_zero`.
  ShownAxis(const AxisRequest& request, const std::string& si_unit,
            const std::vector<double>& values, double margin, bool from_zero = false);

  double of(double value) const;
  const std::string& unit() const { return unit_.unit; }
  double factor() const { return unit_.factor; }  // of an axis that is not in decibels
  const AxisRange& range() const { return range_; }
  bool is_log() const { return scale_ == AxisScale::kLog; }
  // The commands of an axis: its range, its scale, at most so many tics.
  void set_horizontal(GnuplotScript& script, int most_tics) const;
  void set_vertical(GnuplotScript& script, int most_tics) const;

 private:
  AxisScale scale_;
  AxisUnit unit_;
  AxisRange range_;
  double least_ = 0.0;  // smaller values are shown as this, SI; 0: none
};

}  // namespace graze
