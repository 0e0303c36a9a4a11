#include "graze/structure/detail/cantilever.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "graze/scene/check.hpp"

namespace graze {
namespace {

// The terms of the shape of one mode:
//   shape = rise e^{b (xi - 1)} + fall e^{-b xi} - cos(b xi) + ratio sin(b xi)
struct ModeShape {
  double wave_number;
  double ratio;  // s
  double rise;   // (1 - s) e^b/2
  double fall;   // (1 + s)/2
};

// b = (j - 1/2) pi + d with sin(d) = +-sech(b): a contraction (factor below 0.31 for j = 1, below
// 0.02 for all others), so 40 passes settle every digit.
double offset_of_root(int j) {
  const double base = (j - 0.5) * std::numbers::pi;
  const double sign = j % 2 == 1 ? 1.0 : -1.0;
  double offset = 0.0;
  for (int pass = 0; pass < 40; ++pass) offset = sign * std::asin(1.0 / std::cosh(base + offset));
  return offset;
}

ModeShape make_shape(int j) {
  const double offset = offset_of_root(j);
  const double b = (j - 0.5) * std::numbers::pi + offset;
  // sin(b) and cos(b) from the small offset: no digits lost to the size of b.
  const double sign = j % 2 == 1 ? 1.0 : -1.0;
  const double sine = sign * std::cos(offset);
  const double cosine = -sign * std::sin(offset);
  const double decay = std::exp(-b);
  // sinh(b) + sin(b) = scale e^b/2
  const double scale = 1.0 - decay * decay + 2.0 * decay * sine;
  const double ratio = (1.0 + decay * decay + 2.0 * decay * cosine) / scale;
  return {b, ratio, (sine - cosine - decay) / scale, 0.5 * (1.0 + ratio)};
}

const ModeShape& mode_shape(int j) {
  static const auto table = [] {
    std::array<ModeShape, kMostModes> shapes{};
    for (int i = 0; i < kMostModes; ++i) shapes[static_cast<std::size_t>(i)] = make_shape(i + 1);
    return shapes;
  }();
  assert(j >= 1 && j <= kMostModes);
  return table[static_cast<std::size_t>(j - 1)];
}

}  // namespace

double cantilever_wave_number(int j) { return mode_shape(j).wave_number; }

double cantilever_shape(int j, double xi) {
  const ModeShape& m = mode_shape(j);
  const double x = m.wave_number * xi;
  return m.rise * std::exp(m.wave_number * (xi - 1.0)) + m.fall * std::exp(-x) - std::cos(x) +
         m.ratio * std::sin(x);
}

double cantilever_slope(int j, double xi) {
  const ModeShape& m = mode_shape(j);
  const double x = m.wave_number * xi;
  return m.wave_number * (m.rise * std::exp(m.wave_number * (xi - 1.0)) - m.fall * std::exp(-x) +
                          std::sin(x) + m.ratio * std::cos(x));
}

double cantilever_curvature(int j, double xi) {
  const ModeShape& m = mode_shape(j);
  const double x = m.wave_number * xi;
  return m.wave_number * m.wave_number *
         (m.rise * std::exp(m.wave_number * (xi - 1.0)) + m.fall * std::exp(-x) + std::cos(x) -
          m.ratio * std::sin(x));
}

double cantilever_mean(int j) {
  const ModeShape& m = mode_shape(j);
  return 2.0 * m.ratio / m.wave_number;
}

}  // namespace graze
