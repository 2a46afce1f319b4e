#include "scene/stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "core/cancellation.h"
#include "core/content.h"
#include "core/parallel.h"
#include "organisms/describe.h"
#include "organisms/kinds.h"
#include "scene/sowing.h"
#include "scene/specimen_cache.h"

namespace frond {

namespace {

/// What stands for the events of a preset and for where storms blow.
std::string dates_text(const Preset& preset) {
  std::string text;
  for (const Event& event : preset.events) text += keys_of(event).all();
  if (const auto& wind = preset.setup.wind)
    text += fmt::format(" {} {}", wind->direction.x, wind->direction.z);
  return text;
}

/// Grows the beds of a scene stage by stage and adds them to the world.
class SceneBuilder {
 public:
  SceneBuilder(const Preset& preset, const ProgressSink& watch, SpecimenCache* cache, const EntryFilter& only,
               const Surface& floor, std::vector<std::string>& notes)
      : preset_(preset), watch_(watch), cache_(cache), only_(only), notes_(notes) {
    if (!cache_) return;
    std::string_view land(reinterpret_cast<const char*>(floor.position.data()),
                          floor.position.size() * sizeof(Vec3));
    land_ = content_id(land);
    surroundings_ =
        fmt::format("{} {} {}", preset.film.length(), preset.film.frames > 1, preset.setup.setting);
    if (!preset.events.empty()) surroundings_ += dates_text(preset);
  }

  Errors grow_all(const std::vector<Bed>& beds, World& world) {
    for (GrowthStage stage : {GrowthStage::free, GrowthStage::round_bodies, GrowthStage::in_space,
                              GrowthStage::in_light, GrowthStage::creeping, GrowthStage::swimming}) {
      std::vector<Bed> growing;
      std::ranges::copy_if(beds, std::back_inserter(growing),
                           [&](const Bed& bed) { return bed.organism->grower->traits().stage == stage; });
      if (leaves_out(stage, growing)) continue;
      if (stage == GrowthStage::in_space) {
        if (Errors errors = settle_colonies(preset_, growing, world, notes_); !errors.empty())
          return placed(errors, "");
        for (const Bed& bed : growing)  // those that found no room are done
          for (std::size_t i = bed.plantings.size(); i < steps_of(bed); ++i) watch_.step();
      }
      if (Errors errors = grow_stage(stage, growing, world); !errors.empty()) return errors;
    }
    return {};
  }

  CacheUse use;

 private:
  bool wants(const std::vector<Bed>& beds) const {
    return !only_ || std::ranges::any_of(beds, [&](const Bed& bed) { return only_->contains(bed.entry); });
  }

  void leave_out(const std::vector<Bed>& beds) {
    for (const Bed& bed : beds) use.missing.push_back(bed.entry);
  }

  /// What stands for a stage that has grown among all that is there now.
  std::string among(GrowthStage stage) const {
    return content_id(fmt::format("{} stage {}", surroundings_, static_cast<int>(stage)));
  }

  /// With a filter, a stage of which nothing is wanted and nothing can have grown before. Where some of an
  /// earlier one are missing, nobody knows what others would stand on.
  bool leaves_out(GrowthStage stage, const std::vector<Bed>& beds) {
    if (!only_ || !cache_ || beds.empty() || stage == GrowthStage::free) return false;
    if (use.missing.empty() && (wants(beds) || cache_->find(among(stage)))) return false;
    leave_out(beds);
    return true;
  }

  Errors grow_stage(GrowthStage stage, const std::vector<Bed>& beds, World& world) {
    std::vector<std::vector<Bed>> groups;
    // Each by itself, whatever grows beside it, or by what its rivals claim.
    if (cache_ && stage <= GrowthStage::in_space)
      for (const Bed& bed : beds) groups.push_back({bed});
    else
      groups = by_kind(beds, [](const Bed& bed) { return bed.organism; });
    std::vector<std::string> keys(groups.size()), for_others(groups.size()), unedited(groups.size());
    for (std::size_t g = 0; cache_ && g < groups.size(); ++g) {
      BedKeys found = keys_of_beds(groups[g], stage, world.territories());
      keys[g] = std::move(found.all), for_others[g] = std::move(found.for_others);
      unedited[g] = before_edits(groups[g], stage, world.territories());
    }
    if (cache_ && !only_ && !beds.empty()) cache_->keep(among(stage), {});
    std::vector<std::vector<Specimen>> specimens(groups.size());
    std::vector<Errors> errors(groups.size());
    std::vector<char> fresh(groups.size()), left_out(groups.size());
    parallel_for(groups.size(), [&](std::size_t g) {
      fresh[g] = !reuse_grown(keys[g], groups[g], world, specimens[g]);
      left_out[g] = fresh[g] && !wants(groups[g]);
      if (fresh[g] && !left_out[g]) errors[g] = grow(groups[g], world, keys[g], unedited[g], specimens[g]);
    });
    std::vector<Specimen> all;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (!errors[g].empty()) return errors[g];
      if (left_out[g]) leave_out(groups[g]), fresh[g] = false;
      std::ranges::move(specimens[g], std::back_inserter(all));
      for (const Bed& bed : groups[g]) {
        if (fresh[g]) use.grown.push_back(bed.entry);
        if (cache_) use.origins[bed.entry] = keys[g] + land_;
      }
    }
    if (cache_) use.cached.insert(use.cached.end(), keys.begin(), keys.end());
    // What comes later grows among all of these.
    for (const std::string& key : for_others) surroundings_ += key;
    std::ranges::stable_sort(all, {}, &Specimen::entry);
    world.add(std::move(all));
    return {};
  }

  /// What has grown on other land stands on this one: at the same feet, and only its leaves fall elsewhere.
  /// Its entry may have had another number then.
  bool reuse_grown(const std::string& key, const std::vector<Bed>& beds, const World& world,
                   std::vector<Specimen>& specimens) {
    auto kept = cache_ ? cache_->find(key) : nullptr;
    if (!kept || std::ranges::any_of(*kept, [](const auto& s) { return s.model.solids.follow_ground; }))
      return false;
    specimens = *kept;
    for (std::size_t i = 0; i < specimens.size(); ++i) {
      Specimen& s = specimens[i];
      s.entry = bed_of(beds, i).first->entry;
      if (s.life.ground) s.life.ground = world.ground();
    }
    return true;
  }

  /// Grows beds, edits them by hand and lets them fare as their entries say; what has grown is kept as well,
  /// so that another edit or another health grows nothing anew.
  Errors grow(const std::vector<Bed>& beds, const World& world, const std::string& key,
              const std::string& unedited, std::vector<Specimen>& specimens) {
    stay_wanted();
    if (unedited.empty() || !reuse_grown(unedited, beds, world, specimens)) {
      std::vector<Result<Specimen>> all = beds.front().organism->grower->grow(beds, world, watch_.step);
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i])
          return placed(all[i].errors(), fmt::format("/organisms/{}", bed_of(beds, i).first->entry));
        assert(all[i]->model.find_fault().empty() && "before others build on it");
        specimens.push_back(std::move(*all[i]));
      }
      if (cache_ && !unedited.empty()) cache_->keep(unedited, specimens);
    }
    parallel_for(specimens.size(), [&](std::size_t i) {
      auto [bed, planting] = bed_of(beds, i);
      edit_specimen(specimens[i], edits_of(bed->organism->edits, planting));
      set_courses(specimens[i], *bed, planting, world);
      Life& life = specimens[i].life;
      if (!cache_) life.edit = {};
      if (!life.edit && !life.develop) life.held = 0;
      assert(specimens[i].model.find_fault().empty() && "edits leave a whole model");
    });
    if (cache_) cache_->keep(key, specimens);
    return {};
  }

  static void set_courses(Specimen& specimen, const Bed& bed, std::size_t planting, const World& world) {
    const Courses& courses = bed.organism->courses;
    const Seed seed = planting < bed.plantings.size() ? bed.plantings[planting].seed : bed.seed;
    frond::set_courses(specimen, courses, seed.child("courses"));
    if (courses.health && courses.health->sheds > 0) specimen.life.ground = world.ground();
  }

  /// The bed that the i-th of what some beds have grown belongs to, and which of its plantings it is.
  static std::pair<const Bed*, std::size_t> bed_of(const std::vector<Bed>& beds, std::size_t i) {
    for (const Bed& bed : beds) {
      std::size_t count = bed.organism->grower->traits().finds_own_place() ? 1 : bed.plantings.size();
      if (i < count) return {&bed, i};
      i -= count;
    }
    return {&beds.back(), i};
  }

  /// The key of the same beds without edits and courses, for which nothing need be grown; empty if there are
  /// none.
  std::string before_edits(std::vector<Bed> beds, GrowthStage stage, const Territories& territories) const {
    std::vector<Organism> organisms;
    organisms.reserve(beds.size());
    bool any = false;
    for (Bed& bed : beds) {
      Organism& organism = organisms.emplace_back(*bed.organism);
      any = std::erase_if(organism.edits, [](const Edit& edit) { return !edit.dated(); }) > 0 || any;
      any = any || organism.courses.health || organism.courses.tint;
      organism.courses = {};
      bed.organism = &organism;
    }
    return any ? keys_of_beds(beds, stage, territories).all : "";
  }

  /// Errors whose `where` is a pointer below another one, at their places in the preset. What names a file
  /// keeps it.
  Errors placed(Errors errors, const std::string& below) const {
    for (Error& error : errors)
      if (error.where.empty() || (error.where[0] == '/' && error.where.find(':') == error.where.npos))
        error = fault_at(preset_, below + error.where, error.what);
    return errors;
  }

  struct BedKeys {
    std::string all;         // all that their specimens depend on
    std::string for_others;  // the same but for how they look, on which nothing depends that grows among them
  };

  /// Keys of all that these beds grow from at a stage. The land as a whole is part of them only for creepers
  /// and colonies; other organisms depend on the height of their own foot alone.
  BedKeys keys_of_beds(const std::vector<Bed>& beds, GrowthStage stage,
                       const Territories& territories) const {
    std::string text = surroundings_, looks;
    if (stage == GrowthStage::creeping || stage == GrowthStage::in_space) text += land_;
    for (const Bed& bed : beds) {
      Keys keys = keys_of(*bed.organism);
      looks += keys.look;
      text += fmt::format("\n{} {} {}", bed.seed.key, keys.shape, keys.motion);
      for (const Planting& p : bed.plantings) {
        text += fmt::format(" {} {} {} {} {} {} {} {}", p.seed.key, p.foot.x, p.foot.y, p.foot.z, p.normal.x,
                            p.normal.y, p.normal.z, p.turn);
        for (const PlaceLine& l : p.lines)
          text += fmt::format(" {} {} {} {}", l.at.x, l.at.y, l.turn, l.length);
        if (p.claim >= territories.size()) continue;
        for (std::size_t rival : territories.rivals(p.claim)) {
          const Claim& c = territories.claim(rival);
          text += fmt::format(" {} {} {} {} {}", c.foot.x, c.foot.y, c.foot.z, c.across, c.up);
        }
      }
    }
    return {content_id(text + looks), content_id(text)};
  }

  const Preset& preset_;
  const ProgressSink& watch_;
  SpecimenCache* cache_;
  const EntryFilter& only_;
  std::vector<std::string>& notes_;
  std::string land_;          // a hash of it
  std::string surroundings_;  // all that organisms grow in so far, but for the land
};

}  // namespace

std::size_t steps_of(const Bed& bed) {
  const Organism& organism = *bed.organism;
  if (organism.grower->traits().finds_own_place()) return 1;
  std::size_t to_come = organism.place.on.empty() ? 0 : static_cast<std::size_t>(organism.count);
  return std::max(bed.plantings.size(), to_come);
}

Result<CacheUse> grow_stages(const Preset& preset, const std::vector<Bed>& beds, const Surface& floor,
                             const ProgressSink& watch, SpecimenCache* cache, const EntryFilter& only,
                             World& world, std::vector<std::string>& notes) {
  SceneBuilder builder(preset, watch, cache, only, floor, notes);
  if (Errors errors = builder.grow_all(beds, world); !errors.empty()) return errors;
  return std::move(builder.use);
}

}  // namespace frond
