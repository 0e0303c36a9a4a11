#include "graze/continuation/branch/detail/unknown_limits.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graze/continuation/branch/detail/locate.hpp"

namespace graze {
namespace {

// The limit of a range beyond which a value lies; nullopt when it is within.
std::optional<UnknownLimit> limit_below(const UnknownRange& range, double value) {
  if (value < range.from) return UnknownLimit{range.unknown, range.from};
  if (value > range.to) return UnknownLimit{range.unknown, range.to};
  return {};
}

}  // namespace

UnknownLimits::UnknownLimits(const ContinuationOptions& options) : ranges_(options.ranges) {
  for (UnknownRange& range : ranges_)
    if (range.from > range.to) std::swap(range.from, range.to);
}

std::optional<UnknownLimit> UnknownLimits::ahead(const SolutionPoint& here, double h) const {
  std::optional<UnknownLimit> first;
  double nearest = std::numeric_limits<double>::infinity();
  for (const UnknownRange& range : ranges_) {
    const double at = here.u[range.unknown], rate = here.tangent[range.unknown];
    const std::optional<UnknownLimit> limit = limit_below(range, at + h * rate);
    if (!limit || !((limit->value - at) / rate < nearest)) continue;
    nearest = (limit->value - at) / rate;
    first = limit;
  }
  return first;
}

double UnknownLimits::longest(const SolutionPoint& here) const {
  double h = std::numeric_limits<double>::infinity();
  for (const UnknownRange& range : ranges_)
    if (range.max_step > 0.0)
      h = std::min(h, range.max_step / std::abs(here.tangent[range.unknown]));
  return h;
}

std::optional<UnknownLimits::Exit> UnknownLimits::exit_between(Corrector& corrector,
                                                               const SolutionPoint& a,
                                                               const SolutionPoint& b) const {
  std::optional<Exit> exit;
  for (const UnknownRange& range : ranges_) {
    const Eigen::Index k = range.unknown;
    SolutionPoint beyond = exit ? exit->point : b;
    std::optional<UnknownLimit> limit = limit_below(range, beyond.u[k]);
    // The unknown may turn back beyond its limit.
    if (!limit && a.tangent[k] * beyond.tangent[k] < 0.0) {
      auto turn =
          locate(corrector, a, beyond, [k](const SolutionPoint& p) { return p.tangent[k]; });
      if (turn) limit = limit_below(range, turn->u[k]);
      if (limit) beyond = std::move(*turn);
    }
    if (!limit) continue;
    const auto crossing =
        locate(corrector, a, beyond, [&](const SolutionPoint& p) { return p.u[k] - limit->value; });
    if (!crossing) return Exit{a, false};
    exit = Exit{point_on_limit(corrector, *crossing, *limit).value_or(*crossing), true};
  }
  return exit;
}

bool UnknownLimits::leaves_at(const SolutionPoint& here) const {
  return std::any_of(ranges_.begin(), ranges_.end(), [&](const UnknownRange& range) {
    const double at = here.u[range.unknown], rate = here.tangent[range.unknown];
    return (rate < 0.0 && at == range.from) || (rate > 0.0 && at == range.to);
  });
}

std::optional<SolutionPoint> point_on_limit(Corrector& corrector, const SolutionPoint& near,
                                            const UnknownLimit& limit) {
  const Eigen::Index k = limit.unknown;
  Vector x = corrector.pack(near);
  const double rate = near.tangent[k];
  if (rate != 0.0) x += (limit.value - x[k]) / rate * near.tangent;
  x[k] = limit.value;
  // The unknown is fixed: the hyperplane is normal to its axis.
  const Vector normal = (rate < 0.0 ? -1.0 : 1.0) * Vector::Unit(x.size(), k);
  std::optional<SolutionPoint> point = corrector.on_hyperplane(x, normal);
  if (!point) return {};
  point->u[k] = limit.value;
  if (point->tangent.dot(near.tangent) < 0.0) point->turn_round();
  return point;
}

}  // namespace graze
