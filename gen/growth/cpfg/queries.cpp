#include <algorithm>
#include <cmath>
#include <string_view>

#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

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
