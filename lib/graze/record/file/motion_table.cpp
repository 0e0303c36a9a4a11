#include "graze/record/file/detail/motion_table.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace graze {
namespace {

// Of a gap's zero: after a release at which the contact force vanishes without crossing zero.
constexpr int kLargestMultiplicity = 4;

// Beyond, a double cannot tell the periods apart.
constexpr long long kMostCountedPeriods = 1LL << 53;

const std::vector<std::pair<Contact, std::string>>& contact_names() {
  static const std::vector<std::pair<Contact, std::string>> names = {
      {Contact::kClear, "clear"},         {Contact::kTouching, "touching"},
      {Contact::kDeparting, "departing"}, {Contact::kClosed, "closed"},
      {Contact::kLocked, "locked"},       {Contact::kCompressed, "compressed"},
      {Contact::kParted, "parted"}};
  return names;
}

std::string contact_name(Contact contact) {
  for (const auto& [value, name] : contact_names())
    if (value == contact) return quoted(name);
  return {};
}

Contact contact_of(const StateTable& table, const std::string& word) {
  for (const auto& [value, name] : contact_names())
    if (name == word) return value;
  table.fail("contacts", fmt::format("there is no contact called {}", quoted(word)));
}

const std::vector<std::pair<Joint, std::string>>& joint_names() {
  static const std::vector<std::pair<Joint, std::string>> names = {
      {Joint::kForward, "forward"}, {Joint::kBackward, "backward"}, {Joint::kHeld, "held"}};
  return names;
}

std::string joint_name(Joint joint) {
  for (const auto& [value, name] : joint_names())
    if (value == joint) return name;
  return {};
}

Joint joint_of(const StateTable& table, const std::string& word) {
  for (const auto& [value, name] : joint_names())
    if (name == word) return value;
  table.fail("joint", fmt::format("there is no joint called {}", quoted(word)));
}

}  // namespace

void write_motion(StateLines& lines, const std::string& header, const MotionState<double>& motion) {
  lines.table(header);
  lines.count("period", motion.instant.period);
  lines.number("local", motion.instant.local);
  lines.numbers("q", motion.q);
  lines.numbers("qdot", motion.qdot);
  lines.text("contacts", listed(motion.contacts, contact_name));
  lines.text("multiplicities",
             listed(motion.multiplicities, [](int count) { return std::to_string(count); }));
  lines.number("unsummed", motion.unsummed);
  // Of a hub with friction.
  if (motion.joint != Joint::kFree) lines.word("joint", joint_name(motion.joint));
}

Instant<double> read_instant(const StateTable& table, const System& system) {
  const Instant<double> instant{table.count("period"), table.size("local")};
  if (instant.period > kMostCountedPeriods || (!system.forcing() && instant.period != 0))
    table.fail("period", "the scene has no such forcing period");
  if (system.forcing() && instant.local > system.period())
    table.fail("local", "it must not exceed the scene's forcing period");
  return instant;
}

MotionState<double> read_motion(const Node& node, const std::string& path, const System& system) {
  std::vector<std::string> keys = {"period",   "local",          "q",       "qdot",
                                   "contacts", "multiplicities", "unsummed"};
  const bool has_joint = system.rotation() && system.rotation()->friction;
  if (has_joint) keys.emplace_back("joint");
  const StateTable table(node, path, keys);
  const auto modes = static_cast<std::size_t>(system.modes());
  MotionState<double> motion;
  motion.instant = read_instant(table, system);
  const std::vector<double> q = table.numbers("q", modes), qdot = table.numbers("qdot", modes);
  motion.q = Eigen::Map<const Vector>(q.data(), system.modes());
  motion.qdot = Eigen::Map<const Vector>(qdot.data(), system.modes());
  for (const std::string& word : table.words("contacts", system.stops.size()))
    motion.contacts.push_back(contact_of(table, word));
  for (const long long count : table.counts("multiplicities", system.stops.size())) {
    if (count > kLargestMultiplicity)
      table.fail("multiplicities", fmt::format("they are 0 to {}", kLargestMultiplicity));
    motion.multiplicities.push_back(static_cast<int>(count));
  }
  motion.unsummed = table.number("unsummed");
  if (has_joint) motion.joint = joint_of(table, table.word("joint"));
  return motion;
}

}  // namespace graze
