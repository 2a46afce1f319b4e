#include "render/trace_state.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <filesystem>
#include <string>

#include "core/files.h"

namespace frond {

namespace {

namespace fs = std::filesystem;

/// The head of a state file of POV-Ray.
std::string head() {
  std::string text = "POV-Ray Render State File";
  text.resize(512, '\0');
  return text;
}

/// A message of it that holds this.
std::string message(const std::string& body) {
  std::string text = "POVRAYMS....";
  auto length = static_cast<unsigned>(16 + body.size() - 20);
  for (unsigned shift : {24u, 16u, 8u, 0u}) text += static_cast<char>(length >> shift & 255);
  return text + body;
}

std::string first_block() { return message(std::string("PxBSPiIdINT4\0\0\0\4\0\0\0\0PiSi 1234", 29)); }
std::string other_block() { return message(std::string("PxBSPiIdINT4\0\0\0\4\0\0\0\7PiSi 1234", 29)); }
std::string coarse() { return message("PxSe and so on, as many"); }

std::size_t kept(const std::string& state) {
  fs::path file = fs::path(::testing::TempDir()) / ("frond_trace_state_" + std::to_string(::getpid()));
  EXPECT_FALSE(write_new(file, state));
  EXPECT_TRUE(keep_traced(file).empty());
  std::size_t size = fs::file_size(file);
  EXPECT_EQ(*read_file(file), state.substr(0, size));
  fs::remove(file);
  return size;
}

}  // namespace

TEST(TraceState, WholeBlocksAreKept) {
  std::string state = head() + other_block() + other_block();
  EXPECT_EQ(kept(state), state.size());
}

TEST(TraceState, WhatIsCutOffGoes) {
  std::string whole = head() + other_block(), cut = other_block();
  for (std::size_t length = 0; length < cut.size(); ++length)
    EXPECT_EQ(kept(whole + cut.substr(0, length)), whole.size()) << length;
  EXPECT_EQ(kept(whole + "something else, which is no message"), whole.size());
}

TEST(TraceState, CoarsePixelsNeedTheFirstBlock) {
  std::string good = head() + coarse() + other_block() + first_block();
  EXPECT_EQ(kept(good), good.size());
  EXPECT_EQ(kept(head() + coarse() + other_block()), 0u);
}

TEST(TraceState, WithoutBlocksNothingIsKept) { EXPECT_EQ(kept(head()), 0u); }

TEST(TraceState, AnotherRenderersIsLeftAlone) {
  EXPECT_EQ(kept(std::string(700, '\0')), 700u);
  EXPECT_EQ(kept("short"), 5u);
  EXPECT_EQ(kept(""), 0u);
}

/// An attribute of a message: its name and type, then as many units as its length says.
std::string attribute(const std::string& name_and_type, std::uint32_t length, const std::string& bytes) {
  std::string text = name_and_type;
  for (unsigned shift : {24u, 16u, 8u, 0u}) text += static_cast<char>(length >> shift & 255);
  return text + bytes;
}

std::string number(std::uint32_t value) {
  std::string bytes;
  for (unsigned shift : {24u, 16u, 8u, 0u}) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

/// A block of one colour.
std::string block(int left, int top, int right, int bottom, std::array<float, 3> light) {
  std::string pixels;
  int count = (right - left + 1) * (bottom - top + 1);
  for (int i = 0; i < count; ++i)
    for (float channel : {light[0], light[1], light[2], 0.0f, 0.0f})
      pixels += number(std::bit_cast<std::uint32_t>(channel));
  std::string body =
      "RAWSOBJE" + number(9) + attribute("PBloVFL4", static_cast<std::uint32_t>(5 * count), pixels);
  for (auto [name, value] :
       {std::pair("LeftINT4", left), {"Top INT4", top}, {"RighINT4", right}, {"BottINT4", bottom}})
    body += attribute(name, 4, number(static_cast<std::uint32_t>(value)));
  return message(body);
}

std::optional<Raster> traced(const std::string& state, const Raster* below = nullptr) {
  fs::path file = fs::path(::testing::TempDir()) / ("frond_traced_" + std::to_string(::getpid()));
  EXPECT_FALSE(write_new(file, state));
  std::optional<Raster> picture = traced_picture(file, {4, 3}, {}, below);
  fs::remove(file);
  return picture;
}

TEST(TracedPicture, LiesOverASmallerOne) {
  Raster small(2, 1, 3);
  small.data = {10, 20, 30, 40, 50, 60};
  std::optional<Raster> picture = traced(head() + block(0, 0, 1, 1, {1, 0, 0}), &small);
  ASSERT_TRUE(picture);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x)
      EXPECT_EQ(picture->at(x, y, 2), x < 2 && y < 2 ? 0 : x < 2 ? 30 : 60) << x << ' ' << y;
}

TEST(TracedPicture, ShowsTheBlocksThereAre) {
  std::string state = head() + block(0, 0, 1, 1, {1, 0, 0}) + block(3, 2, 3, 2, {0, 1, 0});
  for (const std::string& cut : {std::string(), block(2, 0, 3, 1, {0, 0, 1}).substr(0, 60)}) {
    std::optional<Raster> picture = traced(state + cut);
    ASSERT_TRUE(picture);
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 4; ++x) {
        bool red = x < 2 && y < 2, green = x == 3 && y == 2, blank = !red && !green;
        EXPECT_EQ(picture->at(x, y, 0), red ? 255 : blank ? 64 : 0) << x << ' ' << y;
        EXPECT_EQ(picture->at(x, y, 1), green ? 255 : blank ? 64 : 0) << x << ' ' << y;
      }
  }
}

TEST(TracedPicture, IsNoneWithoutBlocksOrOfAnotherSize) {
  EXPECT_FALSE(traced(head()));
  EXPECT_FALSE(traced(head() + coarse()));
  EXPECT_FALSE(traced("something else"));
  EXPECT_FALSE(traced(head() + block(3, 2, 4, 2, {1, 1, 1})));
}

}  // namespace frond
