#include "export/formats.h"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "core/files.h"
#include "core/text.h"

namespace frond {

namespace {

namespace fs = std::filesystem;

constexpr double kVoxels = 400;  // along a volume that nothing says the voxel of
constexpr double kAny = std::numeric_limits<double>::infinity();

Result<bool> write_obj(const Scene& scene, double time, const CastOptions& options, const fs::path& path) {
  Result<Cast> cast = cast_scene(scene, time, options);
  if (!cast) return cast.errors();
  fs::path materials = path;
  materials.replace_extension(".mtl");
  Result<bool> written = write_file(materials, mtl_text(*cast));
  return written ? write_file(path, obj_text(*cast, materials.filename().string())) : written;
}

Result<bool> write_ply(const Scene& scene, double time, const CastOptions& options, const fs::path& path) {
  Result<Cast> cast = cast_scene(scene, time, options);
  if (!cast) return cast.errors();
  return write_file(path, ply_bytes(*cast));
}

Result<bool> write_glb(const Scene& scene, double time, const CastOptions& options, const fs::path& path) {
  Result<Cast> cast = cast_scene(scene, time, options);
  if (!cast) return cast.errors();
  Result<std::string> bytes = glb_bytes(*cast);
  if (!bytes) return bytes.errors();
  return write_file(path, *bytes);
}

Result<bool> write_volume(const Scene& scene, double time, const CastOptions& options, const fs::path& path) {
  Result<Volume> volume = cast_volume(scene, time, options);
  if (!volume) return volume.errors();
  return write_vdb(path, *volume);
}

constexpr Format kFormats[] = {
    {".obj", "Wavefront OBJ, with an MTL file beside it",
     [](const CastSize& s) { return 85 * s.all_vertices + 60 * s.all_triangles; }, kAny, write_obj},
    {".ply", "binary PLY with colours at the vertices",
     [](const CastSize& s) { return 35 * s.all_vertices + 13 * s.all_triangles; }, kAny, write_ply},
    {".glb", "binary glTF 2.0 with materials and instances",
     [](const CastSize& s) { return 32 * s.vertices + 12 * s.triangles + 160 * s.placements; }, 4294967295.0,
     write_glb},
    {".vdb", "OpenVDB: the branches as a level set named \"surface\"", [](const CastSize&) { return 0.0; },
     kAny, write_volume},
};

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

Result<Volume> cast_volume(const Scene& scene, double time, const CastOptions& options) {
  Boughs limbs;
  VolumeOptions volume{options.voxel, 0, 0};
  std::int32_t first_node = 0;
  Vec3 low(std::numeric_limits<float>::max()), high = -low;
  for (const Branches& organism : scene.branches) {
    Branches stage;
    if (organism.develops()) {
      Result<Branches> now = developed(organism, time);
      if (!now) return now.errors();
      stage = std::move(*now);
    }
    const Branches& b = organism.develops() ? stage : organism;
    if (b.rest.size() < 2 || (!b.skin && !b.bark)) continue;
    Pose pose;
    pose_branches(b, time, pose);
    add_limbs(limbs, b.rest, pose.position, pose.radius, pose.front, static_cast<float>(b.style.blend),
              first_node);
    first_node += static_cast<std::int32_t>(b.rest.size());
    for (const Vec3& p : pose.position) low = glm::min(low, p), high = glm::max(high, p);
    if (options.voxel <= 0 && b.style.build != Build::sweeps)
      volume.voxel = volume.voxel > 0 ? std::min(volume.voxel, b.style.voxel) : b.style.voxel;
    volume.limit = std::max(volume.limit, b.style.limit);
  }
  if (limbs.cones.empty()) return Error{"", "there are no branches at that frame to make a volume of"};
  if (volume.voxel <= 0) volume.voxel = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / kVoxels;
  return volume_of(limbs, volume);
}

}  // namespace frond
