#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// What a solid is made of; gen/emit/solid.cpp has the macro of each.
enum class Matter {
  plain,      ///< one matt colour
  brick,      ///< fired clay, no two alike
  mortar,     ///< sandy, between bricks
  limestone,  ///< dressed, weathered
  plaster,    ///< lime, flaking
  paint,      ///< on wood
  pane        ///< a window before a dark room
};

/// The surface of a solid.
struct Material {
  Matter matter = Matter::plain;
  Color color{0.55f, 0.53f, 0.50f};
  Color second{0.35f, 0.33f, 0.30f};  ///< of what differs from the rest: veins, joints, bands
  double scale = 0.2;                 ///< metres, size of the pattern, > 0
  double relief = 0.5;                ///< depth of the pattern
  double moss = 0;                    ///< 0 none .. 1: how much grows on what faces upward
  double gloss = 0.1;                 ///< 0 matt .. 1 polished
};

/// A body of one material. Metres.
struct Solid {
  Surface surface;
  Material material;
};

/// Bodies without branches: rocks, walls, vases. Each shape is held once and may be placed often. The
/// placements are a structure of arrays.
struct Solids {
  std::vector<Solid> shapes;
  std::vector<std::uint16_t> shape;  ///< of each placement, index into `shapes`
  std::vector<Vec3> position;
  std::vector<Quat> turn;   ///< of length 1
  std::vector<Vec3> scale;  ///< along the shape's axes, each > 0

  std::size_t size() const { return position.size(); }

  /// Adds a shape and returns its index; at most 65535 of them.
  std::uint16_t add_shape(Solid solid);
  void place(std::uint16_t which, Vec3 at = Vec3(0), Quat turned = Quat(1, 0, 0, 0), Vec3 sized = Vec3(1));

  /// Where it is not what it promises: one line for the first fault, empty when all is well.
  std::string check() const;
};

/// All placements as one mesh, without `uv`: what ivy creeps on, what is measured.
Surface merged(const Solids& solids);

}  // namespace frond
