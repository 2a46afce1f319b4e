#include "draw/solids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw/eyes.h"
#include "scene_at.h"

namespace frond {
namespace {

/// A ball of 1 m of quads, `n` from pole to pole.
Surface ball(int n) {
  Surface s;
  auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * 2 * n + j % (2 * n)); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      double up = kPi * i / n, round = kPi * j / n;
      s.position.emplace_back(std::sin(up) * std::cos(round), std::cos(up), std::sin(up) * std::sin(round));
      s.normal.push_back(s.position.back());
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      if (i > 0) s.triangle.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      if (i + 1 < n) s.triangle.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  return s;
}

/// How far the middles of triangles are inside a ball of 1 m, at most.
double deepest(const Surface& s) {
  double most = 0;
  for (const auto& [a, b, c] : s.triangle)
    most = std::max(
        most, 1.0 - static_cast<double>(glm::length((s.position[a] + s.position[b] + s.position[c]) / 3.0f)));
  return most;
}

TEST(Coarser, StaysWithinAPixelOfItsPlaceAndGrowsWithThePixels) {
  Surface whole = ball(150);
  std::size_t before = whole.triangle.size();
  for (double pixel : {0.002, 0.008, 0.032}) {
    std::optional<Coarser> less = coarser(whole, pixel, Quality::good);
    ASSERT_TRUE(less) << pixel;
    Surface drawn = drawn_coarser(whole, *less);
    EXPECT_EQ(drawn.find_fault(), "");
    EXPECT_LT(deepest(drawn), pixel);
    // The error of facets goes by the square of their sides: so do pixels to triangles.
    EXPECT_LT(drawn.triangle.size(), before / 2) << pixel;
    before = drawn.triangle.size();
  }
}

TEST(Coarser, LeavesWhatIsSeenFromNearAsItIs) {
  Surface whole = ball(20);
  std::optional<Coarser> less = coarser(whole, 1e-6, Quality::best);
  // At the poles are triangles without a size.
  EXPECT_TRUE(!less || less->triangles.size() > whole.triangle.size() * 9 / 10);
}

TEST(Coarser, HoldsForTheSameTrianglesElsewhere) {
  Surface small = ball(60), large = small;
  for (Vec3& p : large.position) p *= 3;
  std::optional<Coarser> less = coarser(small, 0.02, Quality::good);
  ASSERT_TRUE(less);
  Surface one = drawn_coarser(small, *less), other = drawn_coarser(large, *less);
  EXPECT_EQ(one.triangle, other.triangle);
  for (std::size_t v = 0; v < one.position.size(); ++v) EXPECT_EQ(3.0f * one.position[v], other.position[v]);
}

TEST(Coarser, GrowsAsTheWholeDoes) {
  Solid solid{ball(60), {}};
  solid.past = {std::vector<Vec3>(solid.surface.position.size(), Vec3(0)), solid.surface.position};
  for (std::size_t v = 0; v < solid.surface.position.size(); ++v)
    solid.light.push_back(solid.surface.position[v].y);
  std::optional<Coarser> less = coarser(solid, 0.02, Quality::good);
  ASSERT_TRUE(less);
  Solid drawn = drawn_coarser(solid, *less);
  ASSERT_EQ(drawn.past.size(), 2u);
  EXPECT_EQ(drawn.past[1], drawn.surface.position);
  for (std::size_t v = 0; v < drawn.light.size(); ++v) EXPECT_EQ(drawn.light[v], drawn.surface.position[v].y);
}

TEST(Coarser, FacesStayFlatWhereARoundedEdgeIsGone) {
  // A ball of many small facets that is pressed flat above: a table with a round rim.
  Surface table = ball(80);
  for (std::size_t v = 0; v < table.position.size(); ++v)
    if (table.position[v].y > 0.02f) table.position[v].y = 0.02f, table.normal[v] = Vec3(0, 1, 0);
  std::optional<Coarser> less = coarser(table, 0.1, Quality::draft);
  ASSERT_TRUE(less);
  Surface drawn = drawn_coarser(table, *less);
  EXPECT_EQ(drawn.find_fault(), "");
  for (const auto& t : drawn.triangle) {
    Vec3 facing = glm::normalize(
        glm::cross(drawn.position[t[1]] - drawn.position[t[0]], drawn.position[t[2]] - drawn.position[t[0]]));
    for (std::uint32_t v : t) EXPECT_GE(glm::dot(facing, drawn.normal[v]), 0.79f);
  }
  EXPECT_TRUE(coarser(table, 0.1, Quality::draft, false)->flat.empty());
}

TEST(Coarser, LeavesBodiesThatPovRayMakesItself) {
  Solid solid{ball(60), {}};
  solid.turned.resize(1);
  EXPECT_FALSE(coarser(solid, 0.1, Quality::draft));
}

TEST(NearestPixel, IsThatOfTheNearestEyeAndLargerWhereNoneLooks) {
  Eye eye = eye_toward(Vec3(0, 0, 10), Vec3(0), 0.5, 0.5, 0.001);
  EXPECT_NEAR(nearest_pixel({eye}, Vec3(0), 2, 4), 0.008, 1e-9);
  Eye away = eye_toward(Vec3(0, 0, 10), Vec3(0, 0, 20), 0.5, 0.5, 0.001);
  EXPECT_NEAR(nearest_pixel({away}, Vec3(0), 2, 4), 0.032, 1e-9);
  EXPECT_NEAR(nearest_pixel({away, eye}, Vec3(0), 2, 4), 0.008, 1e-9);
}

TEST(DrawnFloor, KeepsItsHeightAndItsOutline) {
  Scene scene = scene_at("tests/presets/tiny_garden.json");
  const Surface& whole = scene.ground->floor();
  Surface drawn = drawn_floor(scene);
  EXPECT_EQ(drawn.find_fault(), "");
  EXPECT_LT(drawn.triangle.size(), whole.triangle.size() / 2);
  // What it covers seen from above is the same, without gaps or folds.
  auto covered = [](const Surface& s) {
    double sum = 0;
    for (const auto& t : s.triangle)
      sum += static_cast<double>(
          glm::cross(s.position[t[1]] - s.position[t[0]], s.position[t[2]] - s.position[t[0]]).y);
    return sum / 2;
  };
  EXPECT_NEAR(covered(drawn), covered(whole), 1e-3 * std::abs(covered(whole)));
}

TEST(DrawnSolids, HaveFewerTrianglesWhereThePictureIsSmaller) {
  Scene scene = scene_at("tests/presets/tiny_reef.json");
  std::size_t before = 0;
  for (int width : {40, 160, 640, 2560}) {
    scene.film.size = {width, width * 9 / 16};
    DrawnSolids drawn = drawn_solids(scene);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < scene.specimens.size(); ++i)
      for (const Solid& solid : drawn.of(scene, i).shapes) triangles += solid.surface.triangle.size();
    EXPECT_GT(triangles, before) << width;
    before = triangles;
  }
}

}  // namespace
}  // namespace frond
