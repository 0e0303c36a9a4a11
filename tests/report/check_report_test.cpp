// What `graze check` prints of a hub, from the record: its lines and its part of the document.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "graze/record/records.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

CheckRecord record_of(const std::string& hub) {
  CheckRecord record;
  record.scene = parse_scene(
      "[beam]\nlength = 0.3\nyoungs_modulus = 2e11\nsecond_moment = 2e-13\ndensity = 8500\n"
      "area = 1e-5\nmodes = 2\n[hub]\nradius = 0.02\ninertia = 1e-3\n" +
          hub,
      "s");
  record.info = run_info("check", "s", record.scene);
  record.outcome = {"checked", ""};
  record.system.omega = record.system.modal().delta = Vector::Ones(2);
  return record;
}

void expect_lines(const std::string& text, const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    EXPECT_NE(text.find("\n  " + line + "\n"), std::string::npos) << line << "\n" << text;
}

TEST(CheckReport, SaysWhatIsSimulatedOfAHub) {
  const CheckRecord record = record_of(
      "torque = { kind = \"pulse\", amplitude = 1, duration = 0.05 }\n"
      "friction = { coulomb = 0.01 }\n[gravity]\nacceleration = 9.81\n"
      "[[probe]]\nposition = 0.25\nquantity = \"deflection\"\n");
  const std::string text = to_text(record);
  expect_lines(
      text,
      {"structure    clamped-free beam, 2 modes, Galerkin projection",
       "hub          radius 0.02 m, inertia 0.001 kg m^2, equations that conserve "
       "energy",
       "torque       1 N m for 0.05 s, then none", "centrifugal  terms with the square of the rate",
       "friction     Coulomb's at the joint, 0.01 N m",
       "gravity      9.81 m/s^2 along -u at angle 0", "probe 1      deflection (m) at x = 0.25 m"});
  EXPECT_EQ(text.find("forcing   "), std::string::npos);
  const auto document = nlohmann::json::parse(to_json(record));
  EXPECT_EQ(document["hub"]["radius"], 0.02);
  EXPECT_EQ(document["hub"]["torque"]["kind"], "pulse");
  EXPECT_EQ(document["hub"]["torque"]["duration"], 0.05);
  EXPECT_EQ(document["hub"]["equations"], "consistent");
  EXPECT_EQ(document["hub"]["centrifugal"], true);
  EXPECT_EQ(document["hub"]["friction"], 0.01);
}

TEST(CheckReport, SaysWhatIsNot) {
  const CheckRecord record = record_of("equations = \"paper\"\ncentrifugal = false\n");
  expect_lines(to_text(record),
               {"hub          radius 0.02 m, inertia 0.001 kg m^2, equations as in the paper",
                "torque       none: nothing drives the hub", "centrifugal  none",
                "friction     none at the joint", "gravity      none"});
  const auto document = nlohmann::json::parse(to_json(record));
  EXPECT_TRUE(document["hub"]["torque"].is_null());
  EXPECT_TRUE(document["hub"]["friction"].is_null());
  EXPECT_EQ(document["hub"]["equations"], "paper");
  const CheckRecord table =
      record_of("torque = { kind = \"table\", times = [0, 0.5, 2], values = [1, 1, 0] }\n");
  expect_lines(to_text(table),
               {"torque       3 points from 0 to 2 s, straight between them, none outside"});
  EXPECT_EQ(nlohmann::json::parse(to_json(table))["hub"]["torque"]["times"][2], 2.0);
}

}  // namespace
}  // namespace graze
