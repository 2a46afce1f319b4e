#include "cpfg/turtle.h"

#include <algorithm>
#include <cmath>

#include "core/read_as.h"
#include "cpfg/shapes.h"

namespace frond::cpfg {

namespace {

constexpr double kThinnest = 1e-7;

/// Turns `a` toward `b`, which are at right angles.
void turn_in_plane(DVec3& a, DVec3& b, double angle) {
  double c = std::cos(angle), s = std::sin(angle);
  DVec3 before = a;
  a = a * c + b * s;
  b = b * c - before * s;
}

/// A line of a tropism or torque; nothing where it has no direction or no intensity.
std::optional<CpfgTropism> read_tropism(std::string_view value, bool is_torque) {
  CpfgTropism tropism;
  tropism.is_torque = is_torque;
  auto after = [&](std::string_view label) {
    std::size_t at = value.find(label);
    if (at == value.npos) return std::vector<double>();
    std::string_view rest = value.substr(at + label.size());
    return numbers_in(rest.substr(0, rest.find(':')));
  };
  std::vector<double> direction = after("T:"), intensity = after("I:");
  if (direction.size() < 3) return {};
  DVec3 toward{direction[0], direction[1], direction[2]};
  double length = std::sqrt(glm::dot(toward, toward));
  if (!(length > 0)) return {};
  double factor = intensity.empty() ? 1 / length : std::clamp(intensity[0] / length, -1.0, 1.0);
  if (factor == 0) return {};
  tropism.direction = toward * factor;
  for (auto [label, into] : {std::pair("A:", &tropism.angle), std::pair("E:", &tropism.elasticity),
                             std::pair("S:", &tropism.step)})
    if (std::vector<double> numbers = after(label); !numbers.empty()) *into = numbers[0];
  return tropism;
}

int cut(double number) { return number == number ? static_cast<int>(std::clamp(number, -1e9, 1e9)) : 0; }

}  // namespace

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    std::optional<double> value = consume_as<double>(text);
    if (!value) text.remove_prefix(1);
    if (value && std::isfinite(*value)) numbers.push_back(*value);
  }
  return numbers;
}

TurtleSettings turtle_settings(const CpfgModel& model) {
  TurtleSettings settings;
  for (const auto& [symbol, surface] : model.shapes->surfaces) settings.surfaces[symbol] = surface.end;
  settings.colors = static_cast<int>(model.shapes->colors.size());
  for (const CpfgViewLine& line : model.view) {
    if (line.key == "tropism" || line.key == "torque")
      if (std::optional<CpfgTropism> tropism = read_tropism(line.value, line.key == "torque"))
        settings.tropisms.push_back(*tropism);
    if (line.key == "environment display") settings.answers_after = line.value.starts_with("before");
    if (line.key == "interpretation past %") settings.draws_past_cut = !line.value.starts_with("off");
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
  if (settings.scale == 0) settings.scale = 1;
  return settings;
}

CpfgTurtle::CpfgTurtle(const TurtleSettings& settings, const CpfgDrawing& drawing)
    : settings_(settings), drawing_(drawing) {
  state.scale = part_scale_ = settings.scale;
  state.width = std::max(settings.width, kThinnest);
  state.color = state.back = color_of(settings.color);
  state.elasticity = settings.old_elasticity;
  for (const CpfgTropism& tropism : settings.tropisms) state.elasticities.push_back(tropism.elasticity);
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
      move(values.empty() ? 1 : values[0]);
      if (symbol == 'F' || symbol == 'G') keep_frame();
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
    case '?':
      if (modules()[at].instance < 0) break;
      parts_.push_back(part_scale_);
      set_part_scale(settings_.scale * drawing_.scale[at]);
      break;
    case '$':
      if (parts_.empty()) break;
      set_part_scale(parts_.back());
      parts_.pop_back();
      break;
    case '%':
      if (!settings_.draws_past_cut && values.empty()) return cut_end(drawing_.word, at + 1);
      break;
    case '~':
      if (at + 1 < modules().size()) place_surface(at + 1);
      return at + 2;
    case '@':
      switch (std::size_t letters = read_with(drawing_.word, at, modules().size())) {
        case 1:
          step_special(at + 1);
          return at + 2;
        case 2:
          return step_pair(at + 1);
        default:
          return at + 1 + letters;
      }
    default:
      if (!step_value(symbol, values))
        turn(symbol, radians(values.empty() ? settings_.angle : double{values[0]}));
  }
  return at + 1;
}

void CpfgTurtle::turn(char symbol, double angle) {
  if (symbol == '+') turn_in_plane(state.heading, state.left, angle);
  if (symbol == '-') turn_in_plane(state.heading, state.left, -angle);
  if (symbol == '&') turn_in_plane(state.heading, state.up, angle);
  if (symbol == '^') turn_in_plane(state.heading, state.up, -angle);
  if (symbol == '/') turn_in_plane(state.left, state.up, angle);
  if (symbol == '\\') turn_in_plane(state.left, state.up, -angle);
  if (symbol == '|') turn_in_plane(state.heading, state.left, kPi);
}

/// Width, colour and elasticity; false where the symbol sets none of them.
bool CpfgTurtle::step_value(char symbol, std::span<const float> values) {
  bool bare = values.empty();
  switch (symbol) {
    case '!':
    case '#': {
      double step = symbol == '!' ? -settings_.width_step : settings_.width_step;
      double width = bare ? state.width + step * state.scale : values[0] * state.scale;
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

/// The scale of another L-system: widths follow it, what `@D` had set is gone.
void CpfgTurtle::set_part_scale(double scale) {
  if (part_scale_ != 0) state.width *= scale / part_scale_;
  state.scale = part_scale_ = scale;
}

/// What has one letter after its `@`.
void CpfgTurtle::step_special(std::size_t at) {
  std::span<const float> values = parameters(at);
  switch (symbol(at)) {
    case 'M':
      if (values.size() >= 2) state.position = {values[0], values[1], values.size() > 2 ? values[2] : 0};
      break;
    case 'R':
      if (values.size() >= 2) aim(values);
      break;
    case 'v':
      level();
      break;
    case '#':
      state.contour = values.empty() ? 0 : cut(values[0]);
      break;
    case '!':
      state.sides = values.empty() ? 8 : std::clamp(cut(values[0]), 3, 1000);
      break;
    case ';':
    case ',': {
      int step = symbol(at) == ';' ? settings_.color_step : -settings_.color_step;
      state.back = color_of(values.empty() ? state.back + step : double{values[0]});
      break;
    }
    case 'D':
      state.scale = values[0];
      break;
    default:
      break;
  }
}

/// What has two letters after its `@`.
std::size_t CpfgTurtle::step_pair(std::size_t at) {
  char first = symbol(at), second = symbol(at + 1);
  std::span<const float> values = parameters(at + 1);
  if (first == 'D') {
    double factor = values.empty() ? settings_.scale_multiplier : double{values[0]};
    if (factor != 0) state.scale *= second == 'i' ? factor : 1 / factor;
  }
  if (first == 'T' && second == 'p') carry_frame();
  if (first == 'T' && second == 'f') keep_frame();
  if (first == 'T') set_elasticity(second, values);
  if (first == 'G' && second == 't') set_tangents(values);
  if (first == 'G' && second == 'r') set_rises(values);
  if (first == 'm' && second == 'c' && !values.empty() && values[0] == 1)
    return cut_end(drawing_.word, at + 2);
  return at + 2;
}

void CpfgTurtle::set_elasticity(char how, std::span<const float> values) {
  double number = values.empty() ? 0 : values[0];
  if (!(number >= 1 && number < static_cast<double>(state.elasticities.size()) + 1)) return;
  auto index = static_cast<std::size_t>(number) - 1;
  double& elasticity = state.elasticities[index];
  double step = values.size() > 1 ? values[1] : settings_.tropisms[index].step;
  if (how == 's') elasticity = values.size() > 1 ? values[1] : 0;
  if (how == 'i') elasticity += step;
  if (how == 'd') elasticity -= step;
}

/// `@Gt`: shares for both sides of a place, or for each.
void CpfgTurtle::set_tangents(std::span<const float> values) {
  if (values.empty()) return;
  state.arriving = values[0];
  state.leaving = values[values.size() > 1 ? 1 : 0];
}

/// `@Gr`: angle and length for both sides of a place, or for each.
void CpfgTurtle::set_rises(std::span<const float> values) {
  if (values.size() == 1) state.rises_by_length = values[0] != 0;
  if (values.size() < 2) return;
  auto rise = [&](std::size_t from) -> std::array<double, 2> {
    double angle = radians(double{values[from]}), length = values[from + 1];
    return {std::cos(angle) * length, std::sin(angle) * length};
  };
  state.rise_arriving = rise(0);
  state.rise_leaving = rise(values.size() >= 4 ? 2 : 0);
}

/// `~x`: goes on at the surface's end.
void CpfgTurtle::place_surface(std::size_t at) {
  auto found = settings_.surfaces.find(symbol(at));
  if (found == settings_.surfaces.end()) return;
  std::span<const float> values = parameters(at);
  DVec3 end = found->second * ((values.empty() ? 1 : values[0]) * state.scale);
  state.position += state.left * end.x + state.heading * end.y + state.up * end.z;
}

void CpfgTurtle::move(double length) {
  // The tropisms and torques of the view's newer lines.
  if (!settings_.tropisms.empty()) pull_heading(), roll_up();
  state.position += state.heading * (length * state.scale);
  if (state.elasticity == 0 || settings_.old_direction == DVec3{0, 0, 0}) return;
  auto bend = [&](DVec3& from, DVec3& toward) {
    double sine = std::clamp(state.elasticity * glm::dot(settings_.old_direction, toward), -1.0, 1.0);
    turn_in_plane(from, toward, std::asin(sine));
  };
  bend(state.heading, state.up);
  bend(state.heading, state.left);
}

std::size_t read_with(const CpfgWord& word, std::size_t at, std::size_t end) {
  const std::vector<CpfgModule>& modules = word.modules;
  if (at + 1 >= end) return 0;
  if (modules[at].symbol == '~' || (modules[at].symbol == '?' && modules[at].count == 0)) return 1;
  if (modules[at].symbol != '@') return 0;
  const CpfgModule& first = modules[at + 1];
  bool single = std::string_view(",;ocOvRMLS#!IJ").find(first.symbol) != std::string_view::npos;
  if (single || (first.symbol == 'D' && first.count > 0)) return 1;
  if (first.count > 0 || at + 2 >= end) return 0;
  if (first.symbol == 'b') return 2;
  constexpr std::pair<char, std::string_view> kPairs[] = {
      {'P', "SCD"}, {'T', "xidspf"}, {'G', "scetr"}, {'m', "oc"}, {'D', "id"}};
  for (auto [letter, second] : kPairs)
    if (letter == first.symbol && second.find(modules[at + 2].symbol) != second.npos) return 2;
  return 0;
}

std::size_t cut_end(const CpfgWord& word, std::size_t at) {
  int branches = 1, parts = 1;
  for (; at < word.modules.size(); ++at) {
    const CpfgModule& module = word.modules[at];
    branches += (module.symbol == '[') - (module.symbol == ']');
    parts += (module.symbol == '?' && module.count > 0) - (module.symbol == '$');
    if (branches == 0 || parts == 0 || (module.symbol == '%' && module.count > 0)) return at;
  }
  return at;
}

}  // namespace frond::cpfg
