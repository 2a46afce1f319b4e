#include <algorithm>
#include <cmath>
#include <string_view>

#include "cpfg/turtle.h"

// How the turtle's heading, left and up are set, carried without twist, bent, and told to a model that asks.

namespace frond::cpfg {

namespace {

/// The angle that cpfg turns by about an axis of a length, which it means to hold to 1.
double held_angle(double length) { return length <= 1 ? length : 2 * std::atan(std::tan(0.5) * length); }

/// Whether the module at a place answers a `?` before it.
bool is_query(const CpfgWord& word, std::size_t at) {
  const CpfgModule& module = word.modules[at];
  bool asked = at > 0 && word.modules[at - 1].symbol == '?' && word.modules[at - 1].count == 0;
  return asked && module.count > 0 && std::string_view("PHLUQ").find(module.symbol) != std::string_view::npos;
}

/// The rotation from the axes to the turtle's heading, left and up as a quaternion, its real part last.
std::vector<double> quaternion(const CpfgTurtleState& s) {
  constexpr double kNone = 1e-10;
  double real = 0.25 * (1 + s.heading.x + s.left.y + s.up.z);
  if (real > kNone) {
    double w = std::sqrt(real);
    return {(s.left.z - s.up.y) / (4 * w), (s.up.x - s.heading.z) / (4 * w),
            (s.heading.y - s.left.x) / (4 * w), w};
  }
  if (double square = -0.5 * (s.left.y + s.up.z); square > kNone) {
    double x = std::sqrt(square);
    return {x, s.heading.y / (2 * x), s.heading.z / (2 * x), 0};
  }
  if (double square = 0.5 * (1 - s.up.z); square > kNone) {
    double y = std::sqrt(square);
    return {0, y, s.left.z / (2 * y), 0};
  }
  return {0, 0, 1, 0};
}

std::vector<double> answer(char symbol, const CpfgTurtleState& state) {
  if (symbol == 'Q') return quaternion(state);
  DVec3 v = symbol == 'P'   ? state.position
            : symbol == 'H' ? state.heading
            : symbol == 'L' ? state.left
                            : state.up;
  return {v.x, v.y, v.z};
}

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

bool has_queries(const CpfgWord& word) {
  for (std::size_t i = 1; i < word.modules.size(); ++i)
    if (is_query(word, i)) return true;
  return false;
}

void answer_queries(const TurtleSettings& settings, const CpfgDrawing& drawing, CpfgWord& word) {
  CpfgTurtle turtle(settings, drawing);
  const std::vector<CpfgModule>& modules = drawing.word.modules;
  for (std::size_t at = 0; at < modules.size();) {
    if (!is_query(drawing.word, at)) {
      at = turtle.step(at);
      continue;
    }
    const CpfgModule& query = word.modules[static_cast<std::size_t>(drawing.origin[at])];
    std::vector<double> v = answer(query.symbol, turtle.state);
    bool same = query.symbol == modules[at].symbol && query.count == modules[at].count;
    for (std::size_t i = 0; same && i < std::min<std::size_t>(query.count, v.size()); ++i)
      word.parameters[query.first + i] = static_cast<float>(v[i]);
    ++at;
  }
}

}  // namespace frond::cpfg
