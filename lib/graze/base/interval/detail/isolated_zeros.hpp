// Every zero of a function over a range, isolated, and proof that there are no others.
//
// The range is halved until over each cell either the function keeps its sign or its slope does, as
// its mean value form shows (mean_value_form.hpp); in the latter case the signs at both ends decide
// whether there is a zero or none. A cell is undecided when it cannot be halved any further (a
// multiple zero, to rounding), when the budget is used up, or once it was asked to stop
// (stop_scope.hpp); only the signs at its ends are then known.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/base/interval/detail/mean_value_form.hpp"

namespace graze {

// Returns nullopt when the function cannot be bounded over the cell, which is then halved.
using BoundedFunction = std::function<std::optional<MeanValueForm>(double low, double high)>;

struct IsolatedZeros {
  std::vector<double> zeros;  // ascending, where the function changes its sign
  int first_sign = 0;   // before the first of them: 1 or -1; 0 where it could nowhere be evaluated
  int undecided = 0;    // cells that may hold zeros beyond those
  double widest = 0.0;  // width of the widest undecided cell
  long long evaluations = 0;  // over cells and at points
};

// Requires low < high. `most_cells`: how many may be looked at, the widest ones first.
IsolatedZeros isolated_zeros(const BoundedFunction& f, double low, double high,
                             long long most_cells);

}  // namespace graze
