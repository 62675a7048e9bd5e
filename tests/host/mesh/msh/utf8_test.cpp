#include "host/mesh/msh/utf8.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(Utf8, StaysAsItIs) {
  for (const char* text : {"", "plate", "Oberfläche", "板", "\xf0\x9f\x94\xa9", "\xf4\x8f\xbf\xbf", "\xee\x80\x80"})
    EXPECT_EQ(as_utf8(text), text);
}

TEST(Utf8, AnythingElseIsReadAsLatin1) {
  EXPECT_EQ(as_utf8("Oberfl\xe4"
                    "che"),
            "Oberfläche");
  EXPECT_EQ(as_utf8("N\xba"
                    "1"),
            "Nº1");
  EXPECT_EQ(as_utf8("\xff"), "ÿ");
  EXPECT_EQ(as_utf8("a\xc3"), "aÃ");                        // the first half of a character
  EXPECT_EQ(as_utf8("\xc0\xaf"), "À¯");                     // overlong
  EXPECT_EQ(as_utf8("\xed\xa0\x80"), "í\xc2\xa0\xc2\x80");  // a surrogate
  EXPECT_EQ(as_utf8("\xf4\x90\x80\x80"), "ô\xc2\x90\xc2\x80\xc2\x80");
}

}  // namespace
}  // namespace tentpole
