#include <gtest/gtest.h>

#include <cmath>

#include "export/carry.h"
#include "export/foliage.h"
#include "export/surfaces.h"
#include "geometry/far.h"
#include "solids.h"

namespace frond {
namespace {

double uv_area(const Surface& s) {
  double sum = 0;
  for (auto [a, b, c] : s.triangle) {
    Vec2 p = s.uv[b] - s.uv[a], q = s.uv[c] - s.uv[a];
    sum += std::abs(p.x * q.y - p.y * q.x) / 2;
  }
  return sum;
}

Surface ball(int rows) {
  Surface s;
  auto side = static_cast<std::uint32_t>(2 * rows);
  for (int row = 0; row <= rows; ++row)
    for (std::uint32_t k = 0; k < side; ++k) {
      double down = kPi * row / rows, turn = 2 * kPi * k / side;
      s.position.push_back(
          Vec3(std::sin(down) * std::cos(turn), std::cos(down), std::sin(down) * std::sin(turn)));
    }
  s.normal = s.position;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row)
    for (std::uint32_t k = 0; k < side; ++k) {
      std::uint32_t a = row * side + k, b = row * side + (k + 1) % side;
      s.triangle.push_back({a, b, a + side}), s.triangle.push_back({b, b + side, a + side});
    }
  return s;
}

TEST(BoxMap, KeepsAreasOfABoxInMetres) {
  Surface body = box(Vec3(-1, 0, -2), Vec3(1, 3, 2));
  body.normal.assign(body.position.size(), Vec3(0, 1, 0));
  std::vector<std::uint32_t> of;
  Surface mapped = box_mapped(body, &of);
  EXPECT_EQ(mapped.triangle.size(), body.triangle.size());
  EXPECT_NEAR(uv_area(mapped), area(body), 1e-4);
  ASSERT_EQ(of.size(), mapped.position.size());
  for (std::size_t v = 0; v < of.size(); ++v) EXPECT_EQ(mapped.position[v], body.position[of[v]]);
  lay_picture(mapped, 2, 4);
  EXPECT_NEAR(uv_area(mapped), area(body) / 8, 1e-4) << "pictures of 2 m x 4 m";
}

TEST(Carry, LeadsEachVertexToWhereItIsThen) {
  Surface from = box(Vec3(0), Vec3(1)), to = from;
  for (Vec3& p : to.position) p = 2.0f * p + Vec3(0, 1, 0);
  from.normal = to.normal = std::vector<Vec3>(8, Vec3(0, 1, 0));
  ExportShift shift = shift_between(from, to);
  ASSERT_EQ(shift.position.size(), from.position.size());
  for (std::size_t v = 0; v < 8; ++v)
    EXPECT_NEAR(glm::distance(from.position[v] + shift.position[v], to.position[v]), 0, 1e-6);
}

TEST(DrawnWith, HasAboutSoManyTrianglesAndKnowsItsVertices) {
  Surface whole = ball(40);
  for (double few : {200.0, 800.0, 1e9}) {
    Simplified drawn = drawn_with(whole, few);
    EXPECT_LE(static_cast<double>(drawn.surface.triangle.size()), 1.1 * few);
    ASSERT_EQ(drawn.source.size(), drawn.surface.position.size());
    for (std::size_t v = 0; v < drawn.source.size(); ++v)
      EXPECT_EQ(drawn.surface.position[v], whole.position[drawn.source[v]]);
  }
}

TEST(CardOf, LiesWhereALeafIs) {
  Surface leaf;  // a strip that bends, longer than wide
  for (int row = 0; row <= 8; ++row)
    for (float u : {0.0f, 1.0f}) {
      float v = static_cast<float>(row) / 8;
      leaf.position.push_back({0.3f * (u - 0.5f), v, 0.2f * v * v});
      leaf.normal.push_back(Vec3(0, 0, 1));
      leaf.uv.push_back({u, v});
    }
  for (std::uint32_t k = 0; k < 16; k += 2)
    leaf.triangle.push_back({k, k + 1, k + 3}), leaf.triangle.push_back({k, k + 3, k + 2});
  for (int rows : {1, 2, 3}) {
    Surface card = card_of(leaf, rows);
    EXPECT_EQ(card.triangle.size(), 2u * static_cast<std::size_t>(rows));
    EXPECT_NEAR(area(card), area(leaf), 0.05 * area(leaf)) << rows;
  }
  Surface bent = card_of(leaf, 2);
  EXPECT_NEAR(bent.position.back().z, 0.2, 0.02) << "two rows bend with the leaf";
}

}  // namespace
}  // namespace frond
