#include "scene/bleaching.h"

#include <algorithm>

namespace frond {

Vec3 bleached(Vec3 color, float light) {
  float gray = std::min(0.55f, (color.x + color.y + color.z) / 3);
  Vec3 pale = color * 0.30f + kBleachedLime * (0.30f + 0.75f * gray);
  Vec3 dead = kDeadTurf * (0.18f + 0.80f * gray);
  return light < kPaleLight ? glm::mix(dead, pale, smooth_step(kDeadLight, kPaleLight, light))
                            : glm::mix(pale, color, smooth_step(kPaleLight, kLivingLight, light));
}

}  // namespace frond
