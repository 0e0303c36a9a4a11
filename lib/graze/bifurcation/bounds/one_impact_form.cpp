#include "graze/bifurcation/bounds/detail/one_impact_form.hpp"

#include <cmath>

#include "graze/base/angle.hpp"

namespace graze {
namespace {

using Form = MeanValueForm;

// Displacement and speed just before the next impulse of a repeated unit impulse on one mode;
// displaced has the denominator `over` where it is not 1.
struct RepeatedMode {
  Form displaced, approached, over = 1.0;
};

// Taylor series of sin(x)/x and of (1 - cos x)/x^2 in y = x^2, |y| <= 1: the remainder is less than
// eps/10.
Form sine_over(const Form& y) {
  Form sum = 0.0;
  for (int k = 8; k >= 1; --k) sum = (1.0 - sum) * y * (1.0 / ((2.0 * k) * (2.0 * k + 1.0)));
  return 1.0 - sum;
}
Form cosine_defect_over(const Form& y) {
  Form sum = 0.0;
  for (int k = 8; k >= 1; --k) sum = (1.0 - sum) * y * (1.0 / ((2.0 * k + 1.0) * (2.0 * k + 2.0)));
  return (1.0 - sum) * 0.5;
}

// e^{-x}/(1 - e^{-x}), x > 0.
Form repeated_decay(const Form& x) { return exponential(-x) / -exponential_less_one(-x); }

RepeatedMode undamped_mode(const Form& omega, const Form& duration) {
  const Form half = omega * duration * 0.5;
  RepeatedMode mode;
  mode.approached = -0.5;
  const auto [s, c] = sine_and_cosine(half);
  mode.displaced = c / (omega * 2.0);
  if (s.value.contains(0.0))
    mode.over = s;
  else
    mode.displaced = mode.displaced / s;
  return mode;
}

std::optional<RepeatedMode> underdamped_mode(const Form& delta, const Form& damped,
                                             const Form& duration) {
  const Form x = damped * duration, shrinking = -(delta * duration);
  const Form rho = exponential(shrinking), less = -exponential_less_one(shrinking);
  const auto [s, c] = sine_and_cosine(x * 0.5);
  const Form apart = square(less) + rho * square(s) * 4.0;  // |1 - z|^2
  if (!(apart.value.low > 0.0) || !(apart.middle.low > 0.0)) return {};
  const Form inverted = inverse(apart);
  RepeatedMode mode;
  mode.displaced = rho * s * c * 2.0 * inverted / damped;
  mode.approached = less * (1.0 + rho) * inverted * 0.5 - 0.5 - delta * mode.displaced;
  return mode;
}

std::optional<RepeatedMode> overdamped_mode(const Form& omega, const Form& delta, const Form& root,
                                            const Form& duration) {
  const Form fast = delta + root, slow = square(omega) / fast;
  if (!(slow.value.low > 0.0)) return {};
  const Form of_slow = repeated_decay(slow * duration), of_fast = repeated_decay(fast * duration);
  RepeatedMode mode;
  mode.displaced = (of_slow - of_fast) / (root * 2.0);
  mode.approached = (fast * of_fast - slow * of_slow) / (root * 2.0);
  return mode;
}

// Next to critical damping, D = w^2 - delta^2 small.
std::optional<RepeatedMode> critical_mode(const Form& delta, const Form& discriminant,
                                          const Form& duration) {
  const Form y = discriminant * square(duration);
  if (!(y.value.size() <= 1.0)) return {};
  const Form shrinking = -(delta * duration);
  const Form rho = exponential(shrinking), less = -exponential_less_one(shrinking);
  const Form apart = square(less) + rho * y * cosine_defect_over(y) * 2.0;
  if (!(apart.value.low > 0.0)) return {};
  RepeatedMode mode;
  mode.displaced = rho * duration * sine_over(y) / apart;
  mode.approached = less * (1.0 + rho) / apart * 0.5 - 0.5 - delta * mode.displaced;
  return mode;
}

std::optional<RepeatedMode> repeated_mode(const Form& omega, const Form& delta,
                                          const Form& duration) {
  if (delta.is_exactly(0.0)) {
    if (!(omega.value.low > 0.0)) return {};
    return undamped_mode(omega, duration);
  }
  const Form discriminant = (omega - delta) * (omega + delta);
  if (discriminant.value.low > 0.0)
    return underdamped_mode(delta, square_root(discriminant), duration);
  if (discriminant.value.high < 0.0)
    return overdamped_mode(omega, delta, square_root(-discriminant), duration);
  return critical_mode(delta, discriminant, duration);
}

// A mode without stiffness, as the coefficient of w^-2: displaced 1/P; the speed is finite.
RepeatedMode free_mode(const Form& delta, const Form& duration) {
  RepeatedMode mode;
  mode.displaced = inverse(duration);
  mode.approached = -0.5;
  if (!delta.is_exactly(0.0)) {
    const Form rate = delta * 2.0;
    mode.approached = repeated_decay(rate * duration) - inverse(rate * duration);
  }
  return mode;
}

class Summation {
 public:
  Summation(const SystemForms& system, int stop, int period)
      : system_(system), stop_(system.stops[static_cast<std::size_t>(stop)]) {
    duration_ = inverse(system.frequency) * (kTurn * period);
  }

  std::optional<OneImpactForm> sum() {
    const Form jump = stop_.restitution.front() + 1.0;
    for (std::size_t j = 0; j < system_.omega.size(); ++j)
      if (!add_forced(j) || !add_repeated(j)) return {};
    OneImpactForm form;
    form.kick = jump * system_.frequency;
    form.free_mass = has_free_;
    form.has_factors = !over_.is_exactly(1.0) || !forced_over_.is_exactly(1.0);
    form.free_speed = undamped_ && stop_.restitution.front().is_exactly(1.0);
    form.forced_real = real_ * forced_over_ + real_apart_;
    form.forced_imaginary = imaginary_ * forced_over_;
    form.level = has_free_ ? -free_level_ * forced_over_ : (stop_.gap - level_) * forced_over_;
    form.displaced = has_free_ ? free_displaced_ : displaced_ * over_ + displaced_apart_;
    form.returned = approached_;
    form.approached = 1.0 + jump * approached_;
    if (!has_free_) {
      form.returned = form.returned * over_;
      form.approached = form.approached * over_;
    }
    return form;
  }

 private:
  // A += b p/(w^2 - Omega^2 + 2 i delta Omega), a's static part += b l/w^2.
  bool add_forced(std::size_t j) {
    const Form& omega = system_.omega[j];
    const Form &b = stop_.row[j], &frequency = system_.frequency;
    const Form x = (omega - frequency) * (omega + frequency);
    const Form y = system_.delta[j] * frequency * 2.0;
    const Form amplitude = b * system_.amplitude[j];
    const bool undamped = system_.delta[j].is_exactly(0.0);
    if (undamped && x.value.contains(0.0)) {
      // (A X) with X of size one: for any number of such modes, a sum of fractions.
      const Form unit = inverse(square(omega) + square(frequency)), part = x * unit;
      real_apart_ = real_apart_ * part + amplitude * unit * forced_over_;
      forced_over_ = forced_over_ * part;
    } else if (undamped) {
      real_ = real_ + amplitude / x;
    } else {
      const Form size = square(x) + square(y);
      if (!(size.value.low > 0.0) || !(size.middle.low > 0.0)) return false;
      const Form over = amplitude / size;
      real_ = real_ + x * over;
      imaginary_ = imaginary_ - y * over;
    }
    if (system_.load[j].is_exactly(0.0)) return true;
    const Form load = b * system_.load[j];
    if (omega.is_exactly(0.0)) {
      free_level_ = free_level_ + load;
      return true;
    }
    if (!(omega.value.low > 0.0)) return false;
    level_ = level_ + load / square(omega);
    return true;
  }

  bool add_repeated(std::size_t j) {
    const Form weight = stop_.row[j] * stop_.direction[j];
    undamped_ = undamped_ && system_.delta[j].is_exactly(0.0);
    if (system_.omega[j].is_exactly(0.0)) {
      const RepeatedMode mode = free_mode(system_.delta[j], duration_);
      has_free_ = true;
      free_displaced_ = free_displaced_ + weight * mode.displaced;
      approached_ = approached_ + weight * mode.approached;
      return true;
    }
    const auto mode = repeated_mode(system_.omega[j], system_.delta[j], duration_);
    if (!mode) return false;
    approached_ = approached_ + weight * mode->approached;
    if (mode->over.is_exactly(1.0)) {
      displaced_ = displaced_ + weight * mode->displaced;
    } else {
      displaced_apart_ = displaced_apart_ * mode->over + weight * mode->displaced * over_;
      over_ = over_ * mode->over;
    }
    return true;
  }

  const SystemForms& system_;
  const SystemForms::Stop& stop_;
  Form duration_;
  Form real_ = 0.0, imaginary_ = 0.0, real_apart_ = 0.0, forced_over_ = 1.0;
  Form displaced_ = 0.0, displaced_apart_ = 0.0, over_ = 1.0, approached_ = 0.0;
  Form level_ = 0.0, free_level_ = 0.0, free_displaced_ = 0.0;
  bool has_free_ = false, undamped_ = true;
};

}  // namespace

MeanValueForm OneImpactForm::fold_function() const {
  if (free_speed) return displaced;
  const Form pushed = square(kick * displaced);
  return (square(forced_real) + square(forced_imaginary)) *
             (free_mass ? pushed : pushed + square(approached)) -
         square(level * approached);
}

std::optional<OneImpactForm> one_impact_form(const SystemForms& system, int stop, int period) {
  return Summation(system, stop, period).sum();
}

std::optional<MeanValueForm> repeated_impulse(const MeanValueForm& omega,
                                              const MeanValueForm& delta,
                                              const MeanValueForm& duration, double part) {
  if (!(omega.value.low > 0.0)) return {};
  const Form discriminant = (omega - delta) * (omega + delta);
  if (discriminant.value.high < 0.0) {
    const Form root = square_root(-discriminant), fast = delta + root, slow = square(omega) / fast;
    const auto decay = [&](const Form& rate) {
      return exponential(-(rate * duration) * part) / -exponential_less_one(-(rate * duration));
    };
    return (decay(slow) - decay(fast)) / (root * 2.0);
  }
  if (!(discriminant.value.low > 0.0)) return {};
  // Im[z^part/(1 - z)]/w, with the denominator |1 - z|^2; of an undamped mode a quotient of sines.
  const Form damped = square_root(discriminant), x = damped * duration;
  const Form half_sine = sine(x * 0.5);
  if (delta.is_exactly(0.0)) {
    if (half_sine.value.contains(0.0) || half_sine.middle.contains(0.0)) return {};
    return cosine(x * (part - 0.5)) / (damped * half_sine * 2.0);
  }
  const Form shrinking = -(delta * duration), rho = exponential(shrinking);
  const Form apart = square(-exponential_less_one(shrinking)) + rho * square(half_sine) * 4.0;
  if (!(apart.value.low > 0.0) || !(apart.middle.low > 0.0)) return {};
  return exponential(shrinking * part) * (sine(x * part) - rho * sine(x * (part - 1.0))) /
         (damped * apart);
}

int family_of(const SystemForms& system, int stop, int period, double theta) {
  const auto form = one_impact_form(system, stop, period);
  if (!form) return 0;
  const auto number = [](const Form& of) { return of.middle.middle(); };
  // a D = Re(A (D - i (1 + r) Omega g) e^{i theta}): the imaginary part is that of one solution or
  // minus that of the other, and smooth along each once its poles are divided out.
  const Complex forced(number(form->forced_real), number(form->forced_imaginary));
  const Complex turned(form->free_mass ? 0.0 : number(form->approached),
                       -number(form->kick) * number(form->displaced));
  double side = (forced * turned * std::polar(1.0, theta)).imag();
  for (std::size_t j = 0; j < system.omega.size(); ++j) {
    if (!system.delta[j].is_exactly(0.0) || system.omega[j].is_exactly(0.0)) continue;
    const double omega = number(system.omega[j]), frequency = number(system.frequency);
    if (std::sin(0.5 * omega * kTurn * period / frequency) < 0.0) side = -side;
    if (omega < frequency) side = -side;
  }
  return side > 0.0 ? 1 : side < 0.0 ? -1 : 0;
}

}  // namespace graze
