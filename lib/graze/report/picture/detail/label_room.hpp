// Room for words beside what a panel shows: a label covers no mark and no other label, is crossed
// by no line, and covers dots only where there is no place without.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graze/report/picture/detail/gnuplot.hpp"

namespace graze {

// What the axes of a panel span, in their own units.
struct LabelPlane {
  AxisRange x, y;
  bool x_is_log = false, y_is_log = false;
};

class LabelRoom {
 public:
  // A panel so wide and high, cm of a picture 12 cm wide, with these axes.
  LabelRoom(const LabelPlane& plane, double width, double height);

  // What is there already, in the units of the axes.
  void add_line(double x0, double y0, double x1, double y1);
  void add_dot(double x, double y);
  void add_mark(double x, double y);
  // Writes lines of text about a place, which take their room there.
  void write_over(GnuplotScript& script, const std::string& lines, double x, double y);

  // Words stand on white from here on, to be read on any ground.
  void stand_on_white() { is_on_ground_ = true; }
  // Writes the text near a place, as near as there is room for it, with a thin line to it from
  // farther away; false where there is none.
  bool write(GnuplotScript& script, const std::string& text, double x, double y);
  // Ids beside their points; what stands at one place, as the end of one branch and the beginning
  // of the next, has one label, which counts them where they are more than two. Of many none stands
  // away from its point: lines to all would be a net.
  struct NamedPoint {
    double x = 0.0, y = 0.0;
    std::string id;
  };
  void name(GnuplotScript& script, const std::vector<NamedPoint>& points);
  // The same at the best of several places: on a curve, which it stands beside.
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
