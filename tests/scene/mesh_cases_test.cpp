#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/files.h"
#include "creeping/triangle_surface.h"
#include "scene/scene.h"
#include "winding.h"

// Ivy on meshes as people bring them.

namespace frond {
namespace {

struct GrownCase {
  Scene scene;
  TriangleSurface host;
  const Specimen& ivy() const { return scene.specimens.back(); }
};

GrownCase grown_case(const std::string& preset, const std::vector<std::string>& changes = {}) {
  std::string path = "tests/cases/" + preset;
  Result<Preset> read = read_preset(*read_file(path), path, changes);
  EXPECT_TRUE(read) << (read ? "" : read.errors()[0].text());
  Result<Scene> scene = build_scene(*read);
  EXPECT_TRUE(scene) << (scene ? "" : scene.errors()[0].text());
  TriangleSurface host = std::move(*TriangleSurface::build(skin_of(scene->specimens[0].model)));
  return {std::move(*scene), std::move(host)};
}

TEST(MeshCases, IvyFollowsTheEdgesOfLargeFaces) {
  GrownCase grown = grown_case("20-block-leaves/steps.json");
  Bounds box = bounds_of(grown.scene.specimens[0].model.solids);
  float low = box.low.y, high = low + 3, wide = 0.5f * (box.low.x + box.high.x), step = low + 1.5f;
  int up = 0, roof = 0, down = 0, lower = 0, between = 0;
  for (const Vec3& p : grown.ivy().model.skeleton.position) {
    up += p.x < wide - 0.05f && p.y > low + 0.5f && p.y < high - 0.1f;
    roof += p.y > high - 0.01f && p.x < wide - 0.05f;
    down += std::abs(p.x - wide) < 0.05f && p.y > step + 0.1f && p.y < high - 0.05f;
    lower += p.x > wide + 0.1f && p.y > step - 0.01f;
    between += std::abs(p.x - wide) < 0.02f && p.y < step - 0.05f && std::abs(p.z) < 1.9f;
  }
  EXPECT_GT(up, 20);
  EXPECT_GT(roof, 20);
  EXPECT_GT(down, 5);
  EXPECT_GT(lower, 5);
  EXPECT_EQ(between, 0) << "on the face that the two blocks share";
  // Leaves look as what is below them does: up on roofs, outward on walls.
  std::array<Vec3, 3> sum{};
  std::array<Vec3, 3> of{Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0)};
  const Organs& organs = grown.ivy().model.organs;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    std::optional<Contact> near = grown.host.closest(DVec3(organs.position[i]), 0.05);
    if (!near) continue;
    DVec3 face = grown.host.face_normal(near->triangle);
    for (std::size_t k = 0; k < of.size(); ++k)
      if (glm::dot(Vec3(face), of[k]) > 0.99f) sum[k] += organs.turn[i] * Vec3(0, 0, 1);
  }
  for (std::size_t k = 0; k < of.size(); ++k) {
    if (glm::length(sum[k]) <= 10) continue;
    EXPECT_GT(glm::dot(glm::normalize(sum[k]), of[k]), std::cos(radians(40.0))) << k;
  }
}

TEST(MeshCases, IvyThatHoldsOnKeepsOutOfAScanWithHoles) {
  for (const char* file : {"boulder_be.ply", "boulder_ascii.ply", "boulder.obj"}) {
    SCOPED_TRACE(file);
    GrownCase grown = grown_case("21-ply-scan/boulder.json",
                                 {"/organisms/0/file=" + std::string(file), "/organisms/1/crawl/let_go=0"});
    const auto& strands = grown.ivy().model.skeleton.position;
    EXPECT_GT(strands.size(), 300u);
    DVec3 middle = 0.5 * (grown.host.low() + grown.host.high());
    // Strands that cross a hole lie a little below the round that the skin would have there.
    constexpr double kSlipped = 0.06;
    std::size_t behind = 0;
    double deepest = 0;
    for (const Vec3& p : strands) {
      Contact near = *grown.host.closest(DVec3(p));
      // The boulder is about round: what is behind its skin is nearer to the middle.
      double depth = glm::distance(near.point, middle) - glm::distance(DVec3(p), middle);
      behind += near.inside && depth > kSlipped;
      if (near.inside) deepest = std::max(deepest, depth);
    }
    EXPECT_LE(behind, strands.size() / 200) << strands.size() << " of which the deepest lies " << deepest;
  }
}

TEST(MeshCases, IvyThatHangsKeepsOutOfAScanWithHoles) {
  for (const char* file : {"boulder_be.ply", "boulder_ascii.ply", "boulder.obj"}) {
    SCOPED_TRACE(file);
    GrownCase grown = grown_case("21-ply-scan/boulder.json", {"/organisms/0/file=" + std::string(file)});
    const auto& strands = grown.ivy().model.skeleton.position;
    std::size_t behind = 0;
    EXPECT_GT(strands.size(), 1000u);
    for (std::size_t i = 0; i < strands.size(); i += 4)
      behind += winding(grown.host, DVec3(strands[i])) > 0.75;
    EXPECT_LE(behind, strands.size() / 2000) << "of " << strands.size() << ", of which each fourth is asked";
  }
}

TEST(MeshCases, IvyLeavesTheDoorAndTheWindowOpen) {
  GrownCase grown = grown_case("17-gable-ngon/gable.json");
  EXPECT_TRUE(grown.host.closed());
  Bounds box = bounds_of(grown.scene.specimens[0].model.solids);
  float x = 0.5f * (box.low.x + box.high.x), y = box.low.y;
  auto within = [&](const Vec3& p, float left, float low, float right, float top, float room) {
    return p.x - x > left + room && p.x - x < right - room && p.y - y > low + room && p.y - y < top - room &&
           std::abs(p.z) < 0.3f;
  };
  std::size_t door = 0, window = 0;
  constexpr float kLeaf = 0.07f;
  for (const Vec3& p : grown.ivy().model.skeleton.position) {
    door += within(p, -1, -0.1f, 0.2f, 2.2f, kLeaf);
    window += within(p, 1.2f, 1, 2.2f, 2, kLeaf);
  }
  EXPECT_EQ(door, 0u);
  EXPECT_EQ(window, 0u);
  EXPECT_GT(grown.ivy().model.skeleton.size(), 1000u);
}

}  // namespace
}  // namespace frond
