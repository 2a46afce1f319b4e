#include "studio/exports.h"

#include <gtest/gtest.h>

#include "core/files.h"

namespace frond {
namespace {

TEST(Exports, TrianglesAreToldBeforeAnythingIsWritten) {
  std::string path = FROND_ROOT "/tests/presets/staghorn.json";
  Result<Preset> preset = read_preset(*read_file(path), path, {"/organisms/0/steps=3"});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  Scene scene = *build_scene(*preset);
  Json one = export_size(scene, export_order({{"type", ".glb"}, {"levels", 1}}));
  Json four = export_size(scene, export_order({{"type", ".glb"}, {"levels", 4}}));
  ASSERT_EQ(four["triangles"].size(), 4u);
  EXPECT_GT(one["triangles"][0].get<double>(), 1000);
  EXPECT_EQ(one["triangles"][0], four["triangles"][0]);
  EXPECT_NEAR(four["triangles"][1].get<double>(), 0.25 * one["triangles"][0].get<double>(), 1);
  EXPECT_GT(four["bytes"].get<double>(), one["bytes"].get<double>());
  Json moves = export_size(scene, export_order({{"type", ".glb"}, {"levels", 4}, {"wind", true}}));
  EXPECT_EQ(moves["triangles"].size(), 1u) << "only one mesh can move";
  EXPECT_GT(moves["bytes"].get<double>(), one["bytes"].get<double>());
  EXPECT_EQ(export_order({{"levels", 4}, {"type", ".obj"}}).levels, 1);
  EXPECT_EQ(export_order({{"levels", 1e300}}).levels, 6);
}

}  // namespace
}  // namespace frond
