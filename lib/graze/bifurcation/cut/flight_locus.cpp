#include "graze/bifurcation/cut/detail/flight_locus.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace graze {
namespace {

// Beside a grazing multipliers vary with the impact speed. Steps are short enough to change a speed
// by at most half, or by this part of the forced motion's speed, if that is more.
constexpr double kSlowest = 1e-5;

}  // namespace

std::optional<LocusPlace> FlightLocus::place(const LocusSite& at,
                                             std::optional<LocusMargin> zero) const {
  const System* system = equations_.system_at(std::array{at.first, at.second});
  if (!system) return {};
  const std::vector<ImpactPoint> impacts = equations_.shooting().unpack(*system, at.u);
  LocusPlace place{{at.first, at.second, at.angle,
                    ordered_impacts(*system, equations_.pattern(), impacts), false},
                   locus_margins(*system, equations_.pattern(), impacts, grazing_),
                   "",
                   {}};
  place.at.admissible = is_admissible(*system, place.margins);
  if (zero && are_others_positive(*system, place.margins, *zero)) place.boundary = zero;
  return place;
}

std::optional<Vector> FlightLocus::margins(const LocusSite& at) const {
  const System* system = equations_.system_at(std::array{at.first, at.second});
  if (!system) return {};
  return locus_margins(*system, equations_.pattern(), equations_.shooting().unpack(*system, at.u),
                       grazing_);
}

Vector FlightLocus::speeds(const LocusSite& at) const {
  const System* system = equations_.system_at(std::array{at.first, at.second});
  if (!system) return {};
  Vector speeds =
      approach_speeds(*system, equations_.pattern(), equations_.shooting().unpack(*system, at.u));
  if (grazing_) speeds[static_cast<Eigen::Index>(*grazing_)] = 0.0;  // but for rounding
  return speeds;
}

bool FlightLocus::resolves(const LocusSite& from, const LocusSite& to) const {
  const Vector before = speeds(from), now = speeds(to);
  if (before.size() != now.size()) return true;
  const double unit = equations_.shooting().scale().speed;
  for (Eigen::Index i = 0; i < before.size(); ++i) {
    const double larger = std::max(std::abs(before[i]), std::abs(now[i]));
    if (std::abs(now[i] - before[i]) > std::max(0.5 * larger, kSlowest * unit)) return false;
  }
  return true;
}

}  // namespace graze
