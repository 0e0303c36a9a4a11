// graze modes: of a frame from matrices, of beams and of modes that are given.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/program.hpp"

namespace graze {
namespace {

using nlohmann::json;

const std::string kFrame = scene("24_frame_from_matrices.toml");

TEST(Modes, TellsThoseOfAFrameAndWritesThemForParaView) {
  const ScratchFolder folder;
  const std::string out = (folder / "out").string();
  const Finished run = run_graze("modes --json --out " + out + " " + kFrame);
  ASSERT_EQ(run.code, 0) << run.err;
  const json document = json::parse(run.out);
  ASSERT_EQ(document["modes"].size(), 8u);
  EXPECT_EQ(document["rigid"], 0);
  for (const json& mode : document["modes"]) EXPECT_LE(mode["residual"].get<double>(), 1e-13);
  // The frame holds 7 m of tube, 60 x 60 x 3 mm of steel.
  const double mass = 7.0 * 7850.0 * (0.06 * 0.06 - 0.054 * 0.054);
  for (const json& direction : document["directions"])
    EXPECT_NEAR(direction["total_mass"].get<double>(), mass, 1e-9);
  for (const char* name : {"modes.pvd", "mode_1.vtu", "mode_8.vtu", "scene.toml", "record.json"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name;
  const Finished again = run_graze("view " + out);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out, run_graze("modes " + kFrame).out);
  const Finished from_there = run_graze("modes --json " + out + "/scene.toml");
  ASSERT_EQ(from_there.code, 0) << from_there.err;
  EXPECT_EQ(json::parse(from_there.out)["modes"], document["modes"]);
  EXPECT_EQ(json::parse(from_there.out)["graze"]["scene_sha256"],
            document["graze"]["scene_sha256"]);
}

TEST(Modes, HintAtMassAndStiffnessThatAreExchanged) {
  const std::string matrices = std::string(GRAZE_SOURCE_DIR) + "/data/matrices/portal_frame_";
  const std::string exchanged = kFrame + " --set 'matrices.mass=\"" + matrices +
                                "stiffness.mtx\"' --set 'matrices.stiffness=\"" + matrices +
                                "mass.mtx\"'";
  const std::string hint = "matrices.mass and matrices.stiffness seem to be exchanged";
  EXPECT_NE(run_graze("check " + exchanged).err.find(hint), std::string::npos);
  EXPECT_NE(run_graze("modes --json " + exchanged).out.find(hint), std::string::npos);
  EXPECT_EQ(run_graze("modes --json " + kFrame).out.find(hint), std::string::npos);
}

// A chain of three masses whose mesh is the input file of a finite-element program: its sets hold
// and meet, its elements are the cells. VTK has the middle node of a bent line behind its ends.
TEST(Modes, OfAMeshAreDrawnByItsElements) {
  const ScratchFolder folder;
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder / name) << text;
  };
  write("m.mtx", "1,1,1,1,1\n2,1,2,1,2\n3,1,3,1,1\n");
  write("k.mtx", "1,1,1,1,1\n2,1,1,1,-1\n2,1,2,1,2\n3,1,2,1,-1\n3,1,3,1,1\n");
  write("mesh.inp",
        "*NODE, NSET=ALL\n1,0,0,0\n2,1,0,0\n3,2,0,0\n*ELEMENT, TYPE=B32\n1,1,2,3\n*ELEMENT, "
        "TYPE=S3R\n2,1,2,3\n*ELEMENT, TYPE=SPRINGA\n3,1,2\n*ELEMENT, TYPE=CPS3\n4,3,2,1\n*NSET, "
        "NSET=Root\n1,\n*NSET, "
        "NSET=TIP\n3,\n");
  write("s.toml",
        "[matrices]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\ncoordinates = \"mesh.inp\"\nmodes = "
        "2\nconstraints = [\"ROOT.1\"]\n[[stop]]\nnode = \"tip.1\"\ngap = 1\nrestitution = 0.5\n");
  const Finished done = run_graze("modes --json --out " + (folder / "out").string() + " " +
                                  (folder / "s.toml").string());
  ASSERT_EQ(done.code, 0) << done.err;
  // The static flexibility of the end of two springs.
  EXPECT_NEAR(json::parse(done.out)["stops"][0]["flexibility"].get<double>(), 2.0, 1e-14);
  std::ostringstream drawn;
  drawn << std::ifstream(folder / "out" / "mode_1.vtu").rdbuf();
  const std::string text = drawn.str();
  EXPECT_NE(text.find("NumberOfCells=\"4\""), std::string::npos) << text;
  EXPECT_NE(text.find("0 2 1\n0 1 2\n0 1\n2 1 0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n3\n6\n8\n11\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n21\n5\n2\n5\n"), std::string::npos) << text;
  // What two nodes have cannot be one stop, nor what is no set.
  for (const char* node : {"ALL.1", "NONE.1", "TIP"}) {
    const Finished refused =
        run_graze("check " + (folder / "s.toml").string() + " --set 'stop.node=\"" + node + "\"'");
    EXPECT_EQ(refused.code, 2) << node;
    EXPECT_NE(refused.err.find("stop.node"), std::string::npos) << refused.err;
  }
}

// The tip of a cantilever has the flexibility L^3/(3 E I), which its modes add up to.
TEST(Modes, OfABeamAndOfGivenModes) {
  const json beam = json::parse(run_graze("modes --json " + scene("02_wagg_momentum.toml")).out);
  const double whole = 0.3 * 0.3 * 0.3 / (3.0 * 205e9 * 24.4e-14);
  EXPECT_NEAR(beam["stops"][0]["flexibility"].get<double>() / whole, 1.0, 1e-12);
  // The first mode alone has 4/(1.8751^4) of 1/3.
  EXPECT_GT(beam["stops"][0]["flexibility_of_modes"].get<double>() / whole, 0.97);
  EXPECT_LT(beam["stops"][0]["flexibility_of_modes"].get<double>() / whole, 1.0);
  const json given =
      json::parse(run_graze("modes --json " + scene("04_impact_oscillator.toml")).out);
  EXPECT_TRUE(given["stops"][0]["flexibility"].is_null());
}

TEST(Modes, MacIsTheIdentityOfAStructureAgainstItself) {
  const Finished run = run_graze("modes --json --mac " + kFrame + " " + kFrame);
  ASSERT_EQ(run.code, 0) << run.err;
  const json values = json::parse(run.out)["mac"]["values"];
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(values[i][i].get<double>(), 1.0, 1e-12) << i;
}

TEST(Modes, CheckWarnsWhereTheModesAreTooFew) {
  // Four bending modes hardly compress the column below the corner.
  const Finished run =
      run_graze("check " + kFrame + " --set matrices.modes=4 --set 'stop.node=\"21.2\"'");
  EXPECT_EQ(run.code, 0);
  EXPECT_NE(run.err.find("of the static flexibility"), std::string::npos) << run.err;
  EXPECT_EQ(run_graze("check " + kFrame).err, "");
}

// Two masses with a place between them that has none: all modes there are leave out its own
// flexibility, 1/4 of 3/4.
TEST(Modes, TellsOfDegreesOfFreedomWithoutMass) {
  const ScratchFolder folder;
  std::ofstream(folder / "m.mtx") << "1,1,1,1,1.\n2,1,2,1,1.\n";
  std::ofstream(folder / "k.mtx")
      << "1,1,1,1,3.\n3,1,1,1,-2.\n2,1,2,1,3.\n3,1,2,1,-2.\n3,1,3,1,4.\n";
  const std::string file = (folder / "scene.toml").string();
  std::ofstream(file) << "[matrices]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\nmodes = 2\n"
                         "[[stop]]\nnode = \"3.1\"\ngap = 0.1\nrestitution = 0.5\n";
  const Finished run = run_graze("modes " + file);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("3 degrees of freedom, 0 held; 1 without mass follows the others"),
            std::string::npos)
      << run.out;
  const Finished check = run_graze("check " + file);
  EXPECT_EQ(check.code, 0);
  EXPECT_NE(check.err.find("66.7 %: the rest is that of degrees of freedom without mass"),
            std::string::npos)
      << check.err;
}

}  // namespace
}  // namespace graze
