#pragma once

#include <span>

#include "export/export_scene.h"
#include "motion/motion.h"

namespace frond {

/// Where the surface of branches is in another pose: each vertex keeps its place on the branch, whose node it
/// has, and is as much nearer to its middle line as the branch is thinner there. What growth has not reached
/// yet lies in the growing tip.
ExportShift carried_on(const Skeleton& rest, const Pose& from, const Pose& to, const Surface& surface,
                       std::span<const std::int32_t> node);

/// How the vertices of a surface differ from those of another one of the same triangles.
ExportShift shift_between(const Surface& from, const Surface& to);

inline constexpr double kAllTriangles = 1e18;

/// A surface with about so many triangles, and which vertex of the whole each of its own is.
struct Simplified {
  Surface surface;
  std::vector<std::uint32_t> source;

  /// Another surface, with the vertices of the whole in other places, reduced to those of `surface`.
  Surface of(const Surface& other) const;
};
Simplified drawn_with(const Surface& whole, double triangles);

/// Adds what leads from the vertices of a part, from `first` on, to where they are at a key, as a placement
/// has `there`.
void append_shift(ExportPart& part, std::size_t key, std::size_t first, const Surface& there,
                  const ExportPlacement& placement);

/// Takes the shifts from parts none of which moves by more than a hair.
void leave_out_still(std::vector<ExportPart>& parts);

}  // namespace frond
