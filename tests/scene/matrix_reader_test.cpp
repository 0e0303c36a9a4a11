// [matrices] in a scene: what it reads, what it refuses, and what it writes.
#include <gtest/gtest.h>

#include <fstream>

#include "graze/base/errors.hpp"
#include "graze/scene/matrix_structure.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"
#include "support/scratch_folder.hpp"

namespace graze {
namespace {

// Two masses between three springs: k = 1, m = 1, w^2 = 1 and 3.
class MatrixReader : public testing::Test {
 protected:
  MatrixReader() {
    write("m.mtx", "1,1,1,1,1.\n2,1,2,1,1.\n");
    write("k.mtx", "1,1,1,1,2.\n1,1,2,1,-1.\n2,1,2,1,2.\n");
    write("c.mtx", "1,1,1,1,.3\n");
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  Scene read(const std::string& matrices, const std::string& rest = "") {
    return parse_scene(
        "[matrices]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\nmodes = 2\n" + matrices + rest,
        (folder_ / "scene.toml").string());
  }
  std::string refusal(const std::string& matrices, const std::string& rest = "") {
    try {
      read(matrices, rest);
    } catch (const InputError& error) {
      const std::string said = error.what(), start = folder_.string() + "/";
      return said.rfind(start, 0) == 0 ? said.substr(start.size()) : said;
    }
    return "";
  }

  ScratchFolder folder_;
};

const std::string kLoad = "[forcing]\nkind = \"load\"\namplitude = 1.0\nfrequency = 2.0\n";
const std::string kStop = "[[stop]]\nnode = \"2.1\"\ngap = 0.1\nrestitution = 0.5\n";

TEST_F(MatrixReader, ModesLoadsAndPlacesFollowFromTheFiles) {
  const Scene scene =
      read("direction = 1\nload = [\"1.1\"]\nload_values = [3.0]\n",
           "[forcing]\nkind = \"load\"\namplitude = 1.0\nfrequency = 2.0\n" + kStop +
               "[[stop]]\nnode = \"1.1\"\nagainst = \"2.1\"\ngap = 0.1\nrestitution = 0.5\n"
               "[[probe]]\nnode = \"1.1\"\n");
  const ModalStructure& modal = *scene.modal();
  ASSERT_EQ(scene.modes(), 2);
  EXPECT_NEAR(modal.frequencies[0], 1.0, 1e-14);
  EXPECT_NEAR(modal.frequencies[1], std::sqrt(3.0), 1e-14);
  const double r = std::sqrt(0.5);
  EXPECT_NEAR(std::abs(scene.stops[0].shape[0]), r, 1e-14);
  EXPECT_NEAR(std::abs(scene.stops[1].shape[0]), 0.0, 1e-14);
  EXPECT_NEAR(std::abs(scene.stops[1].shape[1]), 2.0 * r, 1e-14);
  EXPECT_NEAR(std::abs(modal.participation[0]), 3.0 * r, 1e-14);
  EXPECT_NEAR(std::abs(modal.inertia[0]), 2.0 * r, 1e-14);
  EXPECT_NEAR(modal.inertia[1], 0.0, 1e-14);
  // b_i^T K^-1 b_k
  const Matrix& flexibility = scene.matrices()->solved->flexibility;
  EXPECT_NEAR(flexibility(0, 0), 2.0 / 3.0, 1e-14);
  EXPECT_NEAR(flexibility(1, 1), 2.0 / 3.0, 1e-14);
  EXPECT_NEAR(flexibility(0, 1), -1.0 / 3.0, 1e-14);
}

// The spring between both masses is cut in two of stiffness 2, with a place in between that has no
// mass: u_3 = (u_1 + u_2)/2. A force there moves it by 1/4, what both springs give, and half of it
// goes to each mass: 1/4 + (1/2, 1/2) K^-1 (1/2, 1/2)^T = 3/4.
TEST_F(MatrixReader, APlaceWithoutMassFollowsTheOthers) {
  write("k.mtx", "1,1,1,1,3.\n3,1,1,1,-2.\n2,1,2,1,3.\n3,1,2,1,-2.\n3,1,3,1,4.\n");
  const std::string between =
      "[[stop]]\nnode = \"3.1\"\ngap = 0.1\nrestitution = 0.5\n"
      "[[stop]]\nnode = \"1.1\"\nagainst = \"3.1\"\ngap = 0.1\nrestitution = 0.5\n"
      "[[probe]]\nnode = \"3.1\"\n";
  const Scene scene =
      read("direction = 1\nload = [\"3.1\"]\nload_values = [3.0]\n",
           "[forcing]\nkind = \"load\"\namplitude = 1.0\nfrequency = 2.0\n" + between);
  const ModalStructure& modal = *scene.modal();
  EXPECT_NEAR(modal.frequencies[0], 1.0, 1e-14);
  EXPECT_NEAR(modal.frequencies[1], std::sqrt(3.0), 1e-14);
  const double r = std::sqrt(0.5);
  EXPECT_NEAR(std::abs(scene.stops[0].shape[0]), r, 1e-14);
  EXPECT_NEAR(scene.stops[0].shape[1], 0.0, 1e-14);
  EXPECT_NEAR(scene.stops[1].shape[0], 0.0, 1e-14);
  EXPECT_NEAR(std::abs(scene.stops[1].shape[1]), r, 1e-14);
  EXPECT_EQ(scene.probes[0].shape, scene.stops[0].shape);
  EXPECT_NEAR(std::abs(modal.participation[0]), 3.0 * r, 1e-14);
  EXPECT_NEAR(modal.participation[1], 0.0, 1e-14);
  // M r is that of both masses.
  EXPECT_NEAR(std::abs(modal.inertia[0]), 2.0 * r, 1e-14);
  const MatrixModes& found = *scene.matrices()->solved;
  EXPECT_EQ(found.modes.massless, 1);
  EXPECT_NEAR(found.flexibility(0, 0), 0.75, 1e-14);
  EXPECT_NEAR(found.row("3.1").value()[0], scene.stops[0].shape[0], 0.0);
  // With one mass held, one is left.
  EXPECT_EQ(refusal("constraints = [\"1.1\"]\n", kStop),
            "scene.toml:4:1: matrices.modes: 2 is not allowed, the matrices have 1 degree of "
            "freedom that is not held and has mass");
}

TEST_F(MatrixReader, CopiesShareTheModes) {
  const Scene scene = read("", kStop);
  const Scene moved = with_parameter(scene, "stop.gap", 0.2);
  EXPECT_EQ(moved.matrices()->solved.get(), scene.matrices()->solved.get());
  EXPECT_EQ(parameter_names(scene), (std::vector<std::string>{"stop.gap", "stop.restitution"}));
}

TEST_F(MatrixReader, WrittenSceneKnowsItsFiles) {
  const std::string text =
      write_scene(read("direction = 1\nload = [\"1.1\", \"2.1\"]\n", kLoad + kStop));
  const Scene again = parse_scene(text, "elsewhere/scene.toml");
  EXPECT_EQ(write_scene(again), text);
  EXPECT_EQ(again.stops[0].shape, read("", kStop).stops[0].shape);
  write("k.mtx", "1,1,1,1,2.\n1,1,2,1,-1.\n2,1,2,1,2.5\n");
  try {
    parse_scene(text, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("they have been changed since this scene was written"),
              std::string::npos)
        << error.what();
  }
}

// A load that a moving base leaves idle was passed over without a word.
TEST_F(MatrixReader, ALoadThatDoesNotActIsRefused) {
  write("f.txt", "1.1 2.0\n");
  for (const std::string load : {"load = [\"1.1\"]\n", "load_file = \"f.txt\"\n"}) {
    const std::string name = load.substr(0, load.find(' '));
    for (const std::string kind : {"", "kind = \"base\"\n"})
      EXPECT_EQ(refusal("direction = 1\n" + load,
                        "[forcing]\n" + kind + "amplitude = 1.0\nfrequency = 2.0\n"),
                "scene.toml:6:1: matrices." + name +
                    ": forcing moves the base and not this load: forcing.kind must be \"load\", or "
                    "it must be left out");
    EXPECT_EQ(refusal(load), "scene.toml:5:1: matrices." + name +
                                 ": there is no [forcing] that it is for, it must be left out");
  }
}

TEST_F(MatrixReader, WhatDoesNotFitIsRefused) {
  EXPECT_EQ(refusal("", "[[stop]]\ngap = 0.1\nrestitution = 0.5\n"),
            "scene.toml:5:1: stop.node: the key is missing, it must be a degree of freedom, "
            "\"node.direction\" or a number like \"7\"");
  EXPECT_EQ(refusal("", "[[stop]]\nnode = \"3.1\"\ngap = 0.1\nrestitution = 0.5\n"),
            "scene.toml:6:1: stop.node: the matrices have no degree of freedom 3.1");
  EXPECT_EQ(refusal("", "[[stop]]\nnode = 1.1\ngap = 0.1\nrestitution = 0.5\n"),
            "scene.toml:6:1: stop.node: the number 1.1 is not allowed, it must be a degree of "
            "freedom, \"node.direction\" or a number like \"7\"");
  EXPECT_EQ(refusal("constraints = [\"1.1\"]\n", kStop),
            "scene.toml:4:1: matrices.modes: 2 is not allowed, the matrices have 1 degree of "
            "freedom that is not held");
  EXPECT_EQ(refusal("", "[[stop]]\nposition = 1.0\nnode = \"2.1\"\ngap = 0.1\nrestitution = 0.5\n"),
            "scene.toml:6:1: stop.position: a point of [matrices] has no position, it must have a "
            "node");
  EXPECT_EQ(refusal("", "[forcing]\namplitude = 1.0\nfrequency = 2.0\n"),
            "scene.toml:1:1: matrices.direction: forcing of the kind \"base\" needs the direction "
            "of its acceleration, it must be one that degrees of freedom have, 1, 2 or 3 (0 where "
            "they have none)");
  EXPECT_EQ(refusal("", "[forcing]\nkind = \"load\"\namplitude = 1.0\nfrequency = 2.0\n"),
            "scene.toml:1:1: matrices.load: the key is missing, forcing of the kind \"load\" needs "
            "degrees of freedom, or load_file");
  EXPECT_EQ(refusal("load = [\"1.1\"]\nload_values = [1.0, 2.0]\n", kLoad),
            "scene.toml:6:1: matrices.load_values: the list has 2 entries, it must have one for "
            "each of the 1 of load");
  EXPECT_EQ(refusal("damping = \"c.mtx\"\n", "[damping]\nratios = [0.1, 0.1]\n"),
            "scene.toml:6:1: damping: matrices.damping is given already, the scene must have only "
            "one of matrices.damping and [damping]");
  EXPECT_EQ(
      refusal("", "[modal]\nfrequencies = [1.0]\n"),
      "scene.toml:1:1: matrices: the scene has a [modal] already, it must have exactly one of "
      "[beam], [string], [bar], [modal], [matrices] and [lumped]");
  EXPECT_THROW(read("dofs = \"absent.dof\"\n"), FileError);
  write("names.dof", "1.1\n2.1\n");
  EXPECT_EQ(refusal("dofs = \"names.dof\"\n"),
            "names.dof: the matrices have the names of their rows, this file of names (dofs) must "
            "be left out");
}

// A free chain whose stiffness was printed with eight digits.
TEST_F(MatrixReader, KnowsAFreeStructureThatWasPrintedBadly) {
  write("k.mtx", "1,1,1,1,2.\n1,1,2,1,-1.9999999\n2,1,2,1,2.\n");
  const auto weak = read("").matrices()->solved->weak_holds;
  ASSERT_EQ(weak.size(), 1u);
  EXPECT_NEAR(weak.at(1), 2e-7 / 8.0, 1e-9);
  write("k.mtx", "1,1,1,1,2.\n1,1,2,1,-2.\n2,1,2,1,2.\n");
  EXPECT_TRUE(read("").matrices()->solved->weak_holds.empty());
  EXPECT_EQ(read("").matrices()->solved->modes.rigid, 1);
}

TEST_F(MatrixReader, MadeInCodeItIsSolvedFirst) {
  Scene scene;
  MatrixStructure matrices;
  matrices.mass = (folder_ / "m.mtx").string();
  matrices.stiffness = (folder_ / "k.mtx").string();
  matrices.modes = 1;
  scene.structure = matrices;
  solve_matrices(scene);
  EXPECT_NEAR(scene.modal()->frequencies[0], 1.0, 1e-14);
}

}  // namespace
}  // namespace graze
