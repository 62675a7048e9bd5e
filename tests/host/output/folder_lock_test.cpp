#include "host/output/folder_lock.hpp"

#include <csignal>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/case_file/input_error.hpp"
#include "host/output/file_identity.hpp"
#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& folder) {
  try {
    const FolderLock lock(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

TEST(FolderLock, RefusesASecondOwnerAndNamesTheFirst) {
  const TemporaryFolder folder;
  const FolderLock lock(folder.path());
  const std::string message = refusal(folder.path()), owner = owner_text(*parse_lock_record(folder.read(".lock")));
  EXPECT_NE(message.find(folder.path().string() + ": another run works in this folder"), std::string::npos) << message;
  EXPECT_NE(message.find(owner), std::string::npos) << message;
  EXPECT_NE(owner.find("process " + std::to_string(getpid()) + " of "), std::string::npos) << owner;
  lock.require();
}

TEST(FolderLock, LeavesNothingBehind) {
  const TemporaryFolder folder;
  {
    FolderLock lock(folder.path());
    const FolderLock moved = std::move(lock);
    EXPECT_FALSE(fs::is_empty(folder.path()));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_EQ(refusal(folder.path()), "taken");
}

TEST(FolderLock, DiesWithItsProcess) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const FolderLock lock(folder.path());
    [[maybe_unused]] const auto told = write(ready[1], "x", 1);
    pause();
  }
  char byte;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_NE(refusal(folder.path()).find("process " + std::to_string(child)), std::string::npos);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(ready[0]);
  close(ready[1]);
  ASSERT_TRUE(fs::exists(folder.path() / ".lock"));
  EXPECT_EQ(refusal(folder.path()), "taken");
}

/// What require() says after `change`.
template <class Change>
std::string loss(const Change& change) {
  const TemporaryFolder root;
  const fs::path folder = root.path() / "r";
  fs::create_directory(folder);
  const FolderLock lock(folder);
  change(folder);
  try {
    lock.require();
  } catch (const FolderLost& error) {
    return error.what();
  }
  return "kept";
}

TEST(FolderLock, NoticesThatTheFolderIsAnothersByNow) {
  EXPECT_EQ(loss([](const fs::path&) {}), "kept");
  EXPECT_NE(loss([](const fs::path& folder) { fs::remove_all(folder); }).find("r: the result folder was deleted"),
            std::string::npos);
  const auto replace = [](const fs::path& folder) {
    fs::rename(folder, folder.string() + ".1");
    fs::create_directory(folder);
  };
  EXPECT_NE(loss(replace).find("r: another folder has taken the place"), std::string::npos);
  const auto lose_file = [](const fs::path& folder) { fs::remove(folder / ".lock"); };
  EXPECT_NE(loss(lose_file).find("r/.lock was deleted"), std::string::npos);
  const auto take_over = [](const fs::path& folder) {
    LockRecord other = own_lock_record();
    other.host = "elsewhere";
    fs::remove(folder / ".lock");
    std::ofstream(folder / ".lock") << lock_record_text(other);
  };
  EXPECT_NE(loss(take_over).find("r: another run has taken over the result folder (process "), std::string::npos);
  EXPECT_NE(loss(take_over).find(" of elsewhere, "), std::string::npos);
}

TEST(LockRecord, IsReadBackWholeOrNotAtAll) {
  const LockRecord record{"node 17", 4711, "2026-12-01 10:22:33 UTC", "b7", "pid:[1]", 123456789012};
  const std::string text = lock_record_text(record);
  EXPECT_EQ(parse_lock_record(text), record);
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_FALSE(parse_lock_record(text.substr(0, length))) << length;
  EXPECT_FALSE(parse_lock_record("noise\n" + text));
}

TEST(LockRecord, TellsWhetherItsProcessLivesWhereThatCanBeTold) {
  const LockRecord own = own_lock_record();
  EXPECT_EQ(life_of(own, own), Life::alive);
  const auto changed = [&](auto LockRecord::*member, const auto& value) {
    LockRecord record = own;
    record.*member = value;
    return record;
  };
  EXPECT_EQ(life_of(changed(&LockRecord::ticks, own.ticks + 1), own), Life::dead) << "a later process of that number";
  EXPECT_EQ(life_of(changed(&LockRecord::process, std::int64_t{1} << 30), own), Life::dead) << "no such process";
  EXPECT_EQ(life_of(changed(&LockRecord::boot, "earlier"), own), Life::dead) << "the machine was restarted";
  EXPECT_EQ(life_of(changed(&LockRecord::process_space, "pid:[7]"), own), Life::unknown) << "another container";
  LockRecord elsewhere = changed(&LockRecord::boot, "other");
  elsewhere.host += "2";
  EXPECT_EQ(life_of(elsewhere, own), Life::unknown);
  EXPECT_EQ(life_of(changed(&LockRecord::host, own.host + "2"), own), Life::alive) << "a container's name";
}

}  // namespace
}  // namespace tentpole
