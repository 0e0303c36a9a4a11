#include "graze/assembly/beam_shape.hpp"

#include "graze/assembly/probes.hpp"

namespace graze {

BeamRows beam_rows(const Scene& scene, int places) {
  BeamRows made;
  Scene seen = scene;
  seen.probes.clear();
  for (int i = 0; i < places; ++i) {
    Probe probe;
    probe.position = scene.beam()->length * i / (places - 1);
    made.x.push_back(probe.position);
    seen.probes.push_back(probe);
  }
  const std::vector<ProbeRow> rows = probe_rows(seen);
  made.rows.resize(places, rows.empty() ? 0 : rows.front().row.size());
  for (int i = 0; i < places; ++i) made.rows.row(i) = rows[static_cast<std::size_t>(i)].row;
  return made;
}

}  // namespace graze
