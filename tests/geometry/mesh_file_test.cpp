#include "geometry/mesh_file.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/files.h"
#include "geometry/obj.h"

// Meshes as other programs write them, told by what they hold.

namespace frond {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = "tests/cases";

Result<PolygonMesh> mesh_of(std::string text, const std::string& name = "body.dat") {
  return read_mesh_file({name, std::move(text), nullptr});
}

PolygonMesh mesh_at(const fs::path& path) {
  Result<PolygonMesh> mesh = read_mesh_file({path, *read_file(path), nullptr});
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : mesh.errors()[0].text());
  return mesh ? std::move(*mesh) : PolygonMesh{};
}

Surface surface_of(const PolygonMesh& mesh) {
  Result<PartedSurface> made = parted_surface(mesh, {}, "body");
  EXPECT_TRUE(made.ok()) << (made ? "" : made.errors()[0].text());
  if (!made) return {};
  EXPECT_EQ(made->surface.find_fault(), "");
  return std::move(made->surface);
}

double volume_of(const Surface& s) {
  double sum = 0;
  for (auto [a, b, c] : s.triangle)
    sum += glm::dot(DVec3(s.position[a]), glm::cross(DVec3(s.position[b]), DVec3(s.position[c])));
  return sum / 6;
}

template <class T>
void put(std::string& bytes, T value, bool big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bool turned = big != (std::endian::native == std::endian::big);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += raw[turned ? sizeof(T) - 1 - i : i];
}

/// A cube of side 2 on the origin in triangles.
constexpr std::array<std::array<float, 3>, 8> kCube{
    {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};
constexpr std::array<std::array<int, 3>, 12> kSides{{{0, 2, 1},
                                                     {0, 3, 2},
                                                     {4, 5, 6},
                                                     {4, 6, 7},
                                                     {0, 1, 5},
                                                     {0, 5, 4},
                                                     {1, 2, 6},
                                                     {1, 6, 5},
                                                     {2, 3, 7},
                                                     {2, 7, 6},
                                                     {3, 0, 4},
                                                     {3, 4, 7}}};

std::string stl_cube() {
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // as some programs begin binary ones
  put(bytes, std::uint32_t{12});
  for (const auto& side : kSides) {
    bytes += std::string(12, '\0');
    for (int corner : side)
      for (float x : kCube[static_cast<std::size_t>(corner)]) put(bytes, x);
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string stl_text_cube() {
  std::string text = "solid cube\r\n";
  for (const auto& side : kSides) {
    text += "facet normal 0 0 0\r\n outer loop\r\n";
    for (int corner : side) {
      const auto& p = kCube[static_cast<std::size_t>(corner)];
      text += "  VERTEX\t" + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) +
              "\r\n";
    }
    text += " endloop\r\nendfacet\r\n";
  }
  return text + "endsolid cube\r\n";
}

std::string ply_cube(bool big) {
  std::string bytes =
      "ply\r\nformat binary_" + std::string(big ? "big" : "little") +
      "_endian 1.0\r\nelement vertex 8\r\nproperty double x\r\nproperty double y\r\nproperty double "
      "z\r\nproperty uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\nelement extra "
      "1\r\nproperty list uchar short what\r\nelement face 12\r\nproperty uchar mark\r\nproperty list "
      "uchar uint vertex_index\r\nend_header\r\n";
  for (const auto& p : kCube) {
    for (float x : p) put(bytes, static_cast<double>(x), big);
    bytes += std::string(3, '\x80');
  }
  bytes += '\x02', put(bytes, std::int16_t{5}, big), put(bytes, std::int16_t{6}, big);
  for (const auto& side : kSides) {
    bytes += '\0', bytes += '\3';
    for (int corner : side) put(bytes, static_cast<std::uint32_t>(corner), big);
  }
  return bytes;
}

/// JSON and data as a GLB file.
std::string glb_of(std::string json, const std::string& data) {
  while (json.size() % 4) json += ' ';
  std::string bytes = "glTF";
  put(bytes, std::uint32_t{2});
  put(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  put(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  put(bytes, static_cast<std::uint32_t>(data.size()));
  bytes += std::string("BIN\0", 4) + data;
  return bytes;
}

/// A cube as GLB, on a node that is mirrored and moved by `x`.
std::string glb_cube(double x) {
  std::string data;
  for (const auto& p : kCube)
    for (float at : p) put(data, at);
  for (const auto& side : kSides)
    for (int corner : side) put(data, static_cast<std::uint16_t>(corner));
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],"translation":[)" +
      std::to_string(x) +
      R"(,0,0]},{"mesh":0,"name":"box","scale":[-1,1,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)"
      R"("materials":[{"name":"brick","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],"buffers":[{"byteLength":168}]})";
  return glb_of(json, data);
}

/// A cube whose places are zeros but for `replaced` of the eight, which a sparse accessor gives; with `base`
/// they are all twice as far out but for these.
std::string sparse_cube(bool base, std::vector<std::uint16_t> replaced) {
  std::string data;
  for (const auto& p : kCube)
    for (float at : p) put(data, 2 * at);
  for (const auto& side : kSides)
    for (int corner : side) put(data, static_cast<std::uint16_t>(corner));
  for (std::uint16_t i : replaced) put(data, i);
  while (data.size() % 4) data += '\0';
  std::size_t values = data.size();
  for (std::uint16_t i : replaced)
    for (float at : kCube[i % kCube.size()]) put(data, at);
  std::string count = std::to_string(replaced.size());
  return glb_of(
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[{)" +
          std::string(base ? R"("bufferView":0,)" : "") +
          R"("componentType":5126,"count":8,"type":"VEC3","sparse":{"count":)" + count +
          R"(,"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":3}}},)"
          R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72},)"
          R"({"buffer":0,"byteOffset":168,"byteLength":)" +
          std::to_string(2 * replaced.size()) + R"(},{"buffer":0,"byteOffset":)" + std::to_string(values) +
          R"(,"byteLength":)" + std::to_string(12 * replaced.size()) + R"(}],"buffers":[{"byteLength":)" +
          std::to_string(data.size()) + "}]}",
      data);
}

TEST(MeshFile, SparseAccessorsOfGlbReplaceEntriesOfTheirOwnOrOfZeros) {
  Result<PolygonMesh> zeros = mesh_of(sparse_cube(false, {0, 1, 2, 3, 4, 5, 6, 7}));
  ASSERT_TRUE(zeros.ok()) << zeros.errors()[0].text();
  EXPECT_NEAR(volume_of(surface_of(*zeros)), 8, 1e-5);
  Result<PolygonMesh> some = mesh_of(sparse_cube(true, {1, 6}));
  ASSERT_TRUE(some.ok()) << some.errors()[0].text();
  for (std::size_t i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(some->place[i][axis],
                (i == 1 || i == 6 ? 1 : 2) * static_cast<double>(kCube[i][static_cast<std::size_t>(axis)]));
  EXPECT_EQ(mesh_of(sparse_cube(false, {0, 9})).errors()[0].what,
            "has a sparse accessor that replaces an entry which is not there");
  std::string whole = sparse_cube(true, {1, 6}), far = whole;
  far.replace(far.find(R"("count":2)"), 9, R"("count":9)");
  EXPECT_EQ(mesh_of(far).errors()[0].what, "names data beyond its end");
  std::string many = sparse_cube(false, {0, 1});
  many.replace(many.find(R"("count":8,"type")"), 16, R"("count":8e8,"type)");
  EXPECT_FALSE(mesh_of(many).ok());
}

TEST(MeshFile, FormatsAreToldByTheirContent) {
  struct {
    const char* what;
    std::string bytes;
  } const files[] = {{"binary STL", stl_cube()},
                     {"text STL", stl_text_cube()},
                     {"little PLY", ply_cube(false)},
                     {"big PLY", ply_cube(true)},
                     {"GLB", glb_cube(0)}};
  for (const auto& file : files) {
    SCOPED_TRACE(file.what);
    Result<PolygonMesh> mesh = mesh_of(file.bytes, "cube.OBJ");
    ASSERT_TRUE(mesh.ok()) << mesh.errors()[0].text();
    EXPECT_EQ(mesh->place.size(), 8u);
    Surface surface = surface_of(*mesh);
    EXPECT_EQ(surface.triangle.size(), 12u);
    EXPECT_NEAR(area(surface), 24, 1e-5);
    EXPECT_NEAR(volume_of(surface), 8, 1e-5) << "outward";
  }
}

TEST(MeshFile, FilesThatAreCutShortAreToldNotRead) {
  for (const std::string& whole : {stl_cube(), ply_cube(true), ply_cube(false), glb_cube(1)})
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 40) {
      Result<PolygonMesh> mesh = mesh_of(whole.substr(0, length));
      if (mesh) (void)parted_surface(*mesh, {}, "body");
    }
  EXPECT_EQ(mesh_of(ply_cube(true).substr(0, 500)).errors()[0].what,
            "its header promises 8 of \"vertex\", but the numbers of 7 alone can be read");
}

TEST(MeshFile, ObjTextsOfOtherProgramsAreRead) {
  Surface plain = surface_of(mesh_at(kCases / "16-rhino-obj/summerhouse_plain.obj"));
  Surface rhino = surface_of(mesh_at(kCases / "16-rhino-obj/summerhouse.obj"));
  EXPECT_EQ(rhino.triangle, plain.triangle);
  EXPECT_EQ(rhino.position, plain.position);
  EXPECT_EQ(rhino.normal, plain.normal) << "the one normal of the file fits few of its faces";
  for (const char* text : {"\xEF\xBB\xBFv 0 0 0\r\nv\t1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n\x1A",
                           "V 0 0 0\rV 1 0 0\rV 0 1 0\rF -3 -2 -1\r",
                           "v 0 0 0 \\\n\nv 1 0 \\\r\n 0\nv 0 1 0\nusemtl\nusemtl \ng\nf 1 \\\n 2 \\\n 3"}) {
    Result<PolygonMesh> mesh = mesh_of(text);
    ASSERT_TRUE(mesh.ok()) << mesh.errors()[0].text();
    EXPECT_NEAR(area(surface_of(*mesh)), 0.5, 1e-6);
  }
  EXPECT_EQ(mesh_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 \\\n 2 \\\n 9\n", "a.obj").errors()[0].where, "a.obj:4");
}

TEST(MeshFile, ConcavePolygonsKeepTheirAreas) {
  Surface gable = surface_of(mesh_at(kCases / "17-gable-ngon/gable.obj"));
  double front = 0;
  for (auto [a, b, c] : gable.triangle) {
    Vec3 p = gable.position[a], q = gable.position[b], r = gable.position[c];
    Vec3 one = glm::cross(q - p, r - p) * 0.5f;
    if (std::abs(one.z) > 0.99f * glm::length(one) && p.z > 0) front += glm::length(one);
  }
  EXPECT_NEAR(front, 20.36, 1e-4);
  // Walls 0.3 thick round all edges; the slit has none.
  EXPECT_NEAR(volume_of(gable), 20.36 * 0.3, 1e-3);
}

TEST(MeshFile, LargeCoordinatesKeepTheirDigits) {
  // A flight of steps of 1 cm in metres of a national grid.
  std::string text = "v 5412345.00 5.0 5712345.00\nv 5412346.00 5.0 5712345.00\n";
  for (int i = 1; i <= 40; ++i) {
    char line[200];
    std::snprintf(line, sizeof line, "v 5412345.00 5.0 %.2f\nv 5412346.00 5.0 %.2f\nf %d %d %d %d\n",
                  5712345.0 + 0.01 * i, 5712345.0 + 0.01 * i, 2 * i - 1, 2 * i, 2 * i + 2, 2 * i + 1);
    text += line;
  }
  Result<PolygonMesh> mesh = mesh_of(text);
  ASSERT_TRUE(mesh.ok());
  MeshFrame frame = unit_frame(*mesh);
  Result<PartedSurface> made = parted_surface(*mesh, frame, "steps");
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->surface.triangle.size(), 80u);
  for (auto [a, b, c] : made->surface.triangle) {
    const auto& at = made->surface.position;
    EXPECT_NEAR(glm::length(glm::cross(at[b] - at[a], at[c] - at[a])), 0.01, 1e-4);
  }
}

TEST(MeshFile, MirroredPiecesAreTurnedOutward) {
  PolygonMesh garage = mesh_at(kCases / "19-zup-cm-groups/garage.obj");
  EXPECT_EQ(garage.names(), (std::vector<std::string>{"walls", "brick", "panes", "glass", "pipes", "zinc"}));
  EXPECT_GT(volume_of(surface_of(garage)), 0);
  EXPECT_EQ(garage.notes.size(), 1u) << "its MTL file is not there";
  // A hollow in a body stays one.
  std::string hollow =
      "v -1 -1 -1\nv 9 -1 -1\nv -1 9 -1\nv -1 -1 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 5 6 7\nf 5 8 6\nf 6 8 7\nf 7 8 5\n";
  EXPECT_NEAR(volume_of(surface_of(*mesh_of(hollow))), (1000 - 1) / 6.0, 1e-3);
}

TEST(MeshFile, ScansOfAllFormsAreTheSame) {
  Surface obj = surface_of(mesh_at(kCases / "21-ply-scan/boulder.obj"));
  for (const char* name : {"boulder_ascii.ply", "boulder_be.ply"}) {
    SCOPED_TRACE(name);
    Surface ply = surface_of(mesh_at(kCases / "21-ply-scan" / name));
    EXPECT_EQ(ply.triangle.size(), obj.triangle.size());
    EXPECT_NEAR(area(ply), area(obj), 1e-4);
    ASSERT_FALSE(ply.paint.empty());
    EXPECT_NEAR(ply.paint[0][0].z, obj.paint[0][0].z, 1e-3);
  }
}

TEST(MeshFile, WhatCannotBeReadIsNamedAsWhatItIs) {
  struct {
    std::string bytes, said;
  } const files[] = {
      {std::string("Kaydara FBX Binary  \0", 21), "an FBX file"},
      {"BLENDER-v293", "a file of Blender"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "a COLLADA file"},
      {"ISO-10303-21;\nHEADER;", "a STEP file"},
      {"  0\nSECTION\n  2\nHEADER\n", "a DXF text"},
      {"{\"asset\":{},\"meshes\":[]}", "a glTF text, whose data may lie in other files"},
      {"PK\x03\x04", "a zip archive, as 3MF and USDZ are"},
      {"newmtl brick\nKd 1 0 0\n", "an MTL file of materials"},
      {"OFF\n8 6 0\n", "an OFF file"},
      {"\xFF\xFEv\0", "a text in UTF-16"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
       "z\nend_header\n0 0 0\n",
       "a PLY file of 1 points without a face"},
      {"root:x:0:0:root:/root:/bin/bash\n", "is no mesh that is known"}};
  for (const auto& file : files) {
    Result<PolygonMesh> mesh = mesh_of(file.bytes, "a.obj");
    ASSERT_FALSE(mesh.ok()) << file.said;
    EXPECT_NE(mesh.errors()[0].what.find(file.said), std::string::npos) << mesh.errors()[0].text();
    EXPECT_NE(mesh.errors()[0].what.find("expected"), std::string::npos) << mesh.errors()[0].text();
  }
}

TEST(MeshFile, MaterialsComeWithTheirFile) {
  fs::path folder = fs::path(testing::TempDir()) / "frond_materials";
  auto write = [&](const char* name, std::string_view text) {
    EXPECT_TRUE(write_file(folder / name, text).ok());
  };
  write("garden house.mtl",
        "newmtl Brick\r\n\tKd 0.5 0.25 0.125\r\nnewmtl Glass\nKd .2\nTr 0.75\nnewmtl Tiles\nKd 1 1 1\n"
        "map_Kd -s 2 2 1 C:\\maps\\tiles of clay.png\n");
  write("tiles of clay.png", "PNG");
  fs::create_directories(folder / "..");
  write("../outside.mtl", "newmtl Brick\nKd 0 0 0\n");
  write("house.obj",
        "mtllib garden house.mtl\nmtllib ../outside.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Brick\nf 1 2 3\n"
        "usemtl Glass\nf 1 2 3\nusemtl Tiles\nf 1 2 3\n");
  std::vector<fs::path> noted;
  std::string content;
  NamedFile file{folder / "house.obj", *read_file(folder / "house.obj"), &noted};
  Result<PolygonMesh> mesh = read_mesh_file(file, &content);
  ASSERT_TRUE(mesh.ok());
  ASSERT_EQ(mesh->material.size(), 3u);
  EXPECT_EQ(mesh->material[0].color, (Color{0.5f, 0.25f, 0.125f})) << "nothing outside of the folder is read";
  EXPECT_NEAR(mesh->material[1].opacity, 0.25, 1e-9);
  ASSERT_TRUE(mesh->material[2].picture);
  EXPECT_EQ(*mesh->material[2].picture, "PNG");
  EXPECT_EQ(noted.size(), 2u);
  ASSERT_EQ(mesh->notes.size(), 1u);
  EXPECT_NE(mesh->notes[0].find("outside.mtl"), std::string::npos);
}

}  // namespace
}  // namespace frond
