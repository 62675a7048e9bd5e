#include "host/output/output_folder.hpp"

#include <gtest/gtest.h>

#include "host/output/atomic_file.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// Another folder with a file of its own takes the place of root/r.
void replace(const TemporaryFolder& root) {
  fs::rename(root.path() / "r", root.path() / "moved");
  fs::create_directory(root.path() / "r");
  root.write("r/a.txt", "another's");
}

class ClaimedFolder : public testing::Test {
 protected:
  ClaimedFolder() {
    fs::create_directory(root_.path() / "r");
    copy_.claim();
  }
  void expect_lost(const std::function<void()>& write, const std::string& part) {
    try {
      write();
      FAIL() << "written";
    } catch (const FolderLost& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }

  const TemporaryFolder root_;
  const OutputFolder folder_{root_.path() / "r"};
  const OutputFolder copy_ = folder_;
};

TEST_F(ClaimedFolder, TakesFilesWhileItIsTheSame) {
  replace_text_file(folder_, "a.txt", "old");
  replace_text_file(folder_, "a.txt", "new");
  EXPECT_EQ(root_.read("r/a.txt"), "new");
  EXPECT_FALSE(fs::exists(root_.path() / "r" / partial_name("a.txt")));
}

TEST_F(ClaimedFolder, IsLostToAnotherFolderOfItsName) {
  replace(root_);
  expect_lost([&] { replace_text_file(folder_, "a.txt", "mine"); }, "r: another folder has taken the place");
  EXPECT_EQ(root_.read("r/a.txt"), "another's");
}

TEST_F(ClaimedFolder, IsLostWhileAFileIsWritten) {
  const auto write = [&](const fs::path& partial) {
    std::ofstream(partial) << "mine";
    replace(root_);
  };
  expect_lost([&] { replace_file(folder_, "a.txt", write); }, "r: another folder has taken the place");
  EXPECT_EQ(root_.read("r/a.txt"), "another's");
  EXPECT_FALSE(fs::exists(root_.path() / "moved/a.txt"));
}

TEST_F(ClaimedFolder, IsLostWhereItIsDeleted) {
  fs::remove(root_.path() / "r");
  expect_lost([&] { replace_text_file(folder_, "a.txt", "mine"); }, "r: the result folder was deleted or moved");
  EXPECT_TRUE(fs::is_empty(root_.path()));
}

TEST(OutputFolder, ThatNobodyClaimedIsClaimedByTheFirstFile) {
  const TemporaryFolder root;
  fs::create_directory(root.path() / "r");
  const OutputFolder folder(root.path() / "r");
  replace_text_file(folder, "b.txt", "mine");
  replace(root);
  EXPECT_THROW(replace_text_file(folder, "a.txt", "mine"), FolderLost);
}

}  // namespace
}  // namespace tentpole
