// --plot x.html: the file that is written and what it holds. tests/page opens it in a browser.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kRange =
    " --parameter forcing.frequency --from 58 --to 62 --points 9 --periods 300 --samples 20 ";

bool built_with_page() {
  const Finished run = run_graze("orbit --plot /no/such/folder/x.html " + kOneMode);
  return run.err.find("built without npm") == std::string::npos;
}

// Of a <script> that holds data.
json data_of(const std::string& page, const std::string& id) {
  const std::string open = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t from = page.find(open);
  EXPECT_NE(from, std::string::npos) << id;
  if (from == std::string::npos) return {};
  const std::size_t start = from + open.size();
  return json::parse(page.substr(start, page.find("</script>", start) - start));
}

template <class Number>
std::vector<Number> unpacked(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> held));
  }
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

TEST(Page, IsOneFileThatFetchesNothing) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const Finished run =
      run_graze("diagram --quiet --plot " + (scratch / "x.html").string() + kRange + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(names_in(scratch.string()), std::vector<std::string>{"x.html"});
  const std::string page = read_text(scratch / "x.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(page.find("Apache License"), std::string::npos);
  // The ways out of a page.
  for (const char* way : {" src=", " href=", "@import", "url(http", "url(\"http", "fetch(",
                          "XMLHttpRequest", "importScripts", "WebSocket"})
    EXPECT_EQ(page.find(way), std::string::npos) << way;
}

TEST(Page, HoldsTheDotsOfTheDocument) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const Finished run = run_graze("diagram --json --quiet --plot " + (scratch / "x.html").string() +
                                 kRange + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out), view = data_of(read_text(scratch / "x.html"), "view");
  EXPECT_EQ(view["head"]["graze"], document["graze"]);
  const auto number = [&](const std::string& key) {
    for (const json& any : view["things"]["numbers"])
      if (any["key"] == key) return any;
    ADD_FAILURE() << key;
    return json();
  };
  // The rows are the first things of the page, before the points of branches.
  const std::vector<double> values = unpacked<double>(number("forcing.frequency")["exact"]["f64"]);
  const auto first = unpacked<std::int32_t>(number("speed")["first"]["i32"]);
  const auto speeds = unpacked<float>(number("speed")["rough"]["f32"]);
  const auto phases = unpacked<float>(number("phase")["rough"]["f32"]);
  const json& rows = document["sweep"]["rows"];
  ASSERT_GE(values.size(), rows.size());
  ASSERT_EQ(first.size(), values.size() + 1);
  ASSERT_EQ(static_cast<std::size_t>(first[rows.size()]), speeds.size());
  ASSERT_EQ(speeds.size(), phases.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(values[i], rows[i]["value"].get<double>());
    const auto from = static_cast<std::size_t>(first[i]);
    ASSERT_EQ(static_cast<std::size_t>(first[i + 1]) - from, rows[i]["speeds"].size());
    for (std::size_t k = 0; k < rows[i]["speeds"].size(); ++k) {
      EXPECT_FLOAT_EQ(speeds[from + k], rows[i]["speeds"][k].get<float>());
      EXPECT_FLOAT_EQ(phases[from + k], rows[i]["phases"][k].get<float>());
    }
  }
}

// At 40 rad/s and a gap of 10 mm there are two orbits of one impact.
TEST(Page, AnOrbitMeetsItsStopAtItsImpactsAlone) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const Finished run = run_graze("orbit --quiet --set forcing.frequency=40 --set stop.gap=0.01 " +
                                 kOneMode + " --plot " + (scratch / "x.html").string());
  ASSERT_EQ(run.code, 0) << run.err;
  const json orbits = data_of(read_text(scratch / "x.html"), "orbits");
  ASSERT_EQ(orbits.size(), 2U);
  for (const json& orbit : orbits) {
    const json& place = orbit["places"][0];
    const auto t = unpacked<float>(place["t"]["f32"]), x = unpacked<float>(place["x"]["f32"]),
               v = unpacked<float>(place["v"]["f32"]);
    ASSERT_GT(t.size(), 100U);
    EXPECT_EQ(place["stops"][0]["place"], 0.01);
    const double impact = orbit["impacts"][0]["t"], speed = orbit["impacts"][0]["speed"];
    EXPECT_FLOAT_EQ(t.front(), static_cast<float>(impact));
    EXPECT_FLOAT_EQ(x.front(), 0.01F);
    EXPECT_LT(v.front(), 0.0F);             // away from the stop
    const std::size_t last = t.size() - 2;  // then a gap
    EXPECT_FLOAT_EQ(t[last], static_cast<float>(impact + 1.0));
    EXPECT_NEAR(x[last], 0.01, 1e-8);
    EXPECT_NEAR(v[last], speed, 1e-6);
    for (std::size_t i = 1; i < last; ++i) EXPECT_LT(x[i], 0.01F);
  }
}

TEST(Page, NoTextOfASceneEndsItsScripts) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const Finished run =
      run_graze("diagram --quiet --branches none --set 'title=\"</script><b>&\"' " + kRange +
                kOneMode + " --plot " + (scratch / "x.html").string());
  ASSERT_EQ(run.code, 0) << run.err;
  const json view = data_of(read_text(scratch / "x.html"), "view");
  // The scene's title, and what was set.
  EXPECT_EQ(view["subtitle"], "</script><b>& · title=\"</script><b>&\"");
  EXPECT_NE(view["made"].get<std::string>().find("--set 'title=\"</script><b>&\"'"),
            std::string::npos);
}

TEST(Page, IsThereWholeOrNotAtAll) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  EXPECT_EQ(
      run_graze("orbit --plot " + (scratch / "none" / "x.html").string() + " " + kOneMode).code, 4);
  std::ofstream(file) << "what stood here";
  const Finished run =
      run_graze("orbit --quiet --plot " + file + " " + kOneMode, "ulimit -f 100; ");
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
  EXPECT_EQ(read_text(file), "what stood here");
  EXPECT_EQ(names_in(scratch.string()), std::vector<std::string>{"x.html"});
}

TEST(Page, NamesAreCheckedBeforeTheWork) {
  const Finished gif = run_graze("orbit --plot x.gif " + kOneMode);
  EXPECT_EQ(gif.code, 2);
  EXPECT_NE(gif.err.find("x.gif: the name of a picture ends in .svg, .png, .pdf or .html"),
            std::string::npos)
      << gif.err;
}

// Sections are charts as other pictures are, and so have pages.
TEST(Page, OfASectionHoldsItsPoints) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  const Finished run =
      run_graze("simulate --section impact --periods 50 --quiet --plot " + file + " " + kOneMode);
  ASSERT_EQ(run.code, 0) << run.err;
  const json view = data_of(read_text(file), "view");
  EXPECT_EQ(view["title"], "Poincaré section");
  const json& series = view["rows"][0][0]["series"];
  ASSERT_EQ(series.size(), 1u);
  EXPECT_EQ(series[0]["dots"], true);
}

const std::string kBasins =
    " --set forcing.frequency=1.6 --set stop.gap=0.5 --set forcing.amplitude=0.5 "
    "--set 'initial.q=[0.0]' --parameter initial.q.1 --from -2 --to 0.8 --points 15 "
    "--second initial.qdot.1 --second-from -2 --second-to 2 --second-points 11 " +
    scene("04_impact_oscillator.toml");

TEST(Page, HoldsTheCellsOfTheDocument) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  const Finished run = run_graze("map --json --quiet --show speed --plot " + file + kBasins);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out), view = data_of(read_text(file), "view");
  const json &panel = view["rows"][0][0], &things = view["things"];
  EXPECT_EQ(panel["cells"]["shown"], "speed");
  EXPECT_EQ(panel["x"]["unit"], "kg^½ m");
  const std::vector<double> x = unpacked<double>(panel["cells"]["columns"]["f64"]);
  const std::vector<double> y = unpacked<double>(panel["cells"]["rows"]["f64"]);
  ASSERT_EQ(x.size(), 15u);
  ASSERT_EQ(y.size(), 11u);
  EXPECT_EQ(x.front(), -2.0);
  EXPECT_EQ(y.back(), 2.0);
  const auto kind = unpacked<std::uint8_t>(things["kind"]["u8"]);
  const json &kinds = things["kinds"], &cells = document["cells"];
  ASSERT_EQ(kind.size(), 165u);
  std::vector<std::string> keys;
  for (const json& number : things["numbers"]) keys.push_back(number["key"]);
  EXPECT_EQ(keys, (std::vector<std::string>{"impacts", "speed", "stuck"}));
  const auto impacts = unpacked<float>(things["numbers"][0]["rough"]["f32"]);
  const auto speeds = unpacked<float>(things["numbers"][1]["rough"]["f32"]);
  for (std::size_t i = 0; i < kind.size(); ++i) {
    const std::string name = kinds[kind[i]]["title"];
    if (cells["status"][i] == "no start") {
      EXPECT_EQ(name, "no start");
      EXPECT_TRUE(std::isnan(speeds[i]));
      continue;
    }
    const std::size_t attractor = cells["attractor"][i].get<std::size_t>() - 1;
    const std::string label = document["attractors"][attractor]["attractor"];
    EXPECT_EQ(name, label == "clear" ? "no impact" : label);
    EXPECT_EQ(view["cells"]["one"][kind[i]], true);
    // What is clear of the stops has no speed to show.
    if (name.starts_with("no impact"))
      EXPECT_TRUE(std::isnan(speeds[i]));
    else
      EXPECT_FLOAT_EQ(speeds[i], cells["peak_speed"][i].get<float>());
    EXPECT_FLOAT_EQ(impacts[i], cells["impacts_per_period"][i].get<float>());
  }
  // Why there is none is told.
  const auto message = unpacked<std::int32_t>(view["cells"]["messages"]["of"]["i32"]);
  EXPECT_GE(message[14], 0);
  EXPECT_EQ(message[0], -1);
}

TEST(Page, AMapTellsHowToFollowACell) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  ASSERT_EQ(
      run_graze("map --quiet --periods 300 --closure-speed 1e-6 --plot " + file + kBasins).code, 0);
  const json command = data_of(read_text(file), "view")["cells"]["command"];
  EXPECT_EQ(command["before"], "graze simulate " + scene("04_impact_oscillator.toml") +
                                   " --set forcing.frequency=1.6 --set stop.gap=0.5 --set "
                                   "forcing.amplitude=0.5 --set 'initial.q=[0.0]'");
  EXPECT_EQ(command["after"], " --periods 300 --closure-speed 1e-06 --plot cell.html");
  EXPECT_EQ(command["start"], json::parse(R"({"q": [0.0], "qdot": [0.0]})"));
}

TEST(Page, AMapOfTooManyCellsIsRefusedBeforeTheWork) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const Finished run = run_graze(
      "map --plot x.html --parameter forcing.frequency --from 15 --to 120 --points 2001 --second "
      "stop.gap --second-from 1e-4 --second-to 2e-3 --second-points 2000 " +
      kOneMode);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("x.html: a page of a map holds 4000000 cells at most, and this map has "
                         "4002000"),
            std::string::npos)
      << run.err;
}

// The events of the document are the impacts of the page, at the stop's place.
TEST(Page, HoldsTheMotionOfARun) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  const Finished run = run_graze("simulate --json --quiet --energy --duration 1 --plot " + file +
                                 " " + scene("02_wagg_momentum.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out), view = data_of(read_text(file), "view");
  EXPECT_EQ(view["kind"], "run");
  EXPECT_EQ(view["made"].get<std::string>().find("graze simulate --json"), 0u);
  const json& place = view["places"][0];
  const auto t = unpacked<double>(place["impacts"]["t"]["f64"]);
  const auto before = unpacked<float>(place["impacts"]["before"]["f32"]);
  std::size_t impacts = 0;
  for (const json& event : document["events"]) {
    if (event["kind"] != "impact") continue;
    ASSERT_LT(impacts, t.size());
    EXPECT_EQ(t[impacts], event["time"].get<double>());
    EXPECT_FLOAT_EQ(std::abs(before[impacts]), event["speed"].get<float>());
    ++impacts;
  }
  EXPECT_EQ(impacts, t.size());
  std::vector<std::string> panels;
  for (const json& row : view["rows"]) panels.push_back(row[0]["y"]["name"]);
  EXPECT_EQ(panels, (std::vector<std::string>{"displacement\ntowards the stop",
                                              "velocity\ntowards the stop", "contact\nforce",
                                              "energy,\nwork"}));
  const json& displacement = view["rows"][0][0];
  const auto is_stuck = [](const json& fill) { return fill["title"] == "stuck"; };
  EXPECT_EQ(std::count_if(displacement["fills"].begin(), displacement["fills"].end(), is_stuck), 1);
  const auto x = unpacked<double>(displacement["series"][0]["y"]["f64"]);
  EXPECT_EQ(x.size(), unpacked<float>(place["v"]["f32"]).size());
  // A structure that is held lies at its stop to rounding.
  EXPECT_DOUBLE_EQ(*std::max_element(x.begin(), x.end()), place["stops"][0]["place"].get<double>());
}

// Without a forcing, without samples of its own, without stops.
TEST(Page, AnyRunIsAPage) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  for (const std::string& line :
       {"--duration 1 " + scene("06_bouncing_ball.toml"), "--record none " + kOneMode,
        "--duration 0.4 " + scene("18_yigit_lee_wang_2.toml"), "--duration 0 " + kOneMode}) {
    const Finished run = run_graze("simulate --quiet --plot " + file + " " + line);
    ASSERT_EQ(run.code, 0) << line << run.err;
    const json view = data_of(read_text(file), "view");
    EXPECT_GE(view["rows"].size(), 2u) << line;
    const json& time = view["rows"][0][0]["x"];
    EXPECT_LT(time["low"].get<double>(), time["high"].get<double>()) << line;
  }
}

// The runs of the document are the dots and the table of the page.
TEST(Page, ADiagramOfSingleRunsIsAChart) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  const Finished run = run_graze("diagram --json --quiet --plot " + file +
                                 " --duration 1 --points 5 --parameter stop.restitution --from 0.5 "
                                 "--to 0.9 " +
                                 scene("06_bouncing_ball.toml"));
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out), view = data_of(read_text(file), "view");
  EXPECT_EQ(view["kind"], "chart");
  std::vector<double> speeds, found;
  for (const json& row : document["runs"])
    for (const json& impact : row["impacts"]) speeds.push_back(impact["speed"]);
  for (const json& series : view["rows"][0][0]["series"])
    for (const double speed : unpacked<double>(series["y"]["f64"]))
      if (std::isfinite(speed)) found.push_back(speed);
  std::sort(speeds.begin(), speeds.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, speeds);
  EXPECT_GT(found.size(), 4u);
  EXPECT_EQ(view["tables"][0]["rows"].size(), 5u);
  EXPECT_EQ(view["tables"][0]["rows"][4][0], "0.9");
}

// Regions are the cells of the page, loci its lines.
TEST(Page, HoldsTheLociOfTheDocument) {
  if (!built_with_page()) GTEST_SKIP() << "built without npm";
  const ScratchFolder scratch;
  const std::string file = (scratch / "x.html").string();
  const std::string line =
      "continue --json --quiet --locus PD --parameter forcing.frequency --from 20 --to 70 --second "
      "stop.gap --second-from 0.5e-3 --second-to 2e-3 --slices 1 --plot " +
      file + " " + kOneMode;
  const Finished loci = run_graze(line);
  ASSERT_EQ(loci.code, 0) << loci.err;
  const json view = data_of(read_text(file), "view"), document = json::parse(loci.out);
  EXPECT_FALSE(view["rows"][0][0].contains("cells"));
  std::size_t points = 0, drawn = 0;
  for (const json& locus : document["loci"]) points += locus["points"].size();
  for (const json& part : view["rows"][0][0]["series"])
    if (part["line"].get<bool>())
      for (const double x : unpacked<double>(part["x"]["f64"])) drawn += std::isfinite(x);
  EXPECT_GT(points, 20u);
  EXPECT_GE(drawn, points);  // where they cease to be orbits, both parts have the point
  const Finished regions = run_graze(line + " --regions 4");
  ASSERT_EQ(regions.code, 0) << regions.err;
  const json plane = data_of(read_text(file), "view"), places = json::parse(regions.out)["regions"];
  const json& cells = plane["rows"][0][0]["cells"];
  ASSERT_EQ(unpacked<std::uint8_t>(cells["ground"]["u8"]).size(), 16u);
  EXPECT_EQ(unpacked<double>(cells["columns"]["f64"]),
            (std::vector<double>{26.25, 38.75, 51.25, 63.75}));
  EXPECT_EQ(plane["cells"]["command"]["after"], " --period 1");
}

}  // namespace
}  // namespace graze
