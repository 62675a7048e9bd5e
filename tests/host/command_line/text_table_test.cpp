#include "host/command_line/text_table.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirLongestEntryAndLinesHaveNoTrailingBlanks) {
  EXPECT_EQ(text_table({{"stage", "time"}, {"output", "1 s"}, {"all", ""}}, "lr"),
            "  stage   time\n"
            "  output   1 s\n"
            "  all\n");
}

TEST(TextTable, RowsMayBeShorterThanTheTable) {
  EXPECT_EQ(text_table({{"a", "b"}, {"long"}}, "rl"),
            "     a  b\n"
            "  long\n");
}

TEST(TextTable, LettersBeyondAsciiTakeOnePlace) {
  EXPECT_EQ(text_table({{"µs", "1"}, {"ab", "2"}}, "ll"), "  µs  1\n  ab  2\n");
}

TEST(TextTable, ControlCharactersOfEntriesAreShownAndKeepTheColumns) {
  EXPECT_EQ(text_table({{"a\nb", "1"}, {"c\x1b[2J", "2"}}, "ll"), "  a\\nb      1\n  c\\x1b[2J  2\n");
}

TEST(TextTable, NoRowsAreNoText) {
  EXPECT_EQ(text_table({}, "lr"), "");
}

}  // namespace
}  // namespace tentpole
