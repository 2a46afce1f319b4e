#include "draw/branches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/bytes.h"
#include "core/lru_cache.h"
#include "geometry/relief.h"
#include "geometry/tubes.h"

namespace frond {

namespace {

constexpr double kShown = 0.6;  // of the bark's scale: thinner branches are too thin to show it

}  // namespace

BranchForm branch_form(const Specimen& b) {
  if (!b.look.branches.drawn()) return BranchForm::none;
  if (b.style.build != Build::sweeps) return BranchForm::body;
  return b.look.branches.coat ? BranchForm::coat : BranchForm::sweeps;
}

ChunkOptions chunk_options(const Specimen& b) {
  constexpr double kSlide = 0.15;  // of the pattern, by which it may slide on the skin
  constexpr int kRings = 5;        // nodes, so that rings lie across also where it bends
  const BranchLook& look = b.look.branches;
  ChunkOptions options;
  if (!look.drawn()) return options;
  options.tolerance = look.patterned() ? static_cast<float>(kSlide * look.pattern_size())
                                       : std::numeric_limits<float>::infinity();
  options.young_length = static_cast<float>(look.young_length());
  if (look.bark) options.color = b.model.color;
  if (look.ringed()) options.nodes = kRings;
  // Of a swaying tree only what is thick has a bark that one could see slide.
  if (b.motion.limbs && !one_texture(b)) options.thin = static_cast<float>(kShown * look.bark_scale());
  return options;
}

bool slanted(const Specimen& b, const Chunk& chunk) {
  const BranchLook& look = b.look.branches;
  const Skeleton& s = b.model.skeleton;
  if (look.skin || !look.patterned() ||
      s.radius[static_cast<std::size_t>(chunk.first)] < kShown * look.pattern_size())
    return false;
  Vec3 offset = s.position[static_cast<std::size_t>(chunk.last)] -
                s.position[static_cast<std::size_t>(s.parent[static_cast<std::size_t>(chunk.first)])];
  return std::abs(offset.y) < 0.9f * glm::length(offset);
}

bool one_texture(const Specimen& b) {
  const BranchLook& look = b.look.branches;
  if (!look.bark || look.ringed() || look.young_length() > 0 || (!b.model.color.empty() && look.colors() > 1))
    return false;
  return !look.patterned() || (b.motion.wave.amplitude == 0 && b.motion.growth.duration <= 0);
}

namespace {

constexpr double kNearDepths = 90;  // how many depths of a furrow away it shows that it is one

/// The height of a bark at uv, which goes round and round.
float height_at(const Grid& grid, Vec2 uv) {
  float x = (uv.x - std::floor(uv.x)) * static_cast<float>(grid.width) - 0.5f,
        y = (1 - (uv.y - std::floor(uv.y))) * static_cast<float>(grid.height) - 0.5f;
  int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  float right = x - static_cast<float>(column), down = y - static_cast<float>(row);
  return glm::mix(glm::mix(grid.wrapped(column, row), grid.wrapped(column + 1, row), right),
                  glm::mix(grid.wrapped(column, row + 1), grid.wrapped(column + 1, row + 1), right), down);
}

/// The heights of a bark, kept for the trees and frames that ask for the same ones again.
std::shared_ptr<const Grid> heights_of(const BarkCoat& coat, int width) {
  constexpr std::size_t kRoom = 32 << 20;  // bytes
  static LruCache<Grid> kept(kRoom);
  // The picture's name says all that its heights depend on.
  std::string name = bark_height_name(coat);
  if (auto found = kept.find(name)) return found;
  int height = static_cast<int>(std::lround(width * coat.aspect));
  auto grid = std::make_shared<const Grid>(bark_maps(coat.image, width, height, bark_seed()).height);
  kept.put(name, grid, bytes_of(grid->data));
  return grid;
}

/// The furrows of what the eye sees from so near that they show.
Surface furrowed(const Surface& wood, const BarkCoat& coat, Vec3 eye) {
  double depth = coat.furrow * coat.wrap / coat.image.ridges;
  auto reach = static_cast<float>(kNearDepths * depth);
  auto share = [&](Vec3 at, Vec3 normal) {
    Vec3 offset = eye - at;
    float away = glm::length(offset);
    if (away > reach || away < 1e-6f) return 0.0f;
    auto fade = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    return fade(3 * (1 - away / reach)) * fade(3 * (glm::dot(offset, normal) / away + 0.6f));
  };
  bool near = false;
  for (std::size_t i = 0; i < wood.position.size() && !near; ++i)
    near = share(wood.position[i], wood.normal[i]) > 0;
  if (!near) return wood;
  int width = std::min(coat.pixels, 512);
  std::shared_ptr<const Grid> height = heights_of(coat, width);
  return raised(wood, {.depth = depth,
                       .facet = std::max(0.14 * depth, 0.6 * coat.wrap / width),
                       .height = [&](Vec2 uv) { return height_at(*height, uv); },
                       .share = share});
}

}  // namespace

Surface coat_surface(const Specimen& tree, const Pose& pose, Vec3 eye) {
  const BranchLook& look = tree.look.branches;
  Surface wood = tube_surface(tree.model.skeleton, pose.position, pose.radius, pose.turn,
                              look.tube_shape(tree.model.girth));
  return look.coat->furrow > 0 && !wood.triangle.empty() ? furrowed(wood, *look.coat, eye) : wood;
}

std::vector<bool> coatless(const Specimen& tree) {
  return left_out(tree.model.skeleton, tree.look.branches.tube_shape(tree.model.girth));
}

}  // namespace frond
