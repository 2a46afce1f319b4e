#include "crown/arbaro.h"

#include <gtest/gtest.h>

#include <set>

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
  EXPECT_EQ(arbaro_names().size(), 2u + 29 + 4 * 16);
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

}  // namespace
}  // namespace frond
