#include "host/case_file/toml_text.hpp"

#include <string>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

void expect_fault(const std::string& text, int line, int column, const std::string& reason) {
  SCOPED_TRACE(text.substr(0, 60));
  const auto fault = find_toml_text_fault(text);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->line, line);
  EXPECT_EQ(fault->column, column);
  EXPECT_NE(fault->reason.find(reason), std::string::npos) << fault->reason;
}

void expect_sound(const std::string& text) {
  const auto fault = find_toml_text_fault(text);
  EXPECT_FALSE(fault) << text.substr(0, 60) << "\n" << fault->line << ":" << fault->column << ": " << fault->reason;
}

TEST(TomlText, LettersBeyondAsciiStandInQuotationMarksAndComments) {
  expect_sound("title = \"Stoß \\\" 破\" # Übergang 🙂\nname = 'größer'\n\"Rücken\".'x' = 1\n");
  expect_sound("text = \"\"\"\nerste \\\"\"\" Zeile ß\n# kein Kommentar\"\"\"\"\" # Ende ß\nb = '''ß\n'ß''ß'''''\n");
  expect_sound("\xef\xbb\xbf[domain]\r\n");
  expect_fault("a = 1\n  größe = 2\n", 2, 5, "needs quotation marks");
  expect_fault("a = \"ß\" ß\n", 1, 9, "needs quotation marks");
  expect_fault("a = \"\"\"ß\nß\"\"\" ß", 2, 6, "needs quotation marks");
  expect_fault("a = 'ß\\' ß'", 1, 10, "needs quotation marks");    // no escapes between these
  expect_fault("a = 1\xc2\xa0\n", 1, 6, "needs quotation marks");  // a blank that does not break
}

TEST(TomlText, LettersBeyondAsciiDoNotFollowABackslash) {
  expect_fault("a = \"\"\"x\\ß\"\"\"", 1, 10, "follows a backslash");
  expect_fault("a = \"x\\  ﹿ\"", 1, 10, "follows a backslash");
  expect_fault("a = \"\"\"x \\\n\t ß\"\"\"", 2, 3, "follows a backslash");
  expect_sound("a = \"\"\"x \\\n\t yß \\\\ß \\nß\"\"\"\nb = '\\ß'\n");
  expect_sound("a = \"x\\\"\nb = \"ß\"\n");  // the text stands open: no TOML, but nothing is skipped on the next line
}

TEST(TomlText, BytesThatAreNoUtf8AreRefusedEverywhere) {
  for (const std::string bad : {"\xff", "\x80", "\xc0\xaf", "\xe2\x82", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe4"}) {
    expect_fault("a = 1\n" + bad, 2, 1, "no UTF-8");
    expect_fault("# ß" + bad + "\n", 1, 4, "no UTF-8");
    expect_fault("a = \"ß" + bad + "\"\n", 1, 7, "no UTF-8");
  }
}

TEST(TomlText, ControlCharactersOutsideOfTextsAreRefused) {
  expect_fault(std::string("a = 1\n\0b = 2", 12), 2, 1, "control character");
  expect_fault("a\x1b = 1", 1, 2, "control character");
  expect_fault("a\x7f = 1", 1, 2, "control character");
  expect_sound("\ta\t=\t1\r\n");
}

TEST(TomlText, DepthOfBracketsAndKeysIsBounded) {
  const int most = deepest_toml_nesting;
  expect_sound("a = " + repeated("[", most) + repeated("]", most) + "\nb = " + repeated("{c=", most - 1) + "1" +
               repeated("}", most - 1));
  expect_fault("a = " + repeated("[", most + 1), 1, 5 + most, "nested more than 20 deep");
  expect_fault("a = " + repeated("[\n", 20000), most + 1, 1, "nested more than 20 deep");
  expect_fault("a = " + repeated("{b=", 20000), 1, 5 + 3 * most, "nested more than 20 deep");
  expect_fault(repeated("[", 20000), 1, 1 + most, "nested more than 20 deep");
  expect_sound(repeated("a.", most - 1) + "a = 1\n[" + repeated("b.", most - 1) + "b]\n");
  expect_fault(repeated("a.", 20000) + "a = 1\n", 1, 2 * most, "a key of more than 20 parts");
  expect_fault("x = 1\n[" + repeated("a . ", 20000), 2, 4 * most, "a key of more than 20 parts");
  expect_fault("x = { " + repeated("\"a\".", 20000), 1, 6 + 4 * most, "a key of more than 20 parts");
}

TEST(TomlText, DotsAndBracketsSideBySideAreNoDepth) {
  expect_sound("a = [" + repeated("[1.0, 2.0], {b = 3.5},\n", 20000) + "]\n");
  expect_sound(repeated("[a.b.c]\nd.e = 1.5\n[[f]]\n", 20000));
  expect_sound("a = \"" + repeated("[{.", 20000) + "\" # " + repeated("[{.", 20000) + "\nb = '" + repeated("[.", 100) +
               "'");
  expect_sound(repeated("[a\n", 20000));  // no TOML, but not deep: a header ends with its line
}

}  // namespace
}  // namespace tentpole
