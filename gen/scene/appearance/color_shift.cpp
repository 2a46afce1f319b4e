#include "appearance/color_shift.h"

#include "core/linear.h"

namespace frond {

Vec3 shifted(Vec3 light, const ColorShift& by) {
  Vec3 c = glm::angleAxis(static_cast<float>(by.hue), glm::normalize(Vec3(1))) * light;
  float luminance = glm::dot(c, Vec3(0.30f, 0.59f, 0.11f));
  c = glm::mix(Vec3(luminance), c, static_cast<float>(by.saturation));
  return glm::max(static_cast<float>(by.value) * c, Vec3(0));
}

Color shifted(const Color& color, const ColorShift& by) {
  return by.plain() ? color : srgb(glm::clamp(shifted(linear(color), by), Vec3(0), Vec3(1)));
}

Vec3 shift_filter(const Color& color, const ColorShift& by) {
  const Vec3 light = glm::max(linear(color), Vec3(0.01f));
  return shifted(light, by) / light;
}

ColorShift ColorCourse::at(double time) const {
  return {radians(hue.at(time)), saturation.at(time), value.at(time)};
}

}  // namespace frond
