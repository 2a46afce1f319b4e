#include <algorithm>

#include "core/printable.h"
#include "export/carry.h"
#include "export/parts.h"

namespace frond {

namespace {

bool no_branches(const Model& m) { return m.skeleton.size() == 0 && m.blades.size() == 0; }

bool same_vertices(const Prototype& a, const Prototype& b) {
  return std::ranges::equal(
      a.parts, b.parts, {}, [](const OrganPart& p) { return p.surface.position.size(); },
      [](const OrganPart& p) { return p.surface.position.size(); });
}

}  // namespace

bool is_same_swarm(const Model& a, const Model& b) {
  if (!no_branches(a) || !no_branches(b) || a.organs.id != b.organs.id) return false;
  if (a.organs.size() + a.solids.size() == 0) return false;
  auto corners = [](const Solid& solid) { return solid.surface.position.size(); };
  if (!std::ranges::equal(a.solids.shapes, b.solids.shapes, {}, corners, corners)) return false;
  for (std::size_t i = 0; i < a.organs.size(); ++i)
    if (!same_vertices(a.prototypes[a.organs.prototype[i]], b.prototypes[b.organs.prototype[i]]))
      return false;
  return true;
}

std::map<std::string, std::vector<ExportPart>> swarm_parts(Maker& maker, const Look& look, const Model& last,
                                                           std::span<const Model> keys, double triangles) {
  const Organs& o = last.organs;
  double each = triangles / static_cast<double>(o.size());
  std::vector<std::vector<Simplified>> drawn;
  for (const Prototype& p : last.prototypes) {
    drawn.emplace_back();
    for (const OrganPart& part : p.parts)
      drawn.back().push_back(drawn_with(part.surface, each / static_cast<double>(p.parts.size())));
  }
  std::map<std::string, std::vector<ExportPart>> meshes;
  for (std::size_t i = 0; i < o.size(); ++i) {
    const Prototype& p = last.prototypes[o.prototype[i]];
    std::string name = plain_name(p.name, "organ");
    for (std::size_t k = 0; k < p.parts.size(); ++k) {
      const Simplified& own = drawn[o.prototype[i]][k];
      auto lies = own.surface.uv.empty() ? Palette::Lies::nowhere : Palette::Lies::mesh;
      std::size_t material = maker.palette.organ(look, p, k, color_index(o.color[i], p.colors.size()), lies,
                                                 maker.name() + '_' + name);
      std::vector<ExportPart>& parts = meshes[name];
      auto made = std::ranges::find(parts, material, &ExportPart::material);
      if (made == parts.end()) made = parts.insert(made, {{}, material});
      std::size_t first = made->surface.position.size();
      append_placed(made->surface, own.surface, o.position[i], o.turn[i], Vec3(o.scale[i]));
      for (std::size_t key = 0; key < keys.size(); ++key) {
        const Organs& then = keys[key].organs;
        append_shift(*made, key, first, own.of(keys[key].prototypes[then.prototype[i]].parts[k].surface),
                     {0, then.position[i], then.turn[i], Vec3(then.scale[i])});
      }
    }
  }
  return meshes;
}

}  // namespace frond
