#include "settings/settings.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "motion/rain.h"
#include "motion/snowfall.h"
#include "settings/meadow.h"

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

void describe_rest(KeyWriter& v, std::any& block) {
  for (const SettingRow& row : settings()) {
    if (row.initial.type() != block.type()) continue;
    Keys keys = row.keys(block);
    v.add(row.block, keys);
  }
}

double Snow::deepest() const { return highest(depth); }

namespace {

const SettingAnswers& answers_of(const SceneSetup& setup) { return settings()[setup.setting].answers; }

bool reads(const SceneSetup& setup, std::string_view pointer) {
  const auto& all = answers_of(setup).reads;
  return std::ranges::find(all, pointer) != all.end();
}

/// The hour of the day; null where the setting says nothing.
Animated<double>* hour_of(SceneSetup& setup) {
  auto hour = answers_of(setup).hour;
  return hour ? hour(setup) : nullptr;
}

/// Under the open sky; all three linear, as the camera sees them.
FillLight open_fill(Vec3 zenith, Vec3 horizon, Vec3 ground) {
  float dim = std::min(1.0f, 0.02f + glm::dot(zenith + horizon, Vec3(0.3f, 0.6f, 0.1f)) / 1.25f);
  return {.above = dim * (0.27f * zenith + 0.5f),
          .aside = dim * (0.2f * zenith + 0.3f),
          .below = dim * (0.2f * ground + 0.1f),
          .eye = dim * (0.08f * zenith + 0.12f)};
}

/// A clear sky, about, without what the sun adds round it.
std::vector<BackdropStop> open_backdrop(Vec3 zenith, Vec3 horizon) {
  return {{0, horizon},
          {0.06, glm::mix(0.94f * horizon, zenith, 0.06f)},
          {0.25, glm::mix(horizon, zenith, 0.55f)},
          {0.6, zenith},
          {1, 0.85f * zenith}};
}

/// Rain and snow fall from an overcast sky, and their drops and flakes are a part of the haze.
void cloud_over(SceneSetup& now) {
  auto& meadow = now.block<Meadow>();
  meadow.clouds = std::lerp(meadow.clouds, 1.0, overcast(now));
  double lost = is_rainy(now) ? rain_extinction(now.rain->rate.at(0)) : 0;
  if (is_snowy(now)) lost += snowfall_extinction(now.snow.falling.at(0));
  meadow.haze = 1 / (1 / meadow.haze + lost);
}

}  // namespace

bool is_snowy(const SceneSetup& setup) {
  auto some = [](const Animated<double>& a) {
    return std::ranges::any_of(a.keys(), [](const auto& key) { return key.value > 0; });
  };
  return (some(setup.snow.depth) || some(setup.snow.frost) || some(setup.snow.falling)) &&
         reads(setup, "/snow");
}

bool is_rainy(const SceneSetup& setup) { return setup.rain && reads(setup, "/rain"); }

bool is_misty(const SceneSetup& setup) { return setup.air && reads(setup, "/air"); }

SceneSetup::SceneSetup() {
  for (const SettingRow& row : settings()) blocks.push_back(row.initial);
}

Color seen_color(Vec3 light) {
  auto part = [](float x) {
    return static_cast<float>(encoded(std::clamp(static_cast<double>(x), 0.0, 1.0)));
  };
  return {part(light.r), part(light.g), part(light.b)};
}

Vec3 backdrop_at(const Daylight& light, float height) {
  const std::vector<BackdropStop>& stops = light.backdrop;
  Vec3 seen = stops.front().light;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    auto from = static_cast<float>(stops[i - 1].height), to = static_cast<float>(stops[i].height);
    seen = glm::mix(seen, stops[i].light, std::clamp((height - from) / (to - from), 0.0f, 1.0f));
  }
  return seen;
}

Daylight daylight(const Sky& sky, const Color& ground, Vec3 matt, double haze) {
  Daylight light{.sun = sky.lamp, .sunlight = sky.lamplight, .brightest = 3, .soft = true};
  light.above = sky.cloudy_zenith;
  light.aside = sky.cloudy_horizon;
  light.thrown_back = 0.48f * matt;  // its textures are darker than the colour
  light.below = light.thrown_back * (0.5f * sky.lamplight * sky.lamp.y + 0.4f * (light.above + light.aside));
  light.zenith = seen_color(sky.zenith);
  light.horizon = seen_color(sky.horizon);
  light.ground = ground;
  light.fog = 0.9f * sky.horizon + 0.07f * sky.zenith;
  light.fade = haze;
  Vec3 zenith = linear(light.zenith), horizon = linear(light.horizon);
  light.backdrop = open_backdrop(zenith, horizon);
  light.fill = open_fill(zenith, horizon, linear(ground));
  return light;
}

Vec3 ground_normal(const Heights& heights, Vec2 at) {
  constexpr float kReach = 0.5f;  // metres
  auto x = static_cast<float>(heights(at.x - kReach, at.y) - heights(at.x + kReach, at.y));
  auto z = static_cast<float>(heights(at.x, at.y - kReach) - heights(at.x, at.y + kReach));
  return glm::normalize(Vec3(x, 2 * kReach, z));
}

glm::mat3 Patch::axes() const {
  float c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
  return {c, slope.x * c + slope.y * s, s, 0, 1, 0, -s, -slope.x * s + slope.y * c, c};
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

constexpr double kMeteredSnow = 0.8;  // stops by which a light meter turns down what snow makes bright

SceneSetup setup_at(const SceneSetup& setup, double time) {
  SceneSetup now = setup;
  if (Animated<double>* hour = hour_of(now)) *hour = hour->at(time);
  now.snow.depth = setup.snow.depth.at(time);
  now.snow.frost = setup.snow.frost.at(time);
  now.snow.falling = setup.snow.falling.at(time);
  if (now.year) now.year = now.year->at(time);
  if (now.closed) now.closed = now.closed->at(time);
  now.camera.exposure -= kMeteredSnow * snow_cover(now);
  if (is_rainy(setup))
    now.rain = {setup.rain->rate.at(time), setup.rain->fallen.at(time), setup.rain->mist.at(time)};
  if (overcast(now) > 0) cloud_over(now);
  return now;
}

bool sun_moves(const SceneSetup& setup) {
  SceneSetup copy = setup;
  Animated<double>* hour = hour_of(copy);
  return (hour && !hour->constant()) || (is_rainy(setup) && !setup.rain->rate.constant()) ||
         (is_snowy(setup) && !setup.snow.falling.constant());
}

double overcast(const SceneSetup& setup) {
  return std::max(is_rainy(setup) ? rain_clouds(setup.rain->rate.at(0)) : 0,
                  is_snowy(setup) ? snow_clouds(setup.snow.falling.at(0)) : 0);
}

double snow_cover(const SceneSetup& setup) {
  return is_snowy(setup) ? smooth_step(0.0, 0.05, setup.snow.depth.at(0)) : 0;
}

double wet_share(const SceneSetup& setup) { return is_rainy(setup) ? wetness(setup.rain->fallen.at(0)) : 0; }

Daylight drawn_daylight(const SceneSetup& setup) {
  constexpr float kAlbedo = 0.82f;  // of fresh snow with what stands in it
  constexpr float kWet = 0.65f;     // of what land throws back, when it is wet
  Daylight light = answers_of(setup).daylight(setup);
  if (auto wet = static_cast<float>(wet_share(setup)); wet > 0)
    light.thrown_back *= 1 - wet * (1 - kWet), light.below *= 1 - wet * (1 - kWet);
  if (auto cover = static_cast<float>(snow_cover(setup)); cover > 0) {
    light.thrown_back = glm::mix(light.thrown_back, Vec3(kAlbedo), cover);
    light.below =
        light.thrown_back * (0.5f * light.sunlight * light.sun.y + 0.4f * (light.above + light.aside));
    light.ground = mixed(light.ground, Color{0.94f, 0.95f, 0.97f}, cover);
  }
  return light;
}

Vec2 shaded_side(SceneSetup setup) {
  constexpr double kNoon = 13;  // of summer time
  if (Animated<double>* hour = hour_of(setup)) *hour = kNoon;
  Vec3 sun = answers_of(setup).daylight(setup).sun;
  return {-sun.x, -sun.z};
}

Daylight daylight_of(SceneSetup setup) {
  setup.camera.highlights = 0;
  return drawn_daylight(setup);
}

}  // namespace frond
