#pragma once

#include <optional>
#include <string>
#include <vector>

#include "appearance/appearance.h"
#include "core/assets.h"
#include "core/result.h"
#include "core/seed.h"
#include "creeping/swing.h"
#include "creeping/tendrils.h"
#include "creeping/triangle_surface.h"
#include "model/model.h"
#include "motion/motion.h"

namespace frond {

struct Support;

enum class IvyDetail {
  fitting,  ///< single leaves up to kMostSingleLeaves, sprigs for more
  leaves,   ///< single leaves, each on its own petiole
  sprigs    ///< several leaves together, for distant ivy
};
inline constexpr std::size_t kMostSingleLeaves = 25'000;

/// Leaves of ivy.
struct IvyLeaves {
  double size = 0.062;           ///< metres, length of a grown blade
  double size_variation = 0.22;  ///< random change of it, as a share
  double spacing = 0.035;        ///< metres along a strand from leaf to leaf
  double bare = 0.25;            ///< metres above the root without leaves
  double overlap = 0.35;         ///< share of a leaf that others may cover; a leaf covered more is dropped
  Vec3 light{0.25f, 1, 0.6f};    ///< toward the light
  double turn = 0.4;             ///< 0 flat on the surface .. 1 square to the light
  double adult = 0.15;           ///< share of the oldest shoots that bear heart-shaped leaves
  double young_length = 0.35;    ///< metres below a tip in which leaves are small and fresh
  IvyDetail detail = IvyDetail::fitting;
  std::vector<Color> colors{
      {0.20f, 0.31f, 0.09f}, {0.26f, 0.37f, 0.11f}, {0.16f, 0.27f, 0.09f}, {0.31f, 0.40f, 0.13f}};
  Color young{0.42f, 0.54f, 0.20f};  ///< of leaves near the tips
  Color bud{0.58f, 0.62f, 0.34f};    ///< initial colour of leaves while they unfold
  Color veins{0.66f, 0.72f, 0.50f};
  double unfold = 0.18;             ///< share of the growth in which a leaf unfolds
  std::optional<LeafLook> picture;  ///< another climber's leaf, in place of the shapes of ivy and its colours
};

/// Bodies that creep over a host and leave nothing behind.
struct Walkers {
  FileName file;       ///< of a mesh; empty: a beetle
  Surface mesh;        ///< content of the file, one unit long, y up; it walks toward +z
  double size = 0.02;  ///< metres, its length
  double size_variation = 0.15;
  std::vector<Color> colors{{0.07f, 0.13f, 0.08f}, {0.16f, 0.05f, 0.03f}, {0.05f, 0.07f, 0.14f}};
  Color second{0.03f, 0.025f, 0.02f};  ///< of a beetle's legs, head and feelers
  double gloss = 0.7;
};

/// Ivy on other bodies.
struct IvyParams {
  std::vector<std::string> on;  ///< names of the organisms that it grows on; none: all bodies
  Vec3 facing{0};               ///< direction of the host's surface at roots without a given place
  double above = 0.02;          ///< metres above the host's lowest point of such roots
  Crawl crawl;
  IvyLeaves leaves;
  std::optional<Tendrils> tendrils;  ///< none without it
  Walkers walkers;                   ///< where `crawl` leaves no trace
  Bark bark{BarkKind::bark, {{0.31f, 0.25f, 0.18f}, {0.29f, 0.27f, 0.16f}, {0.33f, 0.31f, 0.15f}}};
  Flutter flutter;
  Breeze breeze;
  Growth growth;
};

/// The foot of each ivy: x, z, and the height of the ground there.
using IvyRoots = std::vector<Vec3>;

/// A grown ivy, in the world of its host.
struct Ivy {
  Model model;
  Strands strands;
};

/// Grows over a host: `count` plants, the first ones from the points of the host nearest to `roots`, the
/// others from the beginnings of guides or, without any, from its foot, and from all over what a mask leaves
/// where it stops them there; none where it stops them everywhere. No part is below the ground. Where
/// `crawl` leaves no trace, the strands are the paths of walkers, which begin all over the host, and the
/// model holds these at the end of their paths.
Result<Ivy> grow_ivy(const IvyParams& params, const TriangleSurface& host, const IvyRoots& roots, int count,
                     const GroundHeight& ground, Seed seed);

/// Adds leaves to strands: sites along them, arranged as a mosaic (foliage/mosaic.h), each leaf turned until
/// it lies on the surface below. Sets prototypes and organs of the model. Returns the number of single
/// leaves, counting each leaf of a sprig.
std::size_t add_ivy_leaves(Model& model, const Strands& strands, const IvyLeaves& leaves,
                           const Support& under, Seed seed);

/// Their shapes: a mesh has one, a beetle one for each moment of its gait.
std::vector<Prototype> walker_prototypes(const Walkers& walkers);

/// Where they are when a share 0..1 of the time has passed in which `paths` were crept: the organs of a
/// model, one on each path, its upper side along the normal of the surface, turned along its way.
Organs walkers_at(const Walkers& walkers, const Strands& paths, double share, Seed seed);

}  // namespace frond
