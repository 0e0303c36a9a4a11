// Looks (appearance/looks.hpp) as gnuplot commands.
#pragma once

#include <string>
#include <vector>

#include "graze/report/appearance/looks.hpp"

namespace graze {

// "with lines lw 1.8 dt (8,5) lc rgb '#D55E00'"; `weight` scales the width.
std::string line_of(const Look& look, double weight = 1.0);
// The dashes of it, " dt (8,5)".
std::string dashes_of(const Look& look);

// "with points pt 6 ps 0.90*mark lw 1.2 lc rgb '#000000'"; `scale` scales the size.
std::string mark_of(const Look& look, double scale = 1.0);

// Draws the marks of a table: outlines over the paper's white, so that no curve crosses them.
void add_marks(std::vector<std::string>& layers, const std::string& table, const Look& look,
               double scale = 1.0);

// gnuplot's number of the mark.
int point_type(const Look& look);

}  // namespace graze
