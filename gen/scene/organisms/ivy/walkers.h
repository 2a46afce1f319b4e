#pragma once

#include "core/assets.h"
#include "creeping/crawl.h"
#include "model/model.h"
#include "model/surface.h"

namespace frond {

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

/// Their shapes: a mesh has one, a beetle one for each moment of its gait.
std::vector<Prototype> walker_prototypes(const Walkers& walkers);

/// Where they are when a share 0..1 of the time has passed in which `paths` were crept: the organs of a
/// model, one on each path, its upper side along the normal of the surface, turned along its way.
Organs walkers_at(const Walkers& walkers, const Strands& paths, double share, Seed seed);

}  // namespace frond
