#include "scene/far.h"

#include <algorithm>
#include <cmath>

#include "scene/camera.h"
#include "scene/copies.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr int kLooks = 200;        // of a film, at most
constexpr double kMargin = 0.06;   // radians beside what is in view
constexpr double kPixels = 8.3e6;  // of a picture, as in 3840x2160: a finer land would fill gigabytes

/// The shortest range of directions that holds all: the complement of the widest gap between them.
void set_range(FarView& view, std::vector<std::array<double, 2>> ranges) {
  std::ranges::sort(ranges);
  double end = ranges[0][1], gap = 0, first = ranges[0][0];
  for (const auto& [from, to] : ranges) {
    if (from - end > gap) gap = from - end, first = from;
    end = std::max(end, to);
  }
  double last_gap = ranges[0][0] + 2 * kPi - end;
  if (std::max(gap, last_gap) <= 0) return;  // all round
  if (last_gap >= gap) {
    view.from = ranges[0][0], view.to = end;
    return;
  }
  view.from = first, view.to = first + 2 * kPi - gap;
}

/// The stand of a sown organism of that name, a new one where none of it is sown near.
CopySet& copy_set_named(Scene& scene, const Preset& preset, const std::string& name) {
  auto set = std::ranges::find(scene.copy_sets, name, [](const CopySet& s) { return s.organism.name; });
  if (set != scene.copy_sets.end()) return *set;
  auto entry =
      std::ranges::find_if(preset.organisms, [&](const Organism& o) { return o.sown && o.name == name; });
  auto number = static_cast<std::size_t>(entry - preset.organisms.begin());
  return scene.copy_sets.emplace_back(CopySet{number, *entry, copy_appearance(*entry), {}, {}});
}

}  // namespace

FarView far_view(const Film& film, const Camera& camera) {
  FarView view;
  view.pixel = 1e9, view.eye = -1e9;
  double pixels = static_cast<double>(film.size[0]) * film.size[1];
  view.pixels = std::min(pixels, kPixels);
  double finer = std::sqrt(pixels / view.pixels);
  std::vector<std::array<double, 2>> ranges;
  for (int i = 0, looks = std::min(film.frames, kLooks); i < looks; ++i) {
    double time = film.time(1 + i * (film.frames - 1) / std::max(looks - 1, 1));
    Lens lens = lens_at(camera, time, film.aspect());
    view.pixel = std::min(view.pixel, 2.0 * lens.wide / film.size[0] * finer);
    view.eye = std::max<double>(view.eye, lens.at.y);
    view.aside = std::max<double>(view.aside, glm::length(Vec2(lens.at.x, lens.at.z)));
    // The corners of the picture reach farther round where the camera looks up or down.
    double level = std::hypot(lens.toward.x, lens.toward.z);
    constexpr double kOverPole = 0.1;  // below that its edge comes near the zenith or its opposite: all round
    double inner = level - std::abs(lens.toward.y) * lens.high;
    double half = kMargin + (inner > kOverPole ? std::atan(lens.wide / inner) : kPi);
    double middle = std::atan2(double{lens.toward.z}, double{lens.toward.x});
    if (half >= kPi) middle = 0, half = kPi;
    // Within one turn from 0.
    double from = middle - half;
    from -= 2 * kPi * std::floor(from / (2 * kPi));
    ranges.push_back({from, from + 2 * half});
  }
  set_range(view, std::move(ranges));
  return view;
}

std::optional<DistantTerrain> far_land_round(const Scene& scene, Seed seed) {
  GroundEdge edge = scene.ground->edge();
  if (edge.radius <= 0 || (!scene.setup.far && !edge.country)) return std::nullopt;
  FarLandShape shape = scene.setup.far.value_or(FarLandShape{});
  if (shape.reach <= edge.radius) return std::nullopt;
  shape.shaded = shaded_side(scene.setup);
  return distant_terrain(shape, edge, far_view(scene.film, scene.setup.camera), seed);
}

void plant_far_trees(Scene& scene, const Preset& preset, DistantTerrain& far, Seed seed) {
  if (!scene.setup.far || scene.setup.far->trees.empty()) return;
  const std::vector<std::string>& names = scene.setup.far->trees;
  auto is_tree = [](const FarObject& o) {
    return o.kind == FarKind::broadleaf || o.kind == FarKind::conifer;
  };
  for (std::size_t i = 0; i < far.objects.size(); ++i) {
    const FarObject& tree = far.objects[i];
    if (!is_tree(tree)) continue;
    Seed own = seed.child("tree", i);
    bool first = tree.kind == FarKind::conifer || names.size() == 1;
    CopySet& set =
        copy_set_named(scene, preset, names[first ? 0 : 1 + own.child("kind").bits() % (names.size() - 1)]);
    auto models = static_cast<std::uint64_t>(set.organism.sown->models);
    Copies& copies = set.copies;
    copies.model.push_back(static_cast<std::uint16_t>(own.child("model").bits() % models));
    copies.foot.push_back(tree.foot);
    copies.turn.push_back(glm::angleAxis(tree.turn, Vec3(0, 1, 0)));
    copies.scale.push_back(static_cast<float>(own.child("size").range(0.7, 1.1)));
    copies.tint.push_back(static_cast<std::uint8_t>(own.child("tint").bits() % kTints));
  }
  std::erase_if(far.objects, is_tree);
  far.shapes[static_cast<std::size_t>(FarKind::broadleaf)].clear();
  far.shapes[static_cast<std::size_t>(FarKind::conifer)].clear();
}

std::vector<ScatteredInstances> strewn_far(const DistantTerrain& far) {
  // In the order of FarCover, and of FarKind.
  constexpr std::array<Color, kFarCovers> kColors{{{0.39f, 0.46f, 0.17f},
                                                   {0.50f, 0.52f, 0.26f},
                                                   {0.36f, 0.43f, 0.18f},
                                                   {0.73f, 0.63f, 0.38f},
                                                   {0.56f, 0.58f, 0.30f},
                                                   {0.80f, 0.74f, 0.20f},
                                                   {0.45f, 0.36f, 0.28f},
                                                   {0.22f, 0.29f, 0.12f},
                                                   {0.54f, 0.53f, 0.50f}}};
  constexpr std::array<Color, kFarKinds> kKinds{
      {{0.26f, 0.34f, 0.13f}, {0.17f, 0.24f, 0.12f}, {0.25f, 0.33f, 0.13f}, {0.75f, 0.68f, 0.60f}}};
  std::vector<ScatteredInstances> list;
  for (const FarPart& part : far.parts)
    list.push_back({&part.surface, kColors[static_cast<std::size_t>(part.cover)], {{}}});
  for (std::size_t kind = 0; kind < kFarKinds; ++kind)
    for (std::size_t shape = 0; shape < far.shapes[kind].size(); ++shape) {
      ScatteredInstances copies{&far.shapes[kind][shape], kKinds[kind], {}};
      for (const FarObject& o : far.objects)
        if (o.kind == static_cast<FarKind>(kind) && o.shape == static_cast<int>(shape))
          copies.at.push_back({o.foot, glm::angleAxis(o.turn, Vec3(0, 1, 0)), o.size});
      list.push_back(std::move(copies));
    }
  return list;
}

}  // namespace frond
