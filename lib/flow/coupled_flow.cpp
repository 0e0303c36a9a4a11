#include "graze/flow/coupled_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace graze {
namespace {

// Modes may cost 8 of 53 bits: by dependent eigenvectors, or by a response that cancels the motion.
constexpr double kLargestLoss = 256.0;
// Roundings in one term of a curve, as in the decoupled flow.
constexpr double kRoundings = 8.0;

// Largest growth beyond the error of its eigenvalue.
double certain_growth(const Matrix& generator) {
  double growth = 0.0;
  for (const Eigenvalue& l : eigenvalues(generator))
    if (l.value.real() > l.error) growth = std::max(growth, l.value.real());
  return growth;
}

// Norms know nothing of what an observable sees of the motion. Over a short reach h the derivatives
// at hand bound the second one better,
//
//   B(h) = |g^(2)| + |g^(3)| h + |g^(4)| h^2/2 + K_5 h^3/6,
//
// and the h at which the last term alone would just allow a step of h, 2 (|g| + noise) = B h^2, is
// taken where it is longer than the step that the norms allow.
constexpr std::size_t kMostDerivatives = 3 + 5;  // of a curve's derivative 3 or lower

void sharpen(const std::array<double, 3>& derivatives, double last, CurvePoint<double>& point) {
  const double value = std::abs(point.value) + point.noise;
  if (!(value > 0.0) || !(last > 0.0) || !std::isfinite(last)) return;
  const double reach = std::pow(12.0 * (value / last), 0.2);
  if (!(reach > std::sqrt(2.0 * (value / point.bound)))) return;
  const double bound =
      derivatives[0] +
      reach * (derivatives[1] + reach / 2.0 * (derivatives[2] + reach / 3.0 * last));
  if (!(bound < point.bound)) return;
  point.bound = bound;
  point.reach = reach;
}

}  // namespace

CoupledFlow::CoupledFlow(const CoupledSystem& system)
    : scale_(system.scale), frequency_(system.frequency) {
  const Eigen::Index m = scale_.size();
  generator_ = Matrix::Zero(2 * m, 2 * m);
  generator_.topRightCorner(m, m) = scale_.asDiagonal();
  generator_.bottomLeftCorner(m, m) = -system.stiffness * scale_.cwiseInverse().asDiagonal();
  generator_.bottomRightCorner(m, m) = -system.damping;
  load_ = force_ = Vector::Zero(2 * m);
  load_.tail(m) = system.load;
  force_.tail(m) = system.force;
  growth_ = certain_growth(generator_);
  use_modes(system);
  if (has_modes_) return;
  norm_growth_ = std::max(norm_growth_rate(generator_), 0.0);
  if (norm_growth_ > 0.0) longest_flight_ = 1.0 / norm_growth_;
}

std::string CoupledFlow::instability() const {
  if (!(growth_ > 0.0)) return "";
  return fmt::format(
      "held on its stops by an oblique impulse law the structure is unstable (a motion grows at "
      "{:.3g} 1/s); points spread evenly (i L/N) and equal decay rates have no such motion",
      growth_);
}

void CoupledFlow::use_modes(const CoupledSystem& system) {
  modes_ = complex_modes(generator_);
  const Eigen::Index n = generator_.rows();
  if (!(modes_.condition <= kLargestLoss * static_cast<double>(n))) return;
  const ComplexVector load = modes_.inverse * load_.cast<Complex>();
  const ComplexVector force = modes_.inverse * force_.cast<Complex>();
  ComplexVector rest(n), harmonic(n);
  const double quickest = std::max(scale_.maxCoeff(), frequency_);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Complex l = modes_.values[k];
    const Complex detuning = Complex(0.0, frequency_) - l;
    const bool resonant = system.frequency > 0.0 && std::abs(detuning) * kLargestLoss < std::abs(l);
    const bool soft = std::abs(l) * kLargestLoss * kLargestLoss < quickest;
    if (resonant || (soft && load_.squaredNorm() > 0.0)) return;
    rest[k] = load_.squaredNorm() > 0.0 ? -load[k] / l : Complex(0.0);
    harmonic[k] = system.frequency > 0.0 ? force[k] / detuning : Complex(0.0);
  }
  rest_ = (modes_.vectors * rest).real();
  harmonic_ = modes_.vectors * harmonic;
  has_modes_ = true;
}

void CoupledArc::start(double theta, const Vector& y, const Vector& ydot) {
  theta_ = theta;
  y_ = y;
  ydot_ = ydot;
  const CoupledFlow& flow = *flow_;
  x_.resize(2 * y.size());
  x_ << flow.scale_.cwiseProduct(y), ydot;
  if (!flow.has_modes_) return;
  const Vector forced = (flow.harmonic_ * std::polar(1.0, theta)).real();
  amplitude_ = flow.modes_.inverse * (x_ - flow.rest_ - forced).cast<Complex>();
}

void CoupledArc::state(double s, Vector& y, Vector& ydot) const {
  const CoupledFlow& flow = *flow_;
  Vector x;
  if (flow.has_modes_) {
    const ComplexVector grown =
        amplitude_.cwiseProduct((flow.modes_.values * s).array().exp().matrix());
    x = (flow.modes_.vectors * grown).real() + flow.rest_ +
        (flow.harmonic_ * std::polar(1.0, theta_ + flow.frequency_ * s)).real();
  } else {
    x = matrix_state(s);
  }
  y = x.head(y_.size()).cwiseQuotient(flow.scale_);
  ydot = x.tail(y_.size());
}

Matrix CoupledArc::extended_generator(double s) const {
  const CoupledFlow& flow = *flow_;
  const Eigen::Index n = x_.size();
  Matrix extended = Matrix::Zero(n + 3, n + 3);
  extended.topLeftCorner(n, n) = flow.generator_ * s;
  extended.block(0, n, n, 1) = flow.force_ * s;
  extended.block(0, n + 2, n, 1) = flow.load_ * s;
  extended(n, n + 1) = -flow.frequency_ * s;
  extended(n + 1, n) = flow.frequency_ * s;
  return extended;
}

Vector CoupledArc::matrix_state(double s) const {
  const Eigen::Index n = x_.size();
  Vector start(n + 3);
  start << x_, std::cos(theta_), std::sin(theta_), 1.0;
  return (matrix_exponential(extended_generator(s)) * start).head(n);
}

// The extended system is autonomous: a later start is a deviation of (cos theta, sin theta).
Matrix CoupledArc::growth(double s, const Matrix& deviations,
                          const Eigen::RowVectorXd& delay) const {
  const CoupledFlow& flow = *flow_;
  const Eigen::Index n = x_.size(), m = n / 2;
  Vector unit(n);
  unit << flow.scale_, Vector::Ones(m);
  Matrix x = Matrix::Zero(n + 3, deviations.cols());
  x.topRows(n) = unit.asDiagonal() * deviations;
  x.row(n) = -flow.frequency_ * std::sin(theta_) * delay;
  x.row(n + 1) = flow.frequency_ * std::cos(theta_) * delay;
  const Matrix extended = extended_generator(s);
  Matrix sum = Matrix::Zero(x.rows(), x.cols());
  if (extended.norm() < 1.0) {
    // exp - 1 by its series, which keeps short flights accurate; 20! is beyond 1/eps.
    Matrix term = x;
    for (int k = 1; k <= 20; ++k) {
      term = extended * term / k;
      sum += term;
    }
  } else {
    sum = matrix_exponential(extended) * x - x;
  }
  return unit.cwiseInverse().asDiagonal() * sum.topRows(n);
}

Vector CoupledArc::weight_of(const Observable<double>& observable) const {
  const Eigen::Index m = flow_->scale_.size();
  Vector weight = Vector::Zero(2 * m);
  weight.head(m) = observable.displacement.cwiseQuotient(flow_->scale_);
  if (observable.velocity.size() > 0) weight.tail(m) = observable.velocity;
  return weight;
}

std::vector<SignalTerm> CoupledArc::terms(const Observable<double>& observable) const {
  const CoupledFlow& flow = *flow_;
  const Vector weight = weight_of(observable);
  std::vector<SignalTerm> list;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k)
    list.push_back({weight.cast<Complex>().dot(flow.modes_.vectors.col(k)) * amplitude_[k],
                    flow.modes_.values[k]});
  list.push_back({Complex(observable.constant + weight.dot(flow.rest_)), Complex(0.0)});
  if (flow.frequency_ > 0.0)
    list.push_back({(weight.cast<Complex>().dot(flow.harmonic_) +
                     Complex(observable.harmonic.re, observable.harmonic.im)) *
                        std::polar(1.0, theta_),
                    Complex(0.0, flow.frequency_)});
  return list;
}

ArcCurve<double> CoupledArc::curve(const Observable<double>& observable, double window,
                                   bool from_zero) const {
  const CoupledFlow& flow = *flow_;
  CurvePoint<double> start;
  if (!from_zero) start = observed(observable, theta_, y_, ydot_);
  ArcCurve<double> curve(start.value, start.noise, window);
  const Vector weight = weight_of(observable);
  const Complex harmonic(observable.harmonic.re, observable.harmonic.im);
  if (flow.has_modes_)
    add_modes(weight, harmonic, curve);
  else
    curve.add_part(matrix_part(weight, harmonic, window));
  return curve;
}

void CoupledArc::add_modes(const Vector& weight, Complex harmonic, ArcCurve<double>& curve) const {
  const CoupledFlow& flow = *flow_;
  const Vector reference = flow.rest_.cwiseAbs() + flow.harmonic_.cwiseAbs();
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
    const Complex l = flow.modes_.values[k];
    if (l.imag() < 0.0) continue;  // the conjugate of another
    const Complex share =
        (l.imag() > 0.0 ? 2.0 : 1.0) * weight.cast<Complex>().dot(flow.modes_.vectors.col(k));
    const Complex c = share * amplitude_[k];
    const double formed_from =
        std::abs(share) * (flow.modes_.inverse.row(k).cwiseAbs() * (reference + x_.cwiseAbs()))[0];
    // Growth within the rounding of the eigenvalue is none.
    curve.add_exponential({c.real(), c.imag()}, std::max(-l.real(), 0.0), l.imag(), formed_from);
  }
  if (flow.frequency_ > 0.0) {
    const Complex c =
        (weight.cast<Complex>().dot(flow.harmonic_) + harmonic) * std::polar(1.0, theta_);
    curve.add_exponential({c.real(), c.imag()}, 0.0, flow.frequency_, 0.0);
  }
}

// Derivative p of the observable is weight.A^p x + sum_i weight.A^(p-1-i) d^i/dt^i (load + force),
// and |x| grows at most at the rate of its norm.
ArcCurve<double>::Part CoupledArc::matrix_part(const Vector& weight, Complex harmonic,
                                               double window) const {
  const CoupledFlow& flow = *flow_;
  struct Derivative {
    Vector state;           // weight of x
    double constant = 0.0;  // from the load
    Complex phase;          // weight of e^{i theta}
    double bound_of_input = 0.0;
  };
  std::array<Derivative, kMostDerivatives + 1> derivatives;
  derivatives[0] = {weight, 0.0, harmonic, std::abs(harmonic)};
  for (std::size_t p = 1; p < derivatives.size(); ++p) {
    const Derivative& before = derivatives[p - 1];
    Derivative& now = derivatives[p];
    now.state = flow.generator_.transpose() * before.state;
    now.constant = before.state.dot(flow.load_);
    now.phase = before.phase * Complex(0.0, flow.frequency_) + before.state.dot(flow.force_);
    now.bound_of_input = std::abs(now.constant) + std::abs(now.phase);
  }
  return [*this, derivatives, window](double s, int m, Reach reach, CurvePoint<double>& point) {
    const CoupledFlow& system = *flow_;
    const Vector x = matrix_state(s);
    const Complex turn = std::polar(1.0, theta_ + system.frequency_ * s);
    const auto value = [&](std::size_t p) {
      const Derivative& d = derivatives[p];
      return d.state.dot(x) + d.constant + (d.phase * turn).real();
    };
    const auto order = static_cast<std::size_t>(m);
    const Derivative& first = derivatives[0];
    const double start = first.state.dot(x_) + (first.phase * std::polar(1.0, theta_)).real();
    point.value += value(order) - (m == 0 ? start : 0.0);
    point.slope += value(order + 1);
    const double ahead = std::max(window - s, 0.0);
    const double input = system.load_.norm() + system.force_.norm();
    const double size = std::exp(system.norm_growth_ * ahead) * (x.norm() + input * ahead);
    const auto bound = [&](std::size_t p) {
      return derivatives[p].state.norm() * size + derivatives[p].bound_of_input;
    };
    point.bound += bound(order + 2);
    const double formed_from = x_.norm() + input * s;
    point.noise +=
        kRoundings * std::numeric_limits<double>::epsilon() * (1.0 + system.generator_.norm() * s) *
        (derivatives[order].state.norm() * formed_from + derivatives[order].bound_of_input);
    if (reach == Reach::kWindow) return;
    sharpen({std::abs(value(order + 2)), std::abs(value(order + 3)), std::abs(value(order + 4))},
            bound(order + 5), point);
  };
}

}  // namespace graze
