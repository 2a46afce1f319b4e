// Levels of detail, and what stands in for leaves.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "export/foliage.h"
#include "export/formats.h"
#include "export/portrait.h"
#include "exported.h"

namespace frond {
namespace {

/// A small one, which takes a moment, or as its preset has it.
const Scene& tree(const std::string& name, bool young = true) {
  static std::map<std::pair<std::string, bool>, Scene> grown;
  auto at = grown.find({name, young});
  if (at == grown.end()) {
    // Alone, whatever stands round it in its preset.
    std::vector<std::string> sets{R"(/scene={"setting": "meadow", "floor": {"relief": 0.3}})"};
    if (young) sets.emplace_back("/organisms/0/years=9");
    std::string path = "presets/trees/" + name + ".json";
    Result<Preset> preset = read_preset(*read_file(path), path, sets);
    EXPECT_TRUE(preset) << preset.errors()[0].text();
    preset->organisms.resize(1);
    at = grown.emplace(std::pair(name, young), *build_scene(*preset)).first;
  }
  return at->second;
}

ExportScene exported_of(const Scene& scene, ExportOptions options) {
  options.bake.home = FROND_ROOT;
  Result<ExportScene> made = export_scene(scene, 0, options);
  EXPECT_TRUE(made) << made.errors()[0].text();
  return std::move(*made);
}

/// What a level of detail adds up to.
struct Level {
  std::vector<const ExportPart*> parts;
  Bounds box;
  double triangles = 0, leaves = 0, longest = 0;      // leaves: m2 of their triangles
  std::array<double, 8> silhouette{}, seen_leaves{};  // m2, from as many sides
};

/// The colours of leaves and of what is none, as they are seen on the first level: on pictures of the whole
/// only these tell them apart.
struct Tones {
  Vec3 leaf{0}, other{0};
  float leaves = 0, others = 0;

  void add(const Portrait& portrait) {
    for (std::size_t i = 0; i < portrait.cover.size(); ++i) {
      if (portrait.cover[i] < 0.99f) continue;
      if (portrait.leaves[i] > 0.99f) leaf += portrait.light[i], ++leaves;
      if (portrait.leaves[i] <= 0) other += portrait.light[i], ++others;
    }
  }
  double leafy(const Portrait& portrait) const {
    double sum = 0;
    for (std::size_t i = 0; i < portrait.cover.size(); ++i) {
      bool is_leaf = others == 0 || glm::distance(portrait.light[i], leaf / leaves) <
                                        glm::distance(portrait.light[i], other / others);
      if (is_leaf) sum += static_cast<double>(portrait.cover[i]);
    }
    return sum / static_cast<double>(portrait.cover.size());
  }
};

/// The share of a portrait in which a leaf is seen.
double leafy(const Portrait& portrait) {
  return std::accumulate(portrait.leaves.begin(), portrait.leaves.end(), 0.0) /
         static_cast<double>(portrait.leaves.size());
}

Level level_of(const ExportScene& exported, std::size_t number, const Bounds* frame = nullptr,
               Tones* tones = nullptr) {
  Level level;
  for (const ExportMesh& mesh : exported.meshes)
    if (mesh.has_level(number))
      for (const ExportPart& part : number == 0 ? mesh.parts : mesh.coarser[number - 1])
        level.parts.push_back(&part);
  std::vector<Sitter> sitters;
  for (const ExportPart* part : level.parts) {
    sitters.push_back({part});
    for (const Vec3& p : part->surface.position) level.box.extend(p);
    level.triangles += static_cast<double>(part->surface.triangle.size());
    if (!exported.materials[part->material].leaf) continue;
    level.leaves += area(part->surface);
    level.longest = std::max(level.longest, longest_edge(part->surface));
  }
  Painter painter(exported);
  std::vector<Portrait> portraits;
  for (std::size_t k = 0; k < 8; ++k) {
    PortraitView view = side_view(frame ? *frame : level.box, 2 * kPi * static_cast<double>(k) / 8, 240);
    view.fine = 2;
    Result<Portrait> portrait = painter.portrait(sitters, view);
    EXPECT_TRUE(portrait);
    Vec2 size = view.high - view.low;
    level.silhouette[k] = portrait->covered() * static_cast<double>(size.x * size.y);
    if (tones && number == 0) tones->add(*portrait);
    level.seen_leaves[k] = static_cast<double>(size.x * size.y);
    portraits.push_back(std::move(*portrait));
  }
  for (std::size_t k = 0; k < 8; ++k)
    level.seen_leaves[k] *= tones ? tones->leafy(portraits[k]) : leafy(portraits[k]);
  return level;
}

double sum(const std::array<double, 8>& sides) { return std::accumulate(sides.begin(), sides.end(), 0.0); }

/// How far two boxes are apart, as a share of the longest side of the first.
double apart(const Bounds& a, const Bounds& b) {
  Vec3 most = glm::max(glm::abs(a.low - b.low), glm::abs(a.high - b.high));
  return static_cast<double>(std::max({most.x, most.y, most.z}) / a.longest());
}

class LevelsOf : public testing::TestWithParam<std::tuple<const char*, int, double, bool>> {};

TEST_P(LevelsOf, keep_the_box_the_silhouette_and_the_leaves_of_the_first) {
  auto [name, texture, detail, young] = GetParam();
  ExportScene exported = exported_of(tree(name, young), {.detail = detail, .texture = texture, .levels = 4});
  Tones tones;
  Level first = level_of(exported, 0, nullptr, &tones);
  ASSERT_GT(first.leaves, 0);
  double before = first.triangles;
  for (std::size_t number = 1; number < 4; ++number) {
    Level level = level_of(exported, number, &first.box, &tones);
    std::string what = fmt::format("{} with {} pixels, level {}", name, texture, number);
    // Against all its needles the pictures of a young spruce's boughs differ more from one side, and less on
    // average.
    const double near = young && std::string_view(name) == "spruce" && texture > 0 ? 0.15 : 0.1;
    const double most = number == 1 ? near : 0.25, side = number == 3 && texture > 0 ? 0.15 : most;
    EXPECT_NEAR(sum(level.silhouette) / sum(first.silhouette), 1, 0.1) << what;
    double least = 9, largest = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      least = std::min(least, level.silhouette[k] / first.silhouette[k]);
      largest = std::max(largest, level.silhouette[k] / first.silhouette[k]);
    }
    printf(
        "%s: %.0f of %.0f triangles, box %.3f, silhouette %.3f (%.2f to %.2f), leaves seen %.3f, area %.3f, "
        "edge %.2f\n",
        what.c_str(), level.triangles, first.triangles, apart(first.box, level.box),
        sum(level.silhouette) / sum(first.silhouette), least, largest,
        sum(level.seen_leaves) / sum(first.seen_leaves), level.leaves / first.leaves,
        level.longest / first.longest);
    EXPECT_LT(apart(first.box, level.box), number == 3 ? 0.1 : 0.03) << what;
    EXPECT_LT(level.triangles, before * 1.001) << what;
    before = level.triangles;
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_NEAR(level.silhouette[k] / first.silhouette[k], 1, side) << what << ", side " << k;
      EXPECT_NEAR(level.seen_leaves[k] / first.seen_leaves[k], 1, most) << what << ", leaves, side " << k;
    }
    if (texture > 0) continue;
    EXPECT_NEAR(level.leaves / first.leaves, 1, 0.1) << what;
    EXPECT_LT(level.longest, 2.6 * first.longest) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Trees, LevelsOf,
                         testing::Values(std::tuple{"birch", 0, 2.5e5, true},
                                         std::tuple{"birch", 128, 2.5e5, true},
                                         std::tuple{"spruce", 0, 2.5e5, true},
                                         std::tuple{"spruce", 128, 8e4, true},
                                         std::tuple{"oak", 128, 8000.0, true}));

INSTANTIATE_TEST_SUITE_P(GrownTrees, LevelsOf,
                         testing::Values(std::tuple{"birch", 512, 8000.0, false},
                                         std::tuple{"spruce", 512, 8000.0, false},
                                         std::tuple{"oak", 512, 8000.0, false}));

TEST(LevelsOfATree, end_in_pictures_of_the_whole_that_cross) {
  ExportScene exported = exported_of(tree("birch"), {.texture = 128, .levels = 4});
  Level last = level_of(exported, 3);
  EXPECT_EQ(last.triangles, 6) << "three sides; what is tall needs no top";
  ASSERT_EQ(last.parts.size(), 1u);
  const ExportMaterial& material = exported.materials[last.parts[0]->material];
  EXPECT_TRUE(material.cutout && material.leaf);
  ASSERT_NE(material.colors, kNoPicture);
  ASSERT_NE(material.normals, kNoPicture);
  EXPECT_EQ(level_triangles(exported).size(), 4u);
  EXPECT_EQ(level_triangles(exported)[3], 6);
  ASSERT_TRUE(glb_bytes(exported));
}

TEST(LevelsOfATree, thin_a_trunk_by_no_half) {
  ExportScene exported = exported_of(tree("birch"), {.texture = 0, .levels = 4});
  auto girth = [&](std::size_t number) {  // of what stands on the ground
    Bounds foot;
    for (const ExportMesh& mesh : exported.meshes)
      if (mesh.name.ends_with("branches") && mesh.has_level(number))
        for (const ExportPart& part : number == 0 ? mesh.parts : mesh.coarser[number - 1])
          for (const Vec3& p : part.surface.position)
            if (p.y < 0.3f) foot.extend(p);
    return foot.empty() ? 0 : foot.size().x;
  };
  for (std::size_t number = 1; number < 4; ++number)
    EXPECT_GT(girth(number), 0.75f * girth(0)) << number << ", without the roots at its foot";
}

TEST(LeavesWithoutPictures, are_no_cards_and_keep_their_area_and_gaps) {
  std::vector<double> leaves, silhouettes;
  for (double detail : {1e9, 1.5e4, 7e3}) {
    ExportScene exported = exported_of(tree("birch"), {.detail = detail, .texture = 0});
    for (const ExportMaterial& material : exported.materials) EXPECT_FALSE(material.cutout) << material.name;
    Level level = level_of(exported, 0);
    leaves.push_back(level.leaves), silhouettes.push_back(sum(level.silhouette));
    printf("detail %g: %.0f triangles, leaves %.2f m2, silhouettes %.2f m2\n", detail, level.triangles,
           leaves.back(), silhouettes.back());
  }
  for (std::size_t k = 1; k < leaves.size(); ++k) {
    EXPECT_NEAR(leaves[k] / leaves[0], 1, 0.1);
    EXPECT_NEAR(silhouettes[k] / silhouettes[0], 1, 0.1);
  }
}

}  // namespace
}  // namespace frond
