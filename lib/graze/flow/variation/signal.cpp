#include "graze/flow/variation/detail/signal.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "graze/base/linalg/decompositions.hpp"
#include "graze/base/stop_scope.hpp"

namespace graze {

Complex exponential_integral(Complex l, double s) {
  const double growth = std::expm1(l.real() * s), turn = l.imag() * s;
  const double half = std::sin(0.5 * turn);
  const Complex change(growth * std::cos(turn) - 2.0 * half * half,
                       (1.0 + growth) * std::sin(turn));
  return l == 0.0 ? Complex(s) : change / l;
}

namespace {

// Re x Re y = Re(x y + x y*)/2.
double term_integral(const SignalTerm& x, const SignalTerm& y, double s) {
  return 0.5 * (x.size * y.size * exponential_integral(x.rate + y.rate, s) +
                x.size * std::conj(y.size) * exponential_integral(x.rate + std::conj(y.rate), s))
                   .real();
}

}  // namespace

double product_integral(const Signal& a, const Signal& b, double s) {
  double sum = 0.0;
  for (const SignalTerm& x : a)
    for (const SignalTerm& y : b) sum += term_integral(x, y, s);
  return sum;
}

double square_integral(const Signal& a, double s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += term_integral(a[i], a[i], s);
    for (std::size_t j = 0; j < i; ++j) sum += 2.0 * term_integral(a[i], a[j], s);
  }
  return sum;
}

void visit_nodes(double s, double quickest, const std::function<void(double, double)>& visit) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const double panels = std::ceil(std::fmax(quickest * s, 1.0)), half = 0.5 * s / panels;
  for (double k = 0.0; k < panels; ++k) {
    // An interrupted sum has no value.
    if (StopScope::is_over()) return visit(0.0, std::numeric_limits<double>::quiet_NaN());
    const double middle = s * ((k + 0.5) / panels);
    visit(middle, half * Rule::weights()[0]);
    for (std::size_t i = 1; i < Rule::abscissa().size(); ++i)
      for (const double side : {-half, half})
        visit(middle + side * Rule::abscissa()[i], half * Rule::weights()[i]);
  }
}

double panel_integral(const std::function<double(double)>& f, double s, double quickest) {
  double sum = 0.0;
  visit_nodes(s, quickest, [&](double at, double weight) { sum += weight * f(at); });
  return sum;
}

bool nearly_cancels(const Signal& signal) {
  constexpr double apart = 0.25;
  const auto is_near = [&](const SignalTerm& a, Complex size, Complex rate) {
    return std::abs(a.rate - rate) < apart * std::abs(rate) &&
           std::abs(a.size + size) < apart * std::abs(size);
  };
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const SignalTerm& one = signal[i];
    if (one.rate.imag() != 0.0) {
      if (is_near(one, std::conj(one.size), std::conj(one.rate))) return true;
      continue;
    }
    for (std::size_t j = 0; j < i; ++j)
      if (is_near(signal[j], one.size, one.rate)) return true;
  }
  return false;
}

namespace {

// x as large as its inputs' unit u.
double unit_of(const CoupledArc& arc) {
  const FirstOrderSystem& system = arc.flow().first_order();
  const double inputs = arc.load().norm() + system.force.norm();
  const double size = arc.start_state().norm() + inputs / system.generator.norm();
  return size > 0.0 ? size : 1.0;
}

// The terms of each entry of z, in columns; nullopt where some of the motion has none, or they
// nearly cancel.
struct StateTerms {
  std::vector<Complex> rates;
  Eigen::MatrixXcd sizes;
};
std::optional<StateTerms> terms_of(const CoupledArc& arc, double unit) {
  const Vector& scale = arc.flow().scale();
  const Eigen::Index m = scale.size();
  StateTerms terms;
  const auto fill = [&](Eigen::Index column, const Observable<double>& observable) {
    Signal signal;
    const auto add = [&](Complex size, Complex rate) { signal.push_back({size, rate}); };
    if (!arc.each_term(observable, add) || nearly_cancels(signal)) return false;
    const auto count = static_cast<Eigen::Index>(signal.size());
    if (terms.rates.empty()) {
      for (const SignalTerm& term : signal) terms.rates.push_back(term.rate);
      terms.sizes.resize(count, 2 * m + 3);
    }
    for (Eigen::Index k = 0; k < count; ++k)
      terms.sizes(k, column) = signal[static_cast<std::size_t>(k)].size;
    return true;
  };
  Observable<double> observable;
  observable.displacement = observable.velocity = Vector::Zero(m);
  for (Eigen::Index i = 0; i < 2 * m + 3; ++i) {
    Observable<double> one = observable;
    if (i < m) {
      one.displacement[i] = scale[i];
      one.constant = -scale[i] * arc.origin()[i];
    } else if (i < 2 * m) {
      one.velocity[i - m] = 1.0;
    } else if (i < 2 * m + 2) {
      (i == 2 * m ? one.harmonic.re : one.harmonic.im) = i == 2 * m ? unit : -unit;
    } else {
      one.constant = unit;
    }
    if (!fill(i, one)) return {};
  }
  return terms;
}

Matrix integral_of(const StateTerms& terms, double s) {
  const auto count = static_cast<Eigen::Index>(terms.rates.size());
  Eigen::MatrixXcd sums(count, count), differences(count, count);
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index l = 0; l < count; ++l) {
      const Complex a = terms.rates[static_cast<std::size_t>(k)],
                    b = terms.rates[static_cast<std::size_t>(l)];
      sums(k, l) = exponential_integral(a + b, s);
      differences(k, l) = exponential_integral(a + std::conj(b), s);
    }
  // Re x Re y = Re(x y + x y*)/2.
  const Eigen::MatrixXcd left = terms.sizes.transpose();
  return 0.5 * (left * (sums * terms.sizes + differences * terms.sizes.conjugate())).real();
}

// Over h with 2 |E| h <= 1 by the Taylor series of z z^T, of which 18 terms are exact to rounding
// (1/19! < eps); then doubled: the integral over 2h is M(h) + e^(Eh) M(h) e^(Eh)^T.
Matrix doubled_integral(const CoupledArc& arc, double unit, double s) {
  FirstOrderSystem system = arc.flow().first_order();
  system.load = arc.load() / unit;
  system.force /= unit;
  const Matrix whole = extended_generator(system, system.load, s);
  const int doublings = std::clamp(std::ilogb(whole.norm()), -2, 1024) + 2;
  const Matrix generator = std::ldexp(1.0, -doublings) * whole;
  Vector z(whole.rows());
  z << arc.start_state(), unit * std::cos(arc.start_phase()), unit * std::sin(arc.start_phase()),
      unit;
  Matrix term = std::ldexp(s, -doublings) * z * z.transpose();
  Matrix integral = term;
  for (int k = 1; k <= 18; ++k) {
    const Matrix next = generator * term;
    term = (next + next.transpose()) / (k + 1);
    integral += term;
  }
  Matrix step = matrix_exponential(generator);
  for (int k = 0; k < doublings; ++k) {
    integral += (step * integral * step.transpose()).eval();
    step = (step * step).eval();
  }
  return integral;
}

}  // namespace

Moments moments_along(const CoupledArc& arc, double s) {
  const double unit = unit_of(arc);
  const std::optional<StateTerms> terms = terms_of(arc, unit);
  return {terms ? integral_of(*terms, s) : doubled_integral(arc, unit, s), unit};
}

Vector weights_of(const Observable<double>& observable, const CoupledArc& arc,
                  const Moments& moments) {
  const Eigen::Index m = observable.displacement.size();
  Vector weight = Vector::Zero(2 * m + 3);
  weight.head(m) = observable.displacement.cwiseQuotient(arc.flow().scale());
  if (observable.velocity.size() > 0) weight.segment(m, m) = observable.velocity;
  weight.tail(3) << observable.harmonic.re, -observable.harmonic.im,
      observable.constant + observable.displacement.dot(arc.origin());
  weight.tail(3) /= moments.unit;
  return weight;
}

}  // namespace graze
