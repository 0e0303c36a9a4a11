#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "graze/scene/difference.hpp"
#include "graze/scene/parameter.hpp"
#include "graze/scene/reader.hpp"

namespace graze {
namespace {

const std::string kProbedBeam =
    "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\ndensity = 8500\n"
    "area = 12.4e-6\nmodes = 2\nthickness = 1e-3\n";
const std::string kProbedModal = "[modal]\nfrequencies = [1, 2.5]\n";

TEST(Probe, AreKeptInOrder) {
  const Scene scene = parse_scene(kProbedBeam +
                                      "[[probe]]\nposition = 0.3\n"
                                      "[[probe]]\nposition = 0\nquantity = \"strain\"\n"
                                      "[[probe]]\nposition = 0.1\nquantity = \"velocity\"\n"
                                      "[[probe]]\nposition = 0.2\nquantity = \"deflection\"\n",
                                  "s");
  ASSERT_EQ(scene.probes.size(), 4u);
  EXPECT_EQ(scene.probes[0].position, 0.3);
  EXPECT_EQ(scene.probes[0].quantity, ProbeQuantity::kDisplacement);
  EXPECT_EQ(scene.probes[1].quantity, ProbeQuantity::kStrain);
  EXPECT_EQ(scene.probes[2].quantity, ProbeQuantity::kVelocity);
  EXPECT_EQ(scene.probes[3].quantity, ProbeQuantity::kDeflection);
  EXPECT_EQ(write_scene(parse_scene(write_scene(scene), "s")), write_scene(scene));
}

TEST(Probe, OfModesHasAShape) {
  const Scene scene = parse_scene(kProbedModal + "[[probe]]\nshape = [1, -2]\n", "s");
  EXPECT_EQ(scene.probes[0].shape, (std::vector<double>{1.0, -2.0}));
  EXPECT_EQ(parse_scene(write_scene(scene), "s").probes[0].shape, scene.probes[0].shape);
}

TEST(Probe, SettingsNameThemByNumber) {
  const Scene scene =
      parse_scene(kProbedBeam + "[[probe]]\nposition = 0.3\n", "s",
                  {"probe.position=0.25", "probe.1.quantity=velocity", "probe.2.position=0.1",
                   "probe.3={position=0.2, quantity=\"strain\"}"});
  ASSERT_EQ(scene.probes.size(), 3u);
  EXPECT_EQ(scene.probes[0].position, 0.25);
  EXPECT_EQ(scene.probes[0].quantity, ProbeQuantity::kVelocity);
  EXPECT_EQ(scene.probes[1].position, 0.1);
  EXPECT_EQ(scene.probes[2].quantity, ProbeQuantity::kStrain);
  EXPECT_EQ(parse_scene(kProbedModal, "s", {"probe.shape=[1, 0]"}).probes.size(), 1u);
}

// No parameter, and nothing that an orbit depends on.
TEST(Probe, ChangesNothing) {
  const Scene with = parse_scene(kProbedBeam + "[[probe]]\nposition = 0.3\n", "s");
  const Scene without = parse_scene(kProbedBeam, "s", {"beam.thickness=2e-3"});
  EXPECT_EQ(parameter_names(with), parameter_names(without));
  EXPECT_EQ(scene_difference(with, without, {}), "");
  EXPECT_EQ(scene_difference(with, without, {"beam.thickness"}), "");
  EXPECT_EQ(parameter_direction(with, "beam.length").probes[0].position, 0.0);
}

}  // namespace
}  // namespace graze
