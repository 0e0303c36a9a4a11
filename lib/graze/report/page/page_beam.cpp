#include "graze/report/page/detail/page_beam.hpp"

#include <algorithm>
#include <cmath>

#include "graze/report/json/detail/json_page.hpp"

namespace graze {

Json beam_json(const SimulationRecord& record) {
  if (!record.beam || record.samples.empty()) return nullptr;
  const BeamPlaces& beam = *record.beam;
  std::vector<float> rows, q;
  for (Eigen::Index i = 0; i < beam.rows.rows(); ++i)
    for (Eigen::Index j = 0; j < beam.rows.cols(); ++j)
      rows.push_back(static_cast<float>(beam.rows(i, j)));
  std::vector<double> t;
  AxisRange bent;
  bent.include(0.0);
  for (const Sample& sample : record.samples) {
    t.push_back(sample.time);
    const Vector own = structure_state(record.system, sample.state, sample.phase).q;
    for (const double coordinate : own) q.push_back(static_cast<float>(coordinate));
    const Vector u = beam.rows * own;
    bent.include(u.minCoeff());
    bent.include(u.maxCoeff());
  }
  const double size = std::max(std::abs(bent.low), std::abs(bent.high));
  Json stops = Json::array();
  for (const BeamStop& stop : beam.stops) {
    if (std::abs(stop.u) <= 1.5 * size) bent.include(stop.u);
    stops.push_back({{"x", stop.x}, {"u", stop.u}, {"above", stop.is_above}});
  }
  AxisRange along;
  along.include(0.0);
  along.include(beam.x.back());
  return {{"x", packed(beam.x)},
          {"rows", packed(rows)},
          {"t", packed(t)},
          {"q", packed(q)},
          {"stops", stops},
          {"along", page_axis("place along the beam", unit_in(record.info.units, "m"), along, 0.0)},
          {"bent", page_axis("displacement", unit_in(record.info.units, "m"), bent, 0.05)}};
}

}  // namespace graze
