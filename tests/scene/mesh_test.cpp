#include "organisms/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/files.h"
#include "creeping/triangle_surface.h"
#include "images/raster.h"
#include "model/surface.h"
#include "scene/scene.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// A preset with a mesh, and notes of what is read.
Result<Preset> with_mesh(const std::string& properties,
                         const fs::path& folder = "tests/cases/19-zup-cm-groups") {
  return read_preset(R"({"scene": {"setting": "studio"}, "organisms": [{"kind": "mesh", "name": "body",
      "place": {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0}, )" +
                         properties + "}]}",
                     (folder / "test.json").string(), {});
}

Scene mesh_scene_with(const std::string& properties,
                      const fs::path& folder = "tests/cases/19-zup-cm-groups") {
  Result<Preset> preset = with_mesh(properties, folder);
  if (!preset) ADD_FAILURE() << preset.errors()[0].text();
  return *build_scene(*preset);
}

bool has_note(const Result<Preset>& preset, std::string_view part) {
  return preset && std::ranges::any_of(preset->notes, [&](const Error& note) {
           return note.text().find(part) != std::string::npos;
         });
}

fs::path house_with_materials() {
  fs::path folder =
      fs::path(testing::TempDir()) /
      (std::string("frond_mesh_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  Raster tiles(2, 2, 3);
  tiles.data = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  EXPECT_TRUE(write_file(folder / "tiles.png", *png_text(tiles)).ok());
  EXPECT_TRUE(write_file(folder / "house.mtl",
                         "newmtl brick\nKd 0.6 0.3 0.2\nnewmtl glass\nKd 0.4 0.6 0.8\nd 0.3\n"
                         "newmtl roof\nKd 1 1 1\nmap_Kd tiles.png\n")
                  .ok());
  EXPECT_TRUE(
      write_file(folder / "house.obj",
                 "mtllib house.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\n"
                 "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl brick\nf 1 2 3 4\nusemtl glass\nf 2 5 6 3\n"
                 "usemtl roof\nf 5/1 7/2 8/3 6/4\n")
          .ok());
  return folder;
}

TEST(Mesh, WhatLiesIsToldAndStandsByItsAxisAndUnit) {
  EXPECT_TRUE(has_note(with_mesh(R"("file": "garage.obj")"), "\"up\": \"z\""));
  Result<Preset> upright = with_mesh(R"("file": "garage.obj", "up": "z", "unit": "cm")");
  EXPECT_FALSE(has_note(upright, "\"up\": \"z\""));
  Scene scene = mesh_scene_with(R"("file": "garage.obj", "up": "z", "unit": "cm")");
  Bounds box = bounds_of(scene.specimens[0].model.solids);
  EXPECT_NEAR(box.size().y, 4.4, 1e-4) << "the pipe's height";
  EXPECT_NEAR(box.size().x, 6.1, 1e-4);
  EXPECT_NEAR(box.low.y, 0, 1e-4);
  // What was -y, the side of the panes, is the front.
  Scene panes = mesh_scene_with(R"("file": "garage.obj", "up": "z", "unit": "cm", "parts": ["glass"])");
  EXPECT_NEAR(bounds_of(panes.specimens[0].model.solids).size().z, 0.11, 1e-4);
  EXPECT_FALSE(has_note(with_mesh(R"("file": "gable.obj")", "tests/cases/17-gable-ngon"), "\"up\": \"z\""));
}

TEST(Mesh, UnitsAndPartsThatCannotBeAreRefused) {
  Result<Preset> both = with_mesh(R"("file": "garage.obj", "unit": "cm", "size": 3)");
  ASSERT_FALSE(both);
  EXPECT_NE(both.errors()[0].text().find("/organisms/0/size: says how large"), std::string::npos);
  Result<Preset> unknown = with_mesh(R"("file": "garage.obj", "carries": ["bricks"])");
  ASSERT_FALSE(unknown);
  EXPECT_NE(
      unknown.errors()[0].text().find("/organisms/0/carries/0: no part of garage.obj is named \"bricks\""),
      std::string::npos);
  EXPECT_NE(unknown.errors()[0].text().find("did you mean \"brick\""), std::string::npos);
}

TEST(Mesh, MaterialsOfTheFileAreDrawnOrToldOf) {
  fs::path folder = house_with_materials();
  Scene scene = mesh_scene_with(R"("file": "house.obj")", folder);
  const Specimen& body = scene.specimens[0];
  ASSERT_EQ(body.model.solids.shapes.size(), 3u);
  EXPECT_EQ(body.model.find_fault(), "");
  EXPECT_EQ(body.model.solids.shapes[0].material.color, (Color{0.6f, 0.3f, 0.2f}));
  EXPECT_EQ(body.model.solids.shapes[0].material.matter, Matter::plain);
  ASSERT_EQ(body.look.pictures.size(), 2u) << "a pane that lets light through, and tiles";
  Result<std::vector<Picture>> pane = body.look.pictures[0].draw(), roof = body.look.pictures[1].draw();
  ASSERT_TRUE(pane && roof);
  EXPECT_EQ(read_png((*pane)[0].bytes)->channels, 4);
  EXPECT_EQ(read_png((*roof)[0].bytes)->data[0], 255);
  const Surface& tiles = body.model.solids.shapes[2].surface;
  ASSERT_EQ(tiles.uv.size(), tiles.position.size());
  // Colours with the pattern of a matter; one colour for all.
  Scene bricks = mesh_scene_with(R"("file": "house.obj", "matter": "brick")", folder);
  EXPECT_EQ(bricks.specimens[0].model.solids.shapes[0].material.matter, Matter::brick);
  EXPECT_EQ(bricks.specimens[0].model.solids.shapes[1].material.color, (Color{0.4f, 0.6f, 0.8f}));
  EXPECT_TRUE(has_note(with_mesh(R"("file": "house.obj", "matter": "brick")", folder),
                       "the pictures that the file gives its materials \"roof\""));
  EXPECT_EQ(mesh_scene_with(R"("file": "house.obj", "color": "#fff")", folder)
                .specimens[0]
                .model.solids.shapes.size(),
            1u);
  EXPECT_TRUE(has_note(
      with_mesh(R"("file": "house.obj", "color": "#fff")", folder),
      "takes the place of the colours that the file gives its materials \"brick\", \"glass\", \"roof\""));
  EXPECT_TRUE(has_note(with_mesh(R"("file": "garage.obj")"), "garage.mtl"));
}

TEST(Mesh, OtherMaterialsAreAnotherContent) {
  fs::path folder = house_with_materials();
  Result<Preset> before = with_mesh(R"("file": "house.obj")", folder);
  EXPECT_TRUE(write_file(folder / "house.mtl", "newmtl brick\nKd 0 0 0\n").ok());
  Result<Preset> after = with_mesh(R"("file": "house.obj")", folder);
  EXPECT_NE(before->organisms[0].grower->keys().all(), after->organisms[0].grower->keys().all());
}

/// Metres from a place to the nearest of the parts of the garage that bear a name.
double distance_to(const char* part, const Vec3& place) {
  static std::map<std::string, TriangleSurface> hosts;
  auto [host, fresh] = hosts.try_emplace(
      part, std::move(*TriangleSurface::build(skin_of(
                mesh_scene_with(std::string(R"("file": "garage.obj", "up": "z", "unit": "cm", )") +
                                R"("parts": ["walls", "panes", "pipes"], "carries": [")" + part + "\"]")
                    .specimens[0]
                    .model))));
  std::optional<Contact> near = host->second.closest(DVec3(place));
  bool barred = host->second.paint(near->triangle, near->point).z < 0;
  return barred ? 1e9 : near->distance;
}

TEST(Mesh, IvyKeepsToThePartsThatCarryIt) {
  std::string garage = R"("file": "garage.obj", "up": "z", "unit": "cm", "carries": ["brick"])";
  Result<Preset> preset =
      read_preset(R"({"seed": 3, "scene": {"setting": "studio"}, "organisms": [{"kind": "mesh",
      "name": "body", "place": {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0}, )" +
                      garage +
                      R"(}, {"kind": "ivy", "on": ["body"], "count": 4, "facing": [0, 0, 1],
      "crawl": {"max_age": 200, "let_go": 0}, "growth": {"duration": 0}}]})",
                  "tests/cases/19-zup-cm-groups/test.json", {});
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  Result<Scene> scene = build_scene(*preset);
  ASSERT_TRUE(scene) << scene.errors()[0].text();
  const Skeleton& strands = scene->specimens[1].model.skeleton;
  EXPECT_GT(strands.size(), 500u);
  std::size_t beside = 0;
  for (const Vec3& p : strands.position) beside += distance_to("brick", p) > 0.05;
  // A tip may look over the rim of a pane before it stops.
  EXPECT_LT(beside, strands.size() / 100);
  // Outside of it, though its faces look inward.
  TriangleSurface host = std::move(*TriangleSurface::build(skin_of(scene->specimens[0].model)));
  std::size_t inside = 0;
  for (const Vec3& p : strands.position) inside += host.inside(DVec3(p));
  EXPECT_LT(inside, strands.size() / 100);
}

}  // namespace
}  // namespace frond
