#include <string_view>

#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

/// Whether the module at a place answers a `?` before it.
bool is_query(const CpfgWord& word, std::size_t at) {
  const CpfgModule& module = word.modules[at];
  bool asked = at > 0 && word.modules[at - 1].symbol == '?' && word.modules[at - 1].count == 0;
  return asked && (module.count == 2 || module.count == 3) &&
         std::string_view("PHLU").find(module.symbol) != std::string_view::npos;
}

DVec3 answer(char symbol, const CpfgTurtleState& state) {
  return symbol == 'P'   ? state.position
         : symbol == 'H' ? state.heading
         : symbol == 'L' ? state.left
                         : state.up;
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
    DVec3 v = answer(query.symbol, turtle.state);
    bool same = query.symbol == modules[at].symbol && query.count == modules[at].count;
    for (int i = 0; same && i < query.count; ++i)
      word.parameters[query.first + static_cast<std::uint32_t>(i)] = static_cast<float>(v[i]);
    ++at;
  }
}

}  // namespace frond::cpfg
