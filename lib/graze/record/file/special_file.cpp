#include "graze/record/file/detail/special_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "graze/assembly/assembly.hpp"
#include "graze/bifurcation/problem/detail/special_names.hpp"
#include "graze/orbit/problem/detail/section_map.hpp"
#include "graze/record/file/detail/files.hpp"
#include "graze/record/file/detail/motion_table.hpp"
#include "graze/record/file/detail/state_lines.hpp"
#include "graze/record/file/detail/state_table.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/scene/detail/document.hpp"
#include "graze/scene/detail/text_check.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

// What the numbers of the file mean; another meaning is another format.
constexpr long long kSpecialFormat = 1;
// As many as a scene or a search is allowed.
constexpr long long kMostOrbitPeriods = 1'000'000;

constexpr std::array<SpecialKind, 7> kKinds = {
    SpecialKind::kFold,        SpecialKind::kPeriodDoubling, SpecialKind::kTorus,
    SpecialKind::kBranchPoint, SpecialKind::kGrazing,        SpecialKind::kChatterCompletes,
    SpecialKind::kLiftOff};
// The impacts, one list of each quantity: phases, and the states one after the other.
void write_impacts(StateLines& lines, const std::string& prefix,
                   const std::vector<ImpactPoint>& impacts) {
  std::vector<double> theta, q, qdot;
  for (const ImpactPoint& impact : impacts) {
    theta.push_back(impact.theta);
    q.insert(q.end(), impact.before.q.begin(), impact.before.q.end());
    qdot.insert(qdot.end(), impact.before.qdot.begin(), impact.before.qdot.end());
  }
  lines.numbers(prefix + "theta", theta);
  lines.numbers(prefix + "q", q);
  lines.numbers(prefix + "qdot", qdot);
}

std::vector<ImpactPoint> read_impacts(const StateTable& table, const std::string& prefix,
                                      std::size_t count, const System& system) {
  const auto modes = static_cast<std::size_t>(system.modes());
  const std::vector<double> theta = table.numbers(prefix + "theta", count),
                            q = table.numbers(prefix + "q", count * modes),
                            qdot = table.numbers(prefix + "qdot", count * modes);
  std::vector<ImpactPoint> impacts;
  for (std::size_t i = 0; i < count; ++i)
    impacts.push_back({theta[i],
                       {Eigen::Map<const Vector>(q.data() + i * modes, system.modes()),
                        Eigen::Map<const Vector>(qdot.data() + i * modes, system.modes())}});
  return impacts;
}

// One state after the other.
Vector side_by_side(const std::vector<MotionState<double>>& states,
                    Vector MotionState<double>::*part) {
  Vector list(0);
  for (const MotionState<double>& state : states) {
    const Vector& more = state.*part;
    list.conservativeResize(list.size() + more.size());
    list.tail(more.size()) = more;
  }
  return list;
}

void write_followed(StateLines& lines, const SpecialOrbit& point) {
  const SpecialOrbit::Followed& at = *point.followed;
  lines.table(point.sticks() ? "[special.sticking]" : "[special.compliant]");
  lines.count("period", at.period);
  lines.number("value", at.value);
  lines.number("closure_speed", at.closure_speed);
  if (point.sticks()) return write_motion(lines, "[special.sticking.motion]", at.states.front());
  lines.numbers("q", side_by_side(at.states, &MotionState<double>::q));
  lines.numbers("qdot", side_by_side(at.states, &MotionState<double>::qdot));
}

void write_point(StateLines& lines, const SpecialOrbit& point) {
  lines.table("[[special]]");
  lines.word("id", point.id);
  lines.word("label", point.label);
  if (point.locus) lines.word("locus", label_of(*point.locus));
  lines.numbers("values", point.values);
  if (point.multiplier)
    lines.numbers("multiplier", std::vector{point.multiplier->real(), point.multiplier->imag()});
  lines.flag("by_speed", point.by_speed);
  lines.flag("by_push", point.by_push);
  if (!point.impacts.empty()) {
    lines.count("period", point.pattern.period);
    lines.text("stops",
               listed(point.pattern.stops, [](int stop) { return std::to_string(stop + 1); }));
    write_impacts(lines, "", point.impacts);
  }
  if (point.along) {
    lines.number("along_value", point.along->value);
    write_impacts(lines, "along_", point.along->impacts);
  }
  if (point.followed) write_followed(lines, point);
}

int read_period(const StateTable& table) {
  const long long period = table.count("period");
  if (period < 1 || period > kMostOrbitPeriods) table.fail("period", "an orbit has no such period");
  return static_cast<int>(period);
}

SpecialOrbit::Followed read_sticking(const Node& node, const Scene& scene,
                                     const std::vector<std::string>& parameters,
                                     const std::vector<double>& values) {
  const std::string path = "special.sticking";
  const StateTable table(node, path, {"period", "value", "closure_speed", "motion"});
  const double value = table.number("value");
  // Its clock is that of the value, whose forcing period may be another one.
  Scene there = with_parameter(scene, parameters.front(), value);
  for (std::size_t i = 1; i < parameters.size(); ++i)
    there = with_parameter(there, parameters[i], values[i]);
  SpecialOrbit::Followed followed{
      read_period(table),
      value,
      {read_motion(table.at("motion"), path + ".motion", assemble(there))},
      table.size("closure_speed")};
  if (closed_stops(followed.states.front()).empty())
    table.fail("motion", "no stop is closed in it");
  return followed;
}

SpecialOrbit::Followed read_compliant(const Node& node, const System& system) {
  const StateTable table(node, "special.compliant",
                         {"period", "value", "closure_speed", "q", "qdot"});
  const auto modes = static_cast<std::size_t>(system.modes());
  const int period = read_period(table);
  const auto count = static_cast<std::size_t>(period) * modes;
  SpecialOrbit::Followed followed{period, table.number("value"), {}, table.size("closure_speed")};
  const std::vector<double> q = table.numbers("q", count), qdot = table.numbers("qdot", count);
  for (std::size_t i = 0; i < count; i += modes)
    followed.states.push_back(
        Motion<double>(system, {}, Eigen::Map<const Vector>(q.data() + i, system.modes()),
                       Eigen::Map<const Vector>(qdot.data() + i, system.modes()))
            .state());
  return followed;
}

void read_names(const StateTable& table, SpecialOrbit& point) {
  point.id = table.word("id");
  point.label = table.word("label");
  if (table.find("locus")) {
    const std::string name = table.word("locus");
    for (const OrbitLocusKind kind : kOrbitLocusKinds)
      if (name == label_of(kind)) point.locus = kind;
    if (!point.locus) table.fail("locus", fmt::format("there is no locus called {}", quoted(name)));
    return;
  }
  for (const SpecialKind kind : kKinds)
    if (point.label == label_of(kind)) point.kind = kind;
  if (!point.kind)
    table.fail("label",
               fmt::format("there is no special point called {}", graze::quoted(point.label)));
}

void read_pattern(const StateTable& table, const System& system, SpecialOrbit& point) {
  point.pattern.period = read_period(table);
  for (const long long stop : table.counts("stops")) {
    if (stop < 1 || stop > static_cast<long long>(system.stops.size()))
      table.fail("stops", "the scene has no such stop");
    point.pattern.stops.push_back(static_cast<int>(stop) - 1);
  }
  if (point.pattern.stops.empty()) table.fail("stops", "an orbit has at least one impact");
  const std::size_t count = point.pattern.stops.size();
  point.impacts = read_impacts(table, "", count, system);
  if (!table.find("along_value")) return;
  point.along = {read_impacts(table, "along_", count, system), table.number("along_value")};
}

SpecialOrbit read_point(const Node& node, const Scene& scene, const System& system,
                        const std::vector<std::string>& parameters) {
  const StateTable table(node, "special",
                         {"id", "label", "locus", "values", "multiplier", "by_speed", "by_push",
                          "period", "stops", "theta", "q", "qdot", "along_value", "along_theta",
                          "along_q", "along_qdot", "sticking", "compliant", "strobe"});
  SpecialOrbit point;
  read_names(table, point);
  point.values = table.numbers("values", parameters.size());
  if (table.find("multiplier")) {
    const std::vector<double> parts = table.numbers("multiplier", 2);
    point.multiplier = {parts[0], parts[1]};
  }
  point.by_speed = table.flag("by_speed");
  point.by_push = table.flag("by_push");
  if (const Node* sticking = table.find("sticking"))
    point.followed = read_sticking(*sticking, scene, parameters, point.values);
  else if (const Node* compliant = table.find("compliant"))
    point.followed = read_compliant(*compliant, system);
  else if (const Node* old = table.find("strobe"))  // its name before 0.1.0
    point.followed = read_compliant(*old, system);
  else
    read_pattern(table, system, point);
  return point;
}

// Before any other key is looked at: is this such a file, and does it belong to the scene?
void check_origin(const Node& root, const Scene& scene) {
  const auto* members = root.as<NodeTable>();
  const Node* format = members ? find_member(*members, "graze_special") : nullptr;
  if (!format)
    throw InputError(root.place.location(), "graze_special",
                     "the key is missing, these are not the special points of a run");
  const auto* number = format->as<std::int64_t>();
  if (!number || *number != kSpecialFormat)
    throw InputError(format->place.location(), "graze_special",
                     fmt::format("{} is the format of another version, this one reads {}",
                                 node_description(*format), kSpecialFormat));
  const Node* sha = find_member(*members, "scene_sha256");
  const auto* word = sha ? sha->as<std::string>() : nullptr;
  if (!word || *word != sha256(write_scene(scene)))
    throw InputError((sha ? *sha : root).place.location(), "scene_sha256",
                     "the scene.toml beside it is not the one of this run any more");
}

}  // namespace

std::string write_special_points(const SpecialPoints& special) {
  StateLines lines(
      "Special points with their orbits: graze continue SCENE --restart DIR --label ID goes on "
      "from one.");
  lines.count("graze_special", kSpecialFormat);
  lines.word("version", special.version);
  lines.word("scene_sha256", special.scene_sha256);
  StateLines body;
  for (const SpecialOrbit& point : special.points) write_point(body, point);
  const std::string points = body.take();
  lines.word("points_sha256", sha256(points));
  lines.text("parameters", listed(special.parameters,
                                  [](const std::string& name) { return graze::quoted(name); }));
  return lines.take() + points;
}

SpecialPoints parse_special_points(const std::string& text, const std::string& name,
                                   const Scene& scene) {
  const Node root = read_document(text, name);
  check_origin(root, scene);
  const StateTable table(
      root, "",
      {"graze_special", "version", "scene_sha256", "points_sha256", "parameters", "special"});
  SpecialPoints special{table.word("version"), table.word("scene_sha256"), {}, {}};
  special.parameters = table.words("parameters");
  for (const std::string& parameter : special.parameters)
    if (!parameter_value(scene, parameter))
      table.fail("parameters", fmt::format("the scene has no parameter {}", quoted(parameter)));
  if (special.parameters.empty() || special.parameters.size() > 2)
    table.fail("parameters", "there are one or two");
  const System system = assemble(scene);
  if (table.find("special"))
    for (const Node& node : table.list("special"))
      special.points.push_back(read_point(node, scene, system, special.parameters));
  // What is read well may still have been cut off at the end of a point, or changed.
  const std::size_t points = std::min(text.find("\n[[special]]"), text.size());
  if (table.word("points_sha256") != sha256(text.substr(points)))
    table.fail("points_sha256", "the special points below have been changed since the run");
  return special;
}

SpecialPoints read_special_points(const std::filesystem::path& file, const Scene& scene) {
  return parse_special_points(read_file(file, kLargestText), file.string(), scene);
}

}  // namespace graze
