#include "settings/sky.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frond {

double declination(double day) {
  // Spencer's Fourier series.
  double turn = 2 * kPi * (day - 1) / 365;
  return 0.006918 - 0.399912 * std::cos(turn) + 0.070257 * std::sin(turn) - 0.006758 * std::cos(2 * turn) +
         0.000907 * std::sin(2 * turn) - 0.002697 * std::cos(3 * turn) + 0.00148 * std::sin(3 * turn);
}

Vec3 sun_at(const Moment& when) {
  constexpr double kNoon = 13;  // hours of summer time
  double day = kPi * (when.hour - kNoon) / 12, tilt = declination(when.day);
  double sin_lat = std::sin(when.latitude), cos_lat = std::cos(when.latitude);
  double up = sin_lat * std::sin(tilt) + cos_lat * std::cos(tilt) * std::cos(day);
  double west = std::cos(tilt) * std::sin(day);
  double noon = std::cos(tilt) * std::cos(day) * sin_lat - std::sin(tilt) * cos_lat;
  double c = std::cos(when.south), s = std::sin(when.south);
  return Vec3(noon * s - west * c, up, noon * c + west * s);
}

namespace {

/// Perez's law: what a sky shows as against a patch of it where both terms are 1.
struct Perez {
  double a, b, c, d, e;

  double operator()(double theta, double gamma) const {
    constexpr double kLeastCosine = 0.01;  // of theta: at 0 the law has a pole
    double cos_gamma = std::cos(gamma);
    return (1 + a * std::exp(b / std::max(std::cos(theta), kLeastCosine))) *
           (1 + c * std::exp(d * gamma) + e * cos_gamma * cos_gamma);
  }
};

/// A cubic of the sun's angle whose coefficients are quadratic in turbidity.
double zenith_tone(const std::array<std::array<double, 4>, 3>& m, double sun, double t) {
  auto cubic = [&](const std::array<double, 4>& k) {
    return ((k[0] * sun + k[1]) * sun + k[2]) * sun + k[3];
  };
  return (cubic(m[0]) * t + cubic(m[1])) * t + cubic(m[2]);
}

/// Linear sRGB (IEC 61966-2-1).
Vec3 rgb_of(const Luminance& l) {
  double X = l.x / l.y * l.Y, Y = l.Y, Z = (1 - l.x - l.y) / l.y * l.Y;
  return glm::max(Vec3(3.2406 * X - 1.5372 * Y - 0.4986 * Z, -0.9689 * X + 1.8758 * Y + 0.0415 * Z,
                       0.0557 * X - 0.2040 * Y + 1.0570 * Z),
                  Vec3(0));
}

/// The luminance of linear sRGB (ITU-R BT.709).
float brightness(Vec3 c) { return glm::dot(c, Vec3(0.2126f, 0.7152f, 0.0722f)); }

/// Between the values of a table of {x, value}, x rising.
template <std::size_t N>
float between(const std::array<std::array<double, 2>, N>& table, double x) {
  std::size_t i = 0;
  while (i + 2 < N && table[i + 1][0] < x) ++i;
  double share = std::clamp((x - table[i][0]) / (table[i + 1][0] - table[i][0]), 0.0, 1.0);
  return static_cast<float>(table[i][1] + share * (table[i + 1][1] - table[i][1]));
}

constexpr float kSunKcd = 40.7f;               // 128 klx before the air, on a white matt surface
constexpr Vec3 kSunColor(1.05f, 1.0f, 0.95f);  // before the air
constexpr Vec3 kBalance(0.95f, 1.0f, 1.08f);   // a camera set to daylight, not to the white of a screen

/// Light of a clear sky without its sun on level ground, klx (IES Lighting Handbook).
double diffuse_light(double height) {
  constexpr double kA = 0.8, kB = 15.5;  // klx, as the handbook calls them; its C, the power, is a half
  return kA + kB * std::sqrt(std::max(0.0, std::sin(height)));
}

/// Film gives in before it is white.
Vec3 exposed(Vec3 light) {
  constexpr float kKnee = 0.45f, kRoom = 0.50f;
  float bright = brightness(light);
  if (bright <= kKnee) return light;
  return light * ((kKnee + kRoom * (1 - std::exp((kKnee - bright) / kRoom))) / bright);
}

/// What level ground gets of light from all above.
template <class Light>
double lit_from(const Light& light) {
  constexpr int kRings = 12, kTurns = 16;
  double sum = 0;
  for (int i = 0; i < kRings; ++i)
    for (int k = 0; k < kTurns; ++k) {
      // Rings that a level surface sees alike.
      double level = std::sqrt((i + 0.5) / kRings), turn = 2 * kPi * (k + 0.5) / kTurns;
      sum += static_cast<double>(
          light(Vec3(level * std::cos(turn), std::sqrt(1 - level * level), level * std::sin(turn))));
    }
  return kPi * sum / (kRings * kTurns);
}

constexpr float kOverhead = 2, kOverHorizon = 0.1f;  // rise over run, where means of a sky are taken

/// The mean of a sky all round, at a height.
Vec3 mean(const Sky& sky, float height) {
  constexpr int kDirections = 12;
  Vec3 sum(0);
  for (int i = 0; i < kDirections; ++i) {
    double turn = 2 * kPi * (i + 0.5) / kDirections;
    sum += sky.from(glm::normalize(Vec3(std::cos(turn), height, std::sin(turn))));
  }
  return sum / static_cast<float>(kDirections);
}

}  // namespace

Luminance preetham(double theta, double gamma, double sun, double t) {
  // All coefficients are from appendix A.2 of the paper.
  const Perez Y{0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                -0.0670 * t + 0.3703};
  const Perez x{-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
                -0.0033 * t + 0.0452};
  const Perez y{-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
                -0.0109 * t + 0.0529};
  double chi = (4.0 / 9 - t / 120) * (kPi - 2 * sun);
  double Y_zenith = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
  double x_zenith = zenith_tone({{{0.00166, -0.00375, 0.00209, 0},
                                  {-0.02903, 0.06377, -0.03202, 0.00394},
                                  {0.11693, -0.21196, 0.06052, 0.25886}}},
                                sun, t);
  double y_zenith = zenith_tone({{{0.00275, -0.00610, 0.00317, 0},
                                  {-0.04214, 0.08970, -0.04153, 0.00516},
                                  {0.15346, -0.26756, 0.06670, 0.26688}}},
                                sun, t);
  return {Y_zenith * Y(theta, gamma) / Y(0, sun), x_zenith * x(theta, gamma) / x(0, sun),
          y_zenith * y(theta, gamma) / y(0, sun)};
}

Vec3 through_air(double height, double turbidity) {
  // Kasten and Young (1989) for the mass of air; Rayleigh, Angstrom's dust and ozone as in Preetham's
  // appendix.
  constexpr double kLowestSun = -0.6;                           // degrees: a lower one is taken as there
  constexpr std::array<double, 3> kWave{0.615, 0.545, 0.460};   // micrometres, of red, green and blue
  constexpr std::array<double, 3> kOzone{0.041, 0.030, 0.003};  // optical depth at these
  constexpr double kRayleighDepth = 0.008735;                   // at a micrometre
  constexpr double kRayleighPower = -4.08, kDustPower = -1.3;   // of the wavelength
  double up = std::max(degrees(height), kLowestSun);
  double mass = 1 / (std::sin(radians(up)) + 0.50572 * std::pow(up + 6.07995, -1.6364));
  double dust = std::max(0.0, 0.04608 * turbidity - 0.04586);
  Vec3 left;
  for (int i = 0; i < 3; ++i) {
    auto k = static_cast<std::size_t>(i);
    double depth = kRayleighDepth * std::pow(kWave[k], kRayleighPower) +
                   dust * std::pow(kWave[k], kDustPower) + kOzone[k];
    left[i] = static_cast<float>(std::exp(-mass * depth));
  }
  return left;
}

Vec3 Sky::day(Vec3 direction) const {
  // At the horizon itself Perez's law has a pole.
  constexpr double kFarthest = 88.5;  // degrees from the zenith
  double theta =
      std::min(std::acos(std::clamp(static_cast<double>(direction.y), 0.0, 1.0)), radians(kFarthest));
  double above = std::max(height_, 0.0);
  Vec3 flat = glm::normalize(Vec3(sun.x, 0, sun.z) + Vec3(0, 0, 1e-6f));
  Vec3 toward = flat * static_cast<float>(std::cos(above)) + Vec3(0, std::sin(above), 0);
  double gamma = std::acos(std::clamp(static_cast<double>(glm::dot(direction, toward)), -1.0, 1.0));
  // What comes past a low sun is redder than Preetham has it: by eye.
  constexpr double kLowSun = 4, kHighSun = 22;  // degrees: all of it up to the one, none from the other on
  constexpr Vec3 kWarm(1.24f, 0.90f, 0.55f);    // factor on the light
  constexpr float kFade = 4;                    // of it with the sine of the height
  float a = 0.5f + 0.5f * glm::dot(Vec3(direction.x, 0, direction.z), flat);
  auto low = static_cast<float>(1 - smooth_step(kLowSun, kHighSun, degrees(above)));
  Vec3 warm =
      glm::mix(Vec3(1), kWarm, low * (0.3f + 0.7f * a * a) * std::exp(-kFade * std::max(direction.y, 0.0f)));
  Vec3 light = warm * kBalance * rgb_of(preetham(theta, gamma, kPi / 2 - above, turbidity_));
  constexpr float kLeastGreen = 0.98f;  // of the less of red and blue: no daylight is magenta
  light.g = std::max(light.g, kLeastGreen * std::min(light.r, light.b));
  return light;
}

Vec3 Sky::dusk(Vec3 direction) const {
  // Blue above by the ozone, the afterglow over the sun, the earth's shadow opposite with the belt of Venus
  // on it. All of it by eye: colours are as exposed, heights are sines, and what sinks by so much does from
  // sunset until the sun is kLate below the horizon.
  constexpr double kLate = 8;  // degrees
  constexpr Vec3 kBlue(0.13f, 0.24f, 0.56f), kLateBlue(0.07f, 0.15f, 0.44f);
  constexpr Vec3 kFire(1.20f, 0.50f, 0.17f), kLateFire(0.95f, 0.36f, 0.16f), kPale(0.60f, 0.48f, 0.44f);
  constexpr Vec3 kBelt(0.20f, 0.06f, 0.08f), kEarthShadow(0.16f, 0.12f, 0.06f), kDarkest(0.02f);
  constexpr float kPaleHeight = 0.26f, kPaleSinks = 0.10f, kPaleShare = 0.34f;
  constexpr float kFireHeight = 0.12f, kFireSinks = 0.035f;
  constexpr float kBeltHeight = 0.20f, kBeltSinks = 0.08f, kBeltWidth = 0.10f;
  constexpr float kShadowHeight = 0.09f, kShadowShare = 0.6f;
  Vec3 flat(direction.x, 0, direction.z), west(sun.x, 0, sun.z);
  float along = glm::dot(flat, west) / std::max(glm::length(flat) * glm::length(west), 1e-6f);
  float a = 0.5f + 0.5f * along, y = std::max(direction.y, 0.0f);
  auto low = static_cast<float>(std::clamp(-degrees(height_) / kLate, 0.0, 1.0));
  Vec3 blue = glm::mix(kBlue, kLateBlue, low), fire = glm::mix(kFire, kLateFire, low);
  Vec3 light = blue * (0.62f + 0.38f * a) * (1 - 0.25f * y);
  light += kPale * (0.22f + 0.78f * a * a) * std::exp(-y / (kPaleHeight - kPaleSinks * low)) * kPaleShare;
  light += fire * (0.06f + 0.94f * a * a * a) * std::exp(-y / (kFireHeight - kFireSinks * low));
  float belt = (y - kBeltHeight + kBeltSinks * low) / kBeltWidth, shadow = y / kShadowHeight;
  light += kBelt * (1 - low) * (1 - a) * std::exp(-belt * belt);
  light -= kEarthShadow * (1 - a) * std::exp(-shadow * shadow) * kShadowShare;
  return glm::max(light, kDarkest) * dim_;
}

Vec3 Sky::from(Vec3 direction) const {
  Vec3 tint = stops_ * glm::mix(tint_low_, tint_high_, std::sqrt(std::max(direction.y, 0.0f)));
  Vec3 by_day = twilight_ < 1 ? exposed(metered_ * tint * day(direction)) : Vec3(0);
  Vec3 clear = glm::mix(by_day, exposed(tint * dusk(direction)), twilight_);
  return overcast_ > 0 ? glm::mix(clear, rain_cloud(direction.y), overcast_) : clear;
}

/// The overcast sky of Moon and Spencer (1942), (1 + 2 sin h)/3 of its zenith, half made even by the rain in
/// it; as bright as a light meter has it that finds no sun.
Vec3 Sky::rain_cloud(double height) const {
  constexpr Vec3 kGrey(1.05f, 1.09f, 1.13f);
  auto shape = static_cast<float>(0.5 + 0.5 * (1 + 2 * std::max(height, 0.0)) / 3);
  return exposed(stops_ * glm::mix(1.0f, dim_, twilight_) * shape * kGrey);
}

Sky::Sky(const SkyShape& shape)
    : sun(glm::normalize(shape.sun)),
      turbidity_(shape.turbidity),
      height_(std::asin(std::clamp(static_cast<double>(sun.y), -1.0, 1.0))),
      stops_(static_cast<float>(std::exp2(shape.exposure))),
      overcast_(static_cast<float>(shape.overcast)) {
  // Of the sun, in degrees.
  constexpr double kAllDusk = -4.5, kAllDay = 6;  // heights between which dusk becomes day
  constexpr double kSet = -0.8, kRisen = 0.6;     // heights with none and all of the sun's disc in view
  constexpr double kMoonFrom = 8, kMoonAll = 12;  // depths between which the moon follows the afterglow
  double up = degrees(height_);
  twilight_ = static_cast<float>(1 - smooth_step(kAllDusk, kAllDay, up));
  // How bright dusk is, by the sun's height.
  dim_ = between<6>({{{-18, 0.035}, {-12, 0.07}, {-8, 0.22}, {-4, 0.62}, {0, 1.0}, {2, 1.1}}}, up);
  // A meter reads what the sun gives and what comes from the sky beside it.
  auto risen = static_cast<float>(smooth_step(kSet, kRisen, up));
  Vec3 sunny = risen * kSunKcd * kSunColor * kBalance * through_air(height_, turbidity_);
  // Preetham's sky is too bright, most of all at a low sun: we take what it gives as measured (IES handbook).
  double given = lit_from([&](Vec3 direction) { return brightness(day(direction)); });
  auto share = static_cast<float>(diffuse_light(height_) / given);
  auto level = static_cast<float>(diffuse_light(height_) / kPi);
  constexpr float kExposed = 2.8f, kSunWeight = 0.5f, kSkyWeight = 2.5f;  // by eye
  metered_ = kExposed / (kSunWeight * brightness(sunny) + kSkyWeight * level);
  // What closed clouds and rain keep back of the lamp's light.
  constexpr double kKeptByClouds = 0.75, kKeptByRain = 0.95, kClosing = 0.6;
  auto veil = static_cast<float>((1 - kKeptByClouds * smooth_step(kClosing, 1.0, shape.clouds)) *
                                 (1 - kKeptByRain * shape.overcast));
  lamplight = metered_ * stops_ * veil * sunny;
  metered_ *= share;
  constexpr float kLowestLamp = 0.02f;  // sine of its height, or shadows would have no end
  lamp = glm::normalize(Vec3(sun.x, std::max(sun.y, kLowestLamp), sun.z));
  if (up < kSet) {
    // Shadows are cast by the afterglow, and at night by the moon.
    constexpr Vec3 kMoonlight(0.10f, 0.13f, 0.20f), kAfterglow(0.50f, 0.30f, 0.22f);  // by eye, as exposed
    constexpr float kAfterglowHeight = 0.18f;  // of where it comes from on the average, as a sine
    auto night = static_cast<float>(2 * smooth_step(kMoonFrom, kMoonAll, -up) - 1);
    Vec3 moon(shape.moon.x, std::max(shape.moon.y, kLowestLamp), shape.moon.z);
    lamp = night > 0 ? glm::normalize(moon) : glm::normalize(Vec3(sun.x, kAfterglowHeight, sun.z));
    lamplight = stops_ * veil * (night > 0 ? night * kMoonlight : -night * dim_ * kAfterglow);
  }
  constexpr float kGlow = 0.16f;  // share of the lamp's light, by eye
  glow = kGlow * risen * lamplight;
  if (shape.zenith) tint_high_ = *shape.zenith / glm::max(mean(*this, kOverhead), Vec3(1e-4f));
  if (shape.horizon) tint_low_ = *shape.horizon / glm::max(mean(*this, kOverHorizon), Vec3(1e-4f));
  horizon = mean(*this, kOverHorizon);
  zenith = mean(*this, kOverhead);
  light_clouds(shape.clouds);
}

void Sky::light_clouds(double clouds) {
  // How much clouds throw back of what comes to them is by eye.
  shade = 0.50f * zenith + 0.22f * horizon + 0.05f * lamplight;
  cloud = 0.28f * lamplight + 0.55f * glm::mix(horizon, zenith, 0.3f);
  // Once the sun is down they are lit by the sky just over it.
  if (sun.y < 0) cloud += 0.35f * from(glm::normalize(Vec3(sun.x, 0.06f, sun.z)));
  // A rain cloud is lit through and through.
  Vec3 through = glm::mix(horizon, zenith, 0.5f);
  cloud = glm::mix(cloud, through, overcast_), shade = glm::mix(shade, 0.86f * through, overcast_);
  // The shares of them that are seen above 45 degrees and below 20, measured on Meadow_Clouds.
  auto with = [&](Vec3 clear, float lit, float dark) {
    return (1 - lit - dark) * clear + lit * cloud + dark * shade;
  };
  using Table = std::array<std::array<double, 2>, 7>;
  constexpr Table kLitHigh{
      {{0, 0}, {0.1, 0.008}, {0.2, 0.017}, {0.35, 0.037}, {0.5, 0.088}, {0.7, 0.188}, {1, 0.28}}},
      kDarkHigh{{{0, 0}, {0.1, 0}, {0.2, 0}, {0.35, 0.001}, {0.5, 0.012}, {0.7, 0.094}, {1, 0.467}}},
      kLitLow{{{0, 0}, {0.1, 0.04}, {0.2, 0.077}, {0.35, 0.158}, {0.5, 0.252}, {0.7, 0.322}, {1, 0.229}}},
      kDarkLow{{{0, 0}, {0.1, 0.018}, {0.2, 0.04}, {0.35, 0.102}, {0.5, 0.212}, {0.7, 0.414}, {1, 0.659}}};
  cloudy_zenith = with(zenith, between(kLitHigh, clouds), between(kDarkHigh, clouds));
  cloudy_horizon = with(horizon, between(kLitLow, clouds), between(kDarkLow, clouds));
}

}  // namespace frond
