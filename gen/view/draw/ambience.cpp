#include "draw/ambience.h"

#include "settings/settings.h"

namespace frond {

bool has_soft_light(const SceneSetup& setup) { return drawn_daylight(setup).soft; }

std::optional<Ambience> ambience_of(const Scene& scene, double time) {
  Daylight light = drawn_daylight(setup_at(scene.setup, time));
  if (!light.soft) return std::nullopt;
  return Ambience{light.sun, light.sunlight, light.above, light.aside, light.below, light.thrown_back};
}

}  // namespace frond
