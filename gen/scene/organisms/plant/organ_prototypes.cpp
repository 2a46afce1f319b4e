#include "organisms/plant/organ_prototypes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "foliage/dew.h"
#include "organisms/plant/flower_organ.h"
#include "organisms/plant/organ_mesh.h"

namespace frond {

namespace {

BladeShape leaf_shape(const OrganParams& p) {
  return {.width = p.width,
          .widest = p.widest.value_or(0.4),
          .fold = p.fold,
          .bend = p.bend,
          .wave = p.wave,
          .detail = p.detail,
          .round = p.round.value_or(0)};
}

BladeShape petal_shape(const OrganParams& p) {
  return {.width = p.width,
          .widest = p.widest.value_or(0.62),
          .fold = p.fold * 0.5,
          .bend = p.bend,
          .stalk = 0,
          .wave = p.wave,
          .detail = p.detail,
          .round = p.round.value_or(p.shape == OrganShape::flower ? 0.85 : 0)};
}

void resize(Surface& surface, float factor, Vec3 shift) {
  for (Vec3& p : surface.position) p = p * factor + shift;
}

/// Petals, a heart and green sepals behind.
void add_flower(Prototype& flower, const OrganParams& p) {
  constexpr double kFlatness = 0.45,
                   kLargeHeart = 0.3;  // of hearts; the size from which they have more florets
  constexpr int kFlorets = 40, kManyFlorets = 160;
  constexpr float kHeartUp = 0.03f;  // of its size
  Surface petals = corolla_surface(petal_shape(p), p.petals, p.open);
  float heart = static_cast<float>(p.heart);
  resize(petals, 0.5f, Vec3(0));
  flower.parts.push_back({Tissue::petal, std::move(petals)});
  if (p.heart > 0) {
    Surface dome = heart_surface(0.5 * p.heart, kFlatness, p.heart > kLargeHeart ? kManyFlorets : kFlorets);
    resize(dome, 1, Vec3(0, kHeartUp * heart, 0));
    flower.parts.push_back({Tissue::heart, std::move(dome)});
  }
}

void add_bud(Prototype& bud, const OrganParams& p) {
  constexpr double kWidestLow = 0.75, kPointed = 0.3;  // power of the height; how much narrower the tip is
  constexpr float kCalyxWider = 1.12f, kCalyxHeight = 0.36f;
  std::array<float, 9> profile;
  for (int i = 0; i < 9; ++i) {
    double t = i / 8.0;
    profile[static_cast<std::size_t>(i)] =
        static_cast<float>(0.5 * p.width * std::sin(kPi * std::pow(t, kWidestLow)) * (1 - kPointed * t));
  }
  profile.front() = profile.back() = 0;
  bud.parts.push_back({Tissue::petal, turned_surface(profile, 12)});
  for (float& r : profile) r *= kCalyxWider;
  std::array<float, 4> calyx{0, profile[1], profile[2], profile[3]};
  Surface cup = turned_surface(calyx, 12);
  for (Vec3& v : cup.position) v.y *= kCalyxHeight;
  set_normals(cup);
  bud.parts.push_back({Tissue::heart, std::move(cup)});
}

FrondShape frond_shape(const OrganParams& p) {
  FrondShape shape;
  if (p.leaflets > 0) shape.pairs = p.leaflets;
  shape.width = p.width;
  shape.fold = p.fold;
  shape.bend = p.bend;
  shape.droop = p.droop;
  shape.lobes = p.lobes;
  return shape;
}

TwigShape sprig_shape(const OrganParams& p) {
  TwigShape shape;
  shape.leaf = leaf_shape(p);
  if (p.leaflets > 0) shape.leaves = p.leaflets;
  return shape;
}

Seed variant_seed(const OrganParams& p, int variant) {
  return Seed{0}.child(p.symbol, static_cast<std::uint64_t>(variant));
}

int variant_count(const OrganParams& p) {
  if (p.shape == OrganShape::inflorescence) return 0;
  if (p.diagram) return piece_count(*p.diagram) * stage_count(*p.diagram);
  bool curled = p.picture && p.picture->curl > 0;
  bool grown = p.shape == OrganShape::sprig || p.shape == OrganShape::frond || p.shape == OrganShape::grammar;
  return grown || curled ? p.variants : 1;
}

/// Leaves and the stem that bears them, where there are any.
void add_twig(Prototype& to, TwigParts parts, Tissue stem) {
  if (!parts.blades.position.empty()) to.parts.push_back({Tissue::leaf, std::move(parts.blades)});
  if (!parts.stem.position.empty()) to.parts.push_back({stem, std::move(parts.stem)});
}

Prototype prototype(const OrganParams& p, const std::optional<Seasons>& season, Seed seed) {
  Prototype made{p.symbol, {}, p.colors, p.second};
  switch (p.shape) {
    case OrganShape::leaf:
      made.parts.push_back({Tissue::leaf, blade_surface(leaf_shape(p))});
      break;
    case OrganShape::petal:
      made.parts.push_back({Tissue::petal, blade_surface(petal_shape(p))});
      break;
    case OrganShape::flower:
      add_flower(made, p);
      break;
    case OrganShape::bud:
      add_bud(made, p);
      break;
    case OrganShape::sprig:
      add_twig(made, sprig_foliage(sprig_shape(p), seed), Tissue::skin);
      break;
    case OrganShape::frond:
      add_twig(made, frond_foliage(frond_shape(p), seed), Tissue::heart);
      break;
    case OrganShape::grammar:
      if (Result<TwigParts> parts = drawn_foliage(p, seed); parts)
        add_twig(made, std::move(*parts), Tissue::heart);
      break;
    case OrganShape::obj:
      add_organ_mesh(made, p);
      break;
    case OrganShape::picture:
      if (p.picture)
        made = leaf_prototype(season ? with_seasons(*p.picture, *season) : *p.picture, 2 * kPi * seed.unit());
      made.name = p.symbol;
      break;
    case OrganShape::diagram:
    case OrganShape::inflorescence:
      break;
    case OrganShape::berry:
    case OrganShape::ball: {
      Surface ball = ball_surface();
      float middle = p.shape == OrganShape::berry ? 0.5f : 0.0f, width = static_cast<float>(p.width);
      for (std::size_t i = 0; i < ball.position.size(); ++i) {
        ball.position[i] =
            Vec3(ball.position[i].x * width, ball.position[i].y + middle, ball.position[i].z * width);
        ball.normal[i] = glm::normalize(ball.normal[i] * Vec3(1, width, 1));
      }
      made.parts.push_back({Tissue::fruit, std::move(ball)});
    }
  }
  if (p.luster) made.luster = p.luster;
  if (p.dew > 0)
    made.parts.push_back({Tissue::dew, dew_surface(made.parts[0].surface, p.size, p.dew, seed.child("dew"))});
  return made;
}

}  // namespace

Errors organ_faults(const OrganParams& organ) {
  for (int i = 0; organ.grammar && i < variant_count(organ); ++i)
    if (Result<TwigParts> parts = drawn_foliage(organ, variant_seed(organ, i)); !parts) return parts.errors();
  return {};
}

std::vector<Prototype> organ_prototypes(const PlantParams& params) {
  std::vector<Prototype> list;
  for (const OrganParams& organ : params.organs) {
    if (organ.diagram) {
      std::ranges::move(flower_stages(organ), std::back_inserter(list));
      continue;
    }
    for (int i = 0; i < variant_count(organ); ++i)
      list.push_back(prototype(organ, params.season, variant_seed(organ, i)));
  }
  if (params.season)
    for (Prototype& organ : list) add_seasons(organ, *params.season);
  list.push_back({"@O", {{Tissue::skin, ball_surface()}}, params.bark.colors, params.bark.second});
  constexpr float kDiscThickness = 0.02f;
  std::array<float, 3> disc{0, 0.5f, 0};
  Surface flat = turned_surface(disc, 20);
  for (Vec3& p : flat.position) p.y = (p.y - 0.5f) * kDiscThickness;
  set_normals(flat);
  list.push_back({"@o", {{Tissue::skin, std::move(flat)}}, params.bark.colors, params.bark.second});
  if (params.season) add_seasonal(list, *params.season);
  return list;
}

Variants variants_of(const PlantParams& params, std::string_view symbol) {
  int first = 0, organ = 0;
  for (const OrganParams& p : params.organs) {
    if (p.symbol == symbol && p.diagram)
      return {organ, first, stage_count(*p.diagram), piece_count(*p.diagram)};
    if (p.symbol == symbol) return {organ, first, variant_count(p)};
    first += variant_count(p), ++organ;
  }
  if (symbol == "@O") return {-1, first, 1};
  return {-1, symbol == "@o" ? first + 1 : -1, 1};
}

std::vector<int> prototypes_at(const PlantParams& params, const Variants& variants, double stage) {
  if (variants.count == 0) return {};
  if (variants.pieces == 0) return {variants.first};
  int at = stage_index(*params.organs[static_cast<std::size_t>(variants.organ)].diagram, stage);
  std::vector<int> all;
  for (int k = 0; k < variants.pieces; ++k) all.push_back(variants.first + k * variants.count + at);
  return all;
}

}  // namespace frond
