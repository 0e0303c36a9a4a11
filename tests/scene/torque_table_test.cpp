#include "graze/scene/detail/torque_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "graze/scene/reader.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

// A file that is gone with the test.
class TorqueFile {
 public:
  explicit TorqueFile(const std::string& text) { std::ofstream(path(), std::ios::binary) << text; }
  std::filesystem::path path() const { return folder_ / "torque.csv"; }

 private:
  ScratchFolder folder_;
};

// What follows the file's name.
std::string table_error(const std::string& text) {
  const TorqueFile file(text);
  try {
    read_torque_file(file.path());
  } catch (const InputError& error) {
    return std::string(error.what()).substr(file.path().string().size());
  }
  return "accepted";
}

TEST(TorqueTable, IsReadWithAndWithoutNames) {
  for (const char* names :
       {"", "time (s),torque (N m)\n", "# measured\nt,T\n", "t [s], T [Nm]\r\n"}) {
    const TorqueFile file(std::string(names) + "0,1.5\n 0.25 , -2e-3\n\n0.5,0\n");
    const TorqueTable table = read_torque_file(file.path());
    EXPECT_EQ(table.times, (std::vector<double>{0.0, 0.25, 0.5})) << names;
    EXPECT_EQ(table.values, (std::vector<double>{1.5, -2e-3, 0.0})) << names;
  }
}

TEST(TorqueTable, IsReadAsSpreadsheetsWriteIt) {
  for (const char* text : {"t (ms);T (kNm)\n0;1,5\n250;-0,002\n",
                           "t [ms]\tT [kN*m]\n0\t1.5\n250\t-2e-3\n", "0;1500\n0,25;-2\n"}) {
    const TorqueFile file(text);
    const TorqueTable table = read_torque_file(file.path());
    EXPECT_EQ(table.times, (std::vector<double>{0.0, 0.25})) << text;
    EXPECT_EQ(table.values, (std::vector<double>{1500.0, -2.0})) << text;
  }
}

TEST(TorqueTable, MayJump) {
  const TorqueFile file("0,1\n0.1,1\n0.1,0\n0.2,0\n");
  EXPECT_EQ(read_torque_file(file.path()).times, (std::vector<double>{0.0, 0.1, 0.1, 0.2}));
}

TEST(TorqueTable, MistakesAreReportedWhereTheyStand) {
  EXPECT_EQ(table_error(""), ":1:1: data: the file is empty; it needs rows of numbers");
  EXPECT_EQ(table_error("time,torque\n"),
            ":1:1: data: there is no row of numbers below the column names");
  EXPECT_EQ(table_error("0,1\n"),
            ":1:1: data: the table has 1 row of numbers, it must have at least two");
  EXPECT_EQ(table_error("time,torque\n0,1\n"),
            ":1:1: data: the table has 1 row of numbers, it must have at least two");
  EXPECT_EQ(table_error("0\n1\n"),
            ":1:1: data: the table has 1 column, it must have two, time (s) and torque (N m)");
  EXPECT_EQ(table_error("t,T,x\n0,1,2\n1,1,2\n"),
            ":1:1: data: the table has 3 columns, it must have two, time (s) and torque (N m)");
  EXPECT_EQ(table_error("0,1\n0.1,1,2\n"), ":2:7: data: the row has 3 cells, line 1 has 2 columns");
  EXPECT_EQ(table_error("t,T\n0,1\n0.1\n"),
            ":3:1: data: the row has 1 cell, line 1 names 2 columns");
  EXPECT_EQ(table_error("t (min),T\n0,1\n1,1\n"),
            ":1:1: data: t: it is in min, which is not converted; give it in s");
  EXPECT_EQ(table_error("t,T (lbf ft)\n0,1\n1,1\n"),
            ":1:3: data: T: it is in lbf ft, which is not converted; give it in N m");
  EXPECT_EQ(table_error("0,1\n0.1,x\n"), ":2:5: data: column 2: 'x' is not a number");
  EXPECT_EQ(table_error("0,1\n0.1,\n"), ":2:5: data: column 2: a number is missing");
  EXPECT_EQ(table_error("t,T\n0,1\n0.1,inf\n"), ":3:5: data: T: 'inf' is not a finite number");
  EXPECT_EQ(table_error("-1,1\n0.1,1\n"),
            ":1:1: data: column 1: -1 is not allowed, it must be a finite number of at least 0");
  EXPECT_EQ(table_error("t,T\n0,1\n0.2,1\n 0.1,0\n"),
            ":4:2: data: t: 0.1 is not allowed, it must be at least the time before it, 0.2");
  EXPECT_EQ(table_error("0,1\n0.1,1\n0.1,0\n0.1,2\n0.2,2\n"),
            ":4:1: data: column 1: 0.1 is not allowed, it must be later than the two before it, "
            "which make a jump already");
  EXPECT_EQ(table_error("0.1,1\n0.1,0\n"),
            ":2:1: data: column 1: 0.1 is not allowed, it must be later than the first time");
}

TEST(TorqueTable, MissingFileIsAFileError) {
  try {
    read_torque_file("no/such/torque.csv");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "no/such/torque.csv: cannot be read, No such file or directory");
  }
  try {
    read_torque_file(ScratchFolder().string());
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be read as a table of a torque"),
              std::string::npos);
  }
}

// The file's name starts from the scene's folder, and what is written needs no file.
TEST(TorqueTable, StandsBesideTheScene) {
  const ScratchFolder folder;
  std::ofstream(folder / "torque.csv") << "0,0.5\n0.125,0\n";
  std::ofstream(folder / "scene.toml")
      << "[beam]\nlength = 0.3\nyoungs_modulus = 2e11\nsecond_moment = 2e-13\ndensity = 8500\n"
         "area = 1e-5\nmodes = 2\n[hub]\nradius = 0.02\ninertia = 1e-3\n"
         "torque = { kind = \"table\", file = \"torque.csv\" }\n";
  const Scene scene = read_scene(folder / "scene.toml");
  const auto& table = std::get<TorqueTable>(*scene.hub->torque);
  EXPECT_EQ(table.times, (std::vector<double>{0.0, 0.125}));
  EXPECT_EQ(table.values, (std::vector<double>{0.5, 0.0}));
  EXPECT_NE(write_scene(scene).find(
                "torque = { kind = \"table\", times = [0.0, 0.125], values = [0.5, 0.0] }\n"),
            std::string::npos);
}

TEST(TorqueTable, RulesAreTheSameForTablesMadeInCode) {
  EXPECT_FALSE(torque_fault({{0.0, 1.0, 1.0}, {1.0, 2.0, 0.0}}));
  const std::optional<TorqueFault> fault =
      torque_fault({{0.0, 1.0}, {1.0, std::numeric_limits<double>::infinity()}});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->entry, 1u);
  EXPECT_FALSE(fault->of_times);
  EXPECT_EQ(fault->sentence, "inf is not allowed, it must be a finite number");
}

}  // namespace
}  // namespace graze
