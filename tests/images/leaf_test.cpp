#include "images/leaf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "images/leaf_blade.h"
#include "images/leaf_relief.h"

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
  // Along the side veins of the right half: wherever one looks, some of the four pixels round the place show
  // one. The larger veins are the same for all seeds.
  Veins veins = grow_veins(leaf.outline, 0.1, Seed{0});
  int seen = 0;
  for (std::size_t i = 1; i < veins.size(); ++i) {
    Vec2 a = veins.point[static_cast<std::size_t>(veins.parent[i])], b = veins.point[i];
    if (veins.order[i] != 2 || b.x < 0.04f || b.x > 0.2f) continue;
    for (float t : {0.0f, 0.25f, 0.5f, 0.75f})
      EXPECT_GT(brightness(glm::mix(a, b, t)), 10) << b.x << " " << b.y;
    ++seen;
  }
  EXPECT_GT(seen, 30);
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

TEST(Leaf, PleatsFollowTheSecondaries) {
  LeafImage leaf = leaf_of("beech");
  Surface flat = leaf_mesh(leaf, 24, 0, 0);
  leaf.pleat = 1;
  Surface pleated = leaf_mesh(leaf, 24, 0, 0);
  EXPECT_EQ(pleated.find_fault(), "");
  EXPECT_GT(area(pleated), 1.02 * area(flat));
  EXPECT_LT(area(pleated), 1.6 * area(flat));
  for (Vec3 n : pleated.normal) EXPECT_GT(n.z, 0.2f);
  // It lies in its plane at the midrib and along the veins, and above it between them.
  float high = 0;
  for (Vec3 p : pleated.position) {
    high = std::max(high, p.z);
    if (std::abs(p.x) < 1e-4f) {
      EXPECT_NEAR(p.z, 0, 1e-4f);
    }
    EXPECT_GE(p.z, -1e-5f);
  }
  EXPECT_GT(high, 0.015f);
  Lamina blade(leaf.outline);
  for (const SecondaryLine& line : secondary_lines(leaf.outline)) {
    Vec2 end = blade.middle() + (line.to - blade.middle()) / static_cast<float>(blade.out(line.to));
    float nearest = 1, height = 1;
    for (Vec3 p : pleated.position)
      if (float d = glm::distance(Vec2(p), end); d < nearest) nearest = d, height = p.z;
    EXPECT_LT(nearest, 1e-3f);
    EXPECT_LT(height, 1e-4f);
  }
  // Far leaves stay as they are.
  EXPECT_EQ(leaf_mesh(leaf, 8, 0, 0).triangle.size(), leaf_mesh(leaf_of("beech"), 8, 0, 0).triangle.size());
  // And so do those without secondaries.
  LeafImage maple = leaf_of("maple");
  maple.pleat = 1;
  EXPECT_EQ(leaf_mesh(maple, 24, 0, 0).position, leaf_mesh(leaf_of("maple"), 24, 0, 0).position);
}

TEST(Leaf, PleatsKeepTheOutline) {
  for (std::string_view name : leaf_names()) {
    LeafImage leaf = leaf_of(name);
    double flat = area(leaf_mesh(leaf, 40, 0, 0));
    leaf.pleat = 1e-6;
    Surface pleated = leaf_mesh(leaf, 40, 0, 0);
    EXPECT_EQ(pleated.find_fault(), "") << name;
    EXPECT_NEAR(area(pleated) / flat, 1, 0.02) << name;
  }
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

TEST(Leaf, ReliefFollowsTheVeins) {
  LeafImage leaf = leaf_of("beech");
  Grid heights = leaf_heights(leaf, 300, Seed{1});
  PictureFrame frame = picture_frame(leaf);
  auto at = [&](Vec2 p) {
    return heights.at(static_cast<int>((p.x / frame.half * 0.5 + 0.5) * heights.width),
                      static_cast<int>((frame.high - p.y) / (frame.high - frame.low) * heights.height));
  };
  Veins veins = grow_veins(leaf.outline, 0.1, Seed{0});
  int sunk = 0, all = 0;
  for (std::size_t i = 1; i < veins.size(); ++i)
    if (veins.order[i] <= 2) sunk += at(veins.point[i]) < -0.3f, ++all;
  EXPECT_GT(all, 100);
  EXPECT_GT(sunk, 0.95 * all);
  EXPECT_GT(*std::ranges::max_element(heights.data), 0.8f);
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

TEST(Sprig, DigitateLeavesSpreadFromOnePointAndTheMiddleOneIsTheLargest) {
  Sprig sprig;
  sprig.arrangement = SprigArrangement::digitate;
  sprig.pairs = 3;
  sprig.angle = radians(120.0);
  sprig.length = 0.6;
  sprig.shrink = 0.5;
  std::vector<LeafPlace> places = sprig_places(sprig);
  ASSERT_EQ(places.size(), 7u);
  for (const LeafPlace& p : places) {
    EXPECT_EQ(p.foot, places[0].foot);
    EXPECT_LE(std::abs(p.turn), sprig.angle + 1e-9);
    if (&p != &places.back()) {
      EXPECT_LT(p.size, places.back().size);
    }
  }
  EXPECT_EQ(places.back().turn, 0);
  EXPECT_NEAR(places.back().foot.y + places.back().size, 1, 1e-6);
  EXPECT_NEAR(places[0].turn, sprig.angle, 1e-9);
  EXPECT_NEAR(places[0].size, 0.3, 1e-9);
  // All gaps between them are equal, also without a leaf at the tip.
  for (bool end : {true, false}) {
    sprig.end_leaf = end;
    std::vector<double> turns;
    for (const LeafPlace& p : sprig_places(sprig)) turns.push_back(p.turn);
    std::ranges::sort(turns);
    for (std::size_t i = 2; i < turns.size(); ++i)
      EXPECT_NEAR(turns[i] - turns[i - 1], turns[1] - turns[0], 1e-9) << end;
  }
  LeafImage leaf = leaf_of("cherry");
  leaf.sprig = true;
  leaf.sprigs = sprig;
  Surface mesh = leaf_mesh(leaf, 12, 0, 0);
  EXPECT_EQ(mesh.find_fault(), "");
  for (Vec2 uv : mesh.uv) EXPECT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
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
