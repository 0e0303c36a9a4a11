// What becomes of a description: a document, its units, tables. The described result is made up.
#include <gtest/gtest.h>

#include <limits>

#include "graze/record/described/detail/result_visitor.hpp"
#include "graze/report/csv/detail/table_builder.hpp"
#include "graze/report/json/detail/document_writer.hpp"

namespace graze {
namespace {

struct Tooth {
  int number = 0;
  std::optional<double> wear;
};
struct Wheel {
  std::string name;
  std::complex<double> eigenvalue;
  std::optional<NumberPair> interval;
  std::vector<Tooth> teeth;
  std::optional<bool> turns;
};

void describe(ResultVisitor& v, const std::vector<Wheel>& wheels) {
  v.list({"wheels"}, wheels, [&](const Wheel& wheel, std::size_t i) {
    v.field(Field{"name"}.as("wheel").in("teeth"), wheel.name);
    v.row("wheels", [&] {
      v.field(Field{"number"}.tabular(), i + 1);
      v.field(Field{"eigenvalue", "1/s"}.as("re,im"), wheel.eigenvalue);
      if (const auto some = v.where(wheel.interval.has_value(), "that were measured"))
        v.field(Field{"interval", "m"}.as("low,high"), held(wheel.interval));
      v.part({"rim"}, [&] { v.field({"teeth"}, wheel.teeth.size()); });
      v.field({"turns"}, wheel.turns);
    });
    v.list({"teeth"}, wheel.teeth, [&](const Tooth& tooth, std::size_t) {
      v.row("teeth", [&] {
        v.field({"number"}, tooth.number);
        v.field({"wear", "m"}, tooth.wear);
      });
    });
    v.field(Field{"turns"}.in("teeth").tabular(), wheel.turns);
  });
  v.columns({"names"}, wheels,
            [&](const Wheel& wheel, std::size_t) { v.field({"name"}, wheel.name); });
  v.unit("load", "N");
}

const std::vector<Wheel> kWheels = {{"big",
                                     {1.0, -0.5},
                                     NumberPair{0.25, std::numeric_limits<double>::infinity()},
                                     {{1, 0.5}, {2, {}}},
                                     true},
                                    {"none", {}, {}, {}, {}},
                                    {"small, old", {2.0, 0.0}, {}, {{1, 0.125}}, false}};

std::string table(const char* name, const std::vector<Wheel>& wheels) {
  return csv_text(built_table(name, [&](ResultVisitor& v) { describe(v, wheels); }));
}

TEST(Described, BecomesADocument) {
  DocumentWriter writer;
  describe(writer, kWheels);
  EXPECT_EQ(Json::parse(writer.take().dump()), Json::parse(R"({"wheels": [
      {"name": "big", "eigenvalue": [1.0, -0.5], "interval": [0.25, null], "rim": {"teeth": 2},
       "turns": true, "teeth": [{"number": 1, "wear": 0.5}, {"number": 2, "wear": null}]},
      {"name": "none", "eigenvalue": [0.0, 0.0], "rim": {"teeth": 0}, "turns": null, "teeth": []},
      {"name": "small, old", "eigenvalue": [2.0, 0.0], "rim": {"teeth": 1}, "turns": false,
       "teeth": [{"number": 1, "wear": 0.125}]}],
    "names": {"name": ["big", "none", "small, old"]}})"));
}

TEST(Described, ListsOfNothingAreThere) {
  DocumentWriter writer;
  describe(writer, {});
  EXPECT_EQ(writer.take().dump(), R"({"wheels":[],"names":{"name":[]}})");
}

TEST(Described, HasTheUnitsOfWhatMayBeThere) {
  UnitList units;
  describe(units, {});
  EXPECT_EQ(units.take().dump(), R"({"eigenvalue":"1/s","interval":"m","wear":"m","load":"N"})");
}

TEST(Described, HasTheTablesOfItsRows) {
  TableNames names;
  describe(names, {});
  EXPECT_EQ(names.names(), (std::vector<std::string>{"wheels", "teeth"}));
  EXPECT_EQ(table("wheels", kWheels),
            "number,re,im,low,high,rim_teeth,turns\n"
            "1,1,-0.5,0.25,,2,1\n"
            "2,0,0,,,0,\n"
            "3,2,0,,,1,0\n");
}

// Also what is handed over after them.
TEST(Described, RowsRepeatWhatStandsAroundThem) {
  EXPECT_EQ(table("teeth", kWheels),
            "wheel,number,wear,turns\n"
            "big,1,0.5,1\n"
            "big,2,,1\n"
            "\"small, old\",1,0.125,0\n");
  EXPECT_EQ(table("teeth", {}), "wheel,number,wear,turns\n");
}

}  // namespace
}  // namespace graze
