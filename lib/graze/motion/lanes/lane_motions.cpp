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

bool is_lane_like(const System& system) {
  if (!system.repeats() || system.coupling() || system.modes() > kMostLaneModes ||
      !system.frictions.empty() || system.stops.empty() || system.stops.size() > kMostLaneStops)
    return false;
  double reach = 0.0;
  for (const Stop& stop : system.stops) {
    if (stop.is_compliant() || !stop.restitution().is_constant() ||
        !(stop.restitution().at(0.0) > 0.0))
      return false;
    reach = std::max(reach, std::abs(stop.gap));
  }
  // With all gaps 0 the state decides on the form of the flow (ExactFlow::for_start).
  return reach > 0.0;
}

// P of Re(P e^{i order theta}); none for a course, or where it is taken from rest.
std::optional<LaneForm::Responses> responses_to(const System& system, const Harmonic& harmonic) {
  if (harmonic.timed) return {};
  LinearSystem<double> linear = linear_system<double>(system);
  linear.frequency *= harmonic.order;
  linear.amplitude = harmonic.cosine;
  const ExactFlow<double> even(linear);
  linear.amplitude = harmonic.sine;
  const ExactFlow<double> odd(linear);
  LaneForm::Responses responses;
  for (int j = 0; j < even.modes(); ++j) {
    const ModeFlow<double>&a = even.mode(j), &b = odd.mode(j);
    if (a.kind != ModeKind::kOscillatory || b.kind != ModeKind::kOscillatory) return {};
    responses.push_back({a.forced.re + b.forced.im, a.forced.im - b.forced.re});
  }
  return responses;
}

LaneSet bit(std::size_t lane) { return LaneSet{1} << lane; }

}  // namespace

std::optional<LaneForm> lane_form(const System& system, const ExactFlow<double>& flow) {
  if (!is_lane_like(system) || !(flow.period() <= longest_flight(system))) return {};
  for (int j = 0; j < flow.modes(); ++j)
    if (flow.mode(j).kind != ModeKind::kOscillatory) return {};
  const HarmonicForcing& forcing = *system.forcing();
  LaneForm form{{{1.0, {}}}, modal_forces(system).value()};
  for (int j = 0; j < flow.modes(); ++j) form.harmonics[0].responses.push_back(flow.mode(j).forced);
  double highest = 1.0;
  for (const Harmonic& harmonic : forcing.harmonics) {
    std::optional<LaneForm::Responses> responses = responses_to(system, harmonic);
    if (!responses) return {};
    form.harmonics.push_back({harmonic.order, std::move(*responses)});
    highest = std::max(highest, harmonic.order);
  }
  const double quickest = std::max(flow.turns().quickest, highest * forcing.frequency / 2.0);
  const double farthest = quickest * flow.period() + highest * std::abs(flow.phase({})) / 2.0;
  if (farthest > kFarthestHalfAngle) return {};
  return form;
}

void LaneMotions::adopt(std::size_t lane, const System& system, const ExactFlow<double>& flow,
                        const LaneForm& form, double closure_speed) {
  const auto set = [&](double value, auto... place) { columns_.row(place...)[lane] = value; };
  set(flow.period(), LaneRow::kPeriod);
  set(closure_speed, LaneRow::kSlowest);
  for (std::size_t k = 0; k < columns_.harmonics(); ++k) {
    const double order = form.harmonics[k].order;
    set(order * flow.frequency() / 2.0, LaneHarmonicRow::kHalfFrequency, k);
    set(order * flow.phase({}) / 2.0, LaneHarmonicRow::kHalfPhase, k);
  }
  for (std::size_t j = 0; j < columns_.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    set(mode.first, LaneModeRow::kDecay, j);
    set(mode.second / 2.0, LaneModeRow::kHalfFrequency, j);
    set(std::sqrt(mode.first * mode.first + mode.second * mode.second), LaneModeRow::kRate, j);
    set(1.0 / columns_.row(LaneModeRow::kRate, j)[lane], LaneModeRow::kPerRate, j);
    set(1.0 / mode.second, LaneModeRow::kPerFrequency, j);
    set(mode.offset, LaneModeRow::kOffset, j);
    set(form.forces[static_cast<Eigen::Index>(j)], LaneModeRow::kForce, j);
    for (std::size_t k = 0; k < columns_.harmonics(); ++k) {
      set(form.harmonics[k].responses[j].re, LaneAnswerRow::kRe, j, k);
      set(form.harmonics[k].responses[j].im, LaneAnswerRow::kIm, j, k);
    }
  }
  for (std::size_t i = 0; i < columns_.stops(); ++i)
    adopt_stop(lane, system.stops[i], i, flow, form);
}

void LaneMotions::adopt_stop(std::size_t lane, const Stop& stop, std::size_t i,
                             const ExactFlow<double>& flow, const LaneForm& form) {
  const auto set = [&](double value, auto... place) { columns_.row(place...)[lane] = value; };
  set(stop.gap, LaneStopRow::kGap, i);
  set(stop.restitution().at(0.0), LaneStopRow::kRestitution, i);
  const bool is_normal = stop.direction() == momentum_direction(stop.row);
  set(is_normal ? stop.row.squaredNorm() : 1.0, LaneStopRow::kNorm, i);
  for (std::size_t j = 0; j < columns_.modes(); ++j) {
    const ModeFlow<double>& mode = flow.mode(static_cast<int>(j));
    const double row = stop.row[static_cast<Eigen::Index>(j)];
    set(row, LanePairRow::kRow, i, j);
    set(is_normal ? row : stop.direction()[static_cast<Eigen::Index>(j)], LanePairRow::kDirection,
        i, j);
    const auto drift = [&](double rate) { return 1.0 + (rate + mode.first) / mode.second; };
    double apart = std::abs(mode.offset) * drift(flow.frequency());
    for (const LaneForm::Part& part : form.harmonics)
      apart += (std::abs(part.responses[j].re) + std::abs(part.responses[j].im)) *
               drift(part.order * flow.frequency());
    set(std::abs(row) * apart, LanePairRow::kFormedFrom, i, j);
  }
  for (std::size_t k = 0; k < columns_.harmonics(); ++k) {
    double re = 0.0, im = 0.0;
    for (std::size_t j = 0; j < columns_.modes(); ++j) {
      const double row = stop.row[static_cast<Eigen::Index>(j)];
      re -= row * form.harmonics[k].responses[j].re;
      im -= row * form.harmonics[k].responses[j].im;
    }
    set(re, LaneGapRow::kRe, i, k);
    set(im, LaneGapRow::kIm, i, k);
    set(std::hypot(re, im), LaneGapRow::kSize, i, k);
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
