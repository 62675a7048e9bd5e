#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/case_file/case.hpp"
#include "tests/temporary_folder.hpp"

/// Every file in broken/ begins with the errors that it must cause, one a line, and nothing else may be reported:
///   # error on line 9: fragment of the message          (line 0: the fault has no line)

namespace tentpole {
namespace {

struct ExpectedError {
  int line;
  std::string fragment;
};

const std::string folder = TENTPOLE_TEST_DATA "/broken/";

/// Names without extension, sorted.
std::vector<std::string> broken_cases() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(TENTPOLE_TEST_DATA "/broken"))
    names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<ExpectedError> expected_errors(const std::string& path) {
  const std::string start = "# error on line ";
  std::vector<ExpectedError> expected;
  std::ifstream stream(path);
  for (std::string text; std::getline(stream, text) && text.starts_with(start);) {
    const auto colon = text.find(": ");
    expected.push_back({std::stoi(text.substr(start.size())), text.substr(colon + 2)});
  }
  return expected;
}

class BrokenCase : public testing::TestWithParam<std::string> {};

TEST_P(BrokenCase, IsReportedWithLineKeyAndReasonAndNothingElse) {
  const std::string path = folder + GetParam() + ".toml";
  const std::vector<ExpectedError> expected = expected_errors(path);
  ASSERT_FALSE(expected.empty());
  try {
    read_case(path);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), expected.size()) << error.what();
    for (const ExpectedError& item : expected) {
      const bool found = std::any_of(error.problems().begin(), error.problems().end(), [&](const Problem& problem) {
        return problem.location.line == item.line && to_string(problem).find(item.fragment) != std::string::npos;
      });
      EXPECT_TRUE(found) << "line " << item.line << ": " << item.fragment << "\nnot in\n" << error.what();
    }
    EXPECT_TRUE(std::string(error.what()).starts_with(path)) << error.what();
  }
}

std::string case_name(const testing::TestParamInfo<std::string>& parameter) {
  return parameter.param;
}
INSTANTIATE_TEST_SUITE_P(Files, BrokenCase, testing::ValuesIn(broken_cases()), case_name);

TEST(BrokenCaseMessage, ProblemsAreOrderedByLine) {
  try {
    read_case(TENTPOLE_TEST_DATA "/broken/many_problems_at_once.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const auto& problems = error.problems();
    EXPECT_TRUE(std::is_sorted(problems.begin(), problems.end(),
                               [](const Problem& a, const Problem& b) { return a.location.line < b.location.line; }));
  }
}

TEST(BrokenCaseMessage, SyntaxErrorsNameTheColumn) {
  try {
    read_case(TENTPOLE_TEST_DATA "/broken/syntax_error.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("syntax_error.toml:23:10: this is not TOML"), std::string::npos)
        << error.what();
  }
}

std::string refusal(const std::string& path, const std::vector<std::string>& overrides = {}) {
  try {
    read_case(path, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusal_of_text(const std::string& text) {
  const TemporaryFolder temporary;
  const std::string message = refusal(temporary.write("broken.toml", text));
  const auto name = message.find(".toml");
  return name == std::string::npos ? message : message.substr(name);
}

TEST(BrokenCaseMessage, WhatTheParserCannotBearIsRefusedBeforeItWithLineAndColumn) {
  std::string deep = "title = \"ß\"\na";
  for (int i = 0; i < 20000; ++i) deep += ".a";
  EXPECT_EQ(refusal_of_text(deep + " = 1\n"),
            ".toml:2:40: this is not TOML: a key of more than 20 parts. Remove parts; no key of a case has that many.");
  EXPECT_EQ(
      refusal_of_text("a = 1\n" + std::string(100000, '[')),
      ".toml:2:21: this is not TOML: brackets are nested more than 20 deep. Close those that stand open, or write "
      "fewer of them.");
  EXPECT_EQ(refusal_of_text("[boundary]\ngröße = 1\n"),
            ".toml:2:3: this is not TOML: a letter beyond ASCII needs quotation marks here. Put the name or text into "
            "\"...\".");
  EXPECT_EQ(refusal_of_text("title = \"\xe4\"\n"),
            ".toml:1:10: this is not TOML: this byte is no UTF-8, which TOML is written in. Save the file as UTF-8.");
  EXPECT_EQ(refusal_of_text(std::string(17'000'000, '#')),
            ".toml: has more than 16 MB, so it is no case. Give the path "
            "of a TOML file.");
}

TEST(BrokenCaseMessage, OverridesAreNoDeeperThanFiles) {
  const std::string path = TENTPOLE_TEST_DATA "/valid/three_dimensions.toml";
  std::string plain = "a", quoted = "\"a\"", brackets = "title=";
  for (int i = 0; i < 20000; ++i) {
    plain += ".a";
    quoted += ".\"a\"";
    brackets += "[";
  }
  for (const std::string& deep : {plain, quoted})
    EXPECT_NE(refusal(path, {deep + "=1"}).find("is no override"), std::string::npos);
  EXPECT_EQ(read_case(path, {brackets}).title, brackets.substr(6)) << "a text that is no TOML";
}

TEST(BrokenCaseMessage, FileThatDoesNotExistIsNamed) {
  try {
    read_case("no_such_case.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "no_such_case.toml: is not a readable file with text in it. Give the path of a TOML file.");
  }
}

}  // namespace
}  // namespace tentpole
