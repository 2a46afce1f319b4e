#include "export/formats.h"

#include <algorithm>
#include <limits>

#include "core/content.h"
#include "core/figures.h"
#include "core/files.h"
#include "core/machine.h"
#include "core/printable.h"

namespace frond {

namespace {

namespace fs = std::filesystem;

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kPlyVertex = 35;
constexpr double kMostIndices = 2147483647;  // whole numbers of a PLY

/// What the files beside an OBJ are called by: it stands in lines that programs split at blanks, and that
/// they read in letters of their own. Of an odd name so much as is plain, with what tells it from others.
std::string plain_stem(const fs::path& path) {
  std::string stem = path.stem().string(), plain = stem;
  std::ranges::replace_if(
      plain, [](char c) { return !is_plain(c); }, '_');
  return plain == stem ? stem : plain + '_' + content_id(stem).substr(0, 6);
}

/// The large file first: where the disk is full the small ones would be left alone.
Result<bool> write_obj(const ExportScene& exported, const ExportOptions&, const fs::path& path) {
  fs::path materials = path.parent_path() / (plain_stem(path) + ".mtl");
  // Pictures are called as the file is, so that two exports in one folder do not take each other's.
  ExportScene named = exported;
  for (ExportPicture& picture : named.pictures) picture.name = plain_stem(path) + '_' + picture.name;
  std::vector<fs::path> there;
  auto write = [&](const fs::path& to, const std::string& text) {
    Result<bool> written = write_file(to, text);
    if (written && *written) there.push_back(to);
    return written;
  };
  Result<bool> written = write(path, obj_text(named, materials.filename().string()));
  if (written) written = write(materials, mtl_text(named));
  for (std::size_t i = 0; written && i < named.pictures.size(); ++i)
    written = write(path.parent_path() / (named.pictures[i].name + ".png"), named.pictures[i].png);
  for (std::size_t i = 0; !written && i < there.size(); ++i) remove_file(there[i]);
  return written;
}

Result<bool> write_ply(const ExportScene& exported, const ExportOptions&, const fs::path& path) {
  return write_file(path, ply_bytes(exported));
}

Result<bool> write_glb(const ExportScene& exported, const ExportOptions& options, const fs::path& path) {
  Result<std::string> bytes = glb_bytes(exported, options.instances);
  if (!bytes) return bytes.errors();
  return write_file(path, *bytes);
}

constexpr Format kFormats[] = {
    {".obj", "Wavefront OBJ, with an MTL file and pictures beside it",
     [](const ExportSize& s) { return 45 * s.all_vertices + 50 * s.all_triangles; }, kAny, write_obj, true,
     false},
    {".ply", "binary PLY with colours at the vertices",
     [](const ExportSize& s) { return kPlyVertex * s.all_vertices + 13 * s.all_triangles; },
     kPlyVertex* kMostIndices, write_ply, false},
    {".glb", "binary glTF 2.0 with materials and instances",
     [](const ExportSize& s) {
       return 32 * s.vertices + 12 * s.triangles + 24 * s.shifts + 120 * s.placements + s.pictures;
     },
     4294967295.0, write_glb, true, true, true},
    {".vdb", "OpenVDB: the branches as a level set named \"surface\"", [](const ExportSize&) { return 0.0; },
     kAny, nullptr},
};

/// Why so many bytes are not written, if they are not.
Errors refuse_bytes(const Format& format, double bytes) {
  // A file is put together in memory, beside the meshes.
  double memory = 0.9 * this_machine(".").memory;
  if (bytes > format.most_bytes)
    return {error_at("", "would take about {}; such a file holds {} at most", bytes_text(bytes),
                     bytes_text(format.most_bytes))};
  if (bytes > memory)
    return {error_at("",
                     "would take about {}, more than the {} that this machine's memory has for it; a .glb "
                     "holds each model once, however many copies stand",
                     bytes_text(bytes), bytes_text(memory))};
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
  return error_at(path.string(), "\"{}\" is no format that is known; expected one of {}, .inc", extension,
                  known);
}

Result<std::vector<std::string>> write_scene(const Format& format, const Scene& scene, double time,
                                             const ExportOptions& options, const fs::path& path,
                                             const std::function<void(const ExportTold&)>& tell) {
  if (!format.write) {
    Result<Volume> volume = export_volume(scene, time, options);
    if (!volume) return volume.errors();
    Result<bool> written = write_vdb(path, *volume);
    if (!written) return written.errors();
    return std::vector<std::string>{};
  }
  // Estimated before anything large is made, and again once what is sown has grown.
  if (Errors errors = refuse_bytes(format, format.bytes(estimate_export(scene, options))); !errors.empty())
    return errors;
  ExportOptions own = options;
  if (!format.pictures) own.texture = 0;
  own.tints = format.tints;
  Result<ExportScene> exported = export_scene(scene, time, own);
  if (!exported) return exported.errors();
  double bytes = format.bytes(size_of(*exported));
  tell({bytes, level_triangles(*exported)});
  if (Errors errors = refuse_bytes(format, bytes); !errors.empty()) return errors;
  Result<bool> written = format.write(*exported, own, path);
  if (!written) return written.errors();
  return std::move(exported->absent);
}

}  // namespace frond
