// Special points with their orbits as a file: every digit comes back, and nothing is taken for a
// special point that is none.
#include "graze/record/file/detail/special_file.hpp"

#include <gtest/gtest.h>

#include "graze/base/errors.hpp"
#include "graze/record/file/run_info.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

constexpr const char* kSpecialScene = R"([modal]
frequencies = [1.0, 2.5]
participation = [1.0, 0.3]

[forcing]
kind = "modal"
amplitude = 1.0
frequency = 0.7

[[stop]]
shape = [1.0, 0.2]
gap = 0.1
restitution = 0.8

[[stop]]
shape = [1.0, -0.2]
gap = 0.2
restitution = 0.0
side = "below"
)";

Scene two_modes() { return parse_scene(kSpecialScene, "two_modes.toml"); }

State state(double a) { return {Vector{{a, 1.0 / 3.0}}, Vector{{-a / 7.0, 5e-324}}}; }

SpecialPoints points() {
  SpecialPoints special{"0.1.0", sha256(write_scene(two_modes())), {"forcing.frequency"}, {}};
  SpecialOrbit doubling;
  doubling.id = "PD1";
  doubling.label = "PD";
  doubling.kind = SpecialKind::kPeriodDoubling;
  doubling.values = {0.1 + 0.2};
  doubling.pattern = {2, {0, 1}};
  doubling.impacts = {{0.1, state(1e-300)}, {6.4, state(0.7)}};
  doubling.along = {{{0.2, state(0.3)}, {0.4, state(-1.0)}}, -1.0 / 9.0};
  doubling.multiplier = Complex(-1.0, 1e-17);
  special.points.push_back(doubling);
  SpecialOrbit completes;
  completes.id = "CH1";
  completes.label = "CH";
  completes.kind = SpecialKind::kChatterCompletes;
  completes.values = {0.7};
  completes.followed = SpecialOrbit::Followed{3,
                                              0.71,
                                              {{{1, 0.2},
                                                Vector{{0.1, 0.3}},
                                                Vector::Zero(2),
                                                {Contact::kClosed, Contact::kClear},
                                                {0, 0},
                                                0.0}},
                                              1e-7};
  special.points.push_back(completes);
  return special;
}

void expect_same(const std::vector<ImpactPoint>& a, const std::vector<ImpactPoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].theta, b[i].theta);
    EXPECT_EQ(a[i].before.q, b[i].before.q);
    EXPECT_EQ(a[i].before.qdot, b[i].before.qdot);
  }
}

TEST(SpecialFile, EveryDigitComesBack) {
  const SpecialPoints written = points();
  const SpecialPoints read =
      parse_special_points(write_special_points(written), "special.toml", two_modes());
  EXPECT_EQ(read.version, written.version);
  EXPECT_EQ(read.parameters, written.parameters);
  ASSERT_EQ(read.points.size(), 2u);
  const SpecialOrbit &a = written.points[0], &b = read.points[0];
  EXPECT_EQ(b.id, "PD1");
  EXPECT_EQ(b.kind, SpecialKind::kPeriodDoubling);
  EXPECT_EQ(b.values, a.values);
  EXPECT_EQ(b.multiplier, a.multiplier);
  EXPECT_EQ(b.pattern.period, 2);
  EXPECT_EQ(b.pattern.stops, a.pattern.stops);
  expect_same(a.impacts, b.impacts);
  expect_same(a.along->impacts, b.along->impacts);
  EXPECT_EQ(b.along->value, a.along->value);
  EXPECT_FALSE(b.followed);
  const SpecialOrbit::Followed &c = *written.points[1].followed, &d = *read.points[1].followed;
  EXPECT_TRUE(read.points[1].sticks());
  ASSERT_EQ(d.states.size(), 1u);
  const MotionState<double>&at_c = c.states[0], &at_d = d.states[0];
  EXPECT_EQ(d.period, 3);
  EXPECT_EQ(d.value, c.value);
  EXPECT_EQ(d.closure_speed, c.closure_speed);
  EXPECT_EQ(at_d.instant.period, 1);
  EXPECT_EQ(at_d.instant.local, 0.2);
  EXPECT_EQ(at_d.q, at_c.q);
  EXPECT_EQ(at_d.contacts, at_c.contacts);
}

TEST(SpecialFile, WritesALocusWithItsKindAndBothValues) {
  SpecialPoints special = points();
  special.parameters = {"forcing.frequency", "stop.gap"};
  special.points.pop_back();
  SpecialOrbit& meeting = special.points.front();
  meeting.id = "PDGR-1";
  meeting.label = "PDGR";
  meeting.kind.reset();
  meeting.locus = OrbitLocusKind::kGrazing;
  meeting.values = {0.7, 0.1};
  meeting.along.reset();
  const SpecialPoints read =
      parse_special_points(write_special_points(special), "special.toml", two_modes());
  EXPECT_EQ(read.points.front().locus, OrbitLocusKind::kGrazing);
  EXPECT_EQ(read.points.front().values, meeting.values);
  EXPECT_FALSE(read.points.front().along);
}

// An orbit on compliant stops is told by its states at a fixed phase; before 0.1.0 by another word.
TEST(SpecialFile, OrbitsOnCompliantStopsComeBackUnderTheOldWordToo) {
  SpecialPoints special = points();
  special.points.resize(1);
  SpecialOrbit& fold = special.points.front();
  fold = {};
  fold.id = "LP1";
  fold.label = "LP";
  fold.kind = SpecialKind::kFold;
  fold.values = {0.7};
  MotionState<double> at;
  at.q = state(0.4).q;
  at.qdot = state(0.4).qdot;
  fold.followed = SpecialOrbit::Followed{1, 0.72, {at}, 1e-7};
  std::string text = write_special_points(special);
  for (const std::string word : {"[special.compliant]", "[special.strobe]"}) {
    const std::size_t table = text.find("[special.compliant]");
    ASSERT_NE(table, std::string::npos);
    const std::size_t first = text.find("\n[[special]]");
    const std::string before = sha256(text.substr(first));
    text.replace(table, std::string("[special.compliant]").size(), word);
    text.replace(text.find(before), before.size(), sha256(text.substr(first)));
    const SpecialPoints read = parse_special_points(text, "special.toml", two_modes());
    ASSERT_EQ(read.points.size(), 1u);
    ASSERT_TRUE(read.points[0].followed) << word;
    EXPECT_FALSE(read.points[0].sticks());
    EXPECT_EQ(read.points[0].followed->value, 0.72);
    EXPECT_EQ(read.points[0].followed->states.at(0).q, at.q);
    EXPECT_EQ(read.points[0].followed->states.at(0).qdot, at.qdot);
  }
}

// What the reader says about a file in which `what` stands in place of the first `from`.
std::string refusal(const std::string& from, const std::string& what) {
  std::string text = write_special_points(points());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), what);
  try {
    parse_special_points(text, "run/special.toml", two_modes());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SpecialFile, RefusesWhatIsNone) {
  EXPECT_NE(refusal("graze_special = 1", "graze_special = 2").find("format of another version"),
            std::string::npos);
  EXPECT_NE(refusal("graze_special = 1", "").find("these are not the special points of a run"),
            std::string::npos);
  EXPECT_NE(refusal("stops = [1, 2]", "stops = [1, 3]").find("the scene has no such stop"),
            std::string::npos);
  EXPECT_NE(refusal("theta = [0.1, 6.4]", "theta = [0.1]").find("the list has 1 entries"),
            std::string::npos);
  EXPECT_NE(refusal("label = \"PD\"", "label = \"XX\"").find("no special point called \"XX\""),
            std::string::npos);
  EXPECT_NE(refusal("scene_sha256 = \"", "scene_sha256 = \"0").find("not the one of this run"),
            std::string::npos);
  EXPECT_NE(refusal("values = [", "values = [1.0, ").find("the list has 2 entries"),
            std::string::npos);
}

TEST(SpecialFile, NoticesAChange) {
  EXPECT_NE(refusal("theta = [0.1, 6.4]", "theta = [0.2, 6.4]").find("have been changed"),
            std::string::npos);
  // Cut off where a point ends, the rest reads well.
  std::string text = write_special_points(points());
  text.resize(text.rfind("\n[[special]]"));
  try {
    parse_special_points(text, "run/special.toml", two_modes());
    ADD_FAILURE() << "the second point is missing";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("have been changed"), std::string::npos);
  }
  EXPECT_NE(refusal("\"closed\"", "\"touching\"").find("no stop is closed in it"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
