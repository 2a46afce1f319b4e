#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "core/result.h"
#include "export/cast.h"
#include "field/volume.h"

namespace frond {

/// A format that scenes are exported to: one row in formats.cpp, one file.
struct Format {
  std::string_view extension, doc;
  /// About how many bytes a cast of that size takes.
  double (*bytes)(const CastSize& size);
  double most_bytes;  ///< that the format can hold
  /// Writes a scene as it is at a time, seconds: each file whole or not at all.
  Result<bool> (*write)(const Scene& scene, double time, const CastOptions& options,
                        const std::filesystem::path& path);
};

std::span<const Format> formats();

/// The format of a file's name, or an error that names those there are.
Result<const Format*> format_of(const std::filesystem::path& path);

// The texts of the formats, pure functions of the cast.

/// A Wavefront OBJ; its materials are in the file `materials`.
std::string obj_text(const Cast& cast, std::string_view materials);
std::string mtl_text(const Cast& cast);

/// A binary PLY, little-endian: one mesh, colours at the vertices.
std::string ply_bytes(const Cast& cast);

/// A binary glTF 2.0: a mesh for each of the cast's, a node for each placement.
Result<std::string> glb_bytes(const Cast& cast);

/// The branches of a whole scene as one volume.
Result<Volume> cast_volume(const Scene& scene, double time, const CastOptions& options);

}  // namespace frond
