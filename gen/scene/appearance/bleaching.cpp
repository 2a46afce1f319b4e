#include "appearance/bleaching.h"

#include <algorithm>

namespace frond {

namespace {

float gray(Vec3 color) { return std::min(kBleaching.most_gray, (color.x + color.y + color.z) / 3); }

}  // namespace

Vec3 bleached_color(Vec3 color) {
  const Bleaching& b = kBleaching;
  return b.kept * color + (b.lime_least + b.lime_by_gray * gray(color)) * b.lime;
}

Vec3 dead_color(Vec3 color) {
  const Bleaching& b = kBleaching;
  return (b.turf_least + b.turf_by_gray * gray(color)) * b.turf;
}

Vec3 starved_color(Vec3 color, float light) {
  const Bleaching& b = kBleaching;
  Vec3 pale = bleached_color(color);
  return light < b.pale_light
             ? glm::mix(dead_color(color), pale, smooth_step(b.dead_light, b.pale_light, light))
             : glm::mix(pale, color, smooth_step(b.pale_light, b.living_light, light));
}

}  // namespace frond
