#include "render/frames_left.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>

#include "core/files.h"
#include "core/frame_name.h"

// By a clock that stands where the test puts it.

namespace frond {

namespace fs = std::filesystem;

class Left : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::path(::testing::TempDir()) /
             (std::string("left_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  void scene(int number, std::size_t bytes) {
    EXPECT_FALSE(write_new(folder / (frame_name(number) + ".pov"), std::string(bytes, ' ')));
  }
  /// Of a picture of 10x10, as POV-Ray notes it.
  void traced(int number, std::size_t percent) {
    EXPECT_FALSE(write_new(notes(number), std::string(percent * 20, ' ')));
  }
  void finish(FramesLeft& left, int number) {
    fs::remove(notes(number));
    left.frame_done(number);
  }
  fs::path notes(int number) const { return folder / ("." + frame_name(number) + ".abc.kept"); }

  fs::path folder;
};

TEST_F(Left, OfAStillNothingIsSaidWhileItIsReadAndThenWhatTracingTakes) {
  scene(1, 5000);
  FramesLeft left(folder, folder, {10, 10}, {1}, 2, 100);
  left.look(100);
  left.look(120);
  EXPECT_FALSE(left.seconds_left(120));
  EXPECT_TRUE(left.reads());
  EXPECT_EQ(left.percent(), 0);
  traced(1, 1);
  left.look(130);
  EXPECT_FALSE(left.reads());
  traced(1, 20);
  left.look(150);
  EXPECT_EQ(left.percent(), 20);
  EXPECT_NEAR(left.seconds_left(150).value(), 80, 4);
}

TEST_F(Left, OfAFilmReadingIsReckonedForEveryFrame) {
  std::vector<int> numbers(20);
  std::iota(numbers.begin(), numbers.end(), 1);
  for (int number : numbers) scene(number, 1000);
  FramesLeft left(folder, folder, {10, 10}, numbers, 2, 100);
  left.look(100);
  traced(1, 1), traced(2, 1);  // 10 s of reading, 40 s of tracing
  left.look(110);
  traced(1, 25), traced(2, 25);
  left.look(120);
  EXPECT_NEAR(left.seconds_left(120).value(), 480, 24);  // 20 frames of 50 s by two, but for 20 s
  finish(left, 1), finish(left, 2);
  left.look(150);
  EXPECT_NEAR(left.seconds_left(150).value(), 450, 22);
}

TEST_F(Left, LargerScenesCountForMoreAndWhatAnEarlierRunHasTracedIsNoSpeed) {
  scene(1, 1000);
  scene(2, 3000);
  traced(1, 50);
  FramesLeft left(folder, folder, {10, 10}, {1, 2}, 1, 100);
  left.look(100);
  traced(1, 99);
  left.look(110);
  finish(left, 1);
  left.look(110);
  // Half of a picture of weight 750 took 10 s, one of 1250 is left.
  EXPECT_NEAR(left.seconds_left(110).value(), 33, 1.6);
}

TEST_F(Left, ExposuresOfAFrameShareItsWeight) {
  scene(1, 1000);
  for (int i = 2; i <= 4; ++i) EXPECT_FALSE(write_new(folder / (exposure_name(1, i) + ".pov"), "scene"));
  FramesLeft left(folder, folder, {10, 10}, {1}, 1, 0);
  EXPECT_FALSE(write_new(folder / ".frame_0001.abc.1.exposed", "a picture"));
  left.look(1);
  EXPECT_EQ(left.percent(), 25);
}

TEST(Clock, ShowsMinutes) {
  EXPECT_EQ(clock_text(7.9), "0:07");
  EXPECT_EQ(clock_text(187), "3:07");
}

}  // namespace frond
