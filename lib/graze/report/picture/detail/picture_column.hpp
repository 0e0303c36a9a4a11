// The layout of a picture of a run: panels over one time axis, one below the other, then a row of
// panels with axes of their own. Lengths are centimetres of a Canvas.
#pragma once

#include <string>
#include <vector>

#include "graze/report/picture/picture_style.hpp"

namespace graze {

class PanelColumn {
 public:
  static constexpr double kPanel = 2.6, kLowPanel = 1.7, kRow = 3.6;  // heights
  static constexpr double kLabelLine = 0.36;                          // of text beside a panel

  explicit PanelColumn(GnuplotScript& script) : script_(script) {}

  // The heights of the panels from the head down, and whether the row follows; `legend` at the head
  // and `labels` at the right take their room. To be called first.
  void lay_out(const PictureRequest& request, const RunInfo& info, std::vector<double> panels,
               bool row, bool legend, bool labels);
  const Canvas& canvas() const { return canvas_; }

  // `name`: of what the panels share where that is not time.
  void set_time_axis(const AxisRange& range, const std::string& unit,
                     const std::string& name = "time");
  // The same over a parameter, from its values in SI, a part of them more on both sides; returns
  // the factor from SI to the axis.
  double set_parameter_axis(const std::string& path, const std::string& si_unit, AxisRange values,
                            double margin);
  // The next panel over time; its vertical axis is named in one or two lines.
  void begin_panel(const AxisRange& range, const std::string& name, const std::string& unit);
  void end_panel(const std::vector<std::string>& layers);

  // Panel `i` of the `count` of the row, one or two; the first one names the vertical axis.
  void begin_in_row(std::size_t i, std::size_t count, const AxisRange& x, const AxisRange& y);
  void end_in_row(const std::vector<std::string>& layers);

  void name_vertical(const std::string& name, const std::string& unit);
  // The key into the room at the head, a remark beside it.
  void set_legend();
  void remark(const std::string& text);
  // Between the panel begun and what is above it.
  void note(const std::string& text);
  // A line of text as a part of the height of the panel begun.
  double label_line() const { return kLabelLine / height_; }
  void draw_zero_line();  // where the vertical axis holds zero

 private:
  void set_box(double left, double right);
  void clear_marks();

  GnuplotScript& script_;
  std::vector<double> panels_;
  std::string time_unit_, time_name_;
  std::size_t begun_ = 0;
  Canvas canvas_;
  double row_ = kRow;                 // height of the row
  double right_ = 0.0, total_ = 0.0;  // margin, height of the picture
  double top_ = 0.0, height_ = 0.0;   // of the panel begun, from the head
  AxisRange vertical_;                // of the panel begun
};

}  // namespace graze
