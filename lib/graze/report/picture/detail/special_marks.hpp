// How the kinds of special points are marked in pictures.
#pragma once

#include <cstddef>
#include <string>

namespace graze {

struct SpecialMark {
  std::string title;   // "fold (LP)", for the legend
  int point = 0;       // gnuplot's point type
  double size = 1.0;   // relative, so that all look alike
  const char* colour;  // "#000000"
  // Drawn as an outline over the paper's white; `point` is the outline's, this the shape's that it
  // encloses. 0: filled.
  int ground = 0;
  double width = 1.2;  // of the outline's line
};

// The mark of a kind of special point by its label, "LP"; one that is not known has a mark too and
// its label for a title.
SpecialMark special_mark(const std::string& label);

// Marks shrink as they crowd: the size that suits this many.
double crowded_mark_size(std::size_t count);

}  // namespace graze
