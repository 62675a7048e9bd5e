#include "host/mesh/printable.hpp"

#include <string>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(Printable, LettersOfAllScriptsStay) {
  const std::string text = "Bruch 破壊 كسر 50 % \\ $ \"x\" 🙂";
  EXPECT_EQ(printable(text), text);
}

TEST(Printable, ControlCharactersBecomeEscapes) {
  EXPECT_EQ(printable("a\x1b[31mb\nc\td\r\x7f\x07"), "a\\x1b[31mb\\nc\\td\\r\\x7f\\x07");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"), "\\u009b");  // the one-letter start of an escape sequence
}

TEST(Printable, MarksThatTurnTheDirectionBecomeEscapes) {
  EXPECT_EQ(printable("a\u202eb\u2066c\u200fd\u2028"), "a\\u202eb\\u2066c\\u200fd\\u2028");
}

TEST(Printable, BytesThatAreNoUtf8BecomeEscapes) {
  EXPECT_EQ(printable("a\xff\xc3"), "a\\xff\\xc3");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half a character
}

TEST(Printable, LinesOfAMessageStay) {
  EXPECT_EQ(printable_lines("one\ntwo\x1b[2J\r\nthree"), "one\ntwo\\x1b[2J\\r\nthree");
}

}  // namespace
}  // namespace tentpole
