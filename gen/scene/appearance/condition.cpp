#include "appearance/condition.h"

#include "appearance/skin_colors.h"

namespace frond {

namespace {

bool ails(const Courses& courses) { return courses.health && !courses.health->plain(); }
bool tints(const Courses& courses) { return courses.tint && !courses.tint->plain(); }

void shift_all(std::vector<Color>& colors, const ColorShift& by) {
  for (Color& color : colors) color = shifted(color, by);
}

void shift_all(Prototype& organ, const ColorShift& by) {
  shift_all(organ.colors, by);
  organ.second = shifted(organ.second, by);
  if (organ.bud) organ.bud = shifted(*organ.bud, by);
}

/// All but the organs. Pictures and the colours that stand for them stay: a filter lies over those.
void color_in(Model& model, const Condition& condition, double time, bool together) {
  const std::optional<Fare> fare = condition.fare(time);
  const ColorShift by = condition.shift(time);
  for (Prototype& organ : model.prototypes) {
    if (fare) fade(organ, *condition.courses.health, *fare, together);
    const bool pictured = !organ.parts.empty() && !organ.parts[0].pictures.empty();
    if (!by.plain() && !pictured) shift_all(organ, by);
  }
  for (std::size_t k = 0; k < model.solids.shapes.size(); ++k) {
    Material& material = model.solids.shapes[k].material;
    material = material_at(material, k, condition, time);
  }
}

}  // namespace

std::optional<Fare> Condition::fare(double time) const {
  if (!ails(courses)) return std::nullopt;
  return fare_at(*courses.health, time, delay);
}

std::optional<Condition> condition_of(const Courses& courses, const Look& look, Seed seed) {
  const bool tinted = look.branches.skin && !look.branches.skin->tint.course.constant();
  if (!ails(courses) && !tints(courses) && !tinted) return std::nullopt;
  Condition condition{courses, seed};
  if (courses.health) condition.delay = courses.health->stagger * seed.child("ails later").unit();
  return condition;
}

Look ail_look(const Look& look, const Courses& courses) {
  if (!ails(courses)) return look;
  Look ailing = look;
  if (ailing.leaves) ailing.leaves = ail_look(*ailing.leaves, *courses.health);
  for (LeafLook& organ : ailing.organs) organ = ail_look(organ, *courses.health);
  return ailing;
}

void add_ailing(Model& model, const Look& worn, const Courses& courses) {
  if (!ails(courses)) return;
  const Look ailing = ail_look(worn, courses);
  for (Prototype& organ : model.prototypes) {
    bool done = worn.leaves && ail_pictures(organ, *worn.leaves, *ailing.leaves);
    for (std::size_t k = 0; !done && k < worn.organs.size(); ++k)
      done = ail_pictures(organ, worn.organs[k], ailing.organs[k]);
    if (!done) add_ailing(organ, ailing_colors(*courses.health));
  }
}

void lay_turf(Condition& condition, const Solids& solids) {
  if (!ails(condition.courses)) return;
  condition.turf.clear();
  for (std::size_t k = 0; k < solids.shapes.size(); ++k) {
    const Solid& solid = solids.shapes[k];
    condition.turf.push_back(is_tissue(solid.material.matter)
                                 ? turf_on(solid.surface, condition.seed.child("on", k))
                                 : std::vector<DeadPatch>{});
  }
}

Look look_at(const Look& look, const Condition& condition, double time) {
  Look now = look;
  const std::optional<Fare> fare = condition.fare(time);
  const ColorShift by = condition.shift(time);
  BranchLook& branches = now.branches;
  if (branches.skin) {
    Skin& skin = *branches.skin;
    if (!skin.tint.course.constant()) skin = skin_at(skin, time);
    if (!by.plain()) {
      skin.tint.base = shifted(skin.tint.base, by), skin.tint.secondary = shifted(skin.tint.secondary, by);
    }
    if (fare) skin = skin_in(skin, bleached_at(*condition.courses.health, *fare));
  }
  auto wear = [&](Bark& bark) {
    if (fare) bark = bark_in(bark, *fare);
    if (by.plain()) return;
    shift_all(bark.colors, by);
    bark.second = shifted(bark.second, by), bark.young = shifted(bark.young, by);
  };
  if (branches.bark) wear(*branches.bark);
  for (OtherBark& other : branches.others) wear(other.bark);
  if (fare) now.blades.colors = blades_in(now.blades.colors, *condition.courses.health, *fare);
  shift_all(now.blades.colors, by);
  now.blades.second = shifted(now.blades.second, by);
  return now;
}

Material material_at(const Material& material, std::size_t shape, const Condition& condition, double time) {
  Material now = material;
  const ColorShift by = condition.shift(time);
  if (!by.plain()) now.color = shifted(now.color, by), now.second = shifted(now.second, by);
  const std::optional<Fare> fare = condition.fare(time);
  if (!fare || !is_tissue(material.matter)) return now;
  const Bleached bleached = bleached_at(*condition.courses.health, *fare);
  now = material_in(now, bleached);
  if (bleached.dead > 0 && shape < condition.turf.size())
    now.dead = turf_at(material.dead, condition.turf[shape], bleached.dead);
  return now;
}

void put_in(Model& model, const Condition& condition, double time, const GroundAt& ground) {
  // The organs first, as their prototypes still have the colours of all.
  if (const std::optional<Fare> fare = condition.fare(time))
    ail(model.organs, model.prototypes, *condition.courses.health, *fare, condition.seed, ground);
  color_in(model, condition, time, false);
}

void put_in_together(Model& model, const Condition& condition, double time) {
  color_in(model, condition, time, true);
}

}  // namespace frond
