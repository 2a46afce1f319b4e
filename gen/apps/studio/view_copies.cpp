#include "scene/copies.h"
#include "studio/tiles.h"
#include "studio/view.h"

namespace frond {

namespace {

/// How finely copies are drawn; coarser than for a picture, as there may be ten thousand before a slow
/// display.
constexpr CopyDetail kLevels[] = {{0.012, 2.5e4}, {0.08, 5e3}, {0.4, 800}, {1.6, 120}};

constexpr std::size_t kNear = 2;  // levels that show the bark

/// What leaves are coloured by: the whole part of each corner's u.
std::vector<std::uint8_t> leaf_colors(const Surface& leaves, const std::vector<Color>& colors) {
  std::vector<std::uint8_t> painted;
  painted.reserve(4 * leaves.uv.size());
  for (Vec2 uv : leaves.uv) push(painted, colors[color_index(uv, colors.size())]);
  return painted;
}

/// Adds the wood of one of the barks; with a picture of the bark where it is `near`, as its mesh says or from
/// three sides.
void add_wood(DrawnPart& part, const std::string& below, const Look& look, std::size_t which,
              const Surface& surface, bool near) {
  Surface plain = surface;
  Json& material = part.head[Json::json_pointer(below + "/material")];
  const std::size_t color = look.branches.color_of(which);
  material = material_json({.color = look.branches.plain(color, 1), .gloss = look.branches.gloss(color)});
  std::optional<Tile> tile = near ? tile_of(look.branches, color) : std::nullopt;
  if (tile) {
    tile->unrolled = look.branches.coat_of(color) != nullptr;
    material["tile"] = json_of(*tile);
  }
  if (!tile || !tile->unrolled) plain.uv.clear();
  part.add_surface(below, plain);
}

void add_leaves(DrawnPart& part, const std::string& below, const Look& look, const Model& model,
                CopyPart& leaves) {
  bool blade = leaves.kind == CopyPart::Kind::blade;
  const Prototype* prototype = blade ? nullptr : &model.prototypes[leaves.which];
  const OrganPart* organ = blade ? nullptr : &prototype->parts[leaves.part];
  PlainLook plain = blade ? plain_look(look.blades, 0) : plain_look(*prototype, leaves.part, 0);
  part.head[Json::json_pointer(below + "/material")] = material_json(plain);
  bool heart = organ && organ->tissue == Tissue::heart;
  const std::vector<Color> second{plain.color};
  const std::vector<Color>& colors = blade ? look.blades.colors : heart ? second : prototype->colors;
  std::vector<std::uint8_t> painted = leaf_colors(leaves.surface, colors);
  for (Vec2& uv : leaves.surface.uv) uv.x -= std::floor(uv.x);
  part.add_surface(below, leaves.surface);
  if (plain.picture.empty() && !painted.empty()) part.add(below + "/colors", painted);
}

DrawnPart model_part(const Look& look, const Model& model) {
  DrawnPart part;
  part.head["kind"] = "copies";
  part.head["levels"] = Json::array();
  for (std::size_t level = 0; level < std::size(kLevels); ++level) {
    part.head["levels"].push_back({{"grain", kLevels[level].grain}, {"parts", Json::array()}});
    std::size_t number = 0;
    for (CopyPart& shape : copy_parts(look, model, kLevels[level])) {
      if (shape.surface.triangle.empty()) continue;
      std::string below = "/levels/" + std::to_string(level) + "/parts/" + std::to_string(number++);
      part.head[Json::json_pointer(below)] = Json::object();
      if (shape.kind == CopyPart::Kind::wood) {
        add_wood(part, below, look, shape.which, shape.surface, level < kNear);
      } else if (shape.kind == CopyPart::Kind::solid) {
        part.head[Json::json_pointer(below + "/material")] =
            material_json(plain_look(model.solids.shapes[shape.which].material));
        shape.surface.uv.clear();
        part.add_surface(below, shape.surface);
      } else {
        add_leaves(part, below, look, model, shape);
      }
    }
  }
  return part;
}

}  // namespace

Result<std::shared_ptr<const DrawnPart>> ViewCache::model(const CopySet& set, int which) {
  std::string name = copy_id(set.organism, which);
  if (auto kept = models_.find(name)) return kept;
  Result<Model> grown = grow_copy(set.organism, which);
  if (!grown) return grown.errors();
  auto part = std::make_shared<const DrawnPart>(model_part(set.appearance.look, *grown));
  models_.put(name, part, part->bytes());
  return part;
}

}  // namespace frond
