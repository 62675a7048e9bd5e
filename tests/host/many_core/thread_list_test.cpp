#include "host/many_core/thread_list.hpp"

#include <gtest/gtest.h>

#include "host/case_file/input_error.hpp"

namespace tentpole {
namespace {

TEST(ThreadList, HoldsNumbersAndRangesInAscendingOrder) {
  EXPECT_EQ(parse_thread_list("4"), std::vector<int>{4});
  EXPECT_EQ(parse_thread_list("1-4"), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(parse_thread_list("30,1,2,4-6,5"), (std::vector<int>{1, 2, 4, 5, 6, 30}));
  EXPECT_EQ(parse_thread_list("1-4096").size(), 4096u);
}

TEST(ThreadList, RefusesAnythingElseAndNamesThePart) {
  for (const char* text : {"", ",", "1,", "1,,2", "0", "0-3", "-1", "1-", "5-2", "1-2-3", "two", "1.5", "4097",
                           "1-5000", "99999999999999999999", " 1", "1;2", "+3"}) {
    try {
      parse_thread_list(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("--threads " + std::string(text) + ": "), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("e.g. 1-120 or 1,2,4-8."), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace tentpole
