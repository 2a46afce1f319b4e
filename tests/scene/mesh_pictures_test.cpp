// Pictures that the materials of a mesh name.

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <filesystem>

#include "core/files.h"
#include "images/raster.h"
#include "scene/scene.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// A JPEG, red above blue, of a camera that was held upside down, which no texture coordinates know of.
std::string red_above_blue() {
  Raster raster(16, 16, 3);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) raster.data[raster.index(x, y) + (y < 8 ? 0 : 2)] = 255;
  tjhandle writer = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(writer, raster.data.data(), 16, 0, 16, TJPF_RGB, &bytes, &size, TJSAMP_444, 95, 0);
  std::string jpeg(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(writer);
  std::string exif(
      "\xff\xe1\0\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x03\0\0\0\0\0\0",
      36);
  return jpeg.insert(2, exif);
}

Result<Preset> tile_with(const std::string& name, const std::string& picture) {
  fs::path folder = fs::path(testing::TempDir()) / "frond_mesh_pictures" / name;
  EXPECT_TRUE(write_file(folder / name, picture).ok());
  EXPECT_TRUE(write_file(folder / "tile.mtl", "newmtl tile\nKd 1 1 1\nmap_Kd " + name + "\n").ok());
  EXPECT_TRUE(write_file(folder / "tile.obj",
                         "mtllib tile.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                         "vt 0 1\nusemtl tile\nf 1/1 2/2 3/3 4/4\n")
                  .ok());
  return read_preset(R"({"scene": {"setting": "studio"}, "organisms": [{"kind": "mesh", "file": "tile.obj",
      "place": {"at": [[0, 0]]}}]})",
                     (folder / "test.json").string(), {});
}

TEST(MeshPictures, ThatAreJpegsAreWornAsTheirPixelsAreStored) {
  Result<Preset> preset = tile_with("tile.jpg", red_above_blue());
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  for (const Error& note : preset->notes) EXPECT_EQ(note.text().find("picture"), std::string::npos);
  Result<Scene> scene = build_scene(*preset);
  ASSERT_TRUE(scene);
  const Specimen& tile = scene->specimens[0];
  ASSERT_EQ(tile.look.pictures.size(), 1u);
  Result<std::vector<Picture>> drawn = tile.look.pictures[0].draw();
  ASSERT_TRUE(drawn);
  Result<Raster> png = read_png((*drawn)[0].bytes);
  ASSERT_TRUE(png);
  EXPECT_GT(png->at(4, 2, 0), 200);
  EXPECT_GT(png->at(4, 13, 2), 200);
  const Solid& shape = tile.model.solids.shapes[0];
  EXPECT_EQ(shape.surface.uv.size(), shape.surface.position.size());
  EXPECT_EQ(shape.material.picture, tile.look.pictures[0].names[0]);
  EXPECT_NEAR(shape.material.color.red, 0.5f, 0.05f) << "the mean, where pictures are not shown";
  EXPECT_NEAR(shape.material.color.green, 0, 0.05f);
}

TEST(MeshPictures, OfAnUnknownKindAreToldOfAndDamagedOnesNamed) {
  Result<Preset> tiff = tile_with("tile.tif", std::string("II*\0", 4));
  ASSERT_TRUE(tiff);
  EXPECT_TRUE(std::ranges::any_of(tiff->notes, [](const Error& note) {
    return note.text().find("expected PNG, JPEG or WebP") != std::string::npos;
  }));
  Result<Preset> cut = tile_with("cut.jpg", red_above_blue().substr(0, 300));
  ASSERT_TRUE(cut);
  Result<std::vector<Picture>> drawn = build_scene(*cut)->specimens[0].look.pictures[0].draw();
  ASSERT_FALSE(drawn);
  EXPECT_NE(drawn.errors()[0].text().find("cut.jpg: is a damaged JPEG"), std::string::npos)
      << drawn.errors()[0].text();
}

}  // namespace
}  // namespace frond
