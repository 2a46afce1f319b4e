#include "geometry/mesh_file.h"

#include <algorithm>

#include "core/text.h"
#include "geometry/mesh_formats.h"
#include "geometry/obj.h"

namespace frond {

namespace {

struct Magic {
  std::string_view bytes, what;
};

using namespace std::string_view_literals;

constexpr Magic kForeign[] = {{"Kaydara FBX Binary", "an FBX file"},
                              {"; FBX", "an FBX text"},
                              {"BLENDER", "a file of Blender"},
                              {"\x28\xB5\x2F\xFD", "a file compressed by zstd, as those of Blender"},
                              {"PK\x03\x04", "a zip archive, as 3MF and USDZ are"},
                              {"\x1F\x8B", "a file compressed by gzip"},
                              {"#usda", "a USD text"},
                              {"PXR-USDC", "a USD file"},
                              {"#VRML", "a VRML text"},
                              {"ISO-10303-21", "a STEP file"},
                              {"3D Geometry File Format", "a file of Rhino"},
                              {"LASF", "a LAS cloud of points"},
                              {"# .PCD", "a PCD cloud of points"},
                              {"OFF\n", "an OFF file"},
                              {"OFF\r\n", "an OFF file"},
                              {"COFF\n", "an OFF file"},
                              {"Ogawa", "an Alembic file"},
                              {"\x89PNG", "a PNG picture"},
                              {"\xFF\xD8\xFF", "a JPEG picture"},
                              {"%PDF", "a PDF file"},
                              {"\xFF\xFE\xFF\x0E"sv, "a file of SketchUp"},
                              {"\xFF\xFE", "a text in UTF-16"},
                              {"AutoCAD Binary DXF", "a DXF file"},
                              {"AC10", "a DWG file of AutoCAD"},
                              {"FORM", "a LightWave or other IFF file"},
                              {"\x4D\x4D", "a 3DS file"},
                              {"c4d", "a file of Cinema 4D"},
                              {"SIMPLE  =", "a FITS file"}};

/// The first lines, in which a text says what it is.
std::string_view head_of(std::string_view bytes) { return bytes.substr(0, 2048); }

bool has_word(std::string_view bytes, std::string_view word) {
  return head_of(bytes).find(word) != bytes.npos;
}

bool is_stl(std::string_view bytes) {
  if (is_binary_stl(bytes)) return true;
  std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  return lower_case(bytes.substr(first, 5)) == "solid" &&
         (has_word(bytes, "facet") || has_word(bytes, "FACET") || has_word(bytes, "endsolid"));
}

bool is_ply(std::string_view bytes) { return bytes.starts_with("ply\n") || bytes.starts_with("ply\r"); }

/// Why a text of OBJ holds nothing to draw; empty where it does.
std::string nothing_to_draw(const PolygonMesh& mesh, std::string_view text) {
  if (!mesh.face.empty()) return {};
  if (!mesh.place.empty()) return "";
  if (has_word(text, "newmtl")) return "is an MTL file of materials; expected the OBJ file that names it";
  return "is no mesh that is known; expected a file of Wavefront OBJ, PLY, STL or GLB";
}

/// What kind of file bytes are that hold no mesh Frond reads, such as "an FBX file"; empty where they may be
/// an OBJ text or are of another format that is read.
std::string foreign_format(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  for (const Magic& magic : kForeign)
    if (bytes.starts_with(magic.bytes)) return std::string(magic.what);
  if (has_word(bytes, "<COLLADA")) return "a COLLADA file";
  if (has_word(bytes, "<X3D")) return "an X3D file";
  if (has_word(bytes, "<amf")) return "an AMF file";
  if (has_word(bytes, "<svg")) return "an SVG drawing";
  std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  bool json = bytes.substr(first).starts_with('{');
  if (json && bytes.find("\"asset\"") != bytes.npos && bytes.find("\"meshes\"") != bytes.npos)
    return "a glTF text, whose data may lie in other files";
  if (json) return "a JSON text";
  if (bytes.substr(first).starts_with("0") && has_word(bytes, "SECTION") && has_word(bytes, "HEADER"))
    return "a DXF text";
  return {};
}

}  // namespace

const char* mesh_ending(std::string_view bytes) {
  return bytes.starts_with("glTF") ? ".glb" : is_ply(bytes) ? ".ply" : is_stl(bytes) ? ".stl" : ".obj";
}

Result<PolygonMesh> read_mesh_file(const NamedFile& file, std::string* content) {
  const std::string& name = file.path.string();
  std::string_view bytes = file.text;
  if (bytes.empty()) return Error{name, "is empty; expected a mesh"};
  if (bytes.starts_with("glTF")) return read_glb_mesh(bytes, name);
  if (is_ply(bytes)) return read_ply_mesh(bytes, name);
  if (is_stl(bytes)) return read_stl_mesh(bytes, name);
  if (std::string what = foreign_format(bytes); !what.empty())
    return error_at(
        name, "is {}; expected a mesh as Wavefront OBJ, PLY, STL or GLB, which most programs export", what);
  Result<PolygonMesh> mesh = read_obj_mesh(bytes, name);
  if (!mesh) return mesh;
  if (std::string wrong = nothing_to_draw(*mesh, bytes); !wrong.empty()) return Error{name, wrong};
  read_materials(file.path, *mesh, file.noted, content);
  return mesh;
}

MeshFrame unit_frame(const PolygonMesh& mesh) {
  MeshBox box = box_of(mesh, {});
  DVec3 size = box.high - box.low;
  double longest = std::max({size.x, size.y, size.z, 1e-30});
  return {.origin = {0.5 * (box.low.x + box.high.x), box.low.y, 0.5 * (box.low.z + box.high.z)},
          .scale = 1 / longest};
}

Errors load_unit_mesh(const NamedFile& file, Surface& mesh) {
  Result<PolygonMesh> read = read_mesh_file(file);
  if (!read) return read.errors();
  Result<PartedSurface> made = parted_surface(*read, unit_frame(*read), file.path.string());
  if (!made) return made.errors();
  mesh = std::move(made->surface);
  return {};
}

}  // namespace frond
