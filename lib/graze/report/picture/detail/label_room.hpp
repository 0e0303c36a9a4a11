// Places labels beside the contents of a panel: a label covers no mark and no other label, is
// crossed by no line, and covers dots only if there is no other place.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/report/picture/detail/gnuplot.hpp"

namespace graze {

// The ranges of the axes of a panel, in their own units.
struct LabelPlane {
  AxisRange x, y;
  bool x_is_log = false, y_is_log = false;
};

class LabelRoom {
 public:
  // A panel of this width and height, cm of a picture 12 cm wide, with these axes.
  LabelRoom(const LabelPlane& plane, double width, double height);

  // Adds contents of the panel, in the units of the axes.
  void add_line(double x0, double y0, double x1, double y1);
  void add_dot(double x, double y);
  void add_mark(double x, double y);
  // Writes lines of text about a place, which occupy their space.
  void write_over(GnuplotScript& script, const std::string& lines, double x, double y);

  // Puts white behind labels from here on, so that they are legible on any ground.
  void stand_on_white() { is_on_ground_ = true; }
  // Writes the text near a place, as near as there is space for it, with a thin line to it from
  // farther away; false when there is none.
  bool write(GnuplotScript& script, const std::string& text, double x, double y);
  // Ids beside their points; ids at one place, as the end of one branch and the beginning of the
  // next, share one label, which counts them if they are more than two. If there are many, labels
  // stay at their points: lines to all would form a net.
  struct NamedPoint {
    double x = 0.0, y = 0.0;
    std::string id;
  };
  void name(GnuplotScript& script, const std::vector<NamedPoint>& points);
  // The same at the best of several places: beside a curve.
  bool write(GnuplotScript& script, const std::string& text,
             const std::vector<std::pair<double, double>>& places);

 private:
  struct Box {
    double left = 0.0, right = 0.0, low = 0.0, high = 0.0;  // cm
  };
  struct Found {
    Box box;
    double cost = 0.0;
    double x = 0.0, y = 0.0;  // of the place that it is of, cm
    double away = 0.0;        // cm
  };

  // A thin line from a place to its label, cm.
  struct Leader {
    double from_x = 0.0, from_y = 0.0, to_x = 0.0, to_y = 0.0;
    std::pair<double, double> at(int step) const {
      const double part = static_cast<double>(step) / kLeaderSteps;
      return {from_x + part * (to_x - from_x), from_y + part * (to_y - from_y)};
    }
  };
  static constexpr int kLeaderSteps = 40;
  static Leader leader_to(const Box& box, double x, double y);
  bool meets_label(const Leader& leader) const;

  double cm_x(double x) const { return width_ * plane_.x.part(x, plane_.x_is_log); }
  double cm_y(double y) const { return height_ * plane_.y.part(y, plane_.y_is_log); }
  void fill(const Box& box, unsigned char with);
  std::optional<double> cost_of(const Box& box) const;
  std::optional<Found> best_near(const std::string& text, double x, double y, bool on_curve) const;
  void put(GnuplotScript& script, const std::string& text, const Found& found);

  LabelPlane plane_;
  double width_, height_;
  int columns_, rows_;
  bool is_crowded_ = false, is_on_ground_ = false;
  std::vector<unsigned char> taken_;  // by cells: a dot 1, a line 253, a mark 254, a label 255
};

}  // namespace graze
