#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/seed.h"
#include "geometry/mesh_file.h"
#include "mutant.h"

// Meshes that are damaged, or made to do damage: each is read or refused, and what is read holds together.

namespace frond {
namespace mesh_mutants {
namespace {

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

template <class T>
void put_at(std::string& bytes, std::size_t at, T value) {
  if (at + sizeof(T) <= bytes.size()) std::memcpy(bytes.data() + at, &value, sizeof(T));
}

constexpr std::array<std::array<float, 3>, 4> kPlaces{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
constexpr std::array<std::array<std::uint16_t, 3>, 4> kSides{{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

std::string glb_of(std::string json, const std::string& data) {
  while (json.size() % 4) json += ' ';
  std::string bytes = "glTF";
  put(bytes, std::uint32_t{2});
  put(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  put(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  put(bytes, static_cast<std::uint32_t>(data.size()));
  return bytes + std::string("BIN\0", 4) + data;
}

/// Places, normals, texture coordinates, colours and triangles, of which sparse accessors replace some.
std::string glb_data() {
  std::string data;
  for (int copy = 0; copy < 4; ++copy)  // 48 bytes each
    for (const auto& p : kPlaces)
      for (float x : p) put(data, x);
  for (const auto& side : kSides)  // 24 bytes from 192 on
    for (std::uint16_t corner : side) put(data, corner);
  put(data, std::uint16_t{1}), put(data, std::uint16_t{3});  // 216
  return data;
}

const std::string kGlbText =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
    R"("nodes":[{"children":[1,2],"translation":[1,0,0],"rotation":[0,0,0,1]},{"mesh":0,"name":"box","scale":[-1,1,1]},)"
    R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,3,0,0,1]}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3},"indices":4,"material":0,"mode":4},)"
    R"({"attributes":{"POSITION":5},"indices":4,"mode":5}]}],)"
    R"("materials":[{"name":"brick","alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"baseColorTexture":{"index":0}}}],)"
    R"("textures":[{"source":0}],"images":[{"bufferView":1,"name":"p"}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
    R"({"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC3"},)"
    R"({"bufferView":0,"byteOffset":96,"componentType":5126,"count":4,"type":"VEC2"},)"
    R"({"bufferView":0,"byteOffset":144,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"},)"
    R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"},)"
    R"({"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":0}}}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":192},{"buffer":0,"byteOffset":192,"byteLength":24},{"buffer":0,"byteOffset":216,"byteLength":4}],)"
    R"("buffers":[{"byteLength":220}]})";

std::string stl() {
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(kSides.size()));
  for (const auto& side : kSides) {
    bytes += std::string(12, '\0');
    for (std::uint16_t corner : side)
      for (float x : kPlaces[corner]) put(bytes, x);
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string ply(bool ascii) {
  std::string bytes = "ply\nformat " + std::string(ascii ? "ascii" : "binary_little_endian") +
                      " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                      "property float nx\nproperty float ny\nproperty float nz\nproperty float u\n"
                      "property float v\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : kPlaces) {
    if (ascii) {
      for (int copy = 0; copy < 2; ++copy)
        for (float x : p) bytes += std::to_string(x) + " ";
      bytes += "0.5 0.25 100 120 140\n";
    } else {
      for (int copy = 0; copy < 2; ++copy)
        for (float x : p) put(bytes, x);
      put(bytes, 0.5f), put(bytes, 0.25f);
      bytes += "\x10\x20\x30";
    }
  }
  for (const auto& side : kSides) {
    bytes += ascii ? std::string("3") : std::string("\3");
    for (std::uint16_t corner : side) {
      if (ascii)
        bytes += " " + std::to_string(corner);
      else
        put(bytes, static_cast<std::int32_t>(corner));
    }
    if (ascii) bytes += '\n';
  }
  return bytes;
}

/// Whether what is painted has numbers or is none, as kUnpainted.
bool is_paint(const Vec3& v) { return !std::isinf(v.x) && !std::isinf(v.y) && !std::isinf(v.z); }

/// Reads bytes, and cuts what was read into triangles; whether that could be done.
bool holds_together(const std::string& bytes) {
  Result<PolygonMesh> mesh = read_mesh_file({"damaged", bytes, nullptr});
  if (!mesh) {
    EXPECT_FALSE(mesh.errors().front().what.empty());
    return false;
  }
  auto names = [](std::int32_t index, std::size_t count) {
    return index == PolygonMesh::kNone || (index >= 0 && static_cast<std::size_t>(index) < count);
  };
  bool whole = mesh->color.empty() || mesh->color.size() == mesh->place.size();
  for (const PolygonMesh::Corner& corner : mesh->corner)
    whole = whole && corner.place < mesh->place.size() && names(corner.texture, mesh->texture.size()) &&
            names(corner.normal, mesh->normal.size());
  for (const PolygonMesh::Face& face : mesh->face)
    whole = whole && face.count >= 3 && face.first + face.count <= mesh->corner.size() &&
            face.part < mesh->part.size();
  for (const PolygonMesh::Part& part : mesh->part)
    whole = whole && names(part.material, mesh->material.size());
  for (const DVec3& place : mesh->place) whole = whole && std::isfinite(place.x + place.y + place.z);
  EXPECT_TRUE(whole) << "what the mesh names is not there";
  if (!whole) return false;
  (void)mesh->names();
  Result<PartedSurface> made = parted_surface(*mesh, unit_frame(*mesh), "damaged");
  if (!made) return false;
  EXPECT_EQ(made->surface.find_fault(), "");
  for (const auto& paint : made->surface.paint) EXPECT_TRUE(std::ranges::all_of(paint, is_paint));
  return true;
}

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Bytes of which one to three are others, some are gone, or numbers are none.
std::string damaged(std::string bytes, Seed seed) {
  constexpr std::array<float, 5> kWrong{kNan, kInfinite, -kInfinite, 3e38f, 1e-40f};
  constexpr std::array<std::uint32_t, 5> kLengths{0xFFFFFFFF, 0x7FFFFFFF, 0x80000000, 0, 0x10000};
  for (std::uint64_t i = 0, n = 1 + seed.child("count").bits() % 3; i < n && !bytes.empty(); ++i) {
    Seed place = seed.child("place", i);
    std::size_t at = place.bits() % bytes.size(), which = place.child("which").bits() % 5;
    switch (place.child("kind").bits() % 4) {
      case 0:
        bytes[at] = static_cast<char>(place.child("byte").bits());
        break;
      case 1:
        put_at(bytes, at / 4 * 4, kWrong[which]);
        break;
      case 2:
        put_at(bytes, at / 4 * 4, kLengths[which]);
        break;
      default:
        bytes.resize(place.child("cut").bits() % 8 == 0 ? at : bytes.size());
    }
  }
  return bytes;
}

/// A text with one or two of its numbers replaced by ones that are out of range.
std::string misnumbered(std::string text, Seed seed) {
  static const std::vector<std::string> kNumbers{"-1",
                                                 "-5",
                                                 "1e300",
                                                 "4294967295",
                                                 "18446744073709551615",
                                                 "9223372036854775807",
                                                 "0",
                                                 "0.5",
                                                 "99",
                                                 "5",
                                                 "1e-300",
                                                 "null",
                                                 "[]",
                                                 "\"a\"",
                                                 "1e999",
                                                 "{}"};
  for (std::uint64_t i = 0, n = 1 + seed.child("count").bits() % 2; i < n; ++i) {
    Seed place = seed.child("number", i);
    std::size_t from = place.bits() % text.size(), first = text.find_first_of("0123456789", from);
    if (first == text.npos) continue;
    std::size_t end = text.find_first_not_of("0123456789.", first);
    text.replace(first, std::min(end, text.size()) - first,
                 kNumbers[place.child("which").bits() % kNumbers.size()]);
  }
  return text;
}

TEST(MeshMutants, DamagedGlbIsReadOrRefused) {
  const std::string data = glb_data(), whole = glb_of(kGlbText, data);
  ASSERT_TRUE(holds_together(whole));
  const std::vector<std::string> pieces{"{",  "}", "[",  "]",    ",",    ":",
                                        "\"", "0", "-1", "null", "true", "\"uri\":\"a\","};
  int right = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    SCOPED_TRACE(i);
    right += holds_together(damaged(whole, Seed{i}));
    right += holds_together(glb_of(misnumbered(kGlbText, Seed{i}), data));
    right += holds_together(glb_of(mutant(kGlbText, pieces, Seed{i}), data));
    right += holds_together(glb_of(kGlbText, damaged(data, Seed{i})));
  }
  EXPECT_GT(right, 1000);
}

TEST(MeshMutants, DamagedStlIsReadOrRefused) {
  const std::string whole = stl();
  ASSERT_TRUE(holds_together(whole));
  int right = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    right += holds_together(damaged(whole, Seed{i}));
  }
  EXPECT_GT(right, 300);
}

TEST(MeshMutants, DamagedPlyIsReadOrRefused) {
  const std::string text = ply(true), binary = ply(false);
  ASSERT_TRUE(holds_together(text));
  ASSERT_TRUE(holds_together(binary));
  const std::vector<std::string> pieces{"element", "property", "list", "vertex 3\n", "nan",
                                        "-1",      "uchar ",   "\n",   " "};
  int right = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    SCOPED_TRACE(i);
    right += holds_together(damaged(binary, Seed{i}));
    right += holds_together(mutant(text, pieces, Seed{i}));
    right += holds_together(misnumbered(text, Seed{i}));
  }
  EXPECT_GT(right, 300);
}

TEST(MeshMutants, NestingWithoutEndIsRefused) {
  constexpr std::size_t kDeep = 3'000'000;
  std::string deep = R"({"nodes":[{"children":)" + std::string(kDeep, '[') + std::string(kDeep, ']') +
                     R"(}],"scenes":[{"nodes":[0]}]})";
  EXPECT_FALSE(holds_together(glb_of(deep, "")));
}

TEST(MeshMutants, ManyPartsOfTheSameDataAreRefusedBeforeTheyFillTheMemory) {
  std::string primitives;
  for (int i = 0; i < 30; ++i)
    primitives += std::string(i > 0 ? "," : "") + R"({"attributes":{"POSITION":0},"material":0})";
  std::string data(1 << 20, '\0');
  std::string text = R"({"meshes":[{"primitives":[)" + primitives + R"(]}],"materials":[{}],"accessors":[)" +
                     R"({"bufferView":0,"componentType":5121,"count":1000000,"type":"VEC3"}],)" +
                     R"("bufferViews":[{"buffer":0,"byteLength":1048576,"byteStride":1}],"buffers":[{}]})";
  EXPECT_FALSE(holds_together(glb_of(text, data)));
}

TEST(MeshMutants, AnElementOfNothingEnds) {
  std::string text = ply(true);
  text.insert(text.find("element face"), "element nothing 9000000000000000000\n");
  EXPECT_TRUE(holds_together(text));
}

TEST(MeshMutants, VerticesOfTwoKindsHaveWhatAllHave) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nproperty float u\nproperty float v\n"
      "property float red\nproperty float green\nproperty float blue\nelement vertex 2\n"
      "property float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1 0 0 1 1 1\n1 0 0 0 0 1 0 0 1 1 1\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  EXPECT_TRUE(holds_together(text));
}

TEST(MeshMutants, AMaterialBelowTheFirstIsRefused) {
  std::string text = kGlbText;
  text.replace(text.find(R"("material":0)"), 12, R"("material":-5)");
  EXPECT_FALSE(holds_together(glb_of(text, glb_data())));
}

}  // namespace
}  // namespace mesh_mutants
}  // namespace frond
