#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <utility>

#include "core/content.h"
#include "core/parallel.h"
#include "organisms/kinds.h"
#include "preset/json.h"
#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/feeding.h"
#include "scene/fit.h"
#include "scene/inside.h"
#include "scene/nursery.h"
#include "scene/remarks.h"
#include "scene/settle.h"
#include "scene/shading.h"
#include "scene/sowing.h"
#include "scene/style.h"
#include "settings/settings.h"
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
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    const Place& place = organism.place;
    if (organism.count == 0 || organism.sown) continue;
    PlacedEntry& plot = plots.emplace_back();
    plot.bed = {&organism, o, Seed{preset.seed}.child("organism", o), {}};
    if (finds_its_way(organism.grower->stage())) continue;
    auto room = static_cast<float>(room_of(place, extent));
    for (Vec2 at : place.at) plot.spots.push_back({at, room}), taken.take(plot.spots.back());
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
std::vector<Bed> set_feet(std::vector<PlacedEntry> plots, Grounds& ground) {
  std::vector<Bed> beds;
  for (PlacedEntry& plot : plots) {
    const Organism& organism = *plot.bed.organism;
    double rock = organism.grower->stands_on_rock() && organism.place.on.empty() ? organism.place.rock : 0;
    for (std::size_t i = 0; i < plot.spots.size(); ++i) {
      Seed seed = plot.bed.seed.child("instance", i);
      Vec2 at = plot.spots[i].at;
      float foot = ground.seat(at, rock, seed) + static_cast<float>(organism.place.raise);
      plot.bed.plantings.push_back({seed, Vec3(at.x, foot, at.y)});
    }
    beds.push_back(std::move(plot.bed));
  }
  return beds;
}

/// How many steps are told while a bed grows: one for each planting, also for those that have yet to find
/// room on bodies; all creepers or fish of an entry grow as one.
std::size_t steps_of(const Bed& bed) {
  const Organism& organism = *bed.organism;
  if (finds_its_way(organism.grower->stage())) return 1;
  std::size_t to_come = organism.place.on.empty() ? 0 : static_cast<std::size_t>(organism.count);
  return std::max(bed.plantings.size(), to_come);
}

/// Grows the beds of a scene stage by stage and adds them to the world.
class Gardener {
 public:
  Gardener(const Preset& preset, const Watch& watch, Nursery* nursery, const Haste& haste,
           const Surface& floor)
      : preset_(preset), watch_(watch), nursery_(nursery), haste_(haste) {
    if (!nursery_) return;
    std::string_view land(reinterpret_cast<const char*>(floor.position.data()),
                          floor.position.size() * sizeof(Vec3));
    land_ = content_id(land);
    surroundings_ =
        fmt::format("{} {} {}", preset.film.length(), preset.film.frames > 1, preset.stage.setting);
  }

  Errors grow_all(const std::vector<Bed>& beds, World& world) {
    for (GrowthStage stage : {GrowthStage::free, GrowthStage::in_space, GrowthStage::in_light,
                              GrowthStage::creeping, GrowthStage::swimming}) {
      std::vector<Bed> growing;
      std::ranges::copy_if(beds, std::back_inserter(growing),
                           [&](const Bed& bed) { return bed.organism->grower->stage() == stage; });
      if (leaves_out(stage, growing)) continue;
      if (stage == GrowthStage::in_space) {
        if (Errors errors = settle_colonies(growing, world, notes); !errors.empty())
          return placed(errors, "");
        for (const Bed& bed : growing)  // those that found no room are done
          for (std::size_t i = bed.plantings.size(); i < steps_of(bed); ++i) watch_.step();
      }
      if (Errors errors = grow_stage(stage, growing, world); !errors.empty()) return errors;
    }
    return {};
  }

  std::vector<std::size_t> grown;              ///< entries
  std::map<std::size_t, std::string> origins;  ///< what stands for all that an entry grew from
  std::vector<std::string> names;              ///< in the nursery
  std::vector<std::size_t> missing;            ///< entries that were left out
  std::vector<std::string> notes;

 private:
  bool wants(const std::vector<Bed>& beds) const {
    return !haste_ || std::ranges::any_of(beds, [&](const Bed& bed) { return haste_->contains(bed.entry); });
  }

  void leave_out(const std::vector<Bed>& beds) {
    for (const Bed& bed : beds) missing.push_back(bed.entry);
  }

  /// What stands for a stage that has grown among all that is there now.
  std::string among(GrowthStage stage) const {
    return content_id(fmt::format("{} stage {}", surroundings_, static_cast<int>(stage)));
  }

  /// In haste, a stage of which nothing is wanted and nothing can have grown before. Where some of an earlier
  /// one are missing, nobody knows what others would stand on.
  bool leaves_out(GrowthStage stage, const std::vector<Bed>& beds) {
    if (!haste_ || !nursery_ || beds.empty() || stage == GrowthStage::free) return false;
    if (missing.empty() && (wants(beds) || nursery_->find(among(stage)))) return false;
    leave_out(beds);
    return true;
  }

  Errors grow_stage(GrowthStage stage, const std::vector<Bed>& beds, World& world) {
    std::vector<std::vector<Bed>> groups;
    // Each by itself, whatever grows beside it, or by what its rivals claim.
    if (nursery_ && (stage == GrowthStage::free || stage == GrowthStage::in_space))
      for (const Bed& bed : beds) groups.push_back({bed});
    else
      groups = by_kind(beds, [](const Bed& bed) { return bed.organism; });
    std::vector<std::string> keys(groups.size());
    if (nursery_)
      for (std::size_t g = 0; g < groups.size(); ++g) keys[g] = key_of(groups[g], stage, world.territories());
    if (nursery_ && !haste_ && !beds.empty()) nursery_->keep(among(stage), {});
    std::vector<std::vector<Specimen>> specimens(groups.size());
    std::vector<Errors> errors(groups.size());
    std::vector<char> fresh(groups.size()), left_out(groups.size());
    parallel_for(groups.size(), [&](std::size_t g) {
      fresh[g] = !take_grown(keys[g], world, specimens[g]);
      left_out[g] = fresh[g] && !wants(groups[g]);
      if (fresh[g] && !left_out[g]) errors[g] = grow(groups[g], world, keys[g], specimens[g]);
    });
    std::vector<Specimen> all;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (!errors[g].empty()) return errors[g];
      if (left_out[g]) leave_out(groups[g]), fresh[g] = false;
      std::ranges::move(specimens[g], std::back_inserter(all));
      for (const Bed& bed : groups[g]) {
        if (fresh[g]) grown.push_back(bed.entry);
        if (nursery_) origins[bed.entry] = keys[g] + land_;
      }
    }
    if (nursery_) names.insert(names.end(), keys.begin(), keys.end());
    // What comes later grows among all of these.
    for (const std::string& key : keys) surroundings_ += key;
    std::ranges::stable_sort(all, {}, &Specimen::entry);
    world.add(std::move(all));
    return {};
  }

  /// What has grown on other land stands on this one: at the same feet, and only its leaves fall elsewhere.
  bool take_grown(const std::string& key, const World& world, std::vector<Specimen>& specimens) {
    auto kept = nursery_ ? nursery_->find(key) : nullptr;
    if (!kept || std::ranges::any_of(*kept, [](const auto& s) { return s.model.solids.follow_ground; }))
      return false;
    specimens = *kept;
    for (Specimen& s : specimens)
      if (s.life.ground) s.life.ground = world.ground();
    return true;
  }

  Errors grow(const std::vector<Bed>& beds, const World& world, const std::string& key,
              std::vector<Specimen>& specimens) {
    if (watch_.given_up && watch_.given_up()) return {Error{"", "given up"}};
    std::vector<Result<Specimen>> all = beds.front().organism->grower->grow(beds, world, watch_.step);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i]) return placed(all[i].errors(), fmt::format("/organisms/{}", entry_of(beds, i)));
      assert(all[i]->model.check().empty() && "before others build on it");
      specimens.push_back(std::move(*all[i]));
    }
    if (nursery_) nursery_->keep(key, specimens);
    return {};
  }

  /// The entry that the i-th of what some beds have grown belongs to.
  static std::size_t entry_of(const std::vector<Bed>& beds, std::size_t i) {
    for (const Bed& bed : beds) {
      std::size_t count = finds_its_way(bed.organism->grower->stage()) ? 1 : bed.plantings.size();
      if (i < count) return bed.entry;
      i -= count;
    }
    return beds.back().entry;
  }

  /// Errors whose `where` is a pointer below another one, at their places in the preset. What names a file
  /// keeps it.
  Errors placed(Errors errors, const std::string& below) const {
    for (Error& error : errors)
      if (error.where.empty() || (error.where[0] == '/' && error.where.find(':') == error.where.npos))
        error = fault_at(preset_, below + error.where, error.what);
    return errors;
  }

  /// All that the specimens of some beds depend on. Of the land, what stands by itself takes the height of
  /// its foot alone.
  std::string key_of(const std::vector<Bed>& beds, GrowthStage stage, const Territories& territories) const {
    std::string text = surroundings_;
    if (stage == GrowthStage::creeping || stage == GrowthStage::in_space) text += land_;
    const Value* written = preset_.written->find("organisms");
    for (const Bed& bed : beds) {
      text += fmt::format("\n{} {} {} {}", bed.entry, bed.seed.key, serialize(written->items[bed.entry]),
                          bed.organism->text);
      for (const Planting& p : bed.plantings) {
        text += fmt::format(" {} {} {} {} {} {} {}", p.seed.key, p.foot.x, p.foot.y, p.foot.z, p.normal.x,
                            p.normal.y, p.normal.z);
        if (p.claim >= territories.size()) continue;
        for (std::size_t rival : territories.rivals(p.claim)) {
          const Claim& c = territories.claim(rival);
          text += fmt::format(" {} {} {} {} {}", c.foot.x, c.foot.y, c.foot.z, c.across, c.up);
        }
      }
    }
    return content_id(text);
  }

  const Preset& preset_;
  const Watch& watch_;
  Nursery* nursery_;
  const Haste& haste_;
  std::string land_;          // a hash of it
  std::string surroundings_;  // all that organisms grow in so far, but for the land
};

/// All specimens in the order of the preset, those of the setting first and creepers last.
std::vector<Specimen> in_order(std::vector<Specimen> all, const Preset& preset) {
  std::ranges::stable_sort(all, {}, [&](const Specimen& s) {
    if (s.entry == Specimen::kNoEntry) return std::size_t{0};
    bool creeps = finds_its_way(preset.organisms[s.entry].grower->stage());
    return 1 + s.entry + (creeps ? preset.organisms.size() : 0);
  });
  return all;
}

/// What lies about, as one mesh.
Surface strewn_surface(const Grounds& ground) {
  Surface all;
  for (const Strewn& strewn : ground.strewn())
    for (const Strewn::At& at : strewn.at) append_placed(all, *strewn.shape, at.place, at.turn, at.size);
  all.uv.clear();
  return all;
}

void note_growth(Scene& scene) {
  for (const Specimen& s : scene.specimens)
    for (const std::string& note : s.model.notes) {
      std::string line = s.name.empty() ? note : s.name + ": " + note;
      // One of many like it is enough.
      if (std::ranges::find(scene.notes, line) == scene.notes.end()) scene.notes.push_back(line);
    }
}

}  // namespace

std::size_t Scene::nodes() const {
  std::size_t sum = 0;
  for (const Specimen& s : specimens) sum += s.model.skeleton.size();
  return sum;
}

std::size_t Scene::bytes() const {
  std::size_t bytes = specimens.capacity() * sizeof(Specimen) + stands.capacity() * sizeof(SownStand) +
                      bytes_of(drawings) + (ground ? ground->bytes() : 0);
  for (const Specimen& s : specimens) bytes += bytes_of(s);
  for (const SownStand& stand : stands) {
    const Copies& c = stand.copies;
    bytes += bytes_of(stand.organism.text) + bytes_of(c.model) + bytes_of(c.foot) + bytes_of(c.turn) +
             bytes_of(c.scale) + bytes_of(c.tint);
  }
  return bytes;
}

std::string Scene::check() const {
  for (const Specimen& s : specimens)
    if (std::string fault = s.check(); !fault.empty()) return s.name + ": " + fault;
  for (const SownStand& stand : stands) {
    const Copies& c = stand.copies;
    if (c.foot.size() != c.size() || c.turn.size() != c.size() || c.scale.size() != c.size() ||
        c.tint.size() != c.size())
      return stand.organism.name + ": the arrays of the copies differ in length";
    for (std::size_t i = 0; i < c.size(); ++i)
      if (c.model[i] >= stand.organism.sown->models || c.tint[i] >= kTints || !(c.scale[i] > 0))
        return fmt::format("{}: copy {} is none of a model", stand.organism.name, i);
  }
  return ground ? ground->floor().check() : "there is no ground";
}

Result<Scene> build_scene(const Preset& preset, const Watch& watch, Nursery* nursery, const Haste& haste) {
  // What has grown may be needed once more, see below.
  if (Nursery own; !nursery && !preset.stage.camera.fit.empty()) return build_scene(preset, watch, &own);
  Seed seed{preset.seed};
  Scene scene;
  scene.film = preset.film;
  scene.stage = preset.stage;

  const SettingAnswers& setting = settings()[preset.stage.setting].answers;
  watch.begin("place", 3);
  std::unique_ptr<Grounds> ground = setting.lay(preset.stage, preset.film, reach_of(preset), seed);
  if (preset.stage.camera.follow) scene.stage.camera = over_ground(preset.stage.camera, ground->heights());
  watch.step();
  TakenSpots taken;
  std::vector<PlacedEntry> plots = find_places(preset, setting.extent(preset.stage), taken, scene.notes);
  watch.step();
  ground->strew(taken);
  sow_stands(scene, preset, *ground, taken.list());
  std::vector<Bed> beds = set_feet(std::move(plots), *ground);
  watch.step();

  std::size_t growing = 0;
  for (const Bed& bed : beds) growing += steps_of(bed);
  watch.begin("grow", growing);
  World world(seed, ground->heights(), preset.film.length(), preset.film.frames > 1, std::move(taken));
  world.add(ground->furnishings());
  bool swims = std::ranges::any_of(
      beds, [](const Bed& bed) { return bed.organism->grower->stage() == GrowthStage::swimming; });
  if (swims) world.lay(strewn_surface(*ground));
  Gardener gardener(preset, watch, nursery, haste, ground->floor());
  if (Errors errors = gardener.grow_all(beds, world); !errors.empty()) return errors;
  scene.grown = std::move(gardener.grown);
  scene.origins = std::move(gardener.origins);
  scene.nursery = std::move(gardener.names);
  scene.missing = std::move(gardener.missing);
  std::ranges::move(gardener.notes, std::back_inserter(scene.notes));

  scene.specimens = in_order(std::move(world).take_all(), preset);
  shade(scene.specimens);
  if (preset.film.frames > 1) feed(scene.specimens, preset.film.length());
  if (!preset.stage.camera.fit.empty() && scene.missing.empty()) {
    Camera moved = fitted(scene.stage.camera, outside_of(scene, preset.stage.camera.fit),
                          preset.film.aspect(), ground->heights());
    // Land is laid as far as the camera goes: where it has to step back from all that, once more with that in
    // mind.
    if (reach_of(moved) > reach_of(preset)) {
      Preset wider = preset;
      wider.stage.camera = std::move(moved);
      wider.stage.camera.fit.clear(), wider.stage.camera.follow = false;
      std::vector<std::size_t> grown = std::move(scene.grown);
      scene = {};  // its specimens are in the nursery
      Result<Scene> again = build_scene(wider, watch, nursery, haste);
      if (!again) return again;
      for (std::size_t entry : again->grown)
        if (std::ranges::find(grown, entry) == grown.end()) grown.push_back(entry);
      again->grown = std::move(grown);
      return again;
    }
    scene.stage.camera = std::move(moved);
  }
  ground->lay_litter(scene.stage.camera);
  scene.ground = std::move(ground);
  for (const std::string& said :
       {under_ground(scene.stage.camera, preset.film, scene.ground->heights()), inside_something(scene)})
    if (!said.empty()) scene.notes.push_back(fault_at(preset, "/scene/camera/location", said).text());
  note_growth(scene);
  for (const Organism& organism : preset.organisms)
    if (organism.count > 0)
      std::ranges::move(drawings(organism.grower->dress().look), std::back_inserter(scene.drawings));
  if (Errors errors = take_styles(scene, preset); !errors.empty()) return errors;
  note_fit(scene);
  assert(scene.check().empty());
  return scene;
}

}  // namespace frond
