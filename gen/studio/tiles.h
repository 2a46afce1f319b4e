#pragma once

#include <optional>
#include <string>

#include "bake/bake.h"
#include "scene/scene.h"

namespace frond {

/// Pictures of a body's material that repeat, for the page to lay on it from three sides. Materials that
/// differ in little but their colour share them.
struct Tile {
  std::string colors, normals;  ///< names of PNG files
  double wide = 1;              ///< metres
  Vec3 light{1};                ///< linear factor of the colours
};
/// None where the material has no pattern, or a picture of its own.
std::optional<Tile> tile_of(const Material& material);

/// Draws both pictures of a material that has some.
Drawing tile_drawing(const Material& material, const BakeOptions& options);

}  // namespace frond
