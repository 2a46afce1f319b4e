#include "emit/coat.h"

#include "core/text.h"
#include "geometry/tubes.h"

namespace frond {

namespace {

TubeShape shape_of(const Branches& tree) {
  const BarkCoat& coat = *tree.coat;
  TubeShape shape;
  shape.wrap = coat.wrap;
  shape.aspect = coat.aspect;
  shape.side = coat.facet;
  shape.lobes = tree.lobes;
  shape.lobe_depth = tree.lobe_depth;
  shape.least = static_cast<float>(coat.twigs);
  shape.girth = tree.girth;
  return shape;
}

}  // namespace

std::string coat_text(const PovSpace& space, const Branches& tree, const Pose& pose) {
  const BarkCoat& coat = *tree.coat;
  Surface wood = tube_surface(tree.rest, pose.position, pose.radius, pose.turn, shape_of(tree));
  if (wood.triangle.empty()) return {};
  std::string text = "object{\n";
  append_mesh(text, space, wood);
  text += "\ntexture{Tree_Bark(\"" + bark_color_name(coat) + "\",\"" + bark_height_name(coat) + "\",";
  append_list(text, 4, coat.relief, tree.brightness);
  text += ")}}\n";
  return text;
}

std::vector<bool> coatless(const Branches& tree) { return left_out(tree.rest, shape_of(tree)); }

}  // namespace frond
