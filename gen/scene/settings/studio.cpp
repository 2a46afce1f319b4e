#include "settings/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "settings/settings.h"

namespace frond {

void describe(Properties& v, Studio& s) {
  v.color("wall", s.wall, "Colour of the wall and the floor");
  v.number("distance", s.distance, metres(0.01, 1000), "Distance from the middle back to the wall");
  v.direction("key", s.key, "Direction toward the main light");
  v.number("softness", s.softness, {.min = 0, .max = 3}, "How soft the shadows are; 0 is hard");
}

namespace {

/// Metres, the side of a square before the wall, wherever that stands.
double sown_size(double distance) { return std::sqrt(2.0) * distance; }

/// The main light, and what the room gives back: cool from the other side, from above, and along the edge
/// from behind.
std::vector<Lamp> studio_lamps(const Studio& studio) {
  Vec3 key = glm::normalize(studio.key);
  return {{2.6f * key, 1.28f * Vec3(1.00f, 0.96f, 0.90f), 0.672 * studio.softness, Lamp::Shadows::fine},
          {2.0f * Vec3(-1.6f * key.x, 0.5f, 0.9f * key.z), 0.26f * Vec3(0.86f, 0.93f, 1.0f)},
          {Vec3(0, 3, 0.4f), 0.34f * Vec3(0.96f, 0.98f, 1.0f), 4, Lamp::Shadows::coarse},
          {2.0f * Vec3(-key.x, 0.7f, -0.35f), 0.22f * Vec3(1.0f, 0.98f, 0.95f)}};
}

Daylight studio_light(const Studio& studio, double stops) {
  auto exposed = static_cast<float>(std::exp2(stops));
  Daylight light{.sun = glm::normalize(studio.key), .lamps = studio_lamps(studio)};
  for (Lamp& lamp : light.lamps) lamp.light *= exposed;
  light.sunlight = light.lamps.front().light;
  light.brightest = light.sunlight.r;
  light.zenith = light.horizon = light.ground = studio.wall;
  light.fog = linear(studio.wall);
  light.backdrop = {{0, 0.9f * exposed * light.fog}};
  light.fill = {.above = exposed * Vec3(0.85f, 0.85f, 0.86f),
                .aside = exposed * Vec3(0.26f, 0.27f, 0.29f),
                .below = Vec3(0.10f * exposed),
                .eye = Vec3(0.08f * exposed)};
  return light;
}

/// A level floor that is one with the wall.
class StudioFloor final : public Grounds {
 public:
  explicit StudioFloor(const Studio& studio) : studio_(studio) {}

  void strew(TakenSpots&) override {}
  float seat(Vec2, double, Seed) override { return 0; }
  Land land(std::vector<Spot> taken) const override {
    Land land;
    land.size = sown_size(studio_.distance);
    land.taken = std::move(taken);
    return land;
  }
  std::vector<std::string> remarks(const std::function<std::vector<Occupied>()>& things, const Camera& camera,
                                   double film_end) const override;

 private:
  /// Where the main light hangs at a time.
  Vec3 lamp_at(const Camera& camera, double time) const {
    Vec3 look = camera.look_at.at(time);
    float far = std::max(1.0f, glm::distance(camera.location.at(time), look));
    return look + far * studio_lamps(studio_).front().from;
  }

  Studio studio_;
};

/// What stands through the wall, and round the main light.
std::vector<std::string> StudioFloor::remarks(const std::function<std::vector<Occupied>()>& things,
                                              const Camera& camera, double film_end) const {
  double farthest = 0;
  std::string through, lit;
  for (const Occupied& thing : things()) {
    if (-thing.low.z > farthest) farthest = -thing.low.z, through = thing.name;
    for (double time : {0.0, film_end}) {
      Vec3 lamp = lamp_at(camera, time);
      bool within = glm::all(glm::lessThan(thing.low, lamp)) && glm::all(glm::lessThan(lamp, thing.high));
      if (within && lit.empty()) lit = thing.name;
    }
  }
  std::vector<std::string> notes;
  if (farthest > studio_.distance)
    notes.push_back(
        fmt::format("{}: reaches {:.2g} m through the studio's wall; studio.distance {:.3g} or more?",
                    through, farthest - studio_.distance, std::ceil(farthest * 11) / 10));
  if (!lit.empty())
    notes.push_back(fmt::format(
        "{}: the studio's main light hangs within it; the camera farther from what it looks at?", lit));
  return notes;
}

}  // namespace

SettingRow studio_setting() {
  return setting_row<Studio>(
      "studio", "soft light before a plain wall", "studio", "Wall and light, for studio", {"/studio"},
      [](const SceneSetup& setup) { return Extent{.sown = sown_size(setup.block<Studio>().distance)}; },
      [](const SceneSetup&, const Film&) { return Errors{}; },
      [](const SceneSetup&, const Film&) { return GroundSizeEstimate{}; },
      [](const SceneSetup& setup, const Film&, double, Seed) -> std::unique_ptr<Grounds> {
        return std::make_unique<StudioFloor>(setup.block<Studio>());
      },
      [](const SceneSetup& setup) { return studio_light(setup.block<Studio>(), setup.camera.stops()); });
}

}  // namespace frond
