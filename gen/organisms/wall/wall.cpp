#include "organisms/wall/wall.h"

#include "geometry/crease.h"
#include "masonry/tone.h"

namespace frond {

namespace {

constexpr std::uint16_t kBrickShapes = 10;  // of their own wear and tone

/// The shapes of bricks, of differing tone, then those of stone, wood and panes.
void add_block_shapes(Solids& solids, const WallParams& p, Seed seed) {
  Vec3 stretcher = p.shape.brick;
  for (std::uint16_t i = 0; i < kBrickShapes; ++i) {
    Seed own = seed.child("brick", i);
    Material clay{Matter::brick};
    // One in ten came out of the fire nearly black.
    double burnt = i == kBrickShapes - 1 ? 0.62 : 1;
    clay.color = toned(p.bricks[i % p.bricks.size()], burnt * own.child(0).range(0.86, 1.14),
                       own.child(1).range(-0.05, 0.05));
    clay.second = p.mortar;
    clay.scale = 0.03, clay.relief = 0.5, clay.moss = p.weathering, clay.gloss = 0.05;
    solids.add_shape({worn_block(stretcher, p.shape.wear, own), clay});
  }
  Material stone{Matter::limestone, p.stone, toned(p.stone, 0.6, 0)}, wood{Matter::paint, p.paint},
      pane{Matter::pane, {0.05f, 0.06f, 0.07f}};
  stone.moss = wood.moss = p.weathering;
  stone.scale = 0.12;
  wood.scale = 0.03, wood.second = {0.36f, 0.29f, 0.21f};
  solids.add_shape({worn_block(Vec3(1, 0.15f, 0.28f), 0.8 * p.shape.wear, seed.child("stone")), stone});
  solids.add_shape({worn_block(Vec3(0.05f, 0.6f, 0.05f), 0, seed.child("wood")), wood});
  solids.add_shape({worn_block(Vec3(0.4f, 0.4f, 0.006f), 0, seed.child("pane")), pane});
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

}  // namespace

Model build_wall_model(const WallParams& params, Seed seed) {
  Wall wall = build_wall(params.shape, seed.child("wall"));
  Model model;
  add_block_shapes(model.solids, params, seed.child("shapes"));
  for (std::size_t i = 0; i < wall.blocks.size(); ++i) {
    const WallBlock& block = wall.blocks[i];
    model.solids.place(shape_of(block.part, seed.child("tone", i)), block.middle, block.turn, block.size);
  }
  Material mortar{Matter::mortar, params.mortar, toned(params.mortar, 0.55, 0.02)};
  mortar.scale = 0.05, mortar.moss = params.weathering;
  model.solids.place(model.solids.add_shape({creased(wall.mortar, radians(40.0)), mortar}));
  model.hull = std::move(wall.hull);
  return model;
}

}  // namespace frond
