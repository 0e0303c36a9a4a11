// Response curves as a user asks for them: simulate --amplitudes, continue and diagram --show.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kResponseOscillator =
    std::string(GRAZE_SOURCE_DIR) + "/data/validation/nlvib_oscillator.toml";
const std::string kResponseRange =
    kResponseOscillator + " --parameter forcing.frequency --from 0.5 --to 0.85 ";

json document(const std::string& arguments, int code = 0) {
  const Finished run = run_graze(arguments + " --json");
  EXPECT_EQ(run.code, code) << run.err;
  return json::parse(run.out);
}

// m = k = 1, c = 0.05, F = 0.02
double size_at(double frequency) {
  return 0.02 / std::hypot((1.0 - frequency) * (1.0 + frequency), 0.05 * frequency);
}

TEST(ResponseCurve, OfASweepIsContinuousWhereNothingIsHit) {
  const json found = document("diagram " + kResponseRange + "--points 8 --amplitudes");
  ASSERT_EQ(found["sweep"]["rows"].size(), 8U);
  for (const json& row : found["sweep"]["rows"]) {
    EXPECT_EQ(row["attractor"], "clear");
    const json& probe = row["amplitudes"][0];
    EXPECT_EQ(probe["probe"], 1);
    const double size = size_at(row["value"].get<double>());
    // The sweep ends as near to the orbit as 1e-8.
    for (const char* key : {"amplitude", "max", "half_range"})
      EXPECT_NEAR(probe[key].get<double>(), size, 1e-7 * size) << key;
    EXPECT_NEAR(probe["harmonic"]["amplitude"].get<double>(), size, 1e-7 * size);
    EXPECT_NEAR(probe["min"].get<double>(), -size, 1e-7 * size);
    EXPECT_EQ(row["amplitudes"][1]["stop"], 1);
    EXPECT_EQ(row["loads"][0]["impacts"], 0);
    EXPECT_EQ(row["loads"][0]["peak_force"], 0.0);
  }
  ASSERT_EQ(found["branches"].size(), 1U);
  EXPECT_EQ(found["branches"][0]["impacts"], 0);
  for (const json& point : found["branches"][0]["points"]) {
    const double size = size_at(point["value"].get<double>());
    EXPECT_NEAR(point["amplitudes"][0]["amplitude"].get<double>(), size, 1e-12 * size);
    EXPECT_TRUE(point["phase"].is_null());
  }
}

TEST(ResponseCurve, IsNotMeasuredUnlessThatIsAsked) {
  const json found = document("diagram " + kResponseRange + "--points 3");
  EXPECT_TRUE(found["branches"].empty());
  EXPECT_FALSE(found["sweep"]["rows"][0].contains("amplitudes"));
}

TEST(ResponseCurve, StandsInTheTables) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "out").string();
  ASSERT_EQ(run_graze("diagram " + kResponseRange + "--points 3 --amplitudes --out " + folder).code,
            0);
  for (const char* table : {"sweep.csv", "branches.csv"}) {
    const std::vector<std::string> lines = lines_of(std::filesystem::path(folder) / table);
    const auto columns = [](const std::string& line) {
      return std::count(line.begin(), line.end(), ',');
    };
    EXPECT_NE(lines[0].find(",probe_1_amplitude,probe_1_max,"), std::string::npos) << table;
    EXPECT_NE(lines[0].find(",stop_1_peak_force,stop_1_rms_force"), std::string::npos) << table;
    for (const std::string& line : lines) EXPECT_EQ(columns(line), columns(lines[0])) << table;
  }
  // A resumed run reads its rows back.
  const std::string again = run_graze("diagram " + kResponseRange +
                                      "--points 3 --amplitudes --json --resume --out " + folder)
                                .out;
  const json read = json::parse(again),
             fresh = document("diagram " + kResponseRange + "--points 3 --amplitudes");
  EXPECT_EQ(read["sweep"]["rows"], fresh["sweep"]["rows"]);
  EXPECT_EQ(read["branches"], fresh["branches"]);
}

TEST(ResponseCurve, IsDrawnWithItsOwnAxis) {
  const ScratchFolder scratch;
  const std::string picture = (scratch / "curve.svg").string();
  const auto script = scratch / "curve.gp";
  ASSERT_EQ(run_graze("continue " + kResponseRange + "--show rms --plot " + picture).code, 0);
  EXPECT_NE(read_text(script).find("root mean square at probe 1 (mm)"), std::string::npos);
  ASSERT_EQ(run_graze("diagram " + kResponseRange +
                      "--points 3 --show peak-velocity --at stop.1 --plot " + picture)
                .code,
            0);
  EXPECT_NE(read_text(script).find("largest velocity at stop 1 ("), std::string::npos);
  for (const char* command : {"continue ", "diagram "}) {
    const std::string page = (scratch / "curve.html").string();
    const Finished run =
        run_graze(command + kResponseRange + "--show amplitude --plot " + page + " --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_NE(read_text(page).find("amplitude at probe 1"), std::string::npos);
  }
}

// Clear of the stop the amplitude is |A / (1 - w^2 + i c w)| in every cell, with A = .02, c = .05.
TEST(ResponseCurve, OfAMapIsTheClosedFormWhereItIsClear) {
  const ScratchFolder scratch;
  const std::string plane =
      " --parameter forcing.frequency --from 0.5 --to 1.7 --points 7 --second "
      "stop.gap --second-from 0.05 --second-to 0.3 --second-points 4 ";
  const std::string base = std::string("map ") + GRAZE_SOURCE_DIR +
                           "/data/validation/nlvib_oscillator.toml" + plane + "--quiet ";
  const Finished run = run_graze(base + "--json --show amplitude --out " + scratch.string() +
                                 " --plot " + (scratch / "x.svg").string());
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  const json& amplitude = document["cells"]["amplitudes"][0]["amplitude"];
  ASSERT_EQ(amplitude.size(), 28U);
  int clear = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 7; ++i) {
      const double w = 0.5 + 0.2 * i, gap = 0.05 + 0.25 / 3.0 * j;
      const double linear = 0.02 / std::hypot(1.0 - w * w, 0.05 * w);
      const auto cell = static_cast<std::size_t>(7 * j + i);
      if (document["cells"]["peak_speed"][cell] != 0.0) {
        EXPECT_GT(amplitude[cell].get<double>(), gap);
        // Over a period the stop balances the spring, k = 1.
        const json& stop = document["cells"]["amplitudes"][1];
        const double force = stop["mean_force"][cell].get<double>();
        EXPECT_GT(force, 0.0);
        EXPECT_NEAR(force, std::abs(stop["mean"][cell].get<double>()), 1e-7 * force);
        continue;
      }
      EXPECT_LT(linear, gap);
      EXPECT_NEAR(amplitude[cell].get<double>(), linear, 1e-8 * linear);
      ++clear;
    }
  EXPECT_GT(clear, 10);
  EXPECT_NE(read_text(scratch / "x.gp").find("amplitude at "), std::string::npos);
  EXPECT_EQ(run_graze(base + "--show peak-force --at probe.1").code, 2);
}

TEST(ResponseCurve, SaysWhatPlacesThereAre) {
  const Finished none = run_graze("continue " + kResponseRange + "--show peak-force --at probe.1");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("--at: 'probe.1' is not allowed; give one of stop.1"), std::string::npos)
      << none.err;
  const Finished rate = run_graze("continue " + kResponseRange +
                                  "--show peak-velocity --at probe.2 --set probe.2.mass=1 "
                                  "--set 'probe.2.quantity=\"velocity\"'");
  EXPECT_EQ(rate.code, 2);
  EXPECT_NE(rate.err.find("--at: 'probe.2' is not allowed"), std::string::npos) << rate.err;
  EXPECT_EQ(run_graze("continue " + kResponseRange + "--show speediness").code, 2);
  EXPECT_EQ(run_graze("continue " + kResponseRange + "--at stop.1").code, 2);
}

TEST(ResponseCurve, IsRefusedWhereThereIsNone) {
  const std::string ball =
      scene("06_bouncing_ball.toml") +
      " --parameter gravity.acceleration --from 5 --to 9 --points 3 --duration 1 ";
  EXPECT_EQ(run_graze("diagram " + ball + "--show rms").code, 2);
  const std::string loci = "continue " + kResponseRange +
                           "--second stop.gap --second-from 0.05 --second-to 0.1 --locus GR ";
  EXPECT_EQ(run_graze(loci + "--amplitudes").code, 2);
  EXPECT_EQ(run_graze(loci + "--show rms").code, 2);
  EXPECT_EQ(run_graze(loci + "--impacts 0").code, 2);
  EXPECT_EQ(run_graze("continue " + kResponseRange + "--impacts 0 --period 2").code, 2);
}

TEST(ResponseCurve, OfAnotherQuantityIsDrawnFromTheSameRows) {
  const ScratchFolder scratch;
  const std::string line =
      "diagram " + kResponseRange + "--points 3 --out " + (scratch / "out").string() + " --show ";
  ASSERT_EQ(run_graze(line + "rms").code, 0);
  const Finished again = run_graze(line + "max --resume");
  EXPECT_EQ(again.code, 0) << again.err;
}

TEST(ResponseCurve, OfTheResponseAlone) {
  const json found = document("continue " + kResponseOscillator +
                              " --parameter forcing.frequency --from 0.5 --to 1.7 --impacts 0");
  ASSERT_EQ(found["branches"].size(), 2U);
  EXPECT_EQ(found["counters"]["starts"], 0);
  EXPECT_FALSE(found["branches"][0]["points"][0].contains("amplitudes"));
}

TEST(Amplitudes, OfARunAreThoseOfItsSteadyResponse) {
  // After 200 periods what is left of the start is below exp(-31).
  const json found = document("simulate " + kResponseOscillator +
                              " --set forcing.frequency=0.5 --periods 200 --amplitudes"
                              " --amplitudes-from 2400 --record none");
  const double size = size_at(0.5);
  EXPECT_NEAR(found["amplitudes"][0]["amplitude"].get<double>(), size, 1e-12 * size);
  EXPECT_NEAR(found["measured_time"].get<double>(), 200.0 * 4.0 * M_PI - 2400.0, 1e-9);
  EXPECT_FALSE(document("simulate " + kResponseOscillator + " --periods 2").contains("amplitudes"));
  EXPECT_EQ(run_graze("simulate " + kResponseOscillator + " --amplitudes-from 1").code, 2);
}

TEST(Amplitudes, OfForcesAreTablesOfTheirMeans) {
  const ScratchFolder scratch;
  const json found = document("simulate " + kResponseOscillator +
                              " --set forcing.frequency=1 --periods 20 --forces 64 --out " +
                              (scratch / "out").string());
  EXPECT_TRUE(found["amplitudes"].empty());
  const json& means = found["forces"]["means"][0];
  ASSERT_EQ(means.size(), 64U);
  double impulse = 0.0;
  for (const json& mean : means)
    impulse += mean.get<double>() * found["forces"]["window"].get<double>();
  const double whole = found["loads"][0]["impulse"].get<double>();
  EXPECT_GT(whole, 0.0);
  EXPECT_NEAR(impulse, whole, 1e-12 * whole);
  const std::vector<std::string> table = lines_of(scratch / "out/forces.csv");
  ASSERT_EQ(table.size(), 65U);
  EXPECT_EQ(table.front(), "from,to,force1");
  EXPECT_EQ(
      run_graze("simulate " + kResponseOscillator + " --forces 64 --amplitudes-from 1e9").code, 2);
}

}  // namespace
}  // namespace graze
