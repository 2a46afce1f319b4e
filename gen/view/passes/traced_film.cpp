#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <set>

#include "core/parallel.h"
#include "draw/copy_axes.h"
#include "draw/eyes.h"
#include "draw/focus.h"
#include "draw/food.h"
#include "passes/traced_frame.h"
#include "scene/far.h"
#include "settings/settings.h"

namespace frond {

namespace {

const OrganPlace kHere{Vec3(0), Quat(1, 0, 0, 0), Vec3(1)};

/// Whether a specimen is the same at all times.
bool stands_still(const Specimen& b) {
  const Motion& motion = b.motion;
  return !motion.sways() && motion.growth.duration <= 0 && !motion.food.pulls() &&
         motion.flutter.amplitude == 0 && !b.life.changes() && !b.life.hanging;
}

/// A ball of radius 1, as fine as a grain of a few pixels asks for.
Surface ball() {
  constexpr std::uint32_t kRound = 12, kHigh = 6;
  Surface made;
  for (std::uint32_t j = 0; j <= kHigh; ++j)
    for (std::uint32_t i = 0; i < kRound; ++i) {
      double turn = 2 * kPi * i / kRound, tilt = kPi * j / kHigh;
      made.position.emplace_back(std::sin(tilt) * std::cos(turn), std::cos(tilt),
                                 std::sin(tilt) * std::sin(turn));
      std::uint32_t here = j * kRound + i, beside = j * kRound + (i + 1) % kRound;
      if (j == kHigh) continue;
      if (j > 0) made.triangle.push_back({here, beside, here + kRound});
      if (j + 1 < kHigh) made.triangle.push_back({beside, beside + kRound, here + kRound});
    }
  made.normal = made.position;
  return made;
}

}  // namespace

struct TracedFilm::Parts {
  using Meshes = std::shared_ptr<const MeshGroup>;

  /// One file of a model, by copy set, model, level and block.
  using ModelKey = std::array<int, 4>;

  const Scene& scene;
  CopyPlan plan;
  std::vector<std::shared_ptr<const TwigPlan>> plans;  // of each specimen, as frames have them
  std::vector<std::size_t> moving;                     // specimens
  std::vector<DrawnSpecimen> still;                    // the others
  PlacedScene always;                                  // things that are the same at all times
  std::map<ModelKey, Meshes> models;
  Meshes grain = std::make_shared<const MeshGroup>(std::vector{ball()}, MeshGroup::Shadows::none);
  mutable std::mutex lock;
  mutable std::map<std::pair<std::size_t, std::size_t>, Meshes> shapes;  // of each specimen's organs

  Parts(const Scene& of, CopyPlan copies) : scene(of), plan(std::move(copies)) {}

  Errors prepare();

  /// The things of those specimens at a time, and what they refer to.
  Result<std::vector<Placed>> place(const std::vector<std::size_t>& specimens, double time,
                                    std::vector<DrawnSpecimen>& drawn) const;
  /// The copies at a time.
  std::vector<Placed> copies_at(double time) const;
  std::vector<Placed> food_at(double time) const;

 private:
  Meshes shape_of(std::size_t specimen, std::size_t number, const Prototype& prototype) const;
  Result<std::vector<Placed>> things_of(std::size_t specimen, const DrawList& list, bool changes) const;
  void add_twigs(std::uint32_t owner, const DrawnTwigs& twigs, bool changes,
                 std::vector<Placed>& things) const;
  void add_ground(std::vector<Placed>& things) const;
  Errors add_models();
};

std::shared_ptr<const MeshGroup> TracedFilm::Parts::shape_of(std::size_t specimen, std::size_t number,
                                                             const Prototype& prototype) const {
  Meshes kept;
  {
    std::lock_guard held(lock);
    kept = shapes[{specimen, number}];
  }
  bool same = kept && kept->size() == prototype.parts.size();
  for (std::size_t part = 0; same && part < prototype.parts.size(); ++part)
    same = kept->surface(part).position == prototype.parts[part].surface.position &&
           kept->surface(part).triangle == prototype.parts[part].surface.triangle;
  if (same) return kept;
  std::vector<Surface> surfaces;
  for (const OrganPart& part : prototype.parts) surfaces.push_back(part.surface);
  // Not under the lock: while Embree builds, this thread may take up another specimen, which asks here, too.
  kept = std::make_shared<const MeshGroup>(std::move(surfaces));
  std::lock_guard held(lock);
  return shapes[{specimen, number}] = kept;
}

Result<std::vector<Placed>> TracedFilm::Parts::things_of(std::size_t specimen, const DrawList& list,
                                                         bool changes) const {
  auto owner = static_cast<std::uint32_t>(specimen);
  std::vector<Placed> things;
  if (list.branches) {
    Result<BranchTubes> tubes = BranchTubes::of(*list.branches);
    if (!tubes) return tubes.errors();
    things.push_back(
        {{ThingKind::branches, owner, 0}, nullptr, std::make_shared<const BranchTubes>(std::move(*tubes))});
  }
  if (list.twigs) add_twigs(owner, *list.twigs, !stands_still(scene.specimens[specimen]), things);
  for (const OrganGroup& group : list.organs.groups) {
    auto shape = shape_of(specimen, group.prototype, list.model.prototypes[group.prototype]);
    std::span<const std::uint32_t> numbers = list.organs.organs(group);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      things.push_back(
          placed({ThingKind::organ, owner, numbers[k]}, shape, list.organs.places(group)[k], changes));
  }
  for (const DrawnBlades& blades : list.blades)
    things.push_back(placed(
        {ThingKind::blades, owner, static_cast<std::uint32_t>(blades.color * kLeafShades + blades.shade)},
        std::make_shared<const MeshGroup>(std::vector{&blades.surface}), kHere, true));
  for (const DrawnBody& body : list.bodies) {
    auto mesh = std::make_shared<const MeshGroup>(std::vector{&body.surface()});
    for (std::size_t k = 0; k < body.places.size(); ++k)
      things.push_back(placed({ThingKind::body, owner, static_cast<std::uint32_t>(body.shape << 16 | k)},
                              mesh, body.places[k], body.now.has_value() || changes));
  }
  return things;
}

/// The twigs of a palette: the wood of each counts as branches, its organs as one organ.
void TracedFilm::Parts::add_twigs(std::uint32_t owner, const DrawnTwigs& twigs, bool changes,
                                  std::vector<Placed>& things) const {
  std::vector<std::array<Meshes, 2>> meshes(twigs.shapes.size());
  parallel_for(meshes.size(), [&](std::size_t k) {
    std::array<std::vector<const Surface*>, 2> surfaces;  // wood, organs
    for (const TwigPart& part : twigs.shapes[k])
      surfaces[part.kind == CopyPart::Kind::wood ? 0 : 1].push_back(&part.surface);
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      if (!surfaces[s].empty()) meshes[k][s] = std::make_shared<const MeshGroup>(std::move(surfaces[s]));
  });
  for (std::size_t i = 0; i < twigs.places.size(); ++i) {
    const TwigPlan::Place& place = twigs.plan.places[i];
    const auto& [wood, organs] = meshes[place.kept];
    if (wood)
      things.push_back(placed({ThingKind::branches, owner, static_cast<std::uint32_t>(place.node)}, wood,
                              twigs.places[i], changes));
    if (organs)
      things.push_back(placed({ThingKind::organ, owner, place.organ}, organs, twigs.places[i], changes));
  }
}

void TracedFilm::Parts::add_ground(std::vector<Placed>& things) const {
  const Grounds& ground = *scene.ground;
  auto mesh_of = [](const Surface& surface, auto shadows) {
    return std::make_shared<const MeshGroup>(std::vector{&surface}, shadows);
  };
  using enum MeshGroup::Shadows;
  if (!ground.floor().triangle.empty())
    things.push_back(placed({ThingKind::floor}, mesh_of(ground.floor(), thrown), kHere));
  std::uint32_t number = 0;
  auto add = [&](const std::vector<ScatteredInstances>& list, bool far) {
    for (const ScatteredInstances& strewn : list) {
      auto mesh = mesh_of(*strewn.shape, far || strewn.water ? none : thrown);
      ThingKind kind = strewn.water ? ThingKind::water : ThingKind::stone;
      for (const ScatteredInstances::At& at : strewn.at)
        things.push_back(placed({kind, 0, number++}, mesh, {at.place, at.turn, at.size}));
    }
  };
  add(ground.strewn(), false);
  if (scene.far) add(strewn_far(*scene.far), true);
  std::uint32_t list = 0;
  for (const Patches& patches : ground.patches()) {
    std::vector<Meshes> meshes;
    for (const Surface* shape : patches.shapes) meshes.push_back(mesh_of(*shape, thrown));
    number = 0;
    for (const Patch& patch : *patches.at) {
      const Meshes& mesh = meshes[static_cast<std::size_t>(patch.shape)];
      if (mesh->surface(0).triangle.empty()) continue;
      things.push_back({{ThingKind::cover, list, number++}, mesh, nullptr, patch.axes(), patch.at});
    }
    ++list;
  }
}

/// The meshes of what is drawn of the models at each level.
Errors TracedFilm::Parts::add_models() {
  std::map<std::pair<int, int>, std::set<std::pair<int, int>>> wanted;  // levels and blocks of each model
  for (const auto& stretch : plan.drawn)
    for (std::size_t s = 0; s < stretch.size(); ++s)
      for (const Drawn& one : stretch[s])
        wanted[{static_cast<int>(s), scene.copy_sets[s].copies.model[one.copy]}].insert(
            {one.level, one.block});
  std::vector<std::pair<std::pair<int, int>, std::set<std::pair<int, int>>>> each(wanted.begin(),
                                                                                  wanted.end());
  std::vector<Errors> errors(each.size());
  parallel_for(each.size(), [&](std::size_t i) {
    auto [set, number] = each[i].first;
    const CopySet& of = scene.copy_sets[static_cast<std::size_t>(set)];
    Result<Model> model = grow_copy(of.organism, number);
    if (!model) return void(errors[i] = model.errors());
    ModelBlocks blocks =
        blocks_of(plan.surfels[static_cast<std::size_t>(set)][static_cast<std::size_t>(number)]);
    int made = -1;
    std::vector<CopyPart> parts;
    for (auto [level, block] : each[i].second) {
      if (made != level)
        parts = copy_parts(of.appearance.look, *model, kLevels[level], &blocks), made = level;
      std::vector<Surface> surfaces;
      for (const CopyPart& part : parts)
        surfaces.push_back(block == ModelFile::kWhole ? part.surface : in_block(part, block));
      auto meshes = std::make_shared<const MeshGroup>(std::move(surfaces));
      std::lock_guard held(lock);
      models[{set, number, level, block}] = std::move(meshes);
    }
  });
  for (Errors& list : errors)
    if (!list.empty()) return std::move(list);
  return {};
}

std::vector<Placed> TracedFilm::Parts::copies_at(double time) const {
  std::vector<Placed> things;
  if (plan.drawn.empty()) return things;
  int frame = std::clamp(static_cast<int>(std::lround(time * scene.film.fps)) + 1, 1, scene.film.frames);
  const auto& drawn = plan.drawn[plan.stretch_of(frame)];
  for (std::size_t s = 0; s < drawn.size(); ++s) {
    const Copies& copies = scene.copy_sets[s].copies;
    for (const Drawn& one : drawn[s]) {
      if (!copies.there(one.copy, time)) continue;
      Placed& thing = things.emplace_back();
      thing.thing = {ThingKind::copy, static_cast<std::uint32_t>(s), one.copy};
      thing.meshes = models.at({static_cast<int>(s), copies.model[one.copy], one.level, one.block});
      thing.axes = copy_axes(scene.copy_sets[s], scene.film, one.copy, time);
      Vec3 scale = copies.scale_at(one.copy, time);
      for (int axis = 0; axis < 3; ++axis) thing.axes[axis] *= scale[axis];
      thing.at = copies.foot[one.copy];
    }
  }
  return things;
}

std::vector<Placed> TracedFilm::Parts::food_at(double time) const {
  std::vector<Placed> things;
  for (const FoodGrain& one : drawn_food(scene, time))
    things.push_back(placed({ThingKind::food, 0, static_cast<std::uint32_t>(things.size())}, grain,
                            {one.at, Quat(1, 0, 0, 0), Vec3(one.radius)}));
  std::uint32_t list = 0;
  for (const ScatteredInstances& strewn : scene.ground->adrift(time, scene.film.length())) {
    auto mesh = std::make_shared<const MeshGroup>(std::vector{strewn.shape});
    ++list;
    for (std::uint32_t k = 0; k < strewn.at.size(); ++k)
      things.push_back(placed({ThingKind::food, list, k}, mesh,
                              {strewn.at[k].place, strewn.at[k].turn, strewn.at[k].size}));
  }
  return things;
}

Result<std::vector<Placed>> TracedFilm::Parts::place(const std::vector<std::size_t>& specimens, double time,
                                                     std::vector<DrawnSpecimen>& drawn) const {
  drawn.resize(specimens.size());
  std::vector<Result<std::vector<Placed>>> made(specimens.size(), std::vector<Placed>());
  parallel_for(specimens.size(), [&](std::size_t k) {
    const Specimen& specimen = scene.specimens[specimens[k]];
    auto now = developed(specimen, time);
    if (!now) return void(made[k] = now.errors());
    drawn[k].now = *now;
    drawn[k].list = std::make_unique<DrawList>(**now, time, (*now)->model.solids, plans[specimens[k]].get());
    made[k] = things_of(specimens[k], *drawn[k].list, specimen.life.develop != nullptr);
  });
  std::vector<Placed> things;
  for (Result<std::vector<Placed>>& some : made) {
    if (!some) return some.errors();
    std::ranges::move(*some, std::back_inserter(things));
  }
  return things;
}

Errors TracedFilm::Parts::prepare() {
  if (Errors errors = add_models(); !errors.empty()) return errors;
  plans = twig_plans(scene);
  std::vector<std::size_t> unmoved;
  for (std::size_t i = 0; i < scene.specimens.size(); ++i)
    (stands_still(scene.specimens[i]) ? unmoved : moving).push_back(i);
  Result<std::vector<Placed>> things = place(unmoved, 0, still);
  if (!things) return things.errors();
  add_ground(*things);
  always = PlacedScene(std::move(*things));
  return {};
}

TracedFilm::TracedFilm(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
TracedFilm::~TracedFilm() = default;
TracedFilm::TracedFilm(TracedFilm&&) noexcept = default;

Result<TracedFilm> TracedFilm::of(const Scene& scene, CopyPlan plan) {
  auto parts = std::make_unique<Parts>(scene, std::move(plan));
  if (Errors errors = parts->prepare(); !errors.empty()) return errors;
  return TracedFilm(std::move(parts));
}

Result<TracedFrame> TracedFilm::at(double time) const {
  const Scene& scene = parts_->scene;
  auto parts = std::make_unique<TracedFrame::Parts>();
  Result<std::vector<Placed>> moving = parts_->place(parts_->moving, time, parts->drawn);
  if (!moving) return moving.errors();
  std::ranges::move(parts_->copies_at(time), std::back_inserter(*moving));
  std::ranges::move(parts_->food_at(time), std::back_inserter(*moving));
  parts->moving = PlacedScene(std::move(*moving));
  parts->still = &parts_->always;
  Daylight light = drawn_daylight(setup_at(scene.setup, time));
  Eye eye = eye_at(scene, time);
  parts->light = light.sun;
  if (!light.lamps.empty()) {
    Vec3 target = scene.setup.camera.look_at.at(time);
    parts->is_lamp = true;
    parts->light = target + std::max(1.0f, glm::distance(eye.at, target)) * light.lamps.front().from;
  }
  TracedFrame frame(std::move(parts));
  frame.eye = eye;
  const Camera& camera = scene.setup.camera;
  if (camera.aperture) {
    Vec3 focus = named_focus(scene, time).value_or(focus_of(camera, time));
    frame.lens = static_cast<float>(lens_width(camera, time));
    frame.sharp = std::max(glm::dot(focus - eye.at, eye.ahead), 0.01f);
  }
  return frame;
}

}  // namespace frond
