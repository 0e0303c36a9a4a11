// The order of Runge-Kutta steps across a contact, drawn: error over step and over time.
#pragma once

#include <vector>

#include "graze/report/picture/gnuplot.hpp"
#include "graze/study/compare/detail/contact_order.hpp"

namespace graze {

// Two panels side by side within a multiplot, at its foot, and their legend below them. Lengths are
// centimetres of a picture 12 cm wide.
inline constexpr double kContactOrderHeight = 8.7;
void draw_contact_orders(GnuplotScript& script, const std::vector<ContactOrder>& lines,
                         double picture_height);

}  // namespace graze
