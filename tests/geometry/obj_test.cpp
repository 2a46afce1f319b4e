#include "geometry/obj.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

/// The faces of a text as one mesh.
Result<Surface> read_obj(std::string_view text, const std::string& name = "") {
  Result<PolygonMesh> mesh = read_obj_mesh(text, name);
  if (!mesh) return mesh.errors();
  Result<PartedSurface> made = parted_surface(*mesh, {}, name);
  if (!made) return made.errors();
  return std::move(made->surface);
}

TEST(ReadObj, TakesQuadsNegativeIndicesAndSeveralObjects) {
  Result<Surface> mesh = read_obj(
      "o a\nv 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nf 1 2 3 4\n"
      "o b\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf -3 -2 -1\n");
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->triangle.size(), 3u);
  EXPECT_EQ(mesh->find_fault(), "");
  for (const Vec3& n : mesh->normal) EXPECT_NEAR(n.z, 1, 1e-5);
}

TEST(ReadObj, KeepsTheNormalsThatAreGiven) {
  Result<Surface> mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0.6 0.8\nf 1//1 2//1 3//1\n");
  ASSERT_TRUE(mesh.ok());
  EXPECT_NEAR(mesh->normal[0].y, 0.6f, 1e-5);
}

TEST(ReadObj, TakesTextureCoordinatesAndColorsAsPaint) {
  const std::string faces = "f 1/1 2/2 3/3\n", texture = "vt 0 0\nvt 1 0\nvt 0.25 1\n";
  Result<Surface> mesh = read_obj("v 0 0 0 0 0 0\nv 1 0 0 1 1 1\nv 0 1 0 0 1 0\n" + texture + faces);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->find_fault(), "");
  ASSERT_EQ(mesh->paint.size(), 1u);
  EXPECT_EQ(Vec2(mesh->paint[0][2]), Vec2(0.25f, 1));
  EXPECT_NEAR(mesh->paint[0][1].z, 1, 1e-5);
  EXPECT_NEAR(mesh->paint[0][2].z, 0.7152f, 1e-5);
  mesh = read_obj("v 0 0 0 0 0 0\nv 1 0 0\nv 0 1 0 0 1 0\n" + texture + faces);
  EXPECT_TRUE(std::isnan(mesh->paint[0][0].z)) << "not all vertices have a colour";
  mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(mesh->paint.empty());
}

TEST(ReadObj, PartsSharpEdgesWhereNoNormalsAreGiven) {
  // A flat roof ridge of 20 degrees is smooth, one of 90 degrees is not.
  const char* fold = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 {} 2\nv 1 {} 2\nf 1 4 3 2\nf 4 5 6 3\n";
  auto folded = [&](const std::string& height) {
    std::string text = fold;
    for (std::size_t at; (at = text.find("{}")) != text.npos;) text.replace(at, 2, height);
    return read_obj(text)->position.size();
  };
  EXPECT_EQ(folded("0.36"), 6u);
  EXPECT_EQ(folded("5"), 8u);
}

TEST(ReadObj, TurnsAClosedBodyOutward) {
  const char* places = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const char* faces : {"f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n", "f 2 3 1\nf 4 2 1\nf 4 3 2\nf 3 4 1\n"}) {
    Result<Surface> mesh = read_obj(std::string(places) + faces);
    for (std::size_t v = 0; v < mesh->position.size(); ++v)
      EXPECT_GT(glm::dot(mesh->normal[v], mesh->position[v] - Vec3(0.25f)), 0) << faces;
  }
}

TEST(ReadObj, PassesOverWhatCannotBeDrawn) {
  Result<Surface> mesh = read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\nf 1 2 3\n");
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->triangle.size(), 1u);
  EXPECT_FALSE(read_obj("v 0 0 0\n").ok());
  EXPECT_FALSE(read_obj("").ok());
}

TEST(ReadObj, WhatIsWrongIsToldWithItsLine) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  struct {
    std::string text, said;
  } const cases[] = {
      {"v 0 0 0\nv nan 0 0\n", "m.obj:2: a place whose number 1 is none; expected three finite numbers"},
      {"v 0 0 0\nv 1 1e99 0\n", "m.obj:2: a place whose number 2 is none; expected three finite numbers"},
      {"v 0 0\n", "m.obj:1: a place whose number 3 is none; expected three finite numbers"},
      {"v 0 0 root:x:0\n", "m.obj:1: a place whose number 3 is none; expected three finite numbers"},
      {"vn inf 0 0\n", "m.obj:1: a normal whose number 1 is none; expected three finite numbers"},
      {corners + "f 1 2 4\n",
       "m.obj:4: a corner names a place that is not there; expected one of the 3 that the file has"},
      {corners + "\r\nf 1 2 0\r\n",
       "m.obj:5: a corner names a place that is not there; expected one of the 3 that the file has"},
      {corners + "f -1 -2 -4\n",
       "m.obj:4: a corner names a place that is not there; expected one of the 3 that the file has"},
      {corners + "f 1 2 99999999999999999999\n",
       "m.obj:4: a corner names a place that is not there; expected one of the 3 that the file has"},
      {corners + "f 1//1 2//1 3//2\nvn 0 0 1\n",
       "m.obj:4: a corner names a normal that is not there; expected one of the 1 that the file has"},
      {corners + "f 1 2 x\n",
       "m.obj:4: a corner names a place that is not there; expected one of the 3 that the file has"},
      {corners + "f 1 2\n", "m.obj:4: a face of 2 corners; expected 3 or more"},
      {corners + "l 1\n", "m.obj:4: a line of 1 corners; expected 2 or more"},
      {corners, "m.obj: holds no face that could be drawn"},
      {"root:x:0:0:root:/root:/bin/bash\n", "m.obj: holds no face that could be drawn"},
  };
  for (const auto& c : cases) {
    Result<Surface> mesh = read_obj(c.text, "m.obj");
    ASSERT_FALSE(mesh.ok()) << c.text;
    EXPECT_EQ(mesh.errors()[0].text(), c.said) << c.text;
  }
  EXPECT_EQ(read_obj_lines(corners + "l 1 9\n", "m.obj").errors()[0].where, "m.obj:4");
  EXPECT_TRUE(read_obj("f 1/7/1 2/7/1 3/7/1 # first\nvn 0 0 +1\n" + corners).ok()) << "in any order";
}

TEST(Obj, LineSets) {
  Result<LineSet> set = read_obj_lines("v 0 0 0\nv 0 1 0\nv 1 2 0\nv 5 5 5\nl 1 2 3\nl -1 2\n");
  ASSERT_TRUE(set.ok()) << set.errors()[0].text();
  EXPECT_EQ(set->place.size(), 4u);
  using Line = std::array<std::uint32_t, 2>;
  EXPECT_EQ(set->line, (std::vector<Line>{{0, 1}, {1, 2}, {3, 1}}));
  EXPECT_FALSE(read_obj_lines("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").ok());
}

}  // namespace
}  // namespace frond
