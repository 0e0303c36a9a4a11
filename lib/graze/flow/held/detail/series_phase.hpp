// The phase of a structure of many modes that closed stops hold, followed by power series
// (motion_series.hpp): a set of closed stops needs no preparation, and a sticking phase of a
// fraction of the shortest modal period, as many are, costs one or two steps of O(N m).
//
// Contact forces and gaps are polynomials over each step, with bounds, and their first zeros are
// certified as in the phases with closed forms.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/flow/exact/detail/first_zero.hpp"
#include "graze/flow/series/detail/motion_series.hpp"

namespace graze {

// Whether to follow a structure held by these stops by series: impulses act along their rows, and
// the modes are too many for a fast decomposition of the held structure.
bool suits_series(const System& system, const std::vector<int>& closed);

// Work of damping and forcing over an arc of it, J.
struct SeriesWork {
  double dissipation = 0.0, forcing = 0.0;
};

class SeriesPhase final : public ContactPhase<double> {
 public:
  using ContactPhase<double>::start;
  SeriesPhase(const System& system, PhaseKey key);
  ~SeriesPhase() override;

  void start(const double& theta, const Vector& q, const Vector& qdot, const double& time) override;
  void state(const double& s, Vector& q, Vector& qdot) const override;
  Arrival<double> first_event(const MotionState<double>& now,
                              const Flight<double>& flight) override;
  CurvePoint<double> gap_rate(int stop, int order) const override {
    return outlook(stop, order, 0.0);
  }
  double force_at(int stop, const double& s, const Vector& q, const Vector& qdot) const override;
  double force_rate(int stop) const override;
  bool sees_ahead() const override { return true; }
  CurvePoint<double> outlook(int stop, int order, const double& ahead) const override;
  bool stays_quiet(int stop, const double& duration) const override;
  // The same motion in modes, for derivatives; built on demand.
  const ExactPhase<double>* exact() const override;
  const SeriesPhase* series() const override { return this; }
  SeriesWork work(double s) const;
  // Cuts the arc up to `until`, s after the start, into pieces of at most half a step, one or two
  // radians of the quickest mode: their ends, s.
  std::vector<double> step_ends(double until) const;

 private:
  struct Step {
    double from = 0.0;  // s
    Vector q, qdot;
  };
  struct Watched {
    int stop = 0, multiplicity = 0;
    bool closed = false;
    double sure = 0.0;  // s, up to then it is not met
  };
  struct Met {
    double s = 0.0;
    const Watched* watched = nullptr;
    bool touch = false;
  };

  int column_of(int stop) const;
  // The series about the step's start, formed at most once in a row.
  const MotionSeries& about(const Step& step) const;
  const Step& step_at(double s) const;
  // The first zero of the watched function within tau units of the step that the series is about.
  std::optional<Met> met_by(const Watched& watched, double tau, bool first) const;
  double gap_noise(int stop, int order) const;
  // The first zero over [0, window]; without one, `reached` is set to how far the search got.
  std::optional<Met> first_met(const std::vector<Watched>& list, double window,
                               const StopSignal& stop, std::vector<Step>& steps, double& reached,
                               long long& expansions) const;

  const System system_;
  LinearSystem<double> modes_;
  Matrix rows_;  // of every stop, N x stops
  Vector gaps_, norms_, held_gaps_;
  mutable MotionSeries series_;
  mutable double known_from_ = -1.0;  // s, start of the step that the series is about
  mutable long long known_arc_ = -1;
  mutable std::vector<double> watch_;  // what is watched over a step
  long long arc_ = 0;                  // arcs started
  double theta_ = 0.0, time_ = 0.0;
  Vector q_, qdot_;          // as the arc was started
  std::vector<Step> steps_;  // the first is the start, settled on the stops
  mutable std::unique_ptr<ExactPhase<double>> exact_;
  mutable long long exact_arc_ = -1;
};

}  // namespace graze
