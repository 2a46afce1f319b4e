// How bark lies on exported branches, and how twigs end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "export/export_scene.h"
#include "exported.h"

namespace frond {
namespace {

/// A plant with its branches as an export has them.
struct Barked {
  Scene scene;
  std::vector<Surface> branches;
};

const Barked& barked(const std::string& name) {
  static std::map<std::string, Barked> made;
  if (auto at = made.find(name); at != made.end()) return at->second;
  std::vector<std::string> sets;
  if (name.starts_with("trees/")) sets = {"/organisms/0/years=12"};
  Barked one{scene_of_file("presets/" + name + ".json", sets), {}};
  ExportOptions options{.texture = 0};
  options.bake.home = FROND_ROOT;
  Result<ExportScene> exported = export_scene(one.scene, 0, options);
  EXPECT_TRUE(exported) << exported.errors()[0].text();
  for (const ExportMesh& mesh : exported->meshes)
    if (mesh.name.find("branches") != std::string::npos)
      for (const ExportPart& part : mesh.parts) one.branches.push_back(part.surface);
  return made.emplace(name, std::move(one)).first->second;
}

/// How the picture lies on a triangle: what a unit of u and v is on it. None where it has no area there.
struct Laid {
  Vec3 u{0}, v{0};
};
std::optional<Laid> laid(const Surface& s, const std::array<std::uint32_t, 3>& t) {
  Vec2 p = s.uv[t[1]] - s.uv[t[0]], q = s.uv[t[2]] - s.uv[t[0]];
  Vec3 b = s.position[t[1]] - s.position[t[0]], c = s.position[t[2]] - s.position[t[0]];
  float turn = p.x * q.y - q.x * p.y;
  if (std::abs(turn) < 1e-12f) return std::nullopt;
  return Laid{(b * q.y - c * p.y) / turn, (c * p.x - b * q.x) / turn};
}

double at_share(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

class BarkOf : public testing::TestWithParam<const char*> {};

TEST_P(BarkOf, repeats_along_twigs_as_far_as_along_the_trunk) {
  std::vector<double> along;
  std::size_t flat = 0;
  for (const Surface& s : barked(GetParam()).branches)
    for (const auto& t : s.triangle) {
      if (auto on = laid(s, t))
        along.push_back(static_cast<double>(glm::length(on->v)));
      else
        ++flat;
    }
  ASSERT_GT(along.size(), 1000u);
  std::ranges::sort(along);
  EXPECT_LT(at_share(along, 0.95) / at_share(along, 0.05), 2.2);
  EXPECT_LT(at_share(along, 0.98) / at_share(along, 0.02), 3);
  EXPECT_LT(flat, along.size() / 200) << "triangles that a picture smears over";
}

TEST_P(BarkOf, stands_upright_on_the_trunk) {
  std::vector<double> aside;
  for (const Surface& s : barked(GetParam()).branches)
    for (const auto& t : s.triangle) {
      Vec3 middle = (s.position[t[0]] + s.position[t[1]] + s.position[t[2]]) / 3.0f;
      if (middle.y > 0.3f || std::hypot(middle.x, middle.z) > 0.5f) continue;
      auto on = laid(s, t);
      if (!on) continue;
      // A foot that widens leans outward, but goes round no stem.
      Vec3 round = glm::cross(Vec3(0, 1, 0), middle);
      if (glm::length(round) < 1e-4f || glm::length(on->v) < 1e-6f) continue;
      aside.push_back(std::abs(static_cast<double>(glm::dot(glm::normalize(round), glm::normalize(on->v)))));
    }
  ASSERT_GT(aside.size(), 10u);
  std::ranges::sort(aside);
  EXPECT_LT(at_share(aside, 0.5), 0.3);
}

TEST_P(BarkOf, goes_round_whole_times) {
  for (const Surface& s : barked(GetParam()).branches) {
    // At a seam two vertices lie at one place and as far along.
    std::map<std::tuple<float, float, float>, std::vector<Vec2>> at;
    for (std::size_t i = 0; i < s.position.size(); ++i) {
      const Vec3& p = s.position[i];
      at[{p.x, p.y, p.z}].push_back(s.uv[i]);
    }
    std::size_t seams = 0;
    for (const auto& [place, all] : at) {
      if (all.size() != 2 || all[0].y != all[1].y) continue;  // an end has a point for each side
      float round = all[1].x - all[0].x;
      EXPECT_NEAR(round, std::round(round), 1e-4f);
      EXPECT_GE(std::abs(round), 0.99f);
      ++seams;
    }
    EXPECT_GT(seams, 10u);
  }
}

TEST_P(BarkOf, ends_closed) {
  const Barked& plant = barked(GetParam());
  const Skeleton& skeleton = plant.scene.specimens.at(0).model.skeleton;
  std::map<std::pair<std::tuple<float, float, float>, std::tuple<float, float, float>>, int> edges;
  auto key = [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); };
  for (const Surface& s : plant.branches)
    for (const auto& t : s.triangle)
      for (std::size_t k = 0; k < 3; ++k) {
        auto a = key(s.position[t[k]]), b = key(s.position[t[(k + 1) % 3]]);
        if (a != b) ++edges[{std::min(a, b), std::max(a, b)}];
      }
  std::vector<Vec3> open;  // where edges of one face are
  for (const auto& [edge, faces] : edges)
    if (faces == 1)
      open.push_back({std::get<0>(edge.first), std::get<1>(edge.first), std::get<2>(edge.first)});
  std::vector<bool> bears(skeleton.size());
  for (std::int32_t below : skeleton.parent)
    if (below != Skeleton::kRoot) bears[static_cast<std::size_t>(below)] = true;
  std::size_t ends = 0, opened = 0;
  const Vec3 foot = plant.scene.specimens.at(0).placement.foot;
  for (std::size_t i = 0; i < skeleton.size(); ++i) {
    if (bears[i]) continue;
    ++ends;
    Vec3 tip = skeleton.position[i] - foot;
    opened += std::ranges::any_of(
        open, [&](const Vec3& p) { return glm::distance(p, tip) < 1.5f * skeleton.radius[i]; });
  }
  EXPECT_GT(ends, 20u);
  EXPECT_EQ(opened, 0u) << "of " << ends << ", and " << open.size() << " open edges in all";
}

INSTANTIATE_TEST_SUITE_P(Plants, BarkOf,
                         testing::Values("trees/oak", "aspen", "lsystems/bush-1.25", "lsystems/lilac"));

TEST(Shoots, HaveALeafWithinALeafsLengthOfTheirTip) {
  for (const char* name : {"trees/oak", "trees/birch", "aspen"}) {
    SCOPED_TRACE(name);
    const Model& model = barked(name).scene.specimens.at(0).model;
    const Skeleton& s = model.skeleton;
    // The chain that each node is of, by its last node.
    std::vector<std::int32_t> last(s.size(), -1);
    for (std::size_t i = s.size(); i-- > 0;) {
      if (last[i] < 0) last[i] = static_cast<std::int32_t>(i);
      if (std::int32_t below = s.parent[i]; below == static_cast<std::int32_t>(i) - 1 && below >= 0)
        last[static_cast<std::size_t>(below)] = last[i];
    }
    std::map<std::int32_t, float> nearest;  // leaf to each tip, in its lengths
    for (std::size_t k = 0; k < model.organs.size(); ++k) {
      std::int32_t node = model.organs.node[k];
      if (node < 0) continue;
      std::int32_t tip = last[static_cast<std::size_t>(node)];
      float away = glm::distance(model.organs.position[k], s.position[static_cast<std::size_t>(tip)]);
      float length = reach_of(model.prototypes[model.organs.prototype[k]]) * model.organs.scale[k].y;
      auto [at, fresh] = nearest.try_emplace(tip, away / length);
      if (!fresh) at->second = std::min(at->second, away / length);
    }
    std::size_t bare = 0;
    float worst = 0;
    for (auto& [tip, away] : nearest) bare += away > 1, worst = std::max(worst, away);
    printf("%s: %zu of %zu leafy shoots end without a leaf, the worst %.1f leaves beyond it\n", name, bare,
           nearest.size(), static_cast<double>(worst));
    ASSERT_GT(nearest.size(), 50u);
    EXPECT_LE(bare, nearest.size() / 50);
  }
}

}  // namespace
}  // namespace frond
