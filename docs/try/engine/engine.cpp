#include <algorithm>
#include <cmath>

#include "geometry/outline.h"
#include "grammar/figure.h"
#include "grammar/forecast.h"
#include "grammar/picture.h"
#include "grammar/review.h"
#include "organisms/describe_grammar.h"
#include "preset/reader.h"
#include "try/engine/answers.h"

// The functions of the grammar engine that the page calls. Grammars come as the JSON text of a grammar file;
// every answer is an object, with `errors` where the grammar cannot be drawn.

namespace frond {

namespace {

/// A grammar ready to derive, and what is asked of it.
struct Request {
  Grammar grammar;
  double steps;
  Seed seed;
  Limits limits;
};

/// The compiled grammar of a text. Where it has no limit of modules, that of the page is taken.
Result<Request> read(const std::string& json, double steps, double modules) {
  Result<Document> document = parse_json(json, "grammar");
  if (!document) return document.errors();
  Result<GrammarText> text = read_preset<GrammarText>(*document);
  if (!text) return text.errors();
  text->where = origin_at(document->root, "/steps").text();
  if (!text->guide.file.empty())
    return Error{origin_at(document->root, "/guide/file").text(), "no files are read here; give points"};
  Result<Grammar> grammar = compile(*text);
  if (!grammar) return grammar.errors();
  Limits limits = text->limits;
  if (limits.modules == Limits{}.modules) limits.modules = static_cast<std::uint64_t>(modules);
  limits.bytes = std::min(limits.bytes, std::uint64_t{1} << 29);
  Forecast size = forecast(*grammar, static_cast<int>(std::ceil(steps)), Seed{text->seed}, limits);
  if (Errors errors = refuse(size, limits); !errors.empty()) return placed(errors, grammar->text);
  return Request{std::move(*grammar), steps, Seed{text->seed}, limits};
}

/// Segments as their two ends, each with its radius, and outlines as triangles.
val picture_of(const Figure& figure) {
  const Skeleton& s = figure.skeleton;
  std::vector<float> segments, triangles, sites;
  std::vector<std::int32_t> segment_colors, triangle_colors, site_colors;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto below = static_cast<std::size_t>(s.parent[i]);
    put(segments, s.position[below]), segments.push_back(s.radius[below]);
    put(segments, s.position[i]), segments.push_back(s.radius[i]);
    segment_colors.push_back(figure.color[i]);
  }
  std::vector<std::array<std::uint32_t, 3>> corners;
  for (const Outline& outline : figure.outlines) {
    corners.clear();
    triangulate(outline.points, 0, corners);
    for (const auto& triangle : corners) {
      for (std::uint32_t corner : triangle) put(triangles, outline.points[corner]);
      triangle_colors.push_back(outline.color + 1);
    }
  }
  val names = val::array();
  for (const Site& site : figure.sites) {
    put(sites, site.position), put(sites, site.heading), put(sites, site.left), put(sites, site.scale);
    site_colors.push_back(site.color);
    names.call<void>("push", site.name);
  }
  val out = val::object();
  out.set("segments", copied(segments)), out.set("segmentColors", copied(segment_colors));
  out.set("triangles", copied(triangles)), out.set("triangleColors", copied(triangle_colors));
  out.set("sites", copied(sites)), out.set("siteColors", copied(site_colors)), out.set("siteNames", names);
  return out;
}

/// What the turtle draws after `steps` steps, which may be fractional.
val draw_figure(const std::string& json, double steps, double modules) {
  Result<Request> request = read(json, steps, modules);
  if (!request) return failed(request.errors());
  const Grammar& grammar = request->grammar;
  Result<Figure> figure = figure_of(grammar, steps, request->seed, request->limits);
  if (!figure) return failed(placed(figure.errors(), grammar.text));
  val out = picture_of(*figure);
  out.set("errors", val::array()), out.set("notes", list(grammar.warnings));
  return out;
}

/// The word after whole steps.
val derive_word(const std::string& json, double steps, double modules) {
  Result<Request> request = read(json, std::floor(steps), modules);
  if (!request) return failed(request.errors());
  const Grammar& grammar = request->grammar;
  Result<Word> word = derive(grammar, static_cast<int>(steps), request->seed, request->limits);
  if (!word) return failed(placed(word.errors(), grammar.text));
  val out = failed({});
  out.set("word", text(grammar, *word)), out.set("modules", static_cast<double>(word->size()));
  return out;
}

/// The drawing seen from the front, as SVG.
val draw_svg(const std::string& json, double steps, double modules) {
  Result<Request> request = read(json, steps, modules);
  if (!request) return failed(request.errors());
  Result<std::string> svg = turtle_svg(request->grammar, steps, request->seed, request->limits);
  if (!svg) return failed(placed(svg.errors(), request->grammar.text));
  val out = failed({});
  out.set("svg", *svg);
  return out;
}

}  // namespace

}  // namespace frond

EMSCRIPTEN_BINDINGS(frond) {
  emscripten::function("draw", &frond::draw_figure);
  emscripten::function("derive", &frond::derive_word);
  emscripten::function("svg", &frond::draw_svg);
}
