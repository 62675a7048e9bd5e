#include "host/output/csv_file.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/temporary_folder.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

TEST(CsvFile, ReplacesAnOlderFileAndGrows) {
  const TemporaryFolder root;
  root.write("t.csv", "old\n");
  CsvFile file(root.path(), "t.csv", "a,b");
  file.append("1,2\n");
  file.append("3,4\n5,6\n");
  EXPECT_EQ(root.read("t.csv"), "a,b\n1,2\n3,4\n5,6\n");
}

TEST(CsvFile, LoadedOneGoesOnWhereItWasSaved) {
  const TemporaryFolder root;
  std::stringstream checkpoint;
  CsvFile first(root.path(), "t.csv", "a");
  first.append("1\n");
  first.save(checkpoint);
  first.append("2\n");
  CsvFile second(root.path(), "t.csv", "a");
  second.load(checkpoint);
  EXPECT_EQ(root.read("t.csv"), "a\n1\n2\n") << "nothing is touched before the first row";
  second.append("3\n");
  second.append("4\n");
  EXPECT_EQ(root.read("t.csv"), "a\n1\n3\n4\n");
}

/// A table in r/t.csv with a row, then `change`, then another row: what the second one meets.
template <class Change>
std::string loss(const TemporaryFolder& root, const Change& change) {
  const fs::path folder = root.path() / "r";
  fs::create_directory(folder);
  CsvFile file(folder, "t.csv", "a");
  file.append("1\n");
  change(folder);
  try {
    file.append("2\n");
  } catch (const FolderLost& error) {
    return error.what();
  }
  return "written";
}

TEST(CsvFile, NeverWritesIntoAFolderOrFileThatIsAnothers) {
  const auto replace_folder = [](const fs::path& folder) {
    fs::rename(folder, folder.string() + ".1");
    fs::create_directory(folder);
    std::ofstream(folder / "t.csv") << "a\nx\n";
  };
  {
    const TemporaryFolder root;
    const std::string message = loss(root, replace_folder);
    EXPECT_NE(message.find("r: another folder has taken the place of the run's result folder"), std::string::npos)
        << message;
    EXPECT_EQ(root.read("r/t.csv"), "a\nx\n");
    EXPECT_EQ(root.read("r.1/t.csv"), "a\n1\n");
  }
  {
    const TemporaryFolder root;
    EXPECT_NE(loss(root, [](const fs::path& folder) { fs::remove_all(folder); })
                  .find("the result folder was deleted or moved"),
              std::string::npos);
    EXPECT_TRUE(fs::is_empty(root.path()));
  }
  {
    const TemporaryFolder root;
    EXPECT_NE(loss(root, [](const fs::path& folder) { fs::remove(folder / "t.csv"); }).find("it was deleted"),
              std::string::npos);
    EXPECT_FALSE(fs::exists(root.path() / "r/t.csv"));
  }
  {
    const TemporaryFolder root;
    const auto replace_file = [](const fs::path& folder) {
      std::ofstream(folder / "new") << "a\nx\n";
      fs::rename(folder / "new", folder / "t.csv");
    };
    EXPECT_NE(loss(root, replace_file).find("another file has taken its place"), std::string::npos);
    EXPECT_EQ(root.read("r/t.csv"), "a\nx\n");
  }
  {
    const TemporaryFolder root;
    const auto write_row = [](const fs::path& folder) { std::ofstream(folder / "t.csv", std::ios::app) << "x\n"; };
    EXPECT_NE(loss(root, write_row).find("the run wrote 4 bytes and it has 6"), std::string::npos);
    EXPECT_EQ(root.read("r/t.csv"), "a\n1\nx\n");
  }
}

TEST(WrittenFiles, ThatAreMissingOrTooShortAreNamed) {
  const TemporaryFolder root;
  root.write("whole", "1234");
  root.write("short", "123");
  WrittenFiles files{{root.path() / "whole", 4}};
  EXPECT_NO_THROW(require_written(files));
  files.push_back({root.path() / "short", 4});
  for (int number = 0; number < 6; ++number) files.push_back({root.path() / ("gone" + std::to_string(number))});
  try {
    require_written(files);
    FAIL() << "nothing is missing";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    for (const std::string text : {"short has 3 bytes of 4", "gone0 is missing", "gone3 is missing", "and 2 more"})
      EXPECT_NE(message.find(text), std::string::npos) << text << ": " << message;
    EXPECT_EQ(message.find("whole has"), std::string::npos);
  }
}

}  // namespace
}  // namespace tentpole
