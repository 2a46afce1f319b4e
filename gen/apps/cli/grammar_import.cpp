#include <algorithm>

#include "cli/imported_preset.h"
#include "cli/messages.h"
#include "core/files.h"
#include "core/plain_text.h"
#include "grammar/figure.h"
#include "grammar/import.h"
#include "grammar/kind.h"
#include "grammar/lparser_rules.h"
#include "organisms/grammar_file.h"

// Presets of the grammars of LParser and Houdini: import.

namespace frond {

namespace {

constexpr std::string_view kLeaves = "JKM";  ///< organs of Houdini's rules

/// LParser's colours of the indices 0 to 15, as its lists name them.
constexpr const char* kColors[] = {"#555555", "#1a1a1a", "#b03a2e", "#d4ac0d", "#4f8a3c", "#3f9c94",
                                   "#3a62b0", "#a04a94", "#2f5f2a", "#2c6b66", "#2b3f78", "#6b2f62",
                                   "#7a5a3a", "#3c5f33", "#8a8a8a", "#ededea"};

constexpr float kLargestMeasured = 150;  ///< metres: a skeleton beyond it has another unit, and is scaled

Value texts_of(const std::vector<GrammarText::Rule>& rules) {
  Value list = make_list();
  for (const GrammarText::Rule& rule : rules) list.items.push_back(make_text(rule.text));
  return list;
}

Value properties_of(const GrammarText& g) {
  const GrammarText usual;
  Value out = make_object();
  auto number = [&](std::string_view name, double value, double otherwise) {
    if (value != otherwise) out.set(name, make_number(value));
  };
  if (g.dialect != Dialect::abop)
    out.set("dialect", make_text(g.dialect == Dialect::lparser ? "lparser" : "houdini"));
  out.set("axiom", make_text(g.axiom)).set("steps", make_number(g.steps)).set("angle", make_number(g.angle));
  number("last_step", g.last_step, usual.last_step);
  number("length", g.length, usual.length);
  number("width", g.width, usual.width);
  number("width_scale", g.width_scale, usual.width_scale);
  number("length_scale", g.length_scale, usual.length_scale);
  number("angle_scale", g.angle_scale, usual.angle_scale);
  number("angle_jitter", g.angle_jitter, usual.angle_jitter);
  number("length_jitter", g.length_jitter, usual.length_jitter);
  number("seed", static_cast<double>(g.seed), static_cast<double>(usual.seed));
  Value constants = make_object();
  for (const auto& [name, formula] : g.constants) constants.set(name, make_text(formula));
  if (!constants.members.empty()) out.set("constants", constants);
  out.set("rules", texts_of(g.rules));
  if (!g.interpretation.empty()) out.set("interpretation", texts_of(g.interpretation));
  if (!g.ignore.empty()) out.set("ignore", make_text(g.ignore));
  if (g.start_heading != usual.start_heading)
    out.set("start", make_object({{"heading",
                                   {},
                                   make_list({make_number(g.start_heading.x), make_number(g.start_heading.y),
                                              make_number(g.start_heading.z)})}}));
  if (!g.symbols.empty()) out.set("symbols", make_texts(g.symbols));
  return out;
}

/// Leaves to begin with for what the figure hangs on its branches, and colours for its outlines.
Value looks_of(const GrammarText& g, const Figure& figure) {
  Value organs = make_list(), looks = make_object();
  for (char leaf : kLeaves) {
    std::string name(1, leaf);
    if (std::ranges::find(figure.sites, name, &Site::name) == figure.sites.end()) continue;
    organs.items.push_back(make_object({{"symbol", {}, make_text(name)},
                                        {"shape", {}, make_text("leaf")},
                                        {"size", {}, make_number(0.06)},
                                        {"colors", {}, make_texts(std::vector{"#5d8a2e", "#6f9a35"})}}));
  }
  if (!organs.items.empty()) looks.set("organs", organs);
  if (!figure.outlines.empty() && g.dialect == Dialect::lparser)
    looks.set("blades", make_object({{"colors", {}, make_texts(kColors)}}));
  return looks;
}

Bounds box_of(const Figure& figure) {
  Bounds box = bounds_of(figure.skeleton.position);
  for (const Outline& outline : figure.outlines) box.extend(bounds_of(outline.points));
  return box;
}

}  // namespace

void import_rules(const ImportArguments& arguments) {
  const std::string& path = arguments.path;
  Result<std::string> text = read_file(path);
  GrammarKind kind = grammar_kind(path, text ? *text : "");
  if (text && kind == GrammarKind::preset)
    fail({{path,
           "expected a model of cpfg (.l), a grammar of LParser (.ls), Houdini (.txt) or Fractint, "
           "or a skeleton (.swc)"}},
         kWrongInput);
  bool measured = kind == GrammarKind::skeleton;
  if (arguments.z_up && !measured) fail({{"--z-up", "only skeletons (.swc) are turned"}}, kWrongInput);
  Result<GrammarText> grammar = !text      ? text.errors()
                                : measured ? import_skeleton(plain_text(*text), arguments.z_up)
                                           : import_grammar(path, *text, arguments.system);
  if (!grammar) fail(in_file(grammar.errors(), path), kWrongInput);
  if (arguments.mutations > 0 && grammar->dialect != Dialect::lparser)
    fail({{"--mutate", "only grammars of LParser are mutated"}}, kWrongInput);
  if (arguments.steps) grammar->steps = *arguments.steps, grammar->last_step = 1;
  grammar->seed = arguments.seed.value_or(grammar->seed);
  grammar->mutations += arguments.mutations;
  *grammar = mutated(std::move(*grammar));
  for (char leaf : kLeaves) grammar->organs.emplace_back(1, leaf);
  Result<Grammar> compiled = compile(*grammar);
  if (!compiled) fail(in_file(compiled.errors(), path), kWrongInput);
  tell_notes(in_file(compiled->warnings, path));
  Result<Figure> figure =
      figure_of(*compiled, grammar->growth(), Seed{grammar->seed}, grammar->limits, grammar->organs);
  if (!figure) fail(in_file(figure.errors(), path), kWrongInput);
  ImportedPlant plant{box_of(*figure), {0.35, 0.12, 1}, properties_of(*grammar), looks_of(*grammar, *figure)};
  if (measured) {
    const Vec3 size = plant.box.size();
    plant.measured = std::max({size.x, size.y, size.z}) <= kLargestMeasured;
    plant.looks.set("thickness", make_object({{"from", {}, make_text("turtle")}}));
  }
  write_imported(arguments, plant);
}

}  // namespace frond
