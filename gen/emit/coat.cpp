#include "emit/coat.h"

#include "core/text.h"
#include "geometry/tubes.h"

namespace frond {

namespace {

TubeShape shape_of(const Specimen& tree) {
  const BarkCoat& coat = *tree.look.coat;
  TubeShape shape;
  shape.wrap = coat.wrap;
  shape.aspect = coat.aspect;
  shape.side = coat.facet;
  shape.lobes = tree.look.lobes;
  shape.lobe_depth = tree.look.lobe_depth;
  shape.least = static_cast<float>(coat.twigs);
  shape.girth = tree.model.girth;
  return shape;
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
