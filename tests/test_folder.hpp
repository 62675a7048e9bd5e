#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/temporary_folder.hpp"

namespace tentpole {

/// An empty folder of the running test and of this process; a second call with the same name empties it. It stays until
/// the process ends.
inline std::filesystem::path test_folder(const std::string& name) {
  static const TemporaryFolder root;
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string unique = std::string(test->test_suite_name()) + "." + test->name() + "." + name;
  std::replace(unique.begin(), unique.end(), '/', '_');
  const std::filesystem::path folder = root.path() / unique;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace tentpole
