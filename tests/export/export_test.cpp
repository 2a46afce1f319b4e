#include <gtest/gtest.h>
#include <sys/resource.h>
#include <tiny_obj_loader.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/files.h"
#include "export/formats.h"

namespace frond {
namespace {

using nlohmann::json;

/// A coral, a small plant with leaves and a wall; `body` stands in their defaults.
Scene garden(const std::string& style = R"("sweeps")") {
  std::string text = R"({"seed": 3, "film": {"frames": 24, "fps": 12}, "defaults": {"body": )" + style + R"(},
    "organisms": [
      {"kind": "coral", "name": "red \"coral\"", "steps": 2, "height": 0.5, "growth": {"duration": 1},
       "place": {"at": [[0, 0]]}},
      {"kind": "plant", "name": "herb", "height": 0.4, "place": {"at": [[1, 0]]},
       "grammar": {"axiom": "F[+L]F[-L]FL", "angle": 50, "length": 1, "width": 0.1},
       "organs": [{"symbol": "L", "shape": "flower", "size": 0.05}]}]})";
  Result<Preset> preset = read_preset(text, "garden.json", {});
  EXPECT_TRUE(preset) << preset.errors()[0].text();
  return *build_scene(*preset);
}

Cast cast_of(const Scene& scene, double time = 2) {
  Result<Cast> cast = cast_scene(scene, time, {});
  EXPECT_TRUE(cast);
  return *cast;
}

std::size_t all_triangles(const Cast& cast) {
  std::size_t sum = 0;
  for (const CastPlacement& p : cast.placements) sum += cast.meshes[p.mesh].surface.triangle.size();
  return sum;
}

TEST(Cast, holds_sound_meshes_and_each_organ_once) {
  Cast cast = cast_of(garden());
  std::set<std::string> names;
  for (const CastMaterial& m : cast.materials) EXPECT_TRUE(names.insert(m.name).second) << m.name;
  for (const CastMesh& mesh : cast.meshes) {
    EXPECT_EQ(mesh.surface.check(), "") << mesh.name;
    EXPECT_LT(mesh.material, cast.materials.size());
  }
  std::map<std::size_t, int> placed;
  for (const CastPlacement& p : cast.placements) ++placed[p.mesh];
  int thrice = 0;
  for (auto [mesh, times] : placed) thrice += times == 3;
  EXPECT_EQ(thrice, 2);  // petals and heart of the three flowers
}

TEST(Cast, grows_with_time_and_is_near_what_was_foreseen) {
  Scene scene = garden();
  CastSize foreseen = foresee_cast(scene, {});
  auto grown = static_cast<double>(all_triangles(cast_of(scene)));
  EXPECT_GT(foreseen.all_triangles, 0.7 * grown);
  EXPECT_LT(foreseen.all_triangles, 1.5 * grown);
  EXPECT_LT(all_triangles(cast_of(scene, 0.2)), all_triangles(cast_of(scene)));
}

TEST(Cast, follows_the_style) {
  for (const char* style : {R"("fused")", R"({"build": "voxels", "voxel": 0.03})"}) {
    Scene scene = garden(style);
    Cast cast = cast_of(scene);
    const CastMesh& coral = cast.meshes[0];
    EXPECT_EQ(coral.surface.check(), "");
    EXPECT_GT(coral.surface.triangle.size(), 300u);
    EXPECT_NE(coral.surface.triangle.size(), cast_of(garden()).meshes[0].surface.triangle.size());
  }
}

TEST(Formats, are_told_by_the_extension) {
  EXPECT_EQ((*format_of("a/b.glb"))->extension, ".glb");
  Result<const Format*> none = format_of("a/b.stl");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.errors()[0].what,
            "\".stl\" is no format that is known; expected one of .obj, .ply, .glb, .vdb");
}

TEST(Obj, is_read_back_by_tinyobjloader) {
  Cast cast = cast_of(garden());
  tinyobj::attrib_t attrib;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warn, error;
  std::istringstream text(obj_text(cast, "garden.mtl")), colors(mtl_text(cast));
  tinyobj::MaterialStreamReader reader(colors);
  ASSERT_TRUE(tinyobj::LoadObj(&attrib, &shapes, &materials, &warn, &error, &text, &reader, false)) << error;
  EXPECT_EQ(warn, "");
  EXPECT_EQ(shapes.size(), cast.placements.size());
  EXPECT_EQ(materials.size(), cast.materials.size());
  std::size_t faces = 0, vertex = 0;
  for (const auto& shape : shapes) faces += shape.mesh.num_face_vertices.size();
  EXPECT_EQ(faces, all_triangles(cast));
  for (const CastPlacement& p : cast.placements) {
    Surface surface = placed(cast.meshes[p.mesh], p);
    for (std::size_t v = 0; v < surface.position.size(); ++v, ++vertex)
      for (std::size_t a = 0; a < 3; ++a) {
        auto axis = static_cast<int>(a);
        ASSERT_NEAR(attrib.normals[3 * vertex + a], surface.normal[v][axis], 1e-5);
      }
  }
  EXPECT_EQ(attrib.normals.size(), 3 * vertex);
  EXPECT_LT(attrib.vertices.size(), 3 * vertex);  // seams are not of the body
  for (std::size_t o = 0; o < shapes.size(); ++o) {
    Surface surface = placed(cast.meshes[cast.placements[o].mesh], cast.placements[o]);
    for (std::size_t i = 0; i < shapes[o].mesh.indices.size(); ++i) {
      Vec3 at = surface.position[surface.triangle[i / 3][i % 3]];
      const float* read =
          &attrib.vertices[3 * static_cast<std::size_t>(shapes[o].mesh.indices[i].vertex_index)];
      ASSERT_LT(glm::distance(at, Vec3(read[0], read[1], read[2])), 2e-6f);
    }
  }
  EXPECT_NEAR(materials[0].diffuse[0], cast.materials[0].color.red, 1e-4);
}

template <class T>
T take(std::string_view& bytes) {
  T value;
  EXPECT_GE(bytes.size(), sizeof(T));
  std::memcpy(&value, bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
  return value;
}

TEST(Ply, has_what_its_header_says) {
  Cast cast = cast_of(garden());
  std::string all = ply_bytes(cast);
  std::string_view bytes = all;
  std::size_t end = bytes.find("end_header\n");
  ASSERT_NE(end, bytes.npos);
  std::istringstream header(std::string(bytes.substr(0, end)));
  bytes.remove_prefix(end + 11);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(header, line);) {
    std::sscanf(line.c_str(), "element vertex %zu", &vertices);
    std::sscanf(line.c_str(), "element face %zu", &faces);
  }
  EXPECT_EQ(faces, all_triangles(cast));
  ASSERT_EQ(bytes.size(), vertices * (8 * 4 + 3) + faces * 13);
  Surface first = placed(cast.meshes[cast.placements[0].mesh], cast.placements[0]);
  for (std::size_t v = 0; v < vertices; ++v) {
    Vec3 at = take<Vec3>(bytes), normal = take<Vec3>(bytes);
    take<Vec2>(bytes);
    auto red = take<unsigned char>(bytes);
    bytes.remove_prefix(2);
    EXPECT_NEAR(glm::length(normal), 1, 1e-3);
    if (v < first.position.size()) {
      EXPECT_EQ(at, first.position[v]);
      EXPECT_NEAR(red, 255 * cast.materials[0].color.red, 0.6);
    }
  }
  for (std::size_t f = 0; f < faces; ++f) {
    ASSERT_EQ(take<unsigned char>(bytes), 3);
    for (int k = 0; k < 3; ++k) ASSERT_LT(take<std::uint32_t>(bytes), vertices);
  }
}

TEST(Glb, keeps_to_the_format) {
  Cast cast = cast_of(garden());
  std::string all = *glb_bytes(cast);
  std::string_view bytes = all;
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  bytes.remove_prefix(4);
  EXPECT_EQ(take<std::uint32_t>(bytes), 2u);
  EXPECT_EQ(take<std::uint32_t>(bytes), all.size());
  auto json_size = take<std::uint32_t>(bytes);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(bytes.substr(0, 4), "JSON");
  json root = json::parse(bytes.substr(4, json_size));
  bytes.remove_prefix(4 + json_size);
  auto bin_size = take<std::uint32_t>(bytes);
  EXPECT_EQ(bytes.substr(0, 4), std::string_view("BIN\0", 4));
  bytes.remove_prefix(4);
  ASSERT_EQ(bytes.size(), bin_size);
  EXPECT_EQ(root["buffers"][0]["byteLength"], bin_size);
  EXPECT_EQ(root["nodes"].size(), cast.placements.size());
  EXPECT_EQ(root["meshes"].size(), cast.meshes.size());

  std::map<std::string, std::size_t> width{{"SCALAR", 4}, {"VEC2", 8}, {"VEC3", 12}};
  std::size_t end = 0;
  for (const json& accessor : root["accessors"]) {
    const json& view = root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    auto offset = view["byteOffset"].get<std::size_t>(), size = view["byteLength"].get<std::size_t>();
    EXPECT_EQ(offset, end);  // one after the other
    EXPECT_EQ(offset % 4, 0u);
    end = offset + size;
    EXPECT_EQ(size, accessor["count"].get<std::size_t>() * width[accessor["type"]]);
  }
  EXPECT_EQ(end, bin_size);

  for (std::size_t m = 0; m < cast.meshes.size(); ++m) {
    const json& primitive = root["meshes"][m]["primitives"][0];
    const json& at = root["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    const json& index = root["accessors"][primitive["indices"].get<std::size_t>()];
    EXPECT_LT(primitive["material"].get<std::size_t>(), root["materials"].size());
    auto offset_of = [&](const json& accessor) {
      return root["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"].get<std::size_t>();
    };
    std::string_view places = bytes.substr(offset_of(at)), corners = bytes.substr(offset_of(index));
    Vec3 low(1e9f), high(-1e9f);
    for (std::size_t v = 0; v < at["count"].get<std::size_t>(); ++v) {
      Vec3 p = take<Vec3>(places);
      low = glm::min(low, p), high = glm::max(high, p);
    }
    for (int a = 0; a < 3; ++a) {
      auto axis = static_cast<std::size_t>(a);
      EXPECT_EQ(at["min"][axis].get<double>(), low[a]);
      EXPECT_EQ(at["max"][axis].get<double>(), high[a]);
    }
    for (std::size_t i = 0; i < index["count"].get<std::size_t>(); ++i)
      ASSERT_LT(take<std::uint32_t>(corners), at["count"].get<std::uint32_t>());
  }
}

/// A lawn with herbs and stones that are sown, and nothing else.
Scene sown_lawn() {
  Result<Preset> preset = read_preset(R"({"seed": 4, "scene": {"setting": "studio"}, "organisms": [
      {"kind": "plant", "name": "herb", "count": 30, "height": 0.2,
       "sown": {"models": 2, "where": {"radius": 0.05}},
       "grammar": {"axiom": "F[+L]F[-L]FL", "angle": 50, "length": 1, "width": 0.1},
       "organs": [{"symbol": "L", "shape": "flower", "size": 0.05, "colors": ["#ff0000", "#00ff00"]}]},
      {"kind": "rock", "name": "stone", "count": 5, "sown": {"models": 1, "where": {"radius": 0.1}}}]})",
                                      "lawn.json", {});
  EXPECT_TRUE(preset) << preset.errors()[0].text();
  return *build_scene(*preset);
}

TEST(Cast, holds_each_sown_model_once_and_each_copy_of_it) {
  Scene scene = sown_lawn();
  ASSERT_EQ(scene.stands.size(), 2u);
  ASSERT_GT(scene.stands[0].copies.size(), 20u);
  Cast cast = cast_of(scene, 0);
  std::map<std::size_t, std::size_t> copies;
  for (const CastPlacement& p : cast.placements) ++copies[p.mesh];
  EXPECT_EQ(copies.size(), cast.meshes.size());
  std::size_t herbs = 0, stones = 0;
  std::set<std::string> names;
  for (std::size_t m = 0; m < cast.meshes.size(); ++m) {
    const CastMesh& mesh = cast.meshes[m];
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
    EXPECT_EQ(mesh.surface.check(), "") << mesh.name;
    for (Vec2 at : mesh.surface.uv) EXPECT_TRUE(mesh.name.find("organ") == mesh.name.npos || at.x < 1);
    if (mesh.name.starts_with("herb") && mesh.name.find("wood") != mesh.name.npos) herbs += copies[m];
    if (mesh.name.starts_with("stone")) stones += copies[m];
  }
  EXPECT_EQ(herbs, scene.stands[0].copies.size());
  EXPECT_EQ(stones, scene.stands[1].copies.size());
  // The copies stand where they are sown.
  Surface first = placed(cast.meshes[0], cast.placements[0]);
  EXPECT_LT(glm::distance(first.position[0], scene.stands[0].copies.foot[0]), 0.3f);
  // A file is as large as its copies are many, but for instances.
  CastSize size = size_of(cast);
  EXPECT_GT(size.all_vertices, 5 * size.vertices);
}

TEST(Volume, holds_what_is_sown) {
  Result<Volume> volume = cast_volume(sown_lawn(), 0, {.voxel = 0.004});
  ASSERT_TRUE(volume) << volume.errors()[0].text();
  EXPECT_GT(volume->active_voxels(), 10'000u);
}

TEST(Formats, refuse_a_scene_of_which_nothing_would_be_written) {
  namespace fs = std::filesystem;
  Result<Preset> preset = read_preset(R"({"organisms": []})", "bare.json", {});
  ASSERT_TRUE(preset);
  Scene scene = *build_scene(*preset);
  for (const Format& format : formats()) {
    fs::path path = fs::temp_directory_path() /
                    ("frond_nothing_" + std::to_string(getpid()) + std::string(format.extension));
    Result<bool> written = write_scene(format, scene, 0, {}, path, [](double) {});
    ASSERT_FALSE(written) << format.extension;
    EXPECT_EQ(written.errors()[0].where, "");  // of what was asked for, not of the disk
    EXPECT_FALSE(fs::exists(path));
  }
}

TEST(Formats, refuse_more_than_they_hold_before_they_make_it) {
  Scene scene = sown_lawn();
  for (const Format& format : formats()) {
    if (!format.write) continue;
    Format small = format;
    small.most_bytes = 1e4;
    double told = 0;
    Result<bool> written = write_scene(small, scene, 0, {}, "/nowhere/at/all", [&](double b) { told = b; });
    ASSERT_FALSE(written);
    EXPECT_GT(told, 1e4);
    EXPECT_NE(written.errors()[0].what.find("GB at most"), std::string::npos) << written.errors()[0].what;
  }
}

/// No file of this process may become longer than that, as if the disk were full.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(Formats, leave_nothing_where_the_disk_is_full) {
  namespace fs = std::filesystem;
  fs::path folder = fs::temp_directory_path() / ("frond_full_disk_" + std::to_string(getpid()));
  Scene scene = garden();
  for (const Format& format : formats()) {
    fs::create_directories(folder);
    fs::path path = folder / ("garden" + std::string(format.extension));
    {
      SmallDisk disk(8192);  // the .mtl would find room
      Result<bool> written = write_scene(format, scene, 2, {}, path, [](double) {});
      ASSERT_FALSE(written) << format.extension;
      EXPECT_NE(written.errors()[0].where, "") << format.extension;
    }
    EXPECT_TRUE(fs::is_empty(folder)) << format.extension;
    fs::remove_all(folder);
  }
}

TEST(Formats, an_obj_does_not_stay_without_its_materials) {
  namespace fs = std::filesystem;
  fs::path folder = fs::temp_directory_path() / ("frond_no_mtl_" + std::to_string(getpid()));
  fs::create_directories(folder / "garden.mtl" / "in_the_way");
  Result<bool> written =
      write_scene(**format_of("garden.obj"), garden(), 2, {}, folder / "garden.obj", [](double) {});
  EXPECT_FALSE(written);
  EXPECT_FALSE(fs::exists(folder / "garden.obj"));
  fs::remove_all(folder);
}

TEST(Formats, write_whole_files) {
  namespace fs = std::filesystem;
  fs::path folder = fs::temp_directory_path() / ("frond_export_test_" + std::to_string(getpid()));
  Scene scene = garden();
  for (const Format& format : formats()) {
    fs::path path = folder / ("garden" + std::string(format.extension));
    double told = 0;
    Result<bool> written = write_scene(format, scene, 2, {}, path, [&](double bytes) { told = bytes; });
    ASSERT_TRUE(written) << written.errors()[0].text();
    double foreseen = format.bytes(foresee_cast(scene, {})), size = static_cast<double>(fs::file_size(path));
    EXPECT_GT(size, 10'000);
    if (foreseen > 0) {
      EXPECT_NEAR(foreseen / size, 1, 0.7) << format.extension;
      EXPECT_NEAR(told / size, 1, 0.7) << format.extension;
    }
  }
  EXPECT_TRUE(fs::exists(folder / "garden.mtl"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}), 5);
  Result<Volume> volume = read_vdb(folder / "garden.vdb");
  ASSERT_TRUE(volume);
  EXPECT_GT(volume->active_voxels(), 1000u);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace frond
