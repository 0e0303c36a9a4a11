// What the reader of matrices finds in archives (libzip, which checks records and sums).
#include "graze/record/file/numpy_archive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"
#include "graze/fem/detail/numpy_array.hpp"

namespace graze {
namespace {

double entry(std::size_t row, std::size_t column) {
  return std::sqrt(static_cast<double>(row)) - 1e6 * static_cast<double>(column);
}

PendingFile archive_of(const std::filesystem::path& file, const std::vector<std::string>& columns,
                       std::size_t rows) {
  NumpyArchive archive(file, columns);
  for (std::size_t i = 0; i < rows; ++i) {
    double* const row = archive.add();
    for (std::size_t j = 0; j < columns.size(); ++j) row[j] = entry(i, j);
  }
  return archive.finished();
}

std::vector<std::string> numbered(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t j = 1; j <= count; ++j) names.push_back("column" + std::to_string(j));
  return names;
}

TEST(NumpyArchive, HoldsEveryColumnAsAnArray) {
  const ScratchFolder scratch;
  struct Table {
    std::size_t columns, rows;
  };
  // None and few rows; at and behind the ends of blocks of 2^20 numbers, many columns.
  for (const Table& table : {Table{1, 0}, Table{3, 1}, Table{18, 501}, Table{1, 1 << 20},
                             Table{1, (1 << 20) + 1}, Table{7, 400'000}, Table{3000, 800}}) {
    const std::vector<std::string> names = numbered(table.columns);
    archive_of(scratch / "table.npz", names, table.rows).commit();
    const auto members = zip_members(scratch / "table.npz");
    ASSERT_EQ(members.size(), table.columns);
    for (std::size_t j = 0; j < table.columns; ++j) {
      const NumpyArray array = numpy_array(names[j], members.at(names[j] + ".npy"));
      ASSERT_EQ(array.shape, std::vector<long>{static_cast<long>(table.rows)});
      ASSERT_EQ(array.values.size(), table.rows);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < table.rows; ++i) wrong += array.values[i] != entry(i, j) ? 1 : 0;
      EXPECT_EQ(wrong, 0U) << table.columns << " columns, " << table.rows << " rows";
    }
  }
}

TEST(NumpyArchive, KeepsWhatIsNoNumber) {
  const ScratchFolder scratch;
  NumpyArchive archive(scratch / "table.npz", {"a"});
  *archive.add() = NAN;
  *archive.add() = -0.0;
  *archive.add() = 5e-324;
  archive.finished().commit();
  const NumpyArray array = numpy_array("a", zip_members(scratch / "table.npz").at("a.npy"));
  EXPECT_TRUE(std::isnan(array.values[0]));
  EXPECT_TRUE(std::signbit(array.values[1]));
  EXPECT_EQ(array.values[2], 5e-324);
}

// The offsets and sizes, as APPNOTE.TXT has them and NumPy's header must be aligned.
TEST(NumpyArchive, HasTheNumbersAtAMultipleOf64BytesOfTheirArray) {
  const ScratchFolder scratch;
  for (const std::size_t rows : {0, 9, 10, 99'999, 100'000}) {
    archive_of(scratch / "table.npz", {"a"}, rows).commit();
    EXPECT_EQ((zip_members(scratch / "table.npz").at("a.npy").size() - 8 * rows) % 64, 0U);
  }
}

TEST(NumpyArchive, LeavesNothingUntilItIsCommitted) {
  const ScratchFolder scratch;
  write_file(scratch / "table.npz", "old");
  {
    NumpyArchive archive(scratch / "table.npz", {"a"});
    for (int i = 0; i < 2'000'000; ++i) *archive.add() = i;
  }
  EXPECT_EQ(names_in(scratch.string()), std::vector<std::string>{"table.npz"});
  { const PendingFile dropped = archive_of(scratch / "table.npz", {"a", "b"}, 1'000'000); }
  EXPECT_EQ(names_in(scratch.string()), std::vector<std::string>{"table.npz"});
  EXPECT_EQ(read_text(scratch / "table.npz"), "old");
  EXPECT_THROW(NumpyArchive(scratch / "missing" / "table.npz", {"a"}), FileError);
}

}  // namespace
}  // namespace graze
