#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "export/export_scene.h"
#include "field/volume.h"

namespace frond {

/// A format that scenes are exported to: one row in formats.cpp, one file.
struct Format {
  std::string_view extension, doc;
  /// About how many bytes a scene of that size takes.
  double (*bytes)(const ExportSize& size);
  double most_bytes;  ///< that the format can hold
  /// Writes a scene: each file whole or not at all. Null for the format of volumes.
  Result<bool> (*write)(const ExportScene& exported, const ExportOptions& options,
                        const std::filesystem::path& path);
  bool pictures = true;  ///< whether it holds them
  bool tints = true;     ///< whether what shows it reads colours at the vertices
  bool films = false;    ///< whether it holds levels of detail and shapes that go over into each other
};

std::span<const Format> formats();

/// The format of a file's name, or an error that names those there are, and .inc, which is no mesh: see
/// export/include.h.
Result<const Format*> format_of(const std::filesystem::path& path);

/// What a file will hold.
struct ExportTold {
  double bytes = 0;               ///< about
  std::vector<double> triangles;  ///< at each level of detail, as they are placed
};

/// Writes a scene as it is at a time, seconds. `tell` is told what it will take as soon as that is known;
/// more than the format or this machine's memory holds is refused, and so is a scene of which nothing would
/// be written. Errors of the disk stand at a path, those of what was asked for at none. Gives the names of
/// organisms of which nothing has grown by then.
Result<std::vector<std::string>> write_scene(const Format& format, const Scene& scene, double time,
                                             const ExportOptions& options, const std::filesystem::path& path,
                                             const std::function<void(const ExportTold&)>& tell);

/// How an error begins that is about a frame in which nothing has grown yet, of formats that cannot be empty.
inline constexpr std::string_view kNothingYet = "nothing has grown yet at ";

// The texts of the formats, pure functions of the scene.

/// A Wavefront OBJ; its materials are in the file `materials`.
std::string obj_text(const ExportScene& exported, std::string_view materials);
std::string mtl_text(const ExportScene& exported);

/// A binary PLY, little-endian: one mesh, colours at the vertices.
std::string ply_bytes(const ExportScene& exported);

/// A binary glTF 2.0: a node for each group, below it one for each placement; with `instances`, for all of
/// one mesh (EXT_mesh_gpu_instancing).
Result<std::string> glb_bytes(const ExportScene& exported, bool instances = false);

/// The branches of a whole scene, those of what is sown with them, as one volume.
Result<Volume> export_volume(const Scene& scene, double time, const ExportOptions& options);

}  // namespace frond
