// Branches of orbits in a picture over a parameter: a curve for each impact (or stroboscopic point)
// of their orbits, drawn by stability, and the special points. Every picture that shows branches
// has them from here.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "graze/record/detail/diagram_record.hpp"
#include "graze/report/picture/detail/branch_lines.hpp"
#include "graze/report/picture/detail/label_room.hpp"
#include "graze/report/picture/gnuplot.hpp"

namespace graze {

class BranchCurves {
 public:
  // `curves`: one a branch, or none at all. `weight` scales the widths of the lines; `prefix` parts
  // the names of the data of one panel from those of the next. Refers to the branches.
  BranchCurves(const std::vector<OrbitBranch>& branches, const std::vector<DiagramCurve>& curves,
               const PicturePlane& plane, double weight, std::string prefix = "");

  void write(GnuplotScript& script) const;
  std::vector<std::string> layers() const;
  // Each kind of line and mark once.
  std::vector<std::string> legend() const;
  // Takes room for what is drawn, then writes the ids of special points and the names of branches,
  // as far as they are wanted.
  void label(GnuplotScript& script, LabelRoom& room, LabelChoice choice) const;

 private:
  void label_branches(GnuplotScript& script, LabelRoom& room) const;

  const std::vector<OrbitBranch>& branches_;
  double weight_;
  std::string prefix_;
  BranchLines made_;
  std::array<PlotTable, kLineKinds> lines_;
  std::array<PlotTable, kLineKinds> lone_;  // branches of a single point
  std::map<SpecialKind, PlotTable> marks_;  // special points of orbits
  PlotTable virtual_marks_;
  std::size_t marked_ = 0;  // special points
};

}  // namespace graze
