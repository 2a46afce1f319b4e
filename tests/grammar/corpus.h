#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "grammar/figure.h"

namespace frond {

/// The known answers: derivations and turtle walks of the literature, confirmed by other engines.
inline const nlohmann::json& corpus() {
  static const nlohmann::json cases = [] {
    std::ifstream file(std::string(FROND_ROOT) + "/tests/grammar/corpus.json");
    return nlohmann::json::parse(file);
  }();
  return cases;
}

inline std::string formula(const nlohmann::json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

inline std::vector<GrammarText::Rule> rules_of(const nlohmann::json& rules) {
  std::vector<GrammarText::Rule> texts;
  for (const auto& rule : rules) {
    std::string text = rule["pred"].get<std::string>();
    if (rule.contains("cond")) text += " : " + formula(rule["cond"]);
    text += " ->";
    if (rule.contains("prob")) text += "(" + formula(rule["prob"]) + ")";
    text += " " + rule["succ"].get<std::string>();
    texts.push_back({text, rule.value("limit", GrammarText::kUnlimited), ""});
  }
  return texts;
}

inline DVec3 point_of(const nlohmann::json& p) {
  return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()};
}

/// The grammar of a case, field by field.
inline GrammarText grammar_of(const nlohmann::json& c) {
  GrammarText g;
  g.axiom = c.value("axiom", "F");
  g.steps = c.value("n", 0);
  if (c.contains("angle_deg") && c["angle_deg"].is_number()) g.angle = c["angle_deg"];
  if (c.contains("rules")) g.rules = rules_of(c["rules"]);
  if (c.contains("decomposition")) g.decomposition = rules_of(c["decomposition"]);
  if (c.contains("homomorphism")) g.interpretation = rules_of(c["homomorphism"]);
  g.interpretation_depth = c.value("homomorphism_depth", 1);
  const nlohmann::json drawn = c.value("draw_as", nlohmann::json::object());
  for (const auto& [name, symbol] : drawn.items())
    g.interpretation.push_back({name + " -> " + symbol.get<std::string>(), GrammarText::kUnlimited, ""});
  const nlohmann::json constants = c.value("constants", nlohmann::json::object());
  for (const auto& [name, value] : constants.items()) g.constants.emplace_back(name, formula(value));
  g.ignore = c.value("ignore", "");
  g.consider = c.value("consider", "");
  g.ring = c.value("ring", false);
  g.symbols = c.value("multi_char_symbols", std::vector<std::string>{});
  if (c.value("mode", "parallel") == "sequential") g.mode = GrammarText::Mode::sequential;
  const nlohmann::json pull = c.value("turtle_options", nlohmann::json::object());
  if (pull.contains("tropism")) {
    for (int i = 0; i < 3; ++i) g.tropism[i] = pull["tropism"][static_cast<std::size_t>(i)];
    g.elasticity = pull["e"];
  }
  if (c.contains("start")) {
    g.length = c["start"].value("step", 1.0);
    if (c["start"].contains("position")) g.start = point_of(c["start"]["position"]);
    if (c["start"].contains("heading")) g.start_heading = point_of(c["start"]["heading"]);
  }
  if (c.contains("guide")) {
    for (const auto& point : c["guide"]["points"]) g.guide.points.push_back({point_of(point)});
    g.guide.parent = c["guide"]["parent"].get<std::vector<int>>();
    g.guide.tolerance = c["guide"]["tolerance"];
    g.guide.leniency = c["guide"]["leniency"];
  }
  return g;
}

}  // namespace frond
