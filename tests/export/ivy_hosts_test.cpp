#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "core/files.h"
#include "creeping/meshes.h"
#include "creeping/triangle_surface.h"
#include "export/export_scene.h"

// Leaves of ivy as they are exported, against meshes of all kinds that they grow on.

namespace frond {
namespace {

/// A tube along a closed curve that is knotted, `turns` times round while it goes `winds` times about.
Surface knot(int turns, int winds, double thickness, int columns, int rows) {
  auto curve = [=](double u) {
    double a = 2 * kPi * turns * u, b = 2 * kPi * winds * u, r = 0.5 + 0.22 * std::cos(b);
    return DVec3(r * std::cos(a), 0.8 + r * std::sin(a), 0.25 * std::sin(b));
  };
  Surface s = sheet(columns, rows, true, true, [=](double u, double v) {
    DVec3 along = glm::normalize(curve(u + 1e-4) - curve(u - 1e-4));
    DVec3 side = glm::normalize(glm::cross(along, DVec3(0, 0.1, 1))), up = glm::cross(side, along);
    return Vec3(curve(u) + thickness * (side * std::cos(2 * kPi * v) + up * std::sin(2 * kPi * v)));
  });
  return s;
}

/// A box whose sides have bulges and dents between few corners.
Surface crumpled(Seed seed) {
  Surface s = ball(0.7, 14, 9);
  for (std::size_t i = 0; i < s.position.size(); ++i)
    s.position[i] =
        s.position[i] * static_cast<float>(0.75 + 0.5 * seed.child(i % 14 + i / 14 * 100).unit()) +
        Vec3(0, 0.75f, 0);
  set_normals(s);
  return s;
}

Surface flipped(Surface s, double share, Seed seed) {
  for (std::size_t t = 0; t < s.triangle.size(); ++t)
    if (seed.child(t).unit() < share) std::swap(s.triangle[t][1], s.triangle[t][2]);
  return s;
}

Surface panels() {
  return bricks(24, 30, 24, Vec3(0.05f), [](int x, int, int z) { return x % 8 == 0 || (z == 12 && x > 8); });
}

struct HostMesh {
  const char* name;
  Surface surface;
};

std::vector<HostMesh> host_meshes() {
  Surface thin = bricks(4, 2, 1, Vec3(0.5f, 0.7f, 0.006f), [](int, int, int) { return true; });
  Surface lattice = bricks(31, 31, 2, Vec3(0.05f, 0.05f, 0.02f),
                           [](int x, int y, int) { return x % 6 == 0 || y % 6 == 0; });
  Surface steps = bricks(12, 12, 6, Vec3(0.12f), [](int x, int y, int) { return y <= x; });
  return {{"thin panel", thin},
          {"trefoil knot", knot(2, 3, 0.07, 120, 9)},
          {"thin knot of few faces", knot(3, 5, 0.035, 110, 5)},
          {"scan with holes, flipped and double faces", scanned(Seed{3})},
          {"wall with openings, faces flipped", flipped(wall_with_openings(), 0.4, Seed{9})},
          {"lattice", lattice},
          {"stairs", steps},
          {"crumpled", crumpled(Seed{4})},
          {"panels beside each other", panels()},
          {"ring of few faces", ring(0.5, 0.12, 12, 5)}};
}

Scene ivy_on(const HostMesh& host, const std::string& ivy) {
  std::string text, path = testing::TempDir() + "frond_host.obj";
  for (const Vec3& p : host.surface.position) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (auto [a, b, c] : host.surface.triangle) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  EXPECT_TRUE(write_file(path, text).ok());
  std::string preset = R"({"seed": 5, "film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [
    {"kind": "mesh", "name": "host", "file": ")" +
                       path + R"(", "size": 1.6,
     "place": {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0}},
    {"kind": "ivy", "name": "ivy", "on": ["host"], "growth": {"duration": 0}, "breeze": {"amplitude": 0}, )" +
                       ivy + "}]}";
  Result<Preset> read = read_preset(preset, "test.json", {});
  if (!read) ADD_FAILURE() << read.errors()[0].text();
  Result<Scene> scene = build_scene(*read);
  if (!scene) ADD_FAILURE() << scene.errors()[0].text();
  return std::move(*scene);
}

struct LeafPieces {
  std::size_t all = 0, inside = 0;
};

/// Whether a piece of a leaf, some triangles, is in a host: a corner of it is, or an edge goes through it.
bool is_inside(const Surface& s, const std::vector<std::uint32_t>& triangles, const TriangleSurface& host) {
  for (std::uint32_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      DVec3 a(s.position[s.triangle[t][k]]), b(s.position[s.triangle[t][(k + 1) % 3]]);
      if (host.crossing(a, b) || (host.closed() && host.inside(a))) return true;
    }
  return false;
}

/// The pieces of leaves that hang together, with their petioles or without.
void count_pieces(const Surface& s, const TriangleSurface& host, LeafPieces& pieces) {
  std::vector<std::uint32_t> above(s.position.size());
  std::iota(above.begin(), above.end(), 0u);
  auto root = [&](std::uint32_t i) {
    while (above[i] != i) i = above[i] = above[above[i]];
    return i;
  };
  auto is_blade = [&](std::uint32_t t) { return s.uv[s.triangle[t][0]].x <= 1; };
  for (std::uint32_t t = 0; t < s.triangle.size(); ++t)
    for (std::uint32_t v : s.triangle[t])
      if (is_blade(t))
        above[std::max(root(v), root(s.triangle[t][0]))] = std::min(root(v), root(s.triangle[t][0]));
  std::map<std::uint32_t, std::vector<std::uint32_t>> found;
  for (std::uint32_t t = 0; t < s.triangle.size(); ++t)
    if (is_blade(t)) found[root(s.triangle[t][0])].push_back(t);
  for (const auto& [first, triangles] : found) {
    ++pieces.all;
    pieces.inside += is_inside(s, triangles, host);
  }
}

/// Those of all leaves as they are exported.
LeafPieces pieces_of(const Scene& scene) {
  const Specimen& ivy = scene.specimens.back();
  TriangleSurface host = built(skin_of(scene.specimens[scene.specimens.size() - 2].model));
  Result<ExportScene> exported = export_scene(scene, 0, {.detail = 1e9, .texture = 0, .instances = true});
  LeafPieces pieces;
  EXPECT_TRUE(exported);
  if (!exported) return pieces;
  for (const ExportPlacement& p : exported->placements) {
    if (exported->groups[p.group].name != ivy.name) continue;
    for (const ExportPart& part : exported->meshes[p.mesh].parts)
      if (exported->materials[part.material].leaf) count_pieces(placed(part, p), host, pieces);
  }
  return pieces;
}

void expect_free(const std::string& ivy) {
  LeafPieces trembling;
  for (const HostMesh& host : host_meshes()) {
    Scene scene = ivy_on(host, ivy);
    LeafPieces moved = pieces_of(scene);
    trembling.all += moved.all, trembling.inside += moved.inside;
    scene.specimens.back().motion.flutter.amplitude = 0;
    LeafPieces still = pieces_of(scene);
    EXPECT_GT(still.all, 100u) << host.name;
    EXPECT_LT(static_cast<double>(still.inside), 0.005 * static_cast<double>(still.all))
        << host.name << ": " << still.inside << " of " << still.all;
  }
  EXPECT_LT(static_cast<double>(trembling.inside), 0.005 * static_cast<double>(trembling.all))
      << trembling.inside;
}

TEST(IvyOnMeshes, LeavesDoNotCutWhatTheyGrowOn) {
  expect_free(R"("count": 3, "crawl": {"max_age": 90}, "leaves": {"detail": "leaves"})");
}

TEST(IvyOnMeshes, LeavesOfFineStrandsDoNotCutWhatTheyGrowOn) {
  expect_free(R"("count": 3, "crawl": {"speed": 0.006, "max_age": 220, "spacing": 0.03, "branch_every": 0.12},
                "leaves": {"size": 0.03, "spacing": 0.016, "detail": "leaves"})");
}

}  // namespace
}  // namespace frond
