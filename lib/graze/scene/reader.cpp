#include "graze/scene/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/scene/check.hpp"
#include "graze/scene/detail/document.hpp"
#include "graze/scene/detail/hub_reader.hpp"
#include "graze/scene/detail/keys.hpp"
#include "graze/scene/detail/probe_reader.hpp"
#include "graze/scene/detail/settings.hpp"
#include "graze/scene/detail/spring_reader.hpp"
#include "graze/scene/detail/suggestion.hpp"
#include "graze/scene/detail/table_reader.hpp"
#include "graze/scene/detail/text_file.hpp"

namespace graze {
namespace {

const std::string kPositive = "a number greater than 0";

Beam read_beam(const Node& node, Origins& origins) {
  const TableReader table(node, "beam", origins);
  Beam beam;
  beam.length = table.number("length", kPositive + ", in m");
  beam.youngs_modulus = table.number("youngs_modulus", kPositive + ", in Pa");
  beam.second_moment = table.number("second_moment", kPositive + ", in m^4");
  beam.density = table.number("density", kPositive + ", in kg/m^3");
  beam.area = table.number("area", kPositive + ", in m^2");
  if (table.has("thickness")) beam.thickness = table.number("thickness", kPositive + ", in m");
  const std::string modes = "an integer from 1 to 400";
  const std::int64_t count = table.integer("modes", modes);
  if (count < 1 || count > kMostModes) {
    table.refuse("modes", modes);
  }
  beam.modes = static_cast<int>(count);
  beam.discretisation = table.choice<Projection>(
      "discretisation",
      {{"galerkin", Projection::kGalerkin}, {"collocation", Projection::kCollocation}});
  beam.points = table.numbers("points", "a list of numbers in m, one per mode");
  if (table.has("points") && beam.points.empty()) {
    table.fail("points", "the list is empty, it must have one number in m per mode");
  }
  return beam;
}

ModalStructure read_modal(const Node& node, Origins& origins) {
  const TableReader table(node, "modal", origins);
  const std::string what = "a list of numbers, one per mode";
  ModalStructure modal;
  table.required("frequencies", "a list of numbers in rad/s, one per mode");
  modal.frequencies = table.numbers("frequencies", "a list of numbers in rad/s, one per mode");
  const auto optional_list = [&](const std::string& key) {
    std::vector<double> values = table.numbers(key, what);
    if (table.has(key) && values.empty()) {
      table.fail(key, "the list is empty, it must have one number per mode");
    }
    return values;
  };
  modal.damping_ratios = optional_list("damping_ratios");
  modal.participation = optional_list("participation");
  modal.inertia = optional_list("inertia");
  return modal;
}

Damping read_damping(const Node& node, Origins& origins) {
  const TableReader table(node, "damping", origins);
  const NodeTable& members = *node.as<NodeTable>();
  const std::string allowed = "exactly one of viscous, ratios and rayleigh";
  if (members.empty()) {
    throw InputError(node.place.location(), "damping",
                     fmt::format("the table is empty, it must hold {}", allowed));
  }
  if (members.size() > 1) {
    table.fail(members[1].key, fmt::format("{} is given already, the table must hold {}",
                                           table.path(members[0].key), allowed));
  }
  if (table.has("viscous")) {
    return ViscousDamping{table.number("viscous", "a number of at least 0, in N s/m^2")};
  }
  if (table.has("ratios")) {
    return DampingRatios{table.numbers("ratios", "a list of numbers, one per mode")};
  }
  const TableReader rayleigh(*table.find("rayleigh"), "damping.rayleigh", origins);
  return RayleighDamping{rayleigh.number("mass", "a number of at least 0, in 1/s"),
                         rayleigh.number("stiffness", "a number of at least 0, in s")};
}

Forcing read_forcing(const Node& node, bool modal, Origins& origins) {
  const TableReader table(node, "forcing", origins);
  Forcing forcing;
  forcing.kind =
      modal ? table.choice<ForcingKind>(
                  "kind", {{"modal", ForcingKind::kModal}, {"base", ForcingKind::kBase}})
            : table.choice<ForcingKind>("kind", {{"base", ForcingKind::kBase},
                                                 {"distributed", ForcingKind::kDistributed}});
  forcing.amplitude =
      table.number("amplitude", modal ? "a number" : "a number, in m (base) or N/m (distributed)");
  forcing.frequency = table.number("frequency", kPositive + ", in rad/s");
  forcing.phase = table.number_or("phase", "a number in rad", 0.0);
  return forcing;
}

Gravity read_gravity(const Node& node, Origins& origins) {
  const TableReader table(node, "gravity", origins);
  return Gravity{table.number("acceleration", "a number in m/s^2")};
}

// A number is the list of one entry.
std::vector<double> read_restitution(const TableReader& table) {
  const std::string key = "restitution";
  const std::string what = "a number from 0 to 1 or a list [a0, a1, ..] of numbers";
  if (table.required(key, what).as<NodeList>() != nullptr) {
    return table.numbers(key, what);
  }
  return {table.number(key, what)};
}

SceneStop read_stop(const Node& node, const std::string& path, bool modal, Origins& origins) {
  const TableReader table(node, path, origins);
  SceneStop stop;
  if (modal) {
    if (table.has("position")) {
      table.fail("position", "a stop of a [modal] structure has no position, it must have a shape");
    }
    const std::string what = "a list of numbers, the mode shapes at the stop";
    table.required("shape", what);
    stop.shape = table.numbers("shape", what);
  } else {
    if (table.has("shape")) {
      table.fail("shape", "a stop of a [beam] has no shape, it must have a position");
    }
    stop.position = table.number("position", "a number in m from the clamp");
  }
  stop.gap = table.number("gap", "a number in m");
  stop.side = table.choice<Side>("side", {{"above", Side::kAbove}, {"below", Side::kBelow}});
  if (const Node* spring = table.find("spring")) {
    for (const char* key : {"restitution", "impulse"}) {
      if (table.has(key)) {
        table.fail(key, "a stop with a spring has none, it must be left out");
      }
    }
    stop.spring = read_spring(*spring, path + ".spring", origins);
    return stop;
  }
  stop.restitution = read_restitution(table);
  stop.impulse = table.choice<Impulse>(
      "impulse", {{"momentum", Impulse::kMomentum}, {"collocation", Impulse::kCollocation}});
  return stop;
}

std::vector<SceneStop> read_stops(const Node& node, bool modal, Origins& origins) {
  std::vector<SceneStop> stops;
  for (const Node& entry : tables_of(node, "stop"))
    stops.push_back(read_stop(entry, numbered_path("stop", stops.size() + 1), modal, origins));
  return stops;
}

Initial read_initial(const Node& node, int modes, bool hub, Origins& origins) {
  const TableReader table(node, "initial", origins);
  const std::string what = "a list of numbers, one per mode";
  const auto list = [&](const std::string& key) {
    return table.has(key) ? table.numbers(key, what)
                          : std::vector<double>(static_cast<std::size_t>(modes), 0.0);
  };
  Initial initial{list("q"), list("qdot")};
  for (const char* key : {"angle", "rate"}) {
    if (table.has(key) && !hub) {
      table.fail(key, "it is that of a [hub], without one it must be left out");
    }
  }
  initial.angle = table.number_or("angle", "a number in rad", 0.0);
  initial.rate = table.number_or("rate", "a number in rad/s", 0.0);
  return initial;
}

Solver read_solver(const Node& node, Origins& origins) {
  const TableReader table(node, "solver", origins);
  Solver solver;
  std::vector<std::pair<std::string, FlowChoice>> flows;
  for (const FlowChoice flow :
       {FlowChoice::kAuto, FlowChoice::kExact, FlowChoice::kRk4, FlowChoice::kDopri5,
        FlowChoice::kFehlberg78, FlowChoice::kBulirschStoer})
    flows.emplace_back(flow_name(flow), flow);
  solver.flow = table.choice<FlowChoice>("flow", flows);
  solver.tolerance = table.number_or("tolerance", "a number between 0 and 1", Solver().tolerance);
  if (table.has("step")) solver.step = table.number("step", "a number in s");
  return solver;
}

void read_structure(const TableReader& root, Scene& scene, Origins& origins) {
  const Node* beam = root.find("beam");
  const Node* modal = root.find("modal");
  if (beam == nullptr && modal == nullptr) {
    root.fail("scene", "a scene needs [beam] or [modal], it must have exactly one of them");
  }
  if (beam != nullptr && modal != nullptr) {
    root.fail("modal",
              "the scene has a [beam] already, it must have exactly one of [beam] and "
              "[modal]");
  }
  if (beam != nullptr) {
    scene.structure = read_beam(*beam, origins);
  } else {
    scene.structure = read_modal(*modal, origins);
  }
}

Scene read_root(const Node& node, const std::filesystem::path& folder) {
  const auto origins = std::make_shared<Origins>();
  const TableReader root(node, "", *origins);
  Scene scene;
  scene.title = root.text_or("title", "");
  read_structure(root, scene, *origins);
  const bool modal = scene.modal() != nullptr;
  if (const Node* hub = root.find("hub")) {
    scene.hub = read_hub(*hub, folder, *origins);
  }
  if (const Node* damping = root.find("damping")) {
    scene.damping = read_damping(*damping, *origins);
  }
  if (const Node* forcing = root.find("forcing")) {
    scene.forcing = read_forcing(*forcing, modal, *origins);
  }
  if (const Node* gravity = root.find("gravity")) {
    scene.gravity = read_gravity(*gravity, *origins);
  }
  if (const Node* stops = root.find("stop")) {
    scene.stops = read_stops(*stops, modal, *origins);
  }
  if (const Node* probes = root.find("probe")) {
    scene.probes = read_probes(*probes, modal, *origins);
  }
  if (const Node* initial = root.find("initial")) {
    scene.initial = read_initial(*initial, scene.modes(), scene.hub.has_value(), *origins);
  }
  if (const Node* solver = root.find("solver")) {
    scene.solver = read_solver(*solver, *origins);
  }
  scene.origins = origins;
  return scene;
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<std::string>& settings) {
  Node root = read_document(text, name);
  for (const std::string& setting : settings) {
    apply_setting(root, setting);
  }
  Scene scene = read_root(root, std::filesystem::path(name).parent_path());
  check_scene(scene);
  return scene;
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& settings) {
  return parse_scene(read_text_file(file, "a scene"), file.string(), settings);
}

}  // namespace graze
