#include "host/command_line/result_folder.hpp"

#include <gtest/gtest.h>

#include "host/case_file/input_error.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

TEST(ResultFolder, IsNamedAfterTheCaseAndLiesInTheCurrentFolder) {
  EXPECT_EQ(default_result_folder("some/where/bar.toml"), "result_bar");
  EXPECT_EQ(default_result_folder("plate.v2.toml"), "result_plate.v2");
}

TEST(ResultFolder, IsCreatedWithItsParents) {
  const TemporaryFolder root;
  const PreparedFolder folder = prepare_result_folder(root.path() / "a/b/");
  EXPECT_EQ(folder.path, root.path() / "a/b");
  EXPECT_FALSE(folder.moved_aside);
  EXPECT_FALSE(holds_result(folder.path));
}

TEST(ResultFolder, OlderResultsMoveToTheFirstFreeNumber) {
  const TemporaryFolder root;
  root.write("r.1/notes.txt", "kept");
  for (const char* text : {"first", "second"}) {
    root.write("r/summary.json", text);
    const PreparedFolder folder = prepare_result_folder(root.path() / "r/");
    EXPECT_FALSE(holds_result(folder.path));
    ASSERT_TRUE(folder.moved_aside);
    EXPECT_FALSE(fs::exists(*folder.moved_aside / FolderLock::file_name));
  }
  EXPECT_EQ(fs::file_size(root.path() / "r.2/summary.json"), 5u);
  EXPECT_EQ(fs::file_size(root.path() / "r.3/summary.json"), 6u);
  EXPECT_TRUE(fs::exists(root.path() / "r.1/notes.txt"));
}

TEST(ResultFolder, OfALivingRunIsRefusedAndStaysWhereItIs) {
  const TemporaryFolder root;
  const PreparedFolder folder = prepare_result_folder(root.path() / "r");
  for (const bool has_result : {false, true}) {
    if (has_result) root.write("r/history.csv", "time\n");
    EXPECT_THROW(prepare_result_folder(root.path() / "r"), InputError);
    EXPECT_THROW(reopen_result_folder(root.path() / "r"), InputError);
    EXPECT_FALSE(fs::exists(root.path() / "r.1"));
  }
  folder.lock.require();
}

TEST(ResultFolder, WithTheLockOfADeadRunAndNothingElseIsUsed) {
  const TemporaryFolder root;
  root.write("r/.lock", "noise");
  EXPECT_FALSE(prepare_result_folder(root.path() / "r").moved_aside);
}

TEST(ResultFolder, WhatAKilledRunLeavesCountsAsAResult) {
  for (const char* name :
       {"history.csv", "probe_mid.csv", "snapshot_0000.vtkhdf", "checkpoint.h5", "cracks_0000.vtkhdf",
        ".snapshot_0000.vtkhdf.partial", ".cracks_0000.vtkhdf.partial", ".checkpoint.h5.partial"}) {
    const TemporaryFolder root;
    root.write(name, "x");
    EXPECT_TRUE(holds_result(root.path())) << name;
  }
}

TEST(ResultFolder, FoldersWithOtherFilesAreRefusedAndKept) {
  const TemporaryFolder root;
  const fs::path file = root.write("thesis/chapter.tex", "work");
  EXPECT_THROW(prepare_result_folder(root.path() / "thesis"), InputError);
  EXPECT_THROW(prepare_result_folder(file), InputError);
  EXPECT_EQ(fs::file_size(file), 4u);
}

TEST(ResultFolder, FolderThatCannotBeCreatedIsAnErrorThatNamesIt) {
  const TemporaryFolder root;
  const fs::path folder = root.write("file", "x") / "result";
  try {
    prepare_result_folder(folder);
    FAIL() << "a folder below a file was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(folder.string()), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tentpole
