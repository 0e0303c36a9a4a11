// What the presence of keys decides about a table of a scene file, before these are read.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "graze/scene/detail/node.hpp"
#include "graze/scene/detail/table_reader.hpp"
#include "graze/scene/scene.hpp"

namespace graze {

// Prepares a table before its keys are read.
void prepare(const auto&, const Node&, auto&, const Scene&) {}

// The keys say which damping it is.
inline void prepare(const TableReader& table, const Node& node, Damping& damping, const Scene&) {
  const NodeTable& members = *node.as<NodeTable>();
  const std::string allowed = "exactly one of viscous, ratio, ratios and rayleigh";
  if (members.empty())
    throw InputError(node.place.location(), "damping",
                     fmt::format("the table is empty, it must hold {}", allowed));
  if (members.size() > 1)
    table.fail(members[1].key, fmt::format("{} is given already, the table must hold {}",
                                           table.path(members[0].key), allowed));
  if (table.has("ratio")) damping = DampingRatio{};
  if (table.has("ratios")) damping = DampingRatios{};
  if (table.has("rayleigh")) damping = RayleighDamping{};
}

// Which keys it has says of which kind it is, where it does not say so itself.
inline void infer_kind(const TableReader& table, HarmonicLoad& load, const Scene& scene) {
  if (table.has("kind")) return;
  const auto given = [&](const char* key) { return table.has(key); };
  constexpr std::array kPoints{"position", "shape", "node", "mass"};
  load.kind = std::any_of(kPoints.begin(), kPoints.end(), given)        ? ForcingKind::kPoint
              : std::holds_alternative<ModalStructure>(scene.structure) ? ForcingKind::kModal
                                                                        : ForcingKind::kBase;
}

// Which keys a signal may have depends on whether it is drawn.
inline void prepare(const TableReader& table, const Node&, SignalSource& signal, const Scene&) {
  if (table.has("spectrum")) signal.spectrum = "to be read";
}

// A signal has neither frequency nor phase, and is taken as it is.
inline void prepare_signal(const TableReader& table, HarmonicLoad& load) {
  if (!table.has("signal")) return;
  for (const char* key : {"frequency", "frequency_hz"})
    if (table.has(key)) table.fail(key, "a signal has none, it must be left out");
  load.amplitude = 1.0;
}

inline void prepare(const TableReader& table, const Node&, HarmonicLoad& load, const Scene& scene) {
  infer_kind(table, load, scene);
  prepare_signal(table, load);
  const bool in_hertz = table.has("frequency_hz");
  if (in_hertz && table.has("frequency"))
    table.fail("frequency_hz", "the frequency is given already, it must be left out");
  if (!in_hertz && !table.has("frequency")) return;
  if (table.has("order"))
    table.fail("order", "the frequency is given already, it must be left out");
  load.own.emplace().in_hertz = in_hertz;
}

inline void prepare(const TableReader& table, const Node&, Forcing& forcing, const Scene& scene) {
  infer_kind(table, forcing, scene);
  prepare_signal(table, forcing);
  if (table.has("signal")) {
    forcing.frequency = 1.0;
    return;
  }
  forcing.frequency.in_hertz = table.has("frequency_hz");
  if (table.has("frequency_hz") && table.has("frequency"))
    table.fail("frequency_hz",
               "forcing.frequency is given already, the table must hold exactly one of frequency "
               "and frequency_hz");
}

inline void prepare(const TableReader& table, const Node&, Spring& spring, const Scene&) {
  if (table.has("radii") || table.has("moduli") || table.has("poisson")) {
    spring.geometry.emplace();
    spring.exponent = 1.5;  // Hertz's
  }
  // The unit of the stiffness depends on it.
  if (const Node* exponent = table.find("exponent")) {
    if (const auto* real = exponent->as<double>()) spring.exponent = *real;
    if (const auto* whole = exponent->as<std::int64_t>())
      spring.exponent = static_cast<double>(*whole);
  }
}

inline void prepare(const TableReader&, const Node&, Initial& initial, const Scene& scene) {
  initial.q.assign(static_cast<std::size_t>(scene.modes()), 0.0);
  initial.qdot = initial.q;
}

inline void prepare(const TableReader& root, const Node&, Scene& scene, const Scene&) {
  std::vector<std::string> given;
  for (const char* name : {"beam", "string", "bar", "modal", "matrices", "lumped"})
    if (root.has(name)) given.emplace_back(name);
  const std::string allowed =
      "exactly one of [beam], [string], [bar], [modal], [matrices] and [lumped]";
  if (given.empty())
    root.fail("scene", fmt::format("a scene needs a structure, it must have {}", allowed));
  if (given.size() > 1)
    root.fail(given.back(),
              fmt::format("the scene has a [{}] already, it must have {}", given.front(), allowed));
  if (given.front() == "string") scene.structure = TautString{};
  if (given.front() == "bar") scene.structure = Bar{};
  if (given.front() == "modal") scene.structure = ModalStructure{};
  if (given.front() == "matrices") scene.structure = MatrixStructure{};
  if (given.front() == "lumped") scene.structure = LumpedStructure{};
}

}  // namespace graze
