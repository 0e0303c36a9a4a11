// What is stable in a plane of two parameters, as tints behind the curves of a picture.
#pragma once

#include <string>
#include <vector>

#include "graze/report/picture/detail/branch_lines.hpp"
#include "graze/report/picture/detail/label_room.hpp"
#include "graze/study/plane/stable_regions.hpp"

namespace graze {

class RegionTints {
 public:
  // Axes from (x.low, y.low) to (x.high, y.high) that are the plane's ranges.
  RegionTints(const StableRegions& regions, const PicturePlane& plane);

  void write(GnuplotScript& script) const;
  // To be drawn before all else.
  std::vector<std::string> layers() const;
  // Each kind of tint that there is, once.
  std::vector<std::string> legend() const;
  // Names the areas that have room for it, and takes that room.
  void label(GnuplotScript& script, LabelRoom& room) const;

  // Of every place, -1: none; and what each tint says and looks like.
  const std::vector<int>& tints() const { return tints_; }
  std::string tint_title(int tint) const;
  std::string colour_of(int tint) const;

 private:
  struct Box {
    int first = 0, last = 0;  // columns
    int row = 0, end = 0;     // rows, the last one after them
    int tint = 0;
  };

  int tint_at(int column, int row) const;
  std::vector<Box> boxes() const;
  std::string fill_of(int tint) const;
  // The motion that the loci are of, so many times its period and impacts: "(2,2)".
  std::string asked(int times) const;
  double x(double column) const;
  double y(double row) const;

  const StableRegions& regions_;
  const PicturePlane& plane_;
  bool mirrored_x_ = false, mirrored_y_ = false;  // a range may be given from its upper end
  std::vector<int> tints_;                        // of each place; -1: none
};

}  // namespace graze
