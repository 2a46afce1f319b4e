#pragma once

#include "model/surface.h"

namespace frond {

/// A stalk or blade that rises from its root and bends over.
struct BladeOfGrass {
  Vec3 root;
  Vec3 toward, across;  ///< horizontal: direction in which it bends, direction of its width
  float length, droop, width;
  float own;  ///< 0..1, random number of the blade

  /// The point at `t` of 0..1 from root to tip.
  Vec3 along(float t) const {
    float reach = length * droop * t * t, height = length * t * (1 - 0.45f * droop * t);
    return root + toward * reach + Vec3(0, height, 0);
  }
};

/// The integer part of v on leaves and flowers.
enum class HerbPart { clover, herb, earth };
enum class Bloom { daisy, buttercup, clover, spike, panicle };

/// A blade of 5 triangles whose normals are those of a lawn, slightly rounded across.
void add_blade(Surface& s, const BladeOfGrass& b);

/// Three leaflets at the end of a stalk: u runs from foot to tip and is bent to draw the chevron.
void add_trefoil(Surface& s, const BladeOfGrass& stalk, float length, HerbPart kind);

/// A leaf of a rosette that rises by `rise` (sine) in the direction of the blade.
void add_rosette_leaf(Surface& s, const BladeOfGrass& b, float rise);

/// Flower heads at the end of a stalk: u from heart to rim; of a clover's head, a spike or a spikelet from
/// foot to tip.
void add_head(Surface& s, const BladeOfGrass& stalk, float radius, Bloom kind);
void add_clover_head(Surface& s, const BladeOfGrass& stalk, float radius);
void add_spike(Surface& s, const BladeOfGrass& stalk, float length);
void add_panicle(Surface& s, const BladeOfGrass& stalk, float length);

/// Bare earth about the origin with an uneven rim, which lies below the ground.
void add_earth(Surface& s, float radius, float own);
/// Factor of its radius in a horizontal direction of length 1; within 0.65 .. 1.35.
float earth_reach(Vec3 out, float own);

}  // namespace frond
