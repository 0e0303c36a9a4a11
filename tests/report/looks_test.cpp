// Every kind of thing has one look, told apart from the others by more than its colour.
#include "graze/report/appearance/looks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "graze/report/picture/detail/gnuplot_looks.hpp"

namespace graze {
namespace {

TEST(Looks, StandInTheGalleryAsTheyAre) {
  std::ifstream page(std::string(GRAZE_SOURCE_DIR) + "/docs/gallery.md");
  std::ostringstream text;
  text << page.rdbuf();
  EXPECT_NE(text.str().find(looks_table()), std::string::npos)
      << "docs/gallery.md must have this table:\n"
      << looks_table();
}

TEST(Looks, OfSpecialPointsDifferInTheirShape) {
  std::set<int> shapes;
  for (const Look& look : special_looks()) EXPECT_TRUE(shapes.insert(point_type(look)).second);
  EXPECT_TRUE(shapes.insert(point_type(special_look("of a later version"))).second);
  for (const Look& look : dot_looks()) {
    if (look.id == "cut") continue;  // in the panel of exponents, where there are none
    EXPECT_FALSE(shapes.contains(point_type(look)));
  }
}

TEST(Looks, OfLinesDifferInTheirDashesOrColourlessly) {
  std::set<std::pair<std::vector<int>, double>> lines;
  for (const Look& look : line_looks())
    EXPECT_TRUE(lines.insert({look.dashes, look.width}).second) << look.id;
  lines.clear();
  for (const Look& look : locus_looks())
    EXPECT_TRUE(lines.insert({look.dashes, look.width}).second) << look.id;
}

// A fold is a fold, as a point and as a locus.
TEST(Looks, OfALocusAreTheColourOfItsPoints) {
  for (const Look& locus : locus_looks()) {
    if (locus.id == "virtual") continue;
    EXPECT_EQ(locus.colour, special_look(locus.id).colour) << locus.id;
    EXPECT_EQ(locus.title, special_look(locus.id).title) << locus.id;
  }
}

// Relative luminance by the sRGB transfer function (IEC 61966-2-1).
double luminance(const std::string& colour) {
  double sum = 0.0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weights[i] * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
  }
  return sum;
}

// CIE 1976 lightness, 0 to 100: what is left of a colour in grey print.
double lightness(const std::string& colour) { return 116.0 * std::cbrt(luminance(colour)) - 16.0; }

// Two greys side by side differ by 2 of lightness; a fill on white, with no edge, by 7 or so.
TEST(Looks, OfPaleFillsAreToldApartInGreyPrint) {
  EXPECT_GE(std::abs(lightness(kStopShade) - lightness(kStuckShade)), 5.0);
  for (const Look& one : ground_looks()) {
    if (one.id == "blank") continue;
    EXPECT_LE(lightness(one.colour), 93.0) << one.id;
    for (const Look& other : ground_looks()) {
      if (&one == &other || lightness(one.colour) <= 77.0) continue;
      EXPECT_GE(std::abs(lightness(one.colour) - lightness(other.colour)), 2.0)
          << one.id << " and " << other.id;
    }
  }
}

// Words upon them are read: a contrast of 4.5, as the Web Content Accessibility Guidelines 2.1 ask.
TEST(Looks, OfGroundsCarryBlackWordsButForWhatIsWild) {
  std::set<std::string> colours;
  for (const Look& look : ground_looks()) {
    EXPECT_TRUE(colours.insert(look.colour).second) << look.id;
    if (look.id == "wild") continue;
    EXPECT_GE((luminance(look.colour) + 0.05) / 0.05, 4.5) << look.id;
  }
  for (const char* colour : other_grounds()) {
    EXPECT_TRUE(colours.insert(colour).second) << colour;
    EXPECT_GE((luminance(colour) + 0.05) / 0.05, 4.5) << colour;
  }
}

}  // namespace
}  // namespace graze
