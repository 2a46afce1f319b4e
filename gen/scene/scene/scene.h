#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "land/far_objects.h"
#include "land/snow.h"
#include "motion/fall.h"
#include "scene/preset.h"
#include "settings/setting.h"
#include "world/specimen.h"

namespace frond {

/// When a copy is there and how it changes meanwhile, where copies come and go over a film.
struct CopySpan {
  double begin = 0, end = 0;         ///< seconds; at the end it is no longer there
  Vec2 first{1}, last{1};            ///< factors of its width and height at both; in proportion between
  std::shared_ptr<const Fall> fall;  ///< as which it falls over about its foot; null: it stands
  Vec2 moss{0};                      ///< 0..1, of what looks up, at both

  double share(double time) const;  ///< of it that has passed
  Vec2 size(double time) const { return glm::mix(first, last, static_cast<float>(share(time))); }
};

/// Copies of the models of a set: a structure of arrays. Metres.
struct Copies {
  std::vector<std::uint16_t> model;
  std::vector<Vec3> foot;
  std::vector<Quat> turn;
  std::vector<float> scale;
  std::vector<std::uint8_t> tint;  ///< 0..kTints - 1
  std::vector<CopySpan> span;      ///< empty: all stand there over the whole film

  std::size_t size() const { return model.size(); }
  bool there(std::size_t i, double time) const {
    return span.empty() || (time >= span[i].begin && time < span[i].end);
  }
  /// One more, copy `i` of others in one of its spans.
  void add(const Copies& all, std::size_t i, CopySpan in);
  Quat turn_at(std::size_t i, double time) const;
  Vec3 scale_at(std::size_t i, double time) const;
  double moss_at(std::size_t i, double time) const;
};
inline constexpr int kTints = 12;  ///< colours that copies of a set come in

/// An organism that is sown: where its copies stand. Its models are grown when they are written.
struct CopySet {
  std::size_t entry = 0;                       ///< which of the preset's organisms
  Organism organism;                           ///< that one
  Appearance appearance;                       ///< what it wears
  std::shared_ptr<const WindField> wind = {};  ///< in which its copies sway; none: they do not
  Copies copies;

  /// How high a model is at most, about, metres; 0: unknown.
  double tallest() const {
    return organism.sown->size ? double{organism.sown->size->height} : organism.grower->traits().tallest;
  }
};

/// What a cache of specimens had for a scene, and what not.
struct CacheUse {
  std::vector<std::size_t> grown;    ///< entries that were not taken from there
  std::vector<std::string> cached;   ///< what it is called there that stands in the scene
  std::vector<std::size_t> missing;  ///< entries that were left out, see EntryFilter
  std::map<std::size_t, std::string>
      origins;  ///< of entries that stand by themselves or creep, what stands for all that they grew from
};

/// All that stands before the camera, grown; nothing of it depends on the frame.
struct Scene : CacheUse {
  Film film;
  SceneSetup setup;
  Seed seed;                                  ///< the preset's
  std::shared_ptr<const Grounds> ground;      ///< that of its setting
  std::shared_ptr<const DistantTerrain> far;  ///< the land beyond the ground; null: none
  std::shared_ptr<const CoverGrid> overhead;  ///< bodies that keep off snow and rain; null: it is dry
  std::vector<Specimen> specimens;
  std::vector<CopySet> copy_sets;
  std::vector<Drawing> drawings;   ///< pictures that frames name, to be put beside them
  std::vector<std::string> notes;  ///< what the user should know of how it was built

  /// Nodes of all skeletons.
  std::size_t nodes() const;
  /// Bytes of memory that the scene holds, about.
  std::size_t bytes() const;

  /// Checks all invariants: one line for the first fault, empty when all is well.
  std::string find_fault() const;
};

/// Functions by which build_scene() tells how far it is.
struct ProgressSink {
  std::function<void(std::string_view phase, std::size_t steps)> begin;
  std::function<void()> step;  ///< one more of the phase is done; called from several threads
  std::function<bool()> cancelled =
      {};  ///< whether nobody waits for the scene any more; empty: somebody does
};

class SpecimenCache;

/// The entries that may grow where the cache does not have them, among what is there; without a set all may.
/// Other entries that the cache does not have are left out, and so is what grows among them, as it may come
/// to look otherwise. A camera that is to fit all organisms stays as it is.
using EntryFilter = std::optional<std::set<std::size_t>>;

/// Places and grows everything, and lays what is round it: the phases "place", "grow" and "surround". What a
/// cache has is taken from there. A scene that is given up is an error, soon and wherever the work is.
Result<Scene> build_scene(const Preset& preset, const ProgressSink& watch = {[](auto, auto) {}, [] {}},
                          SpecimenCache* cache = nullptr, const EntryFilter& only = {});

}  // namespace frond
