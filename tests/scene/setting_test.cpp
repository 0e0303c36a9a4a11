// --set NAME=VALUE.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "graze/scene/reader.hpp"

namespace graze {
namespace {

const std::string kScene =
    "title = \"t\"\n"
    "[modal]\nfrequencies = [1.0, 6.3]\nparticipation = [1.0, 0.5]\n"
    "[forcing]\namplitude = 1.0\nfrequency = 2.8\n"
    "[[stop]]\nshape = [1.0, 1.0]\ngap = 0.0\nrestitution = 0.8\n";

const std::string kSecondStop = "[[stop]]\nshape = [1.0, -1.0]\ngap = 2.0\nrestitution = 0.5\n";

Scene with(const std::vector<std::string>& settings) { return parse_scene(kScene, "s", settings); }

std::string setting_error(const std::string& setting, const std::string& text = kScene) {
  try {
    parse_scene(text, "s", {setting});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Setting, ReplacesAValue) {
  EXPECT_EQ(with({"forcing.frequency=3.5"}).forcing->frequency, 3.5);
  EXPECT_EQ(with({"forcing.frequency = 4"}).forcing->frequency, 4.0);
  EXPECT_EQ(with({"title=\"a b\""}).title, "a b");
}

TEST(Setting, LaterSettingsWin) { EXPECT_EQ(with({"stop.gap=1", "stop.gap=2"}).stops[0].gap, 2.0); }

TEST(Setting, AddsKeysAndTables) {
  EXPECT_EQ(with({"forcing.phase=0.5"}).forcing->phase, 0.5);
  EXPECT_EQ(with({"solver.tolerance=1e-8"}).solver.tolerance, 1e-8);
  EXPECT_EQ(with({"modal.inertia=[1, 0]", "gravity.acceleration=9.81"}).gravity->acceleration,
            9.81);
  const Scene scene = with({"damping.rayleigh.mass=0.1", "damping.rayleigh.stiffness=1e-3"});
  EXPECT_EQ(std::get<RayleighDamping>(*scene.damping).mass, 0.1);
  EXPECT_EQ(std::get<RayleighDamping>(*scene.damping).stiffness, 1e-3);
}

TEST(Setting, ReplacesWholeTablesAndLists) {
  EXPECT_EQ(with({"forcing={amplitude=3, frequency=4}"}).forcing->amplitude, 3.0);
  EXPECT_EQ(with({"stop=[]"}).stops.size(), 0u);
  EXPECT_EQ(with({"stop.shape=[2, 3]"}).stops[0].shape, (std::vector<double>{2, 3}));
}

TEST(Setting, NamesStopsByNumber) {
  EXPECT_EQ(with({"stop.1.gap=0.25"}).stops[0].gap, 0.25);
  const Scene scene = parse_scene(kScene + kSecondStop, "s",
                                  {"stop.2.gap=0.25", "stop.2.side=below", "stop.2.shape.1=3"});
  EXPECT_EQ(scene.stops[0].gap, 0.0);
  EXPECT_EQ(scene.stops[1].gap, 0.25);
  EXPECT_EQ(scene.stops[1].side, Side::kBelow);
  EXPECT_EQ(scene.stops[1].shape, (std::vector<double>{3, -1}));
  EXPECT_EQ(setting_error("stop.2.gap=nan", kScene + kSecondStop),
            "--set stop.2.gap=nan: stop.2.gap: nan is not allowed, it must be a finite "
            "number");
  EXPECT_EQ(setting_error("stop.3.gap=0.25"),
            "--set stop.3.gap=0.25: stop.3.gap: there is no entry 3 in stop, the number must "
            "be from 1 to 2");
  EXPECT_EQ(setting_error("stop.0.gap=1"),
            "--set stop.0.gap=1: stop.0.gap: there is no entry 0 in stop, the number must be "
            "from 1 to 2");
  EXPECT_EQ(setting_error("stop.2.gap=1", "[modal]\nfrequencies = [1.0]\n"),
            "--set stop.2.gap=1: stop.2.gap: there is no entry 2 in stop, the number must be "
            "1");
}

TEST(Setting, MakesTheNextStop) {
  const Scene scene =
      with({"stop.2.shape=[2, 3]", "stop.2.gap=0.5", "stop.2.restitution=[0.9, 0.1]",
            "stop.3={shape=[1, 0], gap=1, restitution=0}"});
  ASSERT_EQ(scene.stops.size(), 3u);
  EXPECT_EQ(scene.stops[0].gap, 0.0);
  EXPECT_EQ(scene.stops[1].gap, 0.5);
  EXPECT_EQ(scene.stops[1].restitution, (std::vector<double>{0.9, 0.1}));
  EXPECT_EQ(scene.stops[2].gap, 1.0);
  EXPECT_EQ(setting_error("stop.2.gap=0.5"),
            "--set stop.2.gap=0.5: stop.2.shape: the key is missing, it must be a list of "
            "numbers, the mode shapes at the stop");
}

TEST(Setting, MakesTheFirstStop) {
  const std::string none = "[modal]\nfrequencies = [1.0]\n";
  for (const std::string stop : {"stop.", "stop.1."}) {
    const Scene scene =
        parse_scene(none, "s", {stop + "shape=[1]", stop + "gap=0.5", stop + "restitution=0.7"});
    ASSERT_EQ(scene.stops.size(), 1u);
    EXPECT_EQ(scene.stops[0].gap, 0.5);
  }
  EXPECT_EQ(setting_error("stop.gap=0.5", none),
            "--set stop.gap=0.5: stop.shape: the key is missing, it must be a list of numbers, "
            "the mode shapes at the stop");
}

TEST(Setting, NamesEntriesOfLists) {
  EXPECT_EQ(with({"modal.frequencies.2=7"}).modal()->frequencies, (std::vector<double>{1, 7}));
  EXPECT_EQ(with({"stop.shape.1=3"}).stops[0].shape, (std::vector<double>{3, 1}));
  EXPECT_EQ(with({"stop.1.shape.2=3"}).stops[0].shape, (std::vector<double>{1, 3}));
  EXPECT_EQ(with({"stop.restitution=[0.9, 0.2]", "stop.restitution.2=0.1"}).stops[0].restitution,
            (std::vector<double>{0.9, 0.1}));
  EXPECT_EQ(setting_error("stop.restitution.2=0.1"),
            "--set stop.restitution.2=0.1: stop.restitution.2: stop.restitution is the number "
            "0.8, it must be a table or a list to hold 2");
  EXPECT_EQ(setting_error("modal.frequencies.3=7"),
            "--set modal.frequencies.3=7: modal.frequencies.3: there is no entry 3 in "
            "modal.frequencies, the number must be from 1 to 2");
  EXPECT_EQ(setting_error("modal.frequencies.x=7"),
            "--set modal.frequencies.x=7: modal.frequencies.x: there is no entry x in "
            "modal.frequencies, the number must be from 1 to 2");
}

TEST(Setting, TakesABareWordForAString) {
  EXPECT_EQ(with({"stop.side=below"}).stops[0].side, Side::kBelow);
  EXPECT_EQ(with({"stop.side = below "}).stops[0].side, Side::kBelow);
  EXPECT_EQ(with({"stop.side='below'"}).stops[0].side, Side::kBelow);
  EXPECT_EQ(setting_error("stop.side=left"),
            "--set stop.side=left: stop.side: the string \"left\" is not allowed, it must be "
            "\"above\" or \"below\"");
}

TEST(Setting, ErrorsOfValuesStandInTheSetting) {
  EXPECT_EQ(setting_error("stop.restitution=1.5"),
            "--set stop.restitution=1.5: stop.restitution: 1.5 is not allowed, it must be a "
            "number from 0 to 1");
  EXPECT_EQ(setting_error("forcing.frequency= nan"),
            "--set forcing.frequency= nan: forcing.frequency: nan is not allowed, it must be "
            "a finite number greater than 0");
  EXPECT_EQ(setting_error("modal.frequencies=[1, -2]"),
            "--set modal.frequencies=[1, -2]: modal.frequencies.2: -2 is not allowed, it must "
            "be a finite number of at least 0");
  EXPECT_EQ(setting_error("stop.gapp=1"),
            "--set stop.gapp=1: stop.gapp: there is no such key, did you mean stop.gap?");
  EXPECT_EQ(setting_error("frequency=3"),
            "--set frequency=3: frequency: there is no such key, did you mean "
            "forcing.frequency?");
  EXPECT_EQ(setting_error("gravity.acceleration=9.81"),
            "s:2:1: modal.inertia: the key is missing, [gravity] needs a list of numbers, one per "
            "mode");
}

TEST(Setting, MalformedOnesSayWhatIsAllowed) {
  const std::string form = "the setting is malformed, it must read NAME=VALUE like stop.gap=1e-3";
  EXPECT_EQ(setting_error("stop.gap"), "--set stop.gap: set: " + form);
  EXPECT_EQ(setting_error(""), "--set : set: " + form);
  EXPECT_EQ(setting_error("=3"), "--set =3: set: " + form);
  EXPECT_EQ(setting_error("stop..gap=3"), "--set stop..gap=3: set: " + form);
  EXPECT_EQ(setting_error("stop gap=3"), "--set stop gap=3: set: " + form);
  EXPECT_EQ(setting_error("stop.gap="),
            "--set stop.gap=: stop.gap: the value is missing, the setting must read "
            "NAME=VALUE");
  EXPECT_EQ(setting_error("a.b.c.d.e.f=1"),
            "--set a.b.c.d.e.f=1: a.b.c.d.e.f: there is no such key, at most five names can be "
            "joined by dots");
  EXPECT_EQ(setting_error("title.x=1"),
            "--set title.x=1: title.x: title is the string \"t\", it must be a table or a list "
            "to hold x");
  for (const std::string value : {"1e", "1..2", "[1", "\"x", "two words", "1\ny=2", "-x", "1x", "{",
                                  "1, 2", "\x01", "\xff"}) {
    const std::string message = setting_error("stop.gap=" + value);
    EXPECT_NE(
        message.find(
            ": stop.gap: the value is not TOML, it must be a number without a unit, a list in "
            "[ ], a string in quotes or one bare word"),
        std::string::npos)
        << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(Setting, SaysHowOneOfSeveralTablesIsSet) {
  for (const std::string name : {"stop", "probe"}) {
    const std::string setting = name + "={gap=1}";
    EXPECT_EQ(setting_error(setting),
              "--set " + setting + ": " + name +
                  ": a table is not allowed, it must be a list of tables like [{..}]; --set " +
                  name + ".1.NAME=VALUE sets one key of the first " + name);
  }
}

// What a list or a table in a setting holds stands nowhere in a file either.
TEST(Setting, TellsNoPlaceWithinItself) {
  EXPECT_EQ(setting_error("stop.shape=[1, true]").substr(0, 35),
            "--set stop.shape=[1, true]: stop.sh");
  EXPECT_EQ(setting_error("forcing={amplitude=1mm, frequency=2}").substr(0, 47),
            "--set forcing={amplitude=1mm, frequency=2}: for");
}

// A value goes nowhere but to its key.
TEST(Setting, CannotSmuggleInAnotherKey) {
  EXPECT_NE(setting_error("stop.gap=1\n[solver]\ntolerance=0.5").find("not TOML"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
