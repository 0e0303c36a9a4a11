// Branches of orbits in a picture over a parameter: a curve for each impact (or strobe) of their
// orbits, drawn by stability, and the special points. Every picture that shows branches has them
// from here.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graze/record/diagram_record.hpp"
#include "graze/report/picture_style.hpp"
#include "graze/report/special_marks.hpp"

namespace graze {

// Axes of the picture: SI values times these factors, and what the axes span in their own units.
struct PicturePlane {
  double x_factor = 1.0, y_factor = 1.0;
  AxisRange x, y;
};

class BranchCurves {
 public:
  // `curves`: one a branch. `weight` scales the widths of the lines; `prefix` parts the names of
  // the data of one panel from those of the next.
  BranchCurves(const std::vector<OrbitBranch>& branches, const std::vector<DiagramCurve>& curves,
               const PicturePlane& plane, double weight, std::string prefix = "");

  bool marks(SpecialKind kind) const { return marks_.contains(kind); }
  void write(GnuplotScript& script) const;
  std::vector<std::string> layers() const;
  // Each kind of line and mark once.
  std::vector<std::string> legend() const;

 private:
  // In the order in which they are drawn: what is seen in an experiment lies on top.
  enum Kind : std::size_t { kVirtual, kOpen, kUnstable, kStable, kKinds };
  struct KindStyle;
  // A point of a branch; special points belong to both sides and have no kind of their own.
  struct Node {
    double x = 0.0;
    std::vector<double> y;
    std::optional<Kind> kind;
  };

  static const KindStyle& style_of(std::size_t kind);
  static Kind kind_of(const Orbit& orbit);
  static void align(const Node& before, Node& node);
  Node node(const OrbitBranchPoint& point, const std::vector<double>& heights) const;
  double distance(const Node& a, const Node& b) const;
  void add(const OrbitBranch& branch, const DiagramCurve& curve);
  void add_special(const SpecialPoint& special, const std::vector<double>& heights,
                   std::vector<Node>& nodes);
  void insert(std::vector<Node>& nodes, Node& special) const;
  void draw(const std::vector<Node>& nodes, std::size_t j, Kind first);
  std::string line(std::size_t kind) const;
  std::string mark(const SpecialMark& mark) const;

  PicturePlane plane_;
  double weight_;
  std::string prefix_;
  std::array<PlotTable, kKinds> lines_;
  std::array<PlotTable, kKinds> lone_;      // branches of a single point
  std::map<SpecialKind, PlotTable> marks_;  // special points of orbits
  PlotTable virtual_marks_;
  std::size_t marked_ = 0;  // special points
};

}  // namespace graze
