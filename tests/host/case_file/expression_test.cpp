#include "host/case_file/expression.hpp"

#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

namespace tentpole {
namespace {

const SourceLocation place{"case.toml", 7, 0, "boundary.left.normal_velocity", "\"...\""};

TEST(Expression, KnowsCoordinatesTimePiAndConstants) {
  Expression expression("V*sin(pi*x) + 10*y - z^2 + t/2", {{"V", 6.1}}, place);
  EXPECT_DOUBLE_EQ(expression.evaluate({0.25, 2, 3}, 5), 6.1 * std::sin(std::numbers::pi / 4) + 20 - 9 + 2.5);
  EXPECT_FALSE(expression.is_constant());
}

TEST(Expression, ConditionsSwitchInTime) {
  Expression expression("t < 2 && x >= 0 ? 1 : 0", {}, place);
  EXPECT_EQ(expression.evaluate({}, 1.9), 1);
  EXPECT_EQ(expression.evaluate({}, 2), 0);
}

TEST(Expression, ConstantTextIsFoldedAndZeroIsSeen) {
  EXPECT_TRUE(Expression("0*V", {{"V", 3}}, place).is_zero());
  EXPECT_TRUE(Expression().is_zero());
  EXPECT_TRUE(Expression("2*V", {{"V", 3}}, place).is_constant());
  EXPECT_EQ(Expression("2*V", {{"V", 3}}, place).evaluate({1, 2, 3}, 4), 6);
  EXPECT_FALSE(Expression("0*x", {}, place).is_zero());
  EXPECT_EQ(Expression(0.7).text(), "0.7");
}

TEST(Expression, CopiesHaveTheirOwnVariables) {
  Expression first("x + t", {}, place);
  Expression second = first;
  Expression third;
  third = second;
  EXPECT_EQ(first.evaluate({1}, 2), 3);
  EXPECT_EQ(second.evaluate({10}, 20), 30);
  Expression moved = std::move(first);
  EXPECT_EQ(moved.evaluate({5}, 5), 10);
  EXPECT_EQ(third.evaluate({100}, 200), 300);
}

TEST(Expression, CopiesMayBeEvaluatedByDifferentThreads) {
  const Expression shared("x*x + sin(t)", {}, place);
  const auto work = [&](double offset, bool& correct) {
    Expression own = shared;
    correct = true;
    for (int i = 0; i < 20000; ++i) {
      const double x = offset + i;
      correct = correct && own.evaluate({x}, x) == x * x + std::sin(x);
    }
  };
  bool first_correct = false, second_correct = false;
  std::thread first(work, 0.0, std::ref(first_correct)), second(work, 0.5, std::ref(second_correct));
  first.join();
  second.join();
  EXPECT_TRUE(first_correct && second_correct);
}

TEST(Expression, ValueThatIsNotFiniteNamesKeyPointAndTime) {
  Expression expression("1/(t - 1)", {}, place);
  EXPECT_EQ(expression.evaluate({}, 2), 1);
  try {
    expression.evaluate({0.5, 0.25, 0}, 1);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "case.toml:7: boundary.left.normal_velocity = \"...\": is inf at (x, y, z) = (0.5, 0.25, 0) m, t = 1 s. "
        "Change the expression so that it is finite there.");
  }
}

TEST(Expression, AcceptsComparisonsButNoAssignment) {
  EXPECT_EQ(Expression("1 <= 2", {}, place).evaluate({}, 0), 1);
  EXPECT_EQ(Expression("3 == 3", {}, place).evaluate({}, 0), 1);
  EXPECT_EQ(Expression("3 != 3", {}, place).evaluate({}, 0), 0);
  EXPECT_THROW(Expression("x = 3", {}, place), InputError);
  EXPECT_THROW(Expression("x += 3", {}, place), InputError);
}

TEST(Expression, NamesOfFunctionsAndCoordinatesAreReserved) {
  EXPECT_TRUE(is_reserved_name("t"));
  EXPECT_TRUE(is_reserved_name("pi"));
  EXPECT_TRUE(is_reserved_name("sqrt"));
  EXPECT_FALSE(is_reserved_name("V"));
}

TEST(VectorExpression, MissingComponentsAreZero) {
  VectorExpression vector({Expression("x", {}, place), Expression(2.0)});
  EXPECT_EQ(vector.evaluate({4, 0, 0}, 0), (std::array<double, 3>{4, 2, 0}));
  EXPECT_FALSE(vector.is_zero());
  EXPECT_TRUE(VectorExpression({Expression(), Expression()}).is_zero());
}

TEST(Expression, NamesInATextAreSortedAndNumbersAreNone) {
  EXPECT_EQ(names_in("V*sin(x_1) + 1e5*V - 1.e5 - .5E3 + _a2"), (std::vector<std::string>{"V", "_a2", "sin", "x_1"}));
  EXPECT_TRUE(names_in("1 + 2 * (3.5)").empty());
}

}  // namespace
}  // namespace tentpole
