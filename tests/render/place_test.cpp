#include "render/place.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "images/raster.h"

namespace frond {

namespace fs = std::filesystem;

class Place : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(::testing::TempDir()) /
             (std::string("place_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder;
};

TEST_F(Place, AFileIsReplacedAndIsNewThoughItHeldTheSame) {
  fs::path file = folder / "film.mp4", part = part_of(file);
  EXPECT_EQ(part, folder / ".film.mp4.part");
  EXPECT_TRUE(put_text(part, file, "text").empty());
  auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(file, old);
  EXPECT_TRUE(put_text(part_of(file), file, "text").empty());
  EXPECT_GT(fs::last_write_time(file), old);
  EXPECT_EQ(*read_file(file), "text");
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(Place, NoLinkIsFollowed) {
  fs::path precious = folder / "precious", file = folder / "film.mp4";
  ASSERT_FALSE(write_new(precious, "mine"));
  fs::create_symlink(precious, file);
  fs::create_symlink(precious, folder / ".film.mp4.part");
  EXPECT_TRUE(put_text(part_of(file), file, "text").empty());
  EXPECT_EQ(*read_file(precious), "mine");
  EXPECT_FALSE(fs::is_symlink(file));
}

TEST_F(Place, AFolderInItsPlaceIsAnErrorAndStaysEmpty) {
  fs::path file = folder / "film.mp4";
  fs::create_directory(file);
  Errors errors = put_text(part_of(file), file, "text");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].text(), file.string() + " is a folder; expected a file, or none");
  EXPECT_TRUE(fs::is_empty(file));
  EXPECT_FALSE(fs::exists(folder / ".film.mp4.part"));
}

TEST_F(Place, APictureIsWholeAndOfItsSize) {
  fs::path file = folder / "a.png";
  std::string png = png_text(Raster(4, 3, 3)).value();
  ASSERT_FALSE(write_new(file, png));
  EXPECT_EQ(*whole_picture(file), png);
  EXPECT_TRUE(whole_picture(file, {4, 3}));
  EXPECT_FALSE(whole_picture(file, {3, 4}));
  ASSERT_FALSE(write_new(file, png.substr(0, png.size() - 1)));
  EXPECT_EQ(whole_picture(file).errors()[0].text(), file.string() + " is damaged, or no PNG");
}

TEST(Png, BearsNoTime) {
  std::string png = png_text(Raster(4, 3, 3)).value(), chunk("\0\0\0\7tIME1234567sums", 19);
  constexpr std::size_t kBehindHead = 33;
  std::string dated = png.substr(0, kBehindHead) + chunk + png.substr(kBehindHead);
  EXPECT_EQ(without_time(dated), png);
  EXPECT_EQ(without_time(png), png);
}

TEST(Size, IsReadAsItIsWritten) {
  EXPECT_EQ(size_of("640x360"), (std::array<int, 2>{640, 360}));
  for (const char* wrong : {"", "640", "640x", "x360", "640x360x", "0x360", "-1x3", "a"})
    EXPECT_EQ(size_of(wrong), (std::array<int, 2>{})) << wrong;
}

}  // namespace frond
