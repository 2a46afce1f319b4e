#include "emit/skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/bytes.h"
#include "core/lru_cache.h"
#include "core/text.h"
#include "emit/plant.h"
#include "geometry/relief.h"
#include "geometry/tubes.h"
#include "scene/bleaching.h"

namespace frond {

namespace {

/// What is left of its light at both ends of a chunk; it is taken by neighbours that grow as it does.
std::array<float, 2> light_along(const Specimen& b, const Pose& pose, const Chunk& chunk) {
  const std::vector<float>& light = b.model.light;
  float shaded = std::clamp((pose.front - 0.5f) / 0.4f, 0.0f, 1.0f);
  if (light.empty() || shaded <= 0) return {1, 1};
  auto from = static_cast<std::size_t>(b.model.skeleton.parent[static_cast<std::size_t>(chunk.first)]);
  return {light[from] / shaded, light[static_cast<std::size_t>(chunk.last)] / shaded};
}

/// What stands inside the texture of a chunk: the old skin, or near a tip one that grows younger along the
/// chunk.
void append_skin(std::string& text, const PovSpace& space, const Specimen& b, const Pose& pose,
                 const Chunk& chunk, std::size_t index) {
  const Skeleton& rest = b.model.skeleton;
  if (b.look.bark) index += bark_color(b, chunk.first);
  Vec3 from = rest.position[rest.parent[chunk.first]], to = rest.position[chunk.last];
  if (rest.birth[chunk.last] > pose.front) {
    // Where the growing tip is on its way from the node below.
    std::int32_t below = rest.parent[chunk.last];
    float way = (pose.front - rest.birth[below]) / (rest.birth[chunk.last] - rest.birth[below]);
    to = glm::mix(rest.position[below], to, way);
  }
  Vec3 way = to - from;
  float length2 = glm::dot(way, way);
  // What goes from one value to another along the chunk.
  auto append_slope = [&](float start, float end) {
    Vec3 slope = way * ((end - start) / length2);
    double at_zero = start - glm::dot(slope, from), unit = space.unit;
    text += ',';
    append_list(text, 5, slope.x / unit, slope.y / unit, -slope.z / unit, at_zero);
  };
  auto append_macro = [&](std::string_view name) {
    text += name;
    append_integer(text, static_cast<long long>(index));
  };
  if (std::array<float, 2> light = light_along(b, pose, chunk);
      std::min(light[0], light[1]) < kLivingLight && length2 >= 1e-10f) {
    append_macro("Coral_Starved(");
    append_slope(chunk.young_from, chunk.young_to);
    append_slope(light[0], light[1]);
    text += ')';
  } else if (std::max(chunk.young_from, chunk.young_to) < 0.01f || length2 < 1e-10f) {
    append_macro("Skin[");
    text += ']';
  } else {
    append_macro(b.look.bark ? "Plant_Tip(" : "Coral_Tip(");
    append_slope(chunk.young_from, chunk.young_to);
    text += ')';
  }
}

}  // namespace

void append_chunk_texture(std::string& text, const PovSpace& space, const Specimen& b, const Pose& pose,
                          Chunk chunk, std::size_t index) {
  bool plain = b.look.bark && !patterned(*b.look.bark);
  text += "texture{";
  append_skin(text, space, b, pose, chunk, index);
  if (b.look.bark && (ringed(*b.look.bark) || slanted(b, chunk))) lay_along(b.model.skeleton, chunk);
  // Where a branch is too thin for one there is no pattern to be seen.
  if (chunk.moved() && !plain) static_cast<void>(append_matrix(text, space, chunk.matrix, chunk.shift));
  text += '}';
}

namespace {

constexpr double kNearDepths = 90;  // how many depths of a furrow away it shows that it is one

TubeShape shape_of(const Specimen& tree) {
  const BarkCoat& coat = *tree.look.coat;
  return {.wrap = coat.wrap,
          .aspect = coat.aspect,
          .side = coat.facet,
          .lobes = tree.look.lobes,
          .lobe_depth = tree.look.lobe_depth,
          .least = static_cast<float>(coat.twigs),
          .girth = tree.model.girth};
}

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
    Vec3 way = eye - at;
    float away = glm::length(way);
    if (away > reach || away < 1e-6f) return 0.0f;
    auto fade = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    return fade(3 * (1 - away / reach)) * fade(3 * (glm::dot(way, normal) / away + 0.6f));
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

ObjectText coat_text(const PovSpace& space, const Specimen& tree, const Pose& pose, Vec3 eye) {
  const BarkCoat& coat = *tree.look.coat;
  Surface wood = tube_surface(tree.model.skeleton, pose.position, pose.radius, pose.turn, shape_of(tree));
  if (!has_faces(wood)) return {};
  if (coat.furrow > 0) wood = furrowed(wood, coat, eye);
  std::string text = "object{\n";
  append_mesh(text, space, wood);
  text += "\ntexture{Tree_Bark(\"" + bark_color_name(coat) + "\",\"" + bark_height_name(coat) + "\",";
  append_list(text, 4, coat.relief, tree.brightness);
  text += ")}";
  if (coat.moss > 0) {
    text += "\ntexture{Tree_Moss(";
    append_list(text, 4, coat.moss, coat.moss_height, pose.position[0].y);
    text += ")}";
  }
  return {text + "}\n", 1};
}

std::vector<bool> coatless(const Specimen& tree) { return left_out(tree.model.skeleton, shape_of(tree)); }

}  // namespace frond
