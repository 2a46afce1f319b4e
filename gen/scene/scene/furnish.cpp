#include "scene/furnish.h"

#include <fmt/format.h>

#include <algorithm>

#include "organisms/grammar_faults.h"
#include "plan/layout.h"
#include "scene/entry_seeds.h"
#include "settings/garden.h"

namespace frond {

namespace {

constexpr int kMostFruitless = 300;  // darts in a row, before a room is full

/// A point of a site as its own axes have it.
Vec2 point_in(const PlanSite& site, Vec2 own) {
  auto c = static_cast<float>(std::cos(site.turn)), s = static_cast<float>(std::sin(site.turn));
  return site.at + Vec2(c * own.x + s * own.y, c * own.y - s * own.x);
}

/// Errors whose pointers are below another one.
Errors below(const std::string& pointer, Errors errors) {
  for (Error& error : errors)
    if (error.where.empty() || error.where.starts_with('/')) error.where.insert(0, pointer);
  return errors;
}

/// Ways and rooms as they cover the ground.
std::vector<GroundArea> areas_of(const PlanText& text, const GroundPlan& plan) {
  std::vector<GroundArea> areas;
  for (const PlanSite& way : way_sites(text, plan))
    areas.push_back({GroundArea::Kind::gravel, way.at, way.size});
  for (const PlanRoom& room : plan.rooms) {
    RoomGround ground = text.rooms[room.kind].ground;
    if (ground == RoomGround::lawn) continue;
    PlanSite site = room_site(text, room);
    if (room.facing % 2) std::swap(site.size.x, site.size.y);
    areas.push_back({ground == RoomGround::earth ? GroundArea::Kind::earth : GroundArea::Kind::gravel,
                     site.at, site.size});
  }
  return areas;
}

/// Metres that one of them keeps free round itself.
double kept_free(const Organism& organism) {
  return organism.sown ? organism.sown->where.radius : organism.place.spacing;
}

/// Places in sites: in each those that are given, and more at random that keep apart, `count` in all.
void place_in(Organism& organism, const std::vector<PlanSite>& sites, TakenSpots& taken, Seed seed) {
  std::vector<Vec2> given = std::exchange(organism.place.at, {});
  auto room = static_cast<float>(kept_free(organism));
  std::vector<Stance> each = std::exchange(organism.place.each, {});
  each.resize(given.size());
  auto place = [&](const PlanSite& site, Vec2 at, const Stance& own = {}) {
    organism.place.at.push_back(at);
    organism.place.each.push_back({site.turn + own.turn, own.size});
    taken.add({at, room});
  };
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const PlanSite& site = sites[i];
    for (std::size_t k = 0; k < given.size(); ++k) place(site, point_in(site, given[k]), each[k]);
    Vec2 half = glm::max(0.5f * site.size - room, Vec2(0));
    int left = organism.count - static_cast<int>(given.size()), fruitless = 0;
    for (std::uint64_t dart = 0; left > 0 && fruitless < kMostFruitless; ++dart) {
      Seed own = seed.child("room", i).child(dart);
      Vec2 at = point_in(site, half * Vec2(own.child(0).range(-1, 1), own.child(1).range(-1, 1)));
      bool free = taken.free(at, room);
      fruitless = free ? 0 : fruitless + 1;
      if (free) place(site, at), --left;
    }
  }
}

/// Places along lines: one that is built along all of them, or rows of many.
void place_along(Organism& organism, const std::vector<PlanSite>& lines, TakenSpots& taken) {
  Place& place = organism.place;
  double all = 0, room = kept_free(organism), step = std::max(2 * room, 0.05);
  for (const PlanSite& line : lines) all += static_cast<double>(line.size.x);
  place.at.clear(), place.each.clear();
  if (auto built = lines.empty() ? nullptr : organism.grower->as_long_as(all)) {
    organism.grower = std::move(built);
    for (const PlanSite& line : lines) place.lines.push_back({line.at, line.turn, line.size.x});
    place.at.emplace_back(0);
    place.turn = place.turn_variation = place.size_variation = place.lean = place.spacing = 0;
    return;
  }
  for (const PlanSite& line : lines) {
    auto length = static_cast<double>(line.size.x);
    int count = std::max(1, static_cast<int>(length / step));
    for (int i = 0; i < count; ++i) {
      place.at.push_back(point_in(line, Vec2(length * ((i + 0.5) / count - 0.5), 0)));
      place.each.push_back({line.turn});
      taken.add({place.at.back(), static_cast<float>(room)});
    }
  }
}

/// Why an organism cannot have the places that it asks for; empty where it can.
Error site_fault(const Preset& preset, std::size_t index) {
  const Place& place = preset.organisms[index].place;
  bool in = !place.in.empty();
  std::string where = fmt::format("/organisms/{}/place/{}", index, in ? "in" : "along");
  const std::string& name = in ? place.in : place.along;
  if (in && !place.along.empty()) return {where, "stands beside \"along\"; expected one of the two"};
  if (!preset.plan)
    return error_at(where, "no plan that has \"{}\"; expected a \"plan\" in the preset", name);
  if (in && preset.organisms[index].grower->traits().finds_own_place())
    return {where, "this kind finds its own place; expected another kind"};
  std::vector<std::string_view> names;
  for (const RoomKind& kind : preset.plan->rooms) names.push_back(kind.name);
  if (in)
    names.insert(names.end(), {kPlanGate, kPlanCorners, kPlanDoors});
  else
    names.push_back(kPlanWalls);
  if (std::ranges::find(names, name) != names.end()) return {};
  return {where, fmt::format("the plan has no \"{}\"", name) + expected_names(name, names)};
}

}  // namespace

Result<GroundPlan> plan_of(const PlanText& text) {
  Result<Grammar> grammar = compile_plan(text);
  if (!grammar) return below("/plan", pointed(text.grammar, grammar.errors()));
  Result<GroundPlan> plan = derive_plan(text, *grammar, Seed{text.grammar.seed});
  if (!plan) return below("/plan", pointed(text.grammar, plan.errors()));
  return plan;
}

Errors furnish(Preset& preset, double reach, Faults& warnings) {
  Errors errors;
  for (std::size_t i = 0; i < preset.organisms.size(); ++i)
    if (const Place& place = preset.organisms[i].place; !place.in.empty() || !place.along.empty())
      if (Error fault = site_fault(preset, i); !fault.what.empty()) errors.push_back(std::move(fault));
  if (!preset.plan) return errors;
  PlanText& text = *preset.plan;
  // Its first seed is that of the preset, so that each preset's seed gives a plan of its own.
  text.grammar.seed += preset.seed - 1;
  for (Error& fault : below("/plan", plan_faults(text, reach))) errors.push_back(std::move(fault));
  Result<GroundPlan> plan = plan_of(text);
  if (!plan)
    for (const Error& error : plan.errors()) errors.push_back(error);
  if (!errors.empty()) return errors;
  for (const Error& note : below("/plan", pointed(text.grammar, compile_plan(text)->warnings)))
    warnings.add({origin_at(*preset.written, note.where), note.where, note.what});
  std::ranges::move(areas_of(text, *plan), std::back_inserter(preset.setup.block<Garden>().areas));
  TakenSpots taken;
  std::vector<Seed> seeds = entry_seeds(preset, "plan");
  for (std::size_t i = 0; i < preset.organisms.size(); ++i) {
    Organism& organism = preset.organisms[i];
    const Place& place = organism.place;
    if (organism.count == 0 || (place.in.empty() && place.along.empty())) continue;
    if (!place.in.empty())
      place_in(organism, sites_in(text, *plan, place.in), taken, seeds[i]);
    else
      place_along(organism, sites_along(text, *plan, place.along), taken);
    organism.count = static_cast<int>(organism.place.at.size());
  }
  return {};
}

}  // namespace frond
