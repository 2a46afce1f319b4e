#pragma once

#include <optional>
#include <vector>

#include "appearance/appearance.h"
#include "appearance/coral_health.h"
#include "appearance/leaf_health.h"

// What changes the look of an individual over a film, whatever it is: its health, and colours by time.

namespace frond {

/// What an entry of a preset says of it.
struct Courses {
  std::optional<Health> health;
  std::optional<ColorCourse> tint;  ///< of all its colours
};

/// That of an individual.
struct Condition {
  Courses courses;
  Seed seed;
  double delay = 0;                            ///< seconds by which its health follows later
  std::vector<std::vector<DeadPatch>> turf{};  ///< of each shape of its solids, see turf_on()

  std::optional<Fare> fare(double time) const;
  ColorShift shift(double time) const { return courses.tint ? courses.tint->at(time) : ColorShift{}; }
};

/// That of an individual which wears a look; none where nothing changes it.
std::optional<Condition> condition_of(const Courses& courses, const Look& look, Seed seed);

/// A look with the pictures of all leaves that its health may turn.
Look ail_look(const Look& look, const Courses& courses);

/// Gives the leaves of a model that wears a look the colours of failing health.
void add_ailing(Model& model, const Look& worn, const Courses& courses);

/// Notes where turf spreads from on the bodies of a model.
void lay_turf(Condition& condition, const Solids& solids);

/// The look at a time, and the material of a shape of its solids. Pictures are what they were, see
/// ColorShift.
Look look_at(const Look& look, const Condition& condition, double time);
Material material_at(const Material& material, std::size_t shape, const Condition& condition, double time);

/// Changes a model that stands in its place to how it is at a time: leaves, flowers and bodies.
void put_in(Model& model, const Condition& condition, double time, const GroundAt& ground);

/// The same for the prototypes and bodies of models that are copied, whose leaves change all together and do
/// not fall.
void put_in_together(Model& model, const Condition& condition, double time);

}  // namespace frond
