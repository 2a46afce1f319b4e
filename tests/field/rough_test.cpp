#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/parallel.h"
#include "field/fused.h"
#include "field/volume.h"
#include "pieces.h"
#include "shapes.h"

namespace frond {
namespace {

/// A coral that grows and sways, and how its branches stand at rest and in a pose.
struct Swaying {
  Skeleton rest = test_coral(4);
  Motion motion = lively();
  Pose still, pose;

  void go_to(double time) {
    Motion unmoved;
    unmoved.growth = motion.growth;
    pose_skeleton(rest, unmoved, time, still);
    pose_skeleton(rest, motion, time, pose);
  }
  FusedMesh rough(double roughness) const {
    return *roughen(boughs(), {.voxel = 0.012, .roughness = roughness},
                    {still.position, pose.position, pose.turn});
  }
  BranchVolume boughs() const {
    BranchVolume made;
    add_boughs(made, rest, still.position, still.radius, still.front, 1);
    return made;
  }
};

/// At rest and fully grown.
FusedMesh rough_at_rest(const Skeleton& s, const VolumeOptions& options) {
  std::vector<Quat> turn(s.size(), Quat(1, 0, 0, 0));
  return *roughen(boughs_of(s, 1), options, {s.position, s.position, turn});
}

/// The farthest and the mean distance of the vertices from the surface of the boughs.
struct Departure {
  double most = 0, mean = 0;
};
Departure departure(const Surface& surface, const BranchVolume& boughs) {
  Departure d;
  Nearby all = all_of(boughs);
  for (Vec3 p : surface.position) {
    double away = std::abs(sample_boughs(boughs, all, p).distance);
    d.most = std::max(d.most, away), d.mean += away / static_cast<double>(surface.position.size());
  }
  return d;
}

TEST(Rough, ItDepartsFromTheSmoothSurfaceMoreTheRougherItIsButByLessThanAVoxel) {
  Skeleton s = test_coral(3, 0.05);
  double before = 0;
  for (double roughness : {0.0, 0.5, 1.0}) {
    FusedMesh mesh = rough_at_rest(s, {.voxel = 0.012, .roughness = roughness});
    Departure d = departure(mesh.surface, boughs_of(s, 1));
    EXPECT_LT(d.most, 0.012) << roughness;
    EXPECT_GT(d.mean, before) << roughness;
    before = d.mean;
  }
  EXPECT_GT(before, 0.1 * 0.012) << "steps are seen";
}

TEST(Rough, IsWatertightAndManifold) {
  for (int seed = 1; seed <= 12; ++seed)
    for (double roughness : {0.0, 0.4, 0.7, 1.0}) {
      CoralParams params;
      params.steps = 4, params.height = 1, params.thickness.radius = seed % 2 ? 0.03 : 0.012;
      FusedMesh mesh = rough_at_rest(*grow_coral(params, Seed{static_cast<std::uint64_t>(seed)}),
                                     {.voxel = 0.012, .roughness = roughness});
      EXPECT_EQ(mesh.surface.find_fault(), "");
      PrintedPieces pieces = printed_pieces(mesh.surface);
      EXPECT_EQ(pieces.crowded, 0u) << seed << ' ' << roughness;
      EXPECT_EQ(pieces.flat, 0u) << seed << ' ' << roughness;
      ASSERT_EQ(pieces.volume.size(), 1u) << seed << ' ' << roughness;
      EXPECT_GT(pieces.volume[0], 0);
    }
}

TEST(Rough, SwayingCarriesTheSameTrianglesAndNoVertexJumps) {
  Swaying coral;
  coral.motion.growth = {};
  FusedMesh before;
  Pose last;
  for (int frame = 0; frame < 24; ++frame) {
    coral.go_to(frame / 24.0);
    FusedMesh mesh = coral.rough(1);
    if (frame > 0) {
      ASSERT_EQ(mesh.surface.triangle, before.surface.triangle) << frame;
      double nodes = 0, vertices = 0;
      for (std::size_t i = 0; i < coral.rest.size(); ++i)
        nodes = std::max<double>(nodes, glm::distance(coral.pose.position[i], last.position[i]));
      for (std::size_t v = 0; v < mesh.node.size(); ++v)
        vertices =
            std::max<double>(vertices, glm::distance(mesh.surface.position[v], before.surface.position[v]));
      EXPECT_LT(vertices, 1.2 * nodes + 0.0005) << frame;
    }
    before = std::move(mesh), last = coral.pose;
  }
}

/// The distance of a point from a triangle (Ericson 2005, Real-time collision detection).
float distance_from(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  auto to_edge = [&](Vec3 from, Vec3 to) {
    Vec3 along = to - from;
    float t = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0f, 1.0f);
    return glm::distance(p, from + t * along);
  };
  Vec3 normal = glm::cross(b - a, c - a);
  bool within = glm::dot(glm::cross(b - a, p - a), normal) >= 0 &&
                glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
                glm::dot(glm::cross(a - c, p - c), normal) >= 0;
  if (within && glm::length(normal) > 0) return std::abs(glm::dot(p - a, glm::normalize(normal)));
  return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

/// How far the vertices of one mesh are from another.
double farthest_from(const Surface& from, const Surface& to, float reach) {
  std::map<std::array<int, 3>, std::vector<std::size_t>> cells;
  auto cell = [&](Vec3 p) {
    Vec3 low = glm::floor(p / reach);
    return std::array{static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(low.z)};
  };
  for (std::size_t t = 0; t < to.triangle.size(); ++t)
    cells[cell(to.position[to.triangle[t][0]])].push_back(t);
  double farthest = 0;
  for (Vec3 p : from.position) {
    float nearest = reach;
    std::array<int, 3> at = cell(p);
    for (int n = 0; n < 27; ++n) {
      auto found = cells.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
      if (found == cells.end()) continue;
      for (std::size_t t : found->second) {
        auto [a, b, c] = to.triangle[t];
        nearest = std::min(nearest, distance_from(p, to.position[a], to.position[b], to.position[c]));
      }
    }
    farthest = std::max<double>(farthest, nearest);
  }
  return farthest;
}

TEST(Rough, WithoutRoughnessItIsThePlainMeshOfTheVolume) {
  Skeleton s = trunk(20);
  VolumeOptions options{.voxel = 0.012, .roughness = 0};
  Surface plain = *mesh_of(*volume_of(boughs_of(s, 1), options), 0);
  EXPECT_LT(farthest_from(rough_at_rest(s, options).surface, plain, 0.06f), 0.1 * 0.012);
  options.roughness = 1;
  EXPECT_GT(farthest_from(rough_at_rest(s, options).surface, plain, 0.06f), 0.3 * 0.012);
}

TEST(Rough, GrowingItMovesSteadilyFromFrameToFrame) {
  Swaying coral;
  for (double time : {0.5, 1.0, 2.6}) {
    coral.go_to(time);
    FusedMesh mesh = coral.rough(1);
    Pose pose = coral.pose;
    // In ever shorter steps it moves ever less: nothing pops.
    for (double frames : {1.0, 0.05}) {
      coral.go_to(time + frames / 24);
      double nodes = 0;
      for (std::size_t i = 0; i < coral.rest.size(); ++i)
        nodes = std::max<double>(nodes, glm::distance(coral.pose.position[i], pose.position[i]));
      EXPECT_LT(farthest_from(mesh.surface, coral.rough(1).surface, 0.06f), 2.5 * nodes)
          << time << ' ' << frames;
    }
  }
}

TEST(Rough, IsTheSameAtAnyNumberOfThreads) {
  Skeleton s = test_coral(4);
  VolumeOptions options{.voxel = 0.01, .roughness = 0.8};
  limit_threads(1);
  FusedMesh one = rough_at_rest(s, options);
  limit_threads(0);
  FusedMesh all = rough_at_rest(s, options);
  EXPECT_EQ(one.surface.position, all.surface.position);
  EXPECT_EQ(one.surface.triangle, all.surface.triangle);
  EXPECT_EQ(one.node, all.node);
}

TEST(Rough, PastTheLimitIsRefused) {
  Skeleton s = test_coral(3);
  EXPECT_FALSE(roughen(boughs_of(s, 1), {.voxel = 0.002, .limit = 1e6}, {s.position, s.position, {}}));
}

}  // namespace
}  // namespace frond
