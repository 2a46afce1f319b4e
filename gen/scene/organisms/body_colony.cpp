#include "organisms/body_colony.h"

#include <algorithm>
#include <cmath>

#include "appearance/describe.h"

namespace frond {

void describe(Properties& v, TissueLook& t) {
  v.aspect(Aspect::look);
  v.color("color", t.color, "Colour of what stands out: walls, ridges");
  v.color("second", t.second, "Colour of what lies back: cups, valleys");
  v.number("cup", t.cup, metres(0.0005, 0.2), "Distance from one polyp to the next");
  v.number("relief", t.relief, {.min = 0, .max = 3}, "How deep the cups look; 0 is smooth");
  v.number("gloss", t.gloss, kShare, "How wet it looks: 0 matt");
  v.number("variation", t.variation, {.min = 0, .max = 0.5},
           "How much single ones differ in brightness, as a share");
  v.number(
      "dead", t.dead, {.min = 0, .max = 0.8},
      "Share of the skin that has died and is overgrown by algae, behind a pale border; each colony has a "
      "share of its own about this one");
  v.integer("scars", t.scars, {.min = 1, .max = 12}, "Number of patches that are dead. Needs dead above 0");
  describe(v, t.polyps);
}

Material material_of(const TissueLook& look, Matter matter, Seed seed) {
  auto bright = static_cast<float>(1 + look.variation * seed.child("brightness").range(-1, 1));
  auto toned = [&](Color c) {
    return Color{std::min(1.0f, c.red * bright), std::min(1.0f, c.green * bright),
                 std::min(1.0f, c.blue * bright)};
  };
  return {.matter = matter,
          .color = toned(look.color),
          .second = toned(look.second),
          .scale = look.cup,
          .relief = look.relief,
          .gloss = look.gloss,
          .polyps = look.polyps};
}

std::vector<DeadPatch> dead_patches(const TissueLook& look, const Surface& skin, Seed seed) {
  constexpr int kTries = 12;            // after which a patch lies also where nobody sees it
  constexpr float kFacesDown = -0.15f;  // height of the normals of such places
  constexpr float kLeast = 2e-4f;       // metres, radius of a patch that shows
  std::vector<DeadPatch> patches;
  if (look.dead <= 0 || skin.position.empty()) return patches;
  double area = 0;
  for (const auto& t : skin.triangle) area += 0.5 * static_cast<double>(glm::length(area_of(skin, t)));
  // Some colonies are whole, others mostly dead.
  double dead = area * std::min(0.9, look.dead * seed.child("share").range(0.2, 1.8));
  for (int i = 0; i < look.scars; ++i) {
    Seed own = seed.child("patch", static_cast<std::uint64_t>(i));
    std::size_t v = 0;
    for (std::uint64_t k = 0; k < kTries; ++k) {
      v = own.child(k).bits() % skin.position.size();
      if (skin.normal[v].y > kFacesDown) break;
    }
    double share = own.child("size").range(0.4, 1.6) / look.scars;
    auto radius = static_cast<float>(std::sqrt(share * dead / kPi));
    if (radius >= kLeast) patches.push_back({skin.position[v], radius});
  }
  return patches;
}

MarginWorld margin_world(const Surroundings& around) {
  MarginWorld world;
  world.room = [&around](Vec3 at, float within) { return around.room(at, within); };
  return world;
}

MarginStart ring_start(Vec3 middle, double radius, double turn, double arc, double pitch, double edge) {
  MarginStart start;
  start.closed = arc > 2 * kPi - 1e-6;
  start.from_middle = static_cast<float>(radius);
  int parts = std::max(start.closed ? 9 : 4, static_cast<int>(std::ceil(arc * radius / edge)));
  for (int i = 0; i < parts + (start.closed ? 0 : 1); ++i) {
    // Against the clock from above, so that the upper side is up.
    double angle = turn - arc * (static_cast<double>(i) / parts - 0.5);
    Vec3 out(std::cos(angle), 0, std::sin(angle));
    start.rim.push_back(middle + out * static_cast<float>(radius));
    start.heading.push_back(out * static_cast<float>(std::cos(pitch)) + Vec3(0, std::sin(pitch), 0));
  }
  return start;
}

void append(SheetBody& to, const SheetBody& more) {
  append(to.surface, more.surface);
  for (std::size_t k = 0; k < to.past.size(); ++k)
    to.past[k].insert(to.past[k].end(), more.past[k].begin(), more.past[k].end());
}

Errors check_edge(double edge, double across, double parts) {
  if (edge * parts <= across) return {};
  return {{"/edge", "found triangles that are too large for what is to grow; expected smaller ones"}};
}

SizeEstimate estimate_surface(double area, double edge) {
  constexpr double kSheetTriangle = 4e-6;  // seconds of one that is laid
  constexpr double kLongRow = 300;  // triangles across; in longer rows each is held against more others
  constexpr double kTriangles = 3;  // of both sides, on a square of the edge
  SizeEstimate sight;
  sight.triangles = kTriangles * area / (edge * edge);
  sight.area = area;
  sight.blocks = 1;
  double across = std::sqrt(area) / edge;
  sight.seconds = kSheetTriangle * sight.triangles * std::max(1.0, std::pow(across / kLongRow, 2));
  sight.held = kPastTriangle * sight.triangles;
  return sight;
}

SizeEstimate estimate_surface(const Accretion& law, double area) {
  constexpr double kLaidTriangle = 1.2e-7;  // seconds of one in one layer, when it has grown
  constexpr double kTriangles = 2.3;        // on a square of the edge: 4 / sqrt(3) where all are equilateral
  SizeEstimate sight;
  sight.triangles = kTriangles * area / (law.edge * law.edge);
  // Where a layer is thicker than triangles are wide, the skin folds, and is cut again and again.
  double thick = std::max(law.across, law.up) / law.layers / law.edge;
  sight.triangles *= std::clamp(0.35 * std::pow(thick, 1.8), 1.0, 8.0);
  sight.seconds = kLaidTriangle * law.layers * sight.triangles * std::clamp(1.5 * thick, 1.0, 3.0);
  sight.area = sight.triangles * law.edge * law.edge / kTriangles;
  sight.blocks = 1;
  sight.held = kPastTriangle * sight.triangles;
  return sight;
}

AccretionWorld accretion_world(const Surroundings& around) {
  return {[&](Vec3 at, float within) { return around.room(at, within); },
          [&](Vec3 at) { return around.light(at); }};
}

Model model_of(Surface skin, std::vector<std::vector<Vec3>> past, const TissueLook& look, Matter matter,
               Seed seed) {
  Solid solid{std::move(skin), material_of(look, matter, seed)};
  solid.past = std::move(past);
  solid.material.dead = dead_patches(look, solid.surface, seed.child("scars"));
  Model model;
  model.solids.place(model.solids.add_shape(std::move(solid)));
  return model;
}

Model model_of(SheetBody body, const TissueLook& look, Matter matter, Seed seed) {
  return model_of(std::move(body.surface), std::move(body.past), look, matter, seed);
}

}  // namespace frond
