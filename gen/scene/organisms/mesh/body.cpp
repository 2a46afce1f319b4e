#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/content.h"
#include "geometry/mesh_file.h"
#include "organisms/mesh/mesh.h"

namespace frond {

namespace {

/// Whether what is read with y up looks as if z were: it stands on z = 0 and not on y = 0, or is much lower
/// than it is wide and deep.
bool looks_lying(const MeshBox& box) {
  DVec3 size = box.high - box.low;
  auto stands = [&](int axis) { return std::abs(box.low[axis]) <= 1e-3 * size[axis] && size[axis] > 0; };
  if (stands(1)) return false;
  constexpr double kFlat = 0.35;
  return stands(2) || (size.y < kFlat * size.x && size.y < kFlat * size.z);
}

/// The frame in which it stands on the origin, its longest side one unit long.
MeshFrame frame_of(const MeshBox& box, UpAxis up, std::vector<char> taken) {
  DVec3 size = box.high - box.low, foot = 0.5 * (box.low + box.high);
  int axis = up == UpAxis::z ? 2 : 1;
  foot[axis] = box.low[axis];
  double longest = std::max({size.x, size.y, size.z, 1e-30});
  return {.origin = foot, .scale = 1 / longest, .z_up = up == UpAxis::z, .taken = std::move(taken)};
}

/// Which parts bear one of the names; empty where there are no names, or none of them is there.
std::vector<char> taken_of(const PolygonMesh& mesh, const std::vector<std::string>& names) {
  std::vector<char> taken(mesh.part.size(), 0);
  bool any = false;
  for (std::uint32_t p = 0; p < taken.size(); ++p)
    for (const std::string& name : names)
      if (mesh.bears(p, name)) taken[p] = 1, any = true;
  return any ? taken : std::vector<char>();
}

}  // namespace

double size_of(const MeshParams& params) {
  constexpr double kMetres[] = {0.001, 0.01, 1, 0.0254, 0.3048};  // of each LengthUnit
  if (!params.unit || !params.body) return params.size;
  return kMetres[static_cast<std::size_t>(*params.unit)] * params.body->length;
}

bool MeshBody::bears(std::uint32_t which, const std::vector<std::string>& wanted) const {
  const PolygonMesh::Part& p = part[which];
  return std::ranges::any_of(wanted, [&](const std::string& name) {
    return !name.empty() &&
           (p.object == name || p.group == name ||
            (p.material >= 0 && material[static_cast<std::size_t>(p.material)].name == name));
  });
}

Errors load_mesh_body(const NamedFile& file, MeshParams& params) {
  std::string others;
  Result<PolygonMesh> mesh = read_mesh_file(file, &others);
  if (!mesh) return mesh.errors();
  if (!others.empty()) params.file.content = content_id(params.file.content + others);
  std::vector<char> taken = taken_of(*mesh, params.parts);
  MeshBox box = box_of(*mesh, taken);
  if (box.empty) return {Error{file.path.string(), "holds no face that could be drawn"}};
  MeshFrame frame = frame_of(box, params.up, std::move(taken));
  Result<PartedSurface> cut = parted_surface(*mesh, frame, file.path.string());
  if (!cut) return cut.errors();
  MeshBody body;
  body.cut = std::move(*cut);
  body.length = 1 / frame.scale;
  body.names = mesh->names();
  body.notes = std::move(mesh->notes);
  body.part = std::move(mesh->part), body.material = std::move(mesh->material);
  body.lies = params.up == UpAxis::y && looks_lying(box);
  constexpr double kFar = 100;  // times its size
  DVec3 middle = 0.5 * (box.low + box.high);
  if (double away = glm::length(middle); away > kFar * body.length)
    body.notes.push_back(fmt::format(
        "lies {:.4g} of its units from the origin of the file and is {:.4g} long; it is moved to its "
        "place here, and programs that keep numbers of 32 bits would lose its details",
        away, body.length));
  if (!body.cut.normals_kept)
    body.notes.push_back("has normals that do not fit its faces; they are made anew from these");
  params.body = std::make_shared<const MeshBody>(std::move(body));
  return {};
}

}  // namespace frond
