#include "graze/record/stored/record_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "graze/base/errors.hpp"
#include "graze/record/file/checksum.hpp"
#include "graze/record/file/detail/members.hpp"
#include "graze/record/file/files.hpp"
#include "graze/record/stored/detail/record_fields.hpp"
#include "graze/record/stored/record_file.hpp"
#include "support/scratch_folder.hpp"

namespace graze {

inline const char* const kScene =
    "[modal]\nfrequencies = [1.0]\n[[stop]]\nshape = [1.0]\ngap = 0.1\nrestitution = 0.8\n";

// Not in a namespace without a name, or the fields of lists would not be found. Comes to all
// members of a value as a reader does, and puts there whatever it likes.
class Anything {
 public:
  static constexpr bool kReads = true;

  explicit Anything(unsigned seed) : random_(seed) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_same_v<T, Scene>) {
      value = parse_scene(kScene, "scene");
    } else if constexpr (std::is_same_v<T, Matrix>) {
      value = Matrix::Constant(below(3), below(3), real());
    } else if constexpr (std::is_same_v<T, bool>) {
      value = below(2) == 1;
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(below(2));
    } else if constexpr (std::is_integral_v<T>) {
      value = static_cast<T>(below(4));
    } else if constexpr (std::is_same_v<T, double>) {
      value = real();
    } else if constexpr (std::is_same_v<T, std::string>) {
      value.clear();
      while (has_more()) value += static_cast<char>(below(128));
    } else {
      visit_value(*this, value);
    }
  }
  bool has_more() { return below(5) > 1; }

 private:
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  double real() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double odd[] = {0.0, -0.0, kInfinity, -kInfinity, 5e-324, std::nan("")};
    if (below(4) == 0) return odd[below(6)];
    return std::ldexp(std::uniform_real_distribution<double>(-1.0, 1.0)(random_), below(80) - 40);
  }

  std::mt19937 random_;
};

namespace {

struct Inner {
  int whole = 0;
  State state;
};
struct Several {
  std::optional<double> maybe;
  Inner inner;
  Vector vector;
  std::array<int, 3> three{};
  std::string word;
  std::vector<Inner> list{};
  bool flag = true;
};

static_assert(member_count<State>() == 2);
static_assert(member_count<Inner>() == 2);
static_assert(member_count<Several>() == 7);

TEST(Members, ComeInTheirOrder) {
  Several several;
  with_members(several, [&](auto& maybe, auto& inner, auto& vector, auto& three, auto& word,
                            auto& list, auto& flag) {
    EXPECT_EQ(&maybe, &several.maybe);
    EXPECT_EQ(&inner, &several.inner);
    EXPECT_EQ(&vector, &several.vector);
    EXPECT_EQ(&three, &several.three);
    EXPECT_EQ(&word, &several.word);
    EXPECT_EQ(&list, &several.list);
    EXPECT_EQ(&flag, &several.flag);
  });
}

// The check value of CRC-32 in the catalogues, and of a text in pieces.
TEST(FileChecksum, IsCrc32) {
  EXPECT_EQ(checksum("123456789"), "cbf43926");
  Checksum sum;
  for (const char* piece : {"12345", "", "6789"}) sum.add(piece);
  EXPECT_EQ(sum.text(), "cbf43926");
}

TEST(ValueText, HoldsEveryDouble) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {0.0, -0.0, 0.1, 1.0 / 3.0, 5e-324, -1.7976931348623157e308, 1e22,
                             123456789012345680.0, kInfinity, -kInfinity, nan, -nan}) {
    double back = 7.0;
    ASSERT_TRUE(read_value(value_text(value), back)) << value_text(value);
    EXPECT_EQ(std::isnan(back), std::isnan(value));
    EXPECT_EQ(std::signbit(back), std::signbit(value));
    EXPECT_TRUE(std::isnan(value) || back == value) << value;
  }
  double untouched = 7.0;
  for (const char* text : {"", "[1]", "1,", "1 ", " 1", "0x1", "1e999", "\"in\"", "nan", "true"})
    EXPECT_FALSE(read_value(text, untouched)) << text;
}

TEST(ValueText, RefusesWhatItDidNotWrite) {
  const std::string text = value_text(Several{1.5, {3, {}}, Vector::Ones(2), {}, "a\n\"b\\", {{}}});
  Several back;
  ASSERT_TRUE(read_value(text, back));
  EXPECT_EQ(back.word, "a\n\"b\\");
  for (std::size_t size = 0; size < text.size(); ++size)
    EXPECT_FALSE(read_value(text.substr(0, size), back)) << size;
  EXPECT_FALSE(read_value(text + "]", back));
  EXPECT_FALSE(read_value("[[],[1,[[],[]]],[],[1,2],\"\",[],true]", back));       // two of three
  EXPECT_FALSE(read_value("[[],[1,[[],[]]],[],[1,2,3,4],\"\",[],true]", back));   // four of them
  EXPECT_FALSE(read_value("[[1,2],[1,[[],[]]],[],[1,2,3],\"\",[],true]", back));  // twice maybe
  EXPECT_FALSE(read_value("[[],[1.5,[[],[]]],[],[1,2,3],\"\",[],true]", back));   // no whole number
  EXPECT_FALSE(read_value("[[],[1,[[],[]]],[],[1,2,3],\"\\u00ff\",[],true]", back));
  Matrix matrix;
  EXPECT_TRUE(read_value("[2,1,[0.5,1]]", matrix));
  EXPECT_FALSE(read_value("[2,2,[0.5,1]]", matrix));
  EXPECT_FALSE(read_value("[-2,-1,[0.5,1]]", matrix));
}

template <class Record>
class RecordText : public testing::Test {};
using Records = testing::Types<CheckRecord, SimulationRecord, OrbitRecord, BranchRecord, LociRecord,
                               DiagramRecord, RunDiagramRecord, MapRecord, ComparisonRecord,
                               ComparisonMapRecord, SensitivityRecord, CostRecord, FitRecord>;
TYPED_TEST_SUITE(RecordText, Records);

TYPED_TEST(RecordText, ReadsBackToTheLastBit) {
  std::set<std::string> texts;
  for (unsigned seed = 0; seed < 30; ++seed) {
    TypeParam record{}, back{};
    Anything anything(seed);
    anything(record);
    const std::string text = record_text(record);
    ASSERT_TRUE(read_record_text(text, back)) << text;
    EXPECT_EQ(record_text(back), text);
    texts.insert(text);
    EXPECT_FALSE(read_record_text(text.substr(0, text.size() / 2), back));
  }
  EXPECT_EQ(texts.size(), 30u);
}

// As it stands in a folder, with what follows from the scene filled in.
TEST(RecordFile, HoldsTheResultOfAFolder) {
  const ScratchFolder scratch;
  const Scene scene = parse_scene(kScene, "scene");
  OrbitRecord record;
  record.info = run_info("orbit", "my.toml", scene);
  record.outcome = {"found", ""};
  record.found.tried = "by hand";
  const std::string document = "{}\n";
  write_file(scratch / kSceneFile, record.info.scene_text);
  write_file(scratch / kDocumentFile, document);
  write_file(scratch / kRecordFile, record_file_text(record.info, record_kind<OrbitRecord>(),
                                                     record_text(record), checksum(document)));
  for (const auto& place : {scratch / "", scratch / kDocumentFile}) {
    const StoredResult result = read_result(place);
    const auto& back = std::get<OrbitRecord>(result.record);
    EXPECT_EQ(record_text(back), record_text(record));
    EXPECT_EQ(back.info.scene_text, record.info.scene_text);
    ASSERT_EQ(back.system.omega.size(), 1);
    EXPECT_EQ(back.system.omega[0], 1.0);
    EXPECT_EQ(back.system.stops.at(0).gap, 0.1);
    std::string read;
    result.read_document([&](std::string_view piece) { read += piece; });
    EXPECT_EQ(read, document);
  }
  // Of a kind that this program does not have.
  write_file(scratch / kRecordFile,
             record_file_text(record.info, 99, record_text(record), checksum(document)));
  EXPECT_THROW(read_result(scratch / ""), FileError);
}

}  // namespace
}  // namespace graze
