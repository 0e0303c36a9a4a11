// Statistics of a run that its measured amplitudes (amplitudes.hpp) do not have: how long a place
// is beyond a level, the power of its motion over the frequency, and how a stop is met.
//
// Collected from events and samples as they come, in memory that does not depend on their number.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/assembly/probes.hpp"
#include "graze/base/histogram.hpp"
#include "graze/base/spectrum.hpp"
#include "graze/base/units.hpp"
#include "graze/motion/run_events.hpp"

namespace graze {

// The shares of time of PlaceStatistics::levels.
inline constexpr double kExceededShares[] = {0.999, 0.99, 0.95, 0.9,  0.75, 0.5,
                                             0.25,  0.1,  0.05, 0.01, 0.001};

// Of the motion at a place, in its unit.
struct PlaceStatistics {
  std::vector<double> levels{};  // that it exceeds for the shares of time above
  std::vector<double>
      density{};  // power spectral density, unit^2/Hz; empty: no segment is complete
};

// Of the impacts on a stop, or the contacts with it. A contact is one with a compliant stop, from
// surface to surface, or the time for which a rigid stop holds the structure; contacts and their
// energy count when they end.
struct StopStatistics {
  double mean_speed = 0.0, largest_speed = 0.0;  // of approach, m/s
  long long contacts = 0;
  double mean_contact = 0.0, longest_contact = 0.0;  // s
  double energy_lost = 0.0;  // by impacts and contacts, J; below zero where they add energy
  BinCounts speeds{};        // m/s
  BinCounts durations{};     // of contacts, s
};

struct RunStatistics {
  double sample_rate = 0.0;  // 1/s
  long long samples = 0;
  double segment = 0.0;  // of the power spectral density, s
  long long segments = 0;
  std::vector<PlaceStatistics> places{};  // in the order of the measured places
  std::vector<StopStatistics> stops{};

  // Frequencies of the densities, 1/s; as many as these have.
  std::vector<double> frequencies() const;
};

// Of the density at a place: "m^2/Hz", "1/Hz" of a strain, "" where numbers are pure.
std::string density_unit(const MeasuredPlace& place, Units units);

class StatisticsCollector {
 public:
  // From a time on, s; `rate` of the samples that will be added, 1/s; `segment`: samples of one of
  // the power spectral density, even.
  StatisticsCollector(const std::vector<MeasuredPlace>& places, std::size_t stops, double from,
                      double rate, std::size_t segment);

  double from() const { return from_; }
  // All events of the run, and its samples in their order.
  void add(const Event& event);
  void add(const Sample& sample);

  RunStatistics result() const;

 private:
  struct Place {
    MeasuredRow seen;
    Histogram values;
    PowerSpectrum power;
  };
  struct Met {
    Histogram speeds, durations;
    double sum_of_speeds = 0.0, sum_of_durations = 0.0, largest_speed = 0.0, longest = 0.0;
    double energy_lost = 0.0;
    std::optional<double> held_since{};  // s
  };
  void add_contact(Met& met, double duration);

  double from_, rate_;
  std::size_t segment_;
  long long samples_ = 0;
  std::vector<Place> places_;
  std::vector<Met> stops_;
};

}  // namespace graze
