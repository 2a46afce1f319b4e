#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The field of a blob as a function of d^2, the squared distance from its middle in radii; r is its largest
/// radius. Each is 1 in the middle and decreases; the last two end at d = r.
enum class Falloff : std::uint8_t {
  gaussian,  ///< exp(-r d^2) (Blinn 1982)
  soft,      ///< 1 - 4 d^6/9r^6 + 17 d^4/9r^4 - 22 d^2/9r^2 (Wyvill, McPheeters and Wyvill 1986)
  cubic,     ///< (1 - d^2/r^2)^3
};

/// One ellipsoid of an implicit surface.
struct Blob {
  DVec3 radius{1};  ///< along x, y and z, each > 0
  DVec3 center{0};  ///< in radii: the middle is at radius * center
};

/// The implicit surface f(p) = 0, where f is the sum of the fields of all blobs minus `level`; f > 0 inside.
/// A single blob at level 1 has no inside: its field is 1 only in its middle.
struct Blobs {
  std::vector<Blob> blobs;
  Falloff falloff = Falloff::gaussian;
  double level = 1;  ///< > 0
};

/// An axis-aligned box.
struct Box {
  DVec3 low{0}, high{0};
  DVec3 middle() const { return (low + high) * 0.5; }
  DVec3 size() const { return high - low; }
};

/// An implicit surface that the renderer draws directly instead of triangles.
struct Isosurface {
  Blobs blobs;
  Box box;              ///< contains it, in the blobs' unit
  double steepest = 1;  ///< upper bound of the gradient's length in the box
  DVec3 origin{0};      ///< origin of the solid in the blobs' space
  double unit = 1;      ///< metres per unit of the blobs
};

}  // namespace frond
