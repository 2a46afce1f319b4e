#include "studio/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "core/bounds.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "preset/value.h"
#include "scene/copies.h"
#include "scene/far.h"
#include "settings/forest.h"
#include "settings/settings.h"
#include "studio/tiles.h"

namespace frond {

namespace {

constexpr int kWayPieces = 240;

Json light_json(const Daylight& light) {
  Json backdrop = Json::array();
  constexpr float kLitWall = 1.55f;  // what lamps throw on a wall, as POV-Ray's pictures have it
  const float lit = light.lamps.empty() ? 1 : kLitWall;
  for (const BackdropStop& stop : light.backdrop)
    backdrop.push_back({{"height", stop.height}, {"light", json_of(lit * stop.light)}});
  const FillLight& fill = light.fill;
  return {{"sun", json_of(light.sun)},
          {"sunlight", json_of(light.sunlight)},
          {"fill",
           {{"above", json_of(fill.above)},
            {"aside", json_of(fill.aside)},
            {"below", json_of(fill.below)},
            {"eye", json_of(fill.eye)}}},
          {"backdrop", std::move(backdrop)},
          {"fog", {{"color", json_of(light.fog)}, {"distance", light.fade}}}};
}

Json film_json(const Film& film) {
  return {{"frames", film.frames}, {"fps", film.fps}, {"size", film.size}, {"seconds", film.length()}};
}

Json camera_json(const Camera& camera, double time) {
  return {{"at", json_of(camera.location.at(time))},
          {"to", json_of(camera.look_at.at(time))},
          {"angle", camera.angle.at(time)}};
}

/// Where a camera that moves stands at moments of the film; none of one that does not.
Json way_json(const Camera& camera, const Film& film) {
  Json way = Json::array();
  int pieces = camera.location.constant() ? 0 : std::min(film.frames - 1, kWayPieces);
  double end = film.time(film.frames);
  for (int i = 0; pieces > 0 && i <= pieces; ++i)
    way.push_back(json_of(camera.location.at(end * i / pieces)));
  return way;
}

Vec3 foot_of(const Specimen& specimen, const Bounds& box) {
  const Model& m = specimen.model;
  if (m.skeleton.size() > 0) return m.skeleton.position[0];
  return box.empty() ? Vec3(0) : box.foot();
}

/// The organisms of the preset and the specimens of a scene.
void add_lists(Json& header, const Scene& scene, const Preset& preset) {
  std::vector<Bounds> boxes(scene.specimens.size());
  parallel_for(boxes.size(), [&](std::size_t i) { boxes[i] = bounds_of(scene.specimens[i].model); });
  std::vector<Bounds> of_entry(preset.organisms.size());
  std::vector<std::size_t> count(preset.organisms.size()), copies(preset.organisms.size());
  Json specimens = Json::array();
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& s = scene.specimens[i];
    Json one{{"entry", s.entry == Specimen::kNoEntry ? -1 : static_cast<int>(s.entry)},
             {"foot", json_of(foot_of(s, boxes[i]))},
             {"placed", nullptr},
             {"turn", {s.placement.turn.x, s.placement.turn.y, s.placement.turn.z, s.placement.turn.w}},
             {"size", s.placement.size}};
    if (s.entry != Specimen::kNoEntry) {
      // Plantings come in their order, those at given places first.
      std::size_t number = count[s.entry]++;
      const Organism& organism = preset.organisms[s.entry];
      if (number < organism.place.at.size() && !organism.grower->traits().creeps()) one["placed"] = number;
      if (!boxes[i].empty()) of_entry[s.entry].extend(boxes[i].low), of_entry[s.entry].extend(boxes[i].high);
    }
    specimens.push_back(std::move(one));
  }
  for (const CopySet& set : scene.copy_sets) {
    copies[set.entry] += set.copies.size();
    for (const Vec3& foot : set.copies.foot) of_entry[set.entry].extend(foot);
  }
  Json entries = Json::array();
  for (std::size_t e = 0; e < preset.organisms.size(); ++e) {
    Bounds box = of_entry[e].empty() ? Bounds{Vec3(0), Vec3(0)} : of_entry[e];
    entries.push_back({{"name", preset.organisms[e].name},
                       {"kind", preset.written->find("organisms")->items[e].find("kind")->text},
                       {"specimens", count[e]},
                       {"copies", copies[e]},
                       {"low", json_of(box.low)},
                       {"high", json_of(box.high)}});
  }
  header["entries"] = std::move(entries);
  header["specimens"] = std::move(specimens);
}

/// The colour of a floor below grass or litter that is not drawn blade by blade: on average over the depth of
/// a cover blades are shaded by those above them (Monsi and Saeki 1953), as much as in POV-Ray's pictures.
Color covered(const Color& color, const LowCover& cover) {
  constexpr double kExtinction = 2.7;
  double depth = kExtinction * cover.area;
  return depth > 0 ? srgb(static_cast<float>((1 - std::exp(-depth)) / depth) * linear(color)) : color;
}

/// How much of a place of a forest's floor is trodden, 0..1, by the marks of its mesh: mark_floor() and
/// mark_mountain().
float trodden(Vec2 mark, bool mountain) {
  return mountain ? 1 - glm::smoothstep(0.75f, 1.25f, std::abs(mark.x))
                  : 1 - glm::smoothstep(-0.3f, 0.3f, mark.x);
}

/// The colours of a forest's floor, four bytes a corner: its path is bare of what covers the rest; empty for
/// other settings.
std::vector<std::uint8_t> floor_colors(const Scene& scene, const Color& bare, const Color& floor) {
  const auto* forest = dynamic_cast<const ForestGround*>(scene.ground.get());
  std::vector<std::uint8_t> colors;
  if (!forest) return colors;
  for (const Vec2& mark : forest->floor().uv)
    push(colors, srgb(glm::mix(linear(floor), linear(bare), trodden(mark, forest->mountain))));
  return colors;
}

void add_ground(const Scene& scene, const Daylight& light, std::vector<DrawnPart>& parts) {
  auto add = [&](Surface shape, const Color& color, std::span<const float> places = {}) {
    DrawnPart& part = parts.emplace_back();
    part.head = {{"kind", "ground"},
                 {"entry", -1},
                 {"specimen", -1},
                 {"material", material_json({.color = color, .gloss = 0.02})}};
    shape.uv.clear();
    places.empty() ? part.add_surface("", shape) : add_placed(part, shape, places, false);
  };
  if (!scene.ground->floor().triangle.empty()) {
    Color floor = covered(light.ground, scene.ground->low_cover());
    add(scene.ground->floor(), floor);
    if (auto colors = floor_colors(scene, light.ground, floor); !colors.empty())
      parts.back().add("/colors", colors);
    if (std::optional<Tile> tile = tile_of(scene.setup))
      parts.back().head["material"]["tile"] = json_of(*tile);
  } else {
    constexpr float kHalf = 60;  // metres
    Surface plane;
    for (Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
      plane.position.push_back(Vec3(kHalf * corner.x, 0, kHalf * corner.y));
    plane.normal.assign(4, Vec3(0, 1, 0));
    plane.triangle = {{0, 2, 1}, {0, 3, 2}};
    add(plane, light.ground);
  }
  for (const Patches& patches : scene.ground->patches()) {
    std::vector<std::vector<float>> places(patches.shapes.size());
    if (!patches.color) continue;
    for (const Patch& patch : *patches.at) {
      Quat turn = Quat(Vec3(0, 1, 0), glm::normalize(Vec3(-patch.slope.x, 1, -patch.slope.y))) *
                  glm::angleAxis(static_cast<float>(patch.turn), Vec3(0, 1, 0));
      push(places[static_cast<std::size_t>(patch.shape)], patch.at, turn, Vec3(1));
    }
    for (std::size_t k = 0; k < places.size(); ++k)
      if (!places[k].empty()) add(*patches.shapes[k], *patches.color, places[k]);
  }
  std::vector<ScatteredInstances> all = scene.ground->strewn();
  if (scene.far) std::ranges::move(strewn_far(*scene.far), std::back_inserter(all));
  for (const ScatteredInstances& strewn : all) {
    if (strewn.at.empty()) continue;
    std::vector<float> places;
    for (const ScatteredInstances::At& a : strewn.at) push(places, a.place, a.turn, a.size);
    add(*strewn.shape, strewn.color, places);
  }
}

/// The parts of a specimen at a time. Their names tell which of its entry's it is, not which of the scene's:
/// so they stay what they are while others come and go.
Result<std::vector<DrawnPart>> parts_of(const Specimen& s, std::size_t number, double time) {
  auto now = developed(s, time);
  if (!now) return now.errors();
  Result<std::vector<DrawnPart>> parts = specimen_parts(**now, time);
  if (!parts) return parts;
  for (DrawnPart& part : *parts) {
    part.head["entry"] = s.entry == Specimen::kNoEntry ? -1 : static_cast<int>(s.entry);
    part.head["number"] = number;
    part.set_id();
    part.head.erase("number");
  }
  return parts;
}

/// For each specimen, how many of its entry come before it.
std::vector<std::size_t> numbers_of(const std::vector<Specimen>& specimens) {
  std::map<std::size_t, std::size_t> count;
  std::vector<std::size_t> numbers;
  for (const Specimen& s : specimens) numbers.push_back(count[s.entry]++);
  return numbers;
}

/// The parts of all specimens that are to be seen.
Errors add_specimens(const Scene& scene, const ViewRequest& request, ViewCache& ready,
                     std::vector<DrawnPart>& parts) {
  using Parts = std::shared_ptr<const std::vector<DrawnPart>>;
  std::vector<Parts> made(scene.specimens.size());
  std::vector<Errors> errors(scene.specimens.size());
  std::vector<std::size_t> numbers = numbers_of(scene.specimens);
  parallel_for(scene.specimens.size(), [&](std::size_t i) {
    const Specimen& s = scene.specimens[i];
    bool own = s.entry != Specimen::kNoEntry;
    if (own ? !request.shows(s.entry) : request.solo.has_value()) return;
    auto origin = scene.origins.find(s.entry);
    std::string name;
    if (origin != scene.origins.end() && !s.load) {  // snow comes from the whole scene
      name = fmt::format("{} {} {} {}", origin->second, s.entry, numbers[i], request.time);
      if ((made[i] = ready.parts.find(name))) return;
    }
    Result<std::vector<DrawnPart>> list = parts_of(s, numbers[i], request.time);
    if (!list) {
      errors[i] = list.errors();
      return;
    }
    made[i] = std::make_shared<const std::vector<DrawnPart>>(std::move(*list));
    std::size_t bytes = 0;
    for (const DrawnPart& part : *made[i]) bytes += part.bytes();
    if (!name.empty()) ready.parts.put(name, made[i], bytes);
  });
  for (std::size_t i = 0; i < made.size(); ++i) {
    if (!errors[i].empty()) return errors[i];
    if (!made[i]) continue;
    for (const DrawnPart& part : *made[i]) parts.emplace_back(part).head["specimen"] = i;
  }
  return {};
}

/// Three factors for colours, 128 for 1, which are about what a tint does.
std::array<std::uint8_t, 4> tint_bytes(const ColorShift& shift) {
  auto byte = [&](double turn) {
    return static_cast<std::uint8_t>(std::clamp(128 * shift.value * (1 + turn), 0.0, 255.0));
  };
  return {byte(shift.hue), byte(0), byte(-shift.hue), 255};
}

Errors add_copies(const Scene& scene, const ViewRequest& request, ViewCache& models,
                  std::vector<DrawnPart>& parts) {
  std::vector<std::pair<const CopySet*, int>> wanted;
  for (const CopySet& set : scene.copy_sets)
    if (request.shows(set.entry)) {
      std::set<int> used(set.copies.model.begin(), set.copies.model.end());
      for (int which : used) wanted.emplace_back(&set, which);
    }
  std::vector<Result<std::shared_ptr<const DrawnPart>>> grown(wanted.size(),
                                                              std::shared_ptr<const DrawnPart>{});
  parallel_for(wanted.size(),
               [&](std::size_t i) { grown[i] = models.model(*wanted[i].first, wanted[i].second); });
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!grown[i]) return grown[i].errors();
    const auto& [set, which] = wanted[i];
    DrawnPart part = **grown[i];
    std::vector<float> places;
    std::vector<std::uint8_t> tints;
    const Copies& c = set->copies;
    for (std::size_t k = 0; k < c.size(); ++k) {
      if (c.model[k] != which || !c.there(k, request.time)) continue;
      push(places, c.foot[k], c.turn_at(k, request.time), c.scale_at(k, request.time));
      for (std::uint8_t byte : tint_bytes(tint_shift(set->organism.sown->tint, c.tint[k])))
        tints.push_back(byte);
    }
    part.head["entry"] = set->entry, part.head["specimen"] = -1, part.head["model"] = which;
    part.add("/instances", places);
    part.add("/tints", tints);
    parts.push_back(std::move(part));
  }
  return {};
}

}  // namespace

Result<std::string> view_of(const Scene& scene, const Preset& preset, const ViewRequest& request,
                            ViewCache& models, Json header) {
  std::vector<DrawnPart> parts;
  const SettingRow& setting = settings()[scene.setup.setting];
  Daylight light = daylight_of(setup_at(scene.setup, request.time));
  if (!request.solo) add_ground(scene, light, parts);
  if (Errors errors = add_specimens(scene, request, models, parts); !errors.empty()) return errors;
  if (Errors errors = add_copies(scene, request, models, parts); !errors.empty()) return errors;

  std::size_t copies = 0;
  for (const CopySet& set : scene.copy_sets) copies += set.copies.size();
  header["time"] = request.time;
  header["film"] = film_json(scene.film);
  header["nodes"] = scene.nodes();
  header["copies"] = copies;
  header["camera"] = camera_json(scene.setup.camera, request.time);
  header["camera"]["way"] = way_json(scene.setup.camera, scene.film);
  header["light"] = light_json(light);
  header["setting"] = setting.name;
  header["land"] = setting.answers.extent(scene.setup).sown;
  Json food = Json::array();
  for (const FoodLeft& meal : food_places(scene.specimens, request.time)) food.push_back(json_of(meal.at));
  header["food"] = std::move(food);
  add_lists(header, scene, preset);
  return packet_of(std::move(header), std::move(parts), request.kept);
}

}  // namespace frond
