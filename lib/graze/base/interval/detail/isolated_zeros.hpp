// Every zero of a function over a range, each by itself, and proof that there are no others.
//
// The range is halved until over each cell either the function keeps its sign or its slope does, as
// its mean value form shows (mean_value_form.hpp); in the latter case the signs at both ends say
// whether there is a zero or none. What cannot be halved any further (a multiple zero, to rounding)
// or what is left over by a budget, or once it was asked to stop (stop_scope.hpp), is undecided,
// and the signs at its ends are all that is known of it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/base/interval/detail/mean_value_form.hpp"

namespace graze {

// Nothing where the function cannot be bounded over the cell; it is halved then.
using BoundedFunction = std::function<std::optional<MeanValueForm>(double low, double high)>;

struct IsolatedZeros {
  std::vector<double> zeros;  // ascending, where the function changes its sign
  int first_sign = 0;   // before the first of them: 1 or -1; 0 where it could nowhere be evaluated
  int undecided = 0;    // cells that may hold zeros beyond those
  double widest = 0.0;  // of them
  long long evaluations = 0;  // over cells and at points
};

// Requires low < high. `most_cells`: how many may be looked at, the widest ones first.
IsolatedZeros isolated_zeros(const BoundedFunction& f, double low, double high,
                             long long most_cells);

}  // namespace graze
