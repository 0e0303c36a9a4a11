// Measures a motion flight by flight (amplitudes.hpp). Along closed forms the extremes are those of
// certified searches and the means integrals in closed form. Where the motion is integrated step by
// step, or follows power series, both are those of the polynomial through nine states within each
// step; steps are short enough for that.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "graze/flow/exact/detail/contact_phase.hpp"
#include "graze/motion/amplitudes.hpp"
#include "graze/motion/detail/motion.hpp"

namespace graze {

// The impulse of every stop in equal windows of time, which stands for its force where there are
// impacts.
class ImpulseWindows {
 public:
  // `from`: start of the first window, s.
  ImpulseWindows(std::size_t stops, double from, const ForceWindows& windows)
      : from_(from),
        windows_(windows),
        impulses_(stops, std::vector<double>(static_cast<std::size_t>(windows.count))) {}

  // Adds an impulse, N s, at a time not before the first window.
  void add(int stop, double time, double impulse) {
    impulses_[static_cast<std::size_t>(stop)][index(time)] += impulse;
  }

  // Cuts the time between two instants at the ends of windows: each(begin, end).
  template <class Each>
  void each_part(double begin, double end, const Each& each) const {
    for (std::size_t k = index(begin); begin < end; ++k) {
      const double cut =
          k + 1 < static_cast<std::size_t>(windows_.count)
              ? std::clamp(from_ + static_cast<double>(k + 1) * windows_.length, begin, end)
              : end;
      if (cut > begin) each(begin, cut);
      begin = cut;
    }
  }

  // Means over the windows that lie wholly within `duration`, s.
  StopForces forces(double duration) const {
    StopForces result{from_, windows_.length, {}};
    // The end of a run is rounded; a partly filled window has no mean.
    constexpr double kRounding = 1e-9;
    const auto filled = std::min(static_cast<std::size_t>(duration / windows_.length + kRounding),
                                 impulses_.empty() ? 0 : impulses_.front().size());
    for (const std::vector<double>& impulses : impulses_) {
      std::vector<double>& means = result.means.emplace_back();
      for (std::size_t k = 0; k < filled; ++k) means.push_back(impulses[k] / windows_.length);
    }
    return result;
  }

 private:
  std::size_t index(double time) const {
    const double place = std::max((time - from_) / windows_.length, 0.0);
    return std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(windows_.count - 1));
  }

  double from_;
  ForceWindows windows_;
  std::vector<std::vector<double>> impulses_;  // by stop and window, N s
};

class AmplitudeMeter {
 public:
  // Refers to the system. Without options nothing is measured, and the functions below cost
  // nothing.
  AmplitudeMeter(const System& system, const std::optional<MeasureOptions>& options);

  // Adds a flight of so many seconds that began at forcing phase theta, rad, and at a time, s.
  void add_flight(const ContactPhase<double>& phase, double theta, double time, double seconds);
  // Adds the shares of an impact, and the begin of a contact at a compliant stop.
  void add_impact(const std::vector<ImpactShare<double>>& shares, double time);
  void add_contact(int stop, double time);
  // Adds a summed tail of a chatter: the stops on which the structure is put to rest, and the
  // velocities that this takes away. The stops hold it from then on, so that the impulse may be
  // negative.
  void add_closure(const std::vector<int>& stops, const Vector& taken, double time);

  // All zeros where no time has passed.
  std::optional<Amplitudes> result() const;

 private:
  struct Extent {
    double highest = -std::numeric_limits<double>::infinity();
    double lowest = std::numeric_limits<double>::infinity();
    void note(double value);
  };
  struct Sums {
    Extent extent;
    double value = 0.0, square = 0.0;  // integrals over time
    Complex turned = 0.0;
  };
  // Sums for a row: of itself, and of its rate unless it is a velocity.
  struct Measured {
    Sums sums;
    Extent speed;
  };
  struct Load {
    long long impacts = 0;
    double impulse = 0.0, held = 0.0;
    bool struck = false;  // by an impact that has no force
    Sums force;
  };

  void add_exact(const ContactPhase<double>& phase, double time, double from, double to);
  // Adds the force of a stop, N.
  void add_force(const ExactPhase<double>& phase, int stop, const Observable<double>& force,
                 double time, double from, double to);
  void add_steps(const ContactPhase<double>& phase, double theta, double time, double from,
                 double to);
  void add_step(const ContactPhase<double>& phase, double theta, double time, double from,
                double to);
  void add_impulse(int stop, double time, double impulse);
  // Cuts a part of a flight that began at `time` at the ends of windows, if there are any.
  template <class Each>
  void each_part(double time, double from, double to, const Each& each) const;

  bool measures(double time) const { return options_ && time >= options_->from; }
  Load& load(int stop) { return loads_[static_cast<std::size_t>(stop)]; }

  const System& system_;
  const std::optional<MeasureOptions> options_;
  std::vector<Measured> measured_;
  std::vector<Load> loads_;
  std::optional<ImpulseWindows> windows_;
  double duration_ = 0.0;
};

}  // namespace graze
