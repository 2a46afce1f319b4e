#include "film/soft_light.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "core/bounds.h"
#include "core/parallel.h"
#include "core/text.h"
#include "draw/ambience.h"
#include "draw/eyes.h"
#include "draw/surfel_sampler.h"
#include "scene/copies.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr double kPixels[] = {24, 18, 12};  // that a cell covers, of each Quality
constexpr std::size_t kEyes = 12;           // of a film that are heeded
constexpr float kFarthest = 3000;           // metres from the middle
constexpr double kReuse =
    1.45;  // cells within which POV-Ray uses a place's light again; its tree grows coarse from 1.5
// Cells across a surfel up to which the places that it is spread over, three along each side, are so
// close to each other that the light at them reaches all of it.
constexpr float kSpread = 4;
constexpr float kDiffuse = 0.75f;  // of its colour, about, that a surface throws back

/// Those of the film that are heeded.
std::vector<Eye> some_eyes(const Scene& scene) {
  std::vector<Eye> all = eyes(scene), some;
  for (std::size_t i = 0; i < std::min(all.size(), kEyes); ++i)
    some.push_back(all[i * (all.size() - 1) / std::max<std::size_t>(1, std::min(all.size(), kEyes) - 1)]);
  return some;
}

/// The room over the ground up to some metres.
Bounds room_over(const Grounds& ground, double tall) {
  Bounds room;
  for (const Vec3& at : ground.floor().position) room.extend(at, 0.2f);
  if (room.empty()) room = {Vec3(-1, 0, -1), Vec3(1, 0, 1)};
  room.high.y += static_cast<float>(tall);
  Vec3 far(kFarthest, 1e6f, kFarthest);
  return {glm::max(room.low, -far), glm::min(room.high, far)};
}

/// Side of the smallest cells within so many metres of a place, if that may be in view; else endless.
float seen_cell(const SoftLight& grid, std::span<const Eye> eyes, Vec3 at, float within) {
  float cell = grid.cell_at(at, within);
  bool seen = std::ranges::any_of(eyes, [&](const Eye& eye) { return in_view(eye, at, within + 3 * cell); });
  return seen ? cell : std::numeric_limits<float>::infinity();
}

using Specimens = std::vector<std::shared_ptr<const Specimen>>;

/// The room that a scene takes, metres.
Bounds room_of(const Scene& scene, const Specimens& now, const Surfels& surfels, double time) {
  Bounds room;
  for (const auto& b : now) {
    const Model& m = b->model;
    for (const Vec3& at : m.skeleton.position) room.extend(at, 0.1f);
    for (std::size_t i = 0; i < m.organs.size(); ++i)
      room.extend(m.organs.position[i],
                  std::max({m.organs.scale[i].x, m.organs.scale[i].y, m.organs.scale[i].z}));
    for (const Vec3& at : fallen_nodes(*b)) room.extend(at, 0.3f);
    room.extend(bounds_of(m.solids));
    for (const Vec3& at : m.blades.surface.position) room.extend(at);
  }
  for (std::size_t s = 0; s < scene.copy_sets.size(); ++s) {
    const Copies& copies = scene.copy_sets[s].copies;
    std::vector<float> reach;
    for (const auto& model : surfels[s]) {
      float far = 0;
      for (const Surfel& surfel : model) far = std::max(far, glm::length(surfel.at));
      reach.push_back(far);
    }
    for (std::size_t i = 0; i < copies.size(); ++i)
      if (copies.there(i, time)) {
        Vec3 scale = copies.scale_at(i, time);
        room.extend(copies.foot[i], std::max(scale.x, scale.y) * reach[copies.model[i]]);
      }
  }
  for (const Vec3& at : scene.ground->floor().position) room.extend(at, 0.2f);
  Vec3 far(kFarthest, 1e6f, kFarthest);
  return {glm::max(room.low, -far), glm::min(room.high, far)};
}

/// Lays bits into the grid; three of them across a cell.
struct IntoGrid {
  SoftLight& grid;

  void add(Vec3 at, float area, Vec3 albedo, Facing facing, float bulk) const {
    grid.add(at, area, kDiffuse * albedo, facing, bulk);
  }
  float step(Vec3 at) const { return 0.4f * grid.cell_at(at); }
};

/// Blades next to the camera that rise out of the height of what covers the ground, as where a patch lies
/// over a hollow: they hide little, but light is wanted at them.
void want_tips(SoftLight& grid, const Grounds& ground, std::span<const Eye> eyes) {
  constexpr float kRise = 0.25f;  // of the height, as far as which they are looked for
  constexpr auto reach = static_cast<float>(kReuse);
  auto cover = static_cast<float>(ground.low_cover().height);
  for (const Patches& patches : ground.patches()) {
    std::vector<float> wide;
    for (const Surface* shape : patches.shapes) wide.push_back(reach_of(shape->position));
    parallel_for(patches.at->size(), [&](std::size_t i) {
      const Patch& patch = (*patches.at)[i];
      float around = wide[static_cast<std::size_t>(patch.shape)];
      if (kRise * cover <= reach * seen_cell(grid, eyes, patch.at, around)) return;
      const Surface& shape = *patches.shapes[static_cast<std::size_t>(patch.shape)];
      glm::mat3 axes = patch.axes();
      for (const auto& of : shape.triangle) {
        std::array<Vec3, 3> corner;
        for (std::size_t c = 0; c < 3; ++c) corner[c] = patch.at + axes * shape.position[of[c]];
        float step = 0.5f * grid.cell_at(corner[0]);
        each_bit(corner, step, [&](Vec3 at, float, Facing) {
          float rise = at.y - ground.height({at.x, at.z}) - cover;
          if (rise > 2 * step * reach) grid.want(at, {.most = rise / reach});
        });
      }
    });
  }
}

void add_ground(SoftLight& grid, const Scene& scene, Vec3 albedo, std::span<const Eye> eyes) {
  const Grounds& ground = *scene.ground;
  LowCover cover = ground.low_cover();
  grid.add_land([&](Vec2 at) { return ground.height(at); }, albedo, static_cast<float>(cover.height),
                static_cast<float>(cover.area));
  SurfelSampler<IntoGrid>{IntoGrid{grid}}.strewn(ground.strewn());
  want_tips(grid, ground, eyes);
}

/// The directions that a surface faces when it is turned.
Facing turned(Facing facing_of, Quat turn) {
  if (facing_of == kAllFacings) return kAllFacings;
  Vec3 normal(0);
  for (int axis = 0; axis < 6; ++axis)
    if (facing_of & 1 << axis) normal[axis / 2] += axis % 2 == 0 ? 1.0f : -1.0f;
  return facing(turn * glm::normalize(normal));
}

void add_copies(SoftLight& grid, const Scene& scene, const Surfels& surfels, std::span<const Eye> eyes,
                double time) {
  for (std::size_t s = 0; s < scene.copy_sets.size(); ++s) {
    const Copies& copies = scene.copy_sets[s].copies;
    std::optional<Seasons> seasons = copy_seasons(scene.copy_sets[s].organism, scene.film);
    float leaves = seasons ? static_cast<float>(leaf_area_share(*seasons, seasons->at.at(time))) : 1;
    parallel_for(copies.size(), [&](std::size_t i) {
      if (!copies.there(i, time)) return;
      Vec3 each = copies.scale_at(i, time);
      Quat turn = copies.turn_at(i, time);
      auto add = [&](const Surfel& surfel, Facing facing, CellSizes cells) {
        grid.add(copies.foot[i] + turn * (each * surfel.at),
                 each.x * each.y * surfel.area * (surfel.bulk > 0 ? 1 : leaves), kDiffuse * surfel.albedo,
                 facing, each.x * surfel.bulk, each.x * surfel.wide, cells);
      };
      for (const Surfel& surfel : surfels[s][copies.model[i]]) {
        float wide = each.x * surfel.wide;
        Vec3 at = copies.foot[i] + turn * (each * surfel.at);
        if (surfel.finer.empty() || wide <= kSpread * seen_cell(grid, eyes, at, wide)) {
          add(surfel, kAllFacings, {});
          continue;
        }
        add(surfel, kAllFacings, {.least = wide / kSpread});
        for (const Surfel& finer : surfel.finer)
          add(finer, turned(finer.facing, turn), {.most = wide / kSpread});
      }
    });
  }
}

/// Whether a branch comes so many metres away from where it is in the first frame.
bool moves_by(const Specimen& specimen, const Film& film, double far) {
  constexpr int kMoments = 12;
  if (!specimen.motion.sways() && !specimen.motion.food.pulls()) return false;
  Pose first, now;
  pose_specimen(specimen, 0, first);
  for (int k = 1; k < kMoments; ++k) {
    pose_specimen(specimen, film.time(1 + k * (film.frames - 1) / (kMoments - 1)), now);
    for (std::size_t i = 0; i < now.position.size(); ++i)
      if (static_cast<double>(glm::distance(now.position[i], first.position[i])) > far) return true;
  }
  return false;
}

/// As POV-Ray packs a direction: three bytes in hexadecimal.
constexpr const char* kPacked[] = {"fe7f7f", "007f7f", "7ffe7f",
                                   "7f007f", "7f7f00", "7f7ffe"};  // z is mirrored

void append_probe(std::string& text, const PovSpace& space, const Probe& probe) {
  double unit = space.unit, reach = kReuse / kLightErrorBound * probe.cell * unit;
  text += "C1";
  for (double at : {probe.at.x * unit, probe.at.y * unit, -probe.at.z * unit})
    text += ' ', append(text, at, 3);
  text += ' ';
  text += kPacked[probe.axis];
  for (int c = 0; c < 3; ++c) text += ' ', append(text, probe.light[c], 3);
  for (int twice = 0; twice < 2; ++twice) text += ' ', append(text, reach, 4);
  text += ' ';
  text += kPacked[probe.axis];
  text += '\n';
}

/// The light on the far land that is in view, which nothing there hides from the sky: a lattice of places
/// whose distances from each other grow with that from the middle. They lie behind the surfaces that they are
/// for.
std::vector<Probe> far_probes(const DistantTerrain& far, const Ambience& ambience,
                              const std::vector<Eye>& eyes) {
  constexpr double kStep = 0.2;   // of the distance, from one to the next
  constexpr float kCell = 0.2f;   // of the distance; what is nearer than kReuse of these takes the light
  constexpr double kFrom = 1.25;  // of the radius of the near ground, which has light of its own
  constexpr float kBehind = 0.06f, kAbove = 0.12f;  // of the distance
  Vec3 sky = 0.5f * (ambience.zenith + ambience.horizon), aside = 0.5f * (sky + ambience.below);
  std::set<std::pair<int, int>> taken;
  std::vector<Probe> probes;
  for (const FarPart& part : far.parts)
    for (const Vec3& at : part.surface.position) {
      double away = std::hypot(double{at.x}, double{at.z});
      auto near = static_cast<float>(kStep * away);
      auto seen = [&](const Eye& eye) { return in_view(eye, at, 2 * near); };
      if (away < kFrom * far.from || std::ranges::none_of(eyes, seen)) continue;
      std::pair cell(static_cast<int>(std::log(away) / kStep),
                     static_cast<int>(std::atan2(double{at.z}, double{at.x}) / kStep + 100));
      if (!taken.insert(cell).second) continue;
      auto distance = static_cast<float>(away);
      for (int axis = 0; axis < 6; ++axis) {
        Vec3 out(0);
        out[axis / 2] = axis % 2 ? -1.0f : 1.0f;
        float behind = axis == 3 ? kAbove : kBehind;
        Vec3 light = axis == 2 ? sky : axis == 3 ? ambience.below : aside;
        probes.push_back({at - behind * distance * out, axis, kCell * distance, light});
      }
    }
  return probes;
}

}  // namespace

SoftLight::Size estimate_light(const Scene& scene, double tall) {
  std::vector<Eye> some = some_eyes(scene);
  return SoftLight::estimate_size(
      some, room_over(*scene.ground, tall), kPixels[static_cast<std::size_t>(scene.film.quality)],
      1 / PovSpace{}.unit, [&](Vec2 at) { return scene.ground->height(at); },
      static_cast<float>(scene.ground->low_cover().height), some);
}

double light_reach(Quality quality, double pixel) {
  return kReuse * kPixels[static_cast<std::size_t>(quality)] * pixel;
}

std::vector<int> wanted_halvings(const Scene& scene, std::size_t copy_set, int model,
                                 const std::vector<Surfel>& surfels) {
  std::vector<int> halvings(surfels.size());
  if (surfels.empty() || !has_soft_light(scene.setup)) return halvings;
  const Copies& copies = scene.copy_sets[copy_set].copies;
  float reach = 0, side = surfels[0].wide;
  for (const Surfel& surfel : surfels) reach = std::max(reach, glm::length(surfel.at) + side);
  std::vector<Eye> some = some_eyes(scene);
  SoftLight grid =
      SoftLight::bare(some, room_over(*scene.ground, reach),
                      kPixels[static_cast<std::size_t>(scene.film.quality)], 1 / PovSpace{}.unit);
  for (std::size_t i = 0; i < copies.size(); ++i) {
    float wide = copies.scale[i] * side;
    auto coarse = [&](Vec3 at, float within) { return wide > kSpread * seen_cell(grid, some, at, within); };
    if (copies.model[i] != model || !coarse(copies.foot[i], copies.scale[i] * reach)) continue;
    for (std::size_t k = 0; k < surfels.size(); ++k) {
      Vec3 at = copies.foot[i] + copies.turn[i] * (copies.scale[i] * surfels[k].at);
      if (!coarse(at, wide)) continue;
      int times = static_cast<int>(std::ceil(std::log2(wide / grid.cell_at(at, wide))));
      halvings[k] = std::max(halvings[k], std::min(times, kMostHalvings));
    }
  }
  return halvings;
}

bool light_changes(const Scene& scene, std::span<const double> pixel) {
  if (scene.film.frames <= 1) return false;
  // Bodies that only pale stand in one light; leaves that hang and fall let more of it through.
  auto changes = [](const Specimen& s) {
    return s.life.reshapes() || (s.life.condition && s.model.organs.size() > 0) ||
           s.motion.growth.duration > 0;
  };
  auto turns = [&](const CopySet& s) {
    return !s.copies.span.empty() || copy_seasons(s.organism, scene.film);
  };
  if (sun_moves(scene.setup) || std::ranges::any_of(scene.specimens, changes) ||
      std::ranges::any_of(scene.copy_sets, turns))
    return true;
  std::atomic<bool> leaves = false;
  parallel_for(scene.specimens.size(), [&](std::size_t i) {
    double far = light_reach(scene.film.quality, pixel[i]);
    if (!leaves && moves_by(scene.specimens[i], scene.film, far)) leaves = true;
  });
  return leaves;
}

Result<std::string> soft_light_text(const PovSpace& space, const Scene& scene, const Surfels& surfels,
                                    double time, bool changes) {
  std::optional<Ambience> ambience = ambience_of(scene, time);
  if (!ambience) return std::string();
  Specimens now;
  for (const Specimen& specimen : scene.specimens) {
    auto one = developed(specimen, time);
    if (!one) return one.errors();
    now.push_back(*one);
  }
  std::vector<Eye> some = some_eyes(scene), here{eye_at(scene, time)};
  Bounds room = room_of(scene, now, surfels, time);
  if (!glm::all(glm::lessThan(room.low, room.high))) return std::string();  // there is nothing
  SoftLight grid(some, room, kPixels[static_cast<std::size_t>(scene.film.quality)], 1 / space.unit);
  for (const auto& specimen : now) sample_surfels(IntoGrid{grid}, DrawList(*specimen, time));
  add_copies(grid, scene, surfels, some, time);
  add_ground(grid, scene, ambience->ground, some);
  std::vector<Probe> probes = grid.probes(*ambience, changes ? here : some);
  if (scene.far)
    std::ranges::move(far_probes(*scene.far, *ambience, changes ? here : some), std::back_inserter(probes));
  std::vector<std::string> texts((probes.size() + 4095) / 4096);
  parallel_for(texts.size(), [&](std::size_t i) {
    for (std::size_t k = i * 4096; k < std::min(probes.size(), (i + 1) * 4096); ++k)
      append_probe(texts[i], space, probes[k]);
  });
  std::string text;
  for (const std::string& part : texts) text += part;
  return text;
}

}  // namespace frond
