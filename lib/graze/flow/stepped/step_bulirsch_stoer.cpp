#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>

#include "graze/flow/stepped/detail/step_walk.hpp"

namespace graze {
namespace {

namespace odeint = boost::numeric::odeint;

// A step that fails its error more often than this in a row will not succeed.
constexpr int kMostFailures = 500;

// Odeint begins a step with a look at the size of the last one, which before the first step has no
// value. It gets one here, NaN, which no step has. That size is private: an explicit instantiation
// may name it, and has a friend that sets it.
using Method = odeint::bulirsch_stoer<step_walk::Sprung::State>;
void begin_steps(Method& method);
template <double Method::*kLastStep>
struct LastStep {
  friend void begin_steps(Method& method) {
    method.*kLastStep = std::numeric_limits<double>::quiet_NaN();
  }
};
template struct LastStep<&Method::m_dt_last>;

// Steps and orders that their error decides; what lies within a step is reached from its start.
template <class Rates>
class ExtrapolatedWalk {
 public:
  using RatesOf = Rates;
  using State = typename Rates::State;

  ExtrapolatedWalk(Rates rates_of, const StepSetting& setting)
      : rates(std::move(rates_of)),
        longest_(setting.longest),
        method_(made(setting)),
        method_within_(made(setting)) {
    begin_steps(method_);
    begin_steps(method_within_);
  }

  void begin(const State& x) {
    from_ = to_ = 0.0;
    next_ = rates.first_step(longest_);
    at_start_ = at_end_ = x;
    method_.reset();
  }
  void step() {
    at_start_ = at_end_;
    from_ = to_;
    next_ = std::fmin(next_, rates.longest_step());
    for (int i = 0; i < kMostFailures; ++i)
      if (method_.try_step(std::ref(rates), at_start_, to_, at_end_, next_) == odeint::success)
        return;
  }
  double from() const { return from_; }
  double to() const { return to_; }
  const State& state_at_end() const { return at_end_; }
  void between(double s, State& x) {
    x = at_start_;
    method_within_.reset();
    double at = from_, next = s - from_;
    for (int i = 0; i < kMostFailures && at < s; ++i) {
      next = std::min(next, s - at);
      within_ = x;
      if (method_within_.try_step(std::ref(rates), within_, at, x, next) != odeint::success)
        x = within_;
    }
    if (at < s) x.assign(x.size(), std::numeric_limits<double>::quiet_NaN());
  }

  Rates rates;

 private:
  static Method made(const StepSetting& setting) {
    return Method(setting.tolerance * setting.speed, Rates::relative(setting.tolerance), 1.0, 0.0,
                  std::isfinite(setting.longest) ? setting.longest : 0.0);
  }

  double longest_;
  double from_ = 0.0, to_ = 0.0, next_ = 0.0;
  State at_start_{}, at_end_{}, within_{};
  // It learns from its steps; what is asked within them is not to change them.
  Method method_, method_within_;
};

}  // namespace

std::unique_ptr<StepFlow> bulirsch_stoer_flow(const SprungSystem& system,
                                              const StepSetting& setting) {
  using Walk = ExtrapolatedWalk<step_walk::Sprung>;
  return std::make_unique<step_walk::WalkingFlow<Walk>>(
      Walk(step_walk::Sprung(system, setting.tolerance), setting));
}

}  // namespace graze
