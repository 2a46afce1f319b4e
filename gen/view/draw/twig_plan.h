#pragma once

#include <memory>
#include <vector>

#include "light/light.h"
#include "scene/scene.h"

// Palettes of twigs
// =================
// A large tree bears some hundred thousand leaves on twigs that are a few pixels long and much alike. Instead
// of each of them some hundred twigs, the palette, are drawn in detail, and every other one as a copy of that
// which is most like it. The plan is made once, of the plant at rest and of all that the film's camera sees,
// so that no twig changes from one frame to the next.

namespace frond {

/// How twigs of a plant are replaced by copies of some of them.
struct TwigPlan {
  /// A twig of the palette.
  struct Kept {
    std::int32_t node = 0;              ///< its first node; it begins at the one below, its joint
    std::vector<std::int32_t> nodes;    ///< of the plant, parents first
    std::vector<std::uint32_t> organs;  ///< of the plant
  };
  /// Where one of the palette stands in place of a twig of the plant.
  struct Place {
    std::int32_t node = 0;    ///< the first of the twig that it stands for
    std::uint32_t organ = 0;  ///< the first of that twig's organs
    std::uint32_t kept = 0;   ///< which of the palette
    Quat turn{1, 0, 0, 0};    ///< from that one to this, at rest
    float scale = 1;          ///< by which both have the same area of leaves
  };

  std::vector<Kept> palette;
  std::vector<Place> places;         ///< by their nodes
  std::vector<char> replaced;        ///< of each organ of the plant: whether a place stands for it
  Model limbs;                       ///< the branches that are left: nothing but nodes
  std::vector<std::int32_t> origin;  ///< of each node of the limbs: its number in the plant
  double grain = 0;                  ///< metres that a pixel is at the nearest of the twigs that are replaced
};

/// The joint of a twig: the node that it grows from.
inline std::size_t joint_of(const Skeleton& rest, std::int32_t node) {
  return static_cast<std::size_t>(rest.parent[static_cast<std::size_t>(node)]);
}

/// The plan for a plant that a film's cameras see; `longest` is how many pixels a twig may be long where they
/// come nearest to it. Null where each twig is drawn by itself: where the plant is small, grows, loses its
/// leaves or carries snow, where its leaves are no pictures, as needles are not, or its twigs are near.
std::shared_ptr<const TwigPlan> twig_plan(const Specimen& plant, const std::vector<Eye>& eyes,
                                          double longest);

/// The plans of all specimens of a scene.
std::vector<std::shared_ptr<const TwigPlan>> twig_plans(const Scene& scene);

}  // namespace frond
