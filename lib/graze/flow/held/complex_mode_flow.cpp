#include "graze/flow/held/detail/complex_mode_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {
std::optional<ComplexModes> usable_modes(const FirstOrderSystem& system, double quickest) {
  ComplexModes modes = complex_modes(system.generator);
  if (!(modes.condition <= kLargestLoss * static_cast<double>(system.load.size()))) return {};
  const bool loaded = system.load.squaredNorm() > 0.0;
  for (const Complex l : modes.values) {
    const bool resonant = system.frequency > 0.0 &&
                          std::abs(Complex(0.0, system.frequency) - l) * kLargestLoss < std::abs(l);
    const bool soft = std::abs(l) * kLargestLoss * kLargestLoss < quickest;
    if (resonant || (soft && loaded)) return {};
  }
  return modes;
}

ComplexModeFlow::ComplexModeFlow(const FirstOrderSystem& system, ComplexVector values,
                                 Eigen::MatrixXcd vectors, Eigen::MatrixXcd inverse)
    : frequency_(system.frequency),
      values_(std::move(values)),
      vectors_(std::move(vectors)),
      inverse_(std::move(inverse)) {
  // A mode without load may have no rate to divide by.
  ComplexVector rest = inverse_ * system.load.cast<Complex>();
  ComplexVector harmonic = inverse_ * system.force.cast<Complex>();
  for (Eigen::Index k = 0; k < values_.size(); ++k) {
    rest[k] = system.load.squaredNorm() > 0.0 ? -rest[k] / values_[k] : Complex(0.0);
    harmonic[k] = frequency_ > 0.0 ? harmonic[k] / (Complex(0.0, frequency_) - values_[k]) : 0.0;
  }
  rest_ = (vectors_ * rest).real();
  harmonic_ = vectors_ * harmonic;
}

void ComplexModeArc::start(double theta, const Vector& x) {
  theta_ = theta;
  const ComplexModeFlow& flow = *flow_;
  const Vector forced = (flow.harmonic_ * std::polar(1.0, theta)).real();
  amplitude_ = flow.inverse_ * (x - flow.rest_ - forced).cast<Complex>();
  formed_from_ =
      flow.inverse_.cwiseAbs() * (flow.rest_.cwiseAbs() + flow.harmonic_.cwiseAbs() + x.cwiseAbs());
}

Vector ComplexModeArc::state(double s) const {
  const ComplexModeFlow& flow = *flow_;
  const ComplexVector grown = amplitude_.cwiseProduct((flow.values_ * s).array().exp().matrix());
  return (flow.vectors_ * grown).real() + flow.rest_ +
         (flow.harmonic_ * std::polar(1.0, theta_ + flow.frequency_ * s)).real();
}

Complex ComplexModeArc::add_to(ArcCurve<double>& curve, const Vector& weight) const {
  const ComplexModeFlow& flow = *flow_;
  for (Eigen::Index k = 0; k < amplitude_.size(); ++k) {
    const Complex l = flow.values_[k];
    if (l.imag() < 0.0) continue;  // the conjugate of another
    const Complex share =
        (l.imag() > 0.0 ? 2.0 : 1.0) * weight.cast<Complex>().dot(flow.vectors_.col(k));
    const Complex c = share * amplitude_[k];
    // Growth within the rounding of the eigenvalue is none.
    curve.add_exponential({c.real(), c.imag()}, std::max(-l.real(), 0.0), l.imag(),
                          std::abs(share) * formed_from_[k]);
  }
  return weight.cast<Complex>().dot(flow.harmonic_);
}

}  // namespace graze
