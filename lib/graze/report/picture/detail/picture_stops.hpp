// Stops in the panels of a picture.
#pragma once

#include <string>
#include <vector>

#include "graze/report/chart/detail/motion_seen.hpp"
#include "graze/report/picture/detail/picture_curve.hpp"

namespace graze {

// The stops of a place: a line each with the space behind it shaded. A stop far off the motion is
// only named, on its side of the panel.
class StopMarks {
 public:
  // `motion` is what the panel shows, in `unit`; stops are named where there are several, and far
  // ones with their place in the scene's units.
  StopMarks(const std::vector<SeenStop>& stops, const AxisRange& motion, const AxisUnit& unit,
            bool named, Units units);

  bool drawn() const { return !near_.empty(); }
  // Makes the axis span the stops that are drawn.
  void include(AxisRange& range) const;
  // Widens a settled axis by the room that the names of the others take.
  void make_room(AxisRange& range) const;
  // What of the axis the drawn stops leave free.
  AxisRange between(const AxisRange& range) const;
  // Stops on the vertical axis; `spacing` is a line of text as a part of the axis.
  void draw(GnuplotScript& script, const AxisRange& range, double spacing,
            std::vector<std::string>& layers) const;
  // Stops on the horizontal axis.
  void draw_across(GnuplotScript& script, const AxisRange& range) const;

 private:
  double at(const SeenStop& stop) const { return unit_.factor * stop.place; }
  double edge(const SeenStop& stop, const AxisRange& range) const {
    return stop.sense > 0.0 ? range.high : range.low;
  }
  std::string name(const SeenStop& stop) const;

  AxisUnit unit_;
  bool named_;
  Units units_;
  std::vector<SeenStop> near_, far_;
};

}  // namespace graze
