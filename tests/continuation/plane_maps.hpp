// Maps with two parameters written once, as templates on the scalar; their derivatives by dual
// numbers.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "graze/continuation/locus/locus.hpp"
#include "graze/continuation/map.hpp"

namespace graze::support {

// value + slope e, e^2 = 0
template <class T>
struct Dual {
  T value{}, slope{};
  Dual() = default;
  Dual(double v) : value(v), slope(0.0) {}  // NOLINT(google-explicit-constructor)
  Dual(T v, T s) : value(v), slope(s) {}
};
template <class T>
Dual<T> operator+(const Dual<T>& a, const Dual<T>& b) {
  return {a.value + b.value, a.slope + b.slope};
}
template <class T>
Dual<T> operator-(const Dual<T>& a, const Dual<T>& b) {
  return {a.value - b.value, a.slope - b.slope};
}
template <class T>
Dual<T> operator*(const Dual<T>& a, const Dual<T>& b) {
  return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}
template <class T>
Dual<T> sin(const Dual<T>& a);
template <class T>
Dual<T> cos(const Dual<T>& a) {
  using std::cos, std::sin;
  return {cos(a.value), T(-1.0) * sin(a.value) * a.slope};
}
template <class T>
Dual<T> sin(const Dual<T>& a) {
  using std::cos, std::sin;
  return {sin(a.value), cos(a.value) * a.slope};
}

using First = Dual<double>;
using Second = Dual<First>;

// f(x, p, q) with x a std::vector<S> and S any of double, First, Second; it counts its calls in
// `calls` where that is given.
template <class F>
Map plane_map(F f, long long* calls = nullptr) {
  Map map;
  map.evaluate = [f, calls](const Vector& x, Parameters parameters) {
    const double p = parameters[0], q = parameters[1];
    if (calls) ++*calls;
    const Eigen::Index n = x.size();
    Matrix slope(n, n + 2);
    MapEvaluation at;
    at.image.resize(n);
    for (Eigen::Index k = 0; k < n + 2; ++k) {
      std::vector<First> y;
      for (Eigen::Index i = 0; i < n; ++i) y.push_back({x[i], i == k ? 1.0 : 0.0});
      const auto image = f(y, First(p, k == n ? 1.0 : 0.0), First(q, k == n + 1 ? 1.0 : 0.0));
      for (Eigen::Index i = 0; i < n; ++i) {
        at.image[i] = image[static_cast<std::size_t>(i)].value;
        slope(i, k) = image[static_cast<std::size_t>(i)].slope;
      }
    }
    at.jacobian = slope.leftCols(n);
    at.by_parameters = slope.rightCols(2);
    return std::optional<MapEvaluation>(at);
  };
  map.curvature = [f](const Vector& x, Parameters parameters, const Vector& w, const Vector& v) {
    const double p = parameters[0], q = parameters[1];
    const Eigen::Index n = x.size();
    Vector result = Vector::Zero(n + 2);
    for (Eigen::Index k = 0; k < n + 2; ++k) {
      const auto seed = [&](double value, Eigen::Index place, double along) {
        return Second(First(value, place == k ? 1.0 : 0.0), First(along, 0.0));
      };
      std::vector<Second> y;
      for (Eigen::Index i = 0; i < n; ++i) y.push_back(seed(x[i], i, v[i]));
      const auto image = f(y, seed(p, n, 0.0), seed(q, n + 1, 0.0));
      for (Eigen::Index i = 0; i < n; ++i)
        result[k] += w[i] * image[static_cast<std::size_t>(i)].slope.slope;
    }
    return std::optional<Vector>(result);
  };
  return map;
}

// x -> 1 - p x^2 + y, y -> q x (Henon 1976). Fixed points p x^2 + (1 - q) x - 1 = 0; the product of
// the multipliers is -q, their sum -2 p x.
inline Map henon_plane() {
  return plane_map([](const auto& x, const auto& p, const auto& q) {
    using S = std::decay_t<decltype(p)>;
    return std::vector<S>{S(1.0) - p * x[0] * x[0] + x[1], q * x[0]};
  });
}

// Equations phi(u, c, p, q) = 0 with c = u where they close: phi as f above, its first two
// arguments vectors of n. The closing changes with u, as that of a map does not.
template <class Phi>
ZeroProblem plane_problem(Phi phi) {
  using Seed = std::function<First(Eigen::Index)>;
  ZeroProblem problem;
  problem.evaluate = [phi](const Vector& u, Parameters parameters) {
    const double p = parameters[0], q = parameters[1];
    const Eigen::Index n = u.size();
    ZeroEvaluation at;
    at.residual.resize(n);
    Matrix slope(n, 2 * n + 2);
    for (Eigen::Index k = 0; k < 2 * n + 2; ++k) {
      const Seed seed = [&](Eigen::Index i) { return First(u[i % n], i == k ? 1.0 : 0.0); };
      std::vector<First> open, closed;
      for (Eigen::Index i = 0; i < n; ++i) open.push_back(seed(i)), closed.push_back(seed(n + i));
      const auto value =
          phi(open, closed, First(p, k == 2 * n ? 1.0 : 0.0), First(q, k == 2 * n + 1 ? 1.0 : 0.0));
      for (Eigen::Index i = 0; i < n; ++i) {
        at.residual[i] = value[static_cast<std::size_t>(i)].value;
        slope(i, k) = value[static_cast<std::size_t>(i)].slope;
      }
    }
    at.closing = slope.middleCols(n, n);
    at.jacobian = slope.leftCols(n) + at.closing;
    at.by_parameters = slope.rightCols(2);
    return std::optional<ZeroEvaluation>(at);
  };
  // The gradient of w^T dphi/d(u, c) V, V real, 2 n.
  const auto real_curvature = [phi](const Vector& u, double p, double q, const Vector& w,
                                    const Vector& v) {
    const Eigen::Index n = u.size();
    Vector result = Vector::Zero(n + 2);
    for (Eigen::Index k = 0; k < n + 2; ++k) {
      const auto seed = [&](double value, Eigen::Index place, double along) {
        return Second(First(value, place == k ? 1.0 : 0.0), First(along, 0.0));
      };
      std::vector<Second> open, closed;
      for (Eigen::Index i = 0; i < n; ++i) {
        open.push_back(seed(u[i], i, v[i]));
        closed.push_back(seed(u[i], i, v[n + i]));
      }
      const auto value = phi(open, closed, seed(p, n, 0.0), seed(q, n + 1, 0.0));
      for (Eigen::Index i = 0; i < n; ++i)
        result[k] += w[i] * value[static_cast<std::size_t>(i)].slope.slope;
    }
    return result;
  };
  problem.curvature = [real_curvature](const Vector& u, Parameters parameters,
                                       const std::vector<CriticalProduct>& products) {
    const double p = parameters[0], q = parameters[1];
    Eigen::MatrixXcd rows(static_cast<Eigen::Index>(products.size()), u.size() + 2);
    Eigen::Index row = 0;
    for (const CriticalProduct& product : products) {
      ComplexVector right(2 * u.size());
      right << product.right, product.multiplier * product.right;
      const Vector wr = product.left.real(), wi = product.left.imag();
      const Vector vr = right.real(), vi = right.imag();
      const Vector real = real_curvature(u, p, q, wr, vr) - real_curvature(u, p, q, wi, vi);
      const Vector imag = real_curvature(u, p, q, wr, vi) + real_curvature(u, p, q, wi, vr);
      rows.row(row++) =
          (real.cast<Complex>() + Complex(0.0, 1.0) * imag.cast<Complex>()).transpose();
    }
    return std::optional<Eigen::MatrixXcd>(rows);
  };
  return problem;
}

// The ranges [p0, p1] and [q0, q1].
inline LocusOptions plane(double p0, double p1, double q0, double q1) {
  LocusOptions options;
  options.first_from = p0;
  options.first_to = p1;
  options.second_from = q0;
  options.second_to = q1;
  return options;
}

// The locus from a start; what the residuals of its points may be is the options' default.
inline Locus traced(const ZeroProblem& problem, const LocusOptions& options,
                    const LocusStart& start) {
  const std::optional<Locus> locus = trace_locus(problem, options, start);
  EXPECT_TRUE(locus);
  if (!locus) return {};
  for (const LocusPoint& point : locus->points) EXPECT_LE(point.residual, 1e-11);
  // Newton's method doubles digits: a wrong derivative would show in the number of its steps.
  const auto count = static_cast<long long>(locus->points.size());
  EXPECT_LE(locus->evaluations,
            8 * count + 60 * static_cast<long long>(locus->special.size()) + 40);
  return *locus;
}

// The point of a kind that a locus has once.
inline LocusPoint only(const Locus& locus, LocusPointKind kind) {
  const auto list = locus.special_of(kind);
  EXPECT_EQ(list.size(), 1u) << label_of(kind);
  return list.empty() ? LocusPoint{} : list.front().point;
}

// The labels of a locus's special points in order.
inline std::vector<std::string> labels_of(const Locus& locus) {
  std::vector<std::string> labels;
  for (const LocusSpecialPoint& special : locus.special)
    labels.emplace_back(label_of(special.kind));
  return labels;
}

}  // namespace graze::support
