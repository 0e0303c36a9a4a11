// Files that differ from what the descriptions of the formats ask for, as programs and editors
// leave them: read, or refused with the reason.
#include <gtest/gtest.h>

#include <fstream>

#include "graze/base/errors.hpp"
#include "graze/fem/matrix_file.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

class MatrixDialects : public testing::Test {
 protected:
  Matrix read(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << text;
    return Matrix(read_matrix(file).matrix);
  }
  // What the error says behind the folder.
  std::string refusal(const std::string& name, const std::string& text) {
    try {
      read(name, text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / "").string().size());
    }
    return "";
  }

  ScratchFolder folder_;
};

// 3000 -1000 0; -1000 2000 -500; 0 -500 1500
Matrix dialect_chain() {
  return (Matrix(3, 3) << 3000, -1000, 0, -1000, 2000, -500, 0, -500, 1500).finished();
}

TEST_F(MatrixDialects, DmigIsPartedByTabs) {
  const std::string tabs =
      "DMIG\tKAAX\t0\t6\t2\t0\nDMIG\tKAAX\t1\t3\t\t1\t3\t3000.\n\t2\t3\t-1000.\t\n"
      "DMIG\tKAAX\t2\t3\t\t2\t3\t2000.000000\n\t3\t3\t-500.\t\t\nDMIG\tKAAX\t3\t3\t\t3\t3\t1500.\n";
  EXPECT_EQ(read("k.bdf", tabs), dialect_chain());
  EXPECT_EQ(read("k.bdf", "\xEF\xBB\xBF" + tabs), dialect_chain());
  EXPECT_EQ(read("k.bdf",
                 "DMIG\tKAAX\t0\t6\t2\t0\nDMIG*\tKAAX\t1\t3\n*\t1\t3\t3000.\n*\t2\t3\t-1000.\t\n"
                 "DMIG*\tKAAX\t2\t3\t\n*\t2\t3\t2000.\n*\t3\t3\t-500.\n"
                 "DMIG*\tKAAX\t3\t3\t\n*\t3\t3\t1500.\n"),
            dialect_chain());
  // Columns of blanks with a tab behind the last.
  EXPECT_EQ(read("k.bdf",
                 "DMIG    K              0       6       2       0\t\n"
                 "DMIG    K              1       3               1       3      4.\t\n"),
            (Matrix(1, 1) << 4.0).finished());
  EXPECT_EQ(
      refusal("k.bdf", "DMIG    KAAX\t0\t6\t2\t0\n"),
      "k.bdf:1: the field \"DMIG    KAAX\" has blanks or tabs within, fields must be separated in "
      "one way: by columns of blanks, by commas or by tabs");
}

TEST_F(MatrixDialects, ByteOrderMarksAndBlankLinesComeFirst) {
  const std::string entries = "1 1 3000\n2 1 -1000\n2 2 2000\n3 2 -500\n3 3 1500\n";
  const std::string market = "%%MatrixMarket matrix coordinate real symmetric\n3 3 5\n" + entries;
  for (const char* before : {"\n", "\r\n \t\r\n", "\xEF\xBB\xBF", "\xEF\xBB\xBF\n"}) {
    EXPECT_EQ(read("k.mtx", before + market), dialect_chain());
    EXPECT_EQ(read("k.mtx", before + entries), dialect_chain());
    EXPECT_EQ(read("k.sti", before + entries), dialect_chain());
  }
  for (const char* before : {"\xFF\xFE", "\xFE\xFF"})
    EXPECT_EQ(refusal("k.mtx", before + entries),
              "k.mtx: the text is UTF-16, it must be UTF-8 or ASCII");
}

TEST_F(MatrixDialects, MatrixMarketWithoutItsFirstLineIsRefusedWithTheReason) {
  const std::string entries = "1 1 3000\n2 1 -1000\n2 2 2000\n3 2 -500\n3 3 1500\n";
  EXPECT_EQ(refusal("k.mtx", "3 3 5\n" + entries),
            "k.mtx:1: the line tells 3 rows, 3 columns and 5 entries, as in a Matrix Market file, "
            "whose first line is missing: %%MatrixMarket matrix coordinate real symmetric (or "
            "general)");
  EXPECT_EQ(refusal("k.mtx", "\n% made by hand\n3 3 5\n" + entries),
            "k.mtx:2: the line is a comment of a Matrix Market file, whose first line is missing: "
            "%%MatrixMarket matrix coordinate real symmetric (or general)");
  // An entry that is as large as the lines below it are many, but not of the last row.
  EXPECT_EQ(read("k.mtx", "1 1 1\n2 2 7\n"), (Matrix(2, 2) << 1, 0, 0, 7).finished());
  EXPECT_EQ(read("k.mtx", "2 2 7\n1 1 1\n"), (Matrix(2, 2) << 1, 0, 0, 7).finished());
}

}  // namespace
}  // namespace graze
