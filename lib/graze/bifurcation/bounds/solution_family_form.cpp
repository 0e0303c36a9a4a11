#include "graze/bifurcation/bounds/detail/solution_family_form.hpp"

#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {

std::optional<SolutionFamilyForm> SolutionFamilyForm::over(const SystemForms& system, int stop,
                                                           int period, int family) {
  const auto form = one_impact_form(system, stop, period);
  if (!form || form->free_mass || form->free_speed || form->has_factors) return {};
  const MeanValueForm fold = form->fold_function();
  if (!(fold.value.low > 0.0) || !(fold.middle.low > 0.0)) return {};
  for (std::size_t j = 0; j < system.omega.size(); ++j) {
    if (!system.delta[j].is_exactly(0.0)) continue;
    const double omega = system.omega[j].middle.middle();
    const double frequency = system.frequency.middle.middle();
    if (std::sin(0.5 * omega * kTurn * period / frequency) < 0.0) family = -family;
    if (omega < frequency) family = -family;
  }
  const MeanValueForm root = square_root(fold) * static_cast<double>(family);
  const MeanValueForm& d = form->approached;
  const MeanValueForm k = form->kick * form->displaced, m = square(d) + square(k);
  const MeanValueForm forced = square(form->forced_real) + square(form->forced_imaginary);
  const MeanValueForm size = m * forced;
  if (!(size.value.low > 0.0) || !(size.middle.low > 0.0)) return {};
  SolutionFamilyForm solution;
  solution.stop_ = stop;
  solution.period_ = period;
  solution.speed_ = -(system.frequency * (form->level * k + root) / m);
  const auto& restitution = system.stops[static_cast<std::size_t>(stop)].restitution;
  solution.impulse_ = solution.speed_ * (restitution.front() + 1.0);
  // e^{i theta} = (a D + i s sqrt(F))/N with N = A (D - i K), 1/N its conjugate over |N|^2.
  const MeanValueForm n_real = form->forced_real * d + form->forced_imaginary * k;
  const MeanValueForm n_imaginary = form->forced_imaginary * d - form->forced_real * k;
  const MeanValueForm contact = form->level * d;
  solution.turned_real_ = (contact * n_real + root * n_imaginary) / size;
  solution.turned_imaginary_ = (root * n_real - contact * n_imaginary) / size;
  return solution;
}

std::optional<MeanValueForm> SolutionFamilyForm::gap(const SystemForms& system, int stop,
                                                     double part) const {
  const SystemForms::Stop& at = system.stops[static_cast<std::size_t>(stop)];
  const SystemForms::Stop& by = system.stops[static_cast<std::size_t>(stop_)];
  const MeanValueForm duration = inverse(system.frequency) * (kTurn * period_);
  MeanValueForm real = 0.0, imaginary = 0.0, pushed = 0.0, gap = at.gap;
  for (std::size_t j = 0; j < system.omega.size(); ++j) {
    const MeanValueForm &omega = system.omega[j], &delta = system.delta[j];
    const MeanValueForm x = (omega - system.frequency) * (omega + system.frequency);
    const MeanValueForm y = delta * system.frequency * 2.0, size = square(x) + square(y);
    if (!(size.value.low > 0.0) || !(size.middle.low > 0.0)) return {};
    const MeanValueForm over = at.row[j] * system.amplitude[j] / size;
    real = real + x * over;
    imaginary = imaginary - y * over;
    const auto left = repeated_impulse(omega, delta, duration, part);
    if (!left) return {};
    pushed = pushed + at.row[j] * by.direction[j] * *left;
    if (!system.load[j].is_exactly(0.0)) gap = gap - at.row[j] * system.load[j] / square(omega);
  }
  const double turned = kTurn * period_ * part;
  const MeanValueForm cosine =
      turned_real_ * std::cos(turned) - turned_imaginary_ * std::sin(turned);
  const MeanValueForm sine = turned_real_ * std::sin(turned) + turned_imaginary_ * std::cos(turned);
  return gap - (real * cosine - imaginary * sine) + impulse_ * pushed;
}

}  // namespace graze
