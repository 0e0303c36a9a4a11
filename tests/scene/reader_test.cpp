#include "graze/scene/reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "graze/scene/check.hpp"

namespace graze {
namespace {

const std::string kBeam =
    "[beam]\nlength = 0.3\nyoungs_modulus = 205e9\nsecond_moment = 24.4e-14\ndensity = 8500\n"
    "area = 12.4e-6\nmodes = 4\n";
const std::string kModal = "[modal]\nfrequencies = [1, 2.5]\n";

std::string reading_error(const std::string& text) {
  try {
    parse_scene(text, "s");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Reader, WhatIsNotNamedIsAbsent) {
  const Scene scene = parse_scene(kBeam, "s");
  EXPECT_EQ(scene.title, "");
  EXPECT_EQ(scene.modes(), 4);
  EXPECT_FALSE(scene.damping || scene.forcing || scene.gravity || scene.initial);
  EXPECT_TRUE(scene.stops.empty());
  EXPECT_TRUE(scene.beam()->points.empty());
  const Scene modal = parse_scene(kModal, "s");
  EXPECT_EQ(modal.modes(), 2);
  EXPECT_TRUE(modal.modal()->damping_ratios.empty());
  EXPECT_TRUE(modal.modal()->participation.empty());
  EXPECT_TRUE(modal.modal()->inertia.empty());
}

TEST(Reader, DefaultsAreTheContracts) {
  const Scene scene = parse_scene(
      kBeam +
          "[forcing]\namplitude = 1\nfrequency = 2\n"
          "[[stop]]\nposition = 0.3\ngap = 0\nrestitution = 1\n[initial]\nqdot = [1, 2, 3, 4]\n",
      "s");
  EXPECT_EQ(scene.beam()->discretisation, Projection::kGalerkin);
  EXPECT_EQ(scene.forcing->kind, ForcingKind::kBase);
  EXPECT_EQ(scene.forcing->phase, 0.0);
  EXPECT_EQ(scene.stops[0].side, Side::kAbove);
  EXPECT_EQ(scene.stops[0].impulse, Impulse::kMomentum);
  EXPECT_EQ(scene.initial->q, std::vector<double>(4, 0.0));
  EXPECT_EQ(scene.initial->qdot, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(scene.solver.flow, FlowChoice::kAuto);
  EXPECT_EQ(scene.solver.tolerance, 1e-10);
  const Scene modal = parse_scene(
      kModal + "participation = [1, 0]\n[forcing]\namplitude = 1\nfrequency = 2\n", "s");
  EXPECT_EQ(modal.forcing->kind, ForcingKind::kModal);
}

TEST(Reader, GravityIsAnyNumberAndNeedsInertia) {
  EXPECT_EQ(parse_scene(kBeam + "[gravity]\nacceleration = -9.81\n", "s").gravity->acceleration,
            -9.81);
  const std::string ball = "[modal]\nfrequencies = [0.0]\ninertia = [1.0]\n";
  EXPECT_EQ(parse_scene(ball + "[gravity]\nacceleration = 10\n", "s").gravity->acceleration, 10.0);
  EXPECT_EQ(reading_error(kModal + "[gravity]\nacceleration = 0\n"),
            "s:1:1: modal.inertia: the key is missing, [gravity] needs a list of numbers, one per "
            "mode");
}

TEST(Reader, ConstantRestitutionIsOneEntry) {
  const auto restitution = [](const std::string& value) {
    return parse_scene(kModal + "[[stop]]\nshape = [1, 2]\ngap = 0\nrestitution = " + value, "s")
        .stops[0]
        .restitution;
  };
  EXPECT_EQ(restitution("1"), std::vector<double>{1.0});
  EXPECT_EQ(restitution("[0.8]"), std::vector<double>{0.8});
  EXPECT_EQ(restitution("[1, -0.25, 3e8]"), (std::vector<double>{1.0, -0.25, 3e8}));
}

TEST(Reader, StopsAreKeptInOrder) {
  const std::string text = kBeam +
                           "[[stop]]\nposition = 0.15\ngap = 0.1\nrestitution = 0.9\n"
                           "impulse = \"collocation\"\n"
                           "[[stop]]\nposition = 0.3\ngap = -0.2\nrestitution = [0.5, 0.1]\n"
                           "side = \"below\"\nimpulse = \"collocation\"\n";
  const Scene scene = parse_scene(text, "s");
  ASSERT_EQ(scene.stops.size(), 2u);
  EXPECT_EQ(scene.stops[0].position, 0.15);
  EXPECT_EQ(scene.stops[1].position, 0.3);
  EXPECT_EQ(scene.stops[1].gap, -0.2);  // preload needs no [initial]
  EXPECT_EQ(scene.stops[1].side, Side::kBelow);
  EXPECT_EQ(scene.origins->at("stop.2.restitution.2").text(), "s:16:21");
}

// The C library's strtod rounds correctly; so must the reader.
TEST(Reader, NumbersAreTheNearestDoubles) {
  for (const char* literal : {"0.1", "24.4e-14", "6.703903964971299e153", "2.2250738585072011e-308",
                              "9007199254740993.0", "4.9e-324", "0.30000000000000004"}) {
    const Scene scene = parse_scene("[modal]\nfrequencies = [" + std::string(literal) + "]\n", "s");
    EXPECT_EQ(scene.modal()->frequencies[0], std::strtod(literal, nullptr)) << literal;
  }
}

TEST(Reader, AcceptsWindowsLineEndsAndOtherSpellingsOfTables) {
  EXPECT_EQ(parse_scene("[modal]\r\nfrequencies = [1.0]\r\n", "s").modes(), 1);
  EXPECT_EQ(parse_scene("modal.frequencies = [1.0]\n", "s").modes(), 1);
  const Scene scene = parse_scene(
      "modal = { frequencies = [1.0] }\nstop = [{ shape = [1], gap = 0, restitution = 0 }]\n", "s");
  EXPECT_EQ(scene.stops.size(), 1u);
  EXPECT_TRUE(parse_scene(kModal + "[initial]\n", "s").initial.has_value());
  EXPECT_TRUE(parse_scene("stop = []\n" + kModal, "s").stops.empty());
}

TEST(Reader, RemembersWhereEachKeyStands) {
  const Scene scene = parse_scene(
      kModal + "\n  [[stop]]\n  shape = [1, 2]\n  gap = 0\n  restitution = 0\n", "s.toml");
  const Origins& origins = *scene.origins;
  EXPECT_EQ(origins.at("modal").text(), "s.toml:1:1");
  EXPECT_EQ(origins.at("modal.frequencies").text(), "s.toml:2:1");
  EXPECT_EQ(origins.at("modal.frequencies.2").text(), "s.toml:2:19");
  EXPECT_EQ(origins.at("stop").text(), "s.toml:4:3");
  EXPECT_EQ(origins.at("stop.gap").text(), "s.toml:6:3");
  EXPECT_EQ(origins.at("stop.shape.2").text(), "s.toml:5:15");
}

TEST(Reader, SceneErrorStandsAtTheNearestTableAbove) {
  const Scene scene = parse_scene(
      "# first\n" + kModal + "[[stop]]\nshape = [1, 2]\ngap = 0\nrestitution = 0\n", "s.toml");
  const auto message = [&](const std::string& key) {
    return std::string(scene_error(scene, key, "is wrong").what());
  };
  EXPECT_EQ(message("stop.gap"), "s.toml:6:1: stop.gap: is wrong");
  EXPECT_EQ(message("stop.1.gap"), "s.toml:6:1: stop.1.gap: is wrong");
  EXPECT_EQ(message("stop.1"), "s.toml:4:1: stop.1: is wrong");
  EXPECT_EQ(message("stop.side"), "s.toml:4:1: stop.side: is wrong");
  EXPECT_EQ(message("modal.inertia.2"), "s.toml:2:1: modal.inertia.2: is wrong");
  EXPECT_EQ(message("forcing.phase"), "s.toml:1:1: forcing.phase: is wrong");
}

TEST(Reader, StopsMadeInCodeKeepTheRules) {
  Scene scene;
  scene.structure = ModalStructure{{1.0}, {}, {}, {}};
  scene.stops.resize(2);
  for (SceneStop& stop : scene.stops) {
    stop.shape = {1.0};
  }
  EXPECT_NO_THROW(check_scene(scene));
  scene.stops[1].restitution.clear();
  try {
    check_scene(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "stop.2.restitution: the list is empty, it must have at least one number");
  }
}

TEST(Reader, SceneErrorOfASceneMadeInCodeHasNoPlace) {
  Scene scene;
  scene.structure = ModalStructure{{1.0}, {}, {}, {}};
  EXPECT_STREQ(scene_error(scene, "stop.gap", "is wrong").what(), "stop.gap: is wrong");
  EXPECT_NO_THROW(check_scene(scene));
  scene.initial = Initial{{0.0, 0.0}, {0.0}};
  try {
    check_scene(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "initial.q: the list has 2 entries, it must have one per mode, which is 1");
  }
}

// Whatever the text holds: one line, no control characters, no flood.
TEST(Reader, MessagesAreSafeToPrint) {
  EXPECT_EQ(reading_error(kBeam + "discretisation = \"a\\nb\\\"c\\u0007\"\n"),
            "s:8:1: beam.discretisation: the string \"a\\nb\\\"c\\u0007\" is not allowed, it must "
            "be \"galerkin\" or \"collocation\"");
  EXPECT_EQ(reading_error(kBeam + "discretisation = \"" + std::string(1000, 'x') + "\"\n"),
            "s:8:1: beam.discretisation: the string \"" + std::string(60, 'x') +
                "..\" is not allowed, it must be \"galerkin\" or \"collocation\"");
  EXPECT_EQ(reading_error("\"a\\nb.c\" = 1\n").substr(0, 17), "s:1:1: \"a\\nb.c\": ");
}

TEST(Reader, CountsColumnsInCharacters) {
  EXPECT_EQ(reading_error("modal = { frequencies = [1], \"\xc3\xa4\xc3\xb6\" = 1 }\n").substr(0, 7),
            "s:1:30:");
  EXPECT_EQ(reading_error("title = '\xc3\xa4\xc3\xb6\x01'\n").substr(0, 7), "s:1:12:");
}

TEST(Reader, CollocationPointsAreEvenUnlessGiven) {
  Beam beam;
  beam.length = 0.3;
  beam.modes = 4;
  const std::vector<double> points = collocation_points(beam);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_DOUBLE_EQ(points[0], 0.075);
  EXPECT_DOUBLE_EQ(points[2], 0.225);
  EXPECT_EQ(points[3], 0.3);
  EXPECT_EQ(collocation_index(beam, 0.225), 2);  // 3 * 0.3 / 4 is another double
  EXPECT_EQ(collocation_index(beam, 0.3), 3);
  EXPECT_EQ(collocation_index(beam, 0.2999999), -1);
  beam.points = {0.1, 0.15, 0.2, 0.25};
  EXPECT_EQ(collocation_points(beam), beam.points);
  EXPECT_EQ(collocation_index(beam, 0.15), 1);
}

// N L / N is not always L in doubles; the last point must still be on the beam.
TEST(Reader, TheTipIsACollocationPointForEveryN) {
  Beam beam;
  for (beam.modes = 1; beam.modes <= 2000; ++beam.modes) {
    for (const double length : {0.3, 0.1, 1.0 / 3.0, 2.7e-3}) {
      beam.length = length;
      EXPECT_EQ(collocation_points(beam).back(), length);
      EXPECT_EQ(collocation_index(beam, length), beam.modes - 1);
    }
  }
}

TEST(Reader, MissingFileAndFolderAreFileErrors) {
  const auto message = [](const std::filesystem::path& file) {
    try {
      read_scene(file);
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message("no/such/scene.toml"),
            "no/such/scene.toml: cannot be read, No such file or directory");
  EXPECT_EQ(message(GRAZE_SOURCE_DIR),
            std::string(GRAZE_SOURCE_DIR) + ": cannot be read as a scene, it is a directory");
  EXPECT_NE(message("").find("cannot be read"), std::string::npos);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Random changes of shipped scenes are read or refused, and nothing else happens.
TEST(Reader, MutatedScenesAreReadOrRefused) {
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(GRAZE_SOURCE_DIR) / "data" / "scenes")) {
    texts.push_back(text_of(entry.path()));
  }
  ASSERT_FALSE(texts.empty());
  std::sort(texts.begin(), texts.end());  // folders come in any order
  // Where a scene finds the matrices that it names, which complain themselves.
  const std::filesystem::path data = std::filesystem::path(GRAZE_SOURCE_DIR) / "data";
  const std::string name = (data / "scenes" / "mutant").string();
  const std::string matrices = (data / "matrices").string();
  std::mt19937 random(20040908);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  // Bytes that change the structure more often than chance would have it.
  const std::string pieces = "[]{}=.,\"'#\n\\-+0e9_ \t\r";
  for (int round = 0; round < 2000; ++round) {
    std::string text = texts[below(texts.size())];
    for (std::size_t changes = 1 + below(8); changes > 0; --changes) {
      const std::size_t at = below(text.size());
      const char byte =
          below(2) == 0 ? pieces[below(pieces.size())] : static_cast<char>(below(256));
      const std::size_t kind = below(4);
      if (kind == 0) {
        text[at] = byte;
      } else if (kind == 1) {
        text.insert(at, 1, byte);
      } else if (kind == 2) {
        text.erase(at, 1 + below(20));
      } else {
        text.insert(at, text.substr(below(text.size()), below(60)));
      }
    }
    try {
      const Scene scene = parse_scene(text, name);
      const std::string written = write_scene(scene);
      EXPECT_EQ(write_scene(parse_scene(written, "written")), written) << text;
    } catch (const InputError& error) {
      const std::string said = error.what();
      EXPECT_TRUE(said.find(name + ":") == 0 || said.find(matrices) == 0) << said;
    } catch (const FileError&) {
      // A mutant may name a file that is not there.
    }
  }
}

}  // namespace
}  // namespace graze
