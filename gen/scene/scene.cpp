#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "geometry/ground.h"
#include "geometry/scatter.h"
#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/creep.h"
#include "scene/forest_floor.h"
#include "scene/grove.h"
#include "scene/lawn.h"
#include "scene/put.h"
#include "scene/remarks.h"
#include "scene/sowing.h"
#include "scene/style.h"
#include "scene/tree_dress.h"

namespace frond {

namespace {

constexpr int kStoneShapes = 5;
constexpr int kRockLooks = 3;
constexpr double kFloorRadius = 32;  // metres, at least: as far as the water lets one see
constexpr double kFloorBeyond = 4;   // metres from what stands farthest out to the edge, at least

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
  Ground ground;
  TakenSpots taken;  // by organisms and stones
  std::vector<Stone> shapes;
  Scene scene;
  Heights heights;  // of the scene's floor
  /// How high the floor that is drawn lies there.
  float height(Vec2 at) const { return static_cast<float>(heights(at.x, at.y)); }
};

std::vector<Planting> plantings(Builder& b) {
  std::vector<Planting> list;
  for (std::size_t o = 0; o < b.preset.organisms.size(); ++o) {
    const Organism& organism = b.preset.organisms[o];
    const Place& place = organism.place;
    Seed seed = b.seed.child("organism", o);
    if (organism.count == 0 || organism.sown || std::holds_alternative<IvyParams>(organism.body)) continue;
    auto room = static_cast<float>(room_of(place, b.preset.stage.setting));
    std::vector<Spot> spots;
    for (Vec2 at : place.at) spots.push_back({at, room});
    for (const Spot& spot : spots) b.taken.take(spot);
    int more = organism.count - static_cast<int>(spots.size());
    for (const Spot& spot :
         scatter(place.center, place.inner, place.radius, room, more, b.taken, seed.child("scatter")))
      spots.push_back(spot);
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
  stone.at = Vec3(at.x, b.height(at) + top * (1 - 2 * sunk), at.y);
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
    for (const Spot& spot : spots) lay_stone(b, spot.at, static_cast<float>(width), 0.35f, seed);
  }
}

/// What the parameters of an organism say about its look and motion.
struct Dress {
  Branches& branches;
  const Seed& seed;

  void operator()(const CoralParams& params) {
    branches.skin = params.skin;
    branches.motion = {params.growth, params.wave, params.food, 1};
    vary(params.skin.tint.variation);
  }
  void operator()(const PlantParams& params) {
    branches.bark = params.bark;
    branches.blade_look = params.blades;
    branches.season = params.season;
    branches.motion = {params.growth, params.wave, {}, 1};
    vary(params.bark.variation);
  }
  void operator()(const auto&) {}  // bodies have neither; ivy dresses itself
  void operator()(const WeberPennParams& params) { vary(wear(branches, params)); }
  void operator()(const ColonizedParams& params) { vary(wear(branches, params)); }
  void operator()(const TreeParams& params) {
    branches.bark = params.bark;
    branches.coat = params.coat;
    branches.season = params.season;
    branches.motion = {params.growth, params.wave, {}, 1, true};
    vary(params.bark.variation);
  }
  void vary(double variation) { branches.brightness = 1 + variation * seed.child("brightness").range(-1, 1); }
};

/// Gives what has grown its look and its motion.
void dress(Branches& branches, const Preset& preset, const Planting& planting) {
  Seed seed = planting.seed;
  std::visit(Dress{branches, seed}, planting.organism->body);
  branches.season_seed = seed.child("season");
  branches.motion.film_length = preset.film.length();
  branches.motion.growth.start += branches.motion.growth.stagger * seed.child("start").unit();
  branches.motion.wave.phase += seed.child("phase").range(-0.6, 0.6);
}

/// Whether it grows together with others, in one light.
bool grows_in_grove(const Planting& planting) {
  return std::holds_alternative<TreeParams>(planting.organism->body);
}

Result<Branches> plant(const Builder& b, const Planting& planting, float foot_height) {
  const Preset& preset = b.preset;
  const Organism& organism = *planting.organism;
  Seed seed = planting.seed;
  Result<Model> grown = grow(organism, seed.child("grow"));
  if (!grown) return grown.errors();

  Branches branches;
  branches.name = organism.name;
  branches.entry = static_cast<std::size_t>(planting.organism - preset.organisms.data());
  const Place& place = organism.place;
  float size = static_cast<float>(1 + place.size_variation * seed.child("size").range(-1, 1));
  double turn = place.turn + place.turn_variation * seed.child("turn").range(-1, 1);
  Quat yaw = glm::angleAxis(static_cast<float>(turn), Vec3(0, 1, 0));
  double toward = seed.child("toward").range(0, 2 * kPi);
  Quat lean =
      glm::angleAxis(static_cast<float>(place.lean * seed.child("lean").unit()),
                     Vec3(static_cast<float>(std::cos(toward)), 0, static_cast<float>(std::sin(toward))));
  // What stands in the ground stands as deep as it is thick, or as a small one bears.
  float sunk = place.raise > 0 || grown->skeleton.size() == 0
                   ? 0
                   : std::min(grown->skeleton.radius[0], 0.1f * grown->skeleton.longest()) * size;
  Vec3 foot(planting.spot.at.x, foot_height - sunk, planting.spot.at.y);
  Quat stand = grown->solids.follow_ground ? yaw : lean * yaw;
  settle(branches, std::move(*grown), foot, stand, size);
  if (place.raise == 0) follow_ground(branches.solids, b.heights, foot_height);
  if (const auto* params = std::get_if<PlantParams>(&organism.body); params && params->by_steps)
    branches.stages = {*params, seed.child("grow"), foot, lean * yaw, size};
  dress(branches, preset, planting);
  return branches;
}

/// How high the foot of an organism stands.
float foot_of(Builder& b, const Planting& p) {
  const Place& place = p.organism->place;
  float raise = static_cast<float>(place.raise);
  if (b.preset.stage.setting == Setting::studio) return raise;
  if (b.preset.stage.setting == Setting::meadow || b.preset.stage.setting == Setting::forest)
    return b.height(p.spot.at) + raise;
  if (b.preset.stage.setting == Setting::garden) {
    // Over a pond things stand on the water.
    bool water = b.scene.plot.pond_distance(p.spot.at) < 0;
    float level = static_cast<float>(b.preset.stage.garden.pond.level);
    return (water ? std::max(level, b.height(p.spot.at)) : b.height(p.spot.at)) + raise;
  }
  const auto& body = p.organism->body;
  bool stone = std::holds_alternative<RockParams>(body) || std::holds_alternative<PebblesParams>(body);
  float rock = stone ? 0 : static_cast<float>(place.rock);
  float top = rock > 0 ? lay_stone(b, p.spot.at, rock, 0.3f, p.seed.child("rock")) : b.height(p.spot.at);
  return top + raise;
}

}  // namespace

namespace {

Result<Branches> in_full_leaf(const Branches& branches, double time) {
  if (branches.life) return tree_at(branches, time);
  Branches now = branches;
  if (!branches.stages) return now;
  const Stages& stages = *branches.stages;
  const Growth& growth = branches.motion.growth;
  double share = std::min(growth_front(growth, time) / (1 + growth.ripen), 1.0);
  Result<Model> model = grow_plant(stages.params, stages.seed, share);
  if (!model) return model.errors();
  settle(now, std::move(*model), stages.foot, stages.turn, stages.size);
  now.motion.growth = {};
  return now;
}

}  // namespace

Result<Branches> developed(const Branches& branches, double time) {
  Result<Branches> now = in_full_leaf(branches, time);
  if (!now || !branches.season) return now;
  GroundAt ground;
  if (branches.ground) ground = [&](double x, double z) { return (*branches.ground)(x, z); };
  in_season(now->organs, now->prototypes, *branches.season, time, branches.season_seed, ground);
  return now;
}

std::size_t Scene::nodes() const {
  std::size_t sum = 0;
  for (const Branches& b : branches) sum += b.rest.size();
  return sum;
}

namespace {

/// Lays the ground of the setting.
void lay_ground(Builder& b) {
  switch (b.preset.stage.setting) {
    case Setting::underwater: {
      double radius = std::max(kFloorRadius, reach_of(b.preset) + kFloorBeyond);
      int rings = static_cast<int>(std::lround(60 * std::sqrt(radius / kFloorRadius)));
      b.scene.floor = ground_surface(b.ground, Vec2(0), radius, rings);
      break;
    }
    case Setting::studio:
      break;
    case Setting::meadow:
    case Setting::garden:
      lay_lawn(b.scene, b.ground, reach_of(b.preset), b.seed);
      break;
    case Setting::forest: {
      auto terrain = std::make_shared<const Terrain>(b.preset.stage.forest.terrain, b.seed.child("terrain"));
      b.scene.floor = terrain->surface();
      b.scene.plot = terrain->plot();
      b.heights = Heights([terrain](double x, double z) { return terrain->height(x, z); });
      return;
    }
  }
  b.heights = Heights(b.scene.floor);
}

/// The skins of all that is built, where it stands.
std::vector<Surface> bodies(const std::vector<std::optional<Result<Branches>>>& grown) {
  std::vector<Surface> skins;
  for (const auto& result : grown)
    if (result && *result && (*result)->solids.size() > 0) skins.push_back(skin_of(**result));
  return skins;
}

}  // namespace

Result<Scene> build_scene(const Preset& preset, const Watch& watch) {
  Seed seed{preset.seed};
  const Floor& floor = preset.stage.floor;
  Builder b{preset, seed, {seed.child("ground"), floor.relief, floor.scale}, {}, {}, {}, {}};
  b.scene.film = preset.film;
  b.scene.stage = preset.stage;
  watch.begin("place", 3);
  lay_ground(b);
  if (preset.stage.camera.follow) b.scene.stage.camera = over_ground(preset.stage.camera, b.heights);
  if (std::string said = under_ground(b.scene.stage.camera, preset.film, b.heights); !said.empty())
    b.scene.notes.push_back(fault_at(preset, "/scene/camera/location", said).text());
  watch.step();
  std::vector<Planting> list = plantings(b);
  watch.step();
  if (preset.stage.setting == Setting::underwater) lay_stones(b);
  if (preset.stage.setting == Setting::meadow || preset.stage.setting == Setting::garden)
    cover_lawn(b.scene, b.heights, seed);
  if (preset.stage.setting == Setting::forest) {
    ForestLand land{[&](Vec2 at) { return b.heights(at.x, at.y); },
                    [&](Vec2 at) { return b.scene.plot.has_path() ? b.scene.plot.path_distance(at) : 1e6; }};
    mark_floor(b.scene, land, seed.child("floor"));
    strew_floor(b.scene, land, seed.child("floor"));
  }
  sow_stands(b.scene, preset, b.heights, b.taken.list());
  std::vector<float> feet;
  for (const Planting& p : list) feet.push_back(foot_of(b, p));
  watch.step();
  watch.begin("grow", list.size());
  std::vector<TreePlanting> trees;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (grows_in_grove(list[i]))
      trees.push_back({list[i].organism, list[i].seed, Vec3(list[i].spot.at.x, feet[i], list[i].spot.at.y)});
  std::vector<std::optional<Result<Branches>>> grown(list.size());
  parallel_for(list.size(), [&](std::size_t i) {
    if (grows_in_grove(list[i])) return;
    grown[i] = plant(b, list[i], feet[i]);
    watch.step();
  });
  std::vector<Branches> grove =
      grow_together(preset, trees, trees.empty() ? std::vector<Surface>{} : bodies(grown));
  for (std::size_t i = 0, tree = 0; i < list.size(); ++i) {
    if (!grows_in_grove(list[i])) continue;
    grown[i] = std::move(grove[tree++]);
    dress(**grown[i], preset, list[i]);
    watch.step();
  }
  for (const Organism& organism : preset.organisms)
    if (organism.count > 0)
      for (Drawing& drawing : drawings(organism)) b.scene.drawings.push_back(std::move(drawing));
  auto ground = std::make_shared<const Heights>(b.heights);
  for (auto& result : grown) {
    if (!*result) return result->errors();
    for (const std::string& note : (*result)->notes) {
      std::string line = (*result)->name.empty() ? note : (*result)->name + ": " + note;
      // One of many like it is enough.
      if (std::find(b.scene.notes.begin(), b.scene.notes.end(), line) == b.scene.notes.end())
        b.scene.notes.push_back(line);
    }
    if ((*result)->season) (*result)->ground = ground;
    b.scene.branches.push_back(std::move(**result));
  }
  if (Errors errors = creep(preset, b.scene, b.heights); !errors.empty()) return errors;
  if (Errors errors = take_styles(b.scene, preset); !errors.empty()) return errors;
  note_studio(b.scene);
  return std::move(b.scene);
}

}  // namespace frond
