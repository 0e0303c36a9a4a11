#include "graze/flow/variation/detail/signal.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

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

// Over h with 2 |E| h <= 1 by the Taylor series of z z^T, of which 18 terms are exact to rounding
// (1/19! < eps); then doubled: the integral over 2h is M(h) + e^(Eh) M(h) e^(Eh)^T.
Moments moments_along(const CoupledArc& arc, double s) {
  FirstOrderSystem system = arc.flow().first_order();
  system.load = arc.load();
  const double inputs = system.load.norm() + system.force.norm();
  const double size = arc.start_state().norm() + inputs / system.generator.norm();
  const double unit = size > 0.0 ? size : 1.0;
  system.load /= unit;
  system.force /= unit;
  const Matrix whole = extended_generator(system, system.load, s);
  const int doublings = std::clamp(std::ilogb(whole.norm()), -2, 1024) + 2;
  const Matrix generator = std::ldexp(1.0, -doublings) * whole;
  Vector z(whole.rows());
  z << arc.start_state(), unit * std::cos(arc.start_phase()), unit * std::sin(arc.start_phase()),
      unit;
  Matrix term = std::ldexp(s, -doublings) * z * z.transpose();
  Moments moments{term, unit};
  for (int k = 1; k <= 18; ++k) {
    const Matrix next = generator * term;
    term = (next + next.transpose()) / (k + 1);
    moments.integral += term;
  }
  Matrix step = matrix_exponential(generator);
  for (int k = 0; k < doublings; ++k) {
    moments.integral += (step * moments.integral * step.transpose()).eval();
    step = (step * step).eval();
  }
  return moments;
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
