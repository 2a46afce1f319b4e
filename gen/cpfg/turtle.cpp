#include "cpfg/turtle.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cpfg/shapes.h"

namespace frond::cpfg {

namespace {

constexpr double kThinnest = 1e-7;

DVec3 unit(DVec3 v) {
  double length = std::sqrt(glm::dot(v, v));
  return length > 0 && std::isfinite(length) ? v / length : DVec3{0, 0, 0};
}

/// Turns a vector about an axis of length 1, right-handed.
DVec3 turned(DVec3 v, DVec3 axis, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

/// Turns `a` toward `b`, which are at right angles.
void turn_in_plane(DVec3& a, DVec3& b, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  DVec3 before = a;
  a = a * c + b * s;
  b = b * c - before * s;
}

CpfgTropism read_tropism(std::string_view value, bool is_torque) {
  CpfgTropism tropism;
  tropism.is_torque = is_torque;
  auto after = [&](std::string_view label) {
    std::size_t at = value.find(label);
    if (at == value.npos) return std::vector<double>();
    std::string_view rest = value.substr(at + label.size());
    return numbers_in(rest.substr(0, rest.find(':')));
  };
  if (std::vector<double> t = after("T:"); t.size() >= 3) tropism.direction = {t[0], t[1], t[2]};
  for (auto [label, into] : {std::pair("A:", &tropism.angle), std::pair("I:", &tropism.intensity),
                             std::pair("E:", &tropism.elasticity), std::pair("S:", &tropism.step)})
    if (std::vector<double> numbers = after(label); !numbers.empty()) *into = numbers[0];
  return tropism;
}

int cut(double number) { return number == number ? static_cast<int>(std::clamp(number, -1e9, 1e9)) : 0; }

}  // namespace

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    double value = 0;
    auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    if (error == std::errc{} && std::isfinite(value)) numbers.push_back(value);
    at = error == std::errc{} ? static_cast<std::size_t>(end - text.data()) : at + 1;
  }
  return numbers;
}

TurtleSettings turtle_settings(const CpfgModel& model) {
  TurtleSettings settings;
  for (const auto& [symbol, surface] : model.shapes->surfaces) settings.surfaces[symbol] = surface.end;
  settings.colors = static_cast<int>(model.shapes->colors.size());
  for (const CpfgViewLine& line : model.view) {
    if (line.key == "tropism" || line.key == "torque")
      settings.tropisms.push_back(read_tropism(line.value, line.key == "torque"));
    if (line.key == "environment display") settings.answers_after = line.value == "before";
    if (line.key == "interpretation past %") settings.draws_past_cut = line.value != "off";
    std::vector<double> numbers = numbers_in(line.value);
    if (numbers.empty()) continue;
    for (auto [key, into] :
         {std::pair("angle increment", &settings.angle), std::pair("initial scale", &settings.scale),
          std::pair("scale multiplier", &settings.scale_multiplier),
          std::pair("initial line width", &settings.width),
          std::pair("line width increment", &settings.width_step),
          std::pair("initial elasticity", &settings.old_elasticity),
          std::pair("elasticity increment", &settings.elasticity_increment)})
      if (line.key == key) *into = numbers[0];
    if (line.key == "angle factor" && numbers[0] != 0) settings.angle = 360 / numbers[0];
    if (line.key == "initial color") settings.color = cut(numbers[0]);
    if (line.key == "color increment") settings.color_step = cut(numbers[0]);
    if (line.key == "tropism direction" && numbers.size() >= 3)
      settings.old_direction = unit({numbers[0], numbers[1], numbers[2]});
  }
  return settings;
}

CpfgTurtle::CpfgTurtle(const TurtleSettings& settings, const CpfgDrawing& drawing)
    : settings_(settings), drawing_(drawing) {
  state.scale = settings.scale;
  state.width = std::max(settings.width, kThinnest);
  state.color = state.back = color_of(settings.color);
  state.elasticity = settings.old_elasticity;
  for (const CpfgTropism& tropism : settings.tropisms) state.elasticities.push_back(tropism.elasticity);
  last_ = state;
}

std::span<const float> CpfgTurtle::parameters(std::size_t at) const {
  const CpfgModule& module = modules()[at];
  return std::span(drawing_.word.parameters).subspan(module.first, module.count);
}

int CpfgTurtle::color_of(double number) const {
  int rest = cut(number) % settings_.colors;
  return rest < 0 ? rest + settings_.colors : rest;
}

std::size_t CpfgTurtle::step(std::size_t at) {
  std::span<const float> values = parameters(at);
  switch (char symbol = modules()[at].symbol) {
    case 'F':
    case 'G':
    case 'f':
    case 'g':
      move(at, values.empty() ? 1 : values[0]);
      last_ = state;
      break;
    case '[':
      stack_.push_back(state);
      ++state.depth;
      break;
    case ']':
      if (!stack_.empty()) {
        state = std::move(stack_.back());
        stack_.pop_back();
      }
      break;
    case '%':
      if (!settings_.draws_past_cut) return branch_end(at + 1);
      break;
    case '~':
      if (at + 1 < modules().size()) place_surface(at + 1);
      return at + 2;
    case '@':
      return step_special(at + 1);
    default:
      if (!step_value(symbol, values))
        turn(symbol, radians(values.empty() ? settings_.angle : double{values[0]}));
  }
  return at + 1;
}

void CpfgTurtle::turn(char symbol, double angle) {
  switch (symbol) {
    case '+':
      return turn_in_plane(state.heading, state.left, angle);
    case '-':
      return turn_in_plane(state.heading, state.left, -angle);
    case '&':
      return turn_in_plane(state.heading, state.up, angle);
    case '^':
      return turn_in_plane(state.heading, state.up, -angle);
    case '/':
      return turn_in_plane(state.left, state.up, angle);
    case '\\':
      return turn_in_plane(state.left, state.up, -angle);
    case '|':
      return turn_in_plane(state.heading, state.left, kPi);
    default:
      return;
  }
}

/// Width, colour and elasticity; false where the symbol sets none of them.
bool CpfgTurtle::step_value(char symbol, std::span<const float> values) {
  bool bare = values.empty();
  switch (symbol) {
    case '!':
    case '#': {
      double step = symbol == '!' ? -settings_.width_step : settings_.width_step;
      double width = bare ? state.width + step : double{values[0]};
      state.width = width > kThinnest ? width : kThinnest;
      return true;
    }
    case ';':
    case ',': {
      int step = symbol == ';' ? settings_.color_step : -settings_.color_step;
      state.color = color_of(bare ? state.color + step : double{values[0]});
      return true;
    }
    case '_':
      state.elasticity = bare ? state.elasticity + settings_.elasticity_increment : values[0];
      return true;
    default:
      return false;
  }
}

/// What follows `@`.
std::size_t CpfgTurtle::step_special(std::size_t at) {
  if (at >= modules().size()) return at;
  std::span<const float> values = parameters(at);
  auto vector = [&](std::size_t from) { return DVec3{values[from], values[from + 1], values[from + 2]}; };
  switch (symbol(at)) {
    case 'M':
      if (values.size() >= 2) state.position = {values[0], values[1], values.size() > 2 ? values[2] : 0};
      break;
    case 'R':
      if (values.size() >= 3) aim(vector(0), values.size() >= 6 ? vector(3) : DVec3{0, 0, 0});
      break;
    case 'v':
      level();
      break;
    case '#':
      state.contour = values.empty() ? 0 : cut(values[0]);
      break;
    case '!':
      if (!values.empty()) state.sides = std::clamp(cut(values[0]), 3, 1000);
      break;
    case ';':
    case ',': {
      int step = symbol(at) == ';' ? settings_.color_step : -settings_.color_step;
      state.back = color_of(values.empty() ? state.back + step : double{values[0]});
      break;
    }
    default:
      return step_pair(at);
  }
  return at + 1;
}

/// What has two letters after its `@`.
std::size_t CpfgTurtle::step_pair(std::size_t at) {
  std::span<const float> own = parameters(at);
  char first = symbol(at), second = own.empty() ? symbol(at + 1) : '\0';
  std::span<const float> values = second ? parameters(at + 1) : own;
  if (first == 'D' && (second == 'i' || second == 'd')) {
    double factor = values.empty() ? settings_.scale_multiplier : double{values[0]};
    if (factor != 0) state.scale *= second == 'i' ? factor : 1 / factor;
    return at + 2;
  }
  if (first == 'D' && !own.empty()) state.scale = own[0];
  if (std::string_view("TGbmP").find(first) == std::string_view::npos || !second) return at + 1;
  if (first == 'T') set_elasticity(second, values);
  if (first == 'T' && second == 'x' && !values.empty()) state.texture = cut(values[0]);
  if (first == 'G' && second == 't' && values.size() >= 2)
    state.arriving = values[0], state.leaving = values[1];
  if (first == 'G' && second == 'r') set_rises(values);
  if (first == 'm' && second == 'c' && !values.empty() && values[0] == 1) return branch_end(at + 2);
  return at + 2;
}

/// The `]` of the branch that a place lies in, or the end.
std::size_t CpfgTurtle::branch_end(std::size_t at) const {
  for (int depth = 0; at < modules().size(); ++at) {
    depth += (symbol(at) == '[') - (symbol(at) == ']');
    if (depth < 0) break;
  }
  return at;
}

void CpfgTurtle::set_elasticity(char how, std::span<const float> values) {
  double number = values.empty() ? 1 : values[0];
  if (!(number >= 1 && number <= static_cast<double>(state.elasticities.size()))) return;
  auto index = static_cast<std::size_t>(number) - 1;
  double& elasticity = state.elasticities[index];
  double step = values.size() > 1 ? values[1] : settings_.tropisms[index].step;
  if (how == 's' && values.size() > 1) elasticity = values[1];
  if (how == 'i') elasticity += step;
  if (how == 'd') elasticity -= step;
}

/// `@Gr`: angle and length for both sides of a place, or for each.
void CpfgTurtle::set_rises(std::span<const float> values) {
  if (values.size() == 1) state.rises_by_length = values[0] != 0;
  if (values.size() < 2) return;
  auto rise = [&](std::size_t from) {
    return std::tan(radians(std::clamp(double{values[from]}, -89.0, 89.0))) * values[from + 1];
  };
  state.rise_arriving = rise(0);
  state.rise_leaving = rise(values.size() >= 4 ? 2 : 0);
}

/// `@R`: without an up vector that of the last segment is carried along without twist.
void CpfgTurtle::aim(DVec3 heading, DVec3 up) {
  heading = unit(heading);
  if (heading == DVec3{0, 0, 0}) return;
  if (std::abs(glm::dot(unit(up), heading)) > 1e-3 || unit(up) == DVec3{0, 0, 0}) {
    DVec3 axis = glm::cross(last_.heading, heading);
    double sine = std::sqrt(glm::dot(axis, axis)), cosine = glm::dot(last_.heading, heading);
    up = sine > 1e-9 ? turned(last_.up, axis / sine, std::atan2(sine, cosine)) : last_.up;
  }
  state.heading = heading;
  state.left = unit(glm::cross(heading, up));
  state.up = glm::cross(state.left, heading);
}

/// `@v`: rolls until left is horizontal and up's opposite looks up.
void CpfgTurtle::level() {
  DVec3 left = unit(glm::cross(DVec3{0, 1, 0}, state.heading));
  if (left == DVec3{0, 0, 0}) return;
  state.left = left;
  state.up = glm::cross(left, state.heading);
}

/// `~x`: goes on at the surface's end.
void CpfgTurtle::place_surface(std::size_t at) {
  auto found = settings_.surfaces.find(symbol(at));
  if (found == settings_.surfaces.end()) return;
  std::span<const float> values = parameters(at);
  DVec3 end = found->second * ((values.empty() ? 1 : values[0]) * scale(at));
  state.position += state.left * end.x + state.heading * end.y + state.up * end.z;
}

void CpfgTurtle::move(std::size_t at, double length) {
  bend_before();
  state.position += state.heading * (length * scale(at));
  if (state.elasticity == 0 || settings_.old_direction == DVec3{0, 0, 0}) return;
  auto bend = [&](DVec3& from, DVec3& toward) {
    double sine = std::clamp(state.elasticity * glm::dot(settings_.old_direction, toward), -1.0, 1.0);
    turn_in_plane(from, toward, std::asin(sine));
  };
  bend(state.heading, state.up);
  bend(state.heading, state.left);
}

/// The tropisms and torques of the view's newer lines.
void CpfgTurtle::bend_before() {
  DVec3 pull{0, 0, 0}, roll{0, 0, 0};
  for (std::size_t i = 0; i < settings_.tropisms.size(); ++i) {
    const CpfgTropism& tropism = settings_.tropisms[i];
    DVec3 toward = unit(tropism.direction);
    if (tropism.angle != 0) {  // aims beside it, in the plane of both
      DVec3 axis = unit(glm::cross(toward, state.heading));
      if (axis != DVec3{0, 0, 0}) toward = turned(toward, axis, radians(tropism.angle));
    }
    (tropism.is_torque ? roll : pull) += toward * (state.elasticities[i] * tropism.intensity);
  }
  DVec3 axis = glm::cross(state.heading, pull);
  double angle = std::min(std::sqrt(glm::dot(axis, axis)), 1.0);
  if (angle > 0)
    for (DVec3* v : {&state.heading, &state.left, &state.up}) *v = turned(*v, unit(axis), angle);
  double sine = glm::dot(glm::cross(state.up, roll), state.heading);
  if (sine != 0)
    for (DVec3* v : {&state.left, &state.up}) *v = turned(*v, state.heading, std::clamp(sine, -1.0, 1.0));
}

}  // namespace frond::cpfg
