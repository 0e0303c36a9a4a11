#include "docs/shown_output.hpp"

#include <gtest/gtest.h>

#include "docs/command_blocks.hpp"

namespace graze::support {
namespace {

TEST(ShownNumbers, AreRoundingsOfWhatIsPrinted) {
  EXPECT_FALSE(is_rounding("0.1357", "0.135755773"));
  EXPECT_TRUE(is_rounding("0.1358", "0.135755773"));
  EXPECT_TRUE(is_rounding("136e-3", "0.135755773"));
  EXPECT_TRUE(is_rounding("1.3e5", "131000"));
  EXPECT_FALSE(is_rounding("593", "635"));
  EXPECT_FALSE(is_rounding("0.1357557731", "0.135755773"));  // more digits than are printed
  EXPECT_TRUE(is_rounding("2.0", "2"));
  EXPECT_FALSE(is_rounding("2", "2.6"));
}

TEST(ShownLines, AgreeInWordsAndNumbers) {
  EXPECT_TRUE(shows_line("stuck time 0.0022 s", "stuck time              0.00216334 s"));
  EXPECT_FALSE(shows_line("stuck time 0.0021 s", "stuck time              0.00216334 s"));
  EXPECT_FALSE(shows_line("slip time 0.0022 s", "stuck time 0.00216334 s"));
  EXPECT_FALSE(shows_line("multiplier 0.5", "multiplier -0.5"));
  EXPECT_FALSE(shows_line("a 1", "a 1 2"));
  EXPECT_TRUE(shows_line("a 1 ..", "a 1 2 b"));
  // Below 1e-12 there is rounding only.
  EXPECT_TRUE(shows_line("error of the balance 9.11e-19 J", "error of the balance -1.08e-19 J"));
  EXPECT_FALSE(shows_line("error of the balance 9.11e-19 J", "error of the balance 2e-9 J"));
}

TEST(ShownOutput, LeavesOutOnlyWhatItSays) {
  const std::vector<std::string> printed{"head", "", "1", "2", "3", "tail"};
  EXPECT_EQ(difference({"head", "1", "2", "3", "tail"}, printed, true), "");
  EXPECT_EQ(difference({"head", "..", "3", "tail"}, printed, true), "");
  EXPECT_EQ(difference({"..", "tail"}, printed, true), "");
  EXPECT_EQ(difference({"head", ".."}, printed, true), "");
  EXPECT_EQ(difference({"1", "2"}, printed, false), "");
  EXPECT_EQ(difference({"1", "3"}, printed, false), "not printed: 3");
  EXPECT_EQ(difference({"head", "1"}, printed, true),
            "more is printed than is shown, and no line \"..\" says so");
  EXPECT_EQ(difference({"head", "3"}, printed, true), "not printed: 3");
  EXPECT_EQ(difference({"1", "2", "3", "tail"}, printed, true), "not printed: 1");
  EXPECT_EQ(difference({"head"}, {}, true), "not printed: head");
}

TEST(CommandBlocks, AreReadAsAReaderReadsThem) {
  const std::vector<PageCommand> commands = commands_of(
      "Text.\n\n    key = 1\n\nMore.\n\n    $ build/graze check a.toml \\\n        --json\n    out "
      "1\n"
      "    ..\n    $ build/graze check b.toml\n\nIn 20.3 s.\n\n<!-- printed -->\n    part\n\n"
      "<!-- prints 20.3 impacts:5..7 -->\n\n    build/graze map\n");
  ASSERT_EQ(commands.size(), 3U);
  EXPECT_EQ(commands[0].line, 7);
  EXPECT_EQ(commands[0].text, "build/graze check a.toml \\\n    --json\n");
  EXPECT_EQ(commands[0].output, (std::vector<std::string>{"out 1", ".."}));
  EXPECT_EQ(commands[0].data, "key = 1\n");
  EXPECT_FALSE(commands[1].shows);
  EXPECT_EQ(commands[1].parts, (std::vector<std::vector<std::string>>{{"part"}}));
  EXPECT_EQ(commands[1].numbers, (std::vector<std::string>{"20.3", "impacts:5..7"}));
  EXPECT_EQ(commands[2].text, "build/graze map\n");
  EXPECT_EQ(visible_text("a <!-- b\n c --> d"), "a  d");
}

}  // namespace
}  // namespace graze::support
