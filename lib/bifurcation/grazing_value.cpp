#include "graze/bifurcation/grazing_value.hpp"

#include <cmath>
#include <limits>

#include "graze/base/linear_equations.hpp"
#include "graze/base/vector.hpp"

namespace graze {
namespace {

constexpr Eigen::Index kMostSolutions = 5;
constexpr double kApart = 1.3;

// How much the slope of the parameter over this power of the margin changes over the three nearest,
// as a factor.
double bend(const std::vector<NearGrazing>& used, int power) {
  const auto slope = [&](std::size_t k) {
    return (used[k + 1].parameter - used[k].parameter) /
           (std::pow(used[k + 1].margin, power) - std::pow(used[k].margin, power));
  };
  return std::abs(std::log(std::abs(slope(1) / slope(0))));
}

// Of the nearest `count`: p_0 of p = p_0 + p_1 m^lowest + p_2 m^(lowest + 1) + ...
double by_polynomial(const std::vector<NearGrazing>& used, Eigen::Index count, int lowest) {
  Matrix powers(count, count);
  Vector ahead(count);
  const NearGrazing& nearest = used.front();
  const double unit = used[static_cast<std::size_t>(count - 1)].margin;
  for (Eigen::Index i = 0; i < count; ++i) {
    const NearGrazing& at = used[static_cast<std::size_t>(i)];
    ahead[i] = at.parameter - nearest.parameter;
    powers(i, 0) = 1.0;
    for (int k = 1; k < count; ++k) powers(i, k) = std::pow(at.margin / unit, lowest + k - 1);
  }
  return nearest.parameter + solve_with_full_pivoting(powers, ahead)[0];
}

}  // namespace

std::optional<double> grazing_value(const std::vector<NearGrazing>& solutions, double reliable) {
  std::vector<NearGrazing> used;
  for (auto at = solutions.rbegin(); at != solutions.rend() && std::ssize(used) < kMostSolutions;
       ++at)
    if (at->margin >= (used.empty() ? reliable : kApart * used.back().margin)) used.push_back(*at);
  if (used.size() < 2) return {};
  const int lowest = used.size() > 2 && bend(used, 2) < bend(used, 1) ? 2 : 1;
  // As far as a solution more brings it on: farther ones need not lie where the margin is smooth.
  double best = used.front().parameter, change = std::numeric_limits<double>::infinity();
  for (Eigen::Index count = 2; count <= std::ssize(used); ++count) {
    const double value = by_polynomial(used, count, lowest);
    if (!(std::abs(value - best) < change)) break;
    change = std::abs(value - best);
    best = value;
  }
  return best;
}

}  // namespace graze
