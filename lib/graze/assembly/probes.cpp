#include "graze/assembly/probes.hpp"

#include "graze/structure/modal_model.hpp"

namespace graze {
std::vector<ProbeRow> probe_rows(const Scene& scene) {
  std::vector<ProbeRow> rows;
  std::vector<double> places;
  if (scene.span())
    for (const Probe& probe : scene.probes) places.push_back(probe.position);
  const std::vector<Vector> shapes =
      places.empty() ? std::vector<Vector>{} : shapes_at(scene, places);
  for (const Probe& probe : scene.probes) {
    ProbeRow row;
    row.quantity = probe.quantity;
    row.of_velocity = probe.quantity == ProbeQuantity::kVelocity;
    if (probe.quantity == ProbeQuantity::kStrain)
      row.row = strain_row(scene, probe.position);
    else if (scene.span())
      row.row = shapes[rows.size()];
    else
      row.row = Eigen::Map<const Vector>(probe.shape.data(),
                                         static_cast<Eigen::Index>(probe.shape.size()));
    if (is_of_hub(probe.quantity)) {
      row.of_velocity = probe.quantity == ProbeQuantity::kRate;
      row.angle = 1.0;
      row.row = Vector::Zero(scene.modes());
      rows.push_back(row);
      continue;
    }
    const bool of_the_point = probe.quantity == ProbeQuantity::kDisplacement ||
                              probe.quantity == ProbeQuantity::kVelocity;
    if (scene.hub && of_the_point) row.angle = scene.hub->radius + probe.position;
    rows.push_back(row);
  }
  return rows;
}

std::vector<ProbeRow> probe_rows(const Scene& scene, const System& system) {
  std::vector<ProbeRow> rows = probe_rows(scene);
  if (!system.turns()) return rows;
  for (ProbeRow& row : rows)
    row.row = row.angle * system.rotation()->angle + system.rotation()->beam.transpose() * row.row;
  return rows;
}

std::string MeasuredPlace::name(char between) const {
  return (probe ? "probe" : "stop") + (between + std::to_string((probe ? *probe : *stop) + 1));
}

std::vector<MeasuredPlace> measured_places(const Scene& scene, const System& system) {
  std::vector<MeasuredPlace> places;
  int index = 0;
  for (const ProbeRow& probe : probe_rows(scene, system))
    places.push_back({index++,
                      {},
                      unit_in(scene.units, probe_unit(probe.quantity)),
                      measured_row(system, probe.row, probe.of_velocity)});
  for (std::size_t i = 0; i < system.stops.size(); ++i) {
    const double side = scene.stops[i].side == Side::kBelow ? -1.0 : 1.0;
    places.push_back(
        {{}, static_cast<int>(i), unit_in(scene.units, "m"), measured_row(system, side * system.stops[i].row)});
  }
  return places;
}

std::vector<MeasuredRow> rows_of(const std::vector<MeasuredPlace>& places) {
  std::vector<MeasuredRow> rows;
  for (const MeasuredPlace& place : places) rows.push_back(place.seen);
  return rows;
}

std::string probe_unit(ProbeQuantity quantity) {
  switch (quantity) {
    case ProbeQuantity::kDisplacement:
    case ProbeQuantity::kDeflection:
      return "m";
    case ProbeQuantity::kVelocity:
      return "m/s";
    case ProbeQuantity::kAngle:
      return "rad";
    case ProbeQuantity::kRate:
      return "rad/s";
    case ProbeQuantity::kStrain:
      break;
  }
  return "";
}

}  // namespace graze
