#include "scene/snow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/noise.h"
#include "core/parallel.h"
#include "land/snow.h"
#include "scene/camera.h"
#include "scene/entry_seeds.h"
#include "scene/wind.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr int kRings[] = {180, 260, 340};  // of the mesh on the ground, of each Quality
constexpr float kAround = 20;   // metres from its middle within which bodies shelter and trunks have hollows
constexpr double kRadius = 45;  // metres beyond the camera's way

Vec2 level(Vec3 p) { return {p.x, p.z}; }

/// Metres of a pixel where the camera comes nearest to a box.
double nearest_pixel_of(const Scene& scene, const Bounds& box) {
  const Camera& camera = scene.setup.camera;
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
  for (const CopySet& set : scene.copy_sets)
    for (std::size_t i = 0; i < set.copies.size(); ++i)
      if (set.organism.sown->where.layer == Layer::canopy)
        add(set.copies.foot[i],
            0.5f * set.copies.scale[i] * static_cast<float>(set.organism.sown->where.stem));
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

/// The bodies that the preset names.
std::vector<Surface> skins_of(const Scene& scene) {
  std::vector<Surface> skins;
  for (const Specimen& s : scene.specimens)
    if (s.entry != Specimen::kNoEntry && s.model.solids.size() > 0) skins.push_back(merged(s.model.solids));
  return skins;
}

constexpr float kBoughLength = 0.8f;  // metres of wood that drop their snow as one
constexpr float kFirmRadius = 0.05f;  // metres of what is too thick to be shaken
constexpr double kMoments = 8;        // a second

/// How likely a bough at a place is to drop its snow, summed up from the film's beginning to each moment: in
/// calm air, by the pressure of the wind, and as much of it thaws.
std::vector<double> hazard_at(const Scene& scene, const WindField& wind, Vec3 place) {
  constexpr double kShaken = 2;  // m/s near the ground that double the chance
  const Snow& snow = scene.setup.snow;
  std::vector<double> sum{0};
  for (int i = 1; i <= kMoments * scene.film.length(); ++i) {
    double time = i / kMoments, speed = kLowWind * wind.speed * (1 + wind.gust(place, time)) / kShaken;
    double thawed = std::max(0.0, snow.depth.at(time - 1 / kMoments) - snow.depth.at(time));
    sum.push_back(sum.back() + snow.shed / 6000 / kMoments * (1 + speed * speed) + thawed / snow.deepest());
  }
  return sum;
}

/// When a sum passes a level, seconds; infinity where it does not.
float passing(const std::vector<double>& sum, double level) {
  auto after = std::ranges::upper_bound(sum, level);
  if (after == sum.begin() || after == sum.end()) return std::numeric_limits<float>::infinity();
  double last = after[-1];
  return static_cast<float>(
      (static_cast<double>(after - sum.begin() - 1) + (level - last) / (*after - last)) / kMoments);
}

SnowLoad load_of(const Scene& scene, const Skeleton& bones, const WindField& wind, Seed seed) {
  SnowLoad load{scene.setup.snow.depth, {}, {}, {}, {}};
  std::vector<float> begins;  // of each bough, its distance along the branches
  for (std::size_t i = 0; i < bones.size(); ++i) {
    Vec3 at = bones.position[i];
    // Patches of some decimetres, lumps of some centimetres.
    double lumpy = 0.8 + 0.7 * noise(2.2f * at) + 0.35 * noise(9.0f * at);
    load.share.push_back(static_cast<float>(std::clamp(lumpy, 0.0, 1.2)) * scene.overhead->openness(at));
    std::int32_t p = bones.parent[i];
    bool same = p != Skeleton::kRoot;
    std::int32_t bough = same ? load.bough[static_cast<std::size_t>(p)] : 0;
    same = same && bones.distance[i] - begins[static_cast<std::size_t>(bough)] < kBoughLength;
    if (!same) {
      bough = static_cast<std::int32_t>(begins.size());
      begins.push_back(bones.distance[i]);
      double lot = -std::log(1 - seed.child(static_cast<std::uint64_t>(bough)).unit());
      load.drops.push_back(bones.radius[i] > kFirmRadius ? std::numeric_limits<float>::infinity()
                                                         : passing(hazard_at(scene, wind, at), lot));
    }
    load.bough.push_back(bough);
  }
  return load;
}

/// The seeds of the snow on each specimen, and of its powder.
struct SnowSeeds {
  Seed load, powder;
};

/// They hang on the number of the specimen in the scene, and from version 2 on on that among those of its
/// entry.
std::vector<SnowSeeds> snow_seeds(const Scene& scene, const Preset& preset) {
  std::vector<Seed> entries = entry_seeds(preset, "boughs");
  std::map<std::size_t, std::uint64_t> met;
  std::vector<SnowSeeds> seeds;
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    std::size_t entry = scene.specimens[i].entry;
    Seed own = entry < entries.size() ? entries[entry].child(met[entry]++) : scene.seed.child("setting", i);
    if (preset.version < 2)
      seeds.push_back({scene.seed.child("boughs").child("specimen", i), scene.seed.child("powder", i)});
    else
      seeds.push_back({own.child("load"), own.child("powder")});
  }
  return seeds;
}

}  // namespace

int snow_rings(Quality quality) { return kRings[static_cast<std::size_t>(quality)]; }

void load_boughs(Scene& scene, const Preset& preset) {
  if (scene.setup.snow.deepest() <= 0) return;
  std::vector<SnowSeeds> seeds = snow_seeds(scene, preset);
  WindField wind = wind_in(scene).value_or(WindField{});
  parallel_for(scene.specimens.size(), [&](std::size_t i) {
    Specimen& s = scene.specimens[i];
    if (s.model.skeleton.size() == 0 || s.life.develop || s.life.hanging || s.life.fall) return;
    SnowLoad load = load_of(scene, s.model.skeleton, wind, seeds[i].load);
    load.powder = seeds[i].powder;
    s.load = std::make_shared<const SnowLoad>(std::move(load));
  });
}

CoverGrid bodies_overhead(const Scene& scene) {
  CoverGrid bodies(seen_ground(scene.setup.camera, scene.film.length()).first, 2 * kAround, 0.08f);
  for (const Surface& skin : skins_of(scene)) bodies.add(skin);
  return bodies;
}

std::optional<Specimen> lying_snow(const Scene& scene, Grounds& ground, Seed seed) {
  const Snow& snow = scene.setup.snow;
  double deepest = snow.deepest();
  if (!is_snowy(scene.setup) || deepest <= 0) return {};
  auto [middle, reach] = seen_ground(scene.setup.camera, scene.film.length());
  const CoverGrid& bodies = *scene.overhead;
  double sown = ground.land({}).size;
  auto kept = [&](Vec2 at) { return snow.depth_map.on_land(at, sown); };
  auto seat = [&](Vec2 at) { return static_cast<double>(ground.seat(at, 0, seed)); };
  SnowLand land{seat, middle, kRadius + reach, snow_rings(scene.film.quality), trunks_of(scene, middle),
                kept};
  SnowWind wind{-Vec2(std::sin(snow.wind), std::cos(snow.wind)), snow.drift};
  std::vector<SnowSheet> sheets{snow_on_ground(land, bodies, wind, seed)};
  for (const Surface& skin : skins_of(scene)) {
    auto cell =
        static_cast<float>(std::clamp(1.2 * nearest_pixel_of(scene, bounds_of(skin.position)), 0.008, 0.06));
    SnowSheet cap = snow_on_body(skin, deepest, cell, [&](Vec3 at) {
      return bodies.openness(at) * static_cast<float>(kept(level(at)));
    });
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
