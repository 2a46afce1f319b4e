#include "images/leaf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace frond {
namespace {

LeafImage leaf_of(std::string_view name) {
  LeafImage leaf;
  leaf.outline = leaf_outline(name);
  return leaf;
}

TEST(Leaf, EveryNamedOutlineIsOneUnitLong) {
  EXPECT_GE(leaf_names().size(), 10u);
  for (std::string_view name : leaf_names()) {
    std::vector<Vec2> rim = leaf_rim(leaf_outline(name), 40);
    ASSERT_EQ(rim.size(), 40u) << name;
    EXPECT_NEAR(rim.front().y, 1, 1e-5) << name;
    EXPECT_NEAR(rim.back().y, leaf_outline(name).stalk, 1e-5) << name;
    for (Vec2 p : rim) EXPECT_GE(p.x, 0) << name;
  }
  EXPECT_TRUE(leaf_outline("lettuce").radii.empty());
}

TEST(Leaf, TheMeshCoversWhatThePictureShows) {
  // The share of the picture that is opaque is the area of the flat mesh: they are cut from one curve.
  for (std::string_view name : leaf_names()) {
    LeafImage leaf = leaf_of(name);
    Raster picture = leaf_picture(leaf, 200, Seed{1});
    PictureFrame frame = picture_frame(leaf);
    double opaque = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) opaque += picture.at(x, y, 3) / 255.0;
    double pictured = opaque / (200.0 * picture.width) * 2 * frame.half * (frame.high - frame.low);
    Surface mesh = leaf_mesh(leaf, 48, 0, 0);
    EXPECT_EQ(mesh.find_fault(), "") << name;
    EXPECT_NEAR(area(mesh) / pictured, 1, 0.08) << name;
  }
}

TEST(Leaf, EveryTrianglesMiddleIsOpaque) {
  for (bool sprig : {false, true}) {
    for (std::string_view name : {"birch", "oak", "maple"}) {
      LeafImage leaf = leaf_of(name);
      leaf.sprig = sprig;
      Raster picture = leaf_picture(leaf, 400, Seed{1});
      Surface mesh = leaf_mesh(leaf, 24, radians(20.0), radians(30.0));
      double clear = 0;
      for (auto [a, b, c] : mesh.triangle) {
        Vec2 at = (mesh.uv[a] + mesh.uv[b] + mesh.uv[c]) / 3.0f;
        int x = static_cast<int>(at.x * static_cast<float>(picture.width)),
            y = static_cast<int>((1 - at.y) * 400);
        clear += picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, 399), 3) < 128;
      }
      EXPECT_LE(clear / static_cast<double>(mesh.triangle.size()), 0.04) << name << sprig;
    }
  }
}

TEST(Leaf, NoLeafOrSprigIsCutOffAtTheEdgeOfItsPicture) {
  for (std::string_view name : leaf_names()) {
    for (int kind = 0; kind < 3; ++kind) {
      LeafImage leaf = leaf_of(name);
      leaf.sprig = kind > 0;
      leaf.sprigs.end_leaf = kind == 1;
      for (Vec2 uv : leaf_mesh(leaf, 24, 0, 0).uv) {
        EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1) << name << kind;
      }
      if (!leaf.sprig) continue;
      Raster picture = leaf_picture(leaf, 200, Seed{1});
      int drawn = 0;
      for (int x = 0; x < picture.width; ++x) drawn += picture.at(x, 0, 3) + picture.at(x, 199, 3);
      for (int y = 0; y < 200; ++y) drawn += picture.at(0, y, 3) + picture.at(picture.width - 1, y, 3);
      EXPECT_EQ(drawn, 0) << name << kind;
    }
  }
}

TEST(Leaf, VeinsOfTurnedLeafletsAreWholeLines) {
  LeafImage leaf = leaf_of("aspen");
  leaf.sprig = true;
  leaf.sprigs.pairs = 1;
  leaf.sprigs.end_leaf = false;
  leaf.spots = 0;
  leaf.color = leaf.rim = {0, 0, 0};
  leaf.veins = {1, 1, 1};
  PictureFrame frame = picture_frame(leaf);
  Raster picture = leaf_picture(leaf, 256, Seed{1});
  LeafPlace place = sprig_places(leaf.sprigs)[0];
  auto brightness = [&](Vec2 p) {
    double c = std::cos(place.turn), s = std::sin(place.turn);
    double x = place.foot.x + place.size * (p.x * c + p.y * s),
           y = place.foot.y + place.size * (p.y * c - p.x * s);
    double column = (x / frame.half * 0.5 + 0.5) * picture.width - 0.5,
           row = (frame.high - y) / (frame.high - frame.low) * picture.height - 0.5;
    int most = 0;
    for (int i = 0; i < 4; ++i)
      most =
          std::max<int>(most, picture.at(static_cast<int>(column) + i % 2, static_cast<int>(row) + i / 2, 0));
    return most;
  };
  // Along the third side vein: wherever one looks, some of the four pixels round the place show it.
  double stalk = leaf.outline.stalk;
  for (double x = 0.04; x < 0.2; x += 0.004) {
    double y = 0.75 * x + 0.5 * x * x + stalk + (2.35 / 9) * (1 - stalk);
    EXPECT_GT(brightness(Vec2(x, y)), 10) << x;
  }
}

TEST(Leaf, FarLeavesHaveFewerTriangles) {
  LeafImage leaf = leaf_of("oak");
  std::size_t before = 1000000;
  double whole = area(leaf_mesh(leaf, 48, 0, 0));
  for (int points : {48, 24, 12, 6, 3}) {
    Surface mesh = leaf_mesh(leaf, points, 0, 0);
    EXPECT_LT(mesh.triangle.size(), before);
    EXPECT_NEAR(area(mesh) / whole, 1, 0.4) << points;
    before = mesh.triangle.size();
  }
  EXPECT_LE(before, 6u);
}

TEST(Leaf, FacesUpAndBendsDown) {
  LeafImage leaf = leaf_of("beech");
  Surface flat = leaf_mesh(leaf, 12, 0, 0);
  for (Vec3 n : flat.normal) EXPECT_GT(n.z, 0.99f);
  Surface bent = leaf_mesh(leaf, 12, 0, radians(80.0));
  float low = 0, tip = 0;
  for (Vec3 p : bent.position) {
    low = std::min(low, p.z);
    tip = std::max(tip, p.y);
  }
  EXPECT_LT(low, -0.3f);
  EXPECT_LT(tip, 0.8f);
}

TEST(Leaf, APalmatePictureHasVeinsToItsLobes) {
  LeafImage leaf = leaf_of("maple");
  leaf.spots = 0;
  leaf.color = {0, 0, 0};
  leaf.rim = {0, 0, 0};
  leaf.veins = {1, 1, 1};
  Raster picture = leaf_picture(leaf, 300, Seed{1});
  double bright = 0, opaque = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at(x, y, 3) < 255) continue;
      ++opaque;
      bright += picture.at(x, y, 0) > 90;
    }
  EXPECT_GT(bright / opaque, 0.02);
  EXPECT_LT(bright / opaque, 0.35);
}

TEST(Leaf, OneThatCurlsLeavesThePlaneAndKeepsItsArea) {
  LeafImage leaf = leaf_of("maple");
  Surface flat = leaf_mesh(leaf, 40, 0, 0), curled = leaf_mesh(leaf, 40, 0, 0, {1, 0.4});
  EXPECT_EQ(curled.find_fault(), "");
  EXPECT_NEAR(area(curled) / area(flat), 1, 0.2);  // it buckles
  float high = 0;
  for (Vec3 p : curled.position) high = std::max(high, p.z);
  EXPECT_GT(high, 0.1f);
  EXPECT_NE(curled.position, leaf_mesh(leaf, 40, 0, 0, {1, 2.0}).position);
  // Its upper side is up.
  Vec3 up(0);
  for (Vec3 n : leaf_mesh(leaf, 40, 0, 0, {0.01, 0}).normal) up += n;
  EXPECT_GT(glm::normalize(up).z, 0.9f);
}

TEST(Leaf, AgeBrownsTheRimFirst) {
  LeafImage leaf = leaf_of("beech");
  leaf.spots = 0;
  auto greens = [&](double age) {
    leaf.age = age;
    Raster picture = leaf_picture(leaf, 200, Seed{1});
    std::array<double, 2> green{};  // at the rim, and near the midrib
    for (int y = 40; y < 140; ++y) {
      int x = 0;
      while (picture.at(x, y, 3) < 255) ++x;
      green[0] += picture.at(x + 2, y, 1);
      green[1] += picture.at(picture.width / 2 - 6, y, 1);
    }
    return green;
  };
  auto fresh = greens(0), turning = greens(0.3), old = greens(1);
  EXPECT_LT(turning[0], 0.9 * fresh[0]);
  EXPECT_GT(turning[1], 0.95 * fresh[1]);
  EXPECT_LT(old[1], 0.8 * fresh[1]);
}

TEST(Sprig, HasAnEndLeafOrNot) {
  Sprig sprig;
  sprig.pairs = 5;
  EXPECT_EQ(sprig_places(sprig).size(), 11u);
  EXPECT_EQ(sprig_places(sprig).back().turn, 0);
  sprig.end_leaf = false;
  EXPECT_EQ(sprig_places(sprig).size(), 10u);
  for (const LeafPlace& p : sprig_places(sprig)) EXPECT_NE(p.turn, 0);
}

}  // namespace
}  // namespace frond
