// graze map: what it prints, writes and draws, and how it ends.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kMapBasins =
    "--set forcing.frequency=1.6 --set stop.gap=0.5 --set forcing.amplitude=0.5 "
    "--set 'initial.q=[0.0]' --parameter initial.q.1 --from -2 --to 0.8 --points 15 "
    "--second initial.qdot.1 --second-from -2 --second-to 2 --second-points 11 " +
    scene("04_impact_oscillator.toml");

const std::string kLargePlane =
    "--parameter initial.q.1 --from -2 --to 0.8 --points 300 --second initial.qdot.1 "
    "--second-from -2 --second-to 2 --second-points 300 --set forcing.frequency=1.6 " +
    scene("04_impact_oscillator.toml");

TEST(MapCommand, HasEveryCell) {
  const ScratchFolder out;
  const Finished run = run_graze("map --json --out " + (out / "run").string() + " --plot " +
                                 (out / "m.svg").string() + " " + kMapBasins);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(document["x"]["parameter"], "initial.q.1");
  EXPECT_EQ(document["y"]["points"], 11);
  EXPECT_EQ(document["x"]["unit"], "kg^1/2 m");
  std::size_t named = 0;
  for (const json& attractor : document["attractors"])
    named += attractor["cells"].get<std::size_t>();
  std::size_t beyond = 0;
  for (const char* key : {"status", "attractor", "impacts_per_period", "peak_speed", "stuck_part"})
    ASSERT_EQ(document["cells"][key].size(), 165u) << key;
  for (const json& status : document["cells"]["status"]) beyond += status == "no start";
  EXPECT_EQ(beyond, 22u);  // 0.6 and 0.8 lie beyond the stop
  EXPECT_EQ(named + beyond, 165u);
  std::istringstream table(read_text(out / "run" / "map.csv"));
  std::string line;
  std::size_t lines = 0;
  while (std::getline(table, line)) ++lines;
  EXPECT_EQ(lines, 166u);
  const std::string picture = read_text(out / "m.svg");
  EXPECT_NE(picture.find("(1,1)"), std::string::npos);
  EXPECT_EQ(picture.find("<image"), std::string::npos) << "browsers smooth an image's few cells";
  EXPECT_EQ(
      run_graze("map --json --threads 1 --plot " + (out / "m.svg").string() + " " + kMapBasins).out,
      run.out);
}

// A map of 90 000 cells that was stopped at once is no document of as many entries.
TEST(MapCommand, DocumentOfUnfinishedWorkHoldsWhatIsDone) {
  const ScratchFolder out;
  const Finished run = run_graze("map --quiet --threads 1 --max-seconds 0.05 --out " +
                                 (out / "run").string() + " " + kLargePlane);
  ASSERT_EQ(run.code, 3) << run.err;
  const json document = json::parse(read_text(out / "run" / "result.json"));
  const json& cells = document["cells"];
  ASSERT_LT(cells["index"].size(), 90'000U);
  for (const char* key : {"status", "attractor", "impacts_per_period", "peak_speed", "stuck_part"})
    EXPECT_EQ(cells[key].size(), cells["index"].size()) << key;
  for (const json& status : cells["status"]) EXPECT_TRUE(status.is_string());
  EXPECT_LT(std::filesystem::file_size(out / "run" / "record.json"),
            400'000U + 400U * cells["index"].size());
  const Finished view = run_graze("view --json " + (out / "run").string());
  EXPECT_EQ(view.out, read_text(out / "run" / "result.json")) << view.err;
}

// The loci over a map are those that continue --locus traces over the same plane.
TEST(MapCommand, DrawsLociOverIt) {
  const ScratchFolder out;
  const std::string plane =
      " --parameter forcing.frequency --from 40 --to 60 --second stop.gap --second-from 1e-3 "
      "--second-to 3e-3 --locus LP,PD --slices 2 " +
      scene("05_wagg_one_mode.toml");
  const Finished map =
      run_graze("map --json --points 8 --second-points 6 --out " + (out / "run").string() +
                " --plot " + (out / "m.svg").string() + plane);
  ASSERT_EQ(map.code, 0) << map.err;
  const Finished alone = run_graze("continue --json" + plane);
  ASSERT_EQ(alone.code, 0) << alone.err;
  const json document = json::parse(map.out);
  EXPECT_GE(document["loci"].size(), 2u);
  EXPECT_EQ(document["loci"], json::parse(alone.out)["loci"]);
  EXPECT_NE(read_text(out / "m.svg").find("period doubling (PD)"), std::string::npos);
  EXPECT_NE(read_text(out / "run" / "loci.csv").find("PD"), std::string::npos);
  EXPECT_EQ(run_graze("map --locus PD " + kMapBasins).code, 2);
}

TEST(MapCommand, DrawsEveryQuantity) {
  const ScratchFolder out;
  for (const std::string what : {"impacts", "speed", "stuck", "exponent"}) {
    const Finished run =
        run_graze("map --show " + what + (what == "exponent" ? " --exponents 20" : "") +
                  " --plot " + (out / "m.png").string() + " " + kMapBasins);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_GT(read_text(out / "m.png").size(), 3000u);
  }
  EXPECT_EQ(run_graze("map --show exponent " + kMapBasins).code, 2);
}

TEST(MapCommand, KeepsWhatWasFinishedInTime) {
  const Finished run = run_graze("map --json --max-seconds 1e-9 " + kMapBasins);
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(json::parse(run.out)["outcome"], "budget");
  EXPECT_EQ(run_graze("map --second stop.gap " + kMapBasins).code, 2);
}

}  // namespace
}  // namespace graze
