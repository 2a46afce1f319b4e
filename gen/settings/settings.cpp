#include "settings/settings.h"

#include <algorithm>
#include <cmath>

namespace frond {

std::span<const SettingRow> settings() {
#define FROND_ROW(name) name##_setting(),
  static const std::vector<SettingRow> rows{FROND_SETTINGS(FROND_ROW)};
#undef FROND_ROW
  return rows;
}

std::size_t row_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(settings(), name, &SettingRow::name) -
                                  settings().begin());
}

Stage::Stage() {
  for (const SettingRow& row : settings()) blocks.push_back(row.initial);
}

Vec3 sun_at(double hour, double south) {
  double day = kPi * (hour - 13) / 12, latitude = radians(50.0), tilt = radians(23.4);
  double up = std::sin(latitude) * std::sin(tilt) + std::cos(latitude) * std::cos(tilt) * std::cos(day);
  double west = std::cos(tilt) * std::sin(day);
  double noon = std::cos(tilt) * std::cos(day) * std::sin(latitude) - std::sin(tilt) * std::cos(latitude);
  double c = std::cos(south), s = std::sin(south);
  return Vec3(noon * s - west * c, up, noon * c + west * s);
}

Daylight sky_light(Vec3 sun, const Color& ground, double haze) {
  auto mixed = [](const Color& a, const Color& b, double t) {
    auto part = [&](float x, float y) { return static_cast<float>(x + (y - x) * t); };
    return Color{part(a.red, b.red), part(a.green, b.green), part(a.blue, b.blue)};
  };
  constexpr Color kNight{0.05f, 0.07f, 0.13f}, kBlue{0.30f, 0.52f, 0.84f}, kPale{0.80f, 0.87f, 0.92f};
  constexpr Color kLow{1, 0.62f, 0.36f}, kHigh{1, 0.96f, 0.88f}, kGlow{0.96f, 0.72f, 0.52f};
  sun = glm::normalize(sun);
  double day = smooth_step(-0.15, 0.15, static_cast<double>(sun.y));
  double high = smooth_step(0.05, 0.5, static_cast<double>(sun.y));
  // At night the moon stands where the sun would be by day.
  Daylight light;
  light.sun = Vec3(sun.x, std::abs(sun.y), sun.z);
  light.sunlight = mixed(kNight, mixed(kLow, kHigh, high), day);
  light.zenith = mixed(kNight, kBlue, day);
  light.horizon = mixed(kNight, mixed(kGlow, kPale, high), day);
  light.ground = ground;
  light.fade = haze;
  return light;
}

Vec3 ground_normal(const Heights& heights, Vec2 at) {
  constexpr float kReach = 0.5f;  // metres
  auto x = static_cast<float>(heights(at.x - kReach, at.y) - heights(at.x + kReach, at.y));
  auto z = static_cast<float>(heights(at.x, at.y - kReach) - heights(at.x, at.y + kReach));
  return glm::normalize(Vec3(x, 2 * kReach, z));
}

std::function<double(Vec2)> clear_of(const Plot& plot) {
  return [&plot](Vec2 at) {
    return plot.pond_distance(at) < 0.1 ? -1e6 : std::min(plot.path_distance(at), plot.pond_distance(at));
  };
}

Land Grounds::sloping_land(double size, std::vector<Spot> taken) const {
  constexpr int kSamples = 128;
  Land land;
  land.size = size;
  land.taken = std::move(taken);
  double lowest = 1e9;
  for (int i = 0; i <= kSamples; ++i)
    for (int k = 0; k <= kSamples; ++k)
      lowest = std::min(lowest, heights_((static_cast<double>(i) / kSamples - 0.5) * land.size,
                                         (static_cast<double>(k) / kSamples - 0.5) * land.size));
  land.altitude = [this, lowest](Vec2 at) { return heights_(at.x, at.y) - lowest; };
  land.slope = [this](Vec2 at) { return std::acos(std::min(ground_normal(heights_, at).y, 1.0f)); };
  return land;
}

}  // namespace frond
