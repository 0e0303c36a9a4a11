// Meshes as CalculiX and Abaqus read them, and as plain lists of nodes.
#include "graze/fem/mesh_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "graze/base/errors.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

class MeshFile : public testing::Test {
 protected:
  Mesh read(const std::string& text) {
    std::ofstream(folder_ / "mesh.inp", std::ios::binary) << text;
    return read_mesh(folder_ / "mesh.inp");
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / "").string().size());
    }
    return "";
  }

  ScratchFolder folder_;
};

const std::string kNodes = "*NODE, NSET=all\n1,0,0,0\n2,1.,0,0\n3,1,1\n4,0,1,.5\n";

TEST_F(MeshFile, HasNodesElementsAndSets) {
  const Mesh mesh = read(
      "** a comment\n*HEADING\n7, 8, nine\n" + kNodes +
      "*Element, type=c3d4, elset=E\n11, 1, 2, 3, 4\n*ELEMENT,TYPE=S8\n12, 1,2,\n3,4,1,2,\n3,4\n"
      "*NSET,NSET=Tip\n2,\n*nset, nset=ends\nTIP, 4,\n2\n*NSET, NSET=ROW, GENERATE\n1,4,2\n"
      "*MATERIAL,NAME=M\n*ELASTIC\n2.1e11,.3\n");
  ASSERT_EQ(mesh.nodes.size(), 4u);
  EXPECT_EQ(mesh.nodes.at(3), (std::array<double, 3>{1.0, 1.0, 0.0}));
  EXPECT_EQ(mesh.nodes.at(4), (std::array<double, 3>{0.0, 1.0, 0.5}));
  ASSERT_EQ(mesh.elements.size(), 2u);
  EXPECT_EQ(mesh.elements[0].type, "C3D4");
  EXPECT_EQ(mesh.elements[0].nodes, (std::vector<long>{1, 2, 3, 4}));
  EXPECT_EQ(mesh.elements[1].nodes, (std::vector<long>{1, 2, 3, 4, 1, 2, 3, 4}));
  EXPECT_EQ(mesh.sets,
            (std::map<std::string, std::vector<long>>{
                {"ALL", {1, 2, 3, 4}}, {"TIP", {2}}, {"ENDS", {2, 4}}, {"ROW", {1, 3}}}));
}

TEST_F(MeshFile, HasSetsOfWhatStandsBelowThem) {
  const Mesh mesh = read(
      "*NSET,NSET=ROW,GENERATE\n2,1000000000000,2\n*NSET,NSET=BOTH\nrow, tip\n"
      "*NSET,NSET=A\nB,1\n*NSET,NSET=B\nA,3\n" +
      kNodes + "*NSET,NSET=TIP\n3\n*NODE,NSET=TIP\n6,2,0,0\n");
  EXPECT_EQ(mesh.sets, (std::map<std::string, std::vector<long>>{{"ALL", {1, 2, 3, 4}},
                                                                 {"ROW", {2, 4, 6}},
                                                                 {"TIP", {3, 6}},
                                                                 {"BOTH", {2, 3, 4, 6}},
                                                                 {"A", {1, 3}},
                                                                 {"B", {1, 3}}}));
}

TEST_F(MeshFile, MayBeAListOfNodes) {
  for (const char* text : {"1,0,0,0\n2, 1, 0.5\n", "# x y z\n1 0 0 0\n\n2 1 .5 0\n"}) {
    const Mesh mesh = read(text);
    EXPECT_EQ(mesh.nodes.at(2), (std::array<double, 3>{1.0, 0.5, 0.0})) << text;
    EXPECT_TRUE(mesh.elements.empty());
  }
}

TEST_F(MeshFile, IsRefusedWithItsLine) {
  EXPECT_EQ(refusal("*ELEMENT,TYPE=S3\n1,1,2,3\n"), "mesh.inp: the file has no nodes");
  EXPECT_EQ(refusal(kNodes + "2,0,0,0\n"), "mesh.inp:6: the node 2 stands twice");
  EXPECT_EQ(refusal(kNodes + "5,0,0,0,1\n"),
            "mesh.inp:6: the line has 5 entries, it must have a node and its x, y and z");
  EXPECT_EQ(refusal(kNodes + "*NSET\n1\n"),
            "mesh.inp:6: the set has no name, the keyword must be *NSET, NSET=NAME");
  EXPECT_EQ(refusal(kNodes + "*NSET,NSET=A\nTIP\n"),
            "mesh.inp:7: \"TIP\" is neither a node's number nor a set");
  EXPECT_EQ(refusal(kNodes + "*NSET,NSET=A,GENERATE\n1,4,0\n"),
            "mesh.inp:7: the step 0 must be at least 1");
}

}  // namespace
}  // namespace graze
