#pragma once

#include <string_view>

#include "core/result.h"
#include "model/surface.h"

namespace frond {

/// A Wavefront OBJ text as one mesh: all its objects, faces of any number of corners, with its normals or,
/// where it has none, smooth ones. Materials do not count. Degenerate faces are left out; a text without a
/// usable face is an error.
Result<Surface> read_obj(std::string_view text);

/// The same mesh with its box one unit long at its longest, standing on the origin: an organ's own size.
Surface to_unit(Surface surface);

}  // namespace frond
