#include "field/volume.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "core/parallel.h"
#include "field/fused.h"
#include "shapes.h"

namespace frond {
namespace {

/// A straight branch of two nodes.
Skeleton stick(Vec3 from, Vec3 to, float radius, float end_radius) {
  Skeleton s;
  s.add(from, radius, Skeleton::kRoot, 0);
  s.add(to, end_radius, 0, 0);
  return s;
}

TEST(Fuse, a_stick_is_closed_faces_outward_and_has_its_volume) {
  Skeleton s = stick({0.1f, 0.2f, 0}, {0.3f, 1, 0.2f}, 0.1f, 0.1f);
  Result<FusedMesh> mesh = fuse(boughs_of(s, 1), {.voxel = 0.01, .adaptivity = 0});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->surface.find_fault(), "");
  Closure c = measure(mesh->surface);
  EXPECT_EQ(c.open, 0u);
  EXPECT_EQ(c.crowded, 0u);
  EXPECT_EQ(c.euler, 2);
  double length = glm::distance(s.position[0], s.position[1]);
  double exact = kPi * 0.01 * length + 4 * kPi / 3 * 0.001;
  EXPECT_NEAR(c.volume, exact, 0.01 * exact);
}

TEST(Fuse, vertices_lie_on_the_exact_surface_and_normals_stand_on_it) {
  Skeleton s = stick({0, 0, 0}, {0, 1, 0}, 0.2f, 0.1f);
  BranchVolume boughs = boughs_of(s, 1);
  Result<FusedMesh> mesh = fuse(boughs, {.voxel = 0.02, .adaptivity = 0.3});
  ASSERT_TRUE(mesh);
  for (std::size_t v = 0; v < mesh->surface.position.size(); ++v) {
    EXPECT_NEAR(distance(boughs.cones[0], mesh->surface.position[v]), 0, 0.01 * 0.02);
    EXPECT_GT(glm::dot(mesh->surface.normal[v], outward(boughs.cones[0], mesh->surface.position[v])),
              0.9999f);
    EXPECT_EQ(mesh->node[v], 1);
  }
}

TEST(Fuse, a_ring_of_branches_has_a_hole) {
  Skeleton s;
  for (int i = 0; i <= 24; ++i) {
    auto turn = static_cast<float>(2 * kPi * i / 24);
    s.add({std::cos(turn), std::sin(turn), 0}, 0.2f, i - 1, 0);
  }
  Result<FusedMesh> mesh = fuse(boughs_of(s, 1), {.voxel = 0.03});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(measure(mesh->surface).euler, 0);
}

TEST(Fuse, adaptivity_saves_triangles) {
  Skeleton s = stick({0, 0, 0}, {0, 1, 0}, 0.2f, 0.2f);
  BranchVolume boughs = boughs_of(s, 1);
  std::size_t fine = fuse(boughs, {.voxel = 0.01, .adaptivity = 0})->surface.triangle.size();
  std::size_t coarse = fuse(boughs, {.voxel = 0.01, .adaptivity = 0.2})->surface.triangle.size();
  EXPECT_LT(coarse, fine / 2);
}

class Corals : public testing::TestWithParam<double> {};

TEST_P(Corals, are_watertight_and_manifold) {
  Skeleton s = test_coral(5);
  Result<FusedMesh> mesh = fuse(boughs_of(s, 1), {.voxel = 0.006, .adaptivity = GetParam()});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->surface.find_fault(), "");
  Closure c = measure(mesh->surface);
  EXPECT_EQ(c.open, 0u);
  EXPECT_EQ(c.crowded, 0u) << "of " << mesh->surface.triangle.size() << " triangles";
  EXPECT_EQ(c.euler % 2, 0);
  EXPECT_GT(c.volume, 0);
}
INSTANTIATE_TEST_SUITE_P(Adaptivities, Corals, testing::Values(0, 0.02, 0.1, 0.5));

TEST(Fuse, moves_no_farther_than_its_branches_and_grows_steadily) {
  Skeleton s = test_coral(4);
  Motion motion = lively();
  Pose before, after;
  for (double time : {0.5, 1.0, 2.6}) {
    pose_skeleton(s, motion, time, before);
    pose_skeleton(s, motion, time + 1.0 / 24, after);
    BranchVolume first, second;
    add_boughs(first, s, before.position, before.radius, before.front, 1);
    add_boughs(second, s, after.position, after.radius, after.front, 1);
    FusedMesh mesh = *fuse(first, {.voxel = 0.008}), later = *fuse(second, {.voxel = 0.008});
    double moved = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
      moved = std::max<double>(moved, glm::distance(before.position[i], after.position[i]) +
                                          std::abs(before.radius[i] - after.radius[i]));
    // How far the vertices of one frame are from the exact surface of the next, near the mesh of the next.
    Blocks blocks = gather_blocks(second, 0.008f, 0.08f);
    Nearby near;
    double farthest = 0;
    for (Vec3 p : mesh.surface.position) {
      FoundBlock found = find_block(blocks, voxel_at(p, 0.008f));
      ASSERT_TRUE(found.block);
      near_block(second, blocks, found, near);
      farthest = std::max<double>(farthest, std::abs(sample_boughs(second, near, p).distance));
    }
    EXPECT_LT(farthest, 1.3 * moved + 0.0005) << time;
    double volume = measure(mesh.surface).volume, next = measure(later.surface).volume;
    EXPECT_LT(std::abs(next / volume - 1), 0.3) << time;  // in a growth of two seconds
  }
}

TEST(Fuse, is_the_same_at_any_number_of_threads) {
  BranchVolume boughs = boughs_of(test_coral(4), 1);
  VolumeOptions options{.voxel = 0.008};
  limit_threads(1);
  FusedMesh one = *fuse(boughs, options);
  limit_threads(0);
  FusedMesh all = *fuse(boughs, options);
  ASSERT_EQ(one.surface.position.size(), all.surface.position.size());
  EXPECT_EQ(std::memcmp(one.surface.position.data(), all.surface.position.data(),
                        one.surface.position.size() * sizeof(Vec3)),
            0);
  EXPECT_EQ(one.surface.triangle, all.surface.triangle);
  EXPECT_EQ(one.node, all.node);
}

TEST(Volume, is_foreseen_within_a_factor_of_two) {
  for (double voxel : {0.02, 0.01, 0.004}) {
    BranchVolume boughs = boughs_of(test_coral(4), 1);
    Blocks blocks = gather_blocks(boughs, static_cast<float>(voxel), static_cast<float>(3 * voxel));
    double estimated = estimate_volume(boughs, voxel).blocks;
    EXPECT_LT(estimated, 2.0 * static_cast<double>(blocks.size())) << voxel;
    EXPECT_GT(estimated, 0.5 * static_cast<double>(blocks.size())) << voxel;
  }
}

TEST(Volume, past_the_limit_is_refused_with_the_figure) {
  BranchVolume boughs = boughs_of(test_coral(4), 1);
  Result<FusedMesh> mesh = fuse(boughs, {.voxel = 0.00002});
  ASSERT_FALSE(mesh);
  EXPECT_NE(mesh.errors()[0].what.find("GB"), std::string::npos) << mesh.errors()[0].what;
  EXPECT_NE(mesh.errors()[0].what.find("limit of 4 GB"), std::string::npos) << mesh.errors()[0].what;
  EXPECT_FALSE(volume_of(boughs, {.voxel = 0.01, .limit = 1e5}));
}

TEST(Volume, of_a_vdb_file_is_the_one_that_was_written) {
  BranchVolume boughs = boughs_of(test_coral(3), 1);
  Volume volume = *volume_of(boughs, {.voxel = 0.01});
  auto path =
      std::filesystem::temp_directory_path() / ("frond_field_test_" + std::to_string(getpid()) + ".vdb");
  ASSERT_TRUE(write_vdb(path, volume));
  Result<Volume> read = read_vdb(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(read);
  EXPECT_NEAR(read->voxel(), 0.01, 1e-9);
  EXPECT_EQ(read->active_voxels(), volume.active_voxels());
  EXPECT_GT(volume.active_voxels(), 1000u);
  // The distance itself, at the voxels round the first nodes.
  for (const RoundCone& cone : boughs.cones) {
    Cell cell = voxel_at(cone.from, 0.01f);
    EXPECT_EQ(read->at(cell), volume.at(cell));
    EXPECT_LT(read->at(cell), 0);
  }
  EXPECT_FALSE(read_vdb("/nowhere/at_all.vdb"));
}

}  // namespace
}  // namespace frond
