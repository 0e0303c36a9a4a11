#include "graze/motion/lanes/detail/lane_motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graze/contact/detail/impulse.hpp"
#include "graze/flow/exact/detail/term_kernels.hpp"
#include "graze/system/scale.hpp"

namespace graze {
namespace {

// With more modes a single motion fills the vector unit (term_kernels.hpp), so that lanes gain
// nothing.
constexpr int kMostLaneModes = 16;
// With more stops each evaluation would compute too many gaps for the sake of one.
constexpr std::size_t kMostLaneStops = 8;

LaneSet bit(std::size_t lane) { return LaneSet{1} << lane; }

}  // namespace

bool has_lane(const System& system, const ExactFlow<double>& flow) {
  if (!system.forcing() || !system.has_closed_forms() || system.modes() > kMostLaneModes ||
      system.stops.empty() || system.stops.size() > kMostLaneStops)
    return false;
  double reach = 0.0;
  for (const Stop& stop : system.stops) {
    if (stop.is_compliant() || !stop.restitution().is_constant() ||
        !(stop.restitution().at(0.0) > 0.0))
      return false;
    reach = std::max(reach, std::abs(stop.gap));
  }
  // With all gaps 0 the state decides on the form of the flow (ExactFlow::for_start).
  if (!(reach > 0.0) || !(flow.period() <= longest_flight(system))) return false;
  if (flow.turns().quickest * flow.period() > kFarthestHalfAngle) return false;
  for (int j = 0; j < flow.modes(); ++j)
    if (flow.mode(j).kind != ModeKind::kOscillatory) return false;
  return true;
}

void LaneMotions::adopt(std::size_t lane, const System& system, const ExactFlow<double>& flow,
                        double closure_speed) {
  const double frequency = flow.frequency();
  const auto set = [&](double value, auto... place) { columns_.row(place...)[lane] = value; };
  set(flow.period(), LaneRow::kPeriod);
  set(frequency / 2.0, LaneRow::kHalfFrequency);
  set(flow.phase({}) / 2.0, LaneRow::kHalfPhase);
  set(closure_speed, LaneRow::kSlowest);
  for (std::size_t j = 0; j < columns_.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    set(mode.first, LaneModeRow::kDecay, j);
    set(mode.second / 2.0, LaneModeRow::kHalfFrequency, j);
    set(std::sqrt(mode.first * mode.first + mode.second * mode.second), LaneModeRow::kRate, j);
    set(1.0 / columns_.row(LaneModeRow::kRate, j)[lane], LaneModeRow::kPerRate, j);
    set(1.0 / mode.second, LaneModeRow::kPerFrequency, j);
    set(mode.forced.re, LaneModeRow::kResponseRe, j);
    set(mode.forced.im, LaneModeRow::kResponseIm, j);
    set(mode.offset, LaneModeRow::kOffset, j);
    set(mode.force, LaneModeRow::kForce, j);
  }
  for (std::size_t i = 0; i < columns_.stops(); ++i) {
    const Stop& stop = system.stops[i];
    set(stop.gap, LaneStopRow::kGap, i);
    set(stop.restitution().at(0.0), LaneStopRow::kRestitution, i);
    const bool is_normal = stop.direction() == momentum_direction(stop.row);
    set(is_normal ? stop.row.squaredNorm() : 1.0, LaneStopRow::kNorm, i);
    double re = 0.0, im = 0.0;
    for (std::size_t j = 0; j < columns_.modes(); ++j) {
      const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
      const double row = stop.row[static_cast<Eigen::Index>(j)];
      re -= row * mode.forced.re;
      im -= row * mode.forced.im;
      set(row, LanePairRow::kRow, i, j);
      set(is_normal ? row : stop.direction()[static_cast<Eigen::Index>(j)], LanePairRow::kDirection,
          i, j);
      const double apart =
          std::abs(mode.forced.re) + std::abs(mode.forced.im) + std::abs(mode.offset);
      set(std::abs(row) * apart * (1.0 + (frequency + mode.first) / mode.second),
          LanePairRow::kFormedFrom, i, j);
    }
    set(re, LaneStopRow::kHarmonicRe, i);
    set(im, LaneStopRow::kHarmonicIm, i);
    set(std::hypot(re, im), LaneStopRow::kHarmonicSize, i);
  }
}

void LaneMotions::begin(std::size_t lane, const Vector& q, const Vector& qdot) {
  for (std::size_t j = 0; j < columns_.modes(); ++j) {
    columns_.row(LaneModeRow::kEnd, j)[lane] = q[static_cast<Eigen::Index>(j)];
    columns_.row(LaneModeRow::kAfterRate, j)[lane] = qdot[static_cast<Eigen::Index>(j)];
  }
  columns_.row(LaneRow::kAt)[lane] = 0.0;
  columns_.row(LaneRow::kStage)[lane] = static_cast<double>(LaneStage::kBegin);
  busy_ |= bit(lane);
}

void LaneMotions::drop(std::size_t lane) {
  columns_.row(LaneRow::kStage)[lane] = static_cast<double>(LaneStage::kIdle);
  busy_ &= ~bit(lane);
}

LaneArrivals LaneMotions::fly() {
  const LaneArrivals arrivals = fly_lanes(columns_);
  busy_ &= ~arrivals.left;
  return arrivals;
}

void LaneMotions::end_state(std::size_t lane, Vector& q, Vector& qdot) const {
  for (std::size_t j = 0; j < columns_.modes(); ++j) {
    q[static_cast<Eigen::Index>(j)] = columns_.row(LaneModeRow::kEnd, j)[lane];
    qdot[static_cast<Eigen::Index>(j)] = columns_.row(LaneModeRow::kEndRate, j)[lane];
  }
}

MotionState<double> LaneMotions::departure(std::size_t lane, long long period) const {
  const auto modes = static_cast<Eigen::Index>(columns_.modes());
  MotionState<double> state{{period, local(lane)},
                            Vector(modes),
                            Vector(modes),
                            std::vector<Contact>(columns_.stops(), Contact::kClear),
                            std::vector<int>(columns_.stops(), 0)};
  for (std::size_t j = 0; j < columns_.modes(); ++j) {
    state.q[static_cast<Eigen::Index>(j)] = columns_.row(LaneModeRow::kStart, j)[lane];
    state.qdot[static_cast<Eigen::Index>(j)] = columns_.row(LaneModeRow::kStartRate, j)[lane];
  }
  const int from = static_cast<int>(columns_.row(LaneRow::kFrom)[lane]);
  if (from < 0) return state;
  state.contacts[static_cast<std::size_t>(from)] = Contact::kDeparting;
  state.multiplicities[static_cast<std::size_t>(from)] = 1;
  return state;
}

}  // namespace graze
