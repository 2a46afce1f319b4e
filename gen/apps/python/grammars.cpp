#include "core/files.h"
#include "grammar/figure.h"
#include "grammar/forecast.h"
#include "grammar/picture.h"
#include "grammar/review.h"
#include "organisms/grammar_file.h"
#include "organisms/kinds.h"
#include "python/python.h"
#include "scene/preset.h"

namespace frond {

namespace {

using GrammarPtr = std::shared_ptr<Grammar>;

/// What a derivation gives, with the names of its symbols.
struct Derived {
  GrammarPtr grammar;
  Word word;
};

GrammarPtr compiled(const GrammarText& grammar, const std::string& path) {
  Result<Grammar> result = compile(grammar);
  if (!result) raise(in_file(result.errors(), path));
  return std::make_shared<Grammar>(std::move(*result));
}

GrammarPtr grammar_of(const std::string& text, const std::string& path,
                      const std::optional<std::filesystem::path>& assets) {
  return compiled(or_raise(read_grammar(text, path, Assets(path, assets))), path);
}

std::vector<GrammarPtr> grammars_in(const Preset& preset) {
  std::vector<GrammarPtr> grammars;
  for (const Organism& organism : preset.organisms)
    if (auto grammar = organism.grower->grammar())
      grammars.push_back(std::make_shared<Grammar>(or_raise(*grammar)));
  return grammars;
}

/// What is made of a grammar after `steps`, without holding other threads up.
template <class Make>
auto made(const Grammar& grammar, std::optional<double> steps, std::optional<std::uint64_t> seed,
          const Make& make) {
  double count = steps.value_or(grammar.text.steps);
  if (!(count >= 0 && count <= 1e6)) throw py::value_error("steps: expected a number of 0 to 1e6");
  Seed of{seed.value_or(grammar.text.seed)};
  py::gil_scoped_release others;
  Forecast size = forecast(grammar, static_cast<int>(std::ceil(count)), of, grammar.text.limits);
  Errors errors = refuse(size, grammar.text.limits);
  auto result = errors.empty() ? make(count, of) : decltype(make(count, of))(errors);
  py::gil_scoped_acquire back;
  if (!result) raise(placed(result.errors(), grammar.text));
  return std::move(*result);
}

std::shared_ptr<Derived> word_of(const GrammarPtr& grammar, std::optional<int> steps,
                                 std::optional<std::uint64_t> seed) {
  return std::make_shared<Derived>(Derived{grammar, made(*grammar, steps, seed, [&](double count, Seed of) {
                                             return derive(*grammar, static_cast<int>(count), of,
                                                           grammar->text.limits);
                                           })});
}

std::vector<std::string> names_of(const Grammar& grammar) {
  std::vector<std::string> names;
  for (const Symbol& symbol : grammar.symbols) names.push_back(symbol.name);
  return names;
}

py::dict sites_of(const Figure& figure) {
  py::list names, positions, headings, nodes;
  for (const Site& site : figure.sites) {
    names.append(site.name);
    positions.append(py::make_tuple(site.position.x, site.position.y, site.position.z));
    headings.append(py::make_tuple(site.heading.x, site.heading.y, site.heading.z));
    nodes.append(site.node);
  }
  py::dict sites;
  sites["name"] = names, sites["position"] = positions, sites["heading"] = headings, sites["node"] = nodes;
  return sites;
}

void add_words(py::module_& module) {
  py::class_<Derived, std::shared_ptr<Derived>>(module, "Word")
      .def("__len__", [](const Derived& d) { return d.word.size(); })
      .def("__str__", [](const Derived& d) { return text(*d.grammar, d.word); })
      .def("__eq__", [](const Derived& a,
                        const Derived& b) { return text(*a.grammar, a.word) == text(*b.grammar, b.word); })
      .def_property_readonly(
          "symbols", [](py::object self) { return viewed(self.cast<const Derived&>().word.symbols, self); })
      .def_property_readonly(
          "parameters",
          [](py::object self) { return viewed(self.cast<const Derived&>().word.parameters, self); })
      .def_property_readonly("names", [](const Derived& d) { return names_of(*d.grammar); })
      .def_property_readonly("counts", [](const Derived& d) {
        py::dict found;
        for (const auto& [name, count] : counts(*d.grammar, d.word)) found[py::str(name)] = count;
        return found;
      });
}

}  // namespace

void add_grammars(py::module_& module) {
  using Steps = std::optional<double>;
  using SeedOf = std::optional<std::uint64_t>;
  auto steps = py::arg("steps") = py::none();
  auto seed = py::arg("seed") = py::none();
  add_words(module);
  py::class_<Figure, std::shared_ptr<Figure>>(module, "Figure")
      .def_property_readonly("skeleton",
                             [](const std::shared_ptr<Figure>& f) { return part_of(f, f->skeleton); })
      .def_property_readonly("color", array_of(&Figure::color))
      .def_property_readonly("outlines",
                             [](py::object self) {
                               py::list outlines;
                               for (const Outline& outline : self.cast<const Figure&>().outlines)
                                 outlines.append(viewed(outline.points, self));
                               return outlines;
                             })
      .def_property_readonly("sites", &sites_of);
  py::class_<Grammar, GrammarPtr>(module, "Grammar")
      .def(py::init(&grammar_of), py::arg("text"), py::arg("name") = "grammar.json",
           py::arg("assets") = py::none())
      .def_property_readonly("steps", [](const Grammar& g) { return g.text.steps; })
      .def_property_readonly("angle", [](const Grammar& g) { return g.text.angle; })
      .def("derive", &word_of, steps, seed)
      .def(
          "draw",
          [](const Grammar& g, Steps count, SeedOf of) {
            return std::make_shared<Figure>(
                made(g, count, of, [&](double n, Seed s) { return figure_of(g, n, s, g.text.limits); }));
          },
          steps, seed)
      .def(
          "picture",
          [](const Grammar& g, Steps count, SeedOf of) {
            return made(g, count, of, [&](double n, Seed s) { return turtle_svg(g, n, s, g.text.limits); });
          },
          steps, seed)
      .def(
          "tree",
          [](const Grammar& g, std::optional<int> count, SeedOf of) {
            return made(g, count, of,
                        [&](double n, Seed s) { return derivation_tree_svg(g, static_cast<int>(n), s); });
          },
          steps, seed);
  module.def("grammars_in", &grammars_in);
}

}  // namespace frond
