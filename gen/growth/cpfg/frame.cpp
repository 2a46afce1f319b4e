#include <cmath>

#include "cpfg/directions.h"
#include "cpfg/turtle.h"

// How the turtle's heading, left and up are set, carried without twist, and bent.

namespace frond::cpfg {

namespace {

/// The angle that cpfg turns by about an axis of a length, which it means to hold to 1.
double held_angle(double length) { return length <= 1 ? length : 2 * std::atan(std::tan(0.5) * length); }

}  // namespace

/// `@R`: without an up vector at right angles that of the last segment is carried along without twist.
void CpfgTurtle::aim(std::span<const float> values) {
  DVec3 heading = unit({values[0], values[1], values.size() > 2 ? values[2] : 0});
  state.heading = heading == DVec3{0, 0, 0} ? DVec3{0, 1, 0} : heading;
  DVec3 up = values.size() >= 6 ? DVec3{values[3], values[4], values[5]} : DVec3{0, 0, 0};
  if (values.size() >= 6) state.up = up;
  if (up == DVec3{0, 0, 0} || glm::dot(up, state.heading) != 0) return carry_frame();
  state.up = unit(up);
  state.left = glm::cross(state.heading, state.up);
}

/// Turns up and left so that there is no twist since the last segment.
void CpfgTurtle::carry_frame() {
  DVec3 axis = glm::cross(state.last_heading, state.heading);
  double sine = std::sqrt(glm::dot(axis, axis));
  if (sine > 1e-6)
    state.up =
        turned(state.last_up, axis / sine, std::atan2(sine, glm::dot(state.last_heading, state.heading)));
  state.left = glm::cross(state.heading, state.up);
}

/// The twist until here is wanted.
void CpfgTurtle::keep_frame() { state.last_heading = state.heading, state.last_up = state.up; }

/// `@v`: rolls until left is horizontal and up's opposite looks up.
void CpfgTurtle::level() {
  DVec3 left = unit(glm::cross(DVec3{0, 1, 0}, state.heading));
  if (left == DVec3{0, 0, 0}) return;
  state.left = left;
  state.up = glm::cross(left, state.heading);
}

/// The tropisms and torques of the view's newer lines.
void CpfgTurtle::bend_before() {
  if (settings_.tropisms.empty()) return;
  pull_heading();
  roll_up();
}

/// Tropisms turn the heading; up and left follow without twist since the last segment.
void CpfgTurtle::pull_heading() {
  DVec3 pull{0, 0, 0};
  for (std::size_t i = 0; i < settings_.tropisms.size(); ++i) {
    const CpfgTropism& tropism = settings_.tropisms[i];
    if (tropism.is_torque) continue;
    double angle = radians(tropism.angle);
    pull += tropism.direction * (std::cos(angle) * state.elasticities[i]);
    if (tropism.angle == 0) continue;
    // It aims beside its direction, on the heading's side of it.
    DVec3 across = glm::cross(state.heading, tropism.direction);
    double length = std::sqrt(glm::dot(across, across));
    if (length < 1e-7) across = state.left, length = 1;
    pull += glm::cross(tropism.direction, across) * (std::sin(angle) * state.elasticities[i] / length);
  }
  DVec3 axis = glm::cross(state.heading, pull);
  double length = std::sqrt(glm::dot(axis, axis));
  if (!(length >= 1e-6)) return;
  state.heading = turned(state.heading, axis / length, held_angle(length));
  carry_frame();
}

/// Torques turn up away from their direction: cpfg's up looks out of the underside of what it draws.
void CpfgTurtle::roll_up() {
  DVec3 roll{0, 0, 0};
  for (std::size_t i = 0; i < settings_.tropisms.size(); ++i)
    if (settings_.tropisms[i].is_torque) roll += settings_.tropisms[i].direction * state.elasticities[i];
  DVec3 across = glm::cross(state.heading, unit(roll));
  if (!(glm::dot(across, across) > 1e-8)) return;
  DVec3 toward = glm::cross(across, state.heading) * std::sqrt(glm::dot(roll, roll));
  DVec3 axis = glm::cross(state.up, toward);
  double length = std::sqrt(glm::dot(axis, axis));
  if (length >= 1e-7) {
    state.up = turned(state.up, axis / length, -held_angle(length));
    state.left = glm::cross(state.heading, state.up);
  }
  keep_frame();
}

}  // namespace frond::cpfg
