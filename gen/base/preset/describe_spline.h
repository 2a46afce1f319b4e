#pragma once

#include "core/spline.h"
#include "preset/describe.h"

// The points of smooth lines, as presets spell them; see preset/describe.h.

namespace frond {

template <class V>
void describe(Properties& v, SplinePoint<V>& p) {
  v.shorthand("at");
  v.vector("at", p.at, "Where the point is, in metres");
  v.required("at");
  v.vector(
      "in", p.in,
      "Handle on the side that the line comes from, in metres from the point; not given: opposite to out");
  v.vector(
      "out", p.out,
      "Handle on the side that the line goes on to, in metres from the point; not given: opposite to in");
}

}  // namespace frond
