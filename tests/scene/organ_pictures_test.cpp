// Pictures that the meshes of organs wear.

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "images/raster.h"
#include "scene/scene.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// A PNG, red on its left half and blue on its right.
std::string red_and_blue() {
  Raster raster(8, 4, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) raster.data[raster.index(x, y) + (x < 4 ? 0 : 2)] = 255;
  return *png_text(raster);
}

/// A plant of one organ: a square that wears the picture, beside a triangle that wears none.
Result<Preset> plant_with(const std::string& name, const std::string& corners, const std::string& more) {
  fs::path folder = fs::path(testing::TempDir()) / "frond_organ_pictures" / name;
  EXPECT_TRUE(write_file(folder / "skin.png", red_and_blue()).ok());
  EXPECT_TRUE(write_file(folder / "tile.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd skin.png\nnewmtl bare\n").ok());
  EXPECT_TRUE(
      write_file(folder / "tile.obj",
                 "mtllib tile.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.125 0.25\nvt 1 0\nvt 1 1\n"
                 "vt 0 1\nusemtl skin\nf " +
                     corners + "\nusemtl bare\nf 1 2 3\n")
          .ok());
  return read_preset(R"({"version": 2, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant",
      "place": {"at": [[0, 0]]}, "grammar": {"axiom": "F~K"},
      "organs": [{"symbol": "K", "shape": "obj", "file": "tile.obj")" +
                         more + "}]}]}",
                     (folder / "test.json").string(), {});
}

TEST(OrganPictures, LieByTheTextureCoordinatesOfTheFile) {
  Result<Preset> preset = plant_with("laid", "1/1 2/2 3/3 4/4", "");
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  Result<Scene> scene = build_scene(*preset);
  ASSERT_TRUE(scene);
  const Specimen& plant = scene->specimens[0];
  const Prototype& organ = plant.model.prototypes[0];
  ASSERT_EQ(organ.parts.size(), 2u);
  const Surface& tile = organ.parts[0].surface;
  ASSERT_EQ(tile.uv.size(), 4u);
  for (std::size_t v = 0; v < tile.uv.size(); ++v) {
    const bool first = tile.position[v].x < 0 && tile.position[v].y < 0.5f;
    EXPECT_EQ(tile.uv[v] == Vec2(0.125f, 0.25f), first);
  }
  ASSERT_EQ(organ.parts[0].pictures.size(), 1u);
  EXPECT_TRUE(organ.parts[1].pictures.empty());
  ASSERT_EQ(plant.look.pictures.size(), 1u);
  EXPECT_EQ(plant.look.pictures[0].names[0], organ.parts[0].pictures[0]);
  EXPECT_NEAR(organ.colors[0].red, 0.5f, 0.01f) << "the mean, where pictures are not shown";
  EXPECT_NEAR(organ.colors[0].green, 0, 0.01f);
}

TEST(OrganPictures, AreMultipliedByColoursThatThePresetGives) {
  Result<Preset> preset = plant_with("tinted", "1/1 2/2 3/3 4/4", R"(, "colors": ["#ffffff", "#800000"])");
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  const Specimen plant = build_scene(*preset)->specimens[0];
  ASSERT_EQ(plant.look.pictures.size(), 2u);
  EXPECT_NE(plant.look.pictures[0].names[0], plant.look.pictures[1].names[0]);
  Result<std::vector<Picture>> drawn = plant.look.pictures[1].draw();
  ASSERT_TRUE(drawn);
  Result<Raster> dark = read_png((*drawn)[0].bytes);
  ASSERT_TRUE(dark);
  EXPECT_EQ(dark->at(1, 1, 0), 128);
  EXPECT_EQ(dark->at(6, 1, 2), 0);
}

TEST(OrganPictures, WithoutTextureCoordinatesAreToldOf) {
  Result<Preset> preset = plant_with("unlaid", "1 2 3 4", "");
  ASSERT_TRUE(preset);
  ASSERT_EQ(preset->notes.size(), 1u);
  EXPECT_NE(preset->notes[0].text().find("/organisms/0/organs/0/file"), std::string::npos);
  EXPECT_NE(preset->notes[0].text().find("not all of its corners texture coordinates"), std::string::npos);
  EXPECT_TRUE(build_scene(*preset)->specimens[0].look.pictures.empty());
}

}  // namespace
}  // namespace frond
