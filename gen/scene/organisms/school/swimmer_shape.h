#pragma once

#include "appearance/swimmer_look.h"
#include "core/function_ref.h"
#include "model/surface.h"

namespace frond {

// Animals one unit long, the nose toward +y, the back toward +z, at a phase 0..1 of their stroke. A turtle is
// one from nose to shell's end, a manta from wingtip to wingtip, a jellyfish across its bell.

/// A fish with eyes of a width, bent sideways by `bend`, -1 right .. 1 left.
Surface fish_surface(const FishForm& form, double eye, double phase, double bend);

Surface turtle_surface(double phase);
Surface manta_surface(double phase);
Surface jellyfish_surface(double phase);

/// Half the width of a jellyfish's bell and its height there, from its top 0 to its rim 1, in widths of it at
/// rest.
Vec2 bell_profile(double share, double phase);

/// From the side: `along` from the nose, `up` from the middle line, `out` to one side.
inline Vec3 swimmer_place(double along, double up, double out) {
  return {static_cast<float>(out), static_cast<float>(0.5 - along), static_cast<float>(up)};
}

/// Adds a sheet of `columns` x `rows` faces: `place(t, r)` and `uv(t, r)`, both 0..1.
void add_sheet(Surface& mesh, int columns, int rows, FunctionRef<Vec3(double, double)> place,
               FunctionRef<Vec2(double, double)> uv);

}  // namespace frond
