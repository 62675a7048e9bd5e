#include "host/mesh/toml_name.hpp"

#include <gtest/gtest.h>

namespace tentpole {
namespace {

TEST(TomlName, BareKeysStayAsTheyAre) {
  for (const char* name : {"left", "Steel_2", "grain-17", "42"}) EXPECT_EQ(toml_key(name), name);
}

TEST(TomlName, OtherKeysAreQuoted) {
  EXPECT_EQ(toml_key("Mechanically clamped"), "\"Mechanically clamped\"");
  EXPECT_EQ(toml_key("freie Oberfläche"), "\"freie Oberfläche\"");
  EXPECT_EQ(toml_key("Größe"), "\"Größe\"");
  EXPECT_EQ(toml_key("a.b"), "\"a.b\"");
  EXPECT_EQ(toml_key(""), "\"\"");
}

TEST(TomlName, QuotationMarksBackslashesAndControlCharactersAreEscaped) {
  EXPECT_EQ(toml_key("3\" pipe"), "\"3\\\" pipe\"");
  EXPECT_EQ(toml_string("C:\\mesh"), "\"C:\\\\mesh\"");
  EXPECT_EQ(toml_string("a\tb\x7f"), "\"a\\u0009b\\u007F\"");
  EXPECT_EQ(toml_string("left"), "\"left\"");
}

}  // namespace
}  // namespace tentpole
