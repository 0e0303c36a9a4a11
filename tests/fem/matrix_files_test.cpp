// Matrices as the programs write them, by hand from the descriptions of the formats; and what is
// wrong with a file, told with its line.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>

#include "graze/base/errors.hpp"
#include "graze/fem/matrix_file.hpp"
#include "graze/fem/structural_matrices.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

class MatrixFiles : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  LabelledMatrix read(const std::string& name, const std::string& text) {
    return read_matrix(write(name, text));
  }
  // What the error says behind the folder.
  std::string refusal(const std::string& name, const std::string& text) {
    try {
      read(name, text);
    } catch (const InputError& error) {
      const std::string said = error.what(), start = (folder_ / "").string();
      EXPECT_EQ(said.substr(0, start.size()), start);
      return said.substr(start.size());
    }
    return "";
  }

  ScratchFolder folder_;
};

// 2 -1 0; -1 2 -1; 0 -1 1.5
Matrix written_chain() {
  Matrix k = Matrix::Zero(3, 3);
  k << 2, -1, 0, -1, 2, -1, 0, -1, 1.5;
  return k;
}

TEST_F(MatrixFiles, MatrixMarketInAllItsForms) {
  const std::string entries = "1 1 2\n2 1 -1.0\n2 2 2e0\n3 2 -1\n3 3 15d-1\n";
  EXPECT_EQ(
      Matrix(read("a.mtx",
                  "%%MatrixMarket matrix coordinate real symmetric\n% said\n\n3 3 5\n" + entries)
                 .matrix),
      written_chain());
  EXPECT_EQ(Matrix(read("b.mtx", "%%matrixmarket MATRIX Coordinate Real General\n3 3 7\n" +
                                     entries + "1 2 -1\n2 3 -1\n")
                       .matrix),
            written_chain());
  EXPECT_EQ(Matrix(read("c.mtx",
                        "%%MatrixMarket matrix array real symmetric\n3 3\n2\n-1\n0\n2\n-1\n1.5\n")
                       .matrix),
            written_chain());
  EXPECT_EQ(
      Matrix(
          read("d.mtx", "%%MatrixMarket matrix array integer general\n2 2\n4\n1\n1\n3\n").matrix),
      (Matrix(2, 2) << 4, 1, 1, 3).finished());
}

TEST_F(MatrixFiles, MatrixMarketIsRefusedWithItsLine) {
  const std::string head = "%%MatrixMarket matrix coordinate real symmetric\n";
  EXPECT_EQ(refusal("a.mtx", "%%MatrixMarket matrix coordinate pattern symmetric\n2 2 1\n1 1\n"),
            "a.mtx:1: a matrix of the field \"pattern\" has no real numbers, it must be real or "
            "integer");
  EXPECT_EQ(
      refusal("a.mtx", "%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 1 1\n"),
      "a.mtx:1: the symmetry \"skew-symmetric\" is not allowed, it must be general or "
      "symmetric");
  EXPECT_EQ(refusal("a.mtx", head + "2 3 1\n1 1 1\n"),
            "a.mtx:2: the matrix is 2 x 3, it must be square");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 2\n1 1 1\n3 1 1\n"),
            "a.mtx:4: the row 3 is not allowed, it must be from 1 to 2");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 2\n1 1 1\n2 1 nan\n"),
            "a.mtx:4: the number nan is not allowed, it must be finite");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 2\n1 1 1\n2 2 1.x\n"),
            "a.mtx:4: \"1.x\" is not allowed, it must be a number");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 3\n1 1 1\n2 2 1\n"),
            "a.mtx:4: the file ends after 2 of its 3 entries");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 1\n1 1 1\n2 2 1\n"),
            "a.mtx:4: the file goes on after the last of its entries");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 3\n1 1 1\n2 1 1\n2 1 4\n"),
            "a.mtx:5: the entry (2, 1) stands twice, first in line 4");
  EXPECT_EQ(refusal("a.mtx", head + "2 2 3\n1 1 1\n2 1 1\n1 2 1\n"),
            "a.mtx:4: the entry (2, 1) and its mirror image are both listed, of a symmetric matrix "
            "only one of them must be");
  EXPECT_EQ(refusal("a.mtx",
                    "%%MatrixMarket matrix coordinate real general\n2 2 4\n1 1 4\n2 2 1\n"
                    "1 2 1\n2 1 1.5\n"),
            "a.mtx:5: the matrix is not symmetric: the entry (1, 2) is 1 and the entry (2, 1) is "
            "1.5; their difference is 0.25 of its scale, allowed is 1e-08");
}

// Of what turns the damping is not symmetric.
TEST_F(MatrixFiles, DampingNeedNotBeSymmetric) {
  const auto file = write("c.mtx",
                          "%%MatrixMarket matrix coordinate real general\n2 2 3\n1 1 0.5\n"
                          "1 2 -6\n2 1 6\n");
  EXPECT_THROW(read_matrix(file), InputError);
  const Matrix read = read_general_matrix(file).matrix;
  EXPECT_EQ(read, (Matrix(2, 2) << 0.5, -6.0, 6.0, 0.0).finished());
  const auto unit = write("m.mtx",
                          "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n"
                          "1 1 1\n2 2 1\n");
  const StructuralMatrices whole = read_structure({unit, unit, file, {}, {}});
  EXPECT_EQ(Matrix(*whole.damping), read);
  EXPECT_THROW(read_structure({file, unit, {}, {}, {}}), InputError);
}

// One triangle by an order of nodes of the program's own: here node 7 comes before node 3.
TEST_F(MatrixFiles, AbaqusNamesItsRows) {
  const LabelledMatrix read_one =
      read("k.mtx",
           "** made by hand\n*MATRIX INPUT, TYPE=SYMMETRIC\n7,1, 7,1, 2.\n"
           "3,1, 7,1, -1.\n3,1, 3,1, 2.\n3,6,3,1,-1.0e+00\n3,6,3,6, 1.5\n");
  ASSERT_EQ(read_one.labels, (std::vector<DofLabel>{{3, 1}, {3, 6}, {7, 1}}));
  EXPECT_TRUE(read_one.has_names);
  Matrix wanted(3, 3);
  wanted << 2, -1, -1, -1, 1.5, 0, -1, 0, 2;
  EXPECT_EQ(Matrix(read_one.matrix), wanted);
  const LabelledMatrix held = read("k.mtx", "1,1, 1,1, 1.e36\n1,1, 2,1, -1.\n2,1, 2,1, 2.\n");
  EXPECT_EQ(held.held, (std::vector<DofLabel>{{1, 1}}));
  const LabelledMatrix listed =
      read("k.mtx", " 1 1 2.0\n 2 1 -1.0\n 2 2 2.0\n 3 2 -1.0\n 3 3 1.5\n 1 2 -1.0\n 2 3 -1.0\n");
  EXPECT_EQ(Matrix(listed.matrix), written_chain());
  EXPECT_FALSE(listed.has_names);
}

TEST_F(MatrixFiles, AbaqusIsRefusedWithItsLine) {
  EXPECT_EQ(refusal("k.mtx", "** only comments\n"), "k.mtx: the matrix has no entries");
  EXPECT_EQ(refusal("k.mtx", "1,1,1,1,2.\n1,1,2\n"),
            "k.mtx:2: the line has 3 entries, the lines before have 5");
  EXPECT_EQ(refusal("k.mtx", "1,1,1,2.\n"),
            "k.mtx:1: the line has 4 entries, it must have five (row node, row dof, column node, "
            "column dof, value) or three (row, column, value)");
  EXPECT_EQ(refusal("k.mtx", "1,1,1.5,1,2.\n"),
            "k.mtx:1: \"1.5\" is not allowed, it must be an integer");
  EXPECT_EQ(refusal("k.mtx", "1,1,1,1,2.\n2,1,2,1,4.\n1,1,2,1,-1.\n2,1,1,1,-2.\n"),
            "k.mtx:3: the matrix is not symmetric: the entry (1.1, 2.1) is -1 and the entry (2.1, "
            "1.1) is -2; their difference is 0.35 of its scale, allowed is 1e-08");
}

TEST_F(MatrixFiles, CalculixWithItsNames) {
  const auto mass = write("m.mas", "1 1 1.\n2 2 1.\n3 3 1.\n");
  const auto stiffness =
      write("m.sti", "  1  1  2.0D0\n  1  2  -1.\n  2  2  2.\n  2  3  -1.\n  3  3  1.5\n");
  const auto names = write("m.dof", "4.1\n4.2\n9.1\n");
  const StructuralMatrices structure = read_structure({mass, stiffness, {}, names});
  EXPECT_EQ(Matrix(structure.stiffness), written_chain());
  EXPECT_EQ(structure.labels, (std::vector<DofLabel>{{4, 1}, {4, 2}, {9, 1}}));
  const StructuralMatrices held = read_structure({mass, stiffness, {}, names}, {{4, 2}});
  EXPECT_EQ(Matrix(held.stiffness), (Matrix(2, 2) << 2, 0, 0, 1.5).finished());
  EXPECT_EQ(refusal("m.sti", "1 1 2\n0 1 2\n"),
            "m.sti:2: the row or column 0 is not allowed, it must be from 1 to 20000000");
}

std::string npy(const std::string& type, const std::string& shape, bool fortran,
                const std::string& bytes, int version = 1) {
  std::string header = "{'descr': '" + type +
                       "', 'fortran_order': " + (fortran ? "True" : "False") +
                       ", 'shape': " + shape + ", }";
  header.append(64 - (header.size() + 1 + (version == 1 ? 10 : 12)) % 64, ' ');
  header += '\n';
  std::string text = std::string("\x93NUMPY") + static_cast<char>(version) + '\0';
  const int width = version == 1 ? 2 : 4;
  for (int i = 0; i < width; ++i) text += static_cast<char>(header.size() >> (8 * i) & 0xff);
  return text + header + bytes;
}

template <class Number>
std::string packed(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

TEST_F(MatrixFiles, NumpyInItsTypesAndOrders) {
  const std::vector<double> values{4, 1, 1, 3};
  const Matrix wanted = (Matrix(2, 2) << 4, 1, 1, 3).finished();
  EXPECT_EQ(Matrix(read("a.npy", npy("<f8", "(2, 2)", false, packed(values))).matrix), wanted);
  EXPECT_EQ(Matrix(read("a.npy", npy("<f8", "(2, 2)", true, packed(values), 2)).matrix), wanted);
  EXPECT_EQ(Matrix(read("a.npy", npy("<f4", "(2, 2)", false, packed<float>({4, 1, 1, 3}))).matrix),
            wanted);
  EXPECT_EQ(
      Matrix(read("a.npy", npy("<i8", "(2, 2)", false, packed<std::int64_t>({4, 1, 1, 3}))).matrix),
      wanted);
  EXPECT_EQ(
      Matrix(read("a.npy", npy("<i4", "(2, 2)", false, packed<std::int32_t>({4, 1, 1, 3}))).matrix),
      wanted);
}

TEST_F(MatrixFiles, NumpyIsRefusedWhereItIsNoMatrix) {
  EXPECT_EQ(refusal("a.npy", "no array at all"),
            "a.npy: it is no .npy file, its first bytes must be \\x93NUMPY");
  EXPECT_EQ(refusal("a.npy", npy("<f8", "(2, 2)", false, packed<double>({1, 2}))),
            "a.npy: the array of shape (2, 2) has 16 bytes, which does not fit");
  EXPECT_EQ(refusal("a.npy", npy("<c8", "(1, 1)", false, packed<double>({1}))),
            "a.npy: values of the type '<c8' are not allowed, they must be real numbers: '<f8', "
            "'<f4', '<i8' or '<i4'");
  EXPECT_EQ(refusal("a.npy", npy("<f8", "(2,)", false, packed<double>({1, 2}))),
            "a.npy: the array has 1 dimension, it must be a square matrix");
  EXPECT_EQ(refusal("a.npy", npy("<f8", "(1, 1)", false,
                                 packed<double>({std::numeric_limits<double>::infinity()}))),
            "a.npy: the entry (1, 1) is inf, it must be finite");
  EXPECT_EQ(refusal("a.npy", npy("<f8", "(99999999999, 99999999999)", false, "")),
            "a.npy: the array of shape (99999999999, 99999999999) has 0 bytes, which does not fit");
}

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

// written_chain() as scipy.sparse.save_npz writes it (scipy 1.10.1, numpy 1.24.2): csr, with
// deflated members.
const char* const kSaved =
    "504b03042d000000080000002100eb7c4e85ffffffffffffffff0b001400696e64696365732e6e707901001000"
    "9c000000000000004f000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e9369a2aea3a09e"
    "965f54529498179f5f94920a12774bcc294e058a17672416a402f91ae63a9a3a0ab50a14002e06206064800010"
    "cd84440300504b03042d00000008000000210040382726ffffffffffffffff0a001400696e647074722e6e7079"
    "0100100090000000000000004e000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e9369a2"
    "aea3a09e965f54529498179f5f94920a12774bcc294e058a17672416a402f91a263a9a3a0ab50a14002e062060"
    "0262562066076200504b03042d000000080000002100a3c37497ffffffffffffffff0a001400666f726d61742e"
    "6e707901001000830000000000000045000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a05e"
    "136cacaea3a09e965f54529498179f5f94920a12774bcc294e058a17672416a402f91a9a3a0ab50a1401aee4e2"
    "2200504b03042d000000080000002100f1d916a2ffffffffffffffff0900140073686170652e6e707901001000"
    "900000000000000049000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e9369a1aea3a09e"
    "965f54529498179f5f94920a12774bcc294e058a17672416a402f91a463a9a3a0ab50a14002e66060880d10050"
    "4b03042d000000080000002100a35966f8ffffffffffffffff08001400646174612e6e707901001000b8000000"
    "0000000052000000000000009bec17ea1b10c9c850c650ad9e925a9c5ca46ea5a06e9366a1aea3a09e965f5452"
    "9498179f5f94920a12774bcc294e058a17672416a402f91ae63a9a3a0ab50a14002e06087080501ff6a3d2b8c4"
    "7fd80300504b01022d032d000000080000002100eb7c4e854f0000009c0000000b000000000000000000000080"
    "0100000000696e64696365732e6e7079504b01022d032d000000080000002100403827264e000000900000000a"
    "000000000000000000000080018c000000696e647074722e6e7079504b01022d032d000000080000002100a3c3"
    "749745000000830000000a0000000000000000000000800116010000666f726d61742e6e7079504b01022d032d"
    "000000080000002100f1d916a2490000009000000009000000000000000000000080019701000073686170652e"
    "6e7079504b01022d032d000000080000002100a35966f852000000b80000000800000000000000000000008001"
    "1b020000646174612e6e7079504b0506000000000500050016010000a70200000000";
// The same uncompressed, as coo: scipy.sparse.save_npz(file, matrix, compressed=False).
const char* const kCoordinates =
    "504b03042d00000000000000210099f71d98ffffffffffffffff07001400726f772e6e7079010010009c000000"
    "000000009c00000000000000934e554d5059010076007b276465736372273a20273c6934272c2027666f727472"
    "616e5f6f72646572273a2046616c73652c20277368617065273a2028372c292c207d2020202020202020202020"
    "202020202020202020202020202020202020202020202020202020202020202020202020202020202020202020"
    "202020200a00000000000000000100000001000000010000000200000002000000504b03042d00000000000000"
    "2100eb7c4e85ffffffffffffffff07001400636f6c2e6e7079010010009c000000000000009c00000000000000"
    "934e554d5059010076007b276465736372273a20273c6934272c2027666f727472616e5f6f72646572273a2046"
    "616c73652c20277368617065273a2028372c292c207d2020202020202020202020202020202020202020202020"
    "202020202020202020202020202020202020202020202020202020202020202020202020200a00000000010000"
    "000000000001000000020000000100000002000000504b03042d00000000000000210027f20512ffffffffffff"
    "ffff0a001400666f726d61742e6e70790100100083000000000000008300000000000000934e554d5059010076"
    "007b276465736372273a20277c5333272c2027666f727472616e5f6f72646572273a2046616c73652c20277368"
    "617065273a2028292c207d20202020202020202020202020202020202020202020202020202020202020202020"
    "202020202020202020202020202020202020202020202020202020200a636f6f504b03042d0000000000000021"
    "00f1d916a2ffffffffffffffff0900140073686170652e6e707901001000900000000000000090000000000000"
    "00934e554d5059010076007b276465736372273a20273c6938272c2027666f727472616e5f6f72646572273a20"
    "46616c73652c20277368617065273a2028322c292c207d20202020202020202020202020202020202020202020"
    "20202020202020202020202020202020202020202020202020202020202020202020202020200a030000000000"
    "00000300000000000000504b03042d000000000000002100a35966f8ffffffffffffffff08001400646174612e"
    "6e707901001000b800000000000000b800000000000000934e554d5059010076007b276465736372273a20273c"
    "6638272c2027666f727472616e5f6f72646572273a2046616c73652c20277368617065273a2028372c292c207d"
    "202020202020202020202020202020202020202020202020202020202020202020202020202020202020202020"
    "2020202020202020202020202020200a0000000000000040000000000000f0bf000000000000f0bf0000000000"
    "000040000000000000f0bf000000000000f0bf000000000000f83f504b01022d032d00000000000000210099f7"
    "1d989c0000009c000000070000000000000000000000800100000000726f772e6e7079504b01022d032d000000"
    "000000002100eb7c4e859c0000009c0000000700000000000000000000008001d5000000636f6c2e6e7079504b"
    "01022d032d00000000000000210027f2051283000000830000000a00000000000000000000008001aa01000066"
    "6f726d61742e6e7079504b01022d032d000000000000002100f1d916a290000000900000000900000000000000"
    "0000000080016902000073686170652e6e7079504b01022d032d000000000000002100a35966f8b8000000b800"
    "0000080000000000000000000000800134030000646174612e6e7079504b050600000000050005000f01000026"
    "0400000000";
// [[2, -1], [-1, 1.5]] of numpy.savez(file, k=..).
const char* const kDense =
    "504b03042d000000000000002100707d2c08ffffffffffffffff050014006b2e6e707901001000a00000000000"
    "0000a000000000000000934e554d5059010076007b276465736372273a20273c6638272c2027666f727472616e"
    "5f6f72646572273a2046616c73652c20277368617065273a2028322c2032292c207d2020202020202020202020"
    "202020202020202020202020202020202020202020202020202020202020202020202020202020202020202020"
    "20200a0000000000000040000000000000f0bf000000000000f0bf000000000000f83f504b01022d032d000000"
    "000000002100707d2c08a0000000a00000000500000000000000000000008001000000006b2e6e7079504b0506"
    "000000000100010033000000d70000000000";

TEST_F(MatrixFiles, ArchivesOfNumpyAndScipy) {
  EXPECT_EQ(Matrix(read("a.npz", from_hex(kSaved)).matrix), written_chain());
  EXPECT_EQ(Matrix(read("b.npz", from_hex(kCoordinates)).matrix), written_chain());
  EXPECT_EQ(Matrix(read("c.npz", from_hex(kDense)).matrix),
            (Matrix(2, 2) << 2, -1, -1, 1.5).finished());
  EXPECT_EQ(refusal("d.npz", "no archive").substr(0, 27), "d.npz: it is no .npz archiv");
  const std::string whole = from_hex(kSaved);
  EXPECT_NE(refusal("e.npz", whole.substr(0, whole.size() / 2)), "");
}

TEST_F(MatrixFiles, NastranInItsThreeFields) {
  const std::string free =
      "$ by hand\nDMIG,KAAX,0,6,2,0,,,3\nDMIG,KAAX,1,1,,1,1,2.0,,+\n+,2,1,-1.\n"
      "DMIG,KAAX,2,1,,2,1,2.,,,2,3,-1.\n";
  const std::string rest = "DMIG,KAAX,2,3,,2,3,1.5\nENDDATA\n";
  const LabelledMatrix by_commas = read("k.bdf", free.substr(0, free.size()) + rest);
  EXPECT_EQ(by_commas.labels, (std::vector<DofLabel>{{1, 1}, {2, 1}, {2, 3}}));
  Matrix wanted(3, 3);
  wanted << 2, -1, 0, -1, 2, 0, 0, 0, 1.5;
  wanted(1, 2) = wanted(2, 1) = 0.0;
  const std::string small =
      "DMIG    KAAX    0       6       1       0                       3\n"
      "DMIG    KAAX    1       1               1       1       2.0\n"
      "        2       1       -1.\n"
      "DMIG    KAAX    2       1               2       1       2.\n"
      "DMIG    KAAX    2       3               2       3       15.-1\n";
  EXPECT_EQ(Matrix(read("k.bdf", small).matrix), wanted);
  const std::string large =
      "DMIG    KAAX    0       1       2       0                       3\n"
      "DMIG*   KAAX                           1               1\n"
      "*                      1               1            2.D0\n"
      "*                      2               1           -1.D0\n"
      "DMIG*   KAAX                           2               1\n"
      "*                      1               1           -1.D0\n"
      "*                      2               1            2.D0\n"
      "DMIG*   KAAX                           2               3\n"
      "*                      2               3          1.5D+0\n";
  EXPECT_EQ(Matrix(read("k.pch", large).matrix), wanted);
}

TEST_F(MatrixFiles, NastranNamesOneOfSeveral) {
  const std::string two =
      "DMIG,KAAX,0,6,2,0,,,1\nDMIG,KAAX,1,1,,1,1,2.0\nDMIG,MAAX,0,6,2,0,,,1\nDMIG,MAAX,1,1,,1,1,3."
      "\n";
  write("two.pch", two);
  EXPECT_EQ(read_matrix(folder_ / "two.pch#MAAX").matrix.coeff(0, 0), 3.0);
  const std::string name = (folder_ / "two.pch").string();
  EXPECT_EQ(refusal("two.pch", two),
            "two.pch: the file has the matrices KAAX, MAAX, one of them must be named like \"" +
                name + "#KAAX\"");
  EXPECT_EQ(refusal("k.bdf", "DMIG,KAAX,0,6,3,0,,,1\n"),
            "k.bdf:1: the matrix KAAX has the type 3, it must be 1 or 2 (real)");
  EXPECT_EQ(refusal("k.bdf", "DMIG,KAAX,0,2,1,0,,,1\n"),
            "k.bdf:1: the matrix KAAX has the form 2, it must be 1 (square) or 6 (symmetric)");
  EXPECT_EQ(refusal("k.bdf", "DMIG,KAAX,1,1,,1,1,2.0\n"),
            "k.bdf:1: the matrix KAAX has no header, DMIG, KAAX, 0, ..");
  EXPECT_EQ(refusal("k.bdf", "DMIG,KAAX,0,6,2,0,,,1\nDMIG,KAAX,1,1,,1,1,2.x\n"),
            "k.bdf:2: \"2.x\" is not allowed, it must be a finite number");
}

TEST_F(MatrixFiles, WhatDoesNotFitTogetherIsRefused) {
  const auto said = [&](const std::filesystem::path& mass, const std::filesystem::path& stiffness,
                        const std::vector<DofLabel>& held = {}) {
    try {
      read_structure({mass, stiffness, {}, {}}, held);
    } catch (const InputError& error) {
      const std::string text = error.what();
      return text.substr(
          text.rfind((folder_ / "").string(), 0) == 0 ? (folder_ / "").string().size() : 0);
    }
    return std::string();
  };
  const auto k = write("k.mtx", "1,1,1,1,2.\n2,1,2,1,2.\n"), m = write("m.mtx", "1,1,1,1,1.\n");
  // One without mass follows the others statically, one without stiffness has to have mass.
  EXPECT_EQ(said(m, k), "");
  EXPECT_EQ(said(k, m), "");
  const auto twin = write("t.mtx", "1,1,1,1,2.\n2,1,2,1,0.\n");
  EXPECT_EQ(said(m, twin),
            "t.mtx: 1 degree of freedom has neither stiffness nor mass: 2.1. Hold what nothing "
            "moves (constraints)");
  EXPECT_EQ(said(m, k, {{3, 1}}), "k.mtx: the matrix has no degree of freedom 3.1 to be held");
  const std::string head = "%%MatrixMarket matrix coordinate real symmetric\n";
  const auto small = write("s.mtx", head + "2 2 2\n1 1 1\n2 2 1\n"),
             large = write("l.mtx", head + "3 3 3\n1 1 1\n2 2 1\n3 3 1\n");
  EXPECT_EQ(said(small, large),
            "s.mtx: the matrix has 2 rows, the stiffness of " + large.string() + " has 3");
  EXPECT_THROW(read_matrix(folder_ / "absent.mtx"), FileError);
  EXPECT_EQ(refusal("k.xyz", "1"),
            "k.xyz: \".xyz\" is no format of matrices, it must be .mtx (Matrix Market, Abaqus), "
            ".sti, .mas or .dam (CalculiX), .npy or .npz (NumPy), .bdf, .dat, .nas or .pch "
            "(Nastran)");
}

}  // namespace
}  // namespace graze
