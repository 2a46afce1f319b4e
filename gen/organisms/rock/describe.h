#pragma once

#include "organisms/describe_stone.h"
#include "organisms/rock/rock.h"

// The properties of rocks, as presets spell them; see preset/describe.h.

namespace frond {

template <class Visitor>
void describe(Visitor& v, RockParams& r) {
  v.number("size", r.shape.size, {.min = 0.001, .max = 1000, .unit = "m"}, "Longest side, before weathering");
  describe_shape(v, r.shape);
  v.object("stone", r.stone, "Its surface");
  v.number("buried", r.buried, {.min = 0, .max = 1}, "Share of its height that is in the ground");
  v.boolean("native", r.native, "An isosurface of POV-Ray's own: the blobs alone, exact, without weathering");
}

}  // namespace frond
