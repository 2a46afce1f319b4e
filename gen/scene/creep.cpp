#include "scene/creep.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/parallel.h"

namespace frond {

namespace {

/// What ivy grows on: all placed bodies of the organisms that it names, or of all.
Surface support(const Scene& scene, const IvyParams& ivy) {
  Surface all;
  for (const Branches& body : scene.branches) {
    if (!ivy.on.empty() && std::find(ivy.on.begin(), ivy.on.end(), body.name) == ivy.on.end()) continue;
    Surface own = skin_of(body);
    auto offset = static_cast<std::uint32_t>(all.position.size());
    all.position.insert(all.position.end(), own.position.begin(), own.position.end());
    all.normal.insert(all.normal.end(), own.normal.begin(), own.normal.end());
    for (auto [p, q, r] : own.triangle) all.triangle.push_back({p + offset, q + offset, r + offset});
  }
  return all;
}

/// The ivy of one entry.
Result<Branches> ivy_of(const Preset& preset, const Scene& scene, std::size_t entry, const Heights& heights) {
  const Organism& organism = preset.organisms[entry];
  const IvyParams& params = std::get<IvyParams>(organism.body);
  Seed seed = Seed{preset.seed}.child("organism", entry);
  bool level = preset.stage.setting == Setting::studio;  // its floor is one with the wall
  auto ground = [&](double x, double z) { return level ? 0.0 : heights(x, z); };
  IvyRoots roots;
  for (Vec2 at : organism.place.at) roots.emplace_back(at.x, ground(at.x, at.y) + organism.place.raise, at.y);
  Result<Ivy> ivy =
      grow_ivy(params, support(scene, params), roots, organism.count, ground, seed.child("grow"));
  if (!ivy) {
    Errors errors = ivy.errors();
    for (Error& error : errors)
      error.where = organism.name.empty() ? fmt::format("organism {}", entry) : organism.name;
    return errors;
  }
  Branches branches;
  branches.name = organism.name;
  branches.entry = entry;
  branches.rest = std::move(ivy->model.skeleton);
  branches.color = std::move(ivy->model.color);
  branches.prototypes = std::move(ivy->model.prototypes);
  branches.organs = std::move(ivy->model.organs);
  branches.bark = params.bark;
  branches.brightness = 1 + params.bark.variation * seed.child("brightness").range(-1, 1);
  branches.motion = {params.growth,       {}, {}, preset.film.length(), false, params.flutter,
                     params.leaves.unfold};
  branches.creeper = Creeper{std::move(ivy->strands), params.breeze};
  branches.creeper->breeze.film_length = preset.film.length();
  return branches;
}

}  // namespace

Errors creep(const Preset& preset, Scene& scene, const Heights& heights) {
  std::vector<std::size_t> entries;
  for (std::size_t o = 0; o < preset.organisms.size(); ++o)
    if (preset.organisms[o].count > 0 && std::holds_alternative<IvyParams>(preset.organisms[o].body))
      entries.push_back(o);
  std::vector<std::optional<Result<Branches>>> grown(entries.size());
  parallel_for(entries.size(), [&](std::size_t i) { grown[i] = ivy_of(preset, scene, entries[i], heights); });
  for (auto& result : grown) {
    if (!*result) return result->errors();
    scene.branches.push_back(std::move(**result));
  }
  return {};
}

void pose_branches(const Branches& b, double time, Pose& pose) {
  bool swings =
      b.creeper && std::ranges::any_of(b.creeper->strands.hanging, [](auto held) { return held != 0; });
  if (!swings) return pose_skeleton(b.rest, b.motion, time, pose);
  // Ivy is revealed along strands that the wind has moved.
  std::vector<Quat> turn;
  Skeleton moved = b.rest;
  swing_strands(b.creeper->strands, b.creeper->breeze, time, moved.position, turn);
  pose_skeleton(moved, b.motion, time, pose);
  for (std::size_t i = 0; i < turn.size(); ++i) pose.turn[i] = pose.turn[i] * turn[i];
}

}  // namespace frond
