#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/cpfg_models.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "cpfg/cpfg.h"
#include "grammar/kind.h"
#include "organisms/cpfg_picture.h"

namespace frond {

namespace {

struct DerivedModel {
  CpfgModel model;
  CpfgDerived derived;
};

DerivedModel derive_model(const GrammarArguments& arguments, bool drawing) {
  if (arguments.seed)
    fail({{"--seed", "a model of cpfg has its seed in its file; change it there"}}, kWrongInput);
  if (arguments.angle)
    fail({{"--angle", "a model of cpfg has its angle in its view; change it there"}}, kWrongInput);
  if (arguments.mutations > 0) fail({{"--mutate", "only grammars of LParser are mutated"}}, kWrongInput);
  CpfgModel model = or_fail(read_cpfg(arguments.path), kWrongInput);
  for (const std::string& note : model.notes) tell(fmt::format("note: {}", note));
  CpfgRequest request;
  request.drawing = drawing;
  if (arguments.steps) request.steps = static_cast<int>(std::clamp(std::ceil(*arguments.steps), 0.0, 1e9));
  CpfgDerived derived = or_fail(derive(model, request), kWrongInput);
  for (const std::string& note : derived.notes) tell(fmt::format("{}: note: {}", arguments.path, note));
  return {std::move(model), std::move(derived)};
}

std::string list(DVec3 v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// What `frond turtle` says of our own grammars, too.
std::string measures(const CpfgFigure& figure) {
  double length = 0;
  for (const CpfgSegment& s : figure.segments) length += glm::distance(s.from, s.to);
  return fmt::format(
      "{{\"segments\": {}, \"total_length\": {}, \"end_position\": {}, \"end_heading\": {}, \"end_left\": "
      "{}, \"end_up\": {}, \"bbox\": [{}, {}], \"max_stack_depth\": {}, \"polygons\": {}, \"surfaces\": {}, "
      "\"skins\": {}, \"spheres\": {}, \"discs\": {}}}\n",
      figure.segments.size(), length, list(figure.end), list(figure.end_heading), list(figure.end_left),
      list(figure.end_up), list(figure.low), list(figure.high), figure.max_stack_depth,
      figure.polygons.size(), figure.placed.size(), figure.skins.size(), figure.spheres.size(),
      figure.discs.size());
}

}  // namespace

bool is_cpfg_model(const std::string& path) {
  Result<std::string> text = read_file(path);
  return grammar_kind(path, text ? *text : "") == GrammarKind::cpfg;
}

void info_cpfg(const GrammarArguments& arguments, bool json) {
  DerivedModel made = derive_model(arguments, true);
  const CpfgWord& word = made.derived.word;
  auto draws = [](const CpfgModule& module) { return module.symbol == 'F' || module.symbol == 'G'; };
  auto segments = std::ranges::count_if(made.derived.drawing.word.modules, draws);
  std::size_t bytes = word.modules.size() * sizeof(CpfgModule) + word.parameters.size() * sizeof(float);
  std::string_view form =
      json ? "{{\"forecast\": \"exact\", \"steps\": {}, \"modules\": {}, \"segments\": {}, \"bytes\": {}}}\n"
           : "exact: after {} steps {} modules, {} segments, {} bytes\n";
  put(fmt::format(fmt::runtime(form), made.derived.steps, word.modules.size(), segments, bytes));
}

void derive_cpfg(const GrammarArguments& arguments) {
  if (arguments.picture)
    fail(
        {{"--tree", "which symbol came from which is drawn of Frond's own grammars, not of a model of cpfg"}},
        kWrongInput);
  now_doing("deriving the word");
  DerivedModel made = derive_model(arguments, false);
  if (arguments.format == "text") {
    put(text(made.derived.word, made.model));
    put("\n");
    return;
  }
  std::map<char, std::size_t> counts;
  for (const CpfgModule& module : made.derived.word.modules) ++counts[module.symbol];
  for (const auto& [symbol, count] : counts) put(fmt::format("{} {}\n", symbol, count));
}

void turtle_cpfg(const GrammarArguments& arguments) {
  now_doing("deriving the word and walking along it");
  DerivedModel made = derive_model(arguments, true);
  CpfgFigure figure = or_fail(draw(made.model, made.derived.drawing), kWrongInput);
  if (arguments.picture) {
    or_fail(write_file(*arguments.picture, svg_of(drawing_of(figure))), kCouldNot);
    return;
  }
  put(measures(figure));
}

}  // namespace frond
