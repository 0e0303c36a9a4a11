// The impulse of every stop in equal windows of time, which stands for its force where there are
// impacts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "graze/motion/amplitudes.hpp"

namespace graze {

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

}  // namespace graze
