#include "land/far_land.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "land/far_mesh.h"
#include "land/far_objects.h"
#include "land/far_shapes.h"

namespace frond {
namespace {

GroundEdge disc(double radius) { return {.radius = radius}; }
GroundEdge square(double radius, double ends) {
  return {.radius = radius, .square = true, .beyond = [ends](Vec2) { return ends; }};
}

/// A camera in the middle that looks toward +x.
FarView view_of(double pixels, double pixel) {
  return {.from = -0.4, .to = 0.4, .pixel = pixel, .eye = 1.6, .pixels = pixels};
}

TEST(FarLand, BeginsAtTheHeightAndSlopeOfTheNearGround) {
  for (std::uint64_t seed = 1; seed < 6; ++seed)
    for (const GroundEdge& edge : {disc(150), square(1200, 17)}) {
      FarLand land(FarLandShape{}, edge, Seed{seed});
      double ends = edge.beyond ? edge.beyond(Vec2(0)) : 0;
      for (int i = 0; i < 60; ++i) {
        Vec2 out(std::cos(0.1 * i), std::sin(0.1 * i));
        if (edge.square) out /= std::max(std::abs(out.x), std::abs(out.y));
        double at = land.height(out * static_cast<float>(edge.radius));
        EXPECT_NEAR(at, ends, 1e-3);
        EXPECT_NEAR(land.height(out * static_cast<float>(edge.radius + 3)), ends, 0.05) << seed;
      }
    }
}

TEST(FarLand, IsContinuous) {
  FarLandShape shape;
  shape.mountains = 1500;
  FarLand land(shape, disc(150), Seed{3});
  for (int i = 0; i < 4000; ++i) {
    Vec2 at(140 + 2.7f * static_cast<float>(i), 40 + 0.3f * static_cast<float>(i));
    double step = land.height(at + Vec2(0.02f, 0), 1) - land.height(at, 1);
    EXPECT_LT(std::abs(step), 0.8) << i;
  }
}

TEST(FarLand, WoodsTakeTheirShare) {
  for (double share : {0.1, 0.3, 0.6}) {
    FarLandShape shape;
    shape.woods = share, shape.villages = 0;
    int wooded = 0, all = 0;
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
      FarLand land(shape, disc(150), Seed{seed});
      for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j, ++all) wooded += land.wooded(land.parcel(Vec2(3000 + 211 * i, 211 * j)));
    }
    EXPECT_NEAR(static_cast<double>(wooded) / all, share, 0.1);
  }
}

TEST(FarLand, BordersAreSeenTheSameFromBothSides) {
  FarLand land(FarLandShape{}, disc(150), Seed{7});
  for (int i = 0; i < 300; ++i) {
    Vec2 at(500 + 17 * i, 300 - 11 * i);
    Parcel own = land.parcel(at);
    Vec2 toward = glm::normalize(own.next - own.site);
    Parcel other = land.parcel(at + toward * static_cast<float>(own.edge + 0.05));
    if (other.seed.key == own.seed.key || other.next != own.site) continue;  // a third parcel is nearer there
    EXPECT_EQ(own.border.key, other.border.key);
    EXPECT_LT(other.edge, 0.2);
  }
}

TEST(FarLand, ParcelsAreAboutTwiceAsLongAsWide) {
  FarLandShape shape;
  FarLand land(shape, disc(150), Seed{2});
  std::map<std::uint64_t, std::pair<Vec2, Vec2>> boxes;  // along and across the main direction
  for (int i = 0; i < 250; ++i)
    for (int j = 0; j < 250; ++j) {
      Vec2 at(5.0f * static_cast<float>(i), 5.0f * static_cast<float>(j));
      Vec2 p(glm::dot(at, land.along()), glm::dot(at, Vec2(-land.along().y, land.along().x)));
      auto [box, fresh] = boxes.insert({land.parcel(at).seed.key, {p, p}});
      box->second = {glm::min(box->second.first, p), glm::max(box->second.second, p)};
    }
  double length = 0, width = 0;
  for (const auto& [key, box] : boxes) {
    Vec2 size = box.second - box.first;
    length += size.x, width += size.y;
  }
  EXPECT_GT(length / width, 1.3);
  EXPECT_LT(length / width, 2.5);
}

TEST(FarLand, AboveTheTreeLineAreNoWoods) {
  FarLandShape shape;
  shape.mountains = 2000, shape.tree_line = 700, shape.snow_line = 1500, shape.mountains_distance = 3000;
  FarLand land(shape, disc(150), Seed{5});
  int wood = 0, high = 0;
  for (int i = 0; i < 3000; ++i) {
    Vec2 at(6000 * std::cos(i), 6000 * std::sin(i));
    at *= 1 + 0.0003f * static_cast<float>(i);
    double height = land.height(at, 40);
    FarCover cover = land.cover(at, land.parcel(at), height, land.slope(at, 40));
    MountainPlace place{at, height, land.slope(at, 40)};
    bool bare = cover == FarCover::mountain && mountain_cover_at(shape.lines(), place) > 0.1;
    wood += cover == FarCover::mountain && !bare;
    if (height < 900) continue;
    ++high;
    EXPECT_TRUE(bare) << height;
  }
  EXPECT_GT(wood, 30);
  EXPECT_GT(high, 300);
}

TEST(FarMesh, MountainsSayWhatCoversThem) {
  FarLandShape shape;
  shape.mountains = 2000, shape.tree_line = 700, shape.snow_line = 1500, shape.mountains_distance = 3000;
  FarLand land(shape, disc(150), Seed{5});
  std::array<int, 6> covers{};
  for (const FarPart& part : far_mesh(land, view_of(64 * 48, 0.8 / 64), Seed{1})) {
    if (part.cover != FarCover::mountain) continue;
    ASSERT_EQ(part.surface.uv.size(), part.surface.position.size());
    for (std::size_t i = 0; i < part.surface.uv.size(); ++i) {
      float cover = part.surface.uv[i].y;
      ASSERT_GE(cover, 0);
      ASSERT_LE(cover, 1);
      ++covers[static_cast<std::size_t>(std::lround(5 * cover))];
      if (part.surface.position[i].y > 1100) {
        EXPECT_GT(cover, 0.1) << "no wood";
      }
    }
  }
  for (int count : covers) EXPECT_GT(count, 0);
}

TEST(FarMesh, IsSoundAndGrowsWithThePicture) {
  FarLand land(FarLandShape{}, disc(150), Seed{1});
  std::size_t before = 0;
  for (double width : {64.0, 160.0, 320.0}) {
    std::size_t triangles = 0;
    for (const FarPart& part : far_mesh(land, view_of(width * width * 0.6, 0.8 / width), Seed{1})) {
      EXPECT_EQ(part.surface.find_fault(), "");
      triangles += part.surface.triangle.size();
      for (auto [a, b, c] : part.surface.triangle) {
        Vec3 p = part.surface.position[a], q = part.surface.position[b], r = part.surface.position[c];
        EXPECT_GE(glm::cross(q - p, r - p).y, -1e-3f) << "faces up";
      }
    }
    EXPECT_GT(triangles, before);
    EXPECT_LT(static_cast<double>(triangles), 8000 + 1.5 * width * width * 0.6);
    before = triangles;
  }
}

TEST(FarMesh, WoodsAtTheNearGroundReachDownToIt) {
  // Nobody looks below a canopy that ends in the air.
  FarLandShape shape;
  shape.woods = 0.8;
  FarView view = view_of(60'000, 0.004);
  view.eye = 1e5;  // nothing is hidden
  for (const GroundEdge& edge : {disc(150), square(600, 17)}) {
    FarLand land(shape, edge, Seed{4});
    int low = 0, high = 0;
    for (const FarPart& part : far_mesh(land, view, Seed{1})) {
      if (part.cover != FarCover::wood) continue;
      for (const Vec3& p : part.surface.position) {
        double out = edge.outside(Vec2(p.x, p.z)), above = p.y - land.height(Vec2(p.x, p.z));
        low += out < 8;
        high += out > 30 && above > 8;
        EXPECT_TRUE(out >= 8 || above < 0.5) << out << " " << above;
      }
    }
    EXPECT_GT(low, 10);
    EXPECT_GT(high, 100);
  }
}

TEST(FarMesh, OnlyWoodsRiseAboveTheLand) {
  // A field beside a wood does not climb its canopy.
  FarView view = view_of(480 * 270, 0.8 / 480);
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    FarLand land(FarLandShape{}, disc(60), Seed{seed});
    for (const FarPart& part : far_mesh(land, view, Seed{seed})) {
      if (part.cover == FarCover::wood || part.cover == FarCover::mountain) continue;
      for (const Vec3& p : part.surface.position) EXPECT_LT(p.y - land.height(Vec2(p.x, p.z)), 1.2);
    }
  }
}

TEST(FarMesh, LeavesOutOnlyWhatTheLandHides) {
  // What is left of each ray, against one whose camera stands so high that nothing is hidden.
  FarLand land(FarLandShape{}, disc(150), Seed{4});
  FarView low = view_of(60'000, 0.004), high = low;
  high.eye = 1e5;
  auto count = [&](const FarView& view) {
    std::size_t sum = 0;
    for (const FarPart& part : far_mesh(land, view, Seed{1})) sum += part.surface.triangle.size();
    return sum;
  };
  EXPECT_LT(count(low), 0.8 * static_cast<double>(count(high)));
}

TEST(FarObjects, StandOnTheLandAndKeepToTheirNumber) {
  FarLand land(FarLandShape{}, disc(150), Seed{1});
  FarView view = view_of(640 * 360, 0.8 / 640);
  std::vector<FarObject> objects = far_objects(land, view, Seed{1});
  EXPECT_GT(objects.size(), 500u);
  EXPECT_LE(static_cast<double>(objects.size()), view.pixels / 50);
  std::array<int, kFarKinds> kinds{};
  for (const FarObject& o : objects) {
    Vec2 at(o.foot.x, o.foot.z);
    ++kinds[static_cast<std::size_t>(o.kind)];
    EXPECT_GT(land.edge().outside(at), 0);
    EXPECT_NEAR(o.foot.y, land.height(at), 1e-2);
  }
  EXPECT_GT(kinds[0] + kinds[1], 100);
  EXPECT_GT(kinds[2], 20);
}

TEST(FarObjects, ShrubsCloseTheEdgesOfWoods) {
  FarLandShape shape;
  shape.woods = 0.8;
  FarLand land(shape, disc(60), Seed{4});
  // Along the near ground, in pieces of 12 m: whether it is wooded, and how many shrubs stand in its edge.
  constexpr int kPieces = 34;
  std::array<int, kPieces> shrubs{}, wooded{};
  auto piece = [](Vec2 at) {
    return static_cast<std::size_t>((std::atan2(at.y, at.x) / (2 * kPi) + 0.5) * (kPieces - 1e-3));
  };
  FarView view;
  view.pixels = 1e6;
  for (const FarObject& o : far_objects(land, view, Seed{1})) {
    Vec2 at(o.foot.x, o.foot.z);
    Parcel parcel = land.parcel(at);
    if (o.kind != FarKind::hedge || !land.wooded(parcel)) continue;
    double out = land.edge().outside(at);
    EXPECT_TRUE(out < 9 || parcel.edge < 9) << out << " " << parcel.edge;
    if (out < 9) ++shrubs[piece(at)];
  }
  for (float turn = 0; turn < 360; ++turn) {
    Vec2 at = 65.0f * Vec2(std::cos(radians(turn)), std::sin(radians(turn)));
    wooded[piece(at)] += land.wooded(land.parcel(at));
  }
  for (std::size_t i = 0; i < kPieces; ++i) EXPECT_TRUE(wooded[i] < 10 || shrubs[i] >= 2) << i;
}

TEST(FarObjects, OfSmallPicturesAreFew) {
  FarLand land(FarLandShape{}, disc(150), Seed{1});
  EXPECT_LE(far_objects(land, view_of(64 * 48, 0.8 / 64), Seed{1}).size(), 70u);
}

TEST(FarObjects, OfOpenLandAreNone) {
  FarLandShape open;
  open.woods = open.hedges = open.villages = 0;
  FarView view = view_of(640 * 360, 0.8 / 640);
  EXPECT_TRUE(far_objects(FarLand(open, disc(150), Seed{1}), view, Seed{1}).empty());
  open.hedges = 0.01;
  EXPECT_FALSE(far_objects(FarLand(open, disc(150), Seed{1}), view, Seed{1}).empty());
}

TEST(FarShapes, AreSound) {
  for (int kind = 0; kind < kFarKinds; ++kind)
    for (const Surface& shape : far_shapes(static_cast<FarKind>(kind))) {
      EXPECT_EQ(shape.find_fault(), "");
      EXPECT_LT(shape.triangle.size(), 2000u);
      float low = 1e9f, high = -1e9f;
      for (const Vec3& p : shape.position) low = std::min(low, p.y), high = std::max(high, p.y);
      bool house = static_cast<FarKind>(kind) == FarKind::house;
      EXPECT_LE(low, house ? 0 : 0.3f);
      EXPECT_GT(high, house ? 6 : 0.8f);
      EXPECT_LT(high, house ? 12 : 1.25f);
    }
}

}  // namespace
}  // namespace frond
