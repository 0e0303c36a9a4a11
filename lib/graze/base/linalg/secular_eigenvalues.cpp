#include "graze/base/linalg/detail/secular_eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/base/linalg/detail/arithmetic.hpp"
#include "graze/base/linalg/detail/linear_equations.hpp"

namespace graze {
namespace {

using Eigen::Index;

// A mode is extinguished when its flow vanishes to the first number over one factor, or to the
// third over all factors while one of them is below the second. Its flow is taken for zero, and
// with it two eigenvalues of M. The others move by less than its size times the ratio of their
// vectors' sizes.
constexpr double kExtinguished = 0x1p-100, kWeak = 0x1p-80, kExtinguishedByAll = 0x1p-200;
constexpr double kProportion = 0x1p20;
// A jump whose determinant is cancelled to this part makes an eigenvalue too small to be found like
// the others.
constexpr double kSingular = 0x1p-40;
// Below this product of its rows of P and Q, a mode's eigenvalues are those of its flow to the last
// digit, and the others do not feel it.
constexpr double kUnfelt = 0x1p-52;

// Steps of all roots: until then conjugate ones stay conjugate and real ones real, which costs half
// as much; those that are not found by then have become others.
constexpr int kMirroredSweeps = 12, kMostSweeps = 60;
// A step below this part of a root that does not become shorter is the root's rounding.
constexpr double kStagnant = 1e-7;

// Relative errors allowed for the sum (of the sum of the moduli) and the product (each): a missing
// root, or one counted twice, changes them by more.
constexpr double kOfSum = 1e-10, kOfEach = 1e-9;

struct Root {
  Complex value;
  double step = std::numeric_limits<double>::infinity();  // the last one's length
  bool settled = false, stagnant = false;
  // True for the root with negative imaginary part of a conjugate pair, which follows the other
  // one.
  bool mirrors = false;
};

class RootSearch {
 public:
  RootSearch(const SecularFunction& function, const std::vector<Index>& modes)
      : function_(function) {
    for (const Index m : modes) {
      const PolePair pair = function.alone(m);
      add(pair.first, false);
      add(pair.second, pair.first.imag() != 0.0);
    }
  }

  bool run() {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
      if (sweep == kMirroredSweeps) release();
      bool all = true;
      for (std::size_t i = 0; i < roots_.size(); ++i) {
        if (roots_[i].settled || roots_[i].mirrors) continue;
        if (!improve(i)) return false;
        all = all && roots_[i].settled;
      }
      if (all) return mirror_released();
    }
    return false;
  }

  const std::vector<Root>& roots() const { return roots_; }

 private:
  // Two modes may start alike; each root keeps a place of its own.
  void add(Complex start, bool mirrors) {
    const double spread = 1.0 + 0x1p-20 * static_cast<double>(1 + roots_.size() / 2);
    roots_.push_back({mirrors ? std::conj(roots_.back().value) : start * spread});
    roots_.back().mirrors = mirrors;
  }

  // One step of a root; false where there is no next value.
  bool improve(std::size_t i) {
    Root& root = roots_[i];
    Complex slope = function_.logarithmic_slope(root.value);
    // On a pole, or on the root itself to the last bit.
    if (!std::isfinite(std::norm(slope))) {
      root.value *= 1.0 + 4.0 * kEpsilon;
      slope = function_.logarithmic_slope(root.value);
      if (!std::isfinite(std::norm(slope))) return false;
    }
    Complex others = 0.0;
    for (std::size_t j = 0; j < roots_.size(); ++j) {
      if (j == i) continue;
      const Complex apart = root.value - roots_[j].value;
      const double size = std::norm(apart);
      if (size > 0.0) others += Complex(apart.real() / size, -apart.imag() / size);
    }
    const Complex step = 1.0 / (slope - others);
    const double length = std::abs(step), size = std::abs(root.value);
    if (!std::isfinite(length)) return false;
    root.value -= step;
    const bool small = length <= kStagnant * size;
    const bool quadratic = small && length * length * std::abs(others) <= kEpsilon * size;
    root.stagnant = !quadratic && small && length >= 0.5 * root.step;
    root.settled = quadratic || root.stagnant || length <= 2.0 * kEpsilon * size;
    root.step = length;
    if (i + 1 < roots_.size() && roots_[i + 1].mirrors) {
      roots_[i + 1].value = std::conj(root.value);
      roots_[i + 1].step = length;
      roots_[i + 1].settled = root.settled;
    }
    return true;
  }

  // From now on each root moves by itself: a conjugate pair may become two real roots, and the
  // other way round.
  void release() {
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      Root& root = roots_[i];
      if (root.settled) continue;
      released_.push_back(i);
      root.mirrors = false;
      const double angle = 2.4 * static_cast<double>(i + 1);
      const double reach = std::min(0.1 * root.step, 0.1 * std::abs(root.value));
      if (std::isfinite(reach)) root.value += std::polar(reach, angle);
    }
  }

  // Makes these roots real or conjugate pairs again. False where one is left over.
  bool mirror_released() {
    std::vector<std::size_t> left = released_;
    while (!left.empty()) {
      Root& root = roots_[left.back()];
      left.pop_back();
      double nearest = 2.0 * std::abs(root.value.imag());
      std::size_t partner = left.size();
      for (std::size_t k = 0; k < left.size(); ++k) {
        const double apart = std::abs(roots_[left[k]].value - std::conj(root.value));
        if (apart < nearest) {
          nearest = apart;
          partner = k;
        }
      }
      if (nearest > 1e-3 * kStagnant * std::abs(root.value) && nearest > 16.0 * root.step)
        return false;
      if (partner == left.size()) {
        root.value = root.value.real();
        root.step = std::max(root.step, nearest);
        continue;
      }
      Root& other = roots_[left[partner]];
      root.value = 0.5 * (root.value + std::conj(other.value));
      other.value = std::conj(root.value);
      root.step = other.step = std::max({root.step, other.step, nearest});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(partner));
    }
    return true;
  }

  const SecularFunction& function_;
  std::vector<Root> roots_;
  std::vector<std::size_t> released_;
};

// Whether 1 + P Q^T may be singular: its determinant is that of the small 1 + Q^T P, compared with
// the terms that make up its diagonal.
bool is_singular(const JumpAndFlow& factor) {
  const Index rank = factor.from.cols();
  const Matrix added = factor.to.transpose() * factor.from;
  const double terms = (1.0 + added.diagonal().array().abs()).prod();
  return !(LuFactors(Matrix::Identity(rank, rank) + added).determinant_size() > kSingular * terms);
}

double flow_size(const JumpAndFlow& factor, Index m) {
  return std::hypot(factor.qq[m], factor.qv[m], std::hypot(factor.vq[m], factor.vv[m]));
}

// Takes the flows of extinguished modes for zero. Returns a bound on the change of an eigenvalue.
double extinguish(std::vector<JumpAndFlow>& factors) {
  double largest = 0.0;
  for (Index m = 0; m < factors.front().qq.size(); ++m) {
    double all = 1.0, smallest = std::numeric_limits<double>::infinity();
    JumpAndFlow* weakest = nullptr;
    for (JumpAndFlow& factor : factors) {
      const double size = flow_size(factor, m);
      all *= size;
      if (size >= smallest) continue;
      smallest = size;
      weakest = &factor;
    }
    if (smallest >= kWeak || (smallest >= kExtinguished && all >= kExtinguishedByAll)) continue;
    weakest->qq[m] = weakest->qv[m] = weakest->vq[m] = weakest->vv[m] = 0.0;
    largest = std::max(largest, kProportion * smallest);
  }
  return largest;
}

// Which modes are searched, and which eigenvalues are known without a search.
struct Parts {
  std::vector<Index> searched;
  std::vector<Eigenvalue> known;  // eigenvalues of the modes that are not searched
};

Parts parts_of(const std::vector<JumpAndFlow>& factors, SecularFunction& function,
               double roundings) {
  Parts parts;
  const Index n = function.modes();
  for (Index m = 0; m < n; ++m) {
    double given = 0.0, taken = 0.0, uncertainty = roundings;
    for (const JumpAndFlow& factor : factors) {
      given = std::max(given, std::hypot(factor.from.row(m).norm(), factor.from.row(n + m).norm()));
      taken = std::max(taken, std::hypot(factor.to.row(m).norm(), factor.to.row(n + m).norm()));
      uncertainty += factor.uncertainty[m];
    }
    if (given * taken > kUnfelt && function.flow_norm(m) > 0.0) {
      parts.searched.push_back(m);
      continue;
    }
    function.leave_out(m);
    const PolePair& pole = function.poles()[static_cast<std::size_t>(m)];
    const double error = kEpsilon * uncertainty * function.flow_norm(m);
    parts.known.push_back({pole.first, error});
    parts.known.push_back({pole.second, error});
  }
  return parts;
}

// Whether the roots found are all: by the trace of M, and by the determinant of mu - M at a mu
// nearer to zero than any of them.
bool is_complete(const SecularFunction& function, const Parts& parts,
                 const std::vector<Root>& roots) {
  Complex sum = 0.0;
  double moduli = 0.0, smallest = std::numeric_limits<double>::infinity();
  for (const Eigenvalue& value : parts.known) sum += value.value;
  for (const Root& root : roots) {
    sum += root.value;
    moduli += std::abs(root.value);
    smallest = std::min(smallest, std::abs(root.value));
  }
  if (!(std::abs(sum - function.trace()) <= kOfSum * moduli)) return false;
  const Complex beside(0.0, 0.25 * smallest);
  double logarithm = 0.0, tolerance = 0.0;
  for (const Root& root : roots) logarithm += std::log(std::abs(beside - root.value));
  for (const Index m : parts.searched) {
    const PolePair& pole = function.poles()[static_cast<std::size_t>(m)];
    const double smaller = std::min(std::abs(pole.first), std::abs(pole.second));
    tolerance += 2.0 * kOfEach + 16.0 * kEpsilon * function.flow_norm(m) / smaller;
  }
  return std::abs(logarithm - function.log_modulus(beside)) <= tolerance;
}

// A root that settled at its rounding is off by its last step.
double error_of(const SecularFunction& function, const Root& root, double roundings) {
  const double first_order = function.first_order_error(root.value, roundings);
  return std::isnan(first_order) ? std::numeric_limits<double>::infinity()
                                 : std::max(first_order, root.stagnant ? root.step : 0.0);
}

}  // namespace

std::optional<std::vector<Eigenvalue>> secular_eigenvalues(const std::vector<JumpAndFlow>& factors,
                                                           ErrorBounds errors) {
  for (const JumpAndFlow& factor : factors)
    if (!factor.from.allFinite() || !factor.to.allFinite() || !factor.qq.allFinite() ||
        !factor.qv.allFinite() || !factor.vq.allFinite() || !factor.vv.allFinite())
      return {};
  for (const JumpAndFlow& factor : factors)
    if (is_singular(factor)) return {};
  std::vector<JumpAndFlow> kept = factors;
  const double least_error = extinguish(kept);
  SecularFunction function(kept);
  const double roundings = 2.0 * static_cast<double>(function.modes());
  const Parts parts = parts_of(kept, function, roundings);
  RootSearch search(function, parts.searched);
  if (!search.run() || !is_complete(function, parts, search.roots())) return {};
  std::vector<Eigenvalue> list = parts.known;
  for (const Root& root : search.roots()) {
    // Conjugate ones have one error.
    const bool second =
        !list.empty() && root.value.imag() != 0.0 && list.back().value == std::conj(root.value);
    double error = 0.0;
    if (errors == ErrorBounds::kGiven)
      error = second ? list.back().error : error_of(function, root, roundings);
    list.push_back({root.value, error});
  }
  for (Eigenvalue& value : list)
    value.error = errors == ErrorBounds::kGiven ? std::max(value.error, least_error) : 0.0;
  sort_eigenvalues(list);
  return list;
}

}  // namespace graze
