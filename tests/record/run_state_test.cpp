// The state of a run as a file: every digit comes back, and nothing is taken for a state that is
// none.
#include "graze/record/file/detail/run_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "graze/base/errors.hpp"
#include "support/systems.hpp"

namespace graze {
namespace {

const std::string kSha(64, 'a');

System two_stops() {
  System system = support::forced_oscillator(1.0, 0.05, 0.5, 0.8, 1.6, 1.0);
  system.stops.push_back(system.stops.front());
  return system;
}

// Numbers on which a careless text loses digits.
CutRun cut_run() {
  using Limits = std::numeric_limits<double>;
  CutRun cut{"0.1.0", kSha, "interrupted", 0.1 + 0.2, 1.0 / 3.0, {}};
  RunState& state = cut.state;
  state.motion.instant = {9'007'199'254'740'991LL, 1e-300};
  state.motion.q = Vector::Constant(1, Limits::denorm_min());
  state.motion.qdot = Vector::Constant(1, -Limits::max());
  state.motion.contacts = {Contact::kClosed, Contact::kDeparting};
  state.motion.multiplicities = {0, 3};
  state.motion.unsummed = 1.0 / 9.0;
  state.started = true;
  state.streaks = {{12, 2.2250738585072011e-308}, {0, -0.0}};
  state.tail = ChatterTail{{0, 1}, {3, 0.7}};
  state.totals = {9'000'000'000LL, 2, 3, 4, 1e22, 1e-7, 123456789.123456789, -4.3368e-19, 2e-19};
  state.keeps_balance = true;
  state.balance.start = 5e-324;
  state.balance.work = {1.0 / 7.0, -2.0, 3e-17, 4.0 / 9.0};
  state.balance.impacts = -1.0 / 3.0;
  state.samples = 77;
  state.closure_speed = 1e-6 / 3.0;
  return cut;
}

CutRun parsed(const std::string& text) {
  return parse_run_state(text, "run/state.toml", two_stops(), kSha);
}

// The message about `text` with `old` replaced by `by`.
std::string complaint(const std::string& old, const std::string& by) {
  std::string text = write_run_state(cut_run());
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  text.replace(at, old.size(), by);
  try {
    parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted " << by;
  return "";
}

TEST(RunStateFile, BringsBackEveryDigit) {
  const CutRun cut = cut_run(), read = parsed(write_run_state(cut));
  EXPECT_EQ(read.version, cut.version);
  EXPECT_EQ(read.outcome, cut.outcome);
  EXPECT_EQ(read.time, cut.time);
  EXPECT_EQ(read.sample_rate, cut.sample_rate);
  const RunState &a = cut.state, &b = read.state;
  EXPECT_EQ(b.motion.instant.period, a.motion.instant.period);
  EXPECT_EQ(b.motion.instant.local, a.motion.instant.local);
  EXPECT_EQ(b.motion.q[0], a.motion.q[0]);
  EXPECT_EQ(b.motion.qdot[0], a.motion.qdot[0]);
  EXPECT_EQ(b.motion.contacts, a.motion.contacts);
  EXPECT_EQ(b.motion.multiplicities, a.motion.multiplicities);
  EXPECT_EQ(b.motion.unsummed, a.motion.unsummed);
  EXPECT_EQ(b.started, a.started);
  ASSERT_EQ(b.streaks.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(b.streaks[i].impacts, a.streaks[i].impacts);
    EXPECT_EQ(b.streaks[i].speed, a.streaks[i].speed);
  }
  EXPECT_TRUE(std::signbit(b.streaks[1].speed));
  ASSERT_TRUE(b.tail);
  EXPECT_EQ(b.tail->stops, (std::vector<int>{0, 1}));
  EXPECT_EQ(b.tail->over.period, 3);
  EXPECT_EQ(b.tail->over.local, 0.7);
  EXPECT_EQ(b.samples, 77);
  EXPECT_EQ(b.closure_speed, a.closure_speed);
}

TEST(RunStateFile, BringsBackTotalsAndTheEnergyBalance) {
  const RunState a = cut_run().state, b = parsed(write_run_state(cut_run())).state;
  EXPECT_EQ(b.totals.impacts, a.totals.impacts);
  EXPECT_EQ(b.totals.chatters, 2);
  EXPECT_EQ(b.totals.clamped_restitutions, 3);
  EXPECT_EQ(b.totals.undecided_touches, 4);
  EXPECT_EQ(b.totals.stuck_time, a.totals.stuck_time);
  EXPECT_EQ(b.totals.energy_added, a.totals.energy_added);
  EXPECT_EQ(b.totals.energy_lost, a.totals.energy_lost);
  EXPECT_EQ(b.totals.smallest_gap, a.totals.smallest_gap);
  EXPECT_TRUE(b.keeps_balance);
  EXPECT_EQ(b.balance.start, a.balance.start);
  EXPECT_EQ(b.balance.work.forcing, a.balance.work.forcing);
  EXPECT_EQ(b.balance.work.load, a.balance.work.load);
  EXPECT_EQ(b.balance.work.constraint, a.balance.work.constraint);
  EXPECT_EQ(b.balance.work.dissipation, a.balance.work.dissipation);
  EXPECT_EQ(b.balance.impacts, a.balance.impacts);
}

TEST(RunStateFile, LeavesOutWhatIsNotThere) {
  CutRun cut = cut_run();
  cut.sample_rate.reset();
  cut.state.tail.reset();
  cut.state.keeps_balance = false;
  cut.state.totals.smallest_gap.reset();
  const std::string text = write_run_state(cut);
  for (const char* word : {"sample", "[chatter]", "[energy]", "smallest_gap"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
  const CutRun read = parsed(text);
  EXPECT_FALSE(read.sample_rate);
  EXPECT_FALSE(read.state.tail);
  EXPECT_FALSE(read.state.keeps_balance);
  EXPECT_FALSE(read.state.totals.smallest_gap);
}

// "run/state.toml:LINE:1: " of the line that begins with `start`.
std::string at(const std::string& start) {
  const std::string text = write_run_state(cut_run());
  const std::size_t found = text.find("\n" + start);
  EXPECT_NE(found, std::string::npos) << start;
  const auto line = 2 + std::count(text.begin(), text.begin() + static_cast<long>(found), '\n');
  return "run/state.toml:" + std::to_string(line) + ":1: ";
}

TEST(RunStateFile, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint("graze_state = 2", "title = \"a scene\""),
            "run/state.toml:1:1: graze_state: the key is missing, this is not the state of a run");
  EXPECT_EQ(complaint("graze_state = 2", "graze_state = 1"),
            at("graze_state") +
                "graze_state: the integer 1 is the format of another version, this one reads 2");
  const std::string other = complaint("aaaa\"", "aaab\"");
  EXPECT_EQ(other.find(at("scene_sha256") + "scene_sha256: run/state.toml is the state of another"),
            0U);
  EXPECT_EQ(complaint("\"interrupted\"", "\"refused\""),
            at("outcome") +
                "outcome: the run ended on a stop on which it cannot be followed, it "
                "cannot go on");
  EXPECT_EQ(complaint("\nq = [5e-324]", "\nq = [1.0, 2.0]"),
            at("q = ") + "motion.q: the list has 2 entries, those of this scene have 1");
  EXPECT_EQ(
      complaint("[5e-324]", "[nan]"),
      at("q = ") + "motion.q: the number nan is not allowed, it must be a finite real number");
  EXPECT_EQ(complaint("\"departing\"", "\"gone\""),
            at("contacts") + "motion.contacts: there is no contact called \"gone\"");
  EXPECT_EQ(complaint("started = true", "began = true"),
            at("started") + "began: there is no such key in this file");
  EXPECT_EQ(complaint("started = true\n", ""),
            "run/state.toml:1:1: started: the key is missing, the file is not whole");
  EXPECT_EQ(complaint("stops = [1, 2]", "stops = [1, 3]"),
            at("stops = ") + "chatter.stops: the scene has no such stop");
}

TEST(RunStateFile, RefusesNumbersThatNoRunLeavesBehind) {
  for (const auto& [old, by] : std::vector<std::pair<std::string, std::string>>{
           {"period = 9007199254740991", "period = 9007199254740993"},
           {"period = 3", "period = -1"},
           {"local = 0.7", "local = 1000.0"},
           {"local = 0.7", "local = -1e-3"},
           {"sample_rate = 0.3", "sample_rate = -0.3"},
           {"samples = 77", "samples = 77.0"},
           {"impacts = 9000000000", "impacts = -1"},
           {"multiplicities = [0, 3]", "multiplicities = [0, 5]"},
           {"started = true", "started = 1"},
           {"[streaks]", "[[streaks]]"},
           {"stuck_time = 1e+22", "stuck_time = inf"}})
    EXPECT_NE(complaint(old, by), "");
}

TEST(RunStateFile, IsBoundToItsScene) {
  EXPECT_THROW(
      parse_run_state(write_run_state(cut_run()), "state", two_stops(), std::string(64, 'b')),
      InputError);
  EXPECT_THROW(parse_run_state("", "state", two_stops(), kSha), InputError);
  EXPECT_THROW(parse_run_state("= no toml", "state", two_stops(), kSha), InputError);
  EXPECT_THROW(read_run_state("no/such/file", two_stops(), kSha), FileError);
}

}  // namespace
}  // namespace graze
