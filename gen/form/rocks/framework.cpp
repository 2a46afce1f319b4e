#include "rocks/framework.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "core/joined_sets.h"
#include "core/noise.h"
#include "field/round_cone.h"
#include "field/solid.h"

// All lengths are shares of the size until a mesh is made.

namespace frond {

namespace {

constexpr float kCement = 0.012f;      // width of the fillets between colonies
constexpr float kFinestDome = 0.05f;   // radius of the small domes for which the tolerance counts
constexpr float kWidestCell = 0.125f;  // of the height: wider ones would miss a low framework

/// A part of a dead colony: a cone with round ends, or a disc across the axis of a cone without length, whose
/// radius is then half of the thickness of the disc.
struct Part {
  RoundCone cone;
  float disc = 0;  ///< radius of the flat disc; 0: a cone
};

float distance(const Part& part, Vec3 at) {
  if (part.disc <= 0) return distance(part.cone, at);
  Vec3 away = at - part.cone.from;
  float along = glm::dot(away, part.cone.axis);
  float beyond = std::max(glm::length(away - along * part.cone.axis) - part.disc, 0.0f);
  return std::sqrt(beyond * beyond + along * along) - part.cone.radius;
}

/// What has grown, and what has been taken away from it.
struct Reef {
  std::vector<Part> parts;
  std::vector<RoundCone> bores;
  Vec3 shift{0};       ///< of the noise
  float erosion = 0;   ///< 0 .. 1
  float ground = -9;   ///< height at which it is cut flat
  float cell = 0.01f;  ///< width of the cells of its mesh
};

/// Polynomial smooth minimum (Quilez 2008), no lower than the minimum by more than a quarter of the width.
float joined(float a, float b) {
  float near = std::max(kCement - std::abs(a - b), 0.0f);
  return std::min(a, b) - near * near / (4 * kCement);
}

/// How far erosion moves the surface out: lumps, and knobs with creases between them. Nothing that is too
/// small for the cells.
constexpr float kLumps = 0.13f, kKnobs = 0.06f, kGrain = 0.028f;  // from one to the next
constexpr float kSteep = 0.3f;                                    // of their heights, of that
constexpr float kMostWorn = kSteep * (kLumps + kKnobs + kGrain);

float worn(const Reef& reef, Vec3 at) {
  constexpr float kCells = 3;  // in which there is a lump
  float height = 0;
  auto add = [&](float apart, bool knob) {
    if (apart < kCells * reef.cell) return;
    float n = static_cast<float>(noise(at / apart + reef.shift));
    height += kSteep * apart * (knob ? std::abs(n) - 0.35f : 0.7f * n);
  };
  add(kLumps, false), add(kKnobs, true), add(kGrain, true);
  return reef.erosion * height;
}

/// The distance from what has grown, before it was worn and bored.
float grown(const std::vector<Part>& parts, Vec3 at) {
  float least = 9;
  for (const Part& part : parts) least = joined(least, distance(part, at));
  return least;
}

float left(const Reef& reef, Vec3 at) {
  float d = grown(reef.parts, at) - worn(reef, at);
  for (const RoundCone& bore : reef.bores) d = -joined(-d, distance(bore, at));
  return std::max(d, reef.ground - at.y);
}

/// The part of a reef that counts near a ball.
Reef near_ball(const Reef& reef, Vec3 middle, float reach) {
  Reef near{{}, {}, reef.shift, reef.erosion, reef.ground, reef.cell};
  auto counts = [&](const auto& shape) { return distance(shape, middle) <= reach; };
  std::copy_if(reef.parts.begin(), reef.parts.end(), std::back_inserter(near.parts), counts);
  std::copy_if(reef.bores.begin(), reef.bores.end(), std::back_inserter(near.bores), counts);
  return near;
}

Filling fill(const Reef& reef, Cell first, std::span<float, kBlockVoxels> distances) {
  float half = 0.5f * (kBlockSide - 1) * reef.cell, reach = std::sqrt(3.0f) * half;
  Vec3 low = Vec3(first.i, first.j, first.k) * reef.cell, middle = low + half;
  float band = 3 * reef.cell, counts = reach + band + kMostWorn * reef.erosion + kCement;
  Reef near = near_ball(reef, middle, counts);
  float d = grown(near.parts, middle);
  if (near.parts.empty() || middle.y + counts < reef.ground) return Filling::outside;
  if (near.bores.empty() && d < -counts && middle.y - counts > reef.ground) return Filling::inside;
  std::size_t n = 0;
  for (int i = 0; i < kBlockSide; ++i)
    for (int j = 0; j < kBlockSide; ++j)
      for (int k = 0; k < kBlockSide; ++k) distances[n++] = left(near, low + Vec3(i, j, k) * reef.cell);
  return Filling::crossed;
}

/// The largest piece of a mesh; voids inside and specks are left out.
Surface largest_piece(const Surface& all) {
  JoinedSets pieces(all.position.size());
  for (auto [a, b, c] : all.triangle) pieces.join(a, b), pieces.join(b, c);
  std::vector<double> volume(all.position.size());
  for (auto [a, b, c] : all.triangle)
    volume[pieces.top(a)] +=
        glm::dot(DVec3(all.position[a]), glm::cross(DVec3(all.position[b]), DVec3(all.position[c])));
  auto largest = static_cast<std::uint32_t>(std::ranges::max_element(volume) - volume.begin());
  Surface kept;
  std::vector<std::uint32_t> index(all.position.size());
  for (std::uint32_t v = 0; v < all.position.size(); ++v) {
    if (pieces.top(v) != largest) continue;
    index[v] = static_cast<std::uint32_t>(kept.position.size());
    kept.position.push_back(all.position[v]);
  }
  for (auto [a, b, c] : all.triangle)
    if (pieces.top(a) == largest) kept.triangle.push_back({index[a], index[b], index[c]});
  return kept;
}

Surface mesh_of(const Reef& reef, double size) {
  Box box{DVec3(9), DVec3(-9)};
  for (const Part& part : reef.parts)
    for (Vec3 end : {part.cone.from, part.cone.to()}) {
      float more = part.cone.radius + part.disc + kMostWorn + 4 * reef.cell;
      box.low = glm::min(box.low, DVec3(end - more)), box.high = glm::max(box.high, DVec3(end + more));
    }
  Result<Surface> all = solid_surface(
      box, reef.cell, [&](Cell first, std::span<float, kBlockVoxels> d) { return fill(reef, first, d); });
  if (!all || all->triangle.empty()) return {};
  Surface piece = largest_piece(*all);
  Vec3 low = piece.position[0], high = low;
  for (Vec3 p : piece.position) low = glm::min(low, p), high = glm::max(high, p);
  Vec3 foot((low.x + high.x) / 2, low.y, (low.z + high.z) / 2), extent = high - low;
  float scale = static_cast<float>(size) / std::max({extent.x, extent.y, extent.z});
  for (Vec3& p : piece.position) p = (p - foot) * scale;
  set_normals(piece);
  return piece;
}

Vec3 random_in(Seed seed, Vec3 low, Vec3 high) {
  return Vec3(seed.child(0).range(low.x, high.x), seed.child(1).range(low.y, high.y),
              seed.child(2).range(low.z, high.z));
}

/// A place on what has grown so far.
struct Site {
  Vec3 at{0}, out{0, 1, 0};  ///< and the direction away from it, of length 1
};

/// Where a ray from outside toward the inner part meets what has grown, by sphere tracing (Hart 1996).
Site find_site(const std::vector<Part>& parts, double height, Seed seed) {
  constexpr float kFrom = 1.5f, kClose = 0.002f;
  constexpr int kSteps = 60;
  float top = static_cast<float>(height);
  Vec3 goal = random_in(seed.child("goal"), {-0.25f, 0.1f * top, -0.2f}, {0.25f, 0.5f * top, 0.2f});
  double turn = seed.child("turn").range(0, 2 * kPi), rise = seed.child("rise").range(-0.1, 1);
  double aside = std::sqrt(1 - rise * rise);
  Vec3 from(aside * std::cos(turn), rise, aside * std::sin(turn)), at = goal + kFrom * from;
  for (int i = 0; i < kSteps; ++i) {
    float d = grown(parts, at);
    if (d < kClose) break;
    at -= from * d;
  }
  float d = grown(parts, at);
  Vec3 slope(grown(parts, at + Vec3(kClose, 0, 0)) - d, grown(parts, at + Vec3(0, kClose, 0)) - d,
             grown(parts, at + Vec3(0, 0, kClose)) - d);
  float steep = glm::length(slope);
  return {at, steep > 0 ? slope / steep : from};
}

Vec3 leveled(Vec3 out) {
  out.y = 0;
  float length = glm::length(out);
  return length > 0 ? out / length : Vec3(1, 0, 0);
}

/// A plate: a ledge where it is steep, else a table on a foot.
void grow_plate(std::vector<Part>& parts, const Site& site, float radius, Seed seed) {
  constexpr float kLevel = 0.75f;  // of the direction outward, upward part of a level place
  Vec3 tilt = random_in(seed.child("tilt"), Vec3(-0.3f, 0, -0.3f), Vec3(0.3f, 0, 0.3f));
  Vec3 axis = glm::normalize(Vec3(0, 1, 0) + tilt - 0.15f * leveled(site.out));
  float half = std::max(0.14f * radius, 0.013f), wide = 1.45f * radius;
  Vec3 middle = site.at + 0.6f * radius * leveled(site.out);
  if (site.out.y > kLevel) {
    middle = site.at + Vec3(0, 0.55f * radius, 0);
    parts.push_back({make_cone(site.at - 0.3f * radius * site.out, 0.5f * radius, middle, 0.4f * radius, 0)});
  }
  RoundCone thickness = make_cone(middle, half, middle, half, 0);
  thickness.axis = axis;
  parts.push_back({thickness, wide});
}

/// Stubs of branches that spread from one foot.
void grow_branches(std::vector<Part>& parts, const Site& site, float radius, Seed seed) {
  constexpr std::uint64_t kLeast = 4, kMore = 4;
  float thick = std::max(0.26f * radius, 0.014f);
  for (std::uint64_t i = 0, count = kLeast + seed.child("count").bits() % kMore; i < count; ++i) {
    Seed own = seed.child("stub", i);
    Vec3 way =
        glm::normalize(site.out + random_in(own.child("way"), Vec3(-0.9f), Vec3(0.9f)) + Vec3(0, 0.3f, 0));
    float length = radius * static_cast<float>(own.child("length").range(0.8, 1.7));
    parts.push_back(
        {make_cone(site.at - 0.3f * radius * site.out, thick, site.at + length * way, 0.75f * thick, 0)});
  }
}

/// A dome, which has risen from a place below.
void grow_dome(std::vector<Part>& parts, const Site& site, float radius, Seed seed) {
  Vec3 middle = site.at + 0.2f * radius * site.out;
  Vec3 foot = middle + radius * random_in(seed.child("foot"), Vec3(-0.6f, -2, -0.6f), Vec3(0.6f, 0, 0.6f));
  float lesser = radius * static_cast<float>(seed.child("lesser").range(0.7, 1.1));
  parts.push_back({make_cone(middle, radius, foot, lesser, 0)});
}

/// Lays dead colonies on one another, each where it has the most light of two places.
void grow(std::vector<Part>& parts, const Framework& framework, Seed seed) {
  constexpr double kLargest = 0.15, kSmallest = 0.035, kFewLarge = 0.5;
  constexpr float kHalfWidth = 0.5f;
  auto top = static_cast<float>(framework.height);
  for (int i = 0; i < framework.colonies; ++i) {
    Seed own = seed.child("colony", static_cast<std::uint64_t>(i));
    double size = kLargest + (kSmallest - kLargest) * std::pow((i + 0.5) / framework.colonies, kFewLarge);
    auto radius = static_cast<float>(size * own.child("size").range(0.75, 1.3));
    Site site = find_site(parts, framework.height, own.child("site", 0));
    Site other = find_site(parts, framework.height, own.child("site", 1));
    auto light = [&](const Site& s) { return 0.5f * s.at.y / top + 0.4f * s.out.y; };
    if (light(other) > light(site)) site = other;
    // What would come above the water, or farther out than the whole is wide, has not grown.
    if (site.at.y + radius > top) continue;
    if (std::max(std::abs(site.at.x), std::abs(site.at.z)) + radius > kHalfWidth) continue;
    double which = own.child("form").unit();
    if (which < framework.plates)
      grow_plate(parts, site, radius, own);
    else if (which < framework.plates + framework.branches)
      grow_branches(parts, site, radius, own);
    else
      grow_dome(parts, site, radius, own);
  }
}

/// One size of what bores, and what storms have broken out.
struct Boring {
  const char* name;
  double count;            ///< at boring 1
  double least, most;      ///< radius
  double shorter, longer;  ///< depth in radii
  float level;             ///< largest upward part of the direction outward
  double high;             ///< share of the height up to which there are any
};

constexpr Boring kBorings[] = {{"cave", 16, 0.05, 0.10, 1.5, 3, 0.35f, 0.55},
                               {"hole", 70, 0.02, 0.045, 2, 4, 0.75f, 1},
                               {"pit", 220, 0.009, 0.018, 1, 2.5, 1, 1}};

void bore(Reef& reef, const Framework& framework, Seed seed) {
  constexpr float kLeastCells = 0.9f;  // of a radius that shows
  for (const Boring& boring : kBorings)
    for (std::uint64_t i = 0; static_cast<double>(i) < framework.boring * boring.count; ++i) {
      Seed own = seed.child(boring.name, i);
      auto radius = static_cast<float>(own.child("size").range(boring.least, boring.most));
      Site site = find_site(reef.parts, framework.height, own);
      if (radius < kLeastCells * reef.cell || site.out.y > boring.level ||
          site.at.y > boring.high * framework.height)
        continue;
      Vec3 inward = glm::normalize(
          random_in(own.child("way"), Vec3(-0.6f, -0.2f, -0.6f), Vec3(0.6f, 0.2f, 0.6f)) - site.out);
      auto deep = radius * static_cast<float>(own.child("depth").range(boring.shorter, boring.longer));
      reef.bores.push_back(
          make_cone(site.at - 0.3f * radius * inward, radius, site.at + deep * inward, 0.7f * radius, 0));
    }
}

Reef started(const Framework& framework, const FrameworkCells& cells, Seed seed) {
  Reef reef;
  reef.shift = random_shift(seed.child("noise"), 50);
  reef.erosion = static_cast<float>(framework.erosion);
  // A chord of a cell's width is off from a dome by the square of it over eight radii.
  double even = std::sqrt(8 * kFinestDome * cells.tolerance);
  reef.cell = static_cast<float>(std::max(even, cells.finest));
  return reef;
}

}  // namespace

Surface framework_surface(const Framework& framework, double size, const FrameworkCells& cells, Seed seed) {
  assert(size > 0 && framework.colonies >= 0);
  Reef reef = started(framework, cells, seed);
  reef.ground = 0;
  auto top = static_cast<float>(framework.height);
  reef.cell = std::min(reef.cell, kWidestCell * top);
  // The older core: heaps beside one another.
  constexpr std::uint64_t kHeaps = 4;
  for (std::uint64_t i = 0; i < kHeaps; ++i) {
    Seed own = seed.child("heap", i);
    Vec3 from = random_in(own.child("from"), Vec3(-0.12f, 0, -0.1f), Vec3(0.12f, 0.2f * top, 0.1f));
    Vec3 to = random_in(own.child("to"), Vec3(-0.32f, -0.1f * top, -0.25f), Vec3(0.32f, 0.2f * top, 0.25f));
    float thick = top * static_cast<float>(own.child("thick").range(0.28, 0.4));
    reef.parts.push_back({make_cone(from, thick, to, 0.8f * thick, 0)});
  }
  grow(reef.parts, framework, seed);
  bore(reef, framework, seed.child("bore"));
  return mesh_of(reef, size);
}

Surface rubble_surface(const Framework& framework, double size, const FrameworkCells& cells, Seed seed) {
  assert(size > 0);
  Reef reef = started(framework, cells, seed);
  auto thick = static_cast<float>(seed.child("thick").range(0.09, 0.15));
  Vec3 bend = random_in(seed.child("bend"), Vec3(-0.1f, -0.03f, -0.12f), Vec3(0.1f, 0.03f, 0.12f));
  Vec3 ends[] = {Vec3(-0.4f, 0, 0), bend, Vec3(0.4f, 0, -bend.z)};
  for (int i = 0; i < 2; ++i) reef.parts.push_back({make_cone(ends[i], thick, ends[i + 1], 0.9f * thick, 0)});
  for (std::uint64_t i = 0; i < 3; ++i) {
    Seed own = seed.child("stub", i);
    Vec3 from = glm::mix(ends[0], ends[2], static_cast<float>(own.child("along").range(0.25, 0.95)));
    Vec3 way = random_in(own.child("way"), Vec3(-0.1f, -0.1f, -0.3f), Vec3(0.35f, 0.2f, 0.3f));
    reef.parts.push_back({make_cone(from, 0.8f * thick, from + way, 0.6f * thick, 0)});
  }
  return mesh_of(reef, size);
}

}  // namespace frond
