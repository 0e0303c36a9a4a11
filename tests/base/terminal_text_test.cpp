#include "graze/base/terminal_text.hpp"

#include <gtest/gtest.h>

namespace graze {
namespace {

TEST(TerminalText, LeavesWhatIsOnlyShown) {
  const std::string text = "beam \xC3\xA9, \xE6\xA2\x81 \xF0\x9F\x8E\xB8\n\tw = 3 \\ \"x\"";
  EXPECT_EQ(terminal_text(text), text);
  EXPECT_EQ(terminal_json(text), text);
  EXPECT_EQ(terminal_text(""), "");
}

TEST(TerminalText, EscapesWhatWouldBeObeyed) {
  EXPECT_EQ(terminal_text("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(terminal_text("\x7f\r\x07"), "\\x7f\\x0d\\x07");
  EXPECT_EQ(terminal_text("\xC2\x9B"
                          "31m"),
            "\\u009b31m");                              // CSI as one character
  EXPECT_EQ(terminal_text("\xE2\x80\xAE"), "\\u202e");  // right to left
  EXPECT_EQ(terminal_line("a\nb\tc"), "a\\nb\\tc");
  EXPECT_EQ(terminal_json("\"\xC2\x9B\x7f\"\n"), "\"\\u009b\\u007f\"\n");
}

TEST(TerminalText, EscapesBytesThatAreNoCharacters) {
  EXPECT_EQ(terminal_text("\x9b"
                          "31m"),
            "\\x9b31m");                                        // CSI of an 8-bit terminal
  EXPECT_EQ(terminal_text("\xC0\x9B"), "\\xc0\\x9b");           // overlong
  EXPECT_EQ(terminal_text("\xE2\x80"), "\\xe2\\x80");           // cut off
  EXPECT_EQ(terminal_text("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(terminal_text("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

}  // namespace
}  // namespace graze
