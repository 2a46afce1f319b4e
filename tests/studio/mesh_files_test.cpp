#include "studio/mesh_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/assets.h"
#include "core/files.h"
#include "core/work_folder.h"
#include "geometry/mesh_file.h"
#include "studio/documents.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

constexpr const char* kObj = "mtllib my barrel.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl oak\nf 1 2 3\n";
constexpr const char* kMtl = "newmtl oak\nKd 0.5 0.3 0.1\nmap_Kd C:\\textures\\oak wood.PNG\n";

Result<PolygonMesh> read(const fs::path& file) { return read_mesh_file({file, *read_file(file), nullptr}); }

TEST(MeshFiles, AMeshKeepsTheFilesThatItNamesAndOnlyThese) {
  WorkFolder folder;
  Result<PutFiles> put = put_mesh(folder.path(), "../my barrel.OBJ", kObj,
                                  {{"my barrel.mtl", kMtl},
                                   {"oak wood.PNG", "picture"},
                                   {"other.png", "not named"},
                                   {"../oak wood.PNG", "outside"},
                                   {"run.sh", "no picture"}});
  ASSERT_TRUE(put) << put.errors().front().text();
  EXPECT_EQ(put->name, "my_barrel/my_barrel.obj");
  EXPECT_TRUE(put->fresh);
  EXPECT_EQ(files_in(folder.path()).size(), 1u);
  EXPECT_EQ(files_in(folder.path() / "my_barrel").size(), 3u);
  Result<PolygonMesh> mesh = read(folder.path() / put->name);
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->material.size(), 1u);
  EXPECT_FLOAT_EQ(mesh->material[0].color->red, 0.5f);
  ASSERT_TRUE(mesh->material[0].picture);
  EXPECT_EQ(*mesh->material[0].picture, "picture");
  // The same again stands there; another of that name gets a folder of its own.
  put =
      put_mesh(folder.path(), "my barrel.obj", kObj, {{"my barrel.mtl", kMtl}, {"oak wood.PNG", "picture"}});
  ASSERT_TRUE(put);
  EXPECT_EQ(put->name, "my_barrel/my_barrel.obj");
  EXPECT_FALSE(put->fresh);
  put = put_mesh(folder.path(), "my barrel.obj", kObj, {{"my barrel.mtl", "newmtl oak\n"}});
  ASSERT_TRUE(put);
  EXPECT_EQ(put->name, "my_barrel-2/my_barrel.obj");
}

TEST(MeshFiles, OfAFolderThatCannotBeWrittenWholeNothingIsLeft) {
  WorkFolder folder;
  std::string unwritable(300, 'z');
  Result<PutFiles> put = put_folder(folder.path(), "barrel", {{"barrel.obj", kObj}, {unwritable, kMtl}});
  ASSERT_FALSE(put);
  EXPECT_EQ(put.errors()[0].where, (folder.path() / "barrel" / unwritable).string());
  EXPECT_TRUE(files_in(folder.path()).empty());
}

TEST(MeshFiles, AMeshEndsAsWhatItHoldsAndWhatIsNoneIsNotWritten) {
  WorkFolder folder;
  const char* stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid a\n";
  Result<PutFiles> put = put_mesh(folder.path(), "part.obj", stl, {});
  ASSERT_TRUE(put);
  EXPECT_EQ(put->name, "part.stl");
  for (const std::string content : {"BLENDER-v300", "v 1 2", "", "f 1 2 3\n"}) {
    put = put_mesh(folder.path(), "wrong.obj", content, {});
    ASSERT_FALSE(put) << content;
    EXPECT_TRUE(put.errors().front().where.starts_with("wrong.obj")) << put.errors().front().text();
  }
  EXPECT_EQ(files_in(folder.path()).size(), 1u);
}

TEST(MeshFiles, ACopyOfAPresetTakesTheMaterialsOfItsMeshesAlong) {
  WorkFolder folder;
  const fs::path from = folder.path() / "own", to = from / "copies";
  (void)write_file(from / "barrel.obj",
                   "mtllib barrel.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl oak\nf 1 2 3\n");
  (void)write_file(from / "barrel.mtl", "newmtl oak\nKd 0.5 0.3 0.1\nmap_Kd textures/oak.png\n");
  (void)write_file(from / "textures/oak.png", "picture");
  const std::string text = R"({"organisms": [{"kind": "mesh", "file": "barrel.obj"}]})";
  (void)write_file(from / "a.json", text);
  Documents documents({.home = FROND_ROOT, .preset = from / "a.json", .assets = {}, .ready = {}});
  Answer saved = documents.save("copies/b.json", {text, from / "a.json"}, "", false);
  ASSERT_EQ(saved.status, 200);
  EXPECT_NE(saved.json["text"].get<std::string>().find("barrel/barrel.obj"), std::string::npos) << saved.json;
  Result<PolygonMesh> mesh = read(to / "barrel/barrel.obj");
  ASSERT_TRUE(mesh);
  ASSERT_TRUE(mesh->material[0].picture);
  EXPECT_EQ(*mesh->material[0].picture, "picture");
}

TEST(MeshFiles, WhatWasThereBeforeItWasDroppedStaysWhenThePresetIsSavedWithoutIt) {
  WorkFolder folder;
  const char* stone = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  (void)write_file(folder.path() / "stone.obj", stone);
  (void)write_file(folder.path() / "a.json", "{}");
  Documents documents({.home = FROND_ROOT, .preset = folder.path() / "a.json", .assets = {}, .ready = {}});
  const std::string of = (folder.path() / "a.json").string();
  Answer saved = documents.add_mesh("stone.obj", stone, {}, of);
  ASSERT_EQ(saved.status, 200);
  EXPECT_EQ(saved.json["file"], "stone.obj");
  ASSERT_EQ((saved = documents.add_mesh("barrel.obj", kObj, {{"my barrel.mtl", kMtl}}, of)).status, 200);
  EXPECT_EQ(saved.json["file"], "barrel/barrel.obj");
  ASSERT_EQ(documents.save(of, {"{}", of}, "", true).status, 200);
  EXPECT_TRUE(fs::exists(folder.path() / "stone.obj"));
  EXPECT_FALSE(fs::exists(folder.path() / "barrel"));
}

}  // namespace
}  // namespace frond
