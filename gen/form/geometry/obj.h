#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "geometry/polygon_mesh.h"

namespace frond {

/// A Wavefront OBJ text as it stands: faces of any number of corners, places in double precision, texture
/// coordinates (`vt`) and the colours of vertices (`v x y z r g b`, if all have some), objects, groups and
/// the names of materials, which are in other files. Keywords may be upper case; lines may end as on any
/// system and go on after a backslash. Invalid numbers and missing corners are errors, which call the text
/// `name` and give the line.
Result<PolygonMesh> read_obj_mesh(std::string_view text, const std::string& name);

/// Polylines over numbered points.
struct LineSet {
  std::vector<DVec3> place;
  std::vector<std::array<std::uint32_t, 2>> line;
};

/// The `l` elements of a Wavefront OBJ text, one line per segment, in the order written. A text without any
/// is an error; other errors are those of read_obj_mesh().
Result<LineSet> read_obj_lines(std::string_view text, const std::string& name = "");

}  // namespace frond
