// graze simulate --statistics, against motions in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;
using std::numbers::pi;

class RunStatistics : public ::testing::Test {
 protected:
  // The document of a run with statistics; the scene's text follows a line that names one mode.
  json run(const std::string& text, const std::string& options) {
    std::ofstream(file()) << "units = \"none\"\n[modal]\n" << text;
    const Finished run =
        run_graze("simulate --json --quiet --statistics " + options + " " + file());
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }
  json statistics(const std::string& text, const std::string& options) {
    return run(text, options)["statistics"];
  }
  std::string refusal(const std::string& arguments) {
    const Finished run = run_graze("simulate " + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    return run.err;
  }
  std::string file() const { return (scratch / "scene.toml").string(); }

  ScratchFolder scratch;
};

// An undamped oscillator in its steady response, u = A cos(w t) with A = a / (1 - w^2), seen by a
// probe. Half of its variance A^2/2 lies in the line, which has three frequencies.
TEST_F(RunStatistics, OfASineAreThoseOfASine) {
  const double w = 0.5, size = 0.3 / (1.0 - w * w);
  const json told = statistics(
      "frequencies = [1.0]\nparticipation = [1.0]\n[[probe]]\nshape = [1.0]\n"
      "[[probe]]\nshape = [1.0]\nquantity = \"velocity\"\n"
      "[forcing]\nkind = \"modal\"\namplitude = 0.3\nfrequency = 0.5\n"
      "[initial]\nq = [0.4]\nqdot = [0.0]\n",
      "--periods 90 --record none");
  const json& u = told["places"][0];
  EXPECT_EQ(u["place"], "probe_1");
  EXPECT_NEAR(u["mean"].get<double>(), 0.0, 1e-12);
  EXPECT_NEAR(u["rms"].get<double>(), size / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(u["standard_deviation"].get<double>(), size / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(u["max"].get<double>(), size, 1e-12);
  EXPECT_NEAR(told["places"][1]["rms"].get<double>(), w * size / std::sqrt(2.0), 1e-12);
  // A hundred samples a period, and the one at the end.
  EXPECT_EQ(told["samples"], 9001);
  for (std::size_t k = 0; k < told["shares"].size(); ++k) {
    const double share = told["shares"][k];
    // There are only a hundred different samples.
    EXPECT_NEAR(u["levels"][k].get<double>(), size * std::cos(pi * share), 0.04 * size) << share;
  }
  // Twenty periods are a segment.
  EXPECT_NEAR(told["segment"].get<double>(), 20.0 * 2.0 * pi / w, 1e-9);
  EXPECT_EQ(told["segments"], 8);
  const double step = told["frequencies"][1];
  EXPECT_NEAR(told["frequencies"][20].get<double>(), w / (2.0 * pi), 1e-12);
  EXPECT_NEAR(u["psd"][20].get<double>(), 0.5 * size * size / 1.5 / step, 1e-9);
  double power = 0.0;
  for (const json& density : u["psd"]) power += step * density.get<double>();
  EXPECT_NEAR(power, 0.5 * size * size, 1e-10);
  EXPECT_TRUE(told["stops"].empty());
}

TEST_F(RunStatistics, OfRestUnderAConstantLoadAreItsDeflection) {
  const json told = statistics(
      "frequencies = [2.0]\ninertia = [1.0]\n[[probe]]\nshape = [1.0]\n"
      "[gravity]\nacceleration = 10.0\n[initial]\nq = [2.5]\nqdot = [0.0]\n",
      "--duration 50");
  const json& u = told["places"][0];
  EXPECT_NEAR(u["mean"].get<double>(), 2.5, 1e-12);
  EXPECT_EQ(u["standard_deviation"], 0.0);
  for (const json& level : u["levels"]) EXPECT_NEAR(level.get<double>(), 2.5, 1e-12);
  for (const json& density : u["psd"]) EXPECT_LT(density.get<double>(), 1e-20);
}

// A ball of mass 1 under its weight g and a force a cos(w t + phi) meets a floor once in every
// period T at the speed v = g T/(1 + r): what the weight gives in a period is what an impact takes.
// It comes back to the floor where sin(phi) = pi g/a (1 - r)/(1 + r), and does so stably where a
// cos(phi) is between 0 and 2 g (1 + r^2)/(1 + r)^2.
TEST_F(RunStatistics, OfABallThatBouncesOnceAPeriod) {
  const double g = 1.0, a = 0.93, w = 2.0, r = 0.6, period = 2.0 * pi / w;
  const double v = g * period / (1.0 + r);
  const double phase = std::asin(pi * g / a * (1.0 - r) / (1.0 + r));
  std::ostringstream text;
  text.precision(17);
  text << "frequencies = [0.0]\nparticipation = [1.0]\ninertia = [1.0]\n[[stop]]\nshape = [1.0]\n"
       << "gap = 3.0\nrestitution = " << r << "\n[gravity]\nacceleration = " << g
       << "\n[forcing]\nkind = \"modal\"\namplitude = " << a << "\nfrequency = " << w
       << "\nphase = " << phase << "\n[initial]\nq = [3.0]\nqdot = [" << -r * v << "]\n";
  // From the middle of a period to the middle of one.
  std::ostringstream options;
  options.precision(17);
  options << "--duration " << 22.5 * period << " --amplitudes-from " << 2.5 * period;
  const json told = statistics(text.str(), options.str());
  const json& stop = told["stops"][0];
  EXPECT_NEAR(told["measured_time"].get<double>(), 20.0 * period, 1e-9);
  EXPECT_EQ(stop["impacts"], 20);
  EXPECT_NEAR(stop["impact_rate"].get<double>(), 1.0 / period, 1e-9);
  EXPECT_NEAR(stop["mean_speed"].get<double>(), v, 1e-7);
  EXPECT_NEAR(stop["largest_speed"].get<double>(), v, 1e-7);
  EXPECT_NEAR(stop["mean_impulse"].get<double>(), g * period, 1e-7);
  EXPECT_NEAR(stop["mean_force"].get<double>(), g, 1e-7);
  EXPECT_TRUE(stop["peak_force"].is_null());
  EXPECT_NEAR(stop["work_rate"].get<double>(), 0.5 * (1.0 - r * r) * v * v / period, 1e-7);
  EXPECT_EQ(stop["contacts"], 0);
  EXPECT_TRUE(stop["mean_contact"].is_null());
  // All speeds are in the last bin.
  const std::vector<long long> counts = stop["speeds"]["counts"];
  EXPECT_EQ(counts.back(), 20);
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0LL), 20);
  EXPECT_LE(
      (static_cast<double>(counts.size()) - 1.0) * stop["speeds"]["speed_width"].get<double>(), v);
  EXPECT_GT(static_cast<double>(counts.size()) * stop["speeds"]["speed_width"].get<double>(), v);
}

// An oscillator of frequency 1 that meets a spring k at its rest position with the speed v:
// contacts of half a period of sqrt(1 + k), then half a period on its own. The force is k v/s sin(s
// t).
TEST_F(RunStatistics, OfContactsWithASpring) {
  const double k = 24.0, s = 5.0, v = 2.0;
  const json told = statistics(
      "frequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = 0.0\n"
      "[stop.spring]\nstiffness = 24.0\nexponent = 1.0\n"
      "[initial]\nq = [-2.0]\nqdot = [0.0]\n",
      "--duration 37.6");  // nearly ten times pi + pi/5, from the middle of a flight
  const json& stop = told["stops"][0];
  const double contact = pi / s;
  EXPECT_EQ(stop["impacts"], 10);
  EXPECT_EQ(stop["contacts"], 10);
  EXPECT_NEAR(stop["mean_contact"].get<double>(), contact, 1e-10);
  EXPECT_NEAR(stop["longest_contact"].get<double>(), contact, 1e-10);
  EXPECT_NEAR(stop["mean_speed"].get<double>(), v, 1e-10);
  EXPECT_NEAR(stop["peak_force"].get<double>(), k * v / s, 1e-9);
  const double impulse = 2.0 * k * v / (s * s);
  EXPECT_NEAR(stop["mean_impulse"].get<double>(), impulse, 1e-9);
  EXPECT_NEAR(stop["mean_force"].get<double>(), 10.0 * impulse / 37.6, 1e-9);
  EXPECT_NEAR(stop["rms_force"].get<double>(), k * v / s * std::sqrt(10.0 * 0.5 * contact / 37.6),
              1e-9);
  EXPECT_NEAR(stop["work_rate"].get<double>(), 0.0, 1e-10);
  EXPECT_EQ(stop["durations"]["counts"].back(), 10);
}

// What a rigid stop holds is a contact from where it sticks to where it is released.
TEST_F(RunStatistics, TellHowLongARigidStopHolds) {
  const Finished run =
      run_graze("simulate --json --quiet --statistics --periods 20 " + kForcedChatter);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  double since = -1.0, sum = 0.0, longest = 0.0;
  int contacts = 0;
  for (const json& event : document["events"]) {
    if (event["kind"] == "stick") since = event["time"];
    if (event["kind"] != "release" || since < 0.0) continue;
    const double held = event["time"].get<double>() - since;
    sum += held, longest = std::max(longest, held), ++contacts;
  }
  ASSERT_GT(contacts, 5);
  const json& stop = document["statistics"]["stops"][0];
  EXPECT_EQ(stop["contacts"], contacts);
  EXPECT_NEAR(stop["mean_contact"].get<double>(), sum / contacts, 1e-12);
  EXPECT_NEAR(stop["longest_contact"].get<double>(), longest, 1e-12);
  double lost = 0.0;
  for (const json& event : document["events"])
    if (event.contains("energy_change")) lost -= event["energy_change"].get<double>();
  EXPECT_NEAR(stop["energy_lost"].get<double>(), lost, 1e-12 * lost);
}

// A picture takes more samples, a table other ones: statistics stay what they are. So they do where
// the run is gone on with from where they begin.
TEST_F(RunStatistics, DoNotDependOnWhatElseIsKept) {
  const auto folder = [&](const char* name) { return (scratch / name).string(); };
  const std::string whole = "--statistics --periods 40 --amplitudes-from 10.6814150222053 ";
  const auto of = [&](const std::string& name, const std::string& options) {
    const Finished run = run_graze("simulate --quiet " + options + " --out " +
                                   folder(name.c_str()) + " " + kOscillator);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(read_text(folder(name.c_str()) + "/result.json"))["statistics"];
  };
  const json plain = of("plain", whole + "--record none");
  EXPECT_GT(plain["stops"][0]["impacts"], 10);
  EXPECT_EQ(of("drawn", whole + "--plot " + folder("x.svg")), plain);
  EXPECT_EQ(of("psd", whole + "--show psd --plot " + folder("psd.svg")), plain);
  EXPECT_EQ(of("kept", whole + "--record samples"), plain);
  of("begin", "--duration 10.6814150222053");
  EXPECT_EQ(of("rest", "--statistics --periods 40 --resume " + folder("begin")), plain);
}

TEST_F(RunStatistics, AreTablesAndSeenAgain) {
  const std::string folder = (scratch / "out").string();
  const std::string options = " --statistics --periods 50 " + kOneMode;
  const Finished run = run_graze("simulate --out " + folder + options);
  ASSERT_EQ(run.code, 0) << run.err;
  const Finished seen = run_graze("view " + folder);
  EXPECT_EQ(seen.out, run.out);
  const json told = json::parse(read_text(folder + "/result.json"))["statistics"];
  EXPECT_EQ(lines_of(folder + "/statistics.csv").size(), told["places"].size() + 1);
  EXPECT_EQ(lines_of(folder + "/stop_statistics.csv").size(), 2U);
  EXPECT_EQ(lines_of(folder + "/psd.csv").size(), told["frequencies"].size() + 1);
  EXPECT_EQ(lines_of(folder + "/exceedance.csv").size(), told["shares"].size() + 1);
  EXPECT_EQ(lines_of(folder + "/histograms.csv").size(),
            told["stops"][0]["speeds"]["counts"].size() +
                told["stops"][0]["durations"]["counts"].size() + 1);
  for (const char* picture : {"psd.svg", "psd.html"})
    EXPECT_EQ(
        run_graze("view --show psd --plot " + (scratch / picture).string() + " " + folder).code, 0);
  const std::string bare = (scratch / "bare").string();
  EXPECT_EQ(run_graze("simulate --periods 5 --out " + bare + " " + kOneMode).code, 0);
  EXPECT_NE(run_graze("view --show psd --plot x.svg " + bare).err.find("--statistics"),
            std::string::npos);
}

TEST_F(RunStatistics, RefuseWhatTheyCannotHave) {
  const std::string at = " --periods 10 " + kOneMode;
  EXPECT_NE(refusal("--sample-rate 100" + at).find("--statistics"), std::string::npos);
  EXPECT_NE(refusal("--psd-segment 1" + at).find("--statistics"), std::string::npos);
  EXPECT_NE(refusal("--statistics --psd-segment 1e4" + at).find("are measured"), std::string::npos);
  EXPECT_NE(refusal("--statistics --sample-rate 1e9 --psd-segment 1" + at).find("--sample-rate"),
            std::string::npos);
  EXPECT_NE(refusal("--statistics --amplitudes-from 1e4" + at).find("nothing"), std::string::npos);
  EXPECT_NE(refusal("--show psd --plot x.svg" + at).find("--statistics"), std::string::npos);
  EXPECT_NE(refusal("--statistics --section stroboscopic" + at).find("--statistics"),
            std::string::npos);
}

// Samples are looked at one after the other and not kept: ten times as many take no more memory.
TEST_F(RunStatistics, TakeNoMoreMemoryInALongerRun) {
  const std::string run = "simulate --statistics --record none --max-seconds 300 " + kOscillator;
  const double shorter = peak_memory(run + " --periods 1000");
  EXPECT_LT(peak_memory(run + " --periods 10000"), shorter + 2.0);
}

}  // namespace
}  // namespace graze
