#include "export/formats.h"

#include <fmt/format.h>

#include <limits>

#include "core/files.h"
#include "core/machine.h"

namespace frond {

namespace {

namespace fs = std::filesystem;

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kPlyVertex = 35;
constexpr double kMostIndices = 2147483647;  // whole numbers of a PLY

Result<bool> write_obj(const Cast& cast, const fs::path& path) {
  fs::path materials = path;
  materials.replace_extension(".mtl");
  // The large file first: where the disk is full the small one would be left alone.
  Result<bool> written = write_file(path, obj_text(cast, materials.filename().string()));
  if (!written) return written;
  Result<bool> beside = write_file(materials, mtl_text(cast));
  std::error_code error;
  if (!beside && *written) fs::remove(path, error);
  return beside;
}

Result<bool> write_ply(const Cast& cast, const fs::path& path) { return write_file(path, ply_bytes(cast)); }

Result<bool> write_glb(const Cast& cast, const fs::path& path) {
  Result<std::string> bytes = glb_bytes(cast);
  if (!bytes) return bytes.errors();
  return write_file(path, *bytes);
}

constexpr Format kFormats[] = {
    {".obj", "Wavefront OBJ, with an MTL file beside it",
     [](const CastSize& s) { return 85 * s.all_vertices + 60 * s.all_triangles; }, kAny, write_obj},
    {".ply", "binary PLY with colours at the vertices",
     [](const CastSize& s) { return kPlyVertex * s.all_vertices + 13 * s.all_triangles; },
     kPlyVertex* kMostIndices, write_ply},
    {".glb", "binary glTF 2.0 with materials and instances",
     [](const CastSize& s) { return 32 * s.vertices + 12 * s.triangles + 160 * s.placements; }, 4294967295.0,
     write_glb},
    {".vdb", "OpenVDB: the branches as a level set named \"surface\"", [](const CastSize&) { return 0.0; },
     kAny, nullptr},
};

/// Why so many bytes are not written, if they are not.
Errors refuse_bytes(const Format& format, double bytes) {
  // A file is put together in memory, beside the meshes.
  double memory = 0.9 * this_machine(".").memory;
  if (bytes > format.most_bytes)
    return {Error{"", fmt::format("would take about {:.2g} GB; such a file holds {:.2g} GB at most",
                                  bytes / 1e9, format.most_bytes / 1e9)}};
  if (bytes > memory)
    return {
        Error{"", fmt::format("would take about {:.2g} GB, more than the {:.2g} GB that this machine's "
                              "memory has for it; a .glb holds each model once, however many copies stand",
                              bytes / 1e9, memory / 1e9)}};
  return {};
}

}  // namespace

std::span<const Format> formats() { return kFormats; }

Result<const Format*> format_of(const fs::path& path) {
  std::string extension = path.extension().string(), known;
  for (const Format& format : kFormats) {
    if (format.extension == extension) return &format;
    known += known.empty() ? "" : ", ";
    known += format.extension;
  }
  return Error{path.string(),
               fmt::format("\"{}\" is no format that is known; expected one of {}", extension, known)};
}

Result<bool> write_scene(const Format& format, const Scene& scene, double time, const CastOptions& options,
                         const fs::path& path, const std::function<void(double)>& tell) {
  if (!format.write) {
    Result<Volume> volume = cast_volume(scene, time, options);
    if (!volume) return volume.errors();
    return write_vdb(path, *volume);
  }
  // Foreseen before anything large is made, and again once what is sown has grown.
  if (Errors errors = refuse_bytes(format, format.bytes(foresee_cast(scene, options))); !errors.empty())
    return errors;
  Result<Cast> cast = cast_scene(scene, time, options);
  if (!cast) return cast.errors();
  double bytes = format.bytes(size_of(*cast));
  tell(bytes);
  if (Errors errors = refuse_bytes(format, bytes); !errors.empty()) return errors;
  return format.write(*cast, path);
}

}  // namespace frond
