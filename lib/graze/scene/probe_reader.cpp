#include "graze/scene/detail/probe_reader.hpp"

#include <string>
#include <utility>

#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/table_reader.hpp"

namespace graze {
namespace {

Probe read_probe(const Node& node, const std::string& path, bool modal, Origins& origins) {
  const TableReader table(node, path, origins);
  Probe probe;
  std::vector<std::pair<std::string, ProbeQuantity>> quantities;
  for (const ProbeQuantity quantity :
       {ProbeQuantity::kDisplacement, ProbeQuantity::kVelocity, ProbeQuantity::kDeflection,
        ProbeQuantity::kStrain, ProbeQuantity::kAngle, ProbeQuantity::kRate})
    quantities.emplace_back(probe_quantity_name(quantity), quantity);
  probe.quantity = table.choice<ProbeQuantity>("quantity", quantities);
  if (is_of_hub(probe.quantity)) {
    for (const char* key : {"position", "shape"})
      if (table.has(key))
        table.fail(key, "angle and rate are those of the hub, it must be left out");
    return probe;
  }
  if (modal) {
    if (table.has("position"))
      table.fail("position",
                 "a probe of a [modal] structure has no position, it must have a shape");
    const std::string what = "a list of numbers, the mode shapes at the probe";
    table.required("shape", what);
    probe.shape = table.numbers("shape", what);
  } else {
    if (table.has("shape"))
      table.fail("shape", "a probe of a [beam] has no shape, it must have a position");
    probe.position = table.number("position", "a number in m from the clamp");
  }
  return probe;
}

}  // namespace

std::vector<Probe> read_probes(const Node& node, bool modal, Origins& origins) {
  std::vector<Probe> probes;
  for (const Node& entry : tables_of(node, "probe"))
    probes.push_back(read_probe(entry, numbered_path("probe", probes.size() + 1), modal, origins));
  return probes;
}

}  // namespace graze
