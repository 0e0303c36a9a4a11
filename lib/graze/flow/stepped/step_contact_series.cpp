#include <algorithm>
#include <cmath>
#include <utility>

#include "graze/flow/stepped/detail/contact_series.hpp"
#include "graze/flow/stepped/detail/extrapolated_walk.hpp"

namespace graze {
namespace {

using step_walk::ContactSeries;
using step_walk::ExtrapolatedWalk;
using step_walk::Sprung;

// Uses series from where a spring is entered at a speed, or is compressed, to where its surface is
// reached; extrapolation where there is no series, and beyond the surface.
class SeriesWalk : public ExtrapolatedWalk {
 public:
  SeriesWalk(const SprungSystem& system, const StepSetting& setting)
      : ExtrapolatedWalk(Sprung(system, setting.tolerance), setting),
        series_(system, setting.tolerance * setting.speed) {}

  void begin(const State& x) {
    ExtrapolatedWalk::begin(x);
    end_ = 0.0;
    const auto [depth, rate] = rates.compression(series_.spring(), x);
    by_series_ = (depth > 0.0 || (depth == 0.0 && rate > 0.0)) && std::isinf(rates.longest_step());
    if (!by_series_) return;
    series_.set_units(rates);
    root_ = series_.root_at(depth);
    state_ = x;
    begin_ = reached_ = 0.0;
    short_steps_ = 0;
  }
  void step() {
    if (by_series_ && step_by_series()) return;
    if (by_series_) {
      by_series_ = false;
      end_ = 0.0;
      if (reached_ > 0.0) go_on(reached_, state_, kBeyondSurface * reached_);
    }
    ExtrapolatedWalk::step();
  }
  double from() const { return end_ > 0.0 ? begin_ : ExtrapolatedWalk::from(); }
  double to() const { return by_series_ ? reached_ : ExtrapolatedWalk::to(); }
  const State& state_at_end() const {
    return by_series_ ? state_ : ExtrapolatedWalk::state_at_end();
  }
  void between(double s, State& x) {
    if (end_ > 0.0)
      series_.state(s > begin_ ? series_.instant(s - begin_, end_) : 0.0, x);
    else
      ExtrapolatedWalk::between(s, x);
  }
  // Ends of equal parts of a series up to `to`, s, in its own variable; a step that is short
  // against the time so far has none.
  int parts(double to) const {
    return end_ > 0.0 && to - begin_ > kLeastParted * begin_ ? kParts : 1;
  }
  double part_end(int i, double to) const {
    return begin_ + series_.time(series_.instant(to - begin_, end_) * i / kParts);
  }

 private:
  static constexpr int kParts = 8;
  static constexpr double kLeastParted = 1e-9;
  // Step, relative to the time so far, that brings a depth below the surface that rounding left
  // above.
  static constexpr double kBeyondSurface = 1e-6;
  // Shortest useful step, rad of the forcing phase; after so many shorter ones the state stays
  // where it is, which ends the motion.
  static constexpr double kShortStep = 1e-9;
  static constexpr int kMostShortSteps = 100000;

  bool step_by_series() {
    if (root_ <= 0.0 && reached_ > 0.0) return false;
    if (!series_.expand(rates, state_, reached_, root_)) return false;
    rates.evaluations += ContactSeries::kOrder;
    const double surface = series_.surface();
    const double end = surface > 0.0 ? surface : series_.length();
    const double to = reached_ + series_.time(end);
    if (!(to > reached_)) return false;
    const double turned = rates.frequency() * (to - reached_);
    if (turned > 0.0 && turned < kShortStep && ++short_steps_ > kMostShortSteps) return true;
    end_ = end;
    begin_ = reached_;
    reached_ = to;
    root_ = surface > 0.0 ? 0.0 : series_.root(end);
    series_.state(end, state_);
    return true;
  }

  ContactSeries series_;
  bool by_series_ = false;
  int short_steps_ = 0;
  double root_ = 0.0;                   // of the depth, at the end of the last step
  double begin_ = 0.0, reached_ = 0.0;  // s, of that step
  double end_ = 0.0;                    // likewise, in the variable of the series; 0: none taken
  State state_;                         // at its end
};

}  // namespace

std::unique_ptr<StepFlow> contact_flow(const SprungSystem& system, const StepSetting& setting) {
  if (!ContactSeries::suits(system)) return bulirsch_stoer_flow(system, setting);
  return std::make_unique<step_walk::WalkingFlow<SeriesWalk>>(SeriesWalk(system, setting));
}

}  // namespace graze
