#pragma once

#include <optional>
#include <string>

#include "appearance/appearance.h"
#include "bake/bake.h"
#include "scene/scene.h"
#include "studio/packet.h"

namespace frond {

/// Pictures of what something is made of, for the page to lay on it: from three sides, along branches, or
/// unrolled. Materials that differ in little but their colour share them.
struct Tile {
  std::string colors, normals;  ///< names of PNG files; unrolled ones have no normals
  double wide = 1, high = 1;    ///< metres after which they repeat
  Vec3 light{1};                ///< linear factor of the colours
  bool varied = false;          ///< the colours, with their light, are a factor of what is plain
  bool unrolled = false;        ///< it lies as the mesh's `uv` say
};
/// The tile of a material, which repeats. None where the material has no pattern, or a picture of its own, or
/// is that of a vessel.
std::optional<Tile> tile_of(const Material& material);
/// The tile of any body: that of its material, or of a vessel one that is unrolled.
std::optional<Tile> tile_of(const Solid& body);
/// The tile of branches of one colour, none where that has no pattern. It varies their plain colours,
/// whatever these are.
std::optional<Tile> tile_of(const BranchLook& branches, std::size_t color = 0);

/// The tile of a setting's floor that nothing covers; it repeats. None of any other floor.
std::optional<Tile> tile_of(const SceneSetup& setup);

/// Draws the upper half of a scene's sky, where that stays, see emit/setting.h.
std::optional<Drawing> sky_drawing(const Scene& scene, const BakeOptions& options);

/// Draws both pictures of what has some.
Drawing tile_drawing(const SceneSetup& setup, const BakeOptions& options);
Drawing tile_drawing(const Material& material, const BakeOptions& options);
Drawing tile_drawing(const Solid& body, const BakeOptions& options);
Drawing tile_drawing(const BranchLook& branches, const BakeOptions& options, std::size_t color = 0);

/// A tile as the page reads it.
Json json_of(const Tile& tile);

}  // namespace frond
