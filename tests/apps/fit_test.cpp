// graze fit as a user meets it.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace graze {
namespace {

using nlohmann::json;

std::string pair(const std::string& name) {
  return measured(name + ".toml") + " " + measured(name + ".csv");
}

const std::string kContact =
    pair("contact") +
    " --parameter stop.spring.stiffness=1e6:1e9 --parameter stop.spring.exponent=1:2 "
    "--parameter stop.spring.damping.coefficient=0:1e9";
const std::string kImpacts =
    pair("impacts") +
    " --parameter stop.gap=0.5:2 --parameter stop.restitution=0.5:1 --parameter "
    "record.start=0:0.3";
const std::string kResponse =
    pair("response") + " --parameter damping.viscous=0.001:0.2 --parameter stop.gap=4e-3:6e-3";

// The values that make_measurements.py made the shipped measurements with.
TEST(FitCommand, FindsTheValuesBehindTheShippedMeasurements) {
  const std::vector<std::pair<std::string, std::vector<double>>> cases = {
      {pair("restitution"), {0.92, 0.11, 0.015}},
      {kContact, {2e7, 1.5, 1.5e7}},
      {kImpacts, {1.2, 0.83, 0.15}},
      {kResponse, {0.05, 5.2e-3}},
  };
  for (const auto& [line, truth] : cases) {
    const Finished run = run_graze("fit --json " + line);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "") << line;
    const json document = json::parse(run.out);
    EXPECT_EQ(document["outcome"], "fitted");
    ASSERT_EQ(document["parameters"].size(), truth.size());
    for (std::size_t j = 0; j < truth.size(); ++j) {
      const json& parameter = document["parameters"][j];
      EXPECT_LE(parameter["interval"][0].get<double>(), truth[j]) << parameter;
      EXPECT_GE(parameter["interval"][1].get<double>(), truth[j]) << parameter;
      EXPECT_GT(parameter["uncertainty"].get<double>(), 0.0);
    }
    // Again, to the last bit, with as many threads as one likes.
    EXPECT_EQ(run_graze("fit --json --threads 3 " + line).out, run.out);
  }
}

TEST(FitCommand, SaysWhatItFound) {
  const Finished run = run_graze("fit --wide --verbose " + kResponse);
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char* part :
       {"response in ", "95 % interval", "damping.viscous (N s/m^2)", "0.001..0.2", "correlation",
        "displacement1: 300 values", "Student's t with 298 degrees of freedom", "BOBYQA"})
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
  const Finished known = run_graze("fit --wide --sigma 5e-5 " + kResponse);
  EXPECT_NE(known.out.find("intervals: 1.96 standard uncertainties, from the uncertainties of the "
                           "data"),
            std::string::npos)
      << known.out;
}

TEST(FitCommand, WritesItsFiles) {
  const ScratchFolder scratch;
  const std::string out = (scratch / "run").string();
  const Finished run = run_graze("fit --json --out " + out + " --plot " +
                                 (scratch / "fit.svg").string() + " " + kResponse);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(names_in(out), (std::vector<std::string>{"fit.csv", "fitted.toml", "parameters.csv",
                                                     "record.json", "result.json", "scene.toml"}));
  EXPECT_EQ(read_text(scratch / "run" / "result.json"), run.out);
  const json document = json::parse(run.out);
  EXPECT_EQ(document["data"]["kind"], "response");
  EXPECT_EQ(document["data"]["values"], 300);
  EXPECT_EQ(document["data"]["sha256"].get<std::string>().size(), 64u);
  EXPECT_EQ(document["at"]["unit"], "s");
  EXPECT_EQ(document["degrees_of_freedom"], 298);
  EXPECT_EQ(document["correlations"][0][0], 1.0);
  EXPECT_EQ(document["correlations"][0][1], document["correlations"][1][0]);
  const json& series = document["series"][0];
  EXPECT_EQ(series["unit"], "m");
  EXPECT_EQ(series["measured"].size(), 300u);
  EXPECT_EQ(series["predicted"].size(), 300u);
  EXPECT_EQ(lines_of(scratch / "run" / "fit.csv").size(), 301u);
  EXPECT_EQ(lines_of(scratch / "run" / "fit.csv")[0],
            "series,time,measured,predicted,residual,uncertainty");
  EXPECT_EQ(lines_of(scratch / "run" / "parameters.csv").size(), 3u);
  const std::string picture = read_text(scratch / "fit.svg");
  for (const char* word :
       {"displacement u (mm)", "residual (mm)", "time (s)", "fitted", "measured"})
    EXPECT_NE(picture.find(word), std::string::npos) << word;
  // The fitted scene is one, with these values.
  const Finished again =
      run_graze("fit --json " + (scratch / "run" / "fitted.toml").string() + " " +
                measured("response.csv") + " --parameter stop.gap=4e-3:6e-3");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["parameters"][0]["start"], document["parameters"][1]["value"]);
}

TEST(FitCommand, TakesTheTablesThatSimulateWrites) {
  const ScratchFolder scratch;
  const std::string out = (scratch / "run").string();
  ASSERT_EQ(run_graze("simulate --duration 1 --record samples --set stop.gap=5.1e-3 --out " + out +
                      " " + measured("response.toml"))
                .code,
            0);
  const std::string sought = " --json --parameter stop.gap=4e-3:6e-3";
  Finished run = run_graze("fit " + measured("response.toml") + " " + out + "/events.csv" + sought);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NEAR(json::parse(run.out)["parameters"][0]["value"].get<double>(), 5.1e-3, 1e-12);
  run = run_graze("fit " + measured("response.toml") + " " + out + "/samples.csv --column q1" +
                  sought);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NEAR(json::parse(run.out)["parameters"][0]["value"].get<double>(), 5.1e-3, 1e-12);
  EXPECT_EQ(json::parse(run.out)["data"]["unused_columns"].size(), 5u);
  // Several columns with their uncertainties.
  run = run_graze("fit " + measured("response.toml") + " " + out +
                  "/samples.csv --column q1,qdot1 --sigma q1=1e-6 --sigma qdot1=1e-4" + sought);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["series"].size(), 2u);
  EXPECT_EQ(json::parse(run.out)["uncertainties"], "given");
  EXPECT_EQ(json::parse(run.out)["graze"]["options"]["column"], "q1,qdot1");
  EXPECT_EQ(json::parse(run.out)["graze"]["options"]["sigma"], "q1=1e-6 qdot1=1e-4");
}

TEST(FitCommand, RefusesWhatCannotBeUsed) {
  const ScratchFolder scratch;
  const std::string bad = (scratch / "bad.csv").string();
  std::ofstream(bad) << "time,gap1\n0,1e-3\n1,nan\n";
  const std::string start = "fit " + measured("response.toml") + " ";
  Finished run = run_graze(start + bad + " --parameter stop.gap=4e-3:6e-3");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, bad + ":3:3: data: gap1: 'nan' is not a finite number\n");
  // In mm: known only once the model has been asked, and still nothing is written.
  std::ofstream(bad) << "time,displacement1\n0.1,1\n0.2,-3\n0.3,4\n";
  run = run_graze(start + bad + " --parameter stop.gap=4e-3:6e-3 --out " +
                  (scratch / "out").string());
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err.rfind(bad + ":4:5: data: displacement1: the values reach 4 m", 0), 0u)
      << run.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
  EXPECT_EQ(run_graze(start + bad + " --parameter stop.gap=4e-3").code, 2);
  EXPECT_EQ(run_graze(start + bad + " --parameter stop.gap=a:b").code, 2);
  EXPECT_EQ(run_graze(start + bad + " --parameter stop.gap=1:2 --sigma 0").code, 2);
  EXPECT_EQ(run_graze(start + bad + " --parameter stop.gap=1:2 --algorithm best").code, 2);
  EXPECT_EQ(run_graze(start).code, 2);
  run = run_graze(start + (scratch / "none.csv").string() + " --parameter stop.gap=4e-3:6e-3");
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("none.csv"), std::string::npos);
  EXPECT_EQ(run_graze(start + scratch.string() + " --parameter stop.gap=4e-3:6e-3").code, 4);
  run = run_graze("fit --set solver.flow=dopri5 " + kResponse);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("fitted with the exact flow"), std::string::npos);
}

TEST(FitCommand, WithoutAnEndSaysWhyAndWhatItHas) {
  Finished run = run_graze("fit --json --max-evaluations 10 " + kContact);
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(json::parse(run.out)["outcome"], "budget");
  EXPECT_EQ(json::parse(run.out)["parameters"][0]["uncertainty"], nullptr);
  run = run_graze("fit --wide " + pair("response") + " --parameter forcing.phase=-1:1 " +
                  "--parameter beam.density=8000:9000 --parameter beam.area=1e-5:2e-5");
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(
      run.out.find("not_determined: the data determine only a combination of beam.density and "
                   "beam.area"),
      std::string::npos)
      << run.out;
  EXPECT_EQ(run_graze("fit --max-seconds 1e-9 " + kContact).code, 3);
}

TEST(FitCommand, EndsWhenInterruptedWithTheBestSoFar) {
  // A budget that would take minutes.
  const Finished run =
      run_graze("fit --json --algorithm global --max-evaluations 10000000 " + kContact,
                "timeout --preserve-status -s INT 1 ");
  EXPECT_EQ(run.code, 130);
  const json document = json::parse(run.out);
  EXPECT_EQ(document["outcome"], "interrupted");
  EXPECT_EQ(document["series"][0]["predicted"].size(), 401u);
}

}  // namespace
}  // namespace graze
