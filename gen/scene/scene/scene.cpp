#include "scene/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

#include "appearance/mask_drawing.h"
#include "core/cancellation.h"
#include "organisms/kinds.h"
#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/entry_seeds.h"
#include "scene/far.h"
#include "scene/feeding.h"
#include "scene/fit.h"
#include "scene/rain.h"
#include "scene/reef.h"
#include "scene/remarks.h"
#include "scene/shading.h"
#include "scene/snow.h"
#include "scene/sowing.h"
#include "scene/specimen_cache.h"
#include "scene/stages.h"
#include "scene/stand.h"
#include "scene/style.h"
#include "scene/wind.h"
#include "settings/meadow.h"
#include "settings/settings.h"
#include "world/other_barks.h"
#include "world/world.h"

namespace frond {

namespace {

/// An entry with the spots of its plantings, before these have a height.
struct PlacedEntry {
  Bed bed;
  std::vector<Spot> spots;
};

/// Entries that grow, each with its places; places are taken in the order of the preset.
std::vector<PlacedEntry> find_places(const Preset& preset, const Extent& extent, TakenSpots& taken,
                                     std::vector<std::string>& notes) {
  std::vector<PlacedEntry> plots;
  std::vector<Seed> seeds = entry_seeds(preset, "organism");
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    const Place& place = organism.place;
    if (organism.count == 0 || organism.sown) continue;
    PlacedEntry& plot = plots.emplace_back();
    plot.bed = {&organism, o, seeds[o], {}};
    if (organism.grower->traits().finds_own_place()) continue;
    auto room = static_cast<float>(room_of(place, extent));
    for (Vec2 at : place.at) plot.spots.push_back({at, room}), taken.add(plot.spots.back());
    if (!place.on.empty()) continue;  // bodies are not there yet
    int more = organism.count - static_cast<int>(plot.spots.size());
    for (const Spot& spot :
         scatter(place.center, place.inner, place.radius, room, more, taken, plot.bed.seed.child("scatter")))
      plot.spots.push_back(spot);
    if (plot.spots.size() < static_cast<std::size_t>(organism.count))
      notes.push_back(fmt::format("{}: only {} of {} found room; place.radius larger or place.spacing less?",
                                  organism.name.empty() ? fmt::format("organism {}", o) : organism.name,
                                  plot.spots.size(), organism.count));
  }
  return plots;
}

/// Gives each planting its foot.
std::vector<Bed> set_feet(const Preset& preset, std::vector<PlacedEntry> plots, Grounds& ground) {
  std::vector<Bed> beds;
  for (PlacedEntry& plot : plots) {
    const Organism& organism = *plot.bed.organism;
    double rock =
        organism.grower->traits().stands_on_rock && organism.place.on.empty() ? organism.place.rock : 0;
    for (std::size_t i = 0; i < plot.spots.size(); ++i) {
      bool given = i < organism.place.at.size();
      Seed seed = given ? plot.bed.seed.child("instance", i)
                        : planting_seed(preset, plot.bed.seed, "scattered", i, plot.spots[i].attempt);
      Vec2 at = plot.spots[i].at;
      float foot = ground.seat(at, rock, seed) + static_cast<float>(organism.place.raise);
      plot.bed.plantings.push_back({seed, Vec3(at.x, foot, at.y)});
      plot.bed.plantings.back().lines = organism.place.lines;
      if (i < organism.place.each.size()) {
        plot.bed.plantings.back().turn = organism.place.each[i].turn;
        plot.bed.plantings.back().size = organism.place.each[i].size;
      }
    }
    beds.push_back(std::move(plot.bed));
  }
  return beds;
}

/// All specimens in the order of the preset, those of the setting first and creepers last.
std::vector<Specimen> in_order(std::vector<Specimen> all, const Preset& preset) {
  std::ranges::stable_sort(all, {}, [&](const Specimen& s) {
    if (s.entry == Specimen::kNoEntry) return std::size_t{0};
    bool creeps = preset.organisms[s.entry].grower->traits().finds_own_place();
    return 1 + s.entry + (creeps ? preset.organisms.size() : 0);
  });
  return all;
}

/// What lies about, as one mesh.
Surface strewn_surface(const Grounds& ground) {
  Surface all;
  for (const ScatteredInstances& strewn : ground.strewn())
    for (const ScatteredInstances::At& at : strewn.at)
      append_placed(all, *strewn.shape, at.place, at.turn, at.size);
  all.uv.clear();
  return all;
}

/// The phase "grow".
Result<CacheUse> grow_in(World& world, const Preset& preset, const std::vector<Bed>& beds,
                         const Grounds& ground, const ProgressSink& watch, SpecimenCache* cache,
                         const EntryFilter& only, std::vector<std::string>& notes) {
  std::size_t steps = 0;
  for (const Bed& bed : beds) steps += steps_of(bed);
  watch.begin("grow", steps);
  bool swims =
      std::ranges::any_of(beds, [](const Bed& bed) { return bed.organism->grower->traits().swims(); });
  if (swims) world.lay(strewn_surface(ground));
  return grow_stages(preset, beds, ground.floor(), watch, cache, only, world, notes);
}

Result<Scene> build_all(const Preset& preset, const ProgressSink& watch, SpecimenCache* cache,
                        const EntryFilter& only);

/// The names that the organ may have which a part of the camera's subjects is.
std::vector<std::string> organs_of(const Preset& preset) {
  const std::string& part = preset.setup.camera.part;
  std::vector<std::string> names;
  auto add = [&](std::string_view what, const std::optional<TaxonPart>& is, std::string_view of_trees) {
    if (part != what) return;
    if (is && !is->organ.empty()) names.push_back(is->organ);
    names.emplace_back(of_trees);
  };
  const Taxon known = preset.taxon.value_or(Taxon{});
  add("leaf", known.leaf, "sprig"), add("flower", known.flower, "blossom"),
      add("fruit", known.fruit, "fruit");
  names.push_back(part);
  return names;
}

/// Points on the outside of what the camera is moved to show.
std::vector<Vec3> shown_of(Scene& scene, const Preset& preset) {
  const std::string& part = preset.setup.camera.part;
  std::vector<std::string> subjects = preset.setup.camera.subjects();
  if (part.empty()) return outside_of(scene, subjects);
  if (preset.setup.camera.fit.empty() && !preset.organisms.empty()) subjects = {preset.organisms[0].name};
  for (const std::string& organ : organs_of(preset))
    if (std::vector<Vec3> points = outside_of_part(scene, subjects, organ); !points.empty()) return points;
  scene.notes.push_back(fault_at(preset, "/scene/camera/part",
                                 fmt::format("there is no \"{}\" to come close to; organs here are {}", part,
                                             fmt::join(organ_names(scene, subjects), ", ")))
                            .text());
  return outside_of(scene, subjects);
}

/// The scene once more, for a camera that has stepped back. `before`: entries that grew the first time.
Result<Scene> build_wider(const Preset& preset, Camera camera, std::vector<std::size_t> before,
                          const ProgressSink& watch, SpecimenCache* cache, const EntryFilter& only) {
  Preset wider = preset;
  wider.setup.camera = std::move(camera);
  wider.setup.camera.fit.clear(), wider.setup.camera.compose.reset(), wider.setup.camera.follow = false;
  Result<Scene> scene = build_all(wider, watch, cache, only);
  if (!scene) return scene;
  for (std::size_t entry : scene->grown)
    if (std::ranges::find(before, entry) == before.end()) before.push_back(entry);
  scene->grown = std::move(before);
  return scene;
}

Result<Scene> build_all(const Preset& preset, const ProgressSink& watch, SpecimenCache* cache,
                        const EntryFilter& only) {
  // What has grown may be needed once more, see below.
  const std::vector<std::string> subjects = preset.setup.camera.subjects();
  if (SpecimenCache own; !cache && !subjects.empty()) return build_all(preset, watch, &own, {});
  Seed seed{preset.seed};
  Scene scene;
  scene.film = preset.film;
  scene.setup = preset.setup;
  scene.seed = seed;

  const SettingAnswers& setting = settings()[preset.setup.setting].answers;
  watch.begin("place", 3);
  std::unique_ptr<Grounds> ground = setting.lay(preset.setup, preset.film, reach_of(preset), seed);
  if (preset.setup.camera.follow) scene.setup.camera = over_ground(preset.setup.camera, ground->heights());
  watch.step();
  TakenSpots taken;
  std::vector<PlacedEntry> plots = find_places(preset, setting.extent(preset.setup), taken, scene.notes);
  watch.step();
  ground->strew(taken);
  sow_copies(scene, preset, *ground, taken.list());
  if (preset.reef) add_reef(scene, preset, *ground, reef_history(preset));
  if (preset.stand) add_stand(scene, preset, *ground, stand_history(preset, *ground));
  std::vector<Bed> beds = set_feet(preset, std::move(plots), *ground);
  watch.step();

  World world(seed, ground->heights(), preset.film.length(), preset.film.frames > 1, std::move(taken));
  std::optional<Vec3> storms_toward;
  if (const auto& wind = preset.setup.wind) storms_toward = wind_field(*wind, 0, seed).along;
  world.schedule(preset.events, storms_toward);
  world.add(ground->furnishings());
  std::vector<std::string> notes;
  Result<CacheUse> grown = grow_in(world, preset, beds, *ground, watch, cache, only, notes);
  if (!grown) return grown.errors();
  static_cast<CacheUse&>(scene) = std::move(*grown);
  if (scene.missing.empty())
    if (Errors errors = sow_on_bodies(scene, preset, world); !errors.empty()) return errors;
  set_copy_lifetimes(scene, preset);
  std::ranges::move(notes, std::back_inserter(scene.notes));

  scene.specimens = in_order(std::move(world).release(), preset);
  shade(scene.specimens);
  if (preset.film.frames > 1) feed(scene.specimens, preset.film.length());
  add_wind(scene, preset);
  if (!subjects.empty() && scene.missing.empty()) {
    Camera moved = fitted(scene.setup.camera, shown_of(scene, preset), preset.film.aspect(),
                          ground->heights(), daylight_of(setup_at(scene.setup, 0)).sun);
    // Land is laid as far as the camera goes: where it has to step back from all that, once more with that in
    // mind.
    if (reach_of(moved) > reach_of(preset)) {
      std::vector<std::size_t> before = std::move(scene.grown);
      scene = {};  // its specimens are in the cache
      return build_wider(preset, std::move(moved), std::move(before), watch, cache, only);
    }
    scene.setup.camera = std::move(moved);
  }
  watch.begin("surround", 5);
  ground->lay_litter(scene.setup.camera);
  watch.step();
  if (is_snowy(scene.setup) || is_rainy(scene.setup))
    scene.overhead = std::make_shared<const CoverGrid>(bodies_overhead(scene));
  std::optional<Specimen> snow = lying_snow(scene, *ground, seed.child("snow"));
  watch.step();
  if (is_snowy(scene.setup)) load_boughs(scene, preset);
  watch.step();
  std::optional<Specimen> water = standing_water(scene, *ground);
  watch.step();
  scene.ground = std::move(ground);
  if (std::optional<DistantTerrain> far = far_land_round(scene, seed.child("far"))) {
    plant_far_trees(scene, preset, *far, seed.child("far trees"));
    scene.far = std::make_shared<const DistantTerrain>(std::move(*far));
  }
  watch.step();
  note_camera(scene, preset);
  note_growth(scene, preset);
  for (const Organism& organism : preset.organisms)
    if (organism.count > 0 || (organism.sown && (preset.stand || preset.reef || preset.setup.far))) {
      Look look = ail_look(organism.grower->appearance().look, organism.courses);
      add_other_barks(look.branches, organism.edits);
      std::ranges::move(drawings(look), std::back_inserter(scene.drawings));
    }
  if (const Mask& grass = scene.setup.block<Meadow>().lawn.map; !grass.empty())
    scene.drawings.push_back(mask_drawing(grass));
  if (Errors errors = resolve_styles(scene, preset); !errors.empty()) return errors;
  note_fit(scene);
  for (Specimen& s : scene.specimens) s.snowy = is_snowy(scene.setup), s.wet = is_rainy(scene.setup);
  if (snow) scene.specimens.push_back(std::move(*snow));
  if (water) scene.specimens.push_back(std::move(*water));
  assert(scene.find_fault().empty());
  return scene;
}

}  // namespace

Quat Copies::turn_at(std::size_t i, double time) const {
  if (span.empty() || !span[i].fall) return turn[i];
  return glm::angleAxis(span[i].fall->angle(time), span[i].fall->axis) * turn[i];
}

double CopySpan::share(double time) const {
  return std::clamp((time - begin) / std::max(end - begin, 1e-9), 0.0, 1.0);
}

void Copies::add(const Copies& all, std::size_t i, CopySpan in) {
  model.push_back(all.model[i]), foot.push_back(all.foot[i]), turn.push_back(all.turn[i]);
  scale.push_back(all.scale[i]), tint.push_back(all.tint[i]), span.push_back(std::move(in));
}

Vec3 Copies::scale_at(std::size_t i, double time) const {
  if (span.empty()) return Vec3(scale[i]);
  Vec2 size = span[i].size(time);
  return scale[i] * Vec3(size.x, size.y, size.x);
}

double Copies::moss_at(std::size_t i, double time) const {
  return span.empty() ? 0
                      : std::lerp(span[i].moss.x, span[i].moss.y, static_cast<float>(span[i].share(time)));
}

std::size_t Scene::nodes() const {
  std::size_t sum = 0;
  for (const Specimen& s : specimens) sum += s.model.skeleton.size();
  return sum;
}

std::size_t Scene::bytes() const {
  std::size_t bytes = specimens.capacity() * sizeof(Specimen) + copy_sets.capacity() * sizeof(CopySet) +
                      bytes_of(drawings) + (ground ? ground->bytes() : 0);
  for (const Specimen& s : specimens) bytes += bytes_of(s);
  for (const CopySet& set : copy_sets) {
    const Copies& c = set.copies;
    bytes += bytes_of(c.model) + bytes_of(c.foot) + bytes_of(c.turn) + bytes_of(c.scale) + bytes_of(c.tint) +
             bytes_of(c.span);
  }
  return bytes;
}

std::string Scene::find_fault() const {
  for (const Specimen& s : specimens)
    if (std::string fault = s.find_fault(); !fault.empty()) return s.name + ": " + fault;
  for (const CopySet& set : copy_sets) {
    const Copies& c = set.copies;
    if (c.foot.size() != c.size() || c.turn.size() != c.size() || c.scale.size() != c.size() ||
        c.tint.size() != c.size() || (!c.span.empty() && c.span.size() != c.size()))
      return set.organism.name + ": the arrays of the copies differ in length";
    for (std::size_t i = 0; i < c.size(); ++i)
      if (c.model[i] >= set.organism.sown->models || c.tint[i] >= kTints || !(c.scale[i] > 0))
        return fmt::format("{}: copy {} is none of a model", set.organism.name, i);
  }
  return ground ? ground->floor().find_fault() : "there is no ground";
}

Result<Scene> build_scene(const Preset& preset, const ProgressSink& watch, SpecimenCache* cache,
                          const EntryFilter& only) {
  Result<Scene> scene = Error{"", "given up"};
  try {
    while_wanted(watch.cancelled, [&] { scene = build_all(preset, watch, cache, only); });
  } catch (const Cancelled&) {
  }
  return scene;
}

}  // namespace frond
