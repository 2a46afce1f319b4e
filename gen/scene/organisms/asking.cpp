#include "organisms/asking.h"

#include <algorithm>
#include <array>

#include "grammar/turtle_state.h"

namespace frond {

namespace {

constexpr float kSight = 3;       // metres: bodies farther off do not count
constexpr float kProbe = 0.002f;  // metres

enum class Question { light, surface, food };

struct Answer {
  float distance = 0;
  Vec3 direction{0};
};

Answer nearest_surface(const Surroundings& around, Vec3 at) {
  Surroundings::Hold hold = around.hold(at, kSight);
  Answer answer{glm::distance(at, hold.at), hold.normal};
  float border = around.border(at);
  if (border >= answer.distance) return answer;
  Vec3 slope(0);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 aside(0);
    aside[axis] = kProbe;
    slope[axis] = around.border(at + aside) - around.border(at - aside);
  }
  float length = glm::length(slope);
  return {border, length > 0 ? slope / length : answer.direction};
}

}  // namespace

Environment environment_of(const Surroundings& around, const Food& food, const Growth& growth) {
  Vec3 meal = around.inside(food.position.at(growth.start + growth.duration));
  bool fed = food.pulls();
  return [&around, meal, fed](const TurtleState& turtle, std::span<double> parameters) {
    Vec3 at(turtle.position);
    Answer answer;
    if (parameters[0] == static_cast<double>(Question::light)) {
      answer.distance = around.light(at);
    } else if (parameters[0] == static_cast<double>(Question::surface)) {
      answer = nearest_surface(around, at);
    } else if (parameters[0] == static_cast<double>(Question::food) && fed) {
      answer.distance = glm::distance(at, meal);
      if (answer.distance > 0) answer.direction = (meal - at) / answer.distance;
    } else {
      return;
    }
    std::array<float, 4> said{answer.distance, answer.direction.x, answer.direction.y, answer.direction.z};
    std::size_t asked = std::min(parameters.size(), parameters[0] == 0 ? std::size_t{2} : said.size() + 1);
    for (std::size_t i = 1; i < asked; ++i) parameters[i] = static_cast<double>(said[i - 1]);
  };
}

bool asks(const GrammarText& text) {
  auto asked = [](const std::string& part) { return part.find("?E") != std::string::npos; };
  auto asks_in = [&](const std::vector<GrammarText::Rule>& rules) {
    return std::ranges::any_of(rules, asked, &GrammarText::Rule::text);
  };
  return asked(text.axiom) || asks_in(text.rules) || asks_in(text.decomposition);
}

Errors check_asking(const Grammar& grammar, double height) {
  if (!grammar.asks || height <= 0) return {};
  return {
      {"/height", "found a height, but the grammar asks ?E in metres as its turtle draws; expected none"}};
}

}  // namespace frond
