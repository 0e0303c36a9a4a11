#include "graze/base/real_schur.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

using Eigen::Index;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Iterations on one eigenvalue after which the usual shifts are taken to go round in circles, and
// after which the iteration is given up. Of a badly scaled matrix the first eigenvalue takes
// twenty; other shifts than the usual ones on the way would undo what they have reached.
constexpr int kExceptional = 30, kMostIterations = 300;

// Two shifts: those with the sum x + y and the product x y - w.
struct Shifts {
  double x, y, w;
};

class Iteration {
 public:
  Iteration(Eigen::Ref<Matrix>& h, SchurPart part) : h_(h), whole_(part == SchurPart::kWhole) {}

  bool run() {
    // Entries this small are nothing beside any eigenvalue that the matrix determines.
    negligible_ = std::max(h_.cwiseAbs().maxCoeff() * kEpsilon * kEpsilon,
                           std::numeric_limits<double>::min());
    Index last = h_.rows() - 1;
    int iterations = 0;
    while (last >= 0) {
      const Index first = first_of_block(last);
      if (last - first < 2) {
        if (last > first) split(first);
        last = first - 1;
        iterations = 0;
        continue;
      }
      if (++iterations > kMostIterations) return false;
      const Shifts shifts = shifts_of(last, iterations);
      double p = 0.0, q = 0.0, r = 0.0;
      const Index start = start_of_step(first, last, shifts, p, q, r);
      step(first, start, last, p, q, r);
    }
    return true;
  }

 private:
  // The first row of the block that ends at `last`; sets to zero what is negligible above it.
  Index first_of_block(Index last) {
    for (Index i = last; i > 0; --i) {
      const double size = std::abs(h_(i - 1, i - 1)) + std::abs(h_(i, i));
      if (std::abs(h_(i, i - 1)) <= std::max(kEpsilon * size, negligible_)) {
        h_(i, i - 1) = 0.0;
        return i;
      }
    }
    return 0;
  }

  // Makes the block at rows i, i + 1 triangular where its eigenvalues are real.
  void split(Index i) {
    const double half = 0.5 * (h_(i, i) - h_(i + 1, i + 1));
    const double square = half * half + h_(i + 1, i) * h_(i, i + 1);
    if (square < 0.0) return;
    const double root = std::sqrt(square);
    const double along = half + std::copysign(root, half), below = h_(i + 1, i);
    const double length = std::hypot(along, below);
    if (!(length > 0.0)) return;
    const double c = along / length, s = below / length;
    const Index end = whole_ ? h_.cols() : i + 2;
    for (Index j = i; j < end; ++j) {
      const double a = h_(i, j), b = h_(i + 1, j);
      h_(i, j) = c * a + s * b;
      h_(i + 1, j) = c * b - s * a;
    }
    for (Index k = whole_ ? 0 : i; k < i + 2; ++k) {
      const double a = h_(k, i), b = h_(k, i + 1);
      h_(k, i) = c * a + s * b;
      h_(k, i + 1) = c * b - s * a;
    }
    h_(i + 1, i) = 0.0;
  }

  // The eigenvalues of the last two rows, or now and then Wilkinson's numbers in their place.
  Shifts shifts_of(Index last, int iteration) const {
    const double x = h_(last, last);
    if (iteration % kExceptional != 0)
      return {x, h_(last - 1, last - 1), h_(last, last - 1) * h_(last - 1, last)};
    const double s = std::abs(h_(last, last - 1)) + std::abs(h_(last - 1, last - 2));
    return {x + 0.75 * s, x + 0.75 * s, -0.4375 * s * s};
  }

  // The row a step may start at, because two entries in a row below the diagonal are small there,
  // and the first column of the shifted matrix.
  Index start_of_step(Index first, Index last, const Shifts& shifts, double& p, double& q,
                      double& r) const {
    for (Index m = last - 2;; --m) {
      const double z = h_(m, m), next = h_(m + 1, m + 1);
      const double from_x = shifts.x - z, from_y = shifts.y - z;
      p = (from_x * from_y - shifts.w) / h_(m + 1, m) + h_(m, m + 1);
      q = next - z - from_x - from_y;
      r = h_(m + 2, m + 1);
      const double size = std::abs(p) + std::abs(q) + std::abs(r);
      if (size > 0.0) {
        p /= size;
        q /= size;
        r /= size;
      }
      if (m == first) return m;
      const double around = std::abs(h_(m - 1, m - 1)) + std::abs(z) + std::abs(next);
      if (std::abs(h_(m, m - 1)) * (std::abs(q) + std::abs(r)) <= kEpsilon * std::abs(p) * around)
        return m;
    }
  }

  // Chases the bulge that the reflection along (p, q, r) makes at row `start` down to `last`.
  void step(Index first, Index start, Index last, double p, double q, double r) {
    for (Index k = start; k < last; ++k) {
      const bool three = k + 1 < last;
      double size = 1.0;
      if (k > start) {
        p = h_(k, k - 1);
        q = h_(k + 1, k - 1);
        r = three ? h_(k + 2, k - 1) : 0.0;
        size = std::abs(p) + std::abs(q) + std::abs(r);
        if (size == 0.0) continue;
        p /= size;
        q /= size;
        r /= size;
      }
      const double length = std::copysign(std::sqrt(p * p + q * q + r * r), p);
      if (length == 0.0) continue;
      if (k > start) {
        h_(k, k - 1) = -length * size;
        h_(k + 1, k - 1) = 0.0;
        if (three) h_(k + 2, k - 1) = 0.0;
      } else if (start > first) {
        h_(k, k - 1) = -h_(k, k - 1);
      }
      p += length;
      if (three)
        reflect_three(k, first, last, p / length, q / length, r / length, q / p, r / p);
      else
        reflect_two(k, first, last, p / length, q / length, q / p);
    }
  }

  // I - (x, y, z)^T (1, q, r) on rows and columns k, k + 1, k + 2.
  void reflect_three(Index k, Index first, Index last, double x, double y, double z, double q,
                     double r) {
    const Index end = whole_ ? h_.cols() : last + 1;
    for (Index j = k; j < end; ++j) {
      double* c = &h_(k, j);
      const double dot = c[0] + q * c[1] + r * c[2];
      c[0] -= dot * x;
      c[1] -= dot * y;
      c[2] -= dot * z;
    }
    double *a = &h_(0, k), *b = &h_(0, k + 1), *c = &h_(0, k + 2);
    const Index stop = std::min(last, k + 3);
    for (Index i = whole_ ? 0 : first; i <= stop; ++i) {
      const double dot = x * a[i] + y * b[i] + z * c[i];
      a[i] -= dot;
      b[i] -= dot * q;
      c[i] -= dot * r;
    }
  }

  void reflect_two(Index k, Index first, Index last, double x, double y, double q) {
    const Index end = whole_ ? h_.cols() : last + 1;
    for (Index j = k; j < end; ++j) {
      double* c = &h_(k, j);
      const double dot = c[0] + q * c[1];
      c[0] -= dot * x;
      c[1] -= dot * y;
    }
    double *a = &h_(0, k), *b = &h_(0, k + 1);
    for (Index i = whole_ ? 0 : first; i <= last; ++i) {
      const double dot = x * a[i] + y * b[i];
      a[i] -= dot;
      b[i] -= dot * q;
    }
  }

  Eigen::Ref<Matrix>& h_;
  bool whole_;
  double negligible_ = 0.0;
};

}  // namespace

bool reduce_to_schur_form(Eigen::Ref<Matrix> hessenberg, SchurPart part) {
  if (hessenberg.size() == 0) return true;
  const double size = hessenberg.cwiseAbs().maxCoeff();
  if (!hessenberg.allFinite()) return false;
  if (size == 0.0) return true;
  // By a power of two: squares of entries must not leave the range. In two halves, which are
  // representable.
  const int exponent = std::ilogb(size);
  hessenberg *= std::ldexp(1.0, -(exponent / 2));
  hessenberg *= std::ldexp(1.0, -(exponent - exponent / 2));
  const bool converged = Iteration(hessenberg, part).run();
  hessenberg *= std::ldexp(1.0, exponent / 2);
  hessenberg *= std::ldexp(1.0, exponent - exponent / 2);
  return converged;
}

}  // namespace graze
