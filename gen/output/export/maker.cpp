#include "export/maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "appearance/bleaching.h"
#include "core/printable.h"
#include "export/parts.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr double kNear = 0.85;    // a share that is no less is as good as all
constexpr double kFarMore = 1.8;  // times their share, that leaves may take
constexpr double kCoarse = 1.4;   // times those of the first level: edges of leaves that are no pictures
constexpr int kBoughTriangles = 6, kBoughPictures = 3;

/// About so large a share of a part's triangles.
void make_coarser(ExportPart& part, double share) {
  std::vector<std::uint32_t> kept;
  auto goal = static_cast<std::size_t>(share * static_cast<double>(part.surface.triangle.size()));
  part.surface = reduced(part.surface, goal, &kept);
  std::vector<ExportTint> tint;
  for (std::size_t v = 0; !part.tint.empty() && v < part.surface.position.size(); ++v)
    tint.push_back(part.tint[kept.empty() ? v : kept[v]]);
  part.tint = std::move(tint);
}

/// Without leaves, of which each has as few as it can.
double solid_triangles(const ExportScene& exported, const std::vector<ExportPart>& parts) {
  double triangles = 0;
  for (const ExportPart& p : parts)
    if (!exported.materials[p.material].leaf) triangles += static_cast<double>(p.surface.triangle.size());
  return triangles;
}

/// How many boughs have room on a sheet.
int most_boughs(const ExportOptions& options) {
  int across = std::max(2, 2 * options.texture / bough_pixels(options));
  return std::max(2, across * across / kBoughPictures);
}

/// The longest edge of leaves that are drawn by triangles alone, metres.
double longest_stand_in(const ExportScene& exported, const std::vector<ExportPart>& parts) {
  double longest = 0;
  for (const ExportPart& part : parts) {
    const ExportMaterial& material = exported.materials[part.material];
    if (material.leaf && !material.cutout) longest = std::max(longest, longest_edge(part.surface));
  }
  return longest;
}

}  // namespace

double triangles_of(const std::vector<ExportPart>& parts) {
  double triangles = 0;
  for (const ExportPart& p : parts) triangles += static_cast<double>(p.surface.triangle.size());
  return triangles;
}

Vec3 starved(float light, Vec3 color) {
  return glm::min(starved_color(color, light) / glm::max(color, Vec3(1e-4f)), Vec3(1));
}

ExportTint tint_of(Vec3 light) {
  auto part = [](float x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
  return {part(light.x), part(light.y), part(light.z), 255};
}

int bough_pixels(const ExportOptions& options) { return std::clamp(options.texture / 8, 16, 64); }

bool Maker::whole_is_crossed() {
  if (options.texture == 0 || level < 2 || level + 1 < options.levels) return false;
  auto leafy = [&](std::size_t mesh) {
    return std::ranges::any_of(exported.meshes[mesh].parts, [&](const ExportPart& part) {
      return exported.materials[part.material].leaf;
    });
  };
  CrossedLevel whole{{}, static_cast<std::size_t>(level), 0};
  for (const auto& [name, mesh] : begun) whole.meshes.push_back(mesh);
  if (std::ranges::none_of(whole.meshes, leafy)) return false;
  crossed.push_back(std::move(whole));
  return true;
}

std::optional<std::size_t> Maker::mesh(const std::string& part, std::vector<ExportPart> parts) {
  std::erase_if(parts, [](const ExportPart& p) { return p.surface.triangle.empty(); });
  if (parts.empty()) return {};
  if (level == 0) {
    begun[part] = exported.meshes.size();
    exported.meshes.push_back({mesh_names.unique(name() + '_' + part), std::move(parts)});
    return exported.meshes.size() - 1;
  }
  auto of = begun.find(part);
  if (of == begun.end()) return {};
  ExportMesh& mesh = exported.meshes[of->second];
  double factor = (share() * solid_triangles(exported, mesh.parts) + spare) /
                  std::max(1.0, solid_triangles(exported, parts));
  for (ExportPart& p : parts)
    if (factor < kNear && !exported.materials[p.material].leaf) make_coarser(p, factor);
  double wanted = share() * triangles_of(mesh.parts);
  bool coarse = longest_stand_in(exported, parts) > kCoarse * longest_stand_in(exported, mesh.parts);
  if (options.texture > 0 && solid_triangles(exported, parts) == 0 &&
      (coarse || triangles_of(parts) > kFarMore * wanted)) {
    int boughs = static_cast<int>(std::min(wanted / kBoughTriangles, 1e6));
    crossed.push_back({{of->second},
                       static_cast<std::size_t>(level),
                       std::clamp(boughs, 2, std::max(2, most_boughs(options)))});
    return {};
  }
  mesh.set_level(static_cast<std::size_t>(level), std::move(parts));
  return {};
}

void Maker::add_in_place(const std::string& part, std::vector<ExportPart> parts) {
  for (ExportPart& p : parts)
    for (Vec3& at : p.surface.position) at -= foot();
  if (auto made = mesh(part, std::move(parts))) place(*made, foot(), Quat(1, 0, 0, 0), Vec3(1));
}

std::map<std::string, std::vector<ExportPart>> by_name(Maker& maker, const Look& look, const Model& model,
                                                       std::vector<LeafPart> parts) {
  std::map<std::string, std::vector<ExportPart>> meshes;
  for (LeafPart& leaf : parts) {
    const Prototype& prototype = model.prototypes[leaf.prototype];
    std::string name = plain_name(prototype.name, "organ");
    auto lies = leaf.surface.uv.empty() ? Palette::Lies::nowhere
                : leaf.card             ? Palette::Lies::card
                                        : Palette::Lies::mesh;
    std::size_t material =
        maker.palette.organ(look, prototype, leaf.part, leaf.color, lies, maker.name() + '_' + name);
    std::vector<ExportPart>& made = meshes[name];
    auto same = std::ranges::find(made, material, &ExportPart::material);
    if (same == made.end())
      made.push_back({std::move(leaf.surface), material});
    else
      append(same->surface, leaf.surface);
  }
  return meshes;
}

void Maker::add_bodies(const Look& look, std::span<const DrawnBody> bodies, std::span<const Solids> keys) {
  if (bodies.empty()) return;
  if (!options.instances) return add_in_place("body", body_parts(*this, look, bodies, keys));
  for (DrawnBody body : bodies) {
    std::vector<OrganPlace> places = std::exchange(body.places, {{Vec3(0), Quat(1, 0, 0, 0), Vec3(1)}});
    auto made = mesh(fmt::format("body_{}", body.shape), body_parts(*this, look, {&body, 1}));
    for (std::size_t i = 0; made && i < places.size(); ++i)
      place(*made, places[i].at, places[i].turn, places[i].scale);
  }
}

}  // namespace frond
