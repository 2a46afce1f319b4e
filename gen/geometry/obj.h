#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/assets.h"
#include "core/result.h"
#include "model/surface.h"

namespace frond {

/// A Wavefront OBJ text as one mesh: all objects, faces of any number of corners, with its normals or,
/// without any, smooth face normals except across edges of more than 40 degrees; closed meshes are turned
/// outward. Texture coordinates (`vt`) and the colours of vertices (`v x y z r g b`, if all have some; as
/// grey) become its paint. Materials are ignored, faces without area dropped. Invalid numbers, missing
/// corners and a text without a usable face are errors, which call the text `name` and give the line.
Result<Surface> read_obj(std::string_view text, const std::string& name = "");

/// Polylines over numbered points.
struct LineSet {
  std::vector<DVec3> place;
  std::vector<std::array<std::uint32_t, 2>> line;
};

/// The `l` elements of a Wavefront OBJ text, one line per segment, in the order written. A text without any
/// is an error; otherwise as above.
Result<LineSet> read_obj_lines(std::string_view text, const std::string& name = "");

/// The same mesh scaled to a longest box side of one unit, standing on the origin: the unit size of an organ.
Surface to_unit(Surface surface);

/// Reads the mesh of a file to_unit(), for properties that name one.
Errors load_unit_mesh(const NamedFile& file, Surface& mesh);

}  // namespace frond
