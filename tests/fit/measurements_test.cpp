// Tables of measurements, good and bad. Every message says where, what is wrong and what is
// allowed.
#include "graze/fit/measurements.hpp"

#include <gtest/gtest.h>

#include "graze/scene/reader.hpp"

namespace graze {
namespace {

Scene two_stops() {
  return parse_scene(
      "[modal]\nfrequencies = [1.0, 3.0]\n[[stop]]\nshape = [1.0, 1.0]\ngap = 1.0\nrestitution = "
      "0.5\n[[stop]]\nshape = [1.0, -1.0]\ngap = 1.0\nrestitution = 0.5\n",
      "scene");
}
Scene one_stop() {
  return parse_scene(
      "[modal]\nfrequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = 1.0\nrestitution = 0.5\n",
      "scene");
}

Measurements read(const std::string& text, const Scene& scene = one_stop(),
                  const MeasurementOptions& options = {}) {
  return read_measurements(DataTable(text, "m.csv"), scene, options);
}

std::string error_of(const std::string& text, const Scene& scene = one_stop(),
                     const MeasurementOptions& options = {}) {
  try {
    read(text, scene, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Measurements, TellTheirKindByTheirColumns) {
  EXPECT_EQ(read("speed,restitution\n1,0.5\n").kind, MeasurementKind::kRestitution);
  EXPECT_EQ(read("time\n1\n2\n").kind, MeasurementKind::kImpactTimes);
  const Measurements data = read("time,gap1\n0,0.1\n0.5,0.2\n");
  EXPECT_EQ(data.kind, MeasurementKind::kResponse);
  EXPECT_EQ(data.series[0].quantity, Quantity::kGap);
  EXPECT_EQ(data.at, Eigen::Vector2d(0.0, 0.5));
  EXPECT_EQ(data.series[0].values, Eigen::Vector2d(0.1, 0.2));
  EXPECT_FALSE(data.knows_uncertainty());
}

TEST(Measurements, AreReadAsSpreadsheetsWriteThem) {
  const Measurements data = read(
      "\xEF\xBB\xBF# a comment\r\n\r\n\"time (s)\", \"force (N)\" ,note\r\n 0 ,+1.5e0,a\r\n"
      "\"1\",2,b\r\n");
  EXPECT_EQ(data.series[0].quantity, Quantity::kForce);
  EXPECT_EQ(data.series[0].values, Eigen::Vector2d(1.5, 2.0));
  EXPECT_EQ(data.unused, std::vector<std::string>{"note"});
  EXPECT_EQ(data.places[1].line, 5);
}

// Every decimal multiple is the number divided or multiplied by its power of ten, rounded once.
TEST(Measurements, AreReadInTheUnitsOfTheirColumns) {
  for (const char* text :
       {"t (ms);Force (kN)\n0;0,3\n0,7;1,1\n", "T [ms]\tforce1 [kN]\n0\t0.3\n0.7\t1.1\n",
        "time (us),force (kN)\n0,0.3\n700,1.1\n",
        "time (\xC2\xB5s),force (kN)\n0,0.3\n7e2,1.1\n"}) {
    const Measurements data = read(text);
    EXPECT_EQ(data.kind, MeasurementKind::kResponse) << text;
    EXPECT_EQ(data.at[0], 0.0) << text;
    EXPECT_DOUBLE_EQ(data.at[1], 7e-4) << text;
    EXPECT_EQ(data.series[0].quantity, Quantity::kForce) << text;
    EXPECT_EQ(data.series[0].values, Eigen::Vector2d(300.0, 1100.0)) << text;
    EXPECT_EQ(data.series[0].unit, "N") << text;
  }
  const Measurements data = read(
      "time,gap1 (mm),velocity1 (mm/s),sigma_gap1 (um),sigma_velocity1\n0,3,5,7,1\n1,4,6,8,1\n");
  EXPECT_EQ(data.series[0].values, Eigen::Vector2d(0.003, 0.004));
  EXPECT_EQ(data.series[0].uncertainty, Eigen::Vector2d(7e-6, 8e-6));
  EXPECT_EQ(data.series[1].values, Eigen::Vector2d(0.005, 0.006));
  EXPECT_EQ(read("speed (mm/s);restitution (1)\n300;0,5\n").at[0], 0.3);
  EXPECT_EQ(read("t (ms)\n10\n20\n").series[0].values, Eigen::Vector2d(0.01, 0.02));
}

TEST(Measurements, OfEventsAreTheImpactsAmongThem) {
  const Measurements data = read(
      "kind,time,stop,speed,force\nimpact,0.5,1,1,\nstick,0.6,1,,3\nimpact,0.9,2,1,\ncontact,1.1,1,"
      "1,\n",
      two_stops());
  EXPECT_EQ(data.kind, MeasurementKind::kImpactTimes);
  EXPECT_EQ(data.series[0].values, Eigen::Vector3d(0.5, 0.9, 1.1));
  EXPECT_EQ(data.stops, (std::vector<int>{0, 1, 0}));
  // Counted at each stop.
  EXPECT_EQ(data.at, Eigen::Vector3d(1.0, 1.0, 2.0));
}

TEST(Measurements, HaveUncertaintiesFromAColumnOrTheCommand) {
  EXPECT_EQ(read("time,gap1,sigma\n0,1,0.5\n1,2,0.25\n").series[0].uncertainty,
            Eigen::Vector2d(0.5, 0.25));
  EXPECT_EQ(read("time,gap1,sigma\n0,1,0.5\n1,2,0.25\n", one_stop(), {{}, {{"", 0.1}}})
                .series[0]
                .uncertainty,
            Eigen::Vector2d(0.1, 0.1));
  const Measurements both =
      read("time,gap1,q1,sigma_q1\n0,1,2,3\n1,2,3,4\n", one_stop(), {{}, {{"gap1", 0.1}}});
  EXPECT_EQ(both.series[0].uncertainty, Eigen::Vector2d(0.1, 0.1));
  EXPECT_EQ(both.series[1].uncertainty, Eigen::Vector2d(3.0, 4.0));
}

TEST(Measurements, OfAResponseAreChosenByColumn) {
  const Measurements data = read("time,gap1,q1\n0,1,2\n1,2,3\n", one_stop(), {{"q1"}, {}});
  ASSERT_EQ(data.series.size(), 1u);
  EXPECT_EQ(data.series[0].quantity, Quantity::kCoordinate);
  EXPECT_EQ(data.unused, std::vector<std::string>{"gap1"});
}

struct Bad {
  const char* text;
  const char* place;     // what the message begins with
  const char* sentence;  // and what stands in it
};

TEST(Measurements, ThatAreBadAreRefusedWithTheirPlace) {
  for (const Bad& bad : std::vector<Bad>{
           {"", "m.csv:1:1: data: ", "the file is empty"},
           {"\n# only a comment\n", "m.csv:1:1: data: ", "the file is empty"},
           {"time,gap1\n", "m.csv:1:1: data: ", "no row of numbers below the column names"},
           {"0,1\n1,2\n", "m.csv:1:1: data: ", "'0' is a number; the first row must name"},
           {"time gap1\n0 1\n",
            "m.csv:1:1: data: ", "columns must be separated by commas, semicolons or tabs"},
           {"time;gap1\n0;1.5\n1;1,5\n",
            "m.csv:3:3: data: ", "'1,5' has a comma where other numbers have a point"},
           {"time,,gap1\n0,1,2\n", "m.csv:1:6: data: ", "a column has no name"},
           {"time,gap1,time\n0,1,2\n", "m.csv:1:11: data: ", "column 'time' stands there twice"},
           {"time,gap1\n0,1\n1\n",
            "m.csv:3:1: data: ", "the row has 1 cell, line 1 names 2 columns"},
           {"time,gap1\n0,1\n1,2,3\n", "m.csv:3:5: data: ", "the row has 3 cells"},
           {"time,gap1\n0,1\n1,\n", "m.csv:3:3: data: ", "gap1: a number is missing"},
           {"time,gap1\n0,1\n1,two\n", "m.csv:3:3: data: ", "gap1: 'two' is not a number"},
           {"time,gap1\n0,1\n1,2.0.1\n", "m.csv:3:3: data: ", "'2.0.1' is not a number"},
           {"time,gap1\n0,1\n1,nan\n", "m.csv:3:3: data: ", "'nan' is not a finite number"},
           {"time,gap1\n0,-inf\n1,2\n", "m.csv:2:3: data: ", "'-inf' is not a finite number"},
           {"time,gap1\n0,1\n1,1e999\n", "m.csv:3:3: data: ", "'1e999' is not a finite number"},
           {"time,gap1\n0,1\n0,2\n", "m.csv:3:1: data: ", "times must increase"},
           {"time,gap1\n1,1\n0.5,2\n", "m.csv:3:1: data: ", "0.5 s is not after the 1 s before it"},
           {"time,gap1\n-1,1\n0.5,2\n", "m.csv:2:1: data: ", "it counts from 0 on"},
           {"time,gap1\n0,1\n1,1\n", "m.csv:2:3: data: ", "all 2 values are 1"},
           {"time,gap2\n0,1\n1,2\n", "m.csv:1:6: data: ", "gap2: the scene has 1 stop"},
           {"time,q2\n0,1\n1,2\n", "m.csv:1:6: data: ", "q2: the scene has 1 mode"},
           {"time (min),gap1\n0,1\n1,2\n",
            "m.csv:1:1: data: ", "it is in min, which is not converted; give it in s"},
           {"time,gap1 (in)\n0,1\n1,2\n", "m.csv:1:6: data: ", "it is in in, which is not"},
           {"time (ms),gap1\n0,1\n0,2\n",
            "m.csv:3:1: data: ", "0 s is not after the 0 s before it"},
           {"force,gap1\n0,1\n",
            "m.csv:1:1: data: ", "there is neither a column 'time' (or 't') nor"},
           {"speed,e\n1,0.5\n", "m.csv:1:1: data: ", "neither a column 'time'"},
           {"time,gap1,q1\n0,1,2\n1,2,3\n", "m.csv:1:1: data: ", "how they are to be weighed"},
           {"time,gap1,sigma\n0,1,1\n1,2,0\n", "m.csv:3:5: data: ", "must be above 0"},
           {"speed,restitution\n0,0.5\n", "m.csv:2:1: data: ", "approach speed must be above 0"},
           {"speed,restitution\n1,80\n", "m.csv:2:3: data: ", "80 is far from what a restitution"},
           {"time\n1\n1\n", "m.csv:3:1: data: ", "times must increase"},
           {"time,stop\n1,2\n", "m.csv:2:3: data: ", "2 is not allowed; stops count from 1 to 1"},
           {"time,stop\n1,0.5\n", "m.csv:2:3: data: ", "0.5 is not allowed"},
           {"kind,time\nstick,1\n", "m.csv:1:1: data: ", "no row is an impact or a contact"},
       }) {
    const std::string message = error_of(bad.text);
    EXPECT_EQ(message.rfind(bad.place, 0), 0u) << bad.text << " gives " << message;
    EXPECT_NE(message.find(bad.sentence), std::string::npos) << bad.text << " gives " << message;
  }
  const std::string binary = error_of(std::string("time\0\1\n", 7));
  EXPECT_EQ(binary.rfind("m.csv:1:5: data: this is no text", 0), 0u) << binary;
}

TEST(Measurements, OfImpactsNeedStopsInTheScene) {
  EXPECT_NE(error_of("time\n1\n", two_stops()).find("the scene has 2 stops; a column 'stop'"),
            std::string::npos);
  EXPECT_NE(error_of("time\n1\n", parse_scene("[modal]\nfrequencies = [1.0]\n", "scene"))
                .find("the scene has no stop"),
            std::string::npos);
}

TEST(Measurements, RefuseOptionsThatFitNothing) {
  EXPECT_EQ(error_of("time,gap1\n0,1\n1,2\n", one_stop(), {{"q1"}, {}}),
            "--column: m.csv has no column 'q1' that a motion has; allowed are gap1");
  EXPECT_EQ(error_of("time,gap1\n0,1\n1,2\n", one_stop(), {{}, {{"q1", 1.0}}}),
            "--sigma: no column 'q1' is fitted");
  EXPECT_NE(error_of("speed,restitution\n1,0.5\n", one_stop(), {{"speed"}, {}}).find("--column"),
            std::string::npos);
}

}  // namespace
}  // namespace graze
