#include "graze/motion/detail/event_crowd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace graze {
namespace {

// Part of a forcing period or of the slowest oscillation, in which a motion usually meets its stops
// a few times.
constexpr double kCrowded = 0.1;
constexpr std::size_t kMostStops = 6;  // named

constexpr std::array<std::pair<EventKind, const char*>, 9> kNames{
    {{EventKind::kImpact, "impact"},
     {EventKind::kContact, "contact"},
     {EventKind::kSeparation, "separation"},
     {EventKind::kChatter, "chatter"},
     {EventKind::kStick, "stick"},
     {EventKind::kRelease, "release"},
     {EventKind::kSlip, "slip"},
     {EventKind::kReversal, "reversal"},
     {EventKind::kFrictionStick, "stick"}}};

struct EventCount {
  int stop = 0;
  long long all = 0;
  std::array<long long, kNames.size()> of_kind{};
  double slowest = 0.0, fastest = 0.0;  // of the impacts and contacts, m/s
};

std::string text_of(const EventCount& counted, Units units) {
  std::string text = counted.stop < 0 ? "friction" : fmt::format("stop {}", counted.stop + 1);
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    const long long n = counted.of_kind[k];
    if (n == 0) continue;
    text += fmt::format(", {} {}{}", n, kNames[k].second, n == 1 ? "" : "s");
    if (kNames[k].first == EventKind::kImpact || kNames[k].first == EventKind::kContact)
      text += fmt::format(" at {:.1e} to {:.1e}{}", counted.slowest, counted.fastest,
                          unit_behind(units, "m/s"));
  }
  return text;
}

void count(EventCount& counted, EventKind kind, double speed) {
  const auto place = std::find_if(kNames.begin(), kNames.end(),
                                  [kind](const auto& name) { return name.first == kind; });
  ++counted.of_kind[static_cast<std::size_t>(place - kNames.begin())];
  ++counted.all;
  if (kind != EventKind::kImpact && kind != EventKind::kContact) return;
  const bool first = counted.fastest == 0.0;
  counted.slowest = first ? speed : std::min(counted.slowest, speed);
  counted.fastest = std::max(counted.fastest, speed);
}

}  // namespace

std::string moment_text(double time, Units units) {
  return fmt::format("t = {:.9g}{}", time, unit_behind(units, "s"));
}

void EventCrowd::add(const Event& event) {
  last_[count_++ % kKept] = {event.kind, event.stop, event.time, event.speed};
}

std::string EventCrowd::sentence(double span, Units units) const {
  if (count_ < kKept) return {};
  const double took = last_[(count_ - 1) % kKept].time - last_[count_ % kKept].time;
  if (!(took < kCrowded * span)) return {};
  std::vector<EventCount> counts;
  for (const Kept& kept : last_) {
    auto own = std::find_if(counts.begin(), counts.end(),
                            [&](const EventCount& counted) { return counted.stop == kept.stop; });
    if (own == counts.end()) own = counts.insert(counts.end(), EventCount{kept.stop});
    count(*own, kept.kind, kept.speed);
  }
  std::sort(counts.begin(), counts.end(), [](const EventCount& a, const EventCount& b) {
    return std::pair(-a.all, a.stop) < std::pair(-b.all, b.stop);
  });
  std::string text =
      fmt::format("; the last {} events took {:.2g}{}: ", kKept, took, unit_behind(units, "s"));
  for (std::size_t i = 0; i < std::min(counts.size(), kMostStops); ++i)
    text += (i > 0 ? "; " : "") + text_of(counts[i], units);
  if (counts.size() > kMostStops)
    text += fmt::format("; and {} stops more", counts.size() - kMostStops);
  return text;
}

}  // namespace graze
