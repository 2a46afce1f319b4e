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
#include "core/linear.h"
#include "export/formats.h"
#include "export/materials.h"

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

const ExportOptions kSmallPictures{.texture = 64, .bake = {.home = FROND_ROOT}};

ExportScene export_scene_of(const Scene& scene, double time = 2) {
  Result<ExportScene> exported = export_scene(scene, time, kSmallPictures);
  EXPECT_TRUE(exported);
  return *exported;
}

template <class Visit>
void each_part(const ExportScene& exported, const Visit& visit) {
  for (const ExportPlacement& p : exported.placements)
    for (const ExportPart& part : exported.meshes[p.mesh].parts) visit(part, p);
}

std::size_t all_triangles(const ExportScene& exported) {
  std::size_t sum = 0;
  each_part(exported,
            [&](const ExportPart& part, const ExportPlacement&) { sum += part.surface.triangle.size(); });
  return sum;
}

TEST(ExportScene, holds_sound_meshes_a_few_for_each_organism) {
  for (bool instances : {false, true}) {
    Result<ExportScene> made = export_scene(garden(), 2, {.texture = 0, .instances = instances});
    ASSERT_TRUE(made);
    const ExportScene& exported = *made;
    std::set<std::string> names;
    for (const ExportMaterial& m : exported.materials) EXPECT_TRUE(names.insert(m.name).second) << m.name;
    names.clear();
    for (const ExportMesh& mesh : exported.meshes) {
      EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
      for (const ExportPart& part : mesh.parts) {
        EXPECT_EQ(part.surface.find_fault(), "") << mesh.name;
        EXPECT_LT(part.material, exported.materials.size());
      }
    }
    std::map<std::size_t, int> placed;
    for (const ExportPlacement& p : exported.placements) ++placed[p.mesh];
    int thrice = 0;
    for (auto [mesh, times] : placed) thrice += times == 3;
    EXPECT_EQ(thrice, instances ? 1 : 0);  // the flowers
    EXPECT_EQ(exported.groups.size(), 2u);
    EXPECT_EQ(exported.placements.size(), instances ? 5u : 3u);  // two have branches, one has flowers
  }
}

TEST(ExportScene, has_no_more_triangles_than_it_may) {
  Scene scene = garden();
  std::size_t all = all_triangles(export_scene_of(scene));
  Result<ExportScene> less = export_scene(scene, 2, {.detail = 400, .texture = 0});
  ASSERT_TRUE(less);
  EXPECT_LT(all_triangles(*less), all / 2);
  for (const ExportMesh& mesh : less->meshes)
    for (const ExportPart& part : mesh.parts) EXPECT_EQ(part.surface.find_fault(), "") << mesh.name;
}

TEST(ExportScene, paints_what_patterns_draw) {
  ExportScene exported = export_scene_of(garden());
  ASSERT_NE(exported.materials[0].colors, kNoPicture);  // the pores of the coral
  Result<Raster> picture = read_png(exported.pictures[exported.materials[0].colors].png);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, 64);
  auto [low, high] = std::minmax_element(picture->data.begin(), picture->data.end());
  EXPECT_GT(*high - *low, 60);
  Result<ExportScene> bare = export_scene(garden(), 2, {.texture = 0});
  ASSERT_TRUE(bare);
  EXPECT_TRUE(bare->pictures.empty());
}

TEST(ExportScene, grows_with_time_and_is_near_what_was_foreseen) {
  Scene scene = garden();
  ExportSize estimated = estimate_export(scene, kSmallPictures);
  auto grown = static_cast<double>(all_triangles(export_scene_of(scene)));
  EXPECT_GT(estimated.all_triangles, 0.7 * grown);
  EXPECT_LT(estimated.all_triangles, 1.5 * grown);
  EXPECT_LT(all_triangles(export_scene_of(scene, 0.2)), all_triangles(export_scene_of(scene)));
}

TEST(ExportScene, follows_the_style) {
  for (const char* style : {R"("fused")", R"("rough")", R"({"build": "voxels", "voxel": 0.03})"}) {
    Scene scene = garden(style);
    ExportScene exported = export_scene_of(scene);
    const Surface& coral = exported.meshes[0].parts[0].surface;
    EXPECT_EQ(coral.find_fault(), "");
    EXPECT_GT(coral.triangle.size(), 300u);
    EXPECT_NE(coral.triangle.size(), export_scene_of(garden()).meshes[0].parts[0].surface.triangle.size());
  }
}

TEST(Formats, are_told_by_the_extension) {
  EXPECT_EQ((*format_of("a/b.glb"))->extension, ".glb");
  Result<const Format*> none = format_of("a/b.stl");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.errors()[0].what,
            "\".stl\" is no format that is known; expected one of .obj, .ply, .glb, .vdb, .inc");
}

TEST(Obj, is_read_back_by_tinyobjloader) {
  ExportScene exported = export_scene_of(garden());
  tinyobj::attrib_t attrib;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warn, error;
  std::istringstream text(obj_text(exported, "garden.mtl")), colors(mtl_text(exported));
  tinyobj::MaterialStreamReader reader(colors);
  ASSERT_TRUE(tinyobj::LoadObj(&attrib, &shapes, &materials, &warn, &error, &text, &reader, false)) << error;
  EXPECT_EQ(warn, "");
  EXPECT_EQ(shapes.size(), exported.placements.size());
  EXPECT_EQ(materials.size(), exported.materials.size());
  std::size_t faces = 0;
  for (const auto& shape : shapes) faces += shape.mesh.num_face_vertices.size();
  EXPECT_EQ(faces, all_triangles(exported));
  std::size_t o = 0, i = 0;
  auto as_read = [](const std::vector<tinyobj::real_t>& list, int at) {
    const float* read = &list[3 * static_cast<std::size_t>(at)];
    return Vec3(read[0], read[1], read[2]);
  };
  each_part(exported, [&](const ExportPart& part, const ExportPlacement& p) {
    Surface surface = placed(part, p);
    for (const auto& t : surface.triangle)
      for (std::uint32_t corner : t) {
        if (i == shapes[o].mesh.indices.size()) ++o, i = 0;
        tinyobj::index_t at = shapes[o].mesh.indices[i++];
        ASSERT_LT(glm::distance(surface.position[corner], as_read(attrib.vertices, at.vertex_index)), 2e-6f);
        ASSERT_LT(glm::distance(surface.normal[corner], as_read(attrib.normals, at.normal_index)), 2e-3f);
      }
  });
  EXPECT_NEAR(materials[0].diffuse[0], exported.materials[0].factor.red, 1e-4);
  EXPECT_EQ(materials[0].diffuse_texname, exported.pictures[exported.materials[0].colors].name + ".png");
}

template <class T>
T read(std::string_view& bytes) {
  T value;
  EXPECT_GE(bytes.size(), sizeof(T));
  std::memcpy(&value, bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
  return value;
}

TEST(Ply, has_what_its_header_says) {
  ExportScene exported = export_scene_of(garden());
  std::string all = ply_bytes(exported);
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
  EXPECT_EQ(faces, all_triangles(exported));
  ASSERT_EQ(bytes.size(), vertices * (8 * 4 + 3) + faces * 13);
  Surface first = placed(exported.meshes[exported.placements[0].mesh].parts[0], exported.placements[0]);
  for (std::size_t v = 0; v < vertices; ++v) {
    Vec3 at = read<Vec3>(bytes), normal = read<Vec3>(bytes);
    read<Vec2>(bytes);
    auto red = read<unsigned char>(bytes);
    bytes.remove_prefix(2);
    EXPECT_NEAR(glm::length(normal), 1, 1e-3);
    if (v < first.position.size()) {
      EXPECT_EQ(at, first.position[v]);
      double light = linear(exported.materials[0].color.red) * exported.meshes[0].parts[0].tint[v][0] / 255;
      EXPECT_NEAR(red, 255 * encoded(light), 0.6);
    }
  }
  for (std::size_t f = 0; f < faces; ++f) {
    ASSERT_EQ(read<unsigned char>(bytes), 3);
    for (int k = 0; k < 3; ++k) ASSERT_LT(read<std::uint32_t>(bytes), vertices);
  }
}

TEST(Glb, keeps_to_the_format) {
  ExportScene exported = export_scene_of(garden());
  std::string all = *glb_bytes(exported);
  std::string_view bytes = all;
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  bytes.remove_prefix(4);
  EXPECT_EQ(read<std::uint32_t>(bytes), 2u);
  EXPECT_EQ(read<std::uint32_t>(bytes), all.size());
  auto json_size = read<std::uint32_t>(bytes);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(bytes.substr(0, 4), "JSON");
  json root = json::parse(bytes.substr(4, json_size));
  bytes.remove_prefix(4 + json_size);
  auto bin_size = read<std::uint32_t>(bytes);
  EXPECT_EQ(bytes.substr(0, 4), std::string_view("BIN\0", 4));
  bytes.remove_prefix(4);
  ASSERT_EQ(bytes.size(), bin_size);
  EXPECT_EQ(root["buffers"][0]["byteLength"], bin_size);
  EXPECT_EQ(root["nodes"].size(),
            exported.placements.size() + 1);  // the herb has two meshes below its own node
  EXPECT_EQ(root["scenes"][0]["nodes"].size(), exported.groups.size());
  EXPECT_EQ(root["meshes"].size(), exported.meshes.size());

  std::map<std::string, std::size_t> width{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  std::map<int, std::size_t> bytes_of{{5121, 1}, {5123, 2}, {5125, 4}, {5126, 4}};
  std::size_t end = 0;
  for (const json& view : root["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"], end);  // one after the other, aligned
    end += (view["byteLength"].get<std::size_t>() + 3) / 4 * 4;
  }
  EXPECT_EQ(end, bin_size);
  for (const json& accessor : root["accessors"]) {
    const json& view = root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    EXPECT_EQ(view["byteLength"], accessor["count"].get<std::size_t>() * width[accessor["type"]] *
                                      bytes_of[accessor["componentType"].get<int>()]);
  }
  for (const json& image : root["images"]) {
    const json& view = root["bufferViews"][image["bufferView"].get<std::size_t>()];
    EXPECT_TRUE(
        read_png(bytes.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>())));
  }

  for (std::size_t m = 0; m < exported.meshes.size(); ++m) {
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
      Vec3 p = read<Vec3>(places);
      low = glm::min(low, p), high = glm::max(high, p);
    }
    for (int a = 0; a < 3; ++a) {
      auto axis = static_cast<std::size_t>(a);
      EXPECT_EQ(at["min"][axis].get<double>(), low[a]);
      EXPECT_EQ(at["max"][axis].get<double>(), high[a]);
    }
    ASSERT_EQ(index["componentType"], 5123);
    for (std::size_t i = 0; i < index["count"].get<std::size_t>(); ++i)
      ASSERT_LT(read<std::uint16_t>(corners), at["count"].get<std::uint32_t>());
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

TEST(ExportScene, holds_each_sown_model_once_and_each_copy_of_it) {
  Scene scene = sown_lawn();
  ASSERT_EQ(scene.copy_sets.size(), 2u);
  ASSERT_GT(scene.copy_sets[0].copies.size(), 20u);
  ExportScene exported = export_scene_of(scene, 0);
  std::map<std::size_t, std::size_t> copies;
  for (const ExportPlacement& p : exported.placements) ++copies[p.mesh];
  EXPECT_EQ(copies.size(), exported.meshes.size());
  std::size_t herbs = 0, stones = 0;
  std::set<std::string> names;
  for (std::size_t m = 0; m < exported.meshes.size(); ++m) {
    const ExportMesh& mesh = exported.meshes[m];
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
    for (const ExportPart& part : mesh.parts) EXPECT_EQ(part.surface.find_fault(), "") << mesh.name;
    if (mesh.name.starts_with("herb")) herbs += copies[m];
    if (mesh.name.starts_with("stone")) stones += copies[m];
  }
  EXPECT_EQ(herbs, scene.copy_sets[0].copies.size());
  EXPECT_EQ(stones, scene.copy_sets[1].copies.size());
  // The copies stand where they are sown.
  Surface first = placed(exported.meshes[0].parts[0], exported.placements[0]);
  EXPECT_LT(glm::distance(first.position[0], scene.copy_sets[0].copies.foot[0]), 0.3f);
  EXPECT_EQ(exported.groups.size(), 2u);
  // With instances all copies of a model are one node, else each is one.
  for (bool instances : {false, true}) {
    std::string glb = *glb_bytes(exported, instances);
    json root = json::parse(glb.substr(20, *reinterpret_cast<const std::uint32_t*>(&glb[12])));
    EXPECT_EQ(root["nodes"].size(), 2 + (instances ? exported.meshes.size() : exported.placements.size()));
    EXPECT_EQ(root.contains("extensionsRequired"), instances);
  }
  // A file is as large as its copies are many, but for instances.
  ExportSize size = size_of(exported);
  EXPECT_GT(size.all_vertices, 5 * size.vertices);
}

TEST(Volume, holds_what_is_sown) {
  Result<Volume> volume = export_volume(sown_lawn(), 0, {.voxel = 0.004});
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
    auto written = write_scene(format, scene, 0, kSmallPictures, path, [](const ExportTold&) {});
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
    auto written = write_scene(small, scene, 0, kSmallPictures, "/nowhere/at/all",
                               [&](const ExportTold& t) { told = t.bytes; });
    ASSERT_FALSE(written);
    EXPECT_GT(told, 1e4);
    EXPECT_NE(written.errors()[0].what.find("; such a file holds 10 kB at most"), std::string::npos)
        << written.errors()[0].what;
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
      auto written = write_scene(format, scene, 2, {.texture = 0}, path, [](const ExportTold&) {});
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
  auto written = write_scene(**format_of("garden.obj"), garden(), 2, kSmallPictures, folder / "garden.obj",
                             [](const ExportTold&) {});
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
    auto written =
        write_scene(format, scene, 2, kSmallPictures, path, [&](const ExportTold& t) { told = t.bytes; });
    ASSERT_TRUE(written) << written.errors()[0].text();
    double estimated = format.bytes(estimate_export(scene, kSmallPictures)),
           size = static_cast<double>(fs::file_size(path));
    EXPECT_GT(size, 10'000);
    if (estimated > 0) {
      EXPECT_NEAR(estimated / size, 1, 0.7) << format.extension;
      EXPECT_NEAR(told / size, 1, 0.7) << format.extension;
    }
  }
  EXPECT_TRUE(fs::exists(folder / "garden.mtl"));
  EXPECT_GT(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}), 5);  // pictures, too
  Result<Volume> volume = read_vdb(folder / "garden.vdb");
  ASSERT_TRUE(volume);
  EXPECT_GT(volume->active_voxels(), 1000u);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace frond
