#include "organisms/plant/cpfg_plant.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "organisms/describe_grammar.h"

namespace frond {

namespace {

constexpr std::uint64_t kMostModules = 40'000'000;
constexpr Color kFootOfSurfaces{0.75f, 0.8f, 0.5f};

/// `variation`: 0 for the plant that cpfg grows.
Result<CpfgFigure> figure_after(const PlantParams& params, int steps, std::uint64_t variation = 0) {
  const CpfgModel& model = *params.grammar.cpfg;
  CpfgRequest request;
  request.steps = steps;
  request.drawing = true;
  request.variation = variation;
  request.limits.modules =
      static_cast<std::size_t>(std::min<std::uint64_t>(params.grammar.limits.modules, kMostModules));
  Result<CpfgDerived> derived = derive(model, request);
  return derived ? draw(model, derived->drawing) : Result<CpfgFigure>(derived.errors());
}

/// The figure at a share of the film.
Result<CpfgFigure> figure_at(const PlantParams& params, double share, std::uint64_t variation) {
  int last = params.grammar.steps;
  CpfgFilm film = film_of(*params.grammar.cpfg, last);
  double at = film.first + std::clamp(share, 0.0, 1.0) * (last - film.first);
  if (share >= 1 || film.first >= last) return figure_after(params, last, variation);
  int before = film.first + film.step * static_cast<int>(std::floor((at - film.first) / film.step));
  int after = std::min(before + film.step, last);
  Result<CpfgFigure> figure = figure_after(params, before, variation);
  Result<CpfgFigure> next = figure_after(params, after, variation);
  if (!figure || !next) return figure ? next : figure;
  return between(*figure, *next, (at - before) / (after - before));
}

/// The nodes of a figure's segments, one at the end of each.
std::vector<std::int32_t> add_segments(const CpfgFigure& drawn, Figure& figure) {
  constexpr float kThin = 1e-6f;
  Skeleton& skeleton = figure.skeleton;
  std::vector<std::int32_t> nodes;
  auto add = [&](DVec3 at, double radius, std::int32_t below, const CpfgSegment& s) {
    figure.color.push_back(s.color);
    auto depth = static_cast<std::uint16_t>(std::min(s.depth, 65535));
    return skeleton.add(Vec3(at), std::max(static_cast<float>(radius), kThin), below, depth);
  };
  for (const CpfgSegment& s : drawn.segments) {
    std::int32_t below = s.before >= 0 ? nodes[static_cast<std::size_t>(s.before)] : Skeleton::kRoot;
    if (below == Skeleton::kRoot && s.to != s.from) below = add(s.from, s.radius_from, below, s);
    bool longer =
        below != Skeleton::kRoot && skeleton.position[static_cast<std::size_t>(below)] != Vec3(s.to);
    nodes.push_back(longer ? add(s.to, s.radius_to, below, s) : below);
  }
  return nodes;
}

bool is_mirrored(const CpfgPlaced& p) { return p.factors.x * p.factors.y * p.factors.z < 0; }

/// A surface that is not mirrored; two negative factors are a half turn.
Site site_of(const CpfgPlaced& p, std::int32_t node) {
  DVec3 signs = glm::sign(p.factors);
  for (int i = 0; i < 3; ++i)
    if (is_mirrored(p) || signs[i] == 0) signs[i] = 1;
  return {std::string(1, p.surface),
          Vec3(p.position),
          Vec3(p.heading * signs.y),
          Vec3(p.left * signs.x),
          Vec3(-p.up * signs.z),
          Vec3(p.factors),
          p.color,
          node};
}

/// Whether the surface of a name is the model's and not one that the preset gives in its place.
bool has_own_shape(const PlantParams& params, char surface) {
  auto organ = std::ranges::find(params.organs, std::string(1, surface), &OrganParams::symbol);
  return organ != params.organs.end() && organ->with_plant;
}

/// A mirrored surface where it lies. An organ has no negative scale.
Surface laid(const CpfgPlaced& p, Surface surface) {
  if (surface.uv.empty())
    for (const Vec3& at : surface.position) surface.uv.emplace_back(at.x, at.y);
  for (Vec3& at : surface.position) at = Vec3(p.at(DVec3(at)));
  for (Vec3& n : surface.normal) {
    DVec3 turned = DVec3(n) / p.factors;
    n = Vec3(glm::normalize(p.left * turned.x + p.heading * turned.y + p.up * turned.z));
  }
  for (auto& corner : surface.triangle) std::swap(corner[0], corner[1]);
  return surface;
}

Site site_of(const CpfgRound& round, const char* name, std::int32_t node) {
  Site site{name, Vec3(round.center)};
  site.scale = Vec3(static_cast<float>(2 * round.radius));
  site.color = round.color, site.node = node;
  if (glm::length(round.normal) > 0.5) {
    DVec3 across = std::abs(round.normal.x) < 0.9 ? DVec3{1, 0, 0} : DVec3{0, 0, 1};
    site.heading = Vec3(round.normal);
    site.left = Vec3(glm::normalize(glm::cross(across, round.normal)));
    site.up = glm::cross(site.heading, site.left);
  }
  return site;
}

}  // namespace

Errors load_cpfg(const NamedFile& file, PlantGrammar& grammar) {
  Result<CpfgModel> model = read_cpfg(file.path, file.text);
  // What stands in a file that a preset names is not shown.
  if (!model) return {Error{"", "cannot be read; `frond derive` of that file says why"}};
  if (std::optional<Error> missing = missing_shapes(*model))
    return {Error{"", "cannot be drawn; `frond turtle` of that file says why"}};
  if (file.noted) file.noted->insert(file.noted->end(), model->read.begin(), model->read.end());
  grammar.file.content = model->content;
  grammar.steps = film_of(*model, model->steps).last;
  grammar.cpfg = std::make_shared<const CpfgModel>(std::move(*model));
  return {};
}

void use_model_colors(PlantParams& params) {
  if (!params.grammar.cpfg) return;
  params.bark.kind = BarkKind::stem;
  params.bark.colors = params.blades.colors = colors_of(*params.grammar.cpfg);
}

void use_model_surfaces(PlantParams& params) {
  if (!params.grammar.cpfg) return;
  for (const auto& [name, mesh] : surfaces_of(*params.grammar.cpfg)) {
    std::string symbol(1, name);
    if (std::ranges::find(params.organs, symbol, &OrganParams::symbol) != params.organs.end()) continue;
    OrganParams organ;
    organ.symbol = symbol;
    organ.shape = OrganShape::obj;
    organ.mesh = mesh;
    // An organ's x lies against the turtle's left, its z against cpfg's up.
    for (std::vector<Vec3>* list : {&organ.mesh.position, &organ.mesh.normal})
      for (Vec3& v : *list) v = Vec3(-v.x, v.y, -v.z);
    organ.size = 1, organ.size_variation = 0, organ.turn_variation = 0;
    organ.with_plant = true;
    organ.colors = colors_of(*params.grammar.cpfg);
    organ.second = kFootOfSurfaces;
    params.organs.push_back(std::move(organ));
  }
}

Errors cpfg_faults(const PlantParams& params) {
  GrammarText plain;
  plain.file = params.grammar.file, plain.steps = params.grammar.steps, plain.limits = params.grammar.limits;
  GrammarText given = params.grammar;
  if (!(keys_of(plain) == keys_of(given)))
    return {{"/grammar",
             "a model of cpfg has all else in its own files; expected `file`, `steps`, `limits` and `vary` "
             "alone"}};
  std::map<char, Surface> surfaces = surfaces_of(*params.grammar.cpfg);
  for (std::size_t i = 0; i < params.organs.size(); ++i) {
    const std::string& symbol = params.organs[i].symbol;
    if (symbol.size() != 1 || !surfaces.contains(symbol[0]))
      return {{"/organs/" + std::to_string(i) + "/symbol",
               "the view of the model has no surface \"" + symbol + '"'}};
  }
  Result<CpfgFigure> figure = figure_after(params, params.grammar.steps);
  if (!figure) return {{"/grammar/steps", figure.errors()[0].what}};
  return {};
}

Result<DrawnPlant> draw_cpfg(const PlantParams& params, Seed seed, double share) {
  Result<CpfgFigure> drawn = figure_at(params, share, params.grammar.vary ? seed.bits() : 0);
  if (!drawn) return drawn.errors();
  DrawnPlant plant;
  Figure& figure = plant.figure;
  std::vector<std::int32_t> nodes = add_segments(*drawn, figure);
  auto node = [&](std::int32_t segment) {
    return segment < 0 ? Skeleton::kRoot : nodes[static_cast<std::size_t>(segment)];
  };
  for (const CpfgPolygon& polygon : drawn->polygons) {
    Outline outline{{}, polygon.color, node(polygon.segment), figure.outlines.size()};
    for (DVec3 p : polygon.points) outline.points.emplace_back(p);
    figure.outlines.push_back(std::move(outline));
  }
  for (CpfgSkin& skin : drawn->skins)
    plant.skins.push_back({std::move(skin.mesh), skin.color, node(skin.segment), Vec3(skin.foot)});
  for (const CpfgPlaced& p : drawn->placed) {
    auto surface = drawn->surfaces.find(p.surface);
    if (is_mirrored(p) && has_own_shape(params, p.surface) && surface != drawn->surfaces.end())
      plant.skins.push_back({laid(p, surface->second), p.color, node(p.segment), Vec3(p.position)});
    else
      figure.sites.push_back(site_of(p, node(p.segment)));
  }
  for (const CpfgRound& sphere : drawn->spheres)
    figure.sites.push_back(site_of(sphere, "@O", node(sphere.segment)));
  for (const CpfgRound& disc : drawn->discs) figure.sites.push_back(site_of(disc, "@o", node(disc.segment)));
  for (std::size_t i = 0; i < figure.sites.size(); ++i) figure.sites[i].id = i;
  plant.box = {Vec3(drawn->low), Vec3(drawn->high)};
  return plant;
}

Result<SizeEstimate> cpfg_size(const PlantParams& params) {
  Result<CpfgFigure> figure = figure_after(params, params.grammar.steps);
  if (!figure) return figure.errors();
  SizeEstimate plant;
  auto segments = static_cast<double>(figure->segments.size());
  plant.word.modules = plant.word.work = plant.word.segments = segments;
  plant.word.bytes = 100 * segments;
  plant.nodes = 1 + segments * params.smoothing;
  plant.organs = plant.parts =
      static_cast<double>(figure->placed.size() + figure->spheres.size() + figure->discs.size());
  for (const CpfgPolygon& polygon : figure->polygons)
    plant.corners += static_cast<double>(polygon.points.size());
  for (const CpfgSkin& skin : figure->skins) plant.corners += static_cast<double>(skin.mesh.position.size());
  for (const auto& [name, mesh] : figure->surfaces) plant.shapes += static_cast<double>(mesh.triangle.size());
  return plant;
}

}  // namespace frond
