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
Result<Preset> plant_with(const std::string& name, const std::string& corners, const std::string& more,
                          const std::string& picture = red_and_blue()) {
  fs::path folder = fs::path(testing::TempDir()) / "frond_organ_pictures" / name;
  EXPECT_TRUE(write_file(folder / "skin.png", picture).ok());
  EXPECT_TRUE(write_file(folder / "tile.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd skin.png\nnewmtl bare\n").ok());
  EXPECT_TRUE(
      write_file(folder / "tile.obj",
                 "mtllib tile.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.125 0.25\nvt 1 0\nvt 1 1\n"
                 "vt 0 1\nvt 2.125 -0.75\nvt 3 -1\nvt 3 0\nvt 2 0\nusemtl skin\nf " +
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

TEST(OrganPictures, ThatLieInAnotherTileLieInTheFirst) {
  auto laid = [](const char* name, const char* corners) {
    return build_scene(*plant_with(name, corners, ""))->specimens[0].model.prototypes[0].parts[0].surface.uv;
  };
  EXPECT_EQ(laid("tiled", "1/5 2/6 3/7 4/8"), laid("first", "1/1 2/2 3/3 4/4"));
}

TEST(OrganPictures, OfOpacityHaveTheColourOfWhatIsThere) {
  // Green that is there, and black that is not.
  Raster raster(8, 4, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 2; ++x) raster.data[raster.index(x, y, 1)] = raster.data[raster.index(x, y, 3)] = 255;
  Result<Preset> preset = plant_with("sheer", "1/1 2/2 3/3 4/4", "", *png_text(raster));
  ASSERT_TRUE(preset);
  ASSERT_EQ(preset->notes.size(), 1u);
  EXPECT_NE(preset->notes[0].text().find("\"skin.png\", which has opacity"), std::string::npos);
  const Specimen plant = build_scene(*preset)->specimens[0];
  EXPECT_EQ(plant.model.prototypes[0].colors[0].green, 1);
  Result<std::vector<Picture>> drawn = plant.look.pictures[0].draw();
  ASSERT_TRUE(drawn);
  EXPECT_EQ(read_png((*drawn)[0].bytes)->at(6, 1, 1), 255);
}

TEST(OrganPictures, ThatCannotBeReadAreToldOfAndLeftOut) {
  auto note_of = [](const char* name, const std::string& picture) {
    Result<Preset> preset = plant_with(name, "1/1 2/2 3/3 4/4", "", picture);
    EXPECT_TRUE(preset);
    EXPECT_TRUE(build_scene(*preset)->specimens[0].look.pictures.empty());
    EXPECT_EQ(preset->notes.size(), 1u);
    return preset->notes.empty() ? "" : preset->notes[0].text();
  };
  EXPECT_NE(note_of("damaged", red_and_blue().substr(0, 60)).find("\"skin.png\", which"), std::string::npos);
  EXPECT_NE(note_of("foreign", "GIF89a").find("is a GIF picture; expected a PNG"), std::string::npos);
}

}  // namespace
}  // namespace frond
