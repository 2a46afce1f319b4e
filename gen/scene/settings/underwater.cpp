#include "settings/underwater.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "settings/settings.h"

namespace frond {

void describe(Properties& v, Strobe& s) {
  v.integer("count", s.count, {.min = 1, .max = 2}, "1: one above the camera; 2: one on each side of it");
  v.number("apart", s.apart, {.min = 0, .max = 10, .unit = "m"}, "Distance between two");
  v.number("power", s.power, {.min = 0, .max = 100},
           "Brightness that all together give a white surface at `reach` in clear water; 1: as the sun does "
           "at the surface");
  v.number("reach", s.reach, {.min = 0.1, .max = 20, .unit = "m"},
           "Distance at which they give that; beyond, light falls off with the square of the distance, and "
           "the water takes of it, out and back");
  v.number("angle", s.angle, {.min = 1, .max = 170, .unit = "degrees"},
           "Width of the beam, whose edge is soft: 100 a strobe with a diffuser, 15 a torch");
  v.color("color", s.color, "Colour of its light");
}

void describe(Properties& v, Water& w) {
  v.choice("jerlov", w.type, kWaterTypes,
           "Jerlov's optical type of the water: each colour fades with distance, and with `depth`, by its "
           "measured coefficients, and the veil's colour follows. `near`, `deep` and `visibility` do nothing "
           "then");
  v.color("near", w.near, "Colour that everything fades to with distance");
  v.color("deep", w.deep, "Colour of the depth below the horizon");
  v.number("visibility", w.visibility, {.min = 0.5, .max = 1000, .unit = "m"},
           "Distance at which two thirds of a colour are lost in the water");
  v.number(
      "depth", w.depth, {.min = 0, .max = 60, .unit = "m"},
      "Depth whose colour the light has: red goes first, then green; 0 is as a photographer's lamp shows it");
  v.direction("sun", w.sun, "Direction toward the sun");
  v.number("caustics", w.caustics, {.min = 0, .max = 1.5},
           "How strongly waves focus the light into moving lines on the ground");
  v.number("shafts", w.shafts, {.min = 0, .max = 1}, "How strong the beams of light in the water are");
  v.integer("particles", w.particles, {.min = 0, .max = 1000},
            "Number of specks that drift before the camera");
  v.number("daylight", w.daylight, {.min = 0, .max = 1}, "Share of the daylight that there is; 0 at night");
  v.number("fill", w.fill, {.min = 0, .max = 4},
           "How much light the water scatters to what faces aside or down, as a factor; more lightens shaded "
           "sides");
  v.number("white_balance", w.balance, {.min = 0, .max = 1},
           "How far the camera makes up for the colour of the daylight at `depth`, with `jerlov`: 0 set to "
           "the light at the surface, 1 to a white card at that depth");
  v.object("strobe", w.strobe, "A diver's flashes or torch, which go with the camera");
}

namespace {

constexpr int kStoneShapes = 5;
constexpr int kRockLooks = 3;
constexpr Color kSand{0.78f, 0.72f, 0.58f}, kStone{0.47f, 0.45f, 0.40f};
constexpr double kFloorRadius = 32;  // metres, at least: as far as the water lets one see
constexpr double kEvenFloor = 512;   // metres to which what is near is as fine as without a far camera
constexpr double kFloorBeyond = 4;   // metres from what stands farthest out to the edge, at least
constexpr double kSownSize = 44;     // metres, a square within that
constexpr int kFloorRings = 60;      // of the floor's mesh, at its least radius
constexpr float kStoneSunk = 0.35f, kRockSunk = 0.3f;  // share of the height that is in the ground

/// The water brightens toward the surface: by eye.
std::vector<BackdropStop> water_backdrop(Vec3 fog, Vec3 near) {
  return {{0, fog},
          {0.06, 1.15f * near},
          {0.14, 1.8f * near},
          {0.28, 2.6f * near},
          {0.52, 3.6f * near + 0.05f},
          {1, 4.0f * near + 0.25f}};
}

/// Its light goes over from horizon to zenith as photographs of open water do: by eye.
std::vector<BackdropStop> veil_backdrop(Vec3 veil) {
  return {{0, veil},           {0.06, 1.2f * veil}, {0.14, 1.6f * veil},
          {0.28, 2.3f * veil}, {0.52, 3.3f * veil}, {1, 4.5f * veil}};
}

/// The light in water of a type: all of its colours follow from the water.
void light_by_type(Daylight& light, const Water& water) {
  WaterOptics optics = water_optics(*water.type, water.depth);
  constexpr float kAbove = 0.8f;  // of the sky, by eye
  constexpr float kVeil = 0.1f;   // of the light on a level white surface, where all is scattered: by eye
  Vec3 veil = kVeil * (kSunAtSurface * light.sun.y + kAbove) * optics.veil;
  light.sunlight = kSunAtSurface * optics.passed;
  light.above = kAbove * optics.passed;
  light.aside = veil;
  light.below = 0.15f * veil;
  light.zenith = seen_color(2.0f * veil);
  light.horizon = seen_color(veil);
  light.fog = veil;
  light.backdrop = veil_backdrop(veil);
  light.fade = 1 / static_cast<double>(optics.direct.g);
  light.fill = {
      .above = 0.5f * optics.passed, .aside = veil, .below = 0.3f * veil, .eye = 0.3f * optics.passed};
}

/// The water scatters: from above most, from all sides, a little from below. `stops`: of exposure.
Daylight water_light(const Water& water, double stops) {
  // Kd of clear ocean water, Jerlov's type IB, at 620, 540 and 460 nm: what a metre takes of the light.
  constexpr Vec3 kTaken(0.30f, 0.072f, 0.041f);
  Vec3 left = glm::exp(-static_cast<float>(water.depth) * kTaken);
  Vec3 near = linear(water.near), tint = near / std::max({near.x, near.y, near.z});
  // All shares from here on are by eye.
  Daylight light{.sun = glm::normalize(water.sun), .sunlight = kSunAtSurface * left, .soft = true};
  light.brightest = kSunAtSurface.r;
  light.above = 0.8f * (0.4f * tint + 0.6f) * left;
  light.aside = 0.26f * (0.6f * tint + 0.4f);
  light.below = 0.1f * tint;
  light.thrown_back = {0.36f, 0.32f, 0.26f};
  light.zenith = light.horizon = water.near;
  light.fog = 0.65f * near + 0.35f * linear(water.deep);
  light.backdrop = water_backdrop(light.fog, near);
  light.fill = {.above = 0.3f * tint + 0.26f,
                .aside = 0.22f * tint + 0.08f,
                .below = 0.24f * Vec3(0.5f, 0.46f, 0.38f) + 0.15f * tint + 0.02f,
                .eye = 0.2f * tint + 0.2f};
  light.ground = kSand;
  light.fade = water.visibility;
  if (water.type) light_by_type(light, water);
  for (Vec3* scattered : {&light.aside, &light.below, &light.fill.aside, &light.fill.below})
    *scattered *= static_cast<float>(water.fill);
  Vec3 exposed = static_cast<float>(water.daylight * std::exp2(stops)) * white_balance(water).daylight;
  for (Vec3* part : {&light.sunlight, &light.above, &light.aside, &light.below, &light.fog, &light.fill.above,
                     &light.fill.aside, &light.fill.below, &light.fill.eye})
    *part *= exposed;
  for (BackdropStop& stop : light.backdrop) stop.light *= exposed;
  return light;
}

/// How finely stones are meshed: facets show sooner in careful pictures.
int stone_detail(Quality quality) { return quality == Quality::best ? 5 : 4; }

}  // namespace

WhiteBalance white_balance(const Water& water) {
  if (!water.type || water.balance <= 0) return {};
  WaterOptics optics = water_optics(*water.type, water.depth);
  Vec3 share(static_cast<float>(water.balance));
  return {glm::pow(optics.passed.g / optics.passed, share),
          glm::pow(optics.metered.g / optics.metered, share)};
}

double caustic_contrast(const Water& water) {
  if (!water.type) return 1;
  // Waves focus the sun some metres below them; farther down more and more of its beams overlap, and their
  // contrast falls off with the root of their number. It is lost with the light that is scattered, too, of
  // which half goes on within four degrees (Petzold 1972) and still counts to the beam.
  constexpr double kFocus = 3, kAside = 0.5;  // metres; of what is scattered
  return std::sqrt(kFocus / std::max(kFocus, water.depth)) *
         std::exp(-kAside * water_optics(*water.type, 0).scattering * water.depth);
}

SeaFloor::SeaFloor(const Floor& floor, Quality quality, double reach, Seed seed)
    : loose_(floor), seed_(seed) {
  double radius = std::max(kFloorRadius, reach + kFloorBeyond);
  lay(ground_surface(Ground{seed.child("ground"), floor.relief, floor.scale}, Vec2(0),
                     GroundDisc{kFloorRadius, kFloorRings}.reaching(radius, kEvenFloor)));
  for (int i = 0; i < kStoneShapes; ++i) {
    Seed own = seed.child("stone shape", static_cast<std::uint64_t>(i));
    shapes_.push_back({own, own.child("roughness").range(0.3, 0.6), own.child("flatness").range(0.2, 0.45)});
    stones.push_back(stone_surface(shapes_.back(), stone_detail(quality)));
  }
}

/// Lays a stone so that `sunk` of its height is in the ground, and returns how high its top is above the
/// place.
float SeaFloor::lay_stone(Vec2 at, float width, float sunk, Seed seed) {
  StoneInstance stone;
  stone.shape = static_cast<int>(seed.child("shape").bits() % kStoneShapes);
  stone.look = static_cast<int>(seed.child("look").bits() % kRockLooks);
  stone.turn = seed.child("turn").range(0, 2 * kPi);
  stone.size = Vec3(width, width * static_cast<float>(seed.child("height").range(0.75, 1.05)),
                    width * static_cast<float>(seed.child("depth").range(0.75, 1.1)));
  float top =
      stone_surface_point(shapes_[static_cast<std::size_t>(stone.shape)], Vec3(0, 1, 0)).y * stone.size.y;
  stone.at = Vec3(at.x, height(at) + top * (1 - 2 * sunk), at.y);
  stone_instances.push_back(stone);
  return stone.at.y + top;
}

void SeaFloor::strew(TakenSpots& taken) {
  constexpr double kFew = 4;  // power of the size: the higher, the fewer are large
  for (int i = 0; i < loose_.stones; ++i) {
    Seed seed = seed_.child("stone", static_cast<std::uint64_t>(i));
    // Many small ones, few large ones.
    double width = loose_.stone_size * (0.12 + 0.88 * std::pow(seed.child("width").unit(), kFew));
    auto spots =
        scatter(Vec2(0), 0, loose_.extent, static_cast<float>(width / 2), 1, taken, seed.child("scatter"));
    for (const Spot& spot : spots) lay_stone(spot.at, static_cast<float>(width), kStoneSunk, seed);
  }
}

float SeaFloor::seat(Vec2 at, double rock, Seed seed) {
  return rock > 0 ? lay_stone(at, static_cast<float>(rock), kRockSunk, seed.child("rock")) : height(at);
}

std::vector<ScatteredInstances> SeaFloor::strewn() const {
  std::vector<ScatteredInstances> list;
  for (std::size_t shape = 0; shape < stones.size(); ++shape) {
    ScatteredInstances& all = list.emplace_back(ScatteredInstances{&stones[shape], kStone, {}});
    for (const StoneInstance& stone : stone_instances)
      if (stone.shape == static_cast<int>(shape))
        all.at.push_back(
            {stone.at, glm::angleAxis(static_cast<float>(stone.turn), Vec3(0, 1, 0)), stone.size});
  }
  return list;
}

std::size_t SeaFloor::bytes() const {
  std::size_t bytes = Grounds::bytes() + bytes_of(stones) + bytes_of(stone_instances);
  for (const Surface& stone : stones) bytes += bytes_of(stone);
  return bytes;
}

Land SeaFloor::land(std::vector<Spot> taken) const { return sloping_land(kSownSize, std::move(taken)); }

SettingRow underwater_setting() {
  return setting_row<Water>(
      "underwater", "a sea floor in blue water", "water", "The water, for underwater", {"/water", "/floor"},
      [](const SceneSetup&) { return Extent{.sown = kSownSize, .rocks = true}; },
      [](const SceneSetup&, const Film&) { return Errors{}; },
      [](const SceneSetup& setup, const Film& film) {
        constexpr double kFloor = 14'280;  // triangles
        constexpr double kPlacedAStone = 1.6;
        // Triangles of all kStoneShapes, by stone_detail().
        double stones = film.quality == Quality::best ? 102'400 : 25'600;
        double caustics = setup.block<Water>().caustics > 0 ? caustic_pixels(film.quality) : 0;
        return GroundSizeEstimate{kFloor + stones, 0, kPlacedAStone * setup.floor.stones,
                                  caustics * caustics};
      },
      [](const SceneSetup& setup, const Film& film, double reach, Seed seed) -> std::unique_ptr<Grounds> {
        return std::make_unique<SeaFloor>(setup.floor, film.quality, reach, seed);
      },
      [](const SceneSetup& setup) { return water_light(setup.block<Water>(), setup.camera.stops()); });
}

}  // namespace frond
