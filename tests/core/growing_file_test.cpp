#include "core/growing_file.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

#include "core/files.h"

namespace {
std::atomic<int> flushed = 0;
}  // namespace

/// In place of the C library's, for all that this program calls.
extern "C" int fsync(int file) {
  ++flushed;
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace frond {
namespace {

namespace fs = std::filesystem;

class GrowingFileTest : public testing::Test {
 protected:
  GrowingFileTest() { fs::remove_all(folder_); }
  ~GrowingFileTest() override { fs::remove_all(folder_); }

  Result<bool> write(std::size_t pieces) {
    GrowingFile file(folder_ / "a" / "text");
    for (std::size_t i = 0; i < pieces; ++i) file.add(std::string(1'000'000, static_cast<char>('a' + i)));
    return file.close();
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_ / "a"), {}));
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("frond_growing_file_" + std::to_string(getpid()));
};

TEST_F(GrowingFileTest, WritesShortAndLongFilesAndLeavesThemAloneWhereTheyAreTheSame) {
  for (std::size_t pieces : {0u, 1u, 11u}) {
    EXPECT_TRUE(*write(pieces)) << pieces;
    EXPECT_FALSE(*write(pieces)) << pieces;
    EXPECT_EQ(read_file(folder_ / "a" / "text")->size(), pieces * 1'000'000);
    EXPECT_EQ(files(), 1u);
  }
  EXPECT_EQ(read_file(folder_ / "a" / "text")->back(), 'k');
}

TEST_F(GrowingFileTest, LeavesNothingHalfWritten) {
  {
    GrowingFile file(folder_ / "a" / "text");
    for (int i = 0; i < 9; ++i) file.add(std::string(1'000'000, 'x'));
    EXPECT_EQ(files(), 1u);
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(GrowingFileTest, IsFlushedToDiskBeforeItIsSeenHoweverLongItIs) {
  for (std::size_t pieces : {1u, 11u}) {
    fs::remove_all(folder_);
    int before = flushed;
    ASSERT_TRUE(*write(pieces));
    EXPECT_EQ(flushed, before + 1) << pieces;
  }
}

TEST_F(GrowingFileTest, ThatCannotBeWrittenSaysWhyAndLeavesNothing) {
  ASSERT_TRUE(write_file(folder_ / "a", "no folder").ok());
  Result<bool> long_one = write(11), short_one = write(1);
  ASSERT_FALSE(long_one.ok());
  EXPECT_FALSE(short_one.ok());
  EXPECT_NE(long_one.errors()[0].what.find("cannot be written: "), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace frond
