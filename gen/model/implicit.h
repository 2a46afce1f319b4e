#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// How the field of a blob falls off with d^2, the square of the distance from its middle in radii, where r
/// is the largest of its radii. Each is 1 in the middle and falls steadily; the last two end at d = r.
enum class Falloff : std::uint8_t {
  gaussian,  ///< exp(-r d^2) (Blinn 1982)
  soft,      ///< 1 - 4 d^6/9r^6 + 17 d^4/9r^4 - 22 d^2/9r^2 (Wyvill, McPheeters and Wyvill 1986)
  cubic,     ///< (1 - d^2/r^2)^3
};

/// One ellipsoid of an implicit surface.
struct Blob {
  DVec3 radius{1};  ///< along x, y and z, each > 0
  DVec3 center{0};  ///< in radii: its middle lies at radius * center
};

/// The implicit surface f(p) = 0 of the sum f of the fields of all blobs less `level`; inside f > 0.
/// A single blob at level 1 has no inside: its field is 1 in its middle only.
struct Blobs {
  std::vector<Blob> blobs;
  Falloff falloff = Falloff::gaussian;
  double level = 1;  ///< > 0
};

/// A box with sides along the axes.
struct Box {
  DVec3 low{0}, high{0};
  DVec3 middle() const { return (low + high) * 0.5; }
  DVec3 size() const { return high - low; }
};

/// An implicit surface that the renderer finds by itself, in place of triangles.
struct Isosurface {
  Blobs blobs;
  Box box;              ///< that holds it, in the blobs' own unit
  double steepest = 1;  ///< not less than the length of the gradient anywhere in the box
  DVec3 origin{0};      ///< where the origin of the solid lies in the blobs' space
  double unit = 1;      ///< metres that one of the blobs' units makes
};

}  // namespace frond
