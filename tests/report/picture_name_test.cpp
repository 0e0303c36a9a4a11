// Names of pictures, which gnuplot and shells get to see.
#include <gtest/gtest.h>

#include "apps/program.hpp"
#include "graze/base/errors.hpp"
#include "graze/report/picture/pictures.hpp"

namespace graze {
namespace {

TEST(PictureNames, CannotBeCommandsOfGnuplot) {
  for (const char* name : {"<x.png", "|x.svg", "folder/<x.pdf", "/tmp/| rm.png", "x\n.png"})
    EXPECT_THROW(check_picture_name(name), InputError) << name;
  for (const char* name : {"x.png", "a<b.svg", "<folder/x.pdf", "-x.png", "~x.png", "it's.svg"})
    EXPECT_NO_THROW(check_picture_name(name)) << name;
}

// The script says how it is run: the line must do that in a shell, whatever its name.
TEST(PictureNames, ScriptsTellACommandThatDrawsThem) {
  const ScratchFolder scratch;
  for (const std::string name :
       {"x", "two words", "-x", "~x", "it's", "$(touch y)", "a;b", "a&b"}) {
    const ChartSeries line{.title = "", .look = {}, .x = {0.0, 1.0}, .y = {0.0, 1.0}};
    const ChartPanel panel{.x = {}, .y = {}, .series = {line}};
    draw_chart((scratch / (name + ".svg")).string(), RunInfo{}, {"", {{panel}}});
    const std::string text = read_text(scratch / (name + ".gp"));
    const std::size_t at = text.find(": gnuplot ") + 2;
    const std::string command = text.substr(at, text.find('\n') - at);
    std::filesystem::remove(scratch / (name + ".svg"));
    EXPECT_EQ(std::system(("cd '" + scratch.string() + "' && " + command).c_str()), 0) << command;
    EXPECT_TRUE(std::filesystem::exists(scratch / (name + ".svg"))) << command;
    EXPECT_FALSE(std::filesystem::exists(scratch / "y")) << command;
  }
}

}  // namespace
}  // namespace graze
