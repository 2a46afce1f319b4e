#include "scene/shading.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

#include "core/bounds.h"
#include "core/parallel.h"
#include "core/triangle.h"

namespace frond {

namespace {

constexpr float kCell = 0.015f;     // metres, at least
constexpr double kMostCells = 1e7;  // beyond, cells are larger
constexpr float kFar = 0.7f;        // metres; what is beyond shades nobody
constexpr int kSkyDirections = 32;
constexpr float kHardlyShaded = 0.9f;  // what has more everywhere is told nothing
constexpr std::uint32_t kOpaque = 255;

bool lives_by_light(const Solid& solid) { return row_of(solid.material.matter).nature == Nature::coral; }

bool is_colony(const Specimen& s) {
  auto lives = [](const Solid& solid) { return is_tissue(solid.material.matter); };
  return std::ranges::any_of(s.model.solids.shapes, lives) ||
         (s.look.branches.coral() && s.model.skeleton.size() > 0);
}

/// Boxes of a grid that hold something.
struct BoxGrid {
  Vec3 low{0};
  float cell = kCell;
  std::array<int, 3> count{};

  void enclose(Vec3 from, Vec3 to) {
    low = from;
    Vec3 size = to - from;
    double cells = static_cast<double>(size.x) * static_cast<double>(size.y) * static_cast<double>(size.z) /
                   std::pow(static_cast<double>(cell), 3);
    if (cells > kMostCells) cell *= static_cast<float>(std::cbrt(cells / kMostCells));
    for (int axis = 0; axis < 3; ++axis)
      count[static_cast<std::size_t>(axis)] = static_cast<int>(size[axis] / cell) + 1;
  }
  std::size_t size() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
  }
  /// The index of the box of a place; none outside the grid.
  std::optional<std::size_t> find(Vec3 at) const {
    Vec3 g = glm::floor((at - low) / cell);
    if (!(g.x >= 0 && g.y >= 0 && g.z >= 0)) return std::nullopt;
    if (g.x >= side(0) || g.y >= side(1) || g.z >= side(2)) return std::nullopt;
    return index(g);
  }
  /// The index of the box of a place that the grid was laid round.
  std::size_t of(Vec3 at) const {
    assert(std::isfinite(glm::dot(at, at)) && "a body of finite places");
    Vec3 g = glm::floor((at - low) / cell);
    for (int axis = 0; axis < 3; ++axis) g[axis] = std::min(std::max(0.0f, g[axis]), side(axis) - 1);
    return index(g);
  }

 private:
  float side(int axis) const { return static_cast<float>(count[static_cast<std::size_t>(axis)]); }
  std::size_t index(Vec3 g) const {
    return (static_cast<std::size_t>(g.z) * static_cast<std::size_t>(count[1]) +
            static_cast<std::size_t>(g.y)) *
               static_cast<std::size_t>(count[0]) +
           static_cast<std::size_t>(g.x);
  }
};

/// Who is where, and how much it holds up.
class CrowdedSpace {
 public:
  explicit CrowdedSpace(std::span<const Specimen> specimens) {
    Bounds box;
    for (const Specimen& s : specimens) {
      if (!is_colony(s)) continue;
      for (const Vec3& at : s.model.skeleton.position) box.extend(at);
      box.extend(bounds_of(s.model.solids));
    }
    if (box.empty()) return;
    grid_.enclose(box.low, box.high);
    held_.resize(grid_.size());
    for (std::size_t i = 0; i < specimens.size(); ++i)
      if (is_colony(specimens[i])) fill(specimens[i], static_cast<std::uint32_t>(i));
  }

  float cell() const { return grid_.cell; }

  /// The share of the light from above that others let through to a place on a body, of that which its own
  /// body does; without a normal, to a place on a branch, whose own coral counts as others do.
  float light(Vec3 at, Vec3 normal, std::size_t own) const {
    float come = 0, all = 0;
    bool branch = normal == Vec3(0);
    Vec3 from = at + (branch ? Vec3(0, 1.5f, 0) : 1.6f * normal) * grid_.cell;
    for (int k = 0; k < kSkyDirections; ++k) {
      Vec3 direction = sky_direction(k, kSkyDirections);
      if (!branch && glm::dot(direction, normal) < 0.05f) continue;
      float through = 1, step = 0.7f * grid_.cell;
      bool blocked = false;
      for (float away = 0; away < kFar && !blocked && through > 0.02f; away += step) {
        std::optional<std::size_t> i = grid_.find(from + direction * away);
        if (!i) break;
        std::uint32_t held = held_[*i] & 0xff;
        if (held == 0) continue;
        bool mine = held_[*i] >> 8 == own;
        if (mine && !branch)
          blocked = held > kOpaque / 2;
        else if (!mine || away > 3 * grid_.cell)  // a branch's own next part does not stand over it
          through *= 1 - 0.7f * static_cast<float>(held) / kOpaque;
      }
      if (blocked) continue;
      come += through;
      all += 1;
    }
    return all < 3 ? 1 : come / all;
  }

 private:
  void hold(Vec3 at, std::uint32_t who, std::uint32_t share) {
    std::optional<std::size_t> i = grid_.find(at);
    if (!i || share == 0) return;
    std::uint32_t& held = held_[*i];
    std::uint32_t sum = std::min(kOpaque, (held & 0xff) + share);
    // The one that holds most is taken for all.
    bool mine = share >= (held & 0xff);
    held = (mine ? who : held >> 8) << 8 | sum;
  }

  void fill(const Specimen& s, std::uint32_t who) {
    const Solids& solids = s.model.solids;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const Surface& skin = solids.shapes[solids.shape[i]].surface;
      for (auto [a, b, c] : skin.triangle)
        over_triangle(solids.placed(i, skin.position[a]), solids.placed(i, skin.position[b]),
                      solids.placed(i, skin.position[c]), grid_.cell * 0.6f,
                      [&](Vec3 at) { hold(at, who, kOpaque); });
    }
    const Skeleton& bones = s.model.skeleton;
    for (std::size_t i = 0; i < bones.size(); ++i) {
      if (bones.parent[i] == Skeleton::kRoot) continue;
      Vec3 a = bones.position[static_cast<std::size_t>(bones.parent[i])], b = bones.position[i];
      int n = 1 + static_cast<int>(glm::distance(a, b) / (0.5f * grid_.cell));
      float covers = 2 * bones.radius[i] * glm::distance(a, b) / static_cast<float>(n);
      auto share = static_cast<std::uint32_t>(std::min(1.0f, covers / (grid_.cell * grid_.cell)) *
                                              static_cast<float>(kOpaque));
      for (int k = 0; k < n; ++k)
        hold(a + (b - a) * ((static_cast<float>(k) + 0.5f) / static_cast<float>(n)), who, share);
    }
  }

  BoxGrid grid_;
  std::vector<std::uint32_t> held_;  // who << 8 | how much
};

/// Places of a skin that lie in one box, taken together.
struct SkinPatch {
  Vec3 at{0}, normal{0};
  float count = 0, light = 1;
};

bool has_living_branches(const Specimen& s) {
  return s.look.branches.living() && s.model.skeleton.size() > 0 && !s.life.reshapes();
}

/// The light of each vertex of a solid, placed as the i-th of coral `own`; empty where nearly all is left.
std::vector<float> light_of_skin(const CrowdedSpace& occupied, const Solids& solids, std::size_t i,
                                 std::size_t own) {
  const Surface& skin = solids.shapes[solids.shape[i]].surface;
  const std::vector<Vec3>& position = skin.position;
  Bounds box = bounds_of(position);
  BoxGrid near{.cell = occupied.cell() / solids.scale[i].x};
  near.enclose(box.low - near.cell, box.high + near.cell);
  std::vector<SkinPatch> patches(near.size());
  for (std::size_t v = 0; v < position.size(); ++v) {
    SkinPatch& patch = patches[near.of(position[v])];
    patch.at += position[v], patch.normal += skin.normal[v], ++patch.count;
  }
  float darkest = 1;
  for (SkinPatch& patch : patches) {
    if (patch.count == 0) continue;
    float length = glm::length(patch.normal);
    Vec3 normal = length > 0 ? solids.turn[i] * (patch.normal / length) : Vec3(0, 1, 0);
    patch.light = occupied.light(solids.placed(i, patch.at / patch.count), normal, own);
    darkest = std::min(darkest, patch.light);
  }
  if (darkest > kHardlyShaded) return {};
  // Between the middles of boxes it goes over from one to the next.
  std::vector<float> light;
  for (const Vec3& at : position) {
    float sum = 0, all = 0;
    for (int k = 0; k < 27; ++k) {
      std::optional<std::size_t> found =
          near.find(at + near.cell * Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
      if (!found || patches[*found].count == 0) continue;
      const SkinPatch& patch = patches[*found];
      float away = glm::distance(patch.at / patch.count, at) / near.cell;
      float weight = std::max(1e-3f, 1 - 0.6f * away);
      sum += weight * patch.light, all += weight;
    }
    light.push_back(all > 0 ? sum / all : 1);
  }
  return light;
}

/// The share of the light from above, 0..1, that others let through to each node of the branches; empty where
/// nearly all of it is left everywhere.
std::vector<float> light_of_branches(const CrowdedSpace& occupied, const Skeleton& bones, std::size_t own) {
  std::vector<float> light;
  for (const Vec3& at : bones.position) light.push_back(occupied.light(at, Vec3(0), own));
  if (std::ranges::min(light) > kHardlyShaded) light.clear();
  return light;
}

}  // namespace

void shade(std::span<Specimen> specimens) {
  std::vector<std::size_t> corals;
  std::size_t colonies = 0;
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    const Specimen& s = specimens[i];
    colonies += is_colony(s);
    if (has_living_branches(s) || std::ranges::any_of(s.model.solids.shapes, lives_by_light))
      corals.push_back(i);
  }
  if (colonies < 2 || corals.empty()) return;
  CrowdedSpace occupied(specimens);
  parallel_for(corals.size(), [&](std::size_t c) {
    Specimen& coral = specimens[corals[c]];
    Solids& solids = coral.model.solids;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      Solid& solid = solids.shapes[solids.shape[i]];
      if (lives_by_light(solid) && solid.light.empty() && !solid.surface.position.empty())
        solid.light = light_of_skin(occupied, solids, i, corals[c]);
    }
    if (has_living_branches(coral))
      coral.model.light = light_of_branches(occupied, coral.model.skeleton, corals[c]);
  });
}

}  // namespace frond
