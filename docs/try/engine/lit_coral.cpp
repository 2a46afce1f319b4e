#include "try/engine/lit_coral.h"

#include <algorithm>
#include <cmath>

#include "accretion/openness.h"
#include "appearance/skin_colors.h"
#include "core/bounds.h"
#include "core/linear.h"
#include "try/engine/answers.h"
#include "try/engine/lit_tree.h"

namespace frond {

namespace {

constexpr float kCells = 56;         // of the grid of light along the largest coral
constexpr float kAboveLight = 0.6f;  // the share of light that comes from above
constexpr float kRipe = 0.2f;        // of the growth, after which a branch is as thick as it comes to be
constexpr float kYoung = 0.16f;      // of the growth, in which skin is pale

/// What a coral leaves open of the light around it.
class Open {
 public:
  Open(const Bounds& box, float cell) : grid_(box.low, box.high, cell) {}

  void add_surface(const Surface& surface) {
    for (const auto& [a, b, c] : surface.triangle) {
      Vec3 p = surface.position[a], q = surface.position[b], r = surface.position[c];
      grid_.add((p + q + r) / 3.0f, glm::length(glm::cross(q - p, r - p)) / 2);
    }
  }
  void add_segment(Vec3 from, Vec3 to, float radius) {
    // As wide as it is seen.
    grid_.add((from + to) * 0.5f, 2 * radius * glm::distance(from, to));
  }
  void build() { grid_.build(); }

  float at(Vec3 place, Vec3 normal) const {
    return std::clamp(grid_.openness(place, normal, kAboveLight), 0.0f, 1.0f);
  }

 private:
  Openness grid_;
};

/// The skin of one body; youth is 1 where it has just grown.
void put_body(LitCoral& lit, const Surface& body, float grown, const Open& open, bool valleys) {
  auto first = static_cast<std::uint32_t>(lit.places.size() / 3);
  for (std::size_t v = 0; v < body.position.size(); ++v) {
    put(lit.places, body.position[v]), put(lit.normals, body.normal[v]);
    Vec2 uv = body.uv.empty() ? Vec2(1, 0) : body.uv[v];
    float ridge = valleys ? uv.x : 1, youth = valleys ? 0 : smooth_step(grown - kYoung, grown, uv.y);
    put(lit.skin, {ridge, youth, open.at(body.position[v], body.normal[v])});
  }
  for (const auto& triangle : body.triangle)
    for (std::uint32_t corner : triangle) lit.corners.push_back(first + corner);
}

/// A piece of a branch that is there by then.
struct Twig {
  std::size_t node, below;
  Vec3 tip;
  float at_foot, at_tip;  // radii
};

std::vector<Twig> twigs_of(const Skeleton& s, float grown) {
  std::vector<Twig> twigs;
  auto radius = [&](std::size_t i) {
    return s.radius[i] * (grown >= 1 ? 1 : smooth_step(0.0f, kRipe, grown - s.birth[i] + 0.02f));
  };
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto below = static_cast<std::size_t>(s.parent[i]);
    if (grown < 1 && s.birth[below] >= grown) continue;
    float way = s.birth[i] - s.birth[below];
    float share = grown >= 1 || way <= 0 ? 1 : std::min(1.0f, (grown - s.birth[below]) / way);
    twigs.push_back({i, below, glm::mix(s.position[below], s.position[i], share), radius(below), radius(i)});
  }
  return twigs;
}

void put_twigs(LitCoral& lit, const Skeleton& s, const std::vector<Twig>& twigs, const Skin& skin,
               const Open& open) {
  Color old = srgb(old_skin(skin).tissue), young = srgb(young_skin(skin).tissue);
  auto fades = static_cast<float>(std::max(skin.tint.young_length, 1e-4));
  for (const Twig& twig : twigs) {
    Vec3 foot = s.position[twig.below];
    put(lit.segments, foot), lit.segments.push_back(twig.at_foot);
    put(lit.segments, twig.tip), lit.segments.push_back(twig.at_tip);
    put_color(lit.segments, mixed(young, old, std::min(1.0f, s.to_tip[twig.node] / fades)));
    lit.segments.push_back(1), lit.segments.push_back(open.at(twig.tip, Vec3(0, 1, 0)));
  }
}

}  // namespace

LitCoral lit_coral(const Model& model, const Look& look, float grown) {
  LitCoral lit;
  Bounds whole = bounds_of(model);
  float extent = std::max({whole.size().x, whole.size().y, whole.size().z, 0.02f});
  lit.ground_half = 2.2f * extent;
  Solids bodies = grown_to(model.solids, grown);
  std::vector<Twig> twigs = twigs_of(model.skeleton, grown);

  Bounds box{whole.low - 0.6f * extent, whole.high + 0.6f * extent};
  Open open(box, extent / kCells);
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Surface body = bodies.shapes[bodies.shape[i]].surface;
    for (Vec3& at : body.position) at = bodies.placed(i, at);
    open.add_surface(body);
    surfaces.push_back(std::move(body));
  }
  for (const Twig& twig : twigs)
    open.add_segment(model.skeleton.position[twig.below], twig.tip, twig.at_foot);
  open.build();

  for (std::size_t i = 0; i < surfaces.size(); ++i)
    put_body(lit, surfaces[i], grown, open,
             bodies.shapes[bodies.shape[i]].material.matter == Matter::meander);
  if (look.branches.skin) put_twigs(lit, model.skeleton, twigs, *look.branches.skin, open);
  for (int row = 0; row < kGroundSide; ++row)
    for (int column = 0; column < kGroundSide; ++column) {
      auto along = [&](int k) {
        return lit.ground_half * (2.0f * static_cast<float>(k) / (kGroundSide - 1) - 1);
      };
      float light = open.at(Vec3(along(column), 0, along(row)), Vec3(0, 1, 0));
      lit.ground.push_back(light), lit.ground.push_back(light);
    }
  return lit;
}

}  // namespace frond
