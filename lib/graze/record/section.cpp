#include "graze/record/section.hpp"

#include "graze/study/run_impact.hpp"

namespace graze {
namespace {

constexpr std::size_t kMostPoints = 1'000'000;

}  // namespace

void RunSection::add(const Event& event) {
  if (kind_ != DiagramSection::kImpact || event.time < from_ || !meets_stop(event)) return;
  add({event.time, event.stop, event.phase.value_or(0.0), event.speed});
}

void RunSection::add(const System& system, const Sample& sample) {
  if (kind_ != DiagramSection::kStroboscopic || sample.time < from_) return;
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const Vector& row = system.stops[i].row;
    add({sample.time, static_cast<int>(i), row.dot(sample.state.q), row.dot(sample.state.qdot)});
  }
}

void RunSection::add(const SectionPoint& point) {
  if (points_.size() < kMostPoints)
    points_.push_back(point);
  else
    ++left_out_;
}

}  // namespace graze
