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

/// A Wavefront OBJ text as one mesh: all its objects, faces of any number of corners, with its normals or,
/// where it has none, with those of its faces, smooth but across edges of more than 40 degrees,
/// and turned outward where it is closed. Materials do not count. Faces without area are left out. Numbers
/// that are none, corners that do not exist and a text without a usable face are errors, which call the text
/// `name` and give the line.
Result<Surface> read_obj(std::string_view text, const std::string& name = "");

/// Lines between numbered places.
struct LineSet {
  std::vector<DVec3> place;
  std::vector<std::array<std::uint32_t, 2>> line;
};

/// The `l` elements of a Wavefront OBJ text, each piece of them one line, in the order written. A text
/// without any is an error; else as above.
Result<LineSet> read_obj_lines(std::string_view text, const std::string& name = "");

/// The same mesh with its box one unit long at its longest, standing on the origin: an organ's own size.
Surface to_unit(Surface surface);

/// Reads the mesh of a file to_unit(), for properties that name one.
Errors load_unit_mesh(const NamedFile& file, Surface& mesh);

}  // namespace frond
