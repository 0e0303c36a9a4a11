#include "graze/bifurcation/problem/option_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/continuation/branch/branch_values.hpp"

namespace graze {
namespace {

std::optional<OptionFault> fault_in_range(const BranchOptions& options) {
  const double width = std::abs(options.to - options.from);
  if (!std::isfinite(width)) return OptionFault{"from, to", "the range must be of finite numbers"};
  if (width == 0.0) return OptionFault{"from, to", "the range must not be empty"};
  // A step, a fiftieth of the range, must change the parameter by more than its last digits.
  const double coarsest = 1e3 * std::numeric_limits<double>::epsilon() * 50.0 *
                          std::max(std::abs(options.from), std::abs(options.to));
  if (width < coarsest)
    return OptionFault{
        "from, to",
        fmt::format("the range must be wider than {:.3g} for its steps to be told apart in double "
                    "precision",
                    coarsest)};
  return {};
}

std::optional<OptionFault> fault_in_step(const BranchOptions& options) {
  const double step = options.max_step;
  if (!(step >= 0.0))
    return OptionFault{"max_step", fmt::format("'{:g}' is not a number above 0", step)};
  const double finest = std::abs(options.to - options.from) / kMostBranchPoints;
  if (step > 0.0 && step < finest)
    return OptionFault{
        "max_step",
        fmt::format("a branch has at most {} points, steps of {:g} cannot cross the range; give at "
                    "least {:.3g}",
                    kMostBranchPoints, step, finest)};
  return {};
}

}  // namespace

std::string OptionFault::text_of_program() const {
  std::string names = "--";
  for (const char c : members) names += c == '_' ? "-" : c == ' ' ? " --" : std::string(1, c);
  return names + ": " + sentence;
}

std::optional<OptionFault> fault_in(const BranchOptions& options) {
  if (const auto fault = fault_in_range(options)) return fault;
  if (const auto fault = fault_in_step(options)) return fault;
  const auto whole = [](const char* name, int value, int least) -> std::optional<OptionFault> {
    if (value >= least) return {};
    return OptionFault{name, fmt::format("'{}' is not a whole number from {}", value, least)};
  };
  if (const auto fault = whole("period", options.period, 1)) return fault;
  if (const auto fault = whole("impacts", options.impacts, 0)) return fault;
  const bool is_searched = !options.start && options.settled.empty();
  if (options.impacts == 0 && options.period != 1 && is_searched)
    return OptionFault{"period", "the response that meets no stop has period 1; leave it out"};
  if (const auto fault = whole("start_values", options.start_values, 0)) return fault;
  return whole("follow_depth", options.follow_depth, 0);
}

}  // namespace graze
