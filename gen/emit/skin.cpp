#include "emit/skin.h"

#include <algorithm>

#include "core/text.h"
#include "emit/plant.h"
#include "geometry/tubes.h"

namespace frond {

namespace {

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
  if (std::max(chunk.young_from, chunk.young_to) < 0.01f || length2 < 1e-10f) {
    text += "Skin[";
    append_integer(text, static_cast<long long>(index));
    text += ']';
    return;
  }
  Vec3 slope = way * ((chunk.young_to - chunk.young_from) / length2);
  double at_zero = chunk.young_from - glm::dot(slope, from), unit = space.unit;
  text += b.look.bark ? "Plant_Tip(" : "Coral_Tip(";
  append_integer(text, static_cast<long long>(index));
  text += ',';
  append_list(text, 5, slope.x / unit, slope.y / unit, -slope.z / unit, at_zero);
  text += ')';
}

}  // namespace

void append_chunk_texture(std::string& text, const PovSpace& space, const Specimen& b, const Pose& pose,
                          Chunk chunk, std::size_t index) {
  bool plain = b.look.bark && !patterned(*b.look.bark);
  text += "texture{";
  append_skin(text, space, b, pose, chunk, index);
  if (b.look.bark && (ringed(*b.look.bark) || slanted(b, chunk))) lay_along(b.model.skeleton, chunk);
  if (chunk.moved() && !plain) append_matrix(text, space, chunk.matrix, chunk.shift);
  text += '}';
}

namespace {

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

}  // namespace

std::string coat_text(const PovSpace& space, const Specimen& tree, const Pose& pose) {
  const BarkCoat& coat = *tree.look.coat;
  Surface wood = tube_surface(tree.model.skeleton, pose.position, pose.radius, pose.turn, shape_of(tree));
  if (wood.triangle.empty()) return {};
  std::string text = "object{\n";
  append_mesh(text, space, wood);
  text += "\ntexture{Tree_Bark(\"" + bark_color_name(coat) + "\",\"" + bark_height_name(coat) + "\",";
  append_list(text, 4, coat.relief, tree.brightness);
  text += ")}}\n";
  return text;
}

std::vector<bool> coatless(const Specimen& tree) { return left_out(tree.model.skeleton, shape_of(tree)); }

}  // namespace frond
