#include "organisms/plant/plant.h"

#include <algorithm>

#include "core/bounds.h"
#include "geometry/outline.h"
#include "geometry/smooth.h"
#include "grammar/figure.h"
#include "grammar/review.h"
#include "organisms/plant/cpfg_plant.h"
#include "organisms/plant/flower_organ.h"
#include "organisms/plant/organ_prototypes.h"

namespace frond {

namespace {

/// The box of all that is drawn.
Bounds box_of(const Figure& f) {
  Bounds box = bounds_of(f.skeleton.position);
  for (const Outline& o : f.outlines)
    for (const Vec3& p : o.points) box.extend(p);
  for (const Site& s : f.sites) box.extend(s.position);
  return box.empty() ? Bounds{Vec3(0), Vec3(0)} : box;
}

/// How a plant is scaled and moved to its height and stand, and how long its branches are before that.
struct Stature {
  float factor = 1;
  Vec3 foot{0};
  float longest = 0;
  float start_radius = 0;
};

Stature stature_of(const DrawnPlant& plant, const PlantParams& params) {
  const Bounds& box = plant.box;
  float high = params.origin == PlantOrigin::turtle ? box.high.y : box.size().y;
  float factor = params.height > 0 && high > 0 ? static_cast<float>(params.height) / high : 1.0f;
  Vec3 foot = params.origin == PlantOrigin::turtle ? Vec3(0) : box.foot();
  const Skeleton& s = plant.figure.skeleton;
  float start = s.size() > 0 ? s.radius[0] : static_cast<float>(params.grammar.width / 2);
  return {factor, foot, s.longest(), std::max(start * factor, 1e-6f)};
}

void fit(DrawnPlant& plant, const Stature& stature) {
  Figure& f = plant.figure;
  auto move = [&](Vec3& p) { p = (p - stature.foot) * stature.factor; };
  for (Vec3& p : f.skeleton.position) move(p);
  for (float& radius : f.skeleton.radius) radius *= stature.factor;
  for (Outline& o : f.outlines)
    for (Vec3& p : o.points) move(p);
  for (Site& s : f.sites) move(s.position);
  for (DrawnSkin& skin : plant.skins) {
    for (Vec3& p : skin.surface.position) move(p);
    move(skin.foot);
  }
}

/// Colours of the smoothed nodes, from those of the nodes as they were drawn: those of a segment are that of
/// its end. Empty where all are 0.
std::vector<std::int32_t> smoothed_colors(const std::vector<std::int32_t>& drawn,
                                          const std::vector<std::int32_t>& order,
                                          const std::vector<std::int32_t>& index) {
  if (std::all_of(drawn.begin(), drawn.end(), [](std::int32_t c) { return c == 0; })) return {};
  std::vector<std::int32_t> color(order.size()), fine;
  for (std::size_t i = 0; i < order.size(); ++i) color[static_cast<std::size_t>(order[i])] = drawn[i];
  fine.reserve(static_cast<std::size_t>(index.back()) + 1);
  for (std::size_t i = 0; i < index.size(); ++i)
    fine.resize(static_cast<std::size_t>(index[i]) + 1, color[i]);
  return fine;
}

float birth_at(const Skeleton& s, std::int32_t node, std::size_t i, std::size_t count) {
  if (node != Skeleton::kRoot) return s.birth[node];
  return count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 0.0f;
}

/// The outlines as blades that ride on the skeleton's nodes.
void add_blades(Model& model, const std::vector<Outline>& outlines) {
  Blades& b = model.blades;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Outline& outline = outlines[i];
    // The foot is where the outline starts; the leaf points to its farthest corner.
    Vec3 foot = outline.points[0];
    if (outline.node != Skeleton::kRoot) {
      Vec3 base = model.skeleton.position[outline.node];
      foot = *std::min_element(outline.points.begin(), outline.points.end(), [&](Vec3 p, Vec3 q) {
        return glm::distance(p, base) < glm::distance(q, base);
      });
    }
    add_outline(b.surface, outline.points, foot);
    if (b.surface.position.size() == b.first.back()) continue;
    b.first.push_back(static_cast<std::uint32_t>(b.surface.position.size()));
    b.node.push_back(outline.node);
    b.birth.push_back(birth_at(model.skeleton, outline.node, i, outlines.size()));
    b.color.push_back(outline.color);
    b.id.push_back(static_cast<std::uint32_t>(outline.id));
    b.foot.push_back(foot);
  }
}

/// The skins of generalized cylinders as blades.
void add_skins(Model& model, const std::vector<DrawnSkin>& skins) {
  Blades& b = model.blades;
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const DrawnSkin& skin = skins[i];
    append(b.surface, skin.surface);
    b.first.push_back(static_cast<std::uint32_t>(b.surface.position.size()));
    b.node.push_back(skin.node);
    b.birth.push_back(birth_at(model.skeleton, skin.node, i, skins.size()));
    b.color.push_back(skin.color);
    b.id.push_back(static_cast<std::uint32_t>(b.id.size()));
    b.foot.push_back(skin.foot);
  }
}

std::string missing_organ(const std::string& name) {
  return "the grammar places an organ \"" + name + "\"; organs has none with that symbol";
}

Errors add_organs(Model& model, const std::vector<Site>& sites, const PlantParams& params, float factor,
                  Seed seed) {
  Organs& o = model.organs;
  o.reserve(sites.size());
  // Leaves as pictures are of all their colours where the grammar has no word about colours.
  bool drawn = std::any_of(sites.begin(), sites.end(), [](const Site& site) { return site.color != 0; });
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Site& site = sites[i];
    std::int32_t color = site.color;
    bool round = site.name == "@O" || site.name == "@o";
    Variants kinds = variants_of(params, site.name);
    if (kinds.first < 0) return {{"", missing_organ(site.name)}};
    Seed own = seed.child(site.id);
    Vec3 scale = site.scale;
    Quat turn = glm::normalize(glm::quat_cast(glm::mat3(-site.left, site.heading, site.up)));
    if (round) {
      scale *= factor;
    } else {
      const OrganParams& organ = params.organs[static_cast<std::size_t>(kinds.organ)];
      if (organ.with_plant) scale *= factor;
      scale *= static_cast<float>(organ.size * (1 + organ.size_variation * own.child(0).range(-1, 1)));
      double most = organ.turn_variation;
      turn = turn * glm::angleAxis(static_cast<float>(most * own.child(1).range(-1, 1)), Vec3(1, 0, 0)) *
             glm::angleAxis(static_cast<float>(most * own.child(2).range(-1, 1)), Vec3(0, 1, 0)) *
             glm::angleAxis(static_cast<float>(most * own.child(3).range(-1, 1)), Vec3(0, 0, 1));
      if (organ.picture && !drawn)
        color = static_cast<std::int32_t>(own.child(5).bits() % organ.picture->colors.size());
    }
    auto pick = kinds.pieces > 0
                    ? 0
                    : static_cast<int>(own.child(4).bits() % static_cast<std::uint64_t>(kinds.count));
    for (int which : prototypes_at(params, kinds, site.stage)) {
      auto number = static_cast<std::size_t>(which + pick);
      if (model.prototypes[number].parts.empty()) continue;  // petals that have fallen
      o.prototype.push_back(static_cast<std::uint16_t>(number));
      o.position.push_back(site.position);
      o.turn.push_back(glm::normalize(turn));
      o.scale.push_back(glm::max(glm::abs(scale), Vec3(1e-5f)));
      o.node.push_back(site.node);
      o.birth.push_back(birth_at(model.skeleton, site.node, i, sites.size()));
      o.color.push_back(color);
      o.id.push_back(static_cast<std::uint32_t>(site.id));
    }
  }
  return {};
}

/// The organs that a `~` in the modules names and the plant has not.
void find_missing_organs(const Grammar& grammar, std::span<const SymbolId> modules, const std::string& where,
                         const PlantParams& params, Errors& errors) {
  for (std::size_t i = 0; i + 1 < modules.size(); ++i) {
    if (grammar.symbols[modules[i]].act != Act::organ) continue;
    const std::string& name = grammar.symbols[modules[i + 1]].name;
    if (variants_of(params, name).first < 0) errors.push_back({where, missing_organ(name)});
  }
}

/// What a plant's grammar draws at a share of its steps.
Result<DrawnPlant> drawn_plant(const PlantParams& params, Seed seed, double share,
                               const Environment& environment) {
  if (params.grammar.cpfg) return draw_cpfg(params, seed.child("derive"), share);
  Result<Grammar> grammar = plant_grammar(params);
  if (!grammar) return grammar.errors();
  grammar->environment = environment;
  const GrammarText& text = grammar->text;
  Result<Figure> figure = figure_of(*grammar, text.growth() * share, seed.child("derive"), text.limits,
                                    text.organs, params.by_steps);
  if (!figure) return placed(figure.errors(), text);
  Bounds box = box_of(*figure);
  return DrawnPlant{std::move(*figure), {}, box};
}

}  // namespace

Result<Grammar> plant_grammar(const PlantParams& params) {
  GrammarText text = params.grammar;
  for (const OrganParams& organ : params.organs) text.organs.push_back(organ.symbol);
  Result<Grammar> grammar = compile(text);
  if (!grammar) return grammar;
  Errors errors;
  for (const OrganParams& organ : params.organs) {
    bool known = std::any_of(grammar->symbols.begin(), grammar->symbols.end(),
                             [&](const Symbol& symbol) { return symbol.name == organ.symbol; });
    if (!known && !borne_by_others(params.organs, organ.symbol))
      errors.push_back({"", "the grammar has no symbol \"" + organ.symbol + "\" for an organ to stand at"});
  }
  find_missing_organs(*grammar, grammar->axiom.symbols, "axiom", params, errors);
  for (const RuleSet* set : {&grammar->rules, &grammar->decomposition, &grammar->interpretation})
    for (const Production& rule : set->rules)
      find_missing_organs(*grammar, rule.successor, rule.where, params, errors);
  if (!errors.empty()) return errors;
  return grammar;
}

Result<Model> grow_plant(const PlantParams& params, Seed seed, double share, const Environment& environment) {
  Result<DrawnPlant> plant = drawn_plant(params, seed, 1, environment);
  if (!plant) return plant.errors();
  Figure* figure = &plant->figure;
  const std::string& where = params.grammar.where;
  if (figure->skeleton.size() == 0 && figure->sites.empty() && figure->outlines.empty() &&
      plant->skins.empty())
    return Error{where, "the grammar draws nothing: its turtle meets no F, no outline and no organ"};

  Stature stature = stature_of(*plant, params);
  Girth girth = params.thickness;
  if (share < 1) {
    plant = drawn_plant(params, seed, share, environment);
    if (!plant) return plant.errors();
    figure = &plant->figure;
    // What is still short is thin.
    if (girth.from != GirthFrom::turtle && stature.longest > 0)
      girth.radius = (girth.radius > 0 ? girth.radius : stature.start_radius) *
                     std::min(1.0f, figure->skeleton.longest() / stature.longest);
  }
  fit(*plant, stature);
  std::vector<Prototype> prototypes = organ_prototypes(params);
  if (Errors errors = expand_inflorescences(*figure, params, prototypes, seed.child("organ"));
      !errors.empty())
    return errors;
  if (Errors errors = check_places(*figure); !errors.empty()) return placed(errors, params.grammar);
  Model model;
  {
    std::vector<std::int32_t> order = order_branches(figure->skeleton);
    std::vector<std::int32_t> index = smoothed_index(figure->skeleton, params.smoothing);
    auto moved = [&](std::int32_t& node) {
      if (node != Skeleton::kRoot)
        node = index[static_cast<std::size_t>(order[static_cast<std::size_t>(node)])];
    };
    for (Outline& outline : figure->outlines) moved(outline.node);
    for (Site& site : figure->sites) moved(site.node);
    for (DrawnSkin& skin : plant->skins) moved(skin.node);
    model.color = smoothed_colors(figure->color, order, index);
  }
  // Large plants fill the memory: nothing is kept that is not needed any more.
  std::vector<std::int32_t>().swap(figure->color);
  set_distances(figure->skeleton);
  model.skeleton =
      params.smoothing == 1 ? std::move(figure->skeleton) : smooth(figure->skeleton, params.smoothing);
  figure->skeleton = {};
  set_tip_distances(model.skeleton);
  set_births(model.skeleton);
  set_girth(model.skeleton, girth, stature.start_radius, params.by_steps);
  add_blades(model, figure->outlines);
  add_skins(model, plant->skins);
  std::vector<Outline>().swap(figure->outlines);
  model.prototypes = std::move(prototypes);
  if (Errors errors = add_organs(model, figure->sites, params, stature.factor, seed.child("organ"));
      !errors.empty())
    return placed(errors, params.grammar);
  return model;
}

}  // namespace frond
