#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "export/formats.h"
#include "exported.h"

// Exports that move, and their levels of detail.

namespace frond {
namespace {

using nlohmann::json;

Scene scene_of(const std::string& text) {
  Result<Preset> preset = read_preset(text, "film.json", {});
  EXPECT_TRUE(preset) << preset.errors()[0].text();
  return *build_scene(*preset);
}

/// A coral of tubes, a fused one and a herb with leaves and blades, all of which grow and sway for two
/// seconds.
Scene growing() {
  return scene_of(R"({"seed": 3, "film": {"frames": 24, "fps": 12}, "organisms": [
      {"kind": "coral", "name": "coral", "steps": 2, "height": 0.5, "growth": {"duration": 2},
       "skin": {"tint": {"base": "#803020", "young": 1, "young_length": 0.1}}, "place": {"at": [[0, 0]]}},
      {"kind": "coral", "name": "fused", "steps": 2, "height": 0.5, "growth": {"duration": 2}, "body": "fused",
       "place": {"at": [[2, 0]]}},
      {"kind": "plant", "name": "herb", "height": 0.4, "place": {"at": [[1, 0]]}, "growth": {"duration": 2},
       "wave": {"amplitude": 0.3},
       "grammar": {"axiom": "F[+L]F[-L]F[+{.F+F+F}]FL", "angle": 50, "length": 1, "width": 0.1},
       "organs": [{"symbol": "L", "shape": "flower", "size": 0.05}]}]})");
}

Vec3 highest(const std::vector<Vec3>& places) {
  return *std::ranges::max_element(places, {}, [](Vec3 p) { return p.y; });
}

std::size_t triangles_of_all(const std::vector<ExportPart>& parts) {
  std::size_t all = 0;
  for (const ExportPart& part : parts) all += part.surface.triangle.size();
  return all;
}

json json_of(const std::string& glb) {
  return json::parse(glb.substr(20, *reinterpret_cast<const std::uint32_t*>(&glb[12])));
}

TEST(Film, carries_each_mesh_to_where_it_is_at_other_times) {
  Scene scene = growing();
  ExportOptions options{.texture = 0, .keys = {0.6, 1.2, 1.9}};
  Result<ExportScene> exported = export_scene(scene, 1.9, options);
  ASSERT_TRUE(exported) << exported.errors()[0].text();
  EXPECT_EQ(exported->keys.size(), 3u);
  EXPECT_DOUBLE_EQ(exported->keys[0], 0);
  for (std::size_t key = 0; key < 2; ++key) {
    Result<ExportScene> then = export_scene(scene, options.keys[key], {.texture = 0});
    ASSERT_TRUE(then);
    for (const ExportMesh& mesh : exported->meshes) {
      ASSERT_TRUE(mesh.moves()) << mesh.name;
      auto same = std::ranges::find(then->meshes, mesh.name, &ExportMesh::name);
      if (same == then->meshes.end()) continue;  // nothing of it has grown yet
      for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
        const ExportPart& part = mesh.parts[p];
        ASSERT_EQ(part.shifts.size(), 2u);
        std::vector<Vec3> moved = part.surface.position;
        for (std::size_t v = 0; v < moved.size(); ++v) {
          moved[v] += part.shifts[key].position[v];
          ASSERT_TRUE(std::isfinite(moved[v].x + moved[v].y + moved[v].z)) << mesh.name;
          ASSERT_LT(glm::length(part.surface.normal[v] + part.shifts[key].normal[v]), 1.01f);
        }
        // Flowers that are not there yet lie folded at growing tips.
        if (mesh.name == "herb_L" && same->parts[p].surface.position.size() < moved.size()) continue;
        Vec3 top = highest(moved), wanted = highest(same->parts[p].surface.position);
        EXPECT_LT(glm::distance(top, wanted), 0.03f) << mesh.name << " at " << options.keys[key];
      }
    }
  }
}

/// Mean of the vertices of the leaves of ivy that flutters in a wind.
Vec3 middle_of_leaves(double time, bool instances, std::vector<double> keys = {}) {
  static const Scene scene = scene_of(R"({"seed": 4, "film": {"frames": 48, "fps": 12}, "organisms": [
      {"kind": "wall", "name": "wall", "place": {"at": [[0, 0]]}},
      {"kind": "ivy", "on": ["wall"], "count": 1, "flutter": {"amplitude": 30}, "breeze": {"amplitude": 20},
       "crawl": {"max_age": 60, "speed": 0.014}, "place": {"at": [[0, 0.4]]}}]})");
  Result<ExportScene> made = export_scene(
      scene, time, {.detail = 1e9, .texture = 0, .instances = instances, .keys = std::move(keys)});
  EXPECT_TRUE(made) << made.errors()[0].text();
  DVec3 sum(0);
  double count = 0;
  for (const ExportPlacement& p : made->placements)
    for (const ExportPart& part : made->meshes[p.mesh].parts) {
      if (made->meshes[p.mesh].name.find("leaf") == std::string::npos) continue;
      Surface surface = placed(part, p);
      for (std::size_t v = 0; v < surface.position.size(); ++v) {
        sum += DVec3(surface.position[v]);
        if (!part.shifts.empty()) sum += DVec3(part.shifts[0].position[v]);
        ++count;
      }
    }
  EXPECT_GT(count, 100);
  return Vec3(sum / count);
}

TEST(Film, leaves_flutter_merged_as_placed) {
  for (double time : {1.0, 1.5}) {
    Vec3 merged = middle_of_leaves(time, false);
    EXPECT_LT(glm::distance(merged, middle_of_leaves(time, true)), 1e-5f);
    EXPECT_LT(glm::distance(merged, middle_of_leaves(2, false, {time, 2})), 1e-5f);
    EXPECT_GT(glm::distance(merged, middle_of_leaves(2, false)), 1e-4f);
  }
}

TEST(Film, of_a_glb_is_an_animation_of_weights) {
  Result<ExportScene> exported = export_scene(growing(), 1.9, {.texture = 0, .keys = {0.6, 1.2, 1.9}});
  ASSERT_TRUE(exported);
  json root = json_of(*glb_bytes(*exported));
  EXPECT_EQ(root["animations"][0]["channels"].size(), exported->meshes.size());
  const json& sampler = root["animations"][0]["samplers"][0];
  const json& times = root["accessors"][sampler["input"].get<std::size_t>()];
  EXPECT_EQ(times["count"], 3);
  EXPECT_NEAR(times["max"][0].get<double>(), 1.3, 1e-6);
  EXPECT_EQ(root["accessors"][sampler["output"].get<std::size_t>()]["count"], 6);
  for (const json& mesh : root["meshes"]) {
    EXPECT_EQ(mesh["weights"].size(), 2u);
    for (const json& primitive : mesh["primitives"]) EXPECT_EQ(primitive["targets"].size(), 2u);
  }
}

TEST(Film, a_tree_in_the_wind_keeps_its_foot_and_closes_its_loop) {
  Scene scene = scene_of_file("presets/trees/birch.json",
                              {"/organisms/0/years=6", "/film/frames=24", "/film/fps=8",
                               R"(/scene/wind={"speed": 7, "gusts": 0.3, "direction": [1, 0, 0.3]})"});
  ExportOptions options{.detail = 3e4, .texture = 0};
  constexpr int kKeys = 12;
  for (int i = 0; i < kKeys; ++i) options.keys.push_back(scene.film.time(1 + 23 * i / (kKeys - 1)));
  Result<ExportScene> exported = export_scene(scene, options.keys.back(), options);
  ASSERT_TRUE(exported) << exported.errors()[0].text();
  float top = 0, foot = 0, stem = 0, leaf = 0;
  for (const ExportMesh& mesh : exported->meshes)
    for (const ExportPart& part : mesh.parts)
      for (const Vec3& p : part.surface.position) top = std::max(top, p.y);
  std::vector<double> step(kKeys, 0);  // mean way to the next key; the last leads to the first
  double count = 0;
  for (const ExportMesh& mesh : exported->meshes) {
    bool wood = mesh.name.find("branches") != std::string::npos;
    for (const ExportPart& part : mesh.parts) {
      ASSERT_EQ(part.shifts.size(), kKeys - 1u) << mesh.name;
      for (std::size_t v = 0; v < part.surface.position.size(); ++v) {
        auto at = [&](int key) { return key + 1 == kKeys ? Vec3(0) : part.shifts[key].position[v]; };
        float height = part.surface.position[v].y, way = 0;
        for (int key = 0; key < kKeys; ++key) {
          step[key] += static_cast<double>(glm::distance(at(key), at((key + 1) % kKeys)));
          way = std::max(way, glm::distance(at(key), at(0)));
        }
        ++count;
        if (wood && height < 0.05f) foot = std::max(foot, way);
        if (wood && height > 0.05f && height < 0.3f * top) stem = std::max(stem, way);
        if (!wood) leaf = std::max(leaf, way);
      }
    }
  }
  for (double& s : step) s /= count;
  printf("foot %.4f m, stem %.4f m, leaves %.4f m; steps of %.4f m, back to the first %.4f m\n",
         static_cast<double>(foot), static_cast<double>(stem), static_cast<double>(leaf), step[0],
         step.back());
  EXPECT_LT(foot, 0.002f);
  EXPECT_GT(leaf, 2 * stem);
  EXPECT_GT(leaf, 0.01f);
  EXPECT_LT(step.back(), 2 * *std::max_element(step.begin(), step.end() - 1));
}

TEST(Film, carries_bodies_that_grow_and_fish_that_swim) {
  Scene scene = scene_of(R"({"seed": 3, "film": {"frames": 48, "fps": 12}, "organisms": [
      {"kind": "massive", "name": "brain", "across": 0.3, "height": 0.2, "edge": 0.01, "relief": "plain",
       "growth": {"duration": 3}, "place": {"at": [[0, 0]]}},
      {"kind": "school", "name": "fish", "count": 5, "place": {"at": [[2, 0]], "raise": 1}}]})");
  // At a detail that leaves a part of the triangles.
  ExportOptions options{.detail = 600, .texture = 0, .keys = {0.4, 1.7, 3.5}};
  Result<ExportScene> exported = export_scene(scene, 3.5, options);
  ASSERT_TRUE(exported) << exported.errors()[0].text();
  ASSERT_EQ(exported->meshes.size(), 2u);
  for (std::size_t key = 0; key < 2; ++key) {
    Result<ExportScene> then = export_scene(scene, options.keys[key], {.texture = 0});
    ASSERT_TRUE(then);
    for (std::size_t m = 0; m < 2; ++m) {
      ASSERT_TRUE(exported->meshes[m].moves());
      EXPECT_LT(triangles_of_all(exported->meshes[m].parts), triangles_of_all(then->meshes[m].parts));
      const ExportPart &part = exported->meshes[m].parts[0], &same = then->meshes[m].parts[0];
      std::vector<Vec3> moved = part.surface.position;
      for (std::size_t v = 0; v < moved.size(); ++v) moved[v] += part.shifts[key].position[v];
      Vec3 top = highest(moved), wanted = highest(same.surface.position);
      EXPECT_LT(glm::distance(top + exported->groups[m].foot, wanted + then->groups[m].foot), 0.02f) << m;
      if (m > 0 || key > 0) continue;
      EXPECT_LT(top.y, 0.9f * highest(part.surface.position).y) << "it grows";
    }
  }
}

TEST(Film, is_refused_where_no_mesh_can_follow_or_nothing_moves) {
  Scene still = scene_of(R"({"organisms": [{"kind": "rock", "place": {"at": [[0, 0]]}}]})");
  Result<ExportScene> none = export_scene(still, 1, {.texture = 0, .keys = {0, 1}});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.errors()[0].what, "nothing moves from the first of those frames to the last");
  Scene changing = growing();
  changing.specimens[2].life.develop = [](double) { return Model{}; };
  Result<ExportScene> exported = export_scene(changing, 1, {.texture = 0, .keys = {0, 1}});
  ASSERT_FALSE(exported);
  EXPECT_NE(exported.errors()[0].what.find("herb changes its shape"), std::string::npos)
      << exported.errors()[0].what;
}

TEST(Levels, have_a_quarter_of_the_triangles_each) {
  Result<ExportScene> exported = export_scene(growing(), 1.9 + 2, {.texture = 0, .levels = 3});
  ASSERT_TRUE(exported);
  double all[3] = {0, 0, 0};
  for (const ExportMesh& mesh : exported->meshes) {
    ASSERT_EQ(mesh.coarser.size(), 2u) << mesh.name;
    auto count = [&](double& sum, const std::vector<ExportPart>& parts) {
      for (const ExportPart& part : parts) {
        EXPECT_EQ(part.surface.find_fault(), "") << mesh.name;
        EXPECT_TRUE(part.tint.empty() || part.tint.size() == part.surface.position.size());
        sum += static_cast<double>(part.surface.triangle.size());
      }
    };
    count(all[0], mesh.parts), count(all[1], mesh.coarser[0]), count(all[2], mesh.coarser[1]);
  }
  EXPECT_GT(all[1], 0.15 * all[0]);
  EXPECT_LT(all[1], 0.3 * all[0]);
  EXPECT_LT(all[2], 0.3 * all[1]);
  json root = json_of(*glb_bytes(*exported));
  EXPECT_EQ(root["extensionsUsed"][0], "MSFT_lod");
  EXPECT_EQ(root["meshes"].size(), 3 * exported->meshes.size());
  // Coarser levels stand in no scene; the herb is one node with two levels, as the corals are.
  ASSERT_EQ(root["scenes"][0]["nodes"].size(), 3u);
  for (const json& at : root["scenes"][0]["nodes"]) {
    const json& node = root["nodes"][at.get<std::size_t>()];
    ASSERT_EQ(node["extensions"]["MSFT_lod"]["ids"].size(), 2u);
    const json& coarse = root["nodes"][node["extensions"]["MSFT_lod"]["ids"][1].get<std::size_t>()];
    EXPECT_EQ(coarse["name"], node["name"].get<std::string>() + "_LOD2");
    EXPECT_EQ(coarse["translation"], node["translation"]);
  }
}

TEST(Detail, by_pixels_follows_the_levels_of_forests) {
  EXPECT_NEAR(detail_seen(800) / detail_seen(250), 1.4e5 / 5e4, 0.01);
  for (double pixels = 20; pixels < 1e4; pixels *= 1.3)
    EXPECT_LE(detail_seen(pixels), detail_seen(1.3 * pixels));
  auto triangles = [&](double pixels) {
    Result<ExportScene> exported =
        export_scene(growing(), 4, {.detail = detail_seen(pixels), .texture = 0, .pixels = pixels});
    EXPECT_TRUE(exported);
    return size_of(*exported).triangles;
  };
  EXPECT_LT(triangles(40), 0.7 * triangles(2000));
}

TEST(Tips, are_paler) {
  Result<ExportScene> exported = export_scene(growing(), 4, {.texture = 0});
  ASSERT_TRUE(exported);
  const ExportPart& coral = exported->meshes[0].parts[0];
  ASSERT_EQ(coral.tint.size(), coral.surface.position.size());
  const std::vector<Vec3>& at = coral.surface.position;
  auto tip =
      static_cast<std::size_t>(std::ranges::max_element(at, {}, [](Vec3 p) { return p.y; }) - at.begin());
  auto foot =
      static_cast<std::size_t>(std::ranges::min_element(at, {}, [](Vec3 p) { return p.y; }) - at.begin());
  EXPECT_EQ(coral.tint[tip], (ExportTint{255, 255, 255, 255}));
  EXPECT_LT(coral.tint[foot][2], 100);  // a pale tip is far less red
  EXPECT_TRUE(export_scene(growing(), 4, {.texture = 0, .tints = false})->meshes[0].parts[0].tint.empty());
}

}  // namespace
}  // namespace frond
