#include "graze/motion/detail/event_crowd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace graze {
namespace {

// Of a forcing period or of the slowest oscillation: a motion meets its stops a few times in it.
constexpr double kCrowded = 0.1;
constexpr std::size_t kMostStops = 6;  // named

constexpr std::array<std::pair<EventKind, const char*>, 6> kNames{
    {{EventKind::kImpact, "impact"},
     {EventKind::kContact, "contact"},
     {EventKind::kSeparation, "separation"},
     {EventKind::kChatter, "chatter"},
     {EventKind::kStick, "stick"},
     {EventKind::kRelease, "release"}}};

struct ProgressCounter {
  int stop = 0;
  long long all = 0;
  std::array<long long, kNames.size()> of_kind{};
  double slowest = 0.0, fastest = 0.0;  // of the impacts and contacts, m/s
};

std::string text_of(const ProgressCounter& counter) {
  std::string text = fmt::format("stop {}", counter.stop + 1);
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    const long long n = counter.of_kind[k];
    if (n == 0) continue;
    text += fmt::format(", {} {}{}", n, kNames[k].second, n == 1 ? "" : "s");
    if (kNames[k].first == EventKind::kImpact || kNames[k].first == EventKind::kContact)
      text += fmt::format(" at {:.1e} to {:.1e} m/s", counter.slowest, counter.fastest);
  }
  return text;
}

void count(ProgressCounter& counter, EventKind kind, double speed) {
  const auto place = std::find_if(kNames.begin(), kNames.end(),
                                  [kind](const auto& name) { return name.first == kind; });
  ++counter.of_kind[static_cast<std::size_t>(place - kNames.begin())];
  ++counter.all;
  if (kind != EventKind::kImpact && kind != EventKind::kContact) return;
  const bool first = counter.fastest == 0.0;
  counter.slowest = first ? speed : std::min(counter.slowest, speed);
  counter.fastest = std::max(counter.fastest, speed);
}

}  // namespace

void EventCrowd::add(const Event& event) {
  last_[count_++ % kKept] = {event.kind, event.stop, event.time, event.speed};
}

std::string EventCrowd::sentence(double span) const {
  if (count_ < kKept) return {};
  const double took = last_[(count_ - 1) % kKept].time - last_[count_ % kKept].time;
  if (!(took < kCrowded * span)) return {};
  std::vector<ProgressCounter> tallies;
  for (const Kept& kept : last_) {
    auto own = std::find_if(tallies.begin(), tallies.end(), [&](const ProgressCounter& counter) {
      return counter.stop == kept.stop;
    });
    if (own == tallies.end()) own = tallies.insert(tallies.end(), ProgressCounter{kept.stop});
    count(*own, kept.kind, kept.speed);
  }
  std::sort(tallies.begin(), tallies.end(), [](const ProgressCounter& a, const ProgressCounter& b) {
    return std::pair(-a.all, a.stop) < std::pair(-b.all, b.stop);
  });
  std::string text = fmt::format("; the last {} events took {:.2g} s: ", kKept, took);
  for (std::size_t i = 0; i < std::min(tallies.size(), kMostStops); ++i)
    text += (i > 0 ? "; " : "") + text_of(tallies[i]);
  if (tallies.size() > kMostStops)
    text += fmt::format("; and {} stops more", tallies.size() - kMostStops);
  return text;
}

}  // namespace graze
