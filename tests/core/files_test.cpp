#include "core/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

namespace frond {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for a test, gone after it.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("frond_files_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

TEST(WriteFile, TellsWhetherItWasWritten) {
  Folder folder;
  fs::path path = folder.path / "deep" / "file";
  EXPECT_TRUE(*write_file(path, "one"));
  EXPECT_FALSE(*write_file(path, "one"));
  EXPECT_TRUE(*write_file(path, "two"));
  EXPECT_EQ(*read_file(path), "two");
  EXPECT_EQ(files_in(path.parent_path()).size(), 1u);
}

TEST(WriteFile, AFolderInItsPlaceIsToldAndNothingLeft) {
  Folder folder;
  fs::create_directory(folder.path / "file");
  Result<bool> written = write_file(folder.path / "file", "text");
  ASSERT_FALSE(written);
  EXPECT_NE(written.errors()[0].what.find("cannot be put in place"), std::string::npos);
  EXPECT_EQ(files_in(folder.path).size(), 1u);
}

TEST(WriteFile, WhatFitsOnlyInPartIsToldAndNothingLeft) {
  Folder folder;
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  rlimit small{1000, before.rlim_max};
  auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  Result<bool> written = write_file(folder.path / "file", std::string(5000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written);
  EXPECT_TRUE(files_in(folder.path).empty());
}

TEST(WriteFile, AFullDiskIsToldInOurWords) {
  EXPECT_EQ(reason_of(std::make_error_code(std::errc::no_space_on_device)), "no room on the disk");
  EXPECT_EQ(reason_of(std::make_error_code(std::errc::permission_denied)), "Permission denied");
}

TEST(PathFrom, AFolderThatIsNotThereYetIsAsGoodAsOneThatIs) {
  Folder folder;
  fs::path before = fs::current_path();
  fs::current_path(folder.path);
  fs::path there = path_from("out/film", "preset.json"),
           whole = path_from("out/film", folder.path / "preset.json");
  fs::create_directories("out/film");
  EXPECT_EQ(there, path_from("out/film", "preset.json"));
  fs::current_path(before);
  EXPECT_EQ(there, fs::path("../../preset.json"));
  EXPECT_EQ(whole, there);
}

TEST(FilesIn, NoFolderHoldsNothing) { EXPECT_TRUE(files_in("/nowhere/at/all").empty()); }

}  // namespace
}  // namespace frond
