#include "core/assets.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/files.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// A folder of files for one test.
class AssetsTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    top_ = fs::temp_directory_path() / ("frond_assets_" + std::to_string(getpid()) + test->name());
    fs::remove_all(top_);
    for (const char* file : {"mine/a.obj", "mine/deep/b.obj", "shared/c.obj", "secret/key"})
      ASSERT_TRUE(write_file(top_ / file, file).ok());
    fs::create_symlink(top_ / "secret/key", top_ / "mine/link.obj");
    fs::create_directory_symlink(top_ / "secret", top_ / "mine/folder");
    fs::create_directory_symlink(top_ / "shared", top_ / "mine/good");
    fs::create_directories(top_ / "mine2");
    ASSERT_TRUE(write_file(top_ / "mine2/d.obj", "mine2/d.obj").ok());
  }
  void TearDown() override { fs::remove_all(top_); }

  std::string read(const Assets& assets, const std::string& name) {
    Result<NamedFile> file = assets.read(name);
    return file ? file->text : "error: " + file.errors().front().text();
  }

  fs::path top_;
};

TEST_F(AssetsTest, NamesTheFoldersInWhichItLooked) {
  std::string here = fs::current_path().string();
  EXPECT_EQ(
      read(Assets(top_ / "mine/preset.json"), "none.obj"),
      "error: there is no file \"none.obj\"; looked for in " + (top_ / "mine").string() + " and in " + here);
  // A preset in the working folder is named without one.
  EXPECT_EQ(read(Assets("preset.json"), "none.obj"),
            "error: there is no file \"none.obj\"; looked for in " + here);
  EXPECT_EQ(Assets("preset.json").read("none.obj", "").errors()[0].what,
            "there is no file \"none.obj\"; looked for in " + here);
}

TEST_F(AssetsTest, WithAFolderOfAssetsNothingElseIsRead) {
  Assets assets(top_ / "mine/preset.json", top_ / "shared");
  EXPECT_EQ(read(assets, "a.obj"), "mine/a.obj");
  EXPECT_EQ(read(assets, "deep/../deep/b.obj"), "mine/deep/b.obj");
  EXPECT_EQ(read(assets, "c.obj"), "shared/c.obj") << "assets are looked for there too";
  EXPECT_EQ(read(assets, "../shared/c.obj"), "shared/c.obj");
  EXPECT_EQ(read(assets, "good/c.obj"), "shared/c.obj") << "a link within";
  for (std::string name : {"../secret/key", "link.obj", "folder/key", "../mine2/d.obj",
                           "deep/../../secret/key", "/etc/passwd", "../secret/nothing"}) {
    std::string said = read(assets, name);
    EXPECT_TRUE(said.ends_with("\" lies outside of what may be read; expected a file below " +
                               (top_ / "mine").string() + " or " + (top_ / "shared").string()))
        << said;
  }
  EXPECT_TRUE(read(assets, (top_ / "secret/key").string()).starts_with("error: "));
  EXPECT_EQ(read(assets, std::string("../secret/key\0/../../mine/a.obj", 32)),
            "error: no file has a zero byte in its name");
}

TEST_F(AssetsTest, WithoutThatFolderEveryFileIsRead) {
  Assets assets(top_ / "mine/preset.json");
  EXPECT_EQ(read(assets, "../secret/key"), "secret/key");
  EXPECT_EQ(read(assets, "link.obj"), "secret/key");
  EXPECT_EQ(read(assets, (top_ / "shared/c.obj").string()), "shared/c.obj");
}

TEST_F(AssetsTest, SaysWhereItLooked) {
  EXPECT_EQ(
      read(Assets("presets/x.json"), "none.obj"),
      "error: there is no file \"none.obj\"; looked for in presets and in " + fs::current_path().string());
  EXPECT_EQ(read(Assets("x.json"), "/no/such"), "error: there is no file /no/such");
  EXPECT_EQ(read(Assets("x.json", "lib"), "none.obj").substr(0, 28), "error: there is no file \"non")
      << "lib";
}

}  // namespace
}  // namespace frond
