#include <array>
#include <map>

#include "draw/organs.h"
#include "draw/sweep.h"
#include "export/export_scene.h"
#include "geometry/far.h"
#include "motion/unfold.h"
#include "studio/view.h"

namespace frond {

namespace {

constexpr double kLeafGloss = 0.2, kLightThroughLeaf = 0.35;
constexpr std::size_t kManyTriangles = 10'000;  // in all places together: fewer are quick to draw

void push(std::vector<float>& to, Vec3 at, Quat turn, Vec3 scale) {
  to.insert(to.end(), {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w, scale.x, scale.y, scale.z});
}

void push(std::vector<std::uint8_t>& to, const Color& c) {
  for (float x : {c.red, c.green, c.blue})
    to.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))));
  to.push_back(255);
}

/// Branches that have grown together, or cubes.
Result<DrawnPart> body_part(const Specimen& s, const Pose& pose) {
  Result<FusedMesh> mesh = body_mesh(s, pose);
  if (!mesh) return mesh.errors();
  BranchColors colors(s.look, s.brightness);
  float longest = s.model.skeleton.longest();
  std::vector<std::uint8_t> painted;
  painted.reserve(4 * mesh->node.size());
  for (std::int32_t i : mesh->node)
    push(painted,
         colors.at(s.model, i,
                   youth(s.model.skeleton, pose, longest, static_cast<float>(colors.young_length), i)));
  DrawnPart part;
  part.head["kind"] = "mesh";
  part.head["material"] = material_json({}, s.look.branches.gloss());
  part.add_surface("", mesh->surface);
  part.add("/colors", painted);
  return part;
}

/// Placements of one mesh.
struct PlacedMesh {
  std::vector<float> at;
  std::vector<std::uint8_t> color;
};

void add_organs(const Specimen& s, const Pose& pose, double time, std::vector<DrawnPart>& parts) {
  DrawnOrgans drawn(s, pose, time);
  // By prototype; where colours are pictures, by these too.
  std::map<std::pair<std::size_t, std::size_t>, PlacedMesh> groups;
  for (const OrganGroup& drawn_group : drawn.groups) {
    const Prototype& prototype = s.model.prototypes[drawn_group.prototype];
    bool pictured =
        std::ranges::any_of(prototype.parts, [](const OrganPart& p) { return !p.pictures.empty(); });
    PlacedMesh& group = groups[{drawn_group.prototype, pictured ? drawn_group.color : 0}];
    for (std::uint32_t i : drawn.organs(drawn_group)) {
      OrganPlace place = drawn.place(i);
      push(group.at, place.at, glm::normalize(place.turn), place.scale);
      push(group.color, drawn_group.tint);
    }
  }
  for (const auto& [key, group] : groups) {
    const Prototype& prototype = s.model.prototypes[key.first];
    for (const OrganPart& shape : prototype.parts) {
      if (shape.surface.triangle.empty()) continue;
      bool leaf = is_leaf(shape.tissue), heart = shape.tissue == Tissue::heart;
      DrawnPart& part = parts.emplace_back();
      part.head["kind"] = "mesh";
      Json material =
          material_json(heart ? prototype.second : prototype.colors[key.second], kLeafGloss, leaf);
      if (leaf) material["light_through"] = kLightThroughLeaf;
      if (!shape.pictures.empty()) material["picture"] = shape.pictures[key.second % shape.pictures.size()];
      part.head["material"] = std::move(material);
      add_placed(part, shape.surface, group.at, leaf);
      if (!heart && shape.pictures.empty()) part.add("/instance_colors", group.color);
    }
  }
}

void add_blades(const Specimen& s, const Pose& pose, std::vector<DrawnPart>& parts) {
  const BladeLook& look = s.look.blades;
  for (std::size_t k = 0; s.model.blades.size() > 0 && k < look.colors.size(); ++k) {
    Surface surface = posed_blades(
        s.model.skeleton, pose, s.model.blades, s.motion.growth.ripen,
        [&](std::size_t i) { return color_index(s.model.blades.color[i], look.colors.size()) == k; });
    if (surface.triangle.empty()) continue;
    DrawnPart& part = parts.emplace_back();
    part.head["kind"] = "mesh";
    part.head["material"] = material_json(look.colors[k], kLeafGloss, true);
    part.head["material"]["light_through"] = kLightThroughLeaf;
    part.add_surface("", surface);
  }
}

void add_solids(const Solids& solids, std::vector<DrawnPart>& parts) {
  for (std::size_t shape = 0; shape < solids.shapes.size(); ++shape) {
    std::vector<float> at;
    for (std::size_t i = 0; i < solids.size(); ++i)
      if (solids.shape[i] == shape) push(at, solids.position[i], solids.turn[i], solids.scale[i]);
    const Solid& solid = solids.shapes[shape];
    if (at.empty() || solid.surface.triangle.empty()) continue;
    DrawnPart& part = parts.emplace_back();
    part.head["kind"] = "mesh";
    part.head["material"] = material_json(solid.material.color, solid.material.gloss);
    if (solid.material.matter == Matter::glass) part.head["material"]["opacity"] = 0.35;
    add_placed(part, solid.surface, at, false);
  }
}

}  // namespace

Json material_json(const Color& color, double gloss, bool both_sides) {
  return {{"color", json_of(color)}, {"gloss", gloss}, {"both_sides", both_sides}};
}

void add_placed(DrawnPart& part, const Surface& surface, std::span<const float> places, bool leaf) {
  part.add_surface("", surface);
  part.add("/instances", places);
  if (places.size() / 10 * surface.triangle.size() < kManyTriangles) return;
  Json& list = part.head["coarse"] = Json::array();
  auto add = [&](const Surface& coarse, double size) {
    if (coarse.triangle.size() * 2 > surface.triangle.size() || coarse.triangle.empty()) return;
    std::string below = "/coarse/" + std::to_string(list.size());
    list.push_back({{"size", size}});
    part.add_surface(below, coarse);
  };
  double reach = 0;
  for (const Vec3& p : surface.position) reach = std::max<double>(reach, glm::length(p));
  if (leaf) {
    Pieces pieces = pieces_of(surface);
    add(far_leaves(surface, pieces), std::sqrt(area(surface) / std::max(1u, pieces.count)));
    if (pieces.count > 1) add(one_far_leaf(surface, pieces), reach);
  } else {
    add(simplified(surface, surface.triangle.size() / 12), reach / 8);
    add(simplified(surface, 8), reach);
  }
}

Result<std::vector<DrawnPart>> specimen_parts(const Specimen& specimen, double time) {
  Pose pose;
  pose_specimen(specimen, time, pose);
  std::vector<DrawnPart> parts;
  if (specimen.look.branches.drawn() && specimen.model.skeleton.size() > 1) {
    if (specimen.style.build == Build::sweeps) {
      parts.push_back(tubes_part(specimen, pose));
    } else {
      Result<DrawnPart> body = body_part(specimen, pose);
      if (!body) return body.errors();
      parts.push_back(std::move(*body));
    }
  }
  add_organs(specimen, pose, time, parts);
  add_blades(specimen, pose, parts);
  add_solids(specimen.model.solids, parts);
  return parts;
}

}  // namespace frond
