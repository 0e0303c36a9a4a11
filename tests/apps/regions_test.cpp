// What is stable in the plane of `graze continue --locus --regions`, as a user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kRegionPlane =
    " --parameter forcing.frequency --from 45 --to 55 --second stop.gap --second-from 1e-3 "
    "--second-to 2e-3 --set stop.gap=1.5e-3 --set forcing.frequency=50 --slices 1 ";

TEST(RegionsCommand, WritesTheDocument) {
  const Finished run =
      run_graze("continue --json --locus GR --regions 5" + kRegionPlane + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "complete");
  EXPECT_EQ(document["graze"]["options"]["regions"], 5);
  const json& regions = document["regions"];
  EXPECT_EQ(regions["columns"], 5);
  EXPECT_EQ(regions["rows"], 5);
  ASSERT_EQ(regions["places"].size(), 25u);
  // The middle of the plane, where the linear response is clear and impacts go on.
  const json& middle = regions["places"][12];
  EXPECT_NEAR(middle["value"].get<double>(), 50.0, 1e-12);
  EXPECT_NEAR(middle["second"].get<double>(), 1.5e-3, 1e-15);
  EXPECT_EQ(middle["label"], "(1,1) + no impact");
  int places = 0;
  double share = 0.0;
  for (const json& area : regions["areas"]) {
    places += area["places"].get<int>();
    share += area["share"].get<double>();
    bool inside = false;
    for (const json& place : regions["places"])
      inside = inside || (place["value"] == area["value"] && place["second"] == area["second"] &&
                          place["label"] == area["label"] && place["area"] == area["id"]);
    EXPECT_TRUE(inside) << area;
  }
  EXPECT_EQ(places, 25);
  EXPECT_NEAR(share, 1.0, 1e-12);
  EXPECT_TRUE(regions["boundaries"].is_null());  // the loci are not all there
  const json& counters = regions["counters"];
  EXPECT_EQ(counters["places"], 25);
  EXPECT_EQ(counters["refuted"], 0);
  EXPECT_EQ(counters["missed"], 0);
  EXPECT_GE(counters["confirmed"].get<int>(), 10);
  EXPECT_GE(counters["simulated"].get<int>(), 25);
}

TEST(RegionsCommand, WritesATableAndAPicture) {
  const ScratchFolder folder;
  const Finished run =
      run_graze("continue --wide --locus all --regions 4 --out " + folder.string() + " --plot " +
                (folder / "plane.svg").string() + kRegionPlane + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const std::vector<std::string> lines = lines_of(folder / "regions.csv");
  ASSERT_EQ(lines.size(), 17u);
  EXPECT_EQ(lines[0], "value,second,area,label");
  EXPECT_EQ(lines[1].back(), '"');
  EXPECT_NE(
      run.out.find("4 by 4 places; regions smaller than 2.5 rad/s by 0.00025 m may be missed"),
      std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("(1,1) + no impact"), std::string::npos);
  EXPECT_NE(run.out.find("a locus passes between"), std::string::npos);
  EXPECT_EQ(run.out.find("no locus passes between"), std::string::npos) << run.out;
  const std::string script = read_text(folder / "plane.gp");
  EXPECT_NE(script.find("boxxyerror"), std::string::npos);
  EXPECT_LT(script.size(), 200'000u);
}

TEST(RegionsCommand, DoNotDependOnThreads) {
  const auto document = [](const std::string& threads) {
    const Finished run = run_graze("continue --json --locus GR --regions 6 --threads " + threads +
                                   kRegionPlane + kOneMode);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out)["regions"];
  };
  EXPECT_EQ(document("1"), document("2"));
}

TEST(RegionsCommand, KeepsWhatTheTimeAllows) {
  const Finished run = run_graze("continue --json --locus GR --regions 300 --max-seconds 2" +
                                 kRegionPlane + kOneMode);
  EXPECT_EQ(run.code, 3) << run.err;
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "budget");
  EXPECT_GT(document["regions"]["places"].size(), 0u);
  EXPECT_LT(document["regions"]["places"].size(), 90'000u);
  EXPECT_EQ(document["regions"]["places"].size(), document["regions"]["counters"]["places"]);
}

TEST(RegionsCommand, ShowsRegionsWhereNoLocusIs) {
  const Finished run = run_graze(
      "continue --json --locus NS --regions 3 --set stop.gap=1.5e-3 --set forcing.frequency=50 "
      "--parameter forcing.frequency --from 49 --to 51 --second stop.gap --second-from 1.45e-3 "
      "--second-to 1.55e-3 --slices 1 " +
      kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_TRUE(document["loci"].empty());
  ASSERT_EQ(document["regions"]["areas"].size(), 1u);
  EXPECT_EQ(document["regions"]["areas"][0]["label"], "(1,1) + no impact");
}

TEST(RegionsCommand, RefusesInWords) {
  const auto expect_refused = [&](const std::string& options, const std::string& words) {
    const Finished run = run_graze("continue " + options + kOneMode);
    EXPECT_EQ(run.code, 2) << options;
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  };
  expect_refused("--regions 4 --parameter forcing.frequency --from 45 --to 55 ", "--locus");
  expect_refused("--locus GR --regions 0" + kRegionPlane, "1 to 400");
  expect_refused("--locus GR --regions 2.5" + kRegionPlane, "2.5");
}

}  // namespace
}  // namespace graze
