#pragma once

#include <optional>
#include <vector>

#include "creeping/triangle_surface.h"

namespace frond {

// The geometry of tendrils. Metres.

/// The middle line of a coiled tendril from one place over a bend to another: two helices of opposite hands,
/// `coils` turns each, and between them the reversal that Darwin saw in all that are held at both ends
/// (perversion). `radius` 0 leaves it uncoiled. Ends included.
std::vector<DVec3> coiled_line(const DVec3& from, const DVec3& bend, const DVec3& to, double coils,
                               double radius);

/// A thin part of a host round which a tendril winds.
struct Pole {
  DVec3 middle{0}, axis{0, 1, 0};
  double half = 0;  ///< of its thickness, or of its width where that is larger
};

/// The part of a host under a place of its surface, by rays across it; nothing where that is thicker or wider
/// than `thickest` metres, or is open. `normal` is outward, of length 1.
std::optional<Pole> pole_at(const TriangleSurface& host, const DVec3& place, const DVec3& normal,
                            double thickest);

/// Where a tendril that comes from a place first touches a pole, and how it goes on: a helix that lies on the
/// host, `lift` off its surface, `pitch` forward along the axis each turn (below 0 backward), with `hand` 1
/// or -1. Empty where the place is too near, or where the pole is not free all round.
std::vector<DVec3> wound_line(const TriangleSurface& host, const Pole& pole, const DVec3& from, double turns,
                              double lift, double pitch, double hand);

/// The places of a curl at the tip of a tendril that comes to `tip` in a direction: a narrowing spiral of
/// `turns` turns toward `aside`, from `radius` down to half of it, each turn `rise` beside the last. Without
/// the tip itself.
std::vector<DVec3> curled_line(const DVec3& tip, const DVec3& direction, const DVec3& aside, double radius,
                               double turns, double rise);

}  // namespace frond
