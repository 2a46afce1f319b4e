#include "draw/snowfall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/loop.h"
#include "core/parallel.h"
#include "draw/eyes.h"
#include "motion/snowfall.h"
#include "scene/wind.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr std::array kSizes{0.3, 0.6, 0.9, 1.2, 1.6, 2.0, 3.0};  // mm melted: flakes between two fall as one
constexpr int kFarFlake = 14;                                    // metres to the farthest
constexpr double kMostFlakes = 5000;
constexpr double kShowFlake = 0.4;   // pixels that a flake must be wide at least
constexpr double kLens = 0.008;      // metres, its diameter
constexpr double kNearFlake = 0.15;  // metres

/// A flake is drawn as a disc of as much as it covers: its diameter in metres, and what is melted of one of
/// those.
double drawn_size(double melted) { return std::sqrt(kFlakeCover) * flake_diameter(melted) / 1000; }
double melted_within(double size) { return melted_diameter(1000 * size / std::sqrt(kFlakeCover)); }

/// Pixels from which on flakes are drawn, so that about kMostFlakes of the heaviest snowfall are.
double least_pixels(const Eye& eye, double rate) {
  constexpr double kNext = 1.1;  // factor from one try to the next
  for (double least = kShowFlake;; least *= kNext) {
    double count = 0;
    // In shells of a metre.
    for (double away = 0.5; away < kFarFlake; ++away)
      count += 4 * eye.broad * eye.tall * away * away *
               flakes_larger(rate, melted_within(least * eye.pixel * away));
    if (count < kMostFlakes) return least;
  }
}

/// The flakes about the camera at a time, in cubes of a metre.
struct Flurry {
  const Scene& scene;
  Eye eye;
  double rate, most;  ///< mm/h now, and at most in the film
  double time, open, film_length;
  double least;  ///< pixels that they are wide at least
  double focus;  ///< metres from the camera
  Vec3 middle;   ///< where its wind is measured: the camera's place at the beginning
  WindField wind;

  /// What those of a size have fallen and drifted by since the beginning, in cubes, `period` in the whole
  /// film.
  struct Way {
    Vec3 velocity{0}, gone{0};
    glm::ivec3 period{0};
  };
  Way way_of(double melted) const {
    auto low = static_cast<float>(kLowWind * wind.speed);
    Way way{low * wind.along - Vec3(0, flake_speed(melted), 0)};
    if (film_length > 0) {
      auto film = static_cast<float>(film_length);
      way.period = glm::ivec3(glm::round(film * way.velocity));
      way.period.y = std::min(way.period.y, -1);
      way.velocity = Vec3(way.period) / film;
    }
    // Gusts are wider than what is in view, so they carry all of it alike, and nowhere press it together.
    way.gone = static_cast<float>(time) * way.velocity +
               static_cast<float>(wind.carried(middle, time)) * level(way.velocity);
    return way;
  }

  /// The number of a cube among those that come to the same place when the film repeats.
  static glm::ivec3 first_of(glm::ivec3 cube, glm::ivec3 period) {
    if (period.y == 0) return cube;
    return cube - period * static_cast<int>(std::floor(static_cast<double>(cube.y) / period.y));
  }

  /// Those of a cube, which is where it was at the beginning; the largest first.
  void flakes(glm::ivec3 cube, std::size_t size, const Way& way, std::vector<Streak>& into) const {
    Vec3 center = Vec3(cube) + 0.5f + way.gone;
    double away = glm::distance(center, eye.at);
    constexpr double kCube = 1.2;  // metres round its middle, with the way that flakes swing
    if (away > kFarFlake || !in_view(eye, center, kCube)) return;
    double smallest = std::max(kSizes[size], melted_within(least * eye.pixel * std::max(0.0, away - 1)));
    double from = flakes_larger(most, kSizes[size]), to = flakes_larger(most, kSizes[size + 1]);
    glm::ivec3 own = first_of(cube, way.period);
    Seed seed = scene.seed.child("snowfall", size);
    for (int axis = 0; axis < 3; ++axis) seed = seed.child(static_cast<std::uint64_t>(own[axis] + (1 << 20)));
    for (double i = seed.unit(); i < from - to; ++i) {
      double melted = kSizes[size + 1] - (kSizes[size + 1] - kSizes[size]) * i / (from - to);
      if (melted < smallest) break;
      flake(cube, melted, way, seed.child(static_cast<std::uint64_t>(i)), into);
    }
  }

  void flake(glm::ivec3 cube, double melted, const Way& way, Seed own, std::vector<Streak>& into) const {
    auto lot = [&](std::uint64_t k) { return static_cast<float>(own.child(k).unit()); };
    double falls = flakes_larger(rate, melted) / flakes_larger(most, melted) - own.child(3).unit();
    if (falls <= 0) return;
    Vec3 at = Vec3(cube) + Vec3(lot(0), lot(1), lot(2)) + way.gone;
    // It swings as it falls, by its own width and more.
    constexpr double kSlow = 0.3, kQuick = 1.1;                // swings a second
    constexpr float kTurn = 6.2832f;                           // radians
    constexpr float kLeastSwing = 0.01f, kSwingRange = 0.03f;  // metres
    double turn = 2 * kPi * looping_rate(own.child(4).range(kSlow, kQuick), film_length);
    auto phase = static_cast<float>(turn * time + own.child(5).range(0, 2 * kPi));
    float swing = kLeastSwing + kSwingRange * lot(6), aside = kTurn * lot(7);
    Vec3 sway(std::cos(aside), 0, std::sin(aside));
    at += swing * std::sin(phase) * sway;
    Vec3 drift = way.velocity + static_cast<float>(wind.gust(middle, time)) * level(way.velocity);
    double away = glm::distance(at, eye.at), size = drawn_size(melted);
    // It fades in: as it comes to snow harder, near the camera, far away, and where it is small.
    constexpr double kSudden = 10, kFarFade = 0.2, kSmallFade = 1.5;
    double fade = std::min(1.0, kSudden * falls) * smooth_step(kNearFlake, 2 * kNearFlake, away) *
                  smooth_step(0.0, kFarFade * kFarFlake, kFarFlake - away) *
                  smooth_step(least, kSmallFade * least, size / (eye.pixel * away));
    if (fade <= 0 || is_sheltered(at, drift)) return;
    add(at, drift + static_cast<float>(turn) * swing * std::cos(phase) * sway, size, fade, into);
  }

  static Vec3 level(Vec3 v) { return {v.x, 0, v.z}; }

  bool is_sheltered(Vec3 at, Vec3 velocity) const {
    return scene.overhead->shelters(at, velocity) ||
           static_cast<double>(at.y) < scene.ground->heights()(at.x, at.z) + scene.setup.snow.depth.at(time);
  }

  /// What of white stuff of a size, metres, that covers so much of its disc, is seen.
  void add(Vec3 at, Vec3 velocity, double size, double cover, std::vector<Streak>& into) const {
    double away = std::max<double>(glm::distance(at, eye.at), kNearFlake);
    double blur = kLens * std::abs(away - focus) / focus;
    constexpr double kSharpest = 0.7;                         // pixels, or it would flicker
    constexpr double kMostCover = 0.95, kLeastCover = 0.004;  // what is drawn of a disc
    double width = std::hypot(size, blur, kSharpest * eye.pixel * away);
    Vec3 along = direction_or(velocity, Vec3(0, -1, 0));
    double length = width + open * static_cast<double>(glm::length(velocity));
    if (!in_view(eye, at, length)) return;
    constexpr double kPeak = 2;  // a spot that fades to its rim is so much clearer in its middle
    Vec3 half = static_cast<float>(length / 2) * along;
    double share = std::min(kMostCover, kPeak * cover * size * size / (width * length));
    if (share > kLeastCover)
      into.push_back({at - half, at + half, static_cast<float>(width), static_cast<float>(share)});
  }
};

Flurry flurry_at(const Scene& scene, double time) {
  const SceneSetup& setup = scene.setup;
  Flurry flurry{scene,
                eye_at(scene, time),
                setup.snow.falling.at(time),
                highest(setup.snow.falling),
                time,
                open_time(scene.film, setup.camera),
                scene.film.loop(),
                kShowFlake,
                1,
                setup.camera.location.at(0),
                wind_in(scene).value_or(WindField{})};
  flurry.focus = std::max<double>(1, glm::distance(setup.camera.look_at.at(time), flurry.eye.at));
  return flurry;
}

/// What a bough has dropped: clumps of some millimetres that fall fast, and puffs of fine powder that widen,
/// drift and fade.
class Powder {
 public:
  Powder(const Flurry& flurry, std::vector<Streak>& into) : flurry_(flurry), into_(into) {}

  /// `nodes`: those of the bough.
  void add_bough(const Skeleton& bones, const std::vector<std::size_t>& nodes, double dropped, Seed seed) {
    double wood = 0;
    for (std::size_t i : nodes)
      if (bones.parent[i] != Skeleton::kRoot)
        wood += static_cast<double>(
            glm::distance(bones.position[i], bones.position[static_cast<std::size_t>(bones.parent[i])]));
    constexpr double kPuffsAMetre = 16, kLeastPuffs = 4, kMostPuffs = 60;
    constexpr std::uint64_t kClumpsAPuff = 4;
    constexpr double kTakes = 0.4;  // seconds in which all of it comes loose, as of SnowLoad
    auto puffs = static_cast<std::uint64_t>(std::clamp(kPuffsAMetre * wood, kLeastPuffs, kMostPuffs)),
         clumps = kClumpsAPuff * puffs;
    for (std::uint64_t i = 0; i < puffs + clumps; ++i) {
      Seed own = seed.child(i);
      double since = flurry_.time - dropped - own.child(0).range(0, kTakes);
      if (since <= 0) continue;
      Vec3 from = bones.position[nodes[static_cast<std::size_t>(own.child(1).unit() *
                                                                static_cast<double>(nodes.size()))]];
      add(from, since, i < puffs, own);
    }
  }

 private:
  void add(Vec3 from, double since, bool puff, const Seed& own) {
    // By eye: seconds and metres.
    constexpr double kClumpLife = 2.5;
    constexpr float kPuffSpread = 0.16f, kClumpSpread = 0.1f;  // a second
    constexpr double kPuffSize = 0.05, kWidens = 0.22;         // a second
    constexpr double kPuffCover = 0.16, kClumpCover = 0.8;     // of its disc
    constexpr double kComes = 0.1, kFades = 0.3;               // the latter a share of a clump's life
    double life = puff ? own.child(2).range(1.2, 2.6) : kClumpLife;
    if (since >= life) return;
    // It falls freely at first, and ever less faster, up to a speed at which the air holds it.
    double held = puff ? own.child(3).range(0.5, 1.3) : own.child(3).range(1.5, 4);
    double lag = held / kGravity, eased = since - lag * (1 - std::exp(-since / lag));
    auto aside = [&](std::uint64_t k) { return static_cast<float>(own.child(k).normal()); };
    Vec3 spread = (puff ? kPuffSpread : kClumpSpread) * Vec3(aside(4), 0.5f * aside(5), aside(6));
    Vec3 drift = static_cast<float>(kLowWind * flurry_.wind.speed *
                                    (1 + flurry_.wind.gust(from, flurry_.time - since))) *
                 flurry_.wind.along;
    Vec3 at =
        from + static_cast<float>(since) * spread + static_cast<float>(eased) * (drift - Vec3(0, held, 0));
    Vec3 velocity = static_cast<float>(1 - std::exp(-since / lag)) * (drift - Vec3(0, held, 0));
    if (flurry_.is_sheltered(at, velocity)) return;
    double left = 1 - since / life, begun = smooth_step(0.0, kComes, since);
    if (puff)
      flurry_.add(at, velocity, kPuffSize + kWidens * since, kPuffCover * begun * left * left, into_);
    else
      flurry_.add(at, velocity, own.child(7).range(0.003, 0.014),
                  kClumpCover * begun * smooth_step(0.0, kFades, left), into_);
  }

  const Flurry& flurry_;
  std::vector<Streak>& into_;
};

}  // namespace

std::vector<Streak> snow_flakes(const Scene& scene, double time) {
  if (!is_snowy(scene.setup) || highest(scene.setup.snow.falling) <= 0) return {};
  Flurry flurry = flurry_at(scene, time);
  flurry.least = least_pixels(flurry.eye, flurry.most);
  constexpr int kSide = 2 * kFarFlake + 3;
  std::vector<std::vector<Streak>> found(kSide * (kSizes.size() - 1));
  parallel_for(found.size(), [&](std::size_t i) {
    std::size_t size = i / kSide;
    Flurry::Way way = flurry.way_of((kSizes[size] + kSizes[size + 1]) / 2);
    glm::ivec3 low = glm::ivec3(glm::floor(flurry.eye.at - way.gone)) - kSide / 2;
    for (int y = 0; y < kSide; ++y)
      for (int z = 0; z < kSide; ++z)
        flurry.flakes(low + glm::ivec3(static_cast<int>(i) % kSide, y, z), size, way, found[i]);
  });
  return joined(found);
}

std::vector<Streak> snow_powder(const Scene& scene, double time) {
  constexpr float kHangs = 3;         // seconds
  constexpr float kLeastLoad = 0.3f;  // of what a level branch carries, on a node that drops some
  std::vector<Streak> powder;
  for (std::size_t s = 0; s < scene.specimens.size(); ++s) {
    const SnowLoad* load = scene.specimens[s].load.get();
    if (!load) continue;
    std::map<std::int32_t, std::vector<std::size_t>> falling;  // nodes of boughs
    for (std::size_t i = 0; i < load->bough.size(); ++i)
      if (auto since = static_cast<float>(time) - load->drops[static_cast<std::size_t>(load->bough[i])];
          since > 0 && since < kHangs && load->share[i] > kLeastLoad)
        falling[load->bough[i]].push_back(i);
    if (falling.empty()) continue;
    Flurry flurry = flurry_at(scene, time);
    Powder add(flurry, powder);
    for (const auto& [bough, nodes] : falling)
      add.add_bough(scene.specimens[s].model.skeleton, nodes, load->drops[static_cast<std::size_t>(bough)],
                    load->powder.child(static_cast<std::uint64_t>(bough)));
  }
  return powder;
}

}  // namespace frond
