#pragma once

#include "core/mask.h"
#include "core/result.h"
#include "preset/describe.h"

// The properties of masks, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<Axis> kAxes[] = {{"x", Axis::x, "seen from the side: z to the right, y up"},
                                         {"y", Axis::y, "seen from above: x to the right, z down"},
                                         {"z", Axis::z, "seen from the front: x to the right, y up"}};

/// Takes the brightness of a picture; transparent pixels are dark. A picture that is white all over is as
/// none.
Errors load_mask(const NamedFile& file, Mask& mask);

/// How a mask is laid on.
template <class Visitor>
void describe_projection(Visitor& v, Mask& m) {
  v.choice("along", m.along, kAxes,
           "Axis of the world along which the picture is projected, onto all sides alike");
  v.list("area", m.area, Count{2, 2},
         "Two opposite corners of what the picture covers, in metres of the world: [x, z] along y, [x, y] "
         "along z, [z, y] along x; beyond them its edges go on");
}

template <class Visitor>
void describe(Visitor& v, Mask& m) {
  v.shorthand("file");
  v.file(
      "file", m.file, [&](const NamedFile& file) { return load_mask(file, m); },
      "A picture (PNG, JPEG or WebP), named as seen from the preset's folder, whose brightness scales what "
      "the map is for: none where it is black, all where it is white");
  describe_projection(v, m);
}

}  // namespace frond
