#include "graze/record/names/motion_names.hpp"

#include <fmt/format.h>

#include "graze/base/angle.hpp"

namespace graze {

std::string name_of(SweepDirection direction) {
  switch (direction) {
    case SweepDirection::kUp:
      return "up";
    case SweepDirection::kDown:
      return "down";
    case SweepDirection::kFresh:
      break;
  }
  return "fresh";
}

std::string name_of(SweepStart start) {
  switch (start) {
    case SweepStart::kScene:
      return "scene";
    case SweepStart::kHandedOn:
      return "handed on";
    case SweepStart::kAnew:
      break;
  }
  return "anew";
}

std::string name_of(SweepStatus status) {
  switch (status) {
    case SweepStatus::kSettled:
      return "settled";
    case SweepStatus::kApproaching:
      return "approaching";
    case SweepStatus::kNotPeriodic:
      return "not periodic";
    case SweepStatus::kImpactBudget:
      return "impact budget";
    case SweepStatus::kRefused:
      return "refused";
    case SweepStatus::kNoStart:
      break;
  }
  return "no start";
}

std::string name_of(DiagramSection section) {
  return section == DiagramSection::kImpact ? "impact" : "stroboscopic";
}

std::string attractor_kind(const AttractorClass& attractor) {
  if (attractor.wandering == Wandering::kTorus) return "torus";
  if (attractor.wandering == Wandering::kChaos) return "chaos";
  if (attractor.period == 0) return name_of(attractor.status);
  switch (attractor.kind) {
    case SettledKind::kImpacts:
      return "impacts";
    case SettledKind::kSticks:
      return "sticking";
    case SettledKind::kAtRest:
      return "at rest";
    default:
      return "clear";
  }
}

std::string orbit_label(int period, long long impacts, bool sticks) {
  if (sticks) return fmt::format("({},stick)", period);
  return impacts == 0 ? "no impact" : fmt::format("({},{})", period, impacts);
}

std::string attractor_label(const AttractorClass& attractor) {
  const bool sticks = attractor.kind == SettledKind::kSticks;
  if (attractor.period > 0 && (sticks || attractor.kind == SettledKind::kImpacts))
    return orbit_label(attractor.period, attractor.impacts, sticks);
  return attractor_kind(attractor);
}

std::string attractor_title(const AttractorClass& attractor) {
  const std::string label = attractor_label(attractor);
  return label == "clear" ? orbit_label(attractor.period, 0, false) : label;
}

std::size_t stops_seen(const SweepRow& row) {
  return row.stop_states.empty() ? 0 : static_cast<std::size_t>(row.stop_states.back().stop + 1);
}

long long period_index(const SweepRow& row, const MetImpact& impact) {
  const std::size_t stops = stops_seen(row), shown = stops > 0 ? row.stop_states.size() / stops : 0;
  return impact.period - (row.motion.periods - static_cast<long long>(shown));
}

double impact_phase(const MetImpact& impact) { return wrapped(impact.phase); }

std::string name_of(EventKind kind) {
  switch (kind) {
    case EventKind::kImpact:
      return "impact";
    case EventKind::kChatter:
      return "chatter";
    case EventKind::kStick:
    case EventKind::kFrictionStick:
      return "stick";
    case EventKind::kSlip:
      return "slip";
    case EventKind::kReversal:
      return "reversal";
    case EventKind::kContact:
      return "contact";
    case EventKind::kSeparation:
      return "separation";
    case EventKind::kRelease:
      break;
  }
  return "release";
}

std::string name_of(OrbitBranchEnd end) {
  switch (end) {
    case OrbitBranchEnd::kParameterLimit:
      return "parameter limit";
    case OrbitBranchEnd::kClosed:
      return "closed";
    case OrbitBranchEnd::kGrazing:
      return "GR";
    case OrbitBranchEnd::kChatterCompletes:
      return "CH";
    case OrbitBranchEnd::kLevel:
      return "UZ";
    case OrbitBranchEnd::kAtRest:
      return "at rest";
    case OrbitBranchEnd::kPeriodDoubling:
      return "PD";
    case OrbitBranchEnd::kSliding:
      return "sliding changes";
    case OrbitBranchEnd::kImpactsMeet:
      return "impacts meet";
    case OrbitBranchEnd::kStepLimit:
      return "step limit";
    case OrbitBranchEnd::kOutOfTime:
      return "time limit";
    case OrbitBranchEnd::kStopped:
      return "interrupted";
    case OrbitBranchEnd::kNotConverged:
      break;
  }
  return "not converged";
}

std::string words_beyond(const SpecialPoint& special) {
  if (!special.normal) return "";
  const std::string side = special.normal->opening > 0.0 ? "above" : "below";
  if (special.kind == SpecialKind::kFold) return "the orbits exist " + side;
  const bool is_torus = special.kind == SpecialKind::kTorus;
  const bool supercritical = (special.normal->coefficient > 0.0) != is_torus;
  // Beside a multiplier outside the circle nothing is stable.
  const bool others_inside = special.at.unstable_multipliers == 0;
  const std::string stable = supercritical ? "is stable and " : "is unstable and ";
  return std::string(supercritical ? "supercritical" : "subcritical") +
         (is_torus ? ": the torus " : ": the doubled orbit ") + (others_inside ? stable : "") +
         "exists " + side;
}

std::string name_of(OrbitLocusEnd end) {
  switch (end) {
    case OrbitLocusEnd::kFirstLimit:
      return "parameter limit";
    case OrbitLocusEnd::kSecondLimit:
      return "second limit";
    case OrbitLocusEnd::kClosed:
      return "closed";
    case OrbitLocusEnd::kGrazing:
      return "GR";
    case OrbitLocusEnd::kChatterCompletes:
      return "CH";
    case OrbitLocusEnd::kImpactsMeet:
      return "impacts meet";
    case OrbitLocusEnd::kResonance:
      return "resonance";
    case OrbitLocusEnd::kStepLimit:
      return "step limit";
    case OrbitLocusEnd::kOutOfTime:
      return "time limit";
    case OrbitLocusEnd::kStopped:
      return "interrupted";
    case OrbitLocusEnd::kNotConverged:
      break;
  }
  return "not converged";
}

std::string stability_word(const std::optional<bool>& stable) {
  if (!stable) return "on the circle";
  return *stable ? "yes" : "no";
}

}  // namespace graze
