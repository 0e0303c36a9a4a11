#include "graze/scene/closed_modes.hpp"

#include <algorithm>

namespace graze {
namespace {

// Whether the span is held at its ends only and carries no masses.
bool is_bare(const Span& span) { return span.supports.empty() && span.masses.empty(); }

}  // namespace

bool is_tapered(const Section& section) {
  return std::max({section.width.size(), section.height.size(), section.diameter.size(),
                   section.inner_diameter.size()}) > 1;
}

bool has_closed_modes(const Scene& scene) {
  const Span* span = scene.span();
  if (span == nullptr || !is_bare(*span)) return false;
  if (const Beam* beam = scene.beam())
    return beam->pieces.empty() && !beam->tension && beam->ends == Beam{}.ends &&
           !(beam->section && is_tapered(*beam->section));
  if (const Bar* bar = scene.bar())
    return bar->pieces.empty() && !(bar->section && is_tapered(*bar->section));
  return true;
}

}  // namespace graze
