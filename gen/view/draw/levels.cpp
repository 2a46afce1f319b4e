#include "draw/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/bounds.h"
#include "core/parallel.h"
#include "draw/ambience.h"
#include "draw/eyes.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr int kWholeFrom = 4;         // the first level at which copies are not cut
constexpr int kHeld = 24;             // frames for which a copy keeps its levels
constexpr int kGroups = 6;            // of copies: they change their levels one after the other
constexpr int kBeyond = 12;           // frames before and after those that are heeded
constexpr double kLeastPixels = 1.2;  // of a copy; what is smaller is left out
constexpr double kUnseen = 2;         // as coarse is what only throws a shadow
constexpr double kPenumbra = 0.004;   // metres of grain for each that a shadow falls: half its blur
constexpr float kMargin = 3;          // metres round what is in view

bool moves(const Camera& camera, double length) {
  auto seen = [&](double time) {
    return std::tuple(camera.location.at(time), camera.look_at.at(time), camera.angle.at(time));
  };
  for (int i = 1; i <= 16; ++i)
    if (seen(length * i / 16) != seen(0)) return true;
  return false;
}

auto order(const ModelFile& f) { return std::tuple(f.copy_set, f.model, f.level, f.block); }

}  // namespace

std::string model_file_name(const Organism& organism, int model, int level, int block, bool bare) {
  return fmt::format("model_{}_{}{}.inc", copy_id(organism, model, bare), level,
                     block == ModelFile::kWhole ? "" : fmt::format("_{}", block));
}

const ModelFile& CopyPlan::file(std::size_t copy_set, int model, const Drawn& one) const {
  auto wanted = std::tuple(copy_set, model, static_cast<int>(one.level), static_cast<int>(one.block));
  return *std::ranges::lower_bound(files, wanted, {}, order);
}

ModelBlocks blocks_of(const std::vector<Surfel>& surfels) {
  std::vector<Vec3> bits;
  for (const Surfel& surfel : surfels) bits.push_back(surfel.at);
  return ModelBlocks(bits);
}

Views::Views(const Scene& scene) : scene_(scene), coarse_(coarseness(scene.film.quality)) {
  const Film& film = scene.film;
  bool one = !moves(scene.setup.camera, film.length());
  groups_ = one ? 1 : kGroups;
  stretch_ = one ? film.frames : kHeld / kGroups;
  stretches_ = static_cast<std::size_t>((film.frames + stretch_ - 1) / stretch_);
  if (one) eyes_ = {{eye_at(scene, 0)}}, times_ = {{0, film.length()}};
  while (eyes_.size() < stretches_ + groups_ - 1) {
    int end = stretch_ * static_cast<int>(eyes_.size() + 1) + 1;
    times_.emplace_back(film.time(end - kHeld), film.time(end));
    std::vector<Eye>& eyes = eyes_.emplace_back();
    for (int frame = end - kHeld - kBeyond; frame < end + kBeyond; frame += 3)
      eyes.push_back(eye_at(scene, film.time(std::clamp(frame, 1, film.frames))));
  }
  constexpr int kSuns = 12;
  for (int k = 0, last = sun_moves(scene.setup) ? kSuns : 0; k <= last; ++k)
    if (auto ambience = ambience_of(scene, film.length() * k / kSuns);
        ambience && ambience->sunlight != Vec3(0))
      suns_.push_back(ambience->sun);
}

/// Whether the shadow of a ball may be in view.
bool Views::shades(const std::vector<Eye>& eyes, Vec3 from, float radius) const {
  float step = std::max(1.5f * radius, 1.0f);
  return std::ranges::any_of(suns_, [&](Vec3 sun) {
    if (sun.y < 0.03f) return false;
    Vec3 at = from;
    for (int i = 0; i < 60; ++i) {
      if (std::ranges::any_of(eyes, [&](const Eye& eye) { return in_view(eye, at, radius + 1.5f); }))
        return true;
      if (at.y + radius < scene_.ground->height({at.x, at.z})) return false;
      at -= sun * step;
    }
    return false;
  });
}

/// The level of detail of each block of a copy; kLevelCount for a block that is not drawn.
std::vector<int> Views::levels_of(const std::vector<Eye>& eyes, const ModelBlocks& blocks, Vec3 foot,
                                  Quat turn, float scale) const {
  Bounds box;
  for (int b = 0; b < blocks.count(); ++b) box.extend(blocks.middle(b));
  float around = scale * (glm::distance(box.low, box.middle()) + blocks.radius());
  float radius = scale * blocks.radius();
  std::vector<int> level(static_cast<std::size_t>(blocks.count()), kLevelCount);
  auto placed = [&](Vec3 at) { return foot + turn * (scale * at); };
  Vec3 center = placed(box.middle());
  bool seen =
      std::ranges::any_of(eyes, [&](const Eye& eye) { return in_view(eye, center, around + kMargin); });
  if (!seen && !shades(eyes, center, around)) return level;
  double finest = 1e30;
  for (int b = 0; b < blocks.count(); ++b) {
    Vec3 at = placed(blocks.middle(b));
    double grain = 1e30, unseen = 1e30;
    for (const Eye& eye : eyes) {
      Vec3 from = glm::conjugate(turn) * (eye.at - foot) / scale;
      double of = std::max<double>(scale * blocks.distance(b, from), 0.3) * eye.pixel;
      unseen = std::min(unseen, of);
      if (in_view(eye, at, radius)) grain = std::min(grain, of);
    }
    finest = std::min(finest, unseen);
    if (grain > 1e29) {
      if (!seen && !shades(eyes, at, radius)) continue;
      double deep = std::max<double>(at.y - foot.y, 0);
      grain = std::max(kUnseen * unseen, kPenumbra * deep);
    }
    level[static_cast<std::size_t>(b)] = level_for(grain * coarse_);
  }
  if (2 * around < kLeastPixels * finest) level.assign(level.size(), kLevelCount);
  return level;
}

/// The blocks of copies whose levels may change after the stretch `last`, as they are drawn until then.
std::vector<Drawn> Views::drawn(std::size_t last, const CopySet& set, int model,
                                const ModelBlocks& blocks) const {
  const Copies& copies = set.copies;
  // For a copy that falls, the finest of its levels as it stands, is half way down and lies.
  auto levels_at = [&](std::size_t i) {
    if (copies.span.empty())
      return levels_of(eyes_[last], blocks, copies.foot[i], copies.turn[i], copies.scale[i]);
    const CopySpan& span = copies.span[i];
    std::vector<int> level(static_cast<std::size_t>(blocks.count()), kLevelCount);
    if (span.begin >= times_[last].second || span.end <= times_[last].first) return level;
    float scale = copies.scale[i] * std::max({span.first.x, span.first.y, span.last.x, span.last.y});
    for (double moment : {0.0, 0.8, 1.0}) {
      double time = span.fall ? span.fall->start + moment * span.fall->length() : 0;
      std::vector<int> now = levels_of(eyes_[last], blocks, copies.foot[i], copies.turn_at(i, time), scale);
      for (std::size_t b = 0; b < level.size(); ++b) level[b] = std::min(level[b], now[b]);
      if (!span.fall) break;
    }
    return level;
  };
  std::vector<std::vector<Drawn>> each(copies.size());
  parallel_for(copies.size(), [&](std::size_t i) {
    if (copies.model[i] != model || i % groups_ != last % groups_) return;
    std::vector<int> level = levels_at(i);
    auto add = [&](int block, int of) {
      each[i].push_back(
          {static_cast<std::uint32_t>(i), static_cast<std::int16_t>(block), static_cast<std::int16_t>(of)});
    };
    int finest = *std::ranges::min_element(level);
    if (finest < kLevelCount && (finest >= kWholeFrom || blocks.count() == 1))
      return add(ModelFile::kWhole, finest);
    for (std::size_t b = 0; b < level.size(); ++b)
      if (level[b] < kLevelCount) add(static_cast<int>(b), level[b]);
  });
  return joined(each);
}

ModelPlan Views::plan(std::size_t copy_set, int model, const std::vector<Surfel>& surfels) const {
  const CopySet& sown = scene_.copy_sets[copy_set];
  ModelBlocks blocks = blocks_of(surfels);
  ModelPlan result;
  result.drawn.resize(stretches_);
  std::set<std::pair<int, int>> used;
  for (std::size_t last = 0; last < eyes_.size(); ++last) {
    std::vector<Drawn> some = drawn(last, sown, model, blocks);
    for (const Drawn& one : some) used.insert({one.level, one.block});
    for (std::size_t k = last + 1 - std::min(last + 1, groups_); k <= last && k < stretches_; ++k)
      result.drawn[k].insert(result.drawn[k].end(), some.begin(), some.end());
  }
  // Where near copies ask for its blocks and far ones for all of it, it is read but once.
  bool joined = blocks.count() > 1 && used.contains({kWholeFrom, ModelFile::kWhole});
  for (int b = 0; joined && b < blocks.count(); ++b) used.insert({kWholeFrom, b});
  for (auto [level, block] : used) {
    std::string name = model_file_name(sown.organism, model, level, block,
                                       copy_seasons(sown.organism, scene_.film).has_value());
    int from = joined && level == kWholeFrom && block == ModelFile::kWhole ? blocks.count() : 0;
    result.files.push_back({copy_set, model, level, block, from, std::move(name), {}});
  }
  return result;
}

CopyPlan Views::empty_plan() const {
  CopyPlan plan;
  plan.stretch = stretch_;
  plan.drawn.assign(stretches_, std::vector<std::vector<Drawn>>(scene_.copy_sets.size()));
  plan.surfels.resize(scene_.copy_sets.size());
  return plan;
}

void Views::add(CopyPlan& plan, std::size_t copy_set, const ModelPlan& model) {
  for (std::size_t k = 0; k < plan.drawn.size(); ++k) {
    std::vector<Drawn>& all = plan.drawn[k][copy_set];
    all.insert(all.end(), model.drawn[k].begin(), model.drawn[k].end());
  }
  plan.files.insert(plan.files.end(), model.files.begin(), model.files.end());
}

}  // namespace frond
