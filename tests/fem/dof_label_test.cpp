// Names of degrees of freedom, and rows that share one, as the solids that CalculiX makes of
// shells.
#include "graze/fem/dof_label.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "graze/base/errors.hpp"
#include "graze/fem/matrix_file.hpp"
#include "graze/fem/structural_matrices.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

TEST(DofLabel, IsReadAsItIsWritten) {
  for (const char* text : {"7", "12.3", "12.3.2", "0", "-4.1"})
    EXPECT_EQ(label_text(label_from_text(text).value()), text);
  for (const char* text :
       {"", "a", "1.", "1.a", "1.2.", "1.2.0", "1.0.1", "1.2.3.4", "1.-2", "1 2"})
    EXPECT_FALSE(label_from_text(text)) << text;
}

class SharedNames : public testing::Test {
 protected:
  void SetUp() override {
    write("m.mas", "1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
    write("k.sti", "1 1 10\n1 2 -1\n2 2 20\n2 3 -2\n3 3 30\n3 4 -3\n4 4 40\n");
    write("rows.dof", "2.1\n2.3\n5.1\n2.3\n");
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  StructuralMatrices read(const std::vector<DofLabel>& held = {}) {
    return read_structure({folder_ / "m.mas", folder_ / "k.sti", {}, folder_ / "rows.dof"}, held);
  }

  ScratchFolder folder_;
};

TEST_F(SharedNames, AreToldApartByANumber) {
  const StructuralMatrices structure = read();
  EXPECT_EQ(structure.labels, (std::vector<DofLabel>{{2, 1}, {2, 3, 1}, {5, 1}, {2, 3, 2}}));
  EXPECT_EQ(structure.find({2, 3, 2}), 3);
  EXPECT_FALSE(structure.find({2, 3}));
  EXPECT_EQ(structure.absence({2, 3}),
            "2.3 is the name of 2 rows, it must be one of 2.3.1 to 2.3.2");
  EXPECT_EQ(structure.absence({2, 2}), "the matrices have no degree of freedom 2.2");
  // All of them move in direction 3.
  EXPECT_EQ(structure.total_masses.at(3), 6.0);
}

TEST_F(SharedNames, AreHeldTogetherOrOneByOne) {
  EXPECT_EQ(read({{2, 3}}).labels, (std::vector<DofLabel>{{2, 1}, {5, 1}}));
  EXPECT_EQ(read({{2, 3, 1}}).labels, (std::vector<DofLabel>{{2, 1}, {5, 1}, {2, 3, 2}}));
  EXPECT_THROW(read({{2, 3, 3}}), InputError);
  EXPECT_THROW(read({{2, 2}}), InputError);
}

// Rows of nodes that the mesh has not are no displacements: node 5 is not moved by a base.
TEST_F(SharedNames, AreThoseOfTheMeshWhereItIsKnown) {
  EXPECT_EQ(read().total_masses.at(1), 4.0);
  const StructuralMatrices structure =
      read_structure({folder_ / "m.mas", folder_ / "k.sti", {}, folder_ / "rows.dof", {2, 7}}, {});
  EXPECT_EQ(structure.total_masses.at(1), 1.0);
  EXPECT_EQ(structure.inertia_loads.at(1), (Vector(4) << 1.0, 0.0, 0.0, 0.0).finished());
  EXPECT_EQ(structure.total_masses.at(3), 6.0);
}

// What is listed to be held stands once.
TEST_F(SharedNames, AreRefusedInAListOfDegreesOfFreedom) {
  try {
    read_dof_names(folder_ / "rows.dof");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).substr((folder_ / "").string().size()),
              "rows.dof:4: the degree of freedom 2.3 stands twice");
  }
}

}  // namespace
}  // namespace graze
