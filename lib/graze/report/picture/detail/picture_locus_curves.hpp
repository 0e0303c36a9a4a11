// Loci of special points in a picture of the plane of two parameters: each kind in a colour and a
// dash of its own, parts whose orbits are none of the system grey, points of codimension two as
// dots with their ids. Every picture that shows loci has them from here.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "graze/bifurcation/loci/orbit_loci.hpp"
#include "graze/report/picture/detail/branch_lines.hpp"
#include "graze/report/picture/detail/label_room.hpp"
#include "graze/report/picture/gnuplot.hpp"

namespace graze {

// Points of a locus from `first` to `last` whose orbits all are, or are not, some of the system.
// Where the classification changes both parts have the point.
struct LocusPart {
  bool is_real = true;
  std::size_t first = 0, last = 0;
};
std::vector<LocusPart> locus_parts(const OrbitLocus& locus);

// What is drawn, in its order, and what the legend says of it.
struct LociDrawn {
  std::vector<std::string> curves, legend;
};

// On colours of their own, curves have a white seam.
enum class LociGround { kPaper, kColours };

// Writes their data and adds to what is drawn.
void draw_locus_curves(const OrbitLoci& traced, const PicturePlane& plane, LociGround ground,
                       GnuplotScript& script, LociDrawn& drawn);

// Names the points of codimension two, where names are wanted: beside them, covering none.
void label_loci(const OrbitLoci& traced, const PicturePlane& plane, LabelChoice choice,
                LabelRoom& room, GnuplotScript& script);

// Of the axes that loci are drawn in.
LabelRoom loci_room(const PicturePlane& plane, const Canvas& canvas);

}  // namespace graze
