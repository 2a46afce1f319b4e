#pragma once

#include "core/mask.h"
#include "core/result.h"
#include "preset/describe.h"

// The properties of masks, as presets spell them; see preset/describe.h.

namespace frond {

/// Takes the brightness of a picture; transparent pixels are dark. A picture that is white all over is as
/// none.
Errors load_mask(const NamedFile& file, Mask& mask);

/// How a mask is laid on.
void describe_projection(Properties& v, Mask& m);

void describe(Properties& v, Mask& m);

}  // namespace frond
