#include "graze/assembly/beam_shape.hpp"

#include "graze/assembly/probes.hpp"

namespace graze {

std::optional<BeamPlaces> beam_places(const Scene& scene, int places) {
  if (!scene.span() || scene.hub) return {};
  BeamPlaces made;
  made.structure = scene.structure_name();
  Scene seen = scene;
  seen.probes.clear();
  for (int i = 0; i < places; ++i) {
    Probe probe;
    probe.position = scene.span()->length * i / (places - 1);
    made.x.push_back(probe.position);
    seen.probes.push_back(probe);
  }
  const std::vector<ProbeRow> rows = probe_rows(seen);
  made.rows.resize(places, rows.front().row.size());
  for (int i = 0; i < places; ++i) made.rows.row(i) = rows[static_cast<std::size_t>(i)].row;
  for (const SceneStop& stop : scene.stops) {
    const bool is_above = stop.side == Side::kAbove;
    made.stops.push_back({stop.position, is_above ? stop.gap : -stop.gap, is_above});
  }
  return made;
}

}  // namespace graze
