#include "cli/pass_views.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/seed.h"

namespace frond {

namespace {

constexpr float kSwiftest = 0.02f;  // of the picture's width a frame, which has the full colour

template <class Color>
Raster painted(const FramePasses& passes, const Color& color) {
  Raster picture(passes.width, passes.height, 3);
  for (std::size_t i = 0; i < passes.depth.size(); ++i) {
    Vec3 here = color(i);
    for (int c = 0; c < 3; ++c)
      picture.data[3 * i + static_cast<std::size_t>(c)] = to_byte(static_cast<double>(here[c]));
  }
  return picture;
}

/// A full colour, `turn` times round the circle of them.
Vec3 hue(float turn) {
  return glm::clamp(glm::abs(glm::fract(turn + Vec3(0, 2, 1) / 3.0f) * 6.0f - 3.0f) - 1.0f, 0.0f, 1.0f);
}

Vec3 color_of(const Thing& thing) {
  Seed seed =
      Seed{1}.child("part", static_cast<std::uint64_t>(thing.kind)).child(thing.owner).child(thing.number);
  return glm::mix(Vec3(0.35f), hue(static_cast<float>(seed.child(1).unit())), 0.8f) *
         static_cast<float>(seed.child(2).range(0.55, 1));
}

}  // namespace

std::vector<PassView> pass_views(const FramePasses& passes, float middle) {
  std::vector<PassView> views;
  views.push_back({"depth", painted(passes, [&](std::size_t i) {
                     return Vec3(std::isinf(passes.depth[i]) ? 0 : middle / (middle + passes.depth[i]));
                   })});
  views.push_back({"normal", painted(passes, [&](std::size_t i) {
                     return passes.normal[i] == Vec3(0) ? Vec3(0) : 0.5f + 0.5f * passes.normal[i];
                   })});
  views.push_back({"sun", painted(passes, [&](std::size_t i) { return Vec3(passes.sun[i]); })});
  views.push_back({"parts", painted(passes, [&](std::size_t i) {
                     Vec3 sum(0);
                     for (const auto& [thing, share] : passes.things[i]) sum += share * color_of(thing);
                     return sum;
                   })});
  views.push_back({"motion", painted(passes, [&](std::size_t i) {
                     Vec2 moved = passes.forward[i];
                     float far = glm::length(moved) / (kSwiftest * static_cast<float>(passes.width));
                     return hue(std::atan2(moved.y, moved.x) / (2 * static_cast<float>(kPi))) *
                            std::min(std::sqrt(far), 1.0f);
                   })});
  if (!passes.albedo.empty())
    views.push_back({"albedo", painted(passes, [&](std::size_t i) {
                       Vec3 seen(0);
                       for (int c = 0; c < 3; ++c)
                         seen[c] = static_cast<float>(encoded(static_cast<double>(passes.albedo[i][c])));
                       return seen;
                     })});
  return views;
}

}  // namespace frond
