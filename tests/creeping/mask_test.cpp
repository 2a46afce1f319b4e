#include "creeping/crawl.h"

#include <gtest/gtest.h>

#include "creeping/meshes.h"

namespace frond {
namespace {

/// A wall in x and y, 2 m wide and 2 m high, painted by a function of x.
Surface painted_wall(const std::function<float(float)>& grey) {
  Surface wall = sheet(40, 40, false, false, [](double u, double v) { return Vec3(2 * u - 1, 2 * v, 0); });
  for (auto [a, b, c] : wall.triangle) {
    auto paint = [&](std::uint32_t i) {
      const Vec3& p = wall.position[i];
      return Vec3(0.5f + 0.5f * p.x, 0.5f * p.y, grey(p.x));
    };
    wall.paint.push_back({paint(a), paint(b), paint(c)});
  }
  return wall;
}

Strands creeping(const TriangleSurface& host, const std::optional<CrawlMask>& mask) {
  Crawl crawl;
  crawl.mask = mask;
  crawl.max_age = 120;
  crawl.let_go = 0;
  return grow_strands(host, starts_at_foot(host, 10, 0.05, Vec3(0), Seed{4}), crawl, Seed{1});
}

TEST(Mask, IsThatOfThePlaceWhateverWayTrianglesTurn) {
  Surface wall = painted_wall([](float x) { return 0.5f + 0.5f * x; });
  for (std::size_t t = 0; t < wall.triangle.size(); t += 3) {
    std::swap(wall.triangle[t][1], wall.triangle[t][2]);
    std::swap(wall.paint[t][1], wall.paint[t][2]);
  }
  TriangleSurface host = built(wall);
  EXPECT_TRUE(host.has_grey());
  EXPECT_TRUE(host.has_texture());
  EXPECT_FALSE(built(ball(1, 8, 6)).has_grey());
  CrawlMask by_grey, by_picture;
  std::vector<float> grey;
  for (int i = 0; i < 128; ++i)  // dark above, from black to white below
    grey.push_back(i < 64 ? 0.0f : (static_cast<float>(i) - 63.5f) / 64);
  by_picture.picture.file.name = "ramp.png", by_picture.picture.width = 64, by_picture.picture.height = 2;
  by_picture.picture.grey = std::make_shared<const std::vector<float>>(grey);
  for (int i = 0; i < 200; ++i) {
    Seed own = Seed{3}.child(static_cast<std::uint64_t>(i));
    DVec3 place(own.child(0).range(-0.95, 0.95), own.child(1).range(0.05, 0.45), 0);
    Contact near = *host.closest(place);
    EXPECT_NEAR(by_grey.at(host, near.triangle, near.point), 0.5 + 0.5 * place.x, 1e-4);
    EXPECT_NEAR(by_picture.at(host, near.triangle, near.point), 0.5 + 0.5 * place.x, 0.02);
    near = *host.closest(place + DVec3(0, 1.5, 0));
    EXPECT_NEAR(by_picture.at(host, near.triangle, near.point), 0, 1e-6);
  }
}

TEST(Mask, StopsStrandsWhereItIsBlack) {
  Surface wall = painted_wall([](float x) { return std::abs(x) < 0.4f ? 0.0f : 1.0f; });
  TriangleSurface host = built(wall);
  CrawlMask mask;
  auto within = [](const Strands& s) {
    return std::count_if(s.contact.begin(), s.contact.end(), [](Vec3 p) { return std::abs(p.x) < 0.37f; });
  };
  EXPECT_GT(within(creeping(host, mask)), 100);
  mask.stops = 0.5;
  Strands spared = creeping(host, mask);
  EXPECT_EQ(within(spared), 0);
  EXPECT_GT(spared.size(), 500u);
}

TEST(Mask, ScalesWhatIsNamed) {
  TriangleSurface host = built(painted_wall([](float x) { return x < 0 ? 1.0f : 0.3f; }));
  auto shares = [&](const Strands& s) {  // of nodes that lie in the grey half
    double grey = 0;
    for (const Vec3& p : s.contact) grey += p.x > 0;
    return grey / static_cast<double>(s.size());
  };
  CrawlMask mask;
  Strands leafy = creeping(host, mask);
  ASSERT_EQ(leafy.mask.size(), leafy.size());
  for (std::size_t i = 0; i < leafy.size(); ++i)
    if (std::abs(leafy.contact[i].x) > 0.06f) {
      EXPECT_NEAR(leafy.mask[i], leafy.contact[i].x < 0 ? 1 : 0.3, 1e-4);
    }
  mask.scales = {"spacing"};
  Strands crowded = creeping(host, mask);
  EXPECT_TRUE(crowded.mask.empty());
  EXPECT_GT(shares(crowded), 1.3 * shares(leafy)) << "they stand closer where less spacing is asked for";
  mask.scales = {};
  EXPECT_EQ(creeping(host, mask).skeleton.position, creeping(host, {}).skeleton.position);
}

TEST(Mask, OfBodiesWithoutPaintIsWhite) {
  Surface both = painted_wall([](float) { return 0.0f; });
  append_placed(both, ball(0.5, 12, 8), Vec3(5, 0, 0), Quat(1, 0, 0, 0), Vec3(1));
  EXPECT_EQ(both.find_fault(), "");
  TriangleSurface host = built(both);
  Contact near = *host.closest(DVec3(5, 1, 0));
  EXPECT_EQ(CrawlMask{}.at(host, near.triangle, near.point), 1);
}

}  // namespace
}  // namespace frond
