#include "graze/continuation/normal_form.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "graze/continuation/branch/detail/bordering.hpp"
#include "graze/continuation/branch/detail/corrector.hpp"
#include "graze/continuation/switching.hpp"

namespace graze {
namespace {

// Distances from which a value is extrapolated, each twice the one before. Rounding falls by their
// second or third power; beside a grazing the smallest are needed.
constexpr double kNearest = 0x1p-21;
constexpr int kDoublings = 17;
// A value that three distances agree on to this part is settled, and larger ones are left out once
// they differ so many times more. One that none agree on to the last part is not known.
constexpr double kSettled = 1e-4;
constexpr double kGrown = 30.0;
constexpr double kTold = 1e-2;
// Residual of solutions beside the point, whose distance from it in the parameter is small.
constexpr double kExact = 1e-14;
constexpr Complex kI(0.0, 1.0);

// Solutions beside the point, to the last digits.
ContinuationOptions exact(ContinuationOptions options) {
  options.residual_tolerance = std::min(options.residual_tolerance, kExact);
  return options;
}

// Weights of the multiples k of a distance by which even values over k^2 (and odd ones over k) are
// extrapolated to zero.
constexpr int kDistances = 5;
double weight_of(int k) {
  double weight = 1.0;
  for (int j = 1; j <= kDistances; ++j)
    if (j != k) weight *= static_cast<double>(j * j) / static_cast<double>(j * j - k * k);
  return weight;
}

// a2 of e(x) = a2 x^2 + a4 x^4 + .., from multiples of a distance: the polynomial through e/x^2 at
// 0.
std::optional<double> extrapolated(const std::function<std::optional<double>(double)>& even,
                                   double x) {
  double sum = 0.0;
  for (int k = 1; k <= kDistances; ++k) {
    const std::optional<double> there = even(k * x);
    if (!there) return {};
    sum += weight_of(k) * *there / (k * k * x * x);
  }
  return sum;
}

// The value where three distances in a row agree best, and by how much they differ. From small
// distances, where rounding decides, to larger ones, up to where the differences grow again: beyond
// a grazing or another change of the motion values may agree that are those of something else.
struct DifferenceSum {
  double value = 0.0, size = 0.0;  // that of what was added
};
struct Refined {
  double value, change;
};
std::optional<Refined> refined(const std::function<std::optional<DifferenceSum>(double)>& over) {
  std::optional<Refined> best;
  std::optional<DifferenceSum> before, last;
  double x = kNearest, size = 0.0;
  for (int i = 0; i < kDoublings; ++i, x *= 2.0) {
    const std::optional<DifferenceSum> here = over(x);
    if (here && last && before) {
      const double change =
          std::max(std::abs(here->value - last->value), std::abs(last->value - before->value));
      if (!best || change < best->change) {
        best = Refined{last->value, change};
        size = last->size;
      }
      if (best->change <= kSettled * size && change > kGrown * best->change) break;
    }
    before = last;
    last = here;
  }
  return best && best->change <= kTold * size ? best : std::nullopt;
}

std::optional<NormalForm> opening_of(const std::function<std::optional<double>(double)>& even) {
  const auto best = refined([&](double x) -> std::optional<DifferenceSum> {
    const auto value = extrapolated(even, x);
    return value ? std::optional(DifferenceSum{*value, std::abs(*value)}) : std::nullopt;
  });
  return best ? std::optional(NormalForm{0.0, best->value, best->change}) : std::nullopt;
}

// The null vectors of A(mu), |q| = 1 and p so that p.rate q = 1. `rate`: -closing.
template <class Scalar>
struct CriticalVectors {
  using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  Column left, right;
};
template <class Scalar>
std::optional<CriticalVectors<Scalar>> critical_vectors(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& critical, const Matrix& rate) {
  // A map's may vanish; the rate is of the size of the entries that it is made of.
  const BorderedMatrix<Scalar> bordered(critical, first_borders<Scalar>(critical, rate.norm()));
  if (!bordered.finite()) return {};
  CriticalVectors<Scalar> vectors{bordered.left(), bordered.right().normalized()};
  const Scalar pairing = vectors.left.cwiseProduct(rate * vectors.right).sum();
  if (pairing == 0.0) return {};
  vectors.left /= pairing;
  return vectors;
}

std::optional<CriticalVectors<double>> critical_vectors(const ZeroEvaluation& at,
                                                        double multiplier) {
  if (at.closing.size() == 0) return {};
  return critical_vectors<double>(at.jacobian + (multiplier - 1.0) * at.closing, -at.closing);
}

// G(x, y) = 0 where y follows x, from the equations of two periods: its derivatives by x and y, n x
// 2 n, at a distance along a direction from the solution.
class OnePeriod {
 public:
  OnePeriod(const ZeroProblem& doubled, const Vector& twice, Parameters at)
      : doubled_(doubled), twice_(twice), at_(at) {}

  std::optional<Matrix> slope(double distance, const Vector& along) const {
    const auto there = doubled_.evaluate(twice_ + distance * along, at_);
    return there ? std::optional<Matrix>(there->jacobian.topRows(twice_.size() / 2)) : std::nullopt;
  }

  // The first and second derivative of the slope along a direction, from multiples of a distance.
  struct Bend {
    Matrix first, second;
  };
  std::optional<Bend> bend(const Matrix& here, const Vector& along, double distance) const {
    Bend sum{0.0 * here, 0.0 * here};
    for (int k = 1; k <= kDistances; ++k) {
      const double s = k * distance;
      const auto ahead = slope(s, along), behind = slope(-s, along);
      if (!ahead || !behind) return {};
      sum.first += weight_of(k) / (2.0 * s) * (*ahead - *behind);
      sum.second += weight_of(k) / (s * s) * (*ahead + *behind - 2.0 * here);
    }
    return sum;
  }

 private:
  const ZeroProblem& doubled_;
  const Vector& twice_;
  Parameters at_;
};

// The centre manifold z q + conj + h20 z^2/2 + h11 |z|^2 + ..: each power of z in G(x, y) = 0, with
// vectors of pairs (x, y).
std::optional<DifferenceSum> coefficient_from(const ZeroProblem& doubled, const Vector& twice,
                                              Parameters at, Complex multiplier, double distance) {
  const Eigen::Index n = twice.size() / 2;
  const OnePeriod equations(doubled, twice, at);
  const std::optional<Matrix> here = equations.slope(0.0, Vector::Zero(2 * n));
  if (!here || 2 * here->rows() != here->cols()) return {};
  const Matrix by_x = here->leftCols(n), by_y = here->rightCols(n);
  const auto pencil = [&](Complex mu) -> Eigen::MatrixXcd {
    return by_x.cast<Complex>() + mu * by_y.cast<Complex>();
  };
  const auto pair = [](const ComplexVector& x, Complex mu) {
    ComplexVector both(2 * x.size());
    both << x, mu * x;
    return both;
  };
  const auto critical = critical_vectors<Complex>(pencil(multiplier), -by_y);
  if (!critical) return {};
  const ComplexVector q = pair(critical->right, multiplier);
  const auto real = equations.bend(*here, q.real(), distance),
             imaginary = equations.bend(*here, q.imag(), distance);
  if (!real || !imaginary) return {};
  const Eigen::MatrixXcd with_q = real->first.cast<Complex>() + kI * imaginary->first;
  const ComplexVector cubic = (real->second + imaginary->second) * q;  // C(q, q, conj q)
  const Complex square = multiplier * multiplier;
  const ComplexVector h11 = solve(pencil(1.0), -with_q * q.conjugate()),
                      h20 = solve(pencil(square), -with_q * q);
  const ComplexVector terms[] = {0.5 * cubic, with_q * pair(h11, 1.0),
                                 0.5 * (with_q.conjugate() * pair(h20, square))};
  DifferenceSum a;
  for (const ComplexVector& term : terms) {
    const Complex part = std::conj(multiplier) * critical->left.cwiseProduct(term).sum();
    a.value += part.real();
    a.size += std::abs(part.real());
  }
  return std::isfinite(a.size) ? std::optional(a) : std::nullopt;
}

std::optional<Refined> refined_coefficient(const ZeroProblem& doubled, const Vector& twice,
                                           Parameters at, Complex multiplier) {
  return refined(
      [&](double distance) { return coefficient_from(doubled, twice, at, multiplier, distance); });
}

// How fast the modulus of a multiplier on the circle changes with the parameter along the branch.
std::optional<double> modulus_rate(const ZeroProblem& problem, const ContinuationOptions& options,
                                   const SolutionPoint& at, Complex multiplier) {
  if (!problem.multipliers) return {};
  Corrector corrector(problem, options);
  const auto modulus_at = [&](double s) -> std::optional<double> {
    const auto there = corrector.on_hyperplane(corrector.pack(at) + s * at.tangent, at.tangent);
    if (!there) return {};
    const auto list = problem.multipliers(there->u, there->parameters(), ErrorBounds::kLeftOut);
    const auto critical = nearest_to(list, multiplier);
    return critical == list.end() ? std::nullopt : std::optional(std::abs(critical->value));
  };
  const auto rate = refined([&](double distance) -> std::optional<DifferenceSum> {
    double sum = 0.0;
    for (int k = 1; k <= kDistances; ++k) {
      const auto ahead = modulus_at(k * distance), behind = modulus_at(-k * distance);
      if (!ahead || !behind) return {};
      sum += weight_of(k) / (2.0 * k * distance) * (*ahead - *behind);
    }
    return DifferenceSum{sum, std::abs(sum)};
  });
  const double moved = at.rate() * corrector.range();
  return rate && moved != 0.0 ? std::optional(rate->value / moved) : std::nullopt;
}

}  // namespace

std::optional<NormalForm> fold_form(const ZeroProblem& problem, const ContinuationOptions& options,
                                    const SolutionPoint& fold) {
  const auto here = problem.evaluate(fold.u, fold.parameters());
  const auto vectors = here ? critical_vectors(*here, 1.0) : std::nullopt;
  if (!vectors) return {};
  const ContinuationOptions beside = exact(options);
  Corrector corrector(problem, beside);
  Vector along(fold.tangent.size());
  along << vectors->right, 0.0;
  const auto even = [&](double x) -> std::optional<double> {
    double sum = 0.0;
    for (const double side : {x, -x}) {
      const auto there = corrector.on_hyperplane(corrector.pack(fold) + side * along, along);
      if (!there) return {};
      sum += 0.5 * (there->parameter - fold.parameter);
    }
    return sum;
  };
  std::optional<NormalForm> form = opening_of(even);
  if (form) form->coefficient = -vectors->left.dot(here->by_parameters.col(0)) * form->opening;
  return form;
}

std::optional<NormalForm> doubling_form(const ZeroProblem& problem,
                                        const ContinuationOptions& options,
                                        const SolutionPoint& doubling, const ZeroProblem& doubled,
                                        const SolutionPoint& twice) {
  const std::optional<double> rate = modulus_rate(problem, options, doubling, -1.0);
  if (twice.u.size() == 2 * doubling.u.size()) {
    const auto best = refined_coefficient(doubled, twice.u, twice.parameters(), -1.0);
    if (!rate || !best) return {};
    return NormalForm{-best->value / 3.0, -best->value / (3.0 * *rate), best->change};
  }
  // From doubled orbits x q away from the branch.
  const std::optional<SolutionPoint> start = other_branch(doubled, options, twice);
  if (!rate || !start) return {};
  const ContinuationOptions beside = exact(options);
  Corrector corrector(doubled, beside);
  Vector along = start->tangent;
  along[along.size() - 1] = 0.0;
  along /= along.head(doubling.u.size()).norm();
  const double length = along.norm();
  const auto even = [&](double x) -> std::optional<double> {
    const auto there =
        corrector.on_hyperplane(corrector.pack(twice) + x * along, Vector(along / length));
    return there ? std::optional(there->parameter - twice.parameter) : std::nullopt;
  };
  std::optional<NormalForm> form = opening_of(even);
  if (form) form->coefficient = *rate * form->opening;
  return form;
}

std::optional<NormalForm> torus_form(const ZeroProblem& problem, const ContinuationOptions& options,
                                     const SolutionPoint& torus, Complex multiplier,
                                     const ZeroProblem& doubled, const SolutionPoint& twice) {
  if (twice.u.size() != 2 * torus.u.size()) return {};
  multiplier /= std::abs(multiplier);
  const std::optional<double> rate = modulus_rate(problem, options, torus, multiplier);
  const auto best = refined_coefficient(doubled, twice.u, twice.parameters(), multiplier);
  if (!rate || !best) return {};
  return NormalForm{best->value, -best->value / *rate, best->change};
}

std::optional<double> cubic_coefficient(const ZeroProblem& doubled, const Vector& twice,
                                        Parameters at, Complex multiplier) {
  const auto best = refined_coefficient(doubled, twice, at, multiplier);
  return best ? std::optional(best->value) : std::nullopt;
}

}  // namespace graze
