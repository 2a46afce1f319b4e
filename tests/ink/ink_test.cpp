#include "ink/ink.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

constexpr int kSide = 120;

/// A disc that faces the camera, 10 m away, in one shade.
InkSamples disc(float shade, float slope = 0.01f) {
  InkSamples made{kSide, kSide, 2, 0.001f, {}};
  for (int y = 0; y < 2 * kSide; ++y)
    for (int x = 0; x < 2 * kSide; ++x) {
      InkSample& one = made.samples.emplace_back();
      Vec2 at(static_cast<float>(x) / 2, static_cast<float>(y) / 2);
      if (glm::distance(at, Vec2(60, 60)) > 45) continue;
      one.depth = 10, one.normal = Vec3(0, 0, 1), one.thing = 1, one.shade = shade;
      one.at = Vec3(at * 0.01f, 0);
      one.phase = {at.x * slope, at.y * slope}, one.slope = {slope, slope};
    }
  return made;
}

double ink_within(const Grid& ink, float least, float most) {
  double sum = 0, count = 0;
  for (int y = 0; y < ink.height; ++y)
    for (int x = 0; x < ink.width; ++x) {
      float away = glm::distance(Vec2(x, y), Vec2(60, 60));
      if (away < least || away > most) continue;
      sum += static_cast<double>(ink.at(x, y)), ++count;
    }
  return sum / count;
}

TEST(Ink, WhatIsInTheLightHasAnOutlineAndNothingElse) {
  Grid ink = ink_drawing(disc(0.1f));
  EXPECT_GT(ink_within(ink, 43, 46), 0.3);
  EXPECT_EQ(ink_within(ink, 0, 41), 0);
  EXPECT_EQ(ink_within(ink, 48, 60), 0);
}

TEST(Ink, DarkerPartsHaveMoreOfIt) {
  double before = 0;
  for (float shade : {0.3f, 0.5f, 0.7f, 0.85f, 1.0f}) {
    double now = ink_within(ink_drawing(disc(shade)), 0, 40);
    EXPECT_GE(now, before) << shade;
    before = now;
  }
  EXPECT_GT(before, 0.4);
  EXPECT_LT(before, 0.8) << "lines, no black";
}

TEST(Ink, LinesAreAsCloseAtAnyScaleOfASurface) {
  double usual = ink_within(ink_drawing(disc(0.8f, 0.01f)), 0, 40);
  for (float slope = 0.0001f; slope < 10; slope *= 1.7f)
    EXPECT_NEAR(ink_within(ink_drawing(disc(0.8f, slope)), 0, 40), usual, 0.35 * usual) << slope;
}

TEST(Ink, WhatLiesFartherBehindHasAWiderLine) {
  double before = 0;
  for (float gap : {0.0f, 0.05f, 0.3f, 3.0f}) {
    InkSamples samples = disc(0);
    for (InkSample& one : samples.samples)
      if (one.depth > 0 && one.phase[0] > 0.6f) one.depth += gap, one.at.z -= gap;
    double now = ink_within(ink_drawing(samples), 0, 40);
    EXPECT_GE(now, before) << gap;
    before = now;
  }
  EXPECT_GT(before, 0.01);
}

TEST(Ink, WhereALineIsLeftOutThereIsNone) {
  // Steps everywhere that are all alike: no cell has room for them.
  InkSamples samples = disc(0);
  for (std::size_t i = 0; i < samples.samples.size(); ++i)
    if (InkSample& one = samples.samples[i]; one.depth > 0 && (i / 4 + i / (4 * 2 * kSide)) % 2 == 1)
      one.depth += 0.05f, one.at.z -= 0.05f;
  EXPECT_EQ(ink_within(ink_drawing(samples), 0, 30), 0);
}

TEST(Ink, WithoutPaperThereIsOnlyInk) {
  Grid ink = ink_drawing(disc(0.9f));
  Raster paper = ink_picture(ink, true), clear = ink_picture(ink, false);
  EXPECT_EQ(paper.channels, 3);
  EXPECT_EQ(clear.channels, 4);
  EXPECT_EQ(paper.at(0, 0), 255);
  EXPECT_EQ(clear.at(0, 0, 3), 0);
  for (int x = 0; x < kSide; ++x) EXPECT_EQ(clear.at(x, 60, 3), to_byte(static_cast<double>(ink.at(x, 60))));
}

}  // namespace
}  // namespace frond
