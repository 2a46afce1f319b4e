#include "crown/arbaro.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>
#include <vector>

#include "crown/arbaro_species.h"

namespace frond {
namespace {

std::string species(std::string_view params) {
  return "<?xml version='1.0' ?>\n<arbaro>\n<species name='test'>\n" + std::string(params) +
         "</species>\n</arbaro>\n";
}

TEST(Arbaro, ReadsEveryParameter) {
  std::string text;
  for (const std::string& name : arbaro_names()) {
    std::string value = name == "LeafShape" || name == "Species" ? "disc" : "1";
    text += "<param name='" + name + "' value='" + value + "'/>\n";
  }
  Result<ArbaroSpecies> read = read_arbaro(species(text), "test.xml");
  ASSERT_TRUE(read.ok()) << read.errors()[0].text();
  EXPECT_EQ(read->tree.shape, CrownShape::spherical);
  EXPECT_NEAR(read->tree.level[3].curve_back, radians(1.0), 1e-12);
  EXPECT_EQ(read->tree.level[2].curve_res, 1);
  EXPECT_EQ(arbaro_names().size(), 2u + 29 + 4 * 16);  // and what trunks alone have
  std::set<std::string> once;
  for (const std::string& name : arbaro_names()) EXPECT_TRUE(once.insert(name).second) << name;
}

TEST(Arbaro, PutsValuesWhereTheyBelong) {
  Result<ArbaroSpecies> read = read_arbaro(
      species("<!-- a comment -->\n<param name='Shape' value='7'/>\n<param name='1DownAngle' value='60'/>\n"
              "<param name='0SegSplits' value='0.4'/><param name='Leaves' value='-25'/>\n"
              "<param name='PruneRatio' value='1.0'/><param name='LeafDistrib' value='3'/>\n"),
      "test.xml");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->name, "test");
  EXPECT_EQ(read->tree.shape, CrownShape::tend_flame);
  EXPECT_NEAR(read->tree.level[1].down_angle, radians(60.0), 1e-12);
  EXPECT_NEAR(read->tree.level[0].seg_splits, 0.4, 1e-12);
  EXPECT_EQ(read->tree.leaves, -25);
  EXPECT_EQ(read->tree.pruning.ratio, 1);
  EXPECT_EQ(read->tree.leaf_distribution, CrownShape::cylindrical);
  EXPECT_EQ(read->tree.leaf_stem_length, 0.5);  // Arbaro's default
}

TEST(Arbaro, ReportsEveryFaultWithItsLine) {
  Result<ArbaroSpecies> read = read_arbaro(species("<param name='Scael' value='12'/>\n"
                                                   "<param name='Levels' value='2.5'/>\n"
                                                   "<param name='4Curve' value='1'/>\n"
                                                   "<param name='Shape' value='nine'/>\n<leaf/>\n"),
                                           "test.xml");
  ASSERT_FALSE(read.ok());
  ASSERT_EQ(read.errors().size(), 5u);
  EXPECT_EQ(read.errors()[0].where, "test.xml:4");
  EXPECT_NE(read.errors()[0].what.find("did you mean \"Scale\"?"), std::string::npos);
  EXPECT_EQ(read.errors()[1].where, "test.xml:5");
  EXPECT_NE(read.errors()[1].what.find("whole number from 1 to 9"), std::string::npos);
  EXPECT_FALSE(read_arbaro("<arbaro><species>", "x").ok());
  EXPECT_FALSE(read_arbaro("<tree/>", "x").ok());
  EXPECT_FALSE(read_arbaro("", "x").ok());
}

/// A file of Arbaro with `name value name value ...`.
Result<ArbaroSpecies> read_params(std::string_view params) {
  std::istringstream words{std::string(params)};
  std::string name, value, text;
  while (words >> name >> value)
    text += "<param name='" + name + "' value='" + (value[0] == '.' ? "0" + value : value) + "'/>\n";
  return read_arbaro(species(text), "test.xml");
}

/// Stems and clones: what begins on a stem of another level, or beside what goes on from its node.
int count_stems(const Skeleton& s) {
  std::vector<bool> goes_on(s.size(), false);
  int count = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    bool same = p != Skeleton::kRoot && s.order[p] == s.order[i];
    count += !same || goes_on[p];
    if (same) goes_on[p] = true;
  }
  return count;
}

TEST(Arbaro, SpeciesHaveAsManyStemsAndLeavesAsArbaroMakes) {
  constexpr int kSeeds = 4;
  for (const KnownSpecies& known : kKnownSpecies) {
    Result<ArbaroSpecies> read = read_params(known.params);
    ASSERT_TRUE(read.ok()) << known.name << ": " << read.errors()[0].text();
    double stems = 0, leaves = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Result<Crown> crown = grow_weber_penn(read->tree, Seed{seed});
      ASSERT_TRUE(crown.ok()) << known.name;
      EXPECT_EQ(crown->skeleton.find_fault(), "") << known.name;
      stems += count_stems(crown->skeleton) / double{kSeeds};
      leaves += static_cast<double>(crown->leaves.size()) / kSeeds;
    }
    EXPECT_NEAR(stems / known.stems, 1, 0.15) << known.name;
    EXPECT_NEAR(leaves / known.leaves, 1, 0.15) << known.name;
  }
}

TEST(Arbaro, TrunksStandBesideEachOther) {
  Result<ArbaroSpecies> read =
      read_params("Levels 1 Scale 2 0Branches 9 0BranchDist .3 0DownAngle 20 0Rotate 40 Flare 0");
  ASSERT_TRUE(read.ok());
  Result<Crown> crown = grow_weber_penn(read->tree, Seed{3});
  ASSERT_TRUE(crown.ok());
  std::set<float> feet;
  const Skeleton& s = crown->skeleton;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] != Skeleton::kRoot) continue;
    Vec3 foot = s.position[i];
    feet.insert(foot.x);
    EXPECT_LE(std::hypot(foot.x, foot.z), 0.3f);
    Vec3 way = glm::normalize(s.position[i + 1] - foot);
    EXPECT_NEAR(way.y, std::cos(radians(20.0)), 1e-4);
  }
  EXPECT_EQ(feet.size(), 9u);
}

TEST(Arbaro, AlternatingStemsStandHalfATurnLessTheirAngleToEitherSide) {
  Result<ArbaroSpecies> read = read_params("Levels 2 1Rotate -90 2Rotate -140 3Rotate -200 Leaves 1");
  ASSERT_TRUE(read.ok());
  // Ours is from side to side.
  EXPECT_NEAR(read->tree.level[1].rotate, radians(-180.0), 1e-9);
  EXPECT_NEAR(read->tree.level[2].rotate, radians(-80.0), 1e-9);
  EXPECT_NEAR(read->tree.level[3].rotate, radians(-40.0), 1e-9);
  // A fan spreads by the angle itself.
  read = read_params("Levels 2 2Rotate -140 Leaves -5");
  EXPECT_NEAR(read->tree.level[2].rotate, radians(-140.0), 1e-9);
}

TEST(Arbaro, ItsConesEndInAPoint) {
  Result<ArbaroSpecies> read = read_params("Shape 0");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->tree.cone_top, 0);
  EXPECT_EQ(WeberPenn{}.cone_top, 0.2);  // the paper's
}

TEST(Arbaro, NumbersBeyondWhatATreeCanHaveAreRefused) {
  for (std::string_view params :
       {"0Branches 1e300", "0Branches 0", "0CurveRes 1e300", "Levels -1e300", "Shape 8.5", "Leaves 1e18",
        "0BaseSplits 1e10", "1Branches 1e300", "2SegSplits 1e300", "Scale 1e300", "Lobes 2147483648"})
    EXPECT_FALSE(read_params(params).ok()) << params;
}

}  // namespace
}  // namespace frond
