#include "scene/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/sowing.h"

namespace frond {

namespace {

constexpr double kMostPatches = 400'000;        // of grass or gravel; each is an object of POV-Ray's
constexpr double kMostBlades = 1'000'000;       // in all shapes of such patches
constexpr double kMostPoints = 200;             // of a path
constexpr double kLongestPath = 10'000;         // metres
constexpr double kLongestWay = 10'000;          // metres that a camera goes in a forest
constexpr double kMostLightCells = 50'000'000;  // tiles in the directory of a field of light

using Excesses = std::vector<Excess>;

void add_grass(Excesses& list, const Meadow& meadow) {
  if (meadow.blade <= 0 || meadow.blades <= 0) return;
  double side = 5 * meadow.blade, patches = kPi * std::pow(meadow.extent / side, 2);
  double blades = 4 * meadow.blades * std::pow(1.12 * side, 2);
  if (patches > kMostPatches)
    list.push_back(
        {"/scene/meadow/blade",
         fmt::format("grass of {:g} m takes {:.2g} patches as far as {:g} m; expected {:g} at most, "
                     "by longer blades or a smaller extent",
                     meadow.blade, patches, meadow.extent, kMostPatches)});
  if (blades > kMostBlades)
    list.push_back(
        {"/scene/meadow/blades",
         fmt::format("patches of grass of {:g} m would hold {:.2g} blades; expected {:g} at most, by "
                     "fewer or shorter ones",
                     meadow.blade, blades, kMostBlades)});
}

/// Of a path on land that reaches `reach` metres from the middle.
void add_path(Excesses& list, const PathShape& path, const std::string& pointer, double reach) {
  if (static_cast<double>(path.points.size()) > kMostPoints)
    return list.push_back(
        {pointer, fmt::format("found {} points; expected {:g} at most", path.points.size(), kMostPoints)});
  double length = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (glm::length(glm::dvec2(path.points[i])) > reach)
      return list.push_back(
          {fmt::format("{}/{}", pointer, i),
           fmt::format("lies off the ground; expected a place within {:g} m of the middle", reach)});
    if (i > 0) length += glm::distance(path.points[i - 1], path.points[i]);
  }
  if (length > kLongestPath)
    list.push_back(
        {pointer, fmt::format("makes a path of {:.3g} m; expected {:g} m at most", length, kLongestPath)});
}

void add_gravel(Excesses& list, const Garden& garden) {
  const std::vector<Vec2>& points = garden.path.points;
  double length = 0, side = 10 * garden.gravel;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  double patches = length * garden.path.width / (side * side);
  if (patches > kMostPatches)
    list.push_back(
        {"/scene/garden/gravel",
         fmt::format("stones of {:g} m take {:.2g} patches on such a path; expected {:g} at most, by "
                     "larger stones or a shorter or narrower path",
                     garden.gravel, patches, kMostPatches)});
}

/// Leaves and moss lie wherever the camera comes near.
void add_litter(Excesses& list, const Preset& preset) {
  double way = 0;
  Vec3 last = preset.stage.camera.location.at(preset.film.time(1));
  for (int frame = 2; frame <= preset.film.frames; ++frame) {
    Vec3 at = preset.stage.camera.location.at(preset.film.time(frame));
    way += glm::distance(last, at);
    last = at;
  }
  if (way > kLongestWay)
    list.push_back({"/scene/camera/location",
                    fmt::format("the camera goes {:.3g} m through the forest; expected {:g} m at most", way,
                                kLongestWay)});
}

double reach_of(const Organism& o) {
  double reach = glm::length(o.place.center) + o.place.radius;
  if (o.count <= std::ssize(o.place.at)) reach = 0;  // none is scattered
  for (Vec2 at : o.place.at) reach = std::max<double>(reach, glm::length(at));
  return reach;
}

/// The field of light of all trees together.
void add_light(Excesses& list, const Preset& preset) {
  std::optional<std::size_t> first;
  double reach = 0, low = 0, high = 0;
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    const Organism& o = preset.organisms[i];
    const auto* tree = std::get_if<TreeParams>(&o.body);
    if (!tree || o.sown || o.count == 0) continue;
    if (!first) first = i;
    double tall = tree->species.height * (1 + o.place.size_variation);
    reach = std::max(reach, reach_of(o) + tall / 2);
    low = std::min(low, o.place.raise), high = std::max(high, o.place.raise + tall);
  }
  if (!first) return;
  if (preset.stage.setting == Setting::forest) high += preset.stage.forest.terrain.hills;
  double voxel = std::get<TreeParams>(preset.organisms[*first].body).light.voxel;
  double tiles = std::pow(2 * reach / (16 * voxel), 2) * (high - low) / voxel;
  if (tiles > kMostLightCells)
    list.push_back(
        {fmt::format("/organisms/{}/light/voxel", *first),
         fmt::format("cells of {:g} m are too many for light {:.3g} m wide and {:.3g} m high; expected "
                     "{:.2g} m or more, or trees nearer to each other",
                     voxel, 2 * reach, high - low, voxel * std::cbrt(tiles / kMostLightCells) * 1.05)});
}

}  // namespace

std::vector<Excess> beyond_bounds(const Preset& preset) {
  std::vector<Excess> list;
  const Stage& stage = preset.stage;
  if (stage.setting == Setting::meadow || stage.setting == Setting::garden) add_grass(list, stage.meadow);
  if (stage.setting == Setting::garden) {
    add_path(list, stage.garden.path, "/scene/garden/path/points", 150);
    if (list.empty()) add_gravel(list, stage.garden);
  }
  if (stage.setting == Setting::forest) {
    const TerrainShape& land = stage.forest.terrain;
    add_path(list, land.path, "/scene/forest/terrain/path/points", std::max(1200.0, 2 * land.size));
    add_litter(list, preset);
  }
  add_light(list, preset);
  return list;
}

double room_of(const Place& place, Setting setting) {
  return std::max(place.spacing, setting == Setting::underwater ? place.rock / 2 : 0.0);
}

double reach_of(const Preset& preset) {
  double reach = 0;
  for (const Organism& o : preset.organisms)
    if (!o.sown) reach = std::max(reach, reach_of(o));
  for (const auto& key : preset.stage.camera.location.keys())
    reach = std::max<double>(reach, glm::length(Vec2(key.value.x, key.value.z)));
  return reach;
}

std::vector<Excess> without_room(const Preset& preset) {
  std::vector<Excess> list;
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    const Organism& o = preset.organisms[i];
    if (std::holds_alternative<IvyParams>(o.body)) continue;
    // Discs of their room that do not overlap, on all the ground that they may reach.
    double room = 0, ground = 0;
    if (o.sown) {
      const SowRules& rules = o.sown->where;
      room = rules.radius * (1 - o.place.size_variation);
      ground = std::pow(sown_size(preset.stage) + 2 * room, 2);
      if (rules.reach > 0) ground = std::min(ground, kPi * std::pow(rules.reach + room, 2));
    } else {
      room = room_of(o.place, preset.stage.setting);
      ground = kPi * (std::pow(o.place.radius + room, 2) - std::pow(std::max(0.0, o.place.inner - room), 2));
    }
    double most = ground / (kPi * room * room);
    // Darts cover 0.547 of a large ring with discs of one size, whatever their number.
    if (!o.sown) most = std::min(most, 0.6 * most + 40);
    double more = o.count - static_cast<double>(o.place.at.size());
    if (room <= 0 || more <= most) continue;
    list.push_back(
        {fmt::format("/organisms/{}/count", i),
         fmt::format(
             "{} have no room: each keeps {:.3g} m free round itself, so that {:.0f} at most "
             "could stand there; expected fewer, or {}",
             o.count, room, std::floor(most) + static_cast<double>(o.place.at.size()),
             o.sown ? "a smaller sown.where.radius" : "a larger place.radius or a smaller place.spacing")});
  }
  return list;
}

}  // namespace frond
