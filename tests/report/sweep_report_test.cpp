// The tables of a sweep: what each kind of row looks like.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "graze/record/names/motion_names.hpp"
#include "graze/report/csv/csv.hpp"
#include "graze/report/json/json.hpp"
#include "graze/report/text/text.hpp"

namespace graze {
namespace {

SweepRow periodic_row() {
  SweepRow row;
  row.value = 1.5;
  row.status = SweepStatus::kSettled;
  row.start = SweepStart::kHandedOn;
  row.motion.kind = SettledKind::kImpacts;
  row.motion.period = 2;
  row.motion.near = true;
  row.motion.remaining = 0.5e-8;
  row.motion.periods = 50;
  row.motion.impacts = {{48, 0, 7.0, 0.25}, {49, 0, 1.25, 0.5}};
  row.stop_states = {{0, 0.125, 0.0}, {0, 0.25, -1.0}};
  return row;
}

SweepRow failed_row() {
  SweepRow row;
  row.value = 2.0;
  row.status = SweepStatus::kNoStart;
  row.message = "the motion would start 1, 2 or 3 mm beyond the stop";
  return row;
}

DiagramRecord record_of(std::vector<SweepRow> rows, DiagramSection section) {
  DiagramRecord record;
  record.branches.info.command = "diagram";
  record.branches.traced.parameter = "stop.gap";
  record.branches.unit = "m";
  record.branches.outcome = {"complete", ""};
  record.swept.parameter = "stop.gap";
  record.swept.rows = std::move(rows);
  record.section = section;
  return record;
}

std::string sweep_csv(const DiagramRecord& record) {
  return csv_text(*made_table(tables_of(record), "sweep"));
}

TEST(SweepReport, OneLineASampleAndOneForAValueWithout) {
  EXPECT_EQ(sweep_csv(record_of({periodic_row(), failed_row()}, DiagramSection::kImpact)),
            "value,start,status,attractor,period,impacts,periods,remaining,sample,stop,"
            "period_index,phase,speed,displacement,velocity\n"
            "1.5,handed on,settled,impacts,2,2,50,5e-09,1,1,0,0.7168146928204138,0.25,,\n"
            "1.5,handed on,settled,impacts,2,2,50,5e-09,2,1,1,1.25,0.5,,\n"
            "2,scene,no start,no start,,,0,,,,,,,,\n");
  EXPECT_EQ(sweep_csv(record_of({periodic_row()}, DiagramSection::kStroboscopic)),
            "value,start,status,attractor,period,impacts,periods,remaining,sample,stop,"
            "period_index,phase,speed,displacement,velocity\n"
            "1.5,handed on,settled,impacts,2,2,50,5e-09,1,1,0,,,0.125,0\n"
            "1.5,handed on,settled,impacts,2,2,50,5e-09,2,1,1,,,0.25,-1\n");
}

TEST(SweepReport, DocumentHasNullForWhatDoesNotExist) {
  SweepRow wild = periodic_row();
  wild.status = SweepStatus::kNotPeriodic;
  wild.motion.kind = SettledKind::kNotPeriodic;
  wild.motion.period = 0;
  wild.motion.remaining = std::numeric_limits<double>::infinity();
  const auto document = nlohmann::json::parse(
      to_json(record_of({periodic_row(), wild, failed_row()}, DiagramSection::kImpact)));
  const auto& rows = document["sweep"]["rows"];
  EXPECT_EQ(rows[0]["attractor"], "(2,2)");
  EXPECT_EQ(rows[0]["speeds"], nlohmann::json({0.25, 0.5}));
  EXPECT_EQ(rows[1]["attractor"], "not periodic");
  EXPECT_TRUE(rows[1]["period"].is_null());
  EXPECT_TRUE(rows[1]["remaining"].is_null());
  EXPECT_EQ(rows[1]["speeds"].size(), 2U);
  EXPECT_EQ(rows[2]["status"], "no start");
  EXPECT_EQ(rows[2]["message"], failed_row().message);
  EXPECT_EQ(document["sweep"]["ranges"].size(), 3U);
}

TEST(SweepReport, WhatDoesNotRepeatIsTorusOrChaosWhereExponentsTell) {
  SweepRow row = periodic_row();
  row.status = SweepStatus::kNotPeriodic;
  row.motion.kind = SettledKind::kNotPeriodic;
  row.motion.period = 0;
  row.exponents.emplace();
  for (const auto& [wandering, word] : {std::pair(Wandering::kOpen, "not periodic"),
                                        {Wandering::kTorus, "torus"},
                                        {Wandering::kChaos, "chaos"}}) {
    row.exponents->wandering = wandering;
    EXPECT_EQ(attractor_label(attractor_class(row)), word);
    EXPECT_EQ(attractor_kind(attractor_class(row)), word);
  }
}

TEST(SweepReport, RangesJoinNeighboursOfOneClass) {
  SweepRow a = periodic_row(), b = periodic_row(), slow = periodic_row();
  b.value = 1.75;
  slow.value = 1.875;
  slow.status = SweepStatus::kApproaching;
  const std::string text = to_text(record_of({a, b, slow, failed_row()}, DiagramSection::kImpact));
  std::istringstream lines(text);
  std::string line;
  int ranges = 0;
  while (std::getline(lines, line)) {
    if (line.find("(2,2)") == std::string::npos) continue;
    ++ranges;
    EXPECT_NE(line.find("1.5"), std::string::npos);
    EXPECT_NE(line.find("1.875"), std::string::npos);
    EXPECT_NE(line.find(" 3 "), std::string::npos);
  }
  EXPECT_EQ(ranges, 1);
  EXPECT_NE(text.find("no start"), std::string::npos);
  EXPECT_NE(text.find("note: at 1 value the motion repeats"), std::string::npos);
}

TEST(SweepReport, EveryKindHasAWordWithoutComma) {
  for (const SettledKind kind :
       {SettledKind::kImpacts, SettledKind::kSticks, SettledKind::kClear, SettledKind::kAtRest}) {
    const AttractorClass attractor{SweepStatus::kSettled, kind, 1, 1};
    EXPECT_EQ(attractor_kind(attractor).find(','), std::string::npos);
    EXPECT_FALSE(attractor_label(attractor).empty());
  }
  EXPECT_EQ(attractor_label({SweepStatus::kSettled, SettledKind::kSticks, 3, 0}), "(3,stick)");
}

}  // namespace
}  // namespace graze
