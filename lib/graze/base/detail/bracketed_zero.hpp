// The zero of a function between two places where its signs differ, to the last bits (Alefeld,
// Potra and Shi's algorithm 748).
#pragma once

#include <functional>
#include <utility>

namespace graze {

struct BracketEnd {
  double at = 0.0, value = 0.0;
};

// Two numbers within four roundings that enclose the zero, ascending; equal where it was hit.
// Requires a.at < b.at and values of opposite signs, neither of them zero.
std::pair<double, double> bracketed_zero(const std::function<double(double)>& f,
                                         const BracketEnd& a, const BracketEnd& b);

}  // namespace graze
