// Measurements made in a test: closed forms with normal noise.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "graze/fit/fit.hpp"
#include "graze/scene/reader.hpp"

namespace graze {

// Normal numbers of deviation 1, the same on every machine: the standard library's are not.
// SplitMix (G. Steele, D. Lea, C. Flood, OOPSLA 2014) and the transformation of Box and Muller.
class Noise {
 public:
  // From a bare seed the sequence of the next seed would be the same, one number later.
  explicit Noise(std::uint64_t seed) : state_(mixed(seed)) {}

  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  double uniform() {
    state_ += 0x9E3779B97F4A7C15ull;
    return (static_cast<double>(mixed(state_) >> 11) + 0.5) * 0x1p-53;
  }

  std::uint64_t state_;
};

inline Measurements response(const std::string& column, Quantity quantity, const Vector& at,
                             const Vector& values) {
  Measurements data;
  data.file = "made.csv";
  data.kind = MeasurementKind::kResponse;
  data.at = at;
  data.series.push_back({column, "", quantity, 0, values, {}});
  data.places.resize(static_cast<std::size_t>(at.size()), {"made.csv", 2, 1});
  return data;
}

inline Measurements impacts(const Vector& times) {
  Measurements data;
  data.file = "made.csv";
  data.kind = MeasurementKind::kImpactTimes;
  data.at = Vector::LinSpaced(times.size(), 1.0, static_cast<double>(times.size()));
  data.stops.assign(static_cast<std::size_t>(times.size()), -1);
  data.series.push_back({"time", "s", Quantity::kCoordinate, 0, times, {}});
  data.places.resize(static_cast<std::size_t>(times.size()), {"made.csv", 2, 1});
  return data;
}

inline Measurements restitutions(const Vector& speeds, const Vector& values) {
  Measurements data;
  data.file = "made.csv";
  data.kind = MeasurementKind::kRestitution;
  data.at = speeds;
  data.series.push_back({"restitution", "", Quantity::kCoordinate, 0, values, {}});
  data.places.resize(static_cast<std::size_t>(speeds.size()), {"made.csv", 2, 1});
  return data;
}

inline FitOptions fit_options(std::vector<SoughtParameter> parameters) {
  FitOptions options;
  options.parameters = std::move(parameters);
  options.max_evaluations = 5000;
  return options;
}

}  // namespace graze
