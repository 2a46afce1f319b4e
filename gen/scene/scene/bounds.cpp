#include "scene/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/spline.h"
#include "organisms/kinds.h"
#include "settings/settings.h"

namespace frond {

namespace {

Extent extent_of(const Preset& preset) {
  return settings()[preset.setup.setting].answers.extent(preset.setup);
}

}  // namespace

Errors too_much_together(const Preset& preset) {
  Errors errors;
  std::vector<const Organism*> growing;
  for (const Organism& o : preset.organisms)
    if (!o.sown && o.count > 0) growing.push_back(&o);
  for (const std::vector<const Organism*>& kind : by_kind(growing, [](const Organism* o) { return o; }))
    if (auto faults_of = kind[0]->grower->traits().faults_together)
      for (Error& error : faults_of(kind, extent_of(preset).relief)) {
        error.where.insert(0, fmt::format("/organisms/{}", kind[0] - preset.organisms.data()));
        errors.push_back(std::move(error));
      }
  return errors;
}

double room_of(const Place& place, const Extent& extent) {
  return std::max(place.spacing, extent.rocks ? place.rock / 2 : 0.0);
}

double reach_of(const Preset& preset) {
  double reach = 0;
  for (const Organism& o : preset.organisms)
    if (!o.sown) reach = std::max(reach, reach_of(o));
  return std::max(reach, reach_of(preset.setup.camera));
}

double reach_of(const Camera& camera) {
  double reach = 0;
  // A curve stays within the polygon of its keys and their handles.
  for (const auto& key : camera.location.keys())
    for (Vec3 by : {Vec3(0), handle_of(key.in, key.out), handle_of(key.out, key.in)})
      reach = std::max<double>(reach, glm::length(Vec2(key.value.x + by.x, key.value.z + by.z)));
  return reach;
}

Errors without_room(const Preset& preset) {
  Errors list;
  Extent extent = extent_of(preset);
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    const Organism& o = preset.organisms[i];
    if (o.grower->traits().finds_own_place()) continue;
    // Discs of their room that do not overlap, on all the ground that they may reach.
    double room = 0, ground = 0;
    if (o.sown) {
      const SowRules& rules = o.sown->where;
      room = rules.radius * (1 - o.place.size_variation);
      ground = std::pow(extent.sown + 2 * room, 2);
      if (rules.reach > 0) ground = std::min(ground, kPi * std::pow(rules.reach + room, 2));
    } else {
      room = room_of(o.place, extent);
      ground = kPi * (std::pow(o.place.radius + room, 2) - std::pow(std::max(0.0, o.place.inner - room), 2));
    }
    double most = ground / (kPi * room * room);
    // Darts cover 0.547 of a large ring with discs of one size, whatever their number.
    if (!o.sown) most = std::min(most, 0.6 * most + 40);
    double more = o.count - static_cast<double>(o.place.at.size());
    if (room <= 0 || more <= most) continue;
    list.push_back(error_at(
        fmt::format("/organisms/{}/count", i),
        "{} have no room: each keeps {:.3g} m free round itself, so that {:.0f} at most could stand there; "
        "expected fewer, or {}",
        o.count, room, std::floor(most) + static_cast<double>(o.place.at.size()),
        o.sown ? "a smaller sown.where.radius" : "a larger place.radius or a smaller place.spacing"));
  }
  return list;
}

}  // namespace frond
