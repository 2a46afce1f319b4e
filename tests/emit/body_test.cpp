#include "emit/branch_materials.h"

#include <gtest/gtest.h>

#include "emit/texts.h"

namespace frond {
namespace {

Result<Scene> coral(const std::string& style, const std::string& more = "") {
  Result<Preset> preset = read_preset(
      R"({"film": {"frames": 12, "fps": 12}, "organisms": [{"kind": "coral", "steps": 2, "height": 0.4, )" +
          more + R"( "place": {"at": [[0, 0]]}, "body": )" + style + "}]}",
      "coral.json", {});
  EXPECT_TRUE(preset);
  return build_scene(*preset);
}

TEST(Body, fused_is_meshes_that_bear_the_textures_of_the_chunks) {
  std::string text = text_of(*coral(R"("fused")", R"("wave": {"amplitude": 10},)"), 3);
  EXPECT_EQ(count(text, "sphere_sweep"), 0u);
  EXPECT_GT(count(text, "texture_list"), 0u);
  EXPECT_GT(count(text, "texture{Skin[0] matrix<") + count(text, "texture{Coral_Tip(0,"), 5u);
  EXPECT_EQ(text, text_of(*coral(R"("fused")", R"("wave": {"amplitude": 10},)"), 3));
}

TEST(Body, of_cubes_has_a_texture_for_each_look) {
  std::string text = text_of(*coral(R"({"build": "voxels", "voxel": 0.02})"), 1);
  EXPECT_EQ(count(text, "sphere_sweep"), 0u);
  EXPECT_EQ(count(text, "#include \"frond_voxel.inc\""), 1u);
  EXPECT_GT(count(text, "Voxel_Skin("), 5u);
}

TEST(Body, that_has_not_begun_to_grow_is_nothing) {
  std::string text = text_of(*coral(R"("fused")", R"("growth": {"start": 5, "duration": 1},)"), 1);
  EXPECT_EQ(count(text, "texture_list"), 0u);
}

TEST(Body, past_its_limit_is_refused_before_a_frame_is_made) {
  Result<Scene> scene = coral(R"({"build": "fused", "voxel": 0.002, "limit": 1e6})");
  ASSERT_FALSE(scene);
  EXPECT_TRUE(scene.errors()[0].where.ends_with(": /organisms/0/body/voxel")) << scene.errors()[0].where;
  EXPECT_NE(scene.errors()[0].what.find("more than the limit of 1 MB"), std::string::npos);
}

}  // namespace
}  // namespace frond
