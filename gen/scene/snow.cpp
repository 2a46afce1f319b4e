#include "scene/snow.h"

#include <algorithm>
#include <cmath>

#include "land/snow.h"
#include "scene/camera.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr int kRings[] = {180, 260, 340};  // of the mesh on the ground, of each Quality
constexpr float kAround = 20;   // metres from its middle within which bodies shelter and trunks have hollows
constexpr double kRadius = 45;  // metres beyond the camera's way

Vec2 level(Vec3 p) { return {p.x, p.z}; }

/// Metres of a pixel where the camera comes nearest to a box.
double nearest_pixel_of(const Scene& scene, const Bounds& box) {
  const Camera& camera = scene.stage.camera;
  double nearest = 1e30, length = scene.film.length();
  for (int i = 0; i <= 8; ++i) {
    Vec3 eye = camera.location.at(length * i / 8);
    nearest = std::min<double>(nearest, glm::distance(eye, glm::clamp(eye, box.low, box.high)));
  }
  return 2 * std::tan(radians(camera.angle.at(0)) / 2) * std::max(nearest, 0.5) / scene.film.size[0];
}

/// Trunks that come out of the ground: of what has a skeleton, and of sown trees.
std::vector<SnowTrunk> trunks_of(const Scene& scene, Vec2 middle) {
  constexpr float kLeast = 0.015f;  // metres of radius
  std::vector<SnowTrunk> trunks;
  auto add = [&](Vec3 at, float radius) {
    if (radius >= kLeast && glm::distance(level(at), middle) < kAround) trunks.push_back({level(at), radius});
  };
  for (const Specimen& s : scene.specimens) {
    const Skeleton& bones = s.model.skeleton;
    if (s.life.hanging) continue;
    for (std::size_t i = 0; i < bones.size(); ++i)
      if (bones.parent[i] == Skeleton::kRoot) add(bones.position[i], bones.radius[i]);
  }
  for (const SownStand& stand : scene.stands)
    for (std::size_t i = 0; i < stand.copies.size(); ++i)
      if (stand.organism.sown->where.layer == Layer::canopy)
        add(stand.copies.foot[i],
            0.5f * stand.copies.scale[i] * static_cast<float>(stand.organism.sown->where.stem));
  return trunks;
}

Model snow_model(const std::vector<SnowSheet>& sheets, double depth) {
  Model model;
  if (depth <= 0) return model;
  for (const SnowSheet& sheet : sheets)
    model.solids.place(model.solids.add_shape(
        {snow_surface(sheet, depth), {.matter = Matter::snow, .color = {0.97f, 0.975f, 0.985f}}}));
  return model;
}

}  // namespace

std::optional<Specimen> lying_snow(const Scene& scene, Grounds& ground, Seed seed) {
  const Snow& snow = scene.stage.snow;
  double deepest = snow.deepest();
  if (!is_snowy(scene.stage) || deepest <= 0) return {};
  auto [middle, reach] = seen_ground(scene.stage.camera, scene.film.length());
  Overhead bodies(middle, 2 * kAround, 0.08f);
  std::vector<Surface> skins;
  for (const Specimen& s : scene.specimens)
    if (s.entry != Specimen::kNoEntry && s.model.solids.size() > 0) {
      skins.push_back(merged(s.model.solids));
      bodies.take(skins.back());
    }
  auto seat = [&](Vec2 at) { return static_cast<double>(ground.seat(at, 0, seed)); };
  SnowLand land{seat, middle, kRadius + reach, kRings[static_cast<std::size_t>(scene.film.quality)],
                trunks_of(scene, middle)};
  SnowWind wind{-Vec2(std::sin(snow.wind), std::cos(snow.wind)), snow.drift};
  std::vector<SnowSheet> sheets{snow_on_ground(land, bodies, wind, seed)};
  for (const Surface& skin : skins) {
    auto cell =
        static_cast<float>(std::clamp(1.2 * nearest_pixel_of(scene, bounds_of(skin.position)), 0.008, 0.06));
    SnowSheet cap = snow_on_body(skin, deepest, cell, [&](Vec3 at) { return bodies.openness(at); });
    if (!cap.triangle.empty()) sheets.push_back(std::move(cap));
  }
  Specimen lying;
  lying.name = "snow";
  lying.model = snow_model(sheets, deepest);
  if (!snow.depth.constant())
    lying.life.develop = [depth = snow.depth, sheets = std::move(sheets)](double time) -> Result<Model> {
      return snow_model(sheets, depth.at(time));
    };
  return lying;
}

}  // namespace frond
