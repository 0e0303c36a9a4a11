// The loci of `graze continue --locus`, as a user meets them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kPlane =
    " --parameter forcing.frequency --from 53.5 --to 54.5 --second stop.gap --second-from 1.2e-3 "
    "--second-to 1.3e-3 --set stop.gap=1.25e-3 --set forcing.frequency=54 --slices 2 ";

TEST(LociCommand, WritesTheDocumentOfTheContract) {
  const Finished run = run_graze("continue --json --locus PD,GR" + kPlane + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(document["second"], "stop.gap");
  EXPECT_EQ(document["units"]["second"], "m");
  ASSERT_EQ(document["loci"].size(), 2u);
  const json& doubling = document["loci"][0];
  EXPECT_EQ(doubling["label"], "PD");
  EXPECT_EQ(doubling["ends"][1], "GR");
  ASSERT_EQ(doubling["special"].size(), 1u);
  EXPECT_EQ(doubling["special"][0]["label"], "PDGR");
  EXPECT_EQ(document["loci"][1]["label"], "GR");
  for (const json& locus : document["loci"])
    for (const json& point : locus["points"]) {
      EXPECT_TRUE(point["admissible"].get<bool>());
      EXPECT_GE(point["value"].get<double>(), 53.5);
      EXPECT_LE(point["value"].get<double>(), 54.5);
      EXPECT_GE(point["second"].get<double>(), 1.2e-3);
      EXPECT_LE(point["second"].get<double>(), 1.3e-3);
      // On a grazing of the motion that has no impacts the one listed is the grazing contact.
      if (locus["label"] == "GR") {
        EXPECT_NEAR(point["speed"].get<double>(), 0.0, 1e-12);
      }
    }
}

TEST(LociCommand, WritesTablesAndAPicture) {
  const ScratchFolder folder;
  const Finished run = run_graze("continue --locus all --out " + folder.string() + " --plot " +
                                 (folder / "plane.svg").string() + kPlane + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(lines_of(folder / "loci.csv").at(0),
            "locus,label,period,impacts,value,second,angle,phase,speed,admissible");
  EXPECT_EQ(lines_of(folder / "special.csv").at(0),
            "id,label,locus,value,second,angle,phase,speed,admissible");
  EXPECT_EQ(names_in(folder / ""),
            (std::vector<std::string>{"loci.csv", "plane.gp", "plane.gp.dat", "plane.svg",
                                      "record.json", "result.json", "scene.toml", "special.csv"}));
}

TEST(LociCommand, WithoutVirtualKeepsToOrbits) {
  const std::string plane =
      " --parameter forcing.frequency --from 40 --to 48 --second stop.gap --second-from 1e-3 "
      "--second-to 0.01 --set beam.modes=2 --set stop.gap=2e-3 --set forcing.frequency=44 "
      "--slices 3 ";
  const Finished real = run_graze("continue --json --locus LP" + plane + kOneMode);
  const Finished all = run_graze("continue --json --virtual --locus LP" + plane + kOneMode);
  ASSERT_EQ(real.code, 0) << real.err;
  ASSERT_EQ(all.code, 0) << all.err;
  const json orbits = json::parse(real.out), solutions = json::parse(all.out);
  int virtual_points = 0;
  for (const json& locus : solutions["loci"])
    for (const json& point : locus["points"]) virtual_points += point["admissible"] ? 0 : 1;
  EXPECT_GT(virtual_points, 0);
  EXPECT_FALSE(orbits["loci"].empty());
  for (const json& locus : orbits["loci"])
    for (const json& point : locus["points"]) EXPECT_TRUE(point["admissible"].get<bool>());
}

TEST(LociCommand, RefusesInWords) {
  const std::string range = " --parameter forcing.frequency --from 53 --to 55 ";
  const std::string second = " --second-from 1e-3 --second-to 2e-3 ";
  const auto expect_refused = [&](const std::string& options, const std::string& words) {
    const Finished run = run_graze("continue " + options + range + kOneMode);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  };
  expect_refused("--locus LP", "--second NAME --second-from C --second-to D");
  expect_refused("--locus LP --second stop.gap --second-from 1", "--second-to D");
  expect_refused("--locus XX --second stop.gap" + second, "XX");
  expect_refused("--second stop.gap" + second, "--locus");
  expect_refused("--locus LP --second stop.gapp" + second, "Did you mean stop.gap?");
  expect_refused("--locus LP --second forcing.frequency" + second, "differ from one another");
  expect_refused("--locus LP --second stop.gap --second-from 1 --second-to 1", "--second-from");
  expect_refused("--locus LP --second stop.restitution --second-from 0.5 --second-to 2", "0 to 1");
}

}  // namespace
}  // namespace graze
