// All pairs of options of an export, and frames in which there is little.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "core/files.h"
#include "export/formats.h"
#include "exported.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// One of each sort of what is exported.
std::map<std::string, Scene> kinds() {
  return {{"tree", scene_of_file("presets/trees/birch.json", {"/organisms/0/years=5", "/film/frames=4"})},
          {"herb", scene_of_text(R"({"film": {"frames": 24, "fps": 12}, "organisms": [
          {"kind": "plant", "name": "herb", "height": 0.4, "place": {"at": [[1, 0]]}, "growth": {"duration": 2},
           "grammar": {"axiom": "F[+L]F[-L]F[+{.F+F+F}]FL", "angle": 50, "length": 1, "width": 0.1},
           "organs": [{"symbol": "L", "shape": "flower", "size": 0.05}]}]})")},
          {"fused", scene_of_text(R"({"film": {"frames": 24, "fps": 12}, "organisms": [
          {"kind": "coral", "name": "fused", "steps": 2, "height": 0.5, "growth": {"duration": 2},
           "body": "fused", "place": {"at": [[2, 0]]}}]})")},
          {"sown", scene_of_text(R"({"seed": 4, "scene": {"setting": "studio"}, "organisms": [
          {"kind": "plant", "name": "herb", "count": 8, "height": 0.2,
           "sown": {"models": 2, "where": {"radius": 0.05}},
           "grammar": {"axiom": "F[+L]F[-L]FL", "angle": 50, "length": 1, "width": 0.1},
           "organs": [{"symbol": "L", "shape": "flower", "size": 0.05}]},
          {"kind": "rock", "name": "stone", "count": 3, "sown": {"models": 1, "where": {"radius": 0.1}}}]})")}};
}

using Change = std::function<void(ExportOptions&)>;

const std::vector<std::pair<std::string, Change>> kChanges = {
    {"no pictures", [](ExportOptions& o) { o.texture = 0; }},
    {"coarse", [](ExportOptions& o) { o.detail = 400; }},
    {"fine", [](ExportOptions& o) { o.detail = 1e9; }},
    {"by pixels", [](ExportOptions& o) { o.detail = detail_seen(60), o.pixels = 60; }},
    {"instances", [](ExportOptions& o) { o.instances = true; }},
    {"levels", [](ExportOptions& o) { o.levels = 4; }},
    {"film",
     [](ExportOptions& o) {
       o.keys = {0.1, 0.3};
     }},
    {"few sides", [](ExportOptions& o) { o.sides = 3; }},
    {"coarse volume", [](ExportOptions& o) { o.voxel = 0.02; }},
    {"no tints", [](ExportOptions& o) { o.tints = false; }}};

TEST(Pairs, of_export_options_write_each_format_of_each_kind_or_say_why_not) {
  fs::path folder = fs::temp_directory_path() / ("frond_pairs_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::size_t written = 0;
  for (auto& [kind, scene] : kinds())
    for (const Format& format : formats())
      for (std::size_t a = 0; a < kChanges.size(); ++a)
        for (std::size_t b = a; b < kChanges.size(); ++b) {
          ExportOptions options{.texture = 16};
          options.bake = {.home = FROND_ROOT, .cache = folder / "materials"};
          kChanges[a].second(options), kChanges[b].second(options);
          std::string what =
              kind + std::string(format.extension) + ": " + kChanges[a].first + ", " + kChanges[b].first;
          fs::path path = folder / ("pair" + std::string(format.extension));
          double time = options.keys.empty() ? 0.3 : options.keys.back();
          auto done = write_scene(format, scene, time, options, path, [](const ExportTold& told) {
            for (double triangles : told.triangles) EXPECT_GT(triangles, 0);
          });
          if (!done) {
            EXPECT_FALSE(options.keys.empty() && format.write) << what << ": " << done.errors()[0].text();
            EXPECT_FALSE(done.errors()[0].what.empty()) << what;
          } else {
            EXPECT_GT(fs::file_size(path), 100u) << what;
            ++written;
          }
          fs::remove(path);
        }
  EXPECT_GT(written, 600u);
  fs::remove_all(folder);
}

TEST(Pairs, an_obj_of_leaves_without_pictures_has_its_materials) {
  Scene scene = scene_of_file("presets/trees/birch.json", {"/organisms/0/years=8"});
  Result<ExportScene> exported = export_scene(scene, 0, {.detail = 2000, .texture = 0});
  ASSERT_TRUE(exported);
  std::string text = mtl_text(*exported);
  EXPECT_NE(text.find("newmtl birch_sprig\nKd "), std::string::npos) << text;
  EXPECT_EQ(text.find("map_"), std::string::npos);
}

/// Edges that an OBJ has otherwise than once in each direction, and faces that name a vertex twice, where
/// places are told apart by so many decimals.
std::pair<std::size_t, std::size_t> faults_of(const ExportScene& exported, double unit) {
  std::map<std::array<long long, 3>, std::size_t> place;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  std::size_t twice = 0, wrong = 0;
  for (const ExportMesh& mesh : exported.meshes)
    for (const ExportPart& part : mesh.parts) {
      std::vector<std::size_t> number;
      for (const Vec3& p : part.surface.position) {
        std::array<long long, 3> at{};
        for (int axis = 0; axis < 3; ++axis)
          at[static_cast<std::size_t>(axis)] = std::llround(static_cast<double>(p[axis]) * unit);
        number.push_back(place.try_emplace(at, place.size()).first->second);
      }
      for (const auto& t : part.surface.triangle) {
        std::set<std::size_t> own;
        for (std::size_t k = 0; k < 3; ++k)
          own.insert(number[t[k]]), ++edges[{number[t[k]], number[t[(k + 1) % 3]]}];
        twice += own.size() < 3;
      }
    }
  for (const auto& [edge, times] : edges) {
    auto back = edges.find({edge.second, edge.first});
    wrong += times != 1 || back == edges.end() || back->second != 1;
  }
  return {wrong, twice};
}

TEST(FusedBody, has_no_doubled_edge_and_no_face_that_names_a_vertex_twice) {
  for (const char* voxel : {"0.02", "0.013", "0.008", "0.005", "0.004"}) {
    Scene scene = scene_of_file("tests/cases/10-fused-volume/y.json",
                                {std::string("/organisms/0/body/voxel=") + voxel});
    Result<ExportScene> exported = export_scene(scene, 0, {.texture = 0});
    ASSERT_TRUE(exported);
    for (double unit : {1e5, 1e6}) {
      auto [wrong, twice] = faults_of(*exported, unit);
      EXPECT_EQ(wrong, 0u) << voxel << " to " << unit;
      EXPECT_EQ(twice, 0u) << voxel << " to " << unit;
    }
    double volume = 0;
    for (const ExportPart& part : exported->meshes[0].parts)
      for (auto [a, b, c] : part.surface.triangle) {
        const std::vector<Vec3>& p = part.surface.position;
        volume += static_cast<double>(glm::dot(p[a], glm::cross(p[b], p[c]))) / 6;
      }
    EXPECT_NEAR(volume, 0.0976, 0.03 * 0.0976) << voxel;
  }
}

TEST(FrameOfNothing, is_an_empty_file_and_no_mistake) {
  Scene scene = scene_of_file("tests/cases/26-obj-series/shoot.json");
  fs::path folder = fs::temp_directory_path() / ("frond_series_" + std::to_string(getpid()));
  fs::create_directories(folder);
  for (const Format& format : formats())
    for (int frame : {1, 12}) {
      fs::path path = folder / ("f" + std::string(format.extension));
      auto written =
          write_scene(format, scene, scene.film.time(frame), {.texture = 0}, path, [](const ExportTold&) {});
      if (!format.write && frame == 1) {
        ASSERT_FALSE(written);
        EXPECT_TRUE(written.errors()[0].what.starts_with(kNothingYet)) << written.errors()[0].what;
        continue;
      }
      ASSERT_TRUE(written) << format.extension << written.errors()[0].text();
      EXPECT_EQ(written->size(), frame == 1 ? 1u : 0u) << format.extension;
      if (format.extension == ".obj") {
        std::string text = *read_file(path);
        EXPECT_EQ(text.find("\nv ") == text.npos, frame == 1);
      }
      if (format.extension == ".glb" && frame == 1) {
        std::string glb = *read_file(path);
        EXPECT_EQ(glb.size() % 4, 0u);
        EXPECT_NE(glb.find(R"("scenes":[{}])"), glb.npos);
      }
    }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace frond
