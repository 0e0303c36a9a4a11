#include "graze/record/file/detail/run_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "graze/record/file/detail/files.hpp"
#include "graze/record/file/detail/motion_table.hpp"
#include "graze/record/file/detail/state_lines.hpp"
#include "graze/record/file/detail/state_table.hpp"
#include "graze/scene/detail/document.hpp"
#include "graze/scene/detail/text_check.hpp"

namespace graze {
namespace {

// What the numbers of the file mean; another meaning is another format.
constexpr long long kStateFormat = 2;

void write_totals(StateLines& lines, const RunTotals& totals) {
  lines.table("[totals]");
  lines.count("impacts", totals.impacts);
  lines.count("chatters", totals.chatters);
  lines.count("clamped_restitutions", totals.clamped_restitutions);
  lines.count("undecided_touches", totals.undecided_touches);
  lines.number("stuck_time", totals.stuck_time);
  lines.number("energy_added", totals.energy_added);
  lines.number("energy_lost", totals.energy_lost);
  if (totals.smallest_gap) lines.number("smallest_gap", *totals.smallest_gap);
  lines.number("penetration", totals.penetration);
}

void write_balance(StateLines& lines, const EnergyBalance& balance) {
  lines.table("[energy]");
  lines.number("start", balance.start);
  lines.number("forcing", balance.work.forcing);
  lines.number("load", balance.work.load);
  lines.number("constraint", balance.work.constraint);
  lines.number("impacts", balance.impacts);
  lines.number("dissipation", balance.work.dissipation);
  lines.number("contact", balance.work.contact);
  lines.number("contact_lost", balance.work.contact_lost);
}

std::vector<RunState::Streak> read_streaks(const Node& node, const System& system) {
  const StateTable table(node, "streaks", {"impacts", "speeds"});
  const std::vector<long long> impacts = table.counts("impacts", system.stops.size());
  const std::vector<double> speeds = table.numbers("speeds", system.stops.size());
  std::vector<RunState::Streak> streaks;
  for (std::size_t i = 0; i < system.stops.size(); ++i) streaks.push_back({impacts[i], speeds[i]});
  return streaks;
}

constexpr std::array<std::pair<const char*, double SpringContact::*>, 6> kContactKeys{{
    {"since", &SpringContact::since},
    {"speeds", &SpringContact::speed},
    {"peak_forces", &SpringContact::peak_force},
    {"lost", &SpringContact::lost},
    {"held", &SpringContact::held},
    {"changes_before", &SpringContact::change_before},
}};

// Where there was none there is nothing to remember.
void write_contacts(StateLines& lines, const SpringContacts& list) {
  if (std::all_of(list.begin(), list.end(), [](const SpringContact& contact) {
        return std::all_of(kContactKeys.begin(), kContactKeys.end(),
                           [&contact](const auto& key) { return contact.*key.second == 0.0; });
      }))
    return;
  lines.table("[contacts]");
  const auto write = [&](const char* key, double SpringContact::*value) {
    lines.text(key, listed(list, [value](const SpringContact& contact) {
                 return real_text(contact.*value);
               }));
  };
  for (const auto& [key, value] : kContactKeys) write(key, value);
}

SpringContacts read_contacts(const Node& node, const System& system) {
  const StateTable table(node, "contacts",
                         {"since", "speeds", "peak_forces", "lost", "held", "changes_before"});
  SpringContacts list(system.stops.size());
  const auto read = [&](const char* key, double SpringContact::*value) {
    const std::vector<double> numbers = table.numbers(key, list.size());
    for (std::size_t i = 0; i < list.size(); ++i) list[i].*value = numbers[i];
  };
  for (const auto& [key, value] : kContactKeys) read(key, value);
  return list;
}

ChatterTail read_tail(const Node& node, const System& system) {
  const StateTable table(node, "chatter", {"stops", "period", "local"});
  std::vector<int> stops;
  for (const long long stop : table.counts("stops")) {
    if (stop < 1 || stop > static_cast<long long>(system.stops.size()))
      table.fail("stops", "the scene has no such stop");
    stops.push_back(static_cast<int>(stop) - 1);
  }
  return {stops, read_instant(table, system)};
}

RunTotals read_totals(const Node& node) {
  const StateTable table(
      node, "totals",
      {"impacts", "chatters", "clamped_restitutions", "undecided_touches", "stuck_time",
       "energy_added", "energy_lost", "smallest_gap", "penetration"});
  RunTotals totals;
  totals.impacts = table.count("impacts");
  totals.chatters = table.count("chatters");
  totals.clamped_restitutions = table.count("clamped_restitutions");
  totals.undecided_touches = table.count("undecided_touches");
  totals.stuck_time = table.size("stuck_time");
  totals.energy_added = table.size("energy_added");
  totals.energy_lost = table.size("energy_lost");
  if (table.find("smallest_gap")) totals.smallest_gap = table.number("smallest_gap");
  totals.penetration = table.size("penetration");
  return totals;
}

EnergyBalance read_balance(const Node& node) {
  const StateTable table(node, "energy",
                         {"start", "forcing", "load", "constraint", "impacts", "dissipation",
                          "contact", "contact_lost"});
  EnergyBalance balance;
  balance.start = table.size("start");
  balance.work = {table.number("forcing"), table.number("load"), table.number("constraint"),
                  table.number("dissipation")};
  if (table.find("contact")) balance.work.contact = table.number("contact");
  if (table.find("contact_lost")) balance.work.contact_lost = table.number("contact_lost");
  balance.impacts = table.number("impacts");
  return balance;
}

// Before any other key is looked at: is this such a file, does it fit, can the run go on?
void check_origin(const Node& root, const std::string& name, const std::string& scene_sha256) {
  const auto* members = root.as<NodeTable>();
  const Node* format = members ? find_member(*members, "graze_state") : nullptr;
  if (!format)
    throw InputError(root.place.location(), "graze_state",
                     "the key is missing, this is not the state of a run");
  const auto* number = format->as<std::int64_t>();
  if (!number || *number != kStateFormat)
    throw InputError(format->place.location(), "graze_state",
                     fmt::format("{} is the format of another version, this one reads {}",
                                 node_description(*format), kStateFormat));
  const auto place_of = [&](const char* key) {
    const Node* node = find_member(*members, key);
    return (node ? *node : root).place.location();
  };
  const auto word_at = [&](const char* key) {
    const Node* node = find_member(*members, key);
    const auto* word = node ? node->as<std::string>() : nullptr;
    return word ? *word : std::string();
  };
  if (word_at("scene_sha256") != scene_sha256)
    throw InputError(
        place_of("scene_sha256"), "scene_sha256",
        fmt::format("{} is the state of another scene; go on with the scene that was simulated, "
                    "with the same --set (it is scene.toml in the folder of --out)",
                    name));
  const std::string outcome = word_at("outcome");
  if (outcome == "not_finite" || outcome == "refused")
    throw InputError(place_of("outcome"), "outcome",
                     outcome == "refused"
                         ? "the run ended on a stop on which it cannot be followed, it cannot go on"
                         : "the motion left the range of double precision, it cannot go on");
}

}  // namespace

std::string write_run_state(const CutRun& cut) {
  const RunState& state = cut.state;
  StateLines lines("The state of a run: graze simulate SCENE --resume FILE goes on from it.");
  lines.count("graze_state", kStateFormat);
  lines.text("version", quoted(cut.version));
  lines.text("scene_sha256", quoted(cut.scene_sha256));
  lines.text("outcome", quoted(cut.outcome));
  lines.number("time", cut.time);
  if (cut.sample_rate) {
    lines.number("sample_rate", *cut.sample_rate);
    lines.count("samples", state.samples);
  }
  lines.number("closure_speed", state.closure_speed);
  lines.text("started", state.started ? "true" : "false");
  write_motion(lines, "[motion]", state.motion);
  lines.table("[streaks]");
  lines.text("impacts", listed(state.streaks, [](const RunState::Streak& streak) {
               return std::to_string(streak.impacts);
             }));
  lines.text("speeds", listed(state.streaks, [](const RunState::Streak& streak) {
               return real_text(streak.speed);
             }));
  write_contacts(lines, state.contacts);
  if (state.tail) {
    lines.table("[chatter]");
    lines.text("stops",
               listed(state.tail->stops, [](int stop) { return std::to_string(stop + 1); }));
    lines.count("period", state.tail->over.period);
    lines.number("local", state.tail->over.local);
  }
  write_totals(lines, state.totals);
  if (state.keeps_balance) write_balance(lines, state.balance);
  return lines.take();
}

CutRun parse_run_state(const std::string& text, const std::string& name, const System& system,
                       const std::string& scene_sha256) {
  const Node root = read_document(text, name);
  check_origin(root, name, scene_sha256);
  const StateTable table(
      root, "",
      {"graze_state", "version", "scene_sha256", "outcome", "time", "sample_rate", "samples",
       "closure_speed", "started", "motion", "streaks", "contacts", "chatter", "totals", "energy"});
  CutRun cut;
  cut.version = table.word("version");
  cut.scene_sha256 = scene_sha256;
  cut.outcome = table.word("outcome");
  cut.time = table.size("time");
  RunState& state = cut.state;
  if (table.find("sample_rate")) {
    cut.sample_rate = table.size("sample_rate");
    if (*cut.sample_rate == 0.0) table.fail("sample_rate", "it must be above 0");
    state.samples = table.count("samples");
  }
  state.closure_speed = table.size("closure_speed");
  state.started = table.flag("started");
  state.motion = read_motion(table.at("motion"), "motion", system);
  state.streaks = read_streaks(table.at("streaks"), system);
  state.contacts.resize(system.stops.size());
  if (const Node* contacts = table.find("contacts"))
    state.contacts = read_contacts(*contacts, system);
  if (const Node* tail = table.find("chatter")) state.tail = read_tail(*tail, system);
  state.totals = read_totals(table.at("totals"));
  if (const Node* entries = table.find("energy")) {
    state.keeps_balance = true;
    state.balance = read_balance(*entries);
  }
  return cut;
}

CutRun read_run_state(const std::filesystem::path& file, const System& system,
                      const std::string& scene_sha256) {
  return parse_run_state(read_file(file, kLargestText), file.string(), system, scene_sha256);
}

}  // namespace graze
