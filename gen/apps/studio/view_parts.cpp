#include <map>

#include "draw/bough_snow.h"
#include "export/materials.h"
#include "geometry/far.h"
#include "studio/tiles.h"
#include "studio/view.h"

namespace frond {

namespace {

constexpr std::size_t kManyTriangles = 10'000;  // in all places together: fewer are quick to draw
constexpr double kSnowPixel = 0.006;            // metres, see bough_snow()
constexpr std::uint32_t kLoose = 200;  // pieces: a surface of more has no skin that one could simplify

DrawnPart& mesh_part(std::vector<DrawnPart>& parts, Json material) {
  DrawnPart& part = parts.emplace_back();
  part.head["kind"] = "mesh";
  part.head["material"] = std::move(material);
  return part;
}

/// Branches that have grown together, smooth or rough, or cubes.
Result<DrawnPart> body_part(const DrawnBranches& branches) {
  Result<FusedMesh> mesh = branches.body();
  if (!mesh) return mesh.errors();
  BranchColors colors(branches);
  std::vector<std::uint8_t> painted;
  painted.reserve(4 * mesh->node.size());
  for (std::int32_t i : mesh->node) push(painted, colors.at(i, i));
  DrawnPart part;
  part.head["kind"] = "mesh";
  part.head["material"] = material_json({.color = {}, .gloss = branches.look().gloss()});
  if (branches.traits.style.build != Build::voxels)
    if (auto tile = tile_of(branches.look())) part.head["material"]["tile"] = json_of(*tile);
  part.add_surface("", mesh->surface);
  part.add("/colors", painted);
  return part;
}

/// Placements of one mesh.
struct PlacedMesh {
  std::vector<float> at;
  std::vector<std::uint8_t> color;
};

void add_organs(const DrawList& drawn, std::vector<DrawnPart>& parts) {
  // By prototype; where colours are pictures, by these too.
  std::map<std::pair<std::size_t, std::size_t>, PlacedMesh> groups;
  for (const OrganGroup& drawn_group : drawn.organs.groups) {
    const Prototype& prototype = drawn.model.prototypes[drawn_group.prototype];
    bool pictured =
        std::ranges::any_of(prototype.parts, [](const OrganPart& p) { return !p.pictures.empty(); });
    PlacedMesh& group = groups[{drawn_group.prototype, pictured ? drawn_group.color : 0}];
    for (const OrganPlace& place : drawn.organs.places(drawn_group)) {
      push(group.at, place.at, glm::normalize(place.turn), place.scale);
      push(group.color, drawn_group.tint);
    }
  }
  for (const auto& [key, group] : groups) {
    const Prototype& prototype = drawn.model.prototypes[key.first];
    for (std::size_t k = 0; k < prototype.parts.size(); ++k) {
      const OrganPart& shape = prototype.parts[k];
      if (shape.surface.triangle.empty()) continue;
      PlainLook look = plain_look(prototype, k, key.second);
      DrawnPart& part = mesh_part(parts, material_json(look));
      add_placed(part, shape.surface, group.at, look.both_sides);
      if (shape.tissue != Tissue::heart && shape.pictures.empty()) part.add("/instance_colors", group.color);
    }
  }
}

/// The shades of a colour together.
void add_blades(const DrawList& drawn, std::vector<DrawnPart>& parts) {
  const BladeLook& look = drawn.traits.look.blades;
  for (std::size_t k = 0; k < drawn.blades.size();) {
    Surface surface = drawn.blades[k].surface;
    std::size_t color = drawn.blades[k].color;
    for (++k; k < drawn.blades.size() && drawn.blades[k].color == color; ++k)
      append(surface, drawn.blades[k].surface);
    DrawnPart& part = mesh_part(parts, material_json(plain_look(look, color)));
    part.add_surface("", surface);
  }
}

void add_bodies(const std::vector<DrawnBody>& bodies, std::vector<DrawnPart>& parts) {
  for (const DrawnBody& body : bodies) {
    if (body.surface().triangle.empty()) continue;
    std::vector<float> at;
    for (const OrganPlace& place : body.places) push(at, place.at, place.turn, place.scale);
    DrawnPart& part = mesh_part(parts, material_json(plain_look(body.solid->material)));
    auto tile = tile_of(*body.solid);
    if (tile) part.head["material"]["tile"] = json_of(*tile);
    if (const Material& stone = body.solid->material; tile && !tile->unrolled && stone.moss > 0)
      part.head["material"]["moss"] = {{"share", stone.moss}, {"scale", stone.scale}};
    Surface surface = body.surface();
    if (tile && tile->unrolled) surface.uv = on_vessel(std::move(surface.uv));
    add_placed(part, surface, at, false);
  }
}

/// The snow on its boughs, as in POV-Ray's pictures but for what is thinner than a view shows.
void add_bough_snow(const DrawList& drawn, double time, std::vector<DrawnPart>& parts) {
  BoughSnow snow = bough_snow(drawn, time, kSnowPixel);
  Json white = material_json({.color = {0.985f, 0.988f, 0.992f}, .gloss = 0.1, .both_sides = true});
  for (const Surface* surface : {&snow.heaps, &snow.ridges}) {
    if (surface->triangle.empty()) continue;
    DrawnPart& part = mesh_part(parts, white);
    part.add_surface("", *surface);
  }
  if (snow.tufts.empty()) return;
  std::vector<float> at;
  for (const OrganPlace& tuft : snow.tufts) push(at, tuft.at, glm::normalize(tuft.turn), tuft.scale);
  DrawnPart& part = mesh_part(parts, white);
  add_placed(part, tuft_surface(), at, false);
}

}  // namespace

void push(std::vector<float>& places, Vec3 at, Quat turn, Vec3 scale) {
  places.insert(places.end(), {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w, scale.x, scale.y, scale.z});
}

void push(std::vector<std::uint8_t>& colors, const Color& color) {
  for (float x : {color.red, color.green, color.blue})
    colors.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))));
  colors.push_back(255);
}

Json material_json(const PlainLook& look) {
  Json json{{"color", json_of(look.color)}, {"gloss", look.gloss}, {"both_sides", look.both_sides}};
  if (look.light_through > 0) json["light_through"] = look.light_through;
  if (look.opacity < 1) json["opacity"] = look.opacity;
  if (!look.picture.empty()) json["picture"] = look.picture;
  return json;
}

void add_placed(DrawnPart& part, const Surface& surface, std::span<const float> places, bool leaf) {
  part.add_surface("", surface);
  part.add("/instances", places);
  if (places.size() / 10 * surface.triangle.size() < kManyTriangles) return;
  Json& list = part.head["coarse"] = Json::array();
  float largest = 0;  // of the copies' scales
  for (std::size_t i = 7; i < places.size(); ++i)
    if (i % 10 >= 7) largest = std::max(largest, std::abs(places[i]));
  auto add = [&](const Surface& coarse, double size) {
    if (coarse.triangle.size() * 2 > surface.triangle.size() || coarse.triangle.empty()) return;
    std::string below = "/coarse/" + std::to_string(list.size());
    list.push_back({{"size", size * largest}});
    part.add_surface(below, coarse);
  };
  auto reach = static_cast<double>(reach_of(surface.position));
  if (leaf) {
    Pieces pieces = pieces_of(surface);
    add(far_leaves(surface, pieces), std::sqrt(area(surface) / std::max(1u, pieces.count)));
    if (pieces.count > 1) add(one_far_leaf(surface, pieces), reach);
  } else if (Pieces pieces = pieces_of(surface); pieces.count > kLoose) {
    // A crown of loose leaves: some of them, larger, stand for all.
    for (int stride : {6, 40})
      add(far_leaves(surface, pieces, stride, FarLeaf::triangle),
          std::sqrt(area(surface) * stride / pieces.count));
    add(simplified(surface, 8), reach);
  } else {
    // One that keeps the seams of its picture, where it has one.
    add(surface.uv.empty() ? simplified(surface, surface.triangle.size() / 12)
                           : reduced(surface, surface.triangle.size() / 12),
        reach / 8);
    add(simplified(surface, 8), reach);
  }
}

Result<std::vector<DrawnPart>> specimen_parts(const Specimen& specimen, double time) {
  DrawList drawn(specimen, time);
  std::vector<DrawnPart> parts;
  if (drawn.branches && drawn.branches->rest().size() > 1) {
    if (drawn.branches->form() == BranchForm::body) {
      Result<DrawnPart> body = body_part(*drawn.branches);
      if (!body) return body.errors();
      parts.push_back(std::move(*body));
    } else {
      parts = tubes_parts(*drawn.branches);
    }
  }
  add_organs(drawn, parts);
  add_blades(drawn, parts);
  add_bodies(drawn.bodies, parts);
  add_bough_snow(drawn, time, parts);
  return parts;
}

}  // namespace frond
