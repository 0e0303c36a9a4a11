#include "graze/record/run_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "graze/study/run_impact.hpp"

namespace graze {
namespace {

constexpr int kMostBins = 32;  // of the histograms in a result

double mean_of(double sum, long long count) {
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace

std::vector<double> RunStatistics::frequencies() const {
  std::vector<double> result;
  if (!places.empty())
    for (std::size_t k = 0; k < places.front().density.size(); ++k)
      result.push_back(static_cast<double>(k) / segment);
  return result;
}

std::string density_unit(const MeasuredPlace& place, Units units) {
  if (place.unit.empty()) return unit_in(units, "1/Hz");
  const bool is_single = place.unit.find('/') == std::string::npos;
  return (is_single ? place.unit : "(" + place.unit + ")") + "^2/Hz";
}

StatisticsCollector::StatisticsCollector(const std::vector<MeasuredPlace>& places,
                                         std::size_t stops, double from, double rate,
                                         std::size_t segment)
    : from_(from), rate_(rate), segment_(segment), stops_(stops) {
  for (const MeasuredPlace& place : places)
    places_.push_back({place.seen, {}, PowerSpectrum(segment, rate)});
}

void StatisticsCollector::add(const Event& event) {
  if (event.stop < 0) return;
  Met& met = stops_[static_cast<std::size_t>(event.stop)];
  // What a stop held when the run began, no event tells the beginning of.
  if (event.kind == EventKind::kStick) met.held_since = event.time;
  if (event.time < from_) return;
  met.energy_lost -= event.energy_change;
  if (meets_stop(event)) {
    met.speeds.add(event.speed);
    met.sum_of_speeds += event.speed;
    met.largest_speed = std::max(met.largest_speed, event.speed);
  }
  if (event.kind == EventKind::kSeparation) add_contact(met, event.duration);
  if (event.kind == EventKind::kRelease && met.held_since)
    add_contact(met, event.time - *met.held_since);
}

void StatisticsCollector::add_contact(Met& met, double duration) {
  met.durations.add(duration);
  met.sum_of_durations += duration;
  met.longest = std::max(met.longest, duration);
}

void StatisticsCollector::add(const Sample& sample) {
  if (sample.time < from_) return;
  ++samples_;
  for (Place& place : places_) {
    const double value = place.seen.value(sample.state, sample.phase);
    place.values.add(value);
    place.power.add(value);
  }
}

RunStatistics StatisticsCollector::result() const {
  RunStatistics result{rate_, samples_, static_cast<double>(segment_) / rate_, 0, {}, {}};
  for (const Place& place : places_) {
    result.segments = place.power.segments();
    PlaceStatistics& at = result.places.emplace_back();
    for (const double share : kExceededShares) at.levels.push_back(place.values.exceeded(share));
    at.density = place.power.density();
  }
  for (const Met& met : stops_) {
    const long long impacts = met.speeds.count(), contacts = met.durations.count();
    result.stops.push_back({mean_of(met.sum_of_speeds, impacts), met.largest_speed, contacts,
                            mean_of(met.sum_of_durations, contacts), met.longest, met.energy_lost,
                            met.speeds.from_zero(kMostBins), met.durations.from_zero(kMostBins)});
  }
  return result;
}

}  // namespace graze
