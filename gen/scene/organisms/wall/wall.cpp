#include "organisms/wall/wall.h"

#include <algorithm>

#include "geometry/crease.h"
#include "masonry/block.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr std::uint16_t kBrickShapes = 10;  // of their own wear and tone

// Blocks are boxes of size 1 that are stretched to their places. Their edges are rounded as of these, metres.
constexpr Vec3 kSillBlock(1, 0.15f, 0.28f), kFrameBar(0.05f, 0.6f, 0.05f), kPaneSheet(0.4f, 0.4f, 0.006f);
constexpr Color kDarkGlass{0.05f, 0.06f, 0.07f}, kBareWood{0.36f, 0.29f, 0.21f};

/// The shapes of bricks, of differing tone, then those of stone, wood and panes.
void add_block_shapes(Solids& solids, const WallParams& p, Seed seed) {
  constexpr double kBurnt = 0.62;  // brightness of the last one, which came out of the fire nearly black
  Vec3 stretcher = p.shape.brick;
  for (std::uint16_t i = 0; i < kBrickShapes; ++i) {
    Seed own = seed.child("brick", i);
    Material clay{Matter::brick};
    double burnt = i == kBrickShapes - 1 ? kBurnt : 1;
    clay.color = toned(p.bricks[i % p.bricks.size()], burnt * own.child(0).range(0.86, 1.14),
                       own.child(1).range(-0.05, 0.05));
    clay.second = p.mortar;
    clay.scale = 0.03, clay.relief = 0.5, clay.moss = p.weathering, clay.gloss = 0.05;
    solids.add_shape({worn_block(stretcher, p.shape.wear, own), clay});
  }
  Material stone{Matter::limestone, p.stone, toned(p.stone, 0.6, 0)}, wood{Matter::paint, p.paint},
      pane{Matter::pane, kDarkGlass};
  stone.moss = wood.moss = p.weathering;
  stone.scale = 0.12;
  wood.scale = 0.03, wood.second = kBareWood;
  solids.add_shape({worn_block(kSillBlock, 0.8 * p.shape.wear, seed.child("stone")), stone});
  solids.add_shape({worn_block(kFrameBar, 0, seed.child("wood")), wood});
  solids.add_shape({worn_block(kPaneSheet, 0, seed.child("pane")), pane});
}

std::uint16_t shape_of(WallPart part, Seed seed) {
  switch (part) {
    case WallPart::brick:
      return static_cast<std::uint16_t>(seed.bits() % kBrickShapes);
    case WallPart::stone:
      return kBrickShapes;
    case WallPart::wood:
      return kBrickShapes + 1;
    case WallPart::pane:
      return kBrickShapes + 2;
  }
  return 0;
}

/// Adds a wall, moved there; the shapes of its blocks are those of the model already.
void add_wall(Model& model, const WallParams& params, Seed seed, Vec3 foot, Quat turn) {
  Wall wall = build_wall(params.shape, seed.child("wall"));
  for (std::size_t i = 0; i < wall.blocks.size(); ++i) {
    const WallBlock& block = wall.blocks[i];
    model.solids.place(shape_of(block.part, seed.child("tone", i)), foot + turn * block.middle,
                       turn * block.turn, block.size);
  }
  Material mortar{Matter::mortar, params.mortar, toned(params.mortar, 0.55, 0.02)};
  mortar.scale = 0.05, mortar.moss = params.weathering;
  model.solids.place(model.solids.add_shape({creased(wall.mortar, radians(40.0)), mortar}), foot, turn);
  for (const auto& triangle : wall.hull.triangle) {
    auto paint = [&](std::uint32_t corner) {
      const Vec3& at = wall.hull.position[corner];
      return Vec3(0.5 + at.x / params.shape.width, at.y / params.shape.height, kUnpainted.z);
    };
    wall.hull.paint.push_back({paint(triangle[0]), paint(triangle[1]), paint(triangle[2])});
  }
  for (Vec3& p : wall.hull.position) p = foot + turn * p;
  for (Vec3& n : wall.hull.normal) n = turn * n;
  append(model.hull, wall.hull);
}

Vec2 along(const PlaceLine& line) { return Vec2(std::cos(line.turn), -std::sin(line.turn)); }

/// Whether a line across this one ends where this one does, on the side of that sign.
bool meets_at(std::span<const PlaceLine> lines, const PlaceLine& line, double side) {
  constexpr float kAcross = 0.5f;      // most cosine of the angle between them: 60 degrees at least
  constexpr float kSamePlace = 0.01f;  // metres
  auto end_of = [](const PlaceLine& l, double sign) {
    return l.at + static_cast<float>(sign * l.length / 2) * along(l);
  };
  return std::ranges::any_of(lines, [&](const PlaceLine& other) {
    auto nearest = std::min(glm::distance(end_of(other, 1), end_of(line, side)),
                            glm::distance(end_of(other, -1), end_of(line, side)));
    return std::abs(glm::dot(along(other), along(line))) < kAcross && nearest < kSamePlace;
  });
}

/// Walls along lines that are level, each as high in the ground as its middle. Where two meet, the one along
/// x fills the corner.
Model build_walls(const WallParams& params, const World& world, const Planting& planting, Seed seed) {
  Model model;
  add_block_shapes(model.solids, params, seed.child("shapes"));
  for (std::size_t i = 0; i < planting.lines.size(); ++i) {
    const PlaceLine& line = planting.lines[i];
    WallParams own = params;
    double corner = std::abs(along(line).x) > 0.5f ? params.shape.thickness / 2 : 0;
    double before = meets_at(planting.lines, line, -1) ? corner : 0,
           behind = meets_at(planting.lines, line, 1) ? corner : 0;
    own.shape.width = line.length + before + behind;
    Vec2 at = line.at + static_cast<float>((behind - before) / 2) * along(line);
    double height = world.height(at) - world.height({planting.foot.x, planting.foot.z});
    add_wall(model, own, seed.child("line", i), Vec3(at.x, height, at.y),
             glm::angleAxis(static_cast<float>(line.turn), Vec3(0, 1, 0)));
  }
  return model;
}

}  // namespace

Model build_wall_model(const WallParams& params, Seed seed) {
  Model model;
  add_block_shapes(model.solids, params, seed.child("shapes"));
  add_wall(model, params, seed, Vec3(0), Quat(1, 0, 0, 0));
  return model;
}

inline constexpr Choice<WallHole> kWallHoles[] = {{"window", WallHole::window, "with frame and panes"},
                                                  {"door", WallHole::door, "down to the ground, of planks"},
                                                  {"gap", WallHole::gap, "nothing stands in it"}};

void describe(Properties& v, WallOpening& o) {
  v.choice("kind", o.kind, kWallHoles, "What stands in the opening");
  v.number("at", o.at, metres(-50, 50), "Where its middle is, from the middle of the wall along it");
  v.number("sill", o.sill, metres(0, 50), "Height of its lower edge; a door has none");
  v.number("width", o.width, metres(0.2, 20), "Width of the opening");
  v.number("height", o.height, metres(0.2, 20), "Height of the opening");
}

void describe(Properties& v, WallParams& w) {
  WallShape& s = w.shape;
  v.number("width", s.width, metres(0.1, 30), "Length of the wall");
  v.number("height", s.height, metres(0.1, 15), "Height without the coping, rounded to whole courses");
  v.number("thickness", s.thickness, metres(0.05, 2), "Thickness from face to face");
  v.vector("brick", s.brick, metres(0.03, 1), "Length, height and depth of a brick");
  v.number("joint", s.joint, metres(0.002, 0.03), "Thickness of the mortar between bricks");
  v.number("recess", s.recess, metres(0, 0.02), "How far the mortar lies behind the bricks' faces");
  v.number("wear", s.wear, kShare, "How worn the bricks are: 0 as new, 1 chipped and askew");
  v.number("ruin", s.ruin, {.min = 0, .max = 0.95}, "Share of its height that has fallen down at most");
  v.boolean("coping", s.coping,
            "Whether a top course of bricks stands on edge, where nothing has fallen down");
  v.list("openings", s.openings, "Windows, doors and gaps in the wall");
  v.list("bricks", w.bricks, Count{1, 64}, "Colours of the bricks");
  v.color("mortar", w.mortar, "Colour of the mortar");
  v.color("stone", w.stone, "Colour of sills and lintels");
  v.color("paint", w.paint, "Colour of windows and doors");
  v.number("weathering", w.weathering, kShare, "How much soot, damp and moss there is");
  v.aspect(Aspect::look, "bricks", "mortar", "stone", "paint", "weathering");
}

namespace {

class WallGrower final : public Described<WallParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"width",  "height", "thickness", "openings",
                                                  "coping", "ruin",   "wear",      "weathering",
                                                  "bricks", "mortar", "paint"};

  Review review() const override { return {}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kBlockTriangles = 18'000;  // of all shapes of blocks together
    const WallShape& w = params.shape;
    return SizeEstimate{.triangles = kBlockTriangles,
                        .blocks = w.width * w.height / ((w.brick.x + w.joint) * (w.brick.y + w.joint))};
  }
  Result<Model> grow_alone(Seed seed) const override { return build_wall_model(params, seed); }
  Result<Model> grow_standing(const World& world, const Planting& planting, const Placement&,
                              Seed seed) const override {
    return planting.lines.empty() ? grow_alone(seed) : build_walls(params, world, planting, seed);
  }
  std::shared_ptr<const Grower> as_long_as(double length) const override {
    return changed(*this, [&](WallParams& own) { own.shape.width = length; });
  }
};

}  // namespace

Kind<Organism> wall_kind() {
  return make_grower<WallGrower>("wall", "A wall of bricks with windows and doors, or its ruin");
}

}  // namespace frond
