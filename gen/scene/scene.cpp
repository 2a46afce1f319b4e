#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "geometry/ground.h"
#include "geometry/scatter.h"

namespace frond {

namespace {

constexpr int kStoneShapes = 5;
constexpr int kRockLooks = 3;
constexpr double kFloorRadius = 32;  // metres, as far as the water lets one see

/// A place for one organism to be grown at.
struct Planting {
  const Organism* organism;
  Seed seed;
  Spot spot;
};

/// What growing and placing share.
struct Builder {
  const Preset& preset;
  Seed seed;
  std::vector<Spot> taken;  // by organisms and stones
  std::vector<Stone> shapes;
  Scene scene;

  float ground(Vec2 at) const { return static_cast<float>(surface_height(scene.floor, at.x, at.y)); }
};

std::vector<Planting> plantings(Builder& b) {
  std::vector<Planting> list;
  for (std::size_t o = 0; o < b.preset.organisms.size(); ++o) {
    const Organism& organism = b.preset.organisms[o];
    const Place& place = organism.place;
    Seed seed = b.seed.child("organism", o);
    if (organism.count == 0) continue;
    float room = static_cast<float>(std::max(place.spacing, place.rock / 2));
    std::vector<Spot> spots;
    for (Vec2 at : place.at) spots.push_back({at, room});
    b.taken.insert(b.taken.end(), spots.begin(), spots.end());
    int more = organism.count - static_cast<int>(spots.size());
    for (const Spot& spot :
         scatter(place.center, place.inner, place.radius, room, more, b.taken, seed.child("scatter"))) {
      spots.push_back(spot);
      b.taken.push_back(spot);
    }
    if (spots.size() < static_cast<std::size_t>(organism.count))
      b.scene.notes.push_back(
          fmt::format("{}: only {} of {} found room; place.radius larger or place.spacing less?",
                      organism.name.empty() ? fmt::format("organism {}", o) : organism.name, spots.size(),
                      organism.count));
    for (std::size_t i = 0; i < spots.size(); ++i)
      list.push_back({&organism, seed.child("instance", i), spots[i]});
  }
  return list;
}

/// Lays a stone so that `sunk` of its height is in the ground, and returns how high its top is above the
/// place.
float lay_stone(Builder& b, Vec2 at, float width, float sunk, Seed seed) {
  StoneInstance stone;
  stone.shape = static_cast<int>(seed.child("shape").bits() % kStoneShapes);
  stone.look = static_cast<int>(seed.child("look").bits() % kRockLooks);
  stone.turn = seed.child("turn").range(0, 2 * kPi);
  stone.size = Vec3(width, width * static_cast<float>(seed.child("height").range(0.75, 1.05)),
                    width * static_cast<float>(seed.child("depth").range(0.75, 1.1)));
  float top =
      stone_surface_point(b.shapes[static_cast<std::size_t>(stone.shape)], Vec3(0, 1, 0)).y * stone.size.y;
  stone.at = Vec3(at.x, b.ground(at) + top * (1 - 2 * sunk), at.y);
  b.scene.stone_instances.push_back(stone);
  return stone.at.y + top;
}

/// How finely stones are meshed: facets show sooner in careful pictures.
int stone_detail(Quality quality) { return quality == Quality::best ? 5 : 4; }

void lay_stones(Builder& b) {
  for (int i = 0; i < kStoneShapes; ++i) {
    Seed seed = b.seed.child("stone shape", static_cast<std::uint64_t>(i));
    b.shapes.push_back(
        {seed, seed.child("roughness").range(0.3, 0.6), seed.child("flatness").range(0.2, 0.45)});
    b.scene.stones.push_back(stone_surface(b.shapes.back(), stone_detail(b.preset.film.quality)));
  }
  const Floor& floor = b.preset.stage.floor;
  for (int i = 0; i < floor.stones; ++i) {
    Seed seed = b.seed.child("stone", static_cast<std::uint64_t>(i));
    // Many small ones, few large ones.
    double width = floor.stone_size * (0.12 + 0.88 * std::pow(seed.child("width").unit(), 4.0));
    auto spots =
        scatter(Vec2(0), 0, floor.extent, static_cast<float>(width / 2), 1, b.taken, seed.child("scatter"));
    for (const Spot& spot : spots) {
      lay_stone(b, spot.at, static_cast<float>(width), 0.35f, seed);
      b.taken.push_back(spot);
    }
  }
}

/// Turns, sizes and moves a skeleton from the origin to its place.
void put(Skeleton& s, Vec3 foot, Quat turn, float size) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.position[i] = foot + turn * (s.position[i] * size);
    s.radius[i] *= size;
    s.distance[i] *= size;
    s.to_tip[i] *= size;
  }
}

Result<Branches> plant(const Preset& preset, const Planting& planting, float foot_height) {
  const Organism& organism = *planting.organism;
  Seed seed = planting.seed;
  Result<Skeleton> grown = grow(organism, seed.child("grow"));
  if (!grown) return grown.errors();

  const auto& params = std::get<CoralParams>(organism.body);
  Branches branches{organism.name, std::move(*grown), {}, params.skin, 1};
  const Place& place = organism.place;
  float size = static_cast<float>(1 + place.size_variation * seed.child("size").range(-1, 1));
  double turn = place.turn + place.turn_variation * seed.child("turn").range(-1, 1);
  Quat yaw = glm::angleAxis(static_cast<float>(turn), Vec3(0, 1, 0));
  double toward = seed.child("toward").range(0, 2 * kPi);
  Quat lean =
      glm::angleAxis(static_cast<float>(place.lean * seed.child("lean").unit()),
                     Vec3(static_cast<float>(std::cos(toward)), 0, static_cast<float>(std::sin(toward))));
  // The foot stands a little in the ground, as deep as it is thick or as a small coral bears.
  float sunk = std::min(branches.rest.radius[0], 0.1f * branches.rest.longest()) * size;
  put(branches.rest, Vec3(planting.spot.at.x, foot_height - sunk, planting.spot.at.y), lean * yaw, size);
  branches.motion = {params.growth, params.wave, params.food, preset.film.length()};
  branches.motion.growth.start += params.growth.stagger * seed.child("start").unit();
  branches.motion.wave.phase += seed.child("phase").range(-0.6, 0.6);
  branches.brightness = 1 + params.skin.tint.variation * seed.child("brightness").range(-1, 1);
  return branches;
}

}  // namespace

std::size_t Scene::nodes() const {
  std::size_t sum = 0;
  for (const Branches& b : branches) sum += b.rest.size();
  return sum;
}

Result<Scene> build_scene(const Preset& preset) {
  Seed seed{preset.seed};
  const Floor& floor = preset.stage.floor;
  Builder b{preset, seed, {}, {}, {}};
  b.scene.title = preset.title;
  b.scene.film = preset.film;
  b.scene.stage = preset.stage;
  Ground ground{seed.child("ground"), floor.relief, floor.scale};
  b.scene.floor = ground_surface(ground, Vec2(0), kFloorRadius, 60);

  std::vector<Planting> list = plantings(b);
  lay_stones(b);
  std::vector<float> feet;
  for (const Planting& p : list) {
    float rock = static_cast<float>(p.organism->place.rock);
    float top = rock > 0 ? lay_stone(b, p.spot.at, rock, 0.3f, p.seed.child("rock")) : b.ground(p.spot.at);
    feet.push_back(top);
  }

  std::vector<std::optional<Result<Branches>>> grown(list.size());
  parallel_for(list.size(), [&](std::size_t i) { grown[i] = plant(preset, list[i], feet[i]); });
  for (auto& result : grown) {
    if (!*result) return result->errors();
    b.scene.branches.push_back(std::move(**result));
  }
  return std::move(b.scene);
}

}  // namespace frond
