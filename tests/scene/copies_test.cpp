#include "scene/copies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "scene/copy_organs.h"

namespace frond {
namespace {

Organism organism(const std::string& json, const std::string& seed = "1") {
  Result<Preset> preset =
      read_preset(R"({"seed": )" + seed + R"(, "organisms": [)" + json + "]}", "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return preset->organisms.at(0);
}

std::string tree(const std::string& more = "") {
  return R"({"kind": "tree", "years": 12, "leaves": {"colors": ["#336600", "#447711", "#558822"]}, "sown": {"models": 3)" +
         more + "}}";
}

const CopyPart& part_of(const std::vector<CopyPart>& parts, CopyPart::Kind kind) {
  for (const CopyPart& part : parts)
    if (part.kind == kind) return part;
  ADD_FAILURE() << "no such part";
  return parts.front();
}

TEST(CopyKey, DependsOnWhatGrowsAlone) {
  Organism plain = organism(tree());
  auto key = [](const Organism& o, int which) { return copy_id(o, which); };
  EXPECT_EQ(key(plain, 1), key(organism(tree(), "99"), 1))
      << "the scene's seed moves copies, it grows nothing anew";
  EXPECT_EQ(key(plain, 1), key(organism(R"({"name": "x", "count": 7,)" + tree().substr(1)), 1));
  EXPECT_EQ(key(plain, 1), key(organism(tree(R"(, "where": {"radius": 9}, "tint": {"hue": 90})")), 1));
  EXPECT_NE(key(plain, 0), key(plain, 1));
  EXPECT_NE(key(plain, 1), key(organism(tree(R"(, "crowd": 4)")), 1));
  std::string older = tree();
  EXPECT_NE(key(plain, 1), key(organism(older.replace(older.find("12"), 2, "13")), 1));
}

TEST(CopyKey, AChangedSeedTouchesItsModelOnly) {
  Organism first = organism(tree(R"(, "seeds": [5, 6, 7])")),
           second = organism(tree(R"(, "seeds": [5, 60, 7])"));
  EXPECT_EQ(copy_id(first, 0), copy_id(second, 0));
  EXPECT_NE(copy_id(first, 1), copy_id(second, 1));
  EXPECT_EQ(copy_id(first, 2), copy_id(second, 2));
}

TEST(CopyParts, BecomeFewerAndKeepTheirLeaves) {
  Organism o = organism(tree());
  Result<Model> model = grow_copy(o, 0);
  ASSERT_TRUE(model);
  std::size_t triangles = SIZE_MAX;
  double first = 0;
  for (double grain : {0.002, 0.01, 0.04, 0.16}) {
    std::vector<CopyPart> parts = copy_parts(o.grower->appearance().look, *model, {grain, 1e9});
    std::size_t now = 0;
    for (const CopyPart& part : parts) {
      EXPECT_EQ(part.surface.find_fault(), "");
      now += part.surface.triangle.size();
    }
    EXPECT_LT(now, triangles) << grain;
    triangles = now;
    double leaves = area(part_of(parts, CopyPart::Kind::organ).surface);
    if (first == 0) first = leaves;
    EXPECT_NEAR(leaves, first, 0.3 * first) << grain;
  }
  EXPECT_LT(triangles, 4000u);
}

TEST(CopyParts, KeepToTheirTriangles) {
  Organism o = organism(tree());
  Result<Model> model = grow_copy(o, 0);
  ASSERT_TRUE(model);
  double first = 0;
  for (double most : {1e9, 5000.0, 1000.0, 200.0}) {
    const std::vector<CopyPart> parts = copy_parts(o.grower->appearance().look, *model, {0.002, most});
    const Surface& leaves = part_of(parts, CopyPart::Kind::organ).surface;
    EXPECT_LT(static_cast<double>(leaves.triangle.size()), 2 * most);
    if (first == 0) first = area(leaves);
    EXPECT_NEAR(area(leaves), first, 0.4 * first) << most;
  }
}

TEST(CopyParts, HaveNoMoreLeavesThanHide) {
  Organism o = organism(tree());
  Result<Model> model = grow_copy(o, 0);
  ASSERT_TRUE(model);
  for (Vec3& scale : model->organs.scale) scale *= 6.0f;  // leaves over leaves
  const std::vector<double> areas = organ_areas(*model);
  const double all = std::accumulate(areas.begin(), areas.end(), 0.0), share = hiding_share(*model, all);
  ASSERT_LT(share, 0.5);
  auto leaves = [&](double most) { return copy_parts(o.grower->appearance().look, *model, {0.002, most}); };
  const double whole = area(part_of(leaves(1e9), CopyPart::Kind::organ).surface);
  const double few = area(part_of(leaves(200), CopyPart::Kind::organ).surface);
  EXPECT_NEAR(few, share * whole, 0.4 * share * whole);
  EXPECT_GT(area(part_of(leaves(5000), CopyPart::Kind::organ).surface), 0.6 * share * whole);
}

TEST(CopyParts, LeavesKnowTheirColor) {
  Organism o = organism(tree());
  Result<Model> model = grow_copy(o, 0);
  ASSERT_TRUE(model);
  std::array<int, 3> wanted{}, drawn{};
  for (std::int32_t color : model->organs.color) ++wanted[static_cast<std::size_t>(color)];
  std::vector<CopyPart> parts = copy_parts(o.grower->appearance().look, *model, {});
  const Surface& leaves = part_of(parts, CopyPart::Kind::organ).surface;
  for (Vec2 uv : leaves.uv) {
    EXPECT_GE(uv.x, 0);
    EXPECT_LT(uv.x, 4096);
    ++drawn[static_cast<std::size_t>(uv.x) % 3];
  }
  double all = static_cast<double>(model->organs.size()), corners = static_cast<double>(leaves.uv.size());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(wanted[k] / all, drawn[k] / corners, 1e-6);
}

TEST(CopyParts, HaveNoDew) {
  Organism o = organism(R"j({"kind": "plant", "grammar": {"axiom": "F(0.1)L"}, "sown": {"models": 1},
      "organs": [{"symbol": "L", "dew": 5}]})j");
  Result<Model> model = grow_copy(o, 0);
  ASSERT_TRUE(model);
  ASSERT_EQ(model->prototypes[0].parts.size(), 2u);
  std::vector<CopyPart> parts = copy_parts(o.grower->appearance().look, *model, {});
  EXPECT_EQ(std::ranges::count(parts, CopyPart::Kind::organ, &CopyPart::kind), 1);
}

TEST(GrowCopy, IsTheSameEachTimeAndAnotherInACrowd) {
  Organism o = organism(tree());
  Result<Model> first = grow_copy(o, 1), again = grow_copy(o, 1), other = grow_copy(o, 2);
  Result<Model> crowded = grow_copy(organism(tree(R"(, "crowd": 1.5)")), 1);
  EXPECT_EQ(first->skeleton.position, again->skeleton.position);
  EXPECT_NE(first->skeleton.position, other->skeleton.position);
  EXPECT_NE(first->skeleton.position, crowded->skeleton.position);
  EXPECT_LT(first->skeleton.position[0].y, 0) << "stands in the ground";
}

}  // namespace
}  // namespace frond
