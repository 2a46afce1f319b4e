#include "draw/rain.h"

#include <algorithm>
#include <cmath>

#include "core/loop.h"
#include "core/parallel.h"
#include "draw/eyes.h"
#include "motion/rain.h"
#include "scene/wind.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr double kShow = 0.3;  // pixels that a drop must be thick to be drawn
constexpr int kFarRain = 7;    // metres to the farthest that are
constexpr double kColumn = 8;  // metres of air about the camera, from top to bottom
constexpr std::size_t kMostStreaks = 4000;
constexpr double kRingDrop = 1.5;   // mm
constexpr double kLeastDrop = 0.5;  // mm

/// One square metre of the air about the camera.
struct Column {
  const Eye& eye;
  Vec3 mean, wind;    ///< metres a second: always, and now
  double rate, most;  ///< mm/h now, and at most in the film
  double time, open, film_length;
  const CoverGrid* overhead;  ///< bodies that keep drops off; null: none

  /// The drops of the column that show; `at`: corner of the column, x and z.
  void drops(Vec2 at, const Seed& seed, std::vector<Streak>& into) const {
    double aside = 0.8 + 0.5 * static_cast<double>(glm::length(mean));  // of the column and of the wind in it
    double near =
        std::max(0.3, static_cast<double>(glm::distance(at + 0.5f, Vec2(eye.at.x, eye.at.z))) - aside);
    double least = std::max(kLeastDrop, 1000 * kShow * eye.pixel * near);
    double count = kColumn * drops_thicker(most, kLeastDrop);
    for (double i = 0; i < count; ++i) {  // the thickest first
      Seed own = seed.child(static_cast<std::uint64_t>(i));
      double diameter = drop_diameter(most, kLeastDrop, (i + own.child(0).unit()) / count);
      if (drop_diameter(most, kLeastDrop, (i + 1) / count) < least) break;
      // The share of such drops of the film's hardest rain that fall now, less the lot of this drop.
      double falls = drop_density(rate, diameter) / drop_density(most, diameter) - own.child(4).unit();
      if (falls > 0) add(at, diameter, std::min(1.0, 10 * falls), own, into);
    }
  }

  void add(Vec2 at, double diameter, double there, const Seed& own, std::vector<Streak>& into) const {
    double speed = terminal_speed(diameter);
    // A drop comes through the column a whole number of times in a film that repeats.
    double high = film_length > 0 ? speed / looping_rate(speed / kColumn, film_length) : kColumn;
    double fallen = std::fmod(own.child(1).unit() * high + speed * time + eye.at.y + 1000 * high, high);
    Vec3 middle(at.x + own.child(2).unit(), eye.at.y + high / 2 - fallen, at.y + own.child(3).unit());
    middle += static_cast<float>((fallen - high / 2) / speed) * mean;  // its way is slanted
    Vec3 half = static_cast<float>(open / 2) * (wind - Vec3(0, speed, 0));
    double away = glm::distance(middle, eye.at);
    if (diameter < 1000 * kShow * eye.pixel * away || away < 0.25 || !in_view(eye, middle, glm::length(half)))
      return;
    if (overhead && overhead->shelters(middle, wind - Vec3(0, speed, 0))) return;
    double length = 2 * static_cast<double>(glm::length(half)), thick = diameter / 1000;
    double width = std::max(thick, 0.5 * eye.pixel * away);
    double share = there * std::min(1.0, thick / length) * thick / width;
    into.push_back({middle - half, middle + half, static_cast<float>(width), static_cast<float>(share)});
  }
};

}  // namespace

double open_time(const Film& film, const Camera& camera) {
  constexpr double kUsual = 1.0 / 60;
  if (camera.shutter <= 0 || film.frames == 1) return kUsual;
  return camera.shutter / film.fps / exposures(film, camera);
}

std::vector<Streak> rain_streaks(const Scene& scene, double time) {
  if (!is_rainy(scene.setup)) return {};
  double rate = scene.setup.rain->rate.at(time), most = highest(scene.setup.rain->rate);
  if (most <= 0) return {};
  Eye eye = eye_at(scene, time);
  Column column{eye,
                Vec3(0),
                Vec3(0),
                rate,
                most,
                time,
                open_time(scene.film, scene.setup.camera),
                scene.film.loop(),
                scene.overhead.get()};
  if (std::optional<WindField> field = wind_in(scene)) {
    column.mean = static_cast<float>(kLowWind * field->speed) * field->along;
    column.wind = static_cast<float>(1 + field->gust(eye.at, time)) * column.mean;
  }
  constexpr int kSide = 2 * kFarRain + 1;
  std::vector<std::vector<Streak>> found(kSide * kSide);
  glm::ivec2 low = glm::ivec2(glm::floor(Vec2(eye.at.x, eye.at.z))) - kFarRain;
  parallel_for(found.size(), [&](std::size_t i) {
    glm::ivec2 cell = low + glm::ivec2(static_cast<int>(i) % kSide, static_cast<int>(i) / kSide);
    Seed seed = scene.seed.child("rain", static_cast<std::uint64_t>(cell.x))
                    .child(static_cast<std::uint64_t>(cell.y));
    column.drops(Vec2(cell), seed, found[i]);
  });
  std::vector<Streak> streaks = joined(found);
  if (streaks.size() > kMostStreaks) {
    std::ranges::stable_sort(streaks, std::greater(), &Streak::share);
    streaks.resize(kMostStreaks);
  }
  return streaks;
}

RingField ring_field(double rate, const Film& film) {
  RingField rings;
  rings.life = 1 / looping_rate(1 / rings.life, film.loop());
  double wanted =
      drops_landing(rate, kRingDrop) * rings.life * rings.cell * rings.cell;  // in a square at once
  constexpr int kMostLayers = 3;
  rings.layers = std::clamp(static_cast<int>(std::ceil(wanted)), rate > 0 ? 1 : 0, kMostLayers);
  rings.share = rings.layers > 0 ? std::min(1.0, wanted / rings.layers) : 0;
  return rings;
}

}  // namespace frond
