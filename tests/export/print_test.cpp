// Fused, rough and voxel bodies as a 3D printer needs them.

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <map>
#include <sstream>

#include "core/files.h"
#include "export/formats.h"
#include "pieces.h"

namespace frond {
namespace {

Scene scene_of(const std::string& preset, const std::vector<std::string>& sets) {
  std::string path = std::string(FROND_ROOT) + "/presets/" + preset;
  Result<Preset> read = read_preset(*read_file(path), path, sets);
  EXPECT_TRUE(read) << read.errors()[0].text();
  Result<Scene> scene = build_scene(*read);
  EXPECT_TRUE(scene);
  return *scene;
}

/// A film of a preset, its fused bodies on a grid that takes a moment only.
std::vector<std::string> film_of(const std::string& preset, std::vector<std::string> sets = {}) {
  sets.push_back("/film/frames=48");
  if (preset == "fused.json")
    sets.insert(sets.end(), {"/defaults/body/voxel=0.01", "/organisms/0/body/voxel=0.01"});
  return sets;
}

/// Of the meshes of branches: all are one piece each, every edge twice, without a void.
void expect_printable(const Scene& scene, double time, const std::string& what) {
  Result<ExportScene> exported = export_scene(scene, time, {.texture = 0});
  ASSERT_TRUE(exported) << what;
  std::size_t bodies = 0;
  for (const ExportMesh& mesh : exported->meshes) {
    if (mesh.name.find("_branches") == mesh.name.npos) continue;
    ++bodies;
    PrintedPieces pieces = printed_pieces(mesh.parts[0].surface);
    EXPECT_EQ(mesh.parts[0].surface.find_fault(), "") << what;
    EXPECT_EQ(pieces.crowded, 0u) << what << ' ' << mesh.name;
    EXPECT_EQ(pieces.flat, 0u) << what << ' ' << mesh.name;
    ASSERT_EQ(pieces.volume.size(), 1u) << what << ' ' << mesh.name;
    EXPECT_GT(pieces.volume[0], 0) << what << ' ' << mesh.name;
  }
  EXPECT_EQ(bodies, scene.specimens.size()) << what;
}

class Printed : public testing::TestWithParam<const char*> {};

TEST_P(Printed, bodies_are_one_piece_without_voids_at_any_seed_and_frame) {
  for (int seed : {0, 1, 2, 5}) {
    std::vector<std::string> sets = film_of(GetParam());
    if (seed > 0) sets.push_back("/seed=" + std::to_string(seed));
    Scene scene = scene_of(GetParam(), sets);
    for (double time : {0.0, 1.3})
      expect_printable(scene, time, "seed " + std::to_string(seed) + " at " + std::to_string(time));
  }
}

TEST_P(Printed, bodies_are_one_piece_as_shipped) {
  expect_printable(scene_of(GetParam(), {}), 0, GetParam());
}

TEST_P(Printed, bodies_are_one_piece_while_they_grow) {
  Scene scene = scene_of(GetParam(), film_of(GetParam(), {"/defaults/growth={\"duration\": 1.5}"}));
  for (double time : {0.3, 0.7, 1.1}) expect_printable(scene, time, "growing at " + std::to_string(time));
}

INSTANTIATE_TEST_SUITE_P(Presets, Printed, testing::Values("fused.json", "rough.json", "voxel.json"));

TEST(Printed, bodies_thinner_than_a_voxel_hold_together) {
  for (const char* build : {"fused", "rough", "voxels"}) {
    Scene scene = scene_of("voxel.json",
                           {std::string("/organisms/0/body={\"build\": \"") + build + "\", \"voxel\": 0.02}",
                            "/organisms/0/thickness/radius=0.004"});
    expect_printable(scene, 0, build);
  }
}

TEST(Printed, bodies_in_an_obj_share_the_corners_of_their_faces) {
  Result<ExportScene> exported = export_scene(scene_of("voxel.json", {}), 0, {.texture = 0});
  ASSERT_TRUE(exported);
  tinyobj::attrib_t attrib;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warn, error;
  std::istringstream text(obj_text(*exported, "none.mtl"));
  ASSERT_TRUE(tinyobj::LoadObj(&attrib, &shapes, &materials, &warn, &error, &text, nullptr, false)) << error;
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t i = 0; i < shapes[0].mesh.indices.size(); ++i) {
    int a = shapes[0].mesh.indices[i].vertex_index;
    int b = shapes[0].mesh.indices[i % 3 == 2 ? i - 2 : i + 1].vertex_index;
    ++edges[{std::min(a, b), std::max(a, b)}];
  }
  std::size_t crowded = 0;
  for (const auto& [edge, count] : edges) crowded += count != 2;
  EXPECT_GT(edges.size(), 1000u);
  EXPECT_EQ(crowded, 0u);
}

}  // namespace
}  // namespace frond
