#include "organisms/plant/organ_prototypes.h"

#include <gtest/gtest.h>

#include <set>

#include "core/bounds.h"

namespace frond {
namespace {

constexpr std::size_t kCorners = 18;  // of a leaflet

/// The leaf of a palm: by lot drooping, level or upright, then a pair of leaflets a step.
OrganParams palm_leaf(int leaflets) {
  OrganParams organ;
  organ.symbol = "L";
  organ.shape = OrganShape::grammar;
  organ.leaflets = leaflets;
  GrammarText& text = organ.grammar.emplace();
  text.axiom = "L";
  text.steps = 7;
  text.angle = 14.5;
  text.rules = {{"L ->(0.33) &&F[+++F][---F]l"},
                {"L ->(0.33) F[+++F][---F]l"},
                {"L ->(0.34) ^^^l"},
                {"l -> &F[+++F][---F]l"}};
  return organ;
}

OrganParams drawn(const std::string& axiom, int leaflets = 1) {
  OrganParams organ = palm_leaf(leaflets);
  organ.fold = organ.droop = 0;
  organ.grammar->axiom = axiom;
  organ.grammar->angle = 30;
  organ.grammar->steps = 0;
  organ.grammar->rules.clear();
  return organ;
}

/// The feet of leaflets: the middles of their first rows.
std::vector<Vec3> feet(const Surface& blades) {
  std::vector<Vec3> feet;
  for (std::size_t i = 0; i < blades.position.size(); i += kCorners) feet.push_back(blades.position[i + 1]);
  return feet;
}

TEST(DrawnOrgan, HasALeafletForEachBranchOfOneSegment) {
  std::set<std::size_t> pairs;
  for (int leaflets : {0, 1, 2, 5, 8}) {
    for (std::uint64_t i = 0; i < 12; ++i) {
      Result<TwigParts> leaf = drawn_foliage(palm_leaf(leaflets), Seed{3}.child(i));
      ASSERT_TRUE(leaf.ok()) << leaf.errors()[0].text();
      std::size_t count = leaf->blades.position.size() / kCorners,
                  each = static_cast<std::size_t>(std::max(1, leaflets));
      ASSERT_EQ(count % (2 * each), 0u);
      pairs.insert(count / (2 * each));
      EXPECT_FALSE(leaf->stem.triangle.empty());
      int left = 0;
      for (std::size_t k = 0; k < leaf->blades.position.size(); k += kCorners)  // as many on either side
        left += leaf->blades.position[k + kCorners - 2].x < 0 ? 1 : -1;
      EXPECT_EQ(left, 0);
      EXPECT_EQ(leaf->blades.position, drawn_foliage(palm_leaf(leaflets), Seed{3}.child(i))->blades.position);
    }
  }
  EXPECT_EQ(pairs, (std::set<std::size_t>{6, 7}));  // an upright one begins a step later
}

TEST(DrawnOrgan, SpreadsLeafletsEvenlyAlongItsStem) {
  std::string axiom;
  for (int i = 0; i < 4; ++i) axiom += "F(2)[+F(1)][-F(1)]";
  for (int leaflets : {1, 2, 3, 4, 7}) {
    TwigParts leaf = *drawn_foliage(drawn(axiom, leaflets), Seed{1});
    std::multiset<int> places;  // in parts of the stem, which is one unit long
    for (Vec3 foot : feet(leaf.blades)) {
      EXPECT_NEAR(foot.x, 0, 1e-5);
      float place = foot.y * 4 * static_cast<float>(leaflets);
      EXPECT_NEAR(place, std::round(place), 1e-3);
      places.insert(static_cast<int>(std::round(place)));
    }
    for (int k = 1; k <= 4 * leaflets; ++k) EXPECT_EQ(places.count(k), 2u) << k;
    EXPECT_NEAR(bounds_of(leaf.stem.position).high.y, 1, 0.02);
  }
}

TEST(DrawnOrgan, TurnsLeafletsFromOneDrawnToTheNext) {
  // From 30 to 60 degrees, and from one length to twice as much.
  TwigParts leaf = *drawn_foliage(drawn("F[+(30)F(0.2)]F[+(60)F(0.4)]", 5), Seed{1});
  ASSERT_EQ(leaf.blades.position.size(), 10 * kCorners);
  float before = 0;
  for (std::size_t i = 4; i < 10; ++i) {
    Vec3 way = leaf.blades.position[(i + 1) * kCorners - 2] - leaf.blades.position[i * kCorners + 1];
    float angle = std::atan2(-way.x, way.y), share = static_cast<float>(i - 4) / 5;
    EXPECT_GT(angle, before);
    EXPECT_NEAR(glm::length(way), 0.1f * (1 + share), 0.025f * (1 + share));
    before = angle;
  }
  EXPECT_NEAR(before, radians(60.0), 0.01);
}

TEST(DrawnOrgan, HasOutlinesAsBlades) {
  TwigParts leaf = *drawn_foliage(drawn("F(2){.+F(1).-F(1).-F(1).}"), Seed{1});
  EXPECT_GE(leaf.blades.triangle.size(), 1u);
  EXPECT_EQ(leaf.blades.uv.size(), leaf.blades.position.size());
  TwigParts bare = *drawn_foliage(drawn("{.+f.--f.}"), Seed{1});
  EXPECT_EQ(bare.blades.triangle.size(), 1u);
  EXPECT_TRUE(bare.stem.position.empty());
}

TEST(DrawnOrgan, TellsWhatCannotBeDrawn) {
  EXPECT_NE(drawn_foliage(drawn("F~K"), Seed{1}).errors()[0].what.find("places an organ \"K\""),
            std::string::npos);
  EXPECT_NE(drawn_foliage(drawn("X+f"), Seed{1}).errors()[0].what.find("draws nothing"), std::string::npos);
  OrganParams endless = drawn("F");
  endless.grammar->rules = {{"F -> FFFFFFFF"}}, endless.grammar->steps = 9;
  EXPECT_NE(drawn_foliage(endless, Seed{1}).errors()[0].what.find("an organ has 200000 at most"),
            std::string::npos);
}

TEST(DrawnOrgan, UnfoldsAsOrgansDo) {
  PlantParams plant;
  plant.grammar.axiom = "F(1)[&~L]F(1)[^~L]F(1)L";
  plant.organs = {palm_leaf(4)};
  plant.organs[0].size = 2;
  plant.organs[0].variants = 6;
  Result<Model> model = grow_plant(plant, Seed{2});
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->find_fault(), "");
  ASSERT_EQ(model->organs.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(model->organs.birth[i], (static_cast<float>(i) + 1) / 3, 1e-5);
    EXPECT_NEAR(model->organs.scale[i].y, 2, 0.25);
    EXPECT_NE(model->organs.node[i], Skeleton::kRoot);
  }
  EXPECT_EQ(model->prototypes.size(), 6u + 2u);
  EXPECT_NE(model->prototypes[0].parts[0].surface.position, model->prototypes[1].parts[0].surface.position);
}

}  // namespace
}  // namespace frond
