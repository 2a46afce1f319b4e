#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/files.h"
#include "creeping/meshes.h"
#include "creeping/triangle_surface.h"
#include "scene/scene.h"

// Leaves and strands as they are emitted, against the bodies and the ground that they grow on.

namespace frond {
namespace {

struct Blade {
  std::vector<Vec3> places;  // all over it, of the prototype
  Vec3 foot{0};
  float length = 0;
};

/// The blades of a leaf or a sprig: parts of the mesh that hang together, without petioles.
std::vector<Blade> blades_of(const Surface& s) {
  std::vector<std::uint32_t> piece(s.position.size());
  std::iota(piece.begin(), piece.end(), 0u);
  auto root = [&](std::uint32_t i) {
    while (piece[i] != i) i = piece[i];
    return i;
  };
  for (auto [a, b, c] : s.triangle)
    for (std::uint32_t other : {b, c}) {
      std::uint32_t x = root(a), y = root(other);
      piece[std::max(x, y)] = std::min(x, y);
    }
  std::vector<Blade> blades(s.position.size());
  for (auto [a, b, c] : s.triangle) {
    if (s.uv[a].x > 1) continue;
    Blade& blade = blades[root(a)];
    blade.foot = s.position[root(a)];
    Vec3 p = s.position[a], q = s.position[b], r = s.position[c];
    for (Vec3 corner : {p, q, r}) blade.length = std::max(blade.length, glm::distance(corner, blade.foot));
    float longest = std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
    int cuts = 1 + static_cast<int>(longest / 0.06f);
    for (int i = 0; i <= cuts; ++i)
      for (int k = 0; i + k <= cuts; ++k) {
        Vec3 place = (p * float(i) + q * float(k) + r * float(cuts - i - k)) / float(cuts);
        if (std::ranges::none_of(blade.places,
                                 [&](const Vec3& other) { return glm::distance(place, other) < 0.05f; }))
          blade.places.push_back(place);
      }
  }
  std::erase_if(blades, [](const Blade& b) { return b.places.empty(); });
  return blades;
}

struct Faults {
  std::size_t blades = 0, cut = 0, sunk = 0;  // sunk: over more than a third of their length
};

/// Metres that a place lies in the host or the ground.
double depth_of(const TriangleSurface& host, const GroundHeight& ground, const Vec3& p) {
  Contact near = *host.closest(DVec3(p));
  return std::max(ground(p.x, p.z) - p.y,
                  (host.closed() ? host.inside(DVec3(p)) : near.inside) ? near.distance : 0.0);
}

Faults faults_of(const Specimen& ivy, const TriangleSurface& host, const GroundHeight& ground) {
  Faults f;
  std::vector<std::vector<Blade>> prototypes;
  for (const Prototype& p : ivy.model.prototypes) prototypes.push_back(blades_of(p.parts[0].surface));
  std::vector<Vec3> in;
  for (std::size_t i = 0; i < ivy.model.organs.size(); ++i)
    for (const Blade& blade : prototypes[ivy.model.organs.prototype[i]]) {
      float size = ivy.model.organs.scale[i].x, length = size * blade.length;
      double deepest = 0;
      in.clear();
      for (const Vec3& place : blade.places) {
        Vec3 at = ivy.model.organs.position[i] + ivy.model.organs.turn[i] * (place * size);
        double depth = depth_of(host, ground, at);
        deepest = std::max(deepest, depth);
        if (depth > 0.1 * std::max(0.002, 0.03 * length)) in.push_back(at);
      }
      float extent = 0;
      for (const Vec3& a : in)
        for (const Vec3& b : in) extent = std::max(extent, glm::distance(a, b));
      ++f.blades;
      bool cuts = deepest > std::max(0.002, 0.03 * length);
      f.cut += cuts;
      f.sunk += cuts && extent > length / 3;
    }
  return f;
}

const std::string kStill = R"("turn_variation": 0, "lean": 0, "size_variation": 0)";

/// A foreign mesh one unit high, of few large triangles.
Surface upright_ring() {
  Surface s = ring(0.36, 0.14, 40, 16);
  for (Vec3& p : s.position) p = Vec3(p.x, 0.5f - p.z, p.y);
  set_normals(s);
  return s;
}

/// The same as a file.
std::string ring_file() {
  std::string path = testing::TempDir() + "frond_upright_ring.obj", text;
  Surface s = upright_ring();
  for (const Vec3& p : s.position) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (auto [a, b, c] : s.triangle) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  EXPECT_TRUE(write_file(path, text).ok());
  return path;
}

Scene scene_of(const std::string& setting, const std::string& bodies, const std::string& ivy, int seed) {
  Result<Preset> preset =
      read_preset(R"({"seed": )" + std::to_string(seed) + R"(, "scene": )" + setting + R"(, "organisms": [)" +
                      bodies + R"(, {"kind": "ivy", )" + ivy + "}]}",
                  "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors()[0].text();
  Result<Scene> scene = build_scene(*preset);
  if (!scene) ADD_FAILURE() << scene.errors()[0].text();
  return std::move(*scene);
}

/// The bodies of a scene as one host, and the faults of the ivy, which stands last.
Faults faults_of(const Scene& scene, const GroundHeight& ground) {
  Surface all;
  for (std::size_t b = 0; b + 1 < scene.specimens.size(); ++b) {
    append(all, skin_of(scene.specimens[b].model));
  }
  return faults_of(scene.specimens.back(), *TriangleSurface::build(all), ground);
}

const std::string kWall = R"({"kind": "wall", "width": 2.4, "height": 1.5,
  "openings": [{"kind": "window", "at": 0.3, "sill": 0.5, "width": 0.6, "height": 0.6}],
  "place": {"at": [[0, 0]], )" +
                          kStill + "}}";
const std::string kColumn = R"({"kind": "column", "height": 1.8, "radius": 0.2,
  "place": {"at": [[0, 0]], )" +
                            kStill + "}}";
const std::string kRocks = R"({"kind": "rock", "size": 1.2, "buried": 0.15, "place": {"at": [[0, 0]]}},
  {"kind": "rock", "size": 0.7, "buried": 0.2, "place": {"at": [[0.6, 0.4]]}})";
const std::string kMesh = R"({"kind": "mesh", "file": ")" + ring_file() + R"(", "size": 1.8,
  "place": {"at": [[0, 0]], )" +
                          kStill + "}}";

struct Case {
  const char* name;
  std::string bodies;
};
std::vector<Case> cases() {
  return {{"wall", kWall}, {"column", kColumn}, {"rocks", kRocks}, {"mesh", kMesh}};
}

/// Of all bodies, two seeds each.
void expect_at_rest(const std::string& leaves, std::size_t least) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Faults sum;
    for (int seed = 1; seed <= 2; ++seed) {
      Faults f = faults_of(scene_of(R"({"setting": "studio"})", c.bodies,
                                    R"("count": 3, "crawl": {"max_age": 60}, "leaves": )" + leaves, seed),
                           [](double, double) { return 0.0; });
      sum.blades += f.blades, sum.cut += f.cut, sum.sunk += f.sunk;
    }
    EXPECT_GT(sum.blades, least);
    EXPECT_LT(static_cast<double>(sum.cut), 0.02 * static_cast<double>(sum.blades)) << sum.blades;
    EXPECT_EQ(sum.sunk, 0u);
  }
}

TEST(IvyRest, LeavesLieOnWhatTheyGrowOn) { expect_at_rest(R"({"detail": "leaves"})", 400); }

TEST(IvyRest, LeavesLieOnWhereTheLightComesAlongTheSurface) {
  expect_at_rest(R"({"detail": "leaves", "turn": 1, "light": [1, 0, 0]})", 400);
}

TEST(IvyRest, SprigsLieOnWhatTheyGrowOn) { expect_at_rest(R"({"detail": "sprigs"})", 300); }

/// Metres that the deepest node of the ivy lies in the ground.
double sunk_in(const Scene& scene, const GroundHeight& ground) {
  double deepest = 0;
  for (const Vec3& p : scene.specimens.back().model.skeleton.position)
    deepest = std::max<double>(deepest, ground(p.x, p.z) - p.y);
  return deepest;
}

TEST(IvyRest, NothingHangsIntoTheFloor) {
  for (int seed = 1; seed <= 2; ++seed)
    for (const Case& c : cases()) {
      SCOPED_TRACE(c.name);
      Scene scene = scene_of(R"({"setting": "studio"})", c.bodies,
                             R"("count": 4, "crawl": {"max_age": 100, "let_go": 0.5, "hang_most": 2})", seed);
      const auto& hanging = scene.specimens.back().life.hanging->strands.hanging;
      EXPECT_GT(std::count(hanging.begin(), hanging.end(), 1), 20);
      EXPECT_EQ(sunk_in(scene, [](double, double) { return 0.0; }), 0);
    }
}

TEST(IvyRest, NothingHangsIntoTheGroundWhereItRises) {
  for (int seed = 1; seed <= 2; ++seed) {
    Scene scene = scene_of(R"({"setting": "underwater", "floor": {"relief": 0.3, "scale": 1.5}})",
                           kColumn + "," + kMesh,
                           R"("count": 4, "crawl": {"max_age": 100, "let_go": 0.5, "hang_most": 2})", seed);
    const Heights& heights = scene.ground->heights();
    EXPECT_EQ(sunk_in(scene, [&](double x, double z) { return heights(x, z); }), 0);
  }
}

}  // namespace
}  // namespace frond
