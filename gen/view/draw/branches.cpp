#include "draw/branches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/bytes.h"
#include "core/lru_cache.h"
#include "field/cubes.h"
#include "geometry/relief.h"
#include "world/other_barks.h"

namespace frond {

namespace {

constexpr double kShown = 0.6;  // of the bark's scale: thinner branches are too thin to show it

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

BranchForm DrawnBranches::form() const {
  if (!look().drawn()) return BranchForm::none;
  if (traits.style.build != Build::sweeps) return BranchForm::body;
  return look().coat ? BranchForm::coat : BranchForm::sweeps;
}

ChunkOptions DrawnBranches::chunk_options() const {
  constexpr double kSlide = 0.15;  // of the pattern, by which it may slide on the skin
  constexpr int kRings = 5;        // nodes, so that rings lie across also where it bends
  ChunkOptions options;
  if (!look().drawn()) return options;
  options.tolerance = look().patterned() ? static_cast<float>(kSlide * look().pattern_size())
                                         : std::numeric_limits<float>::infinity();
  options.young_length = static_cast<float>(look().young_length());
  if (look().bark) options.color = model.color;
  if (look().ringed()) options.nodes = kRings;
  // In a swaying tree only thick branches have a bark that one could see slide.
  if (traits.motion.limbs && !one_texture()) options.thin = static_cast<float>(kShown * look().bark_scale());
  return options;
}

bool DrawnBranches::slanted(const Chunk& chunk) const {
  const Skeleton& s = rest();
  if (look().skin || !look().patterned() ||
      s.radius[static_cast<std::size_t>(chunk.first)] < kShown * look().pattern_size())
    return false;
  Vec3 offset = s.position[static_cast<std::size_t>(chunk.last)] -
                s.position[static_cast<std::size_t>(s.parent[static_cast<std::size_t>(chunk.first)])];
  return std::abs(offset.y) < 0.9f * glm::length(offset);
}

bool DrawnBranches::one_texture() const {
  if (!look().bark || look().ringed() || look().young_length() > 0 ||
      (!model.color.empty() && look().colors() > 1))
    return false;
  return !look().patterned() || (!traits.motion.sways() && traits.motion.growth.duration <= 0);
}

TubeShape DrawnBranches::tube_shape(double pixel) const {
  TubeShape shape = look().tube_shape(model.girth);
  shape.grain = pixel;
  // A twig of half a pixel shows no picture.
  if (shape.least > 0) shape.least = std::max(shape.least, static_cast<float>(pixel / 2));
  return shape;
}

std::vector<std::pair<const BarkCoat*, Surface>> DrawnBranches::coat_surfaces(Vec3 eye, double pixel) const {
  TubeShape shape = tube_shape(pixel);
  if (bark_changes_within(look(), model)) shape.grain = 0;
  std::vector<Surface> woods =
      by_bark(look(), model, tube_mesh(rest(), pose.position, pose.radius, pose.turn, shape));
  std::vector<std::pair<const BarkCoat*, Surface>> coats;
  for (std::size_t k = 0; k < woods.size(); ++k) {
    const BarkCoat* coat = look().coat_of(look().color_of(k));
    if (!coat || woods[k].triangle.empty()) continue;
    coats.emplace_back(coat, coat->furrow > 0 ? furrowed(woods[k], *coat, eye) : std::move(woods[k]));
  }
  return coats;
}

std::vector<bool> DrawnBranches::coatless(double pixel) const {
  std::vector<bool> out = left_out(rest(), tube_shape(pixel));
  if (look().others.empty()) return out;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (!look().coat_of(look().color_at(model, static_cast<std::int32_t>(i)))) out[i] = true;
  return out;
}

BranchVolume DrawnBranches::boughs_at(const std::vector<Vec3>& position) const {
  BranchVolume boughs;
  add_boughs(boughs, rest(), position, pose.radius, pose.front, static_cast<float>(traits.style.blend));
  return boughs;
}

std::vector<Vec3> DrawnBranches::unmoved() const {
  std::vector<Vec3> position = rest().position;
  for (std::size_t i = 0; i < position.size(); ++i) {
    auto p = static_cast<std::size_t>(rest().parent[i]);
    if (rest().parent[i] == Skeleton::kRoot || rest().birth[i] <= pose.front) continue;
    position[i] = position[p] + glm::conjugate(pose.turn[i]) * (pose.position[i] - pose.position[p]);
  }
  return position;
}

Result<FusedMesh> DrawnBranches::body() const {
  bool rough = traits.style.build == Build::rough;
  std::vector<Vec3> unmoved_at = rough ? unmoved() : std::vector<Vec3>();
  BranchVolume limbs = rough ? boughs_at(unmoved_at) : boughs();
  if (limbs.cones.empty()) return FusedMesh{};
  if (rough) return roughen(limbs, volume(), {unmoved_at, pose.position, pose.turn});
  if (traits.style.build == Build::fused) return fuse(limbs, volume());
  Result<Cubes> cubes = cubes_of(limbs, volume());
  if (!cubes) return cubes.errors();
  FusedMesh mesh;
  std::vector<std::uint32_t> cube;
  mesh.surface = cubes_surface(*cubes, cube);
  // Each face has four corners of its own.
  for (std::uint32_t c : cube) mesh.node.insert(mesh.node.end(), 4, cubes->node[c]);
  return mesh;
}

BranchColors::BranchColors(const DrawnBranches& branches)
    : branches_(branches),
      young_length_(static_cast<float>(branches.look().young_length())),
      longest_(branches.rest().longest()) {
  Built built = branches.traits.style.build == Build::voxels ? Built::cubes : Built::branches;
  for (std::size_t k = 0; k < branches.look().colors(); ++k) {
    old_.push_back(branches.look().plain(k, branches.traits.brightness));
    young_.push_back(branches.look().young(k, branches.traits.brightness, built));
  }
}

Color BranchColors::at(std::int32_t i, std::int32_t of) const {
  std::size_t k = branches_.look().color_at(branches_.model, of);
  float young = youth(branches_.rest(), branches_.pose, longest_, young_length_, i);
  return young > 0 ? mixed(old_[k], young_[k], young) : old_[k];
}

}  // namespace frond
