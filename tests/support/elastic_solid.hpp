// Mass and stiffness of an elastic block of trilinear hexahedra (27 nodes in each row's stencil),
// made for tests: cubes of side h, consistent mass, integration by 2 x 2 x 2 Gauss points (T. J. R.
// Hughes, The Finite Element Method, chapter 3).
#pragma once

#include <cmath>
#include <vector>

#include "graze/fem/structural_matrices.hpp"

namespace graze::solid {

using Block = Eigen::Matrix<double, 24, 24>;

struct Element {
  Block stiffness = Block::Zero(), mass = Block::Zero();
};

// E = 1, nu = 0.3, rho = 1.
inline Element cube(double h) {
  Element element;
  Eigen::Matrix<double, 6, 6> law = Eigen::Matrix<double, 6, 6>::Zero();
  const double nu = 0.3, factor = 1.0 / ((1.0 + nu) * (1.0 - 2.0 * nu));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) law(i, j) = factor * (i == j ? 1.0 - nu : nu);
    law(i + 3, i + 3) = factor * (0.5 - nu);
  }
  const double gauss = 1.0 / std::sqrt(3.0), volume = h * h * h / 8.0;
  for (int point = 0; point < 8; ++point) {
    const double xi[3] = {point & 1 ? gauss : -gauss, point & 2 ? gauss : -gauss,
                          point & 4 ? gauss : -gauss};
    Eigen::Matrix<double, 6, 24> strain = Eigen::Matrix<double, 6, 24>::Zero();
    Eigen::Matrix<double, 3, 24> shape = Eigen::Matrix<double, 3, 24>::Zero();
    for (int node = 0; node < 8; ++node) {
      const double sign[3] = {node & 1 ? 1.0 : -1.0, node & 2 ? 1.0 : -1.0, node & 4 ? 1.0 : -1.0};
      double value = 0.125, slope[3];
      for (int d = 0; d < 3; ++d) value *= 1.0 + sign[d] * xi[d];
      for (int d = 0; d < 3; ++d) slope[d] = value / (1.0 + sign[d] * xi[d]) * sign[d] * 2.0 / h;
      for (int d = 0; d < 3; ++d) {
        shape(d, 3 * node + d) = value;
        strain(d, 3 * node + d) = slope[d];
      }
      const int first[3] = {0, 1, 2}, second[3] = {1, 2, 0};
      for (int s = 0; s < 3; ++s) {
        strain(3 + s, 3 * node + first[s]) = slope[second[s]];
        strain(3 + s, 3 * node + second[s]) = slope[first[s]];
      }
    }
    element.stiffness += volume * strain.transpose() * law * strain;
    element.mass += volume * shape.transpose() * shape;
  }
  return element;
}

// nx x ny x nz nodes a distance h apart, numbered from 1, x fastest; held where x = 0 if asked.
inline StructuralMatrices block(int nx, int ny, int nz, double h, bool is_held) {
  const Element element = cube(h);
  const auto node = [&](int i, int j, int k) { return i + nx * (j + ny * k); };
  StructuralMatrices result;
  std::vector<int> places;
  for (int n = 0; n < nx * ny * nz; ++n)
    for (int d = 1; d <= 3; ++d) {
      const bool out = is_held && n % nx == 0;
      places.push_back(out ? -1 : result.size());
      if (!out) result.labels.push_back({n + 1, d});
    }
  std::vector<Eigen::Triplet<double>> mass, stiffness;
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i)
        for (int a = 0; a < 24; ++a)
          for (int b = 0; b < 24; ++b) {
            const auto place = [&](int c) {
              const int m = c / 3;
              const int at = node(i + (m & 1), j + (m >> 1 & 1), k + (m >> 2 & 1));
              return places[static_cast<std::size_t>(3 * at + c % 3)];
            };
            const int row = place(a), column = place(b);
            if (row < 0 || column < 0) continue;
            mass.emplace_back(row, column, element.mass(a, b));
            stiffness.emplace_back(row, column, element.stiffness(a, b));
          }
  const int n = result.size();
  result.mass.resize(n, n);
  result.mass.setFromTriplets(mass.begin(), mass.end());
  result.stiffness.resize(n, n);
  result.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  result.mass_file = "mass";
  result.stiffness_file = "stiffness";
  return result;
}

}  // namespace graze::solid
