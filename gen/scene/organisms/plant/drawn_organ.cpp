
#include <algorithm>
#include <cmath>

#include "core/figures.h"
#include "geometry/girth.h"
#include "geometry/outline.h"
#include "geometry/smooth.h"
#include "geometry/tubes.h"
#include "grammar/figure.h"
#include "grammar/forecast.h"
#include "organisms/plant/organ_prototypes.h"

namespace frond {

namespace {

/// Limits of the word of one organ, which is written once for each of its variants.
constexpr Limits kMost{200'000, std::size_t{64} << 20};

/// A leaflet as the turtle draws it.
struct DrawnLeaflet {
  std::int32_t node;  ///< of the stem
  Vec3 reach;         ///< from there to its tip
};

/// A figure's branches: what stays of them as a stem, and leaflets.
struct DrawnStem {
  Skeleton skeleton;
  std::vector<std::vector<DrawnLeaflet>> leaflets;  ///< of each node
};

DrawnStem stem_of(const Skeleton& drawn) {
  std::vector<bool> forks(drawn.size());
  for (std::int32_t below : drawn.parent)
    if (below != Skeleton::kRoot) forks[static_cast<std::size_t>(below)] = true;
  DrawnStem stem;
  std::vector<std::int32_t> index(drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    std::int32_t p = drawn.parent[i];
    if (p != Skeleton::kRoot && !forks[i] && drawn.order[i] > drawn.order[p]) {
      std::int32_t node = index[static_cast<std::size_t>(p)];
      stem.leaflets[static_cast<std::size_t>(node)].push_back({node, drawn.position[i] - drawn.position[p]});
      continue;
    }
    std::int32_t below = p == Skeleton::kRoot ? p : index[static_cast<std::size_t>(p)];
    index[i] = stem.skeleton.add(drawn.position[i], drawn.radius[i], below, drawn.order[i]);
    stem.leaflets.emplace_back();
  }
  return stem;
}

/// Axes at a node of a stem: across, along it, and its upper side.
using StemAxes = glm::mat3;

/// The axes at each node: those of the organ at its foot, carried along without a twist.
std::vector<StemAxes> axes_of(const Skeleton& stem) {
  std::vector<StemAxes> axes(stem.size(), StemAxes(1));
  for (std::size_t i = 0; i < stem.size(); ++i) {
    std::int32_t p = stem.parent[i];
    if (p == Skeleton::kRoot) continue;
    const StemAxes& below = axes[static_cast<std::size_t>(p)];
    Vec3 along = stem.position[i] - stem.position[p];
    if (!(glm::length(along) > 0)) {
      axes[i] = below;
      continue;
    }
    along = glm::normalize(along);
    bool back = glm::dot(below[1], along) < -0.999f;  // where no rotation is the shortest
    Vec3 up = back ? below[2] : glm::normalize(Quat(below[1], along) * below[2]);
    axes[i] = StemAxes(glm::cross(along, up), along, up);
  }
  return axes;
}

/// A leaflet of that direction and length, in the axes of its place on the stem.
LeafletPlace leaflet_at(Vec3 at, const StemAxes& axes, Vec3 own, const OrganParams& organ, Seed seed) {
  // How much leaflets of one kind differ, to either side: angles, and shares of length and droop.
  constexpr double kFoldVaries = radians(8.0), kTwistVaries = radians(25.0);
  constexpr double kLengthVaries = 0.1, kDroopVaries = 0.35;
  // `fold` raises it about the stem.
  Vec3 out(own.x, 0, own.z);
  if (float aside = glm::length(out); aside > 0) {
    auto fold = static_cast<float>(organ.fold + kFoldVaries * seed.child(0).range(-1, 1));
    Vec3 raised = out / aside * std::cos(fold) + Vec3(0, 0, std::sin(fold));
    own = glm::normalize(raised) * aside + Vec3(0, own.y, 0);
  }
  LeafletPlace place{at, axes * glm::normalize(own), axes[2], glm::length(own)};
  place.length *= static_cast<float>(1 + kLengthVaries * seed.child(1).range(-1, 1));
  place.droop = organ.droop * (1 + kDroopVaries * seed.child(2).range(-1, 1));
  place.twist = kTwistVaries * seed.child(3).range(-1, 1);
  return place;
}

/// `organ.leaflets` for each one that is drawn, spread over the segment before it: they go over from the
/// leaflet there, on the same side, to its own direction and length.
std::vector<LeafletPlace> leaflets_of(const DrawnStem& drawn, const Skeleton& stem, int pieces,
                                      const OrganParams& organ, Seed seed) {
  std::vector<std::int32_t> index = smoothed_index(drawn.skeleton, pieces);
  std::vector<StemAxes> axes = axes_of(stem);
  auto own_of = [&](const DrawnLeaflet& leaflet) {
    return glm::transpose(axes[static_cast<std::size_t>(index[static_cast<std::size_t>(leaflet.node)])]) *
           leaflet.reach;
  };
  std::vector<LeafletPlace> places;
  int count = std::max(1, organ.leaflets);
  for (const std::vector<DrawnLeaflet>& here : drawn.leaflets) {
    for (std::size_t k = 0; k < here.size(); ++k) {
      auto node = static_cast<std::size_t>(here[k].node);
      std::int32_t below = drawn.skeleton.parent[node];
      Vec3 own = own_of(here[k]), from = own;
      if (below != Skeleton::kRoot && k < drawn.leaflets[static_cast<std::size_t>(below)].size())
        from = own_of(drawn.leaflets[static_cast<std::size_t>(below)][k]);
      for (int j = below == Skeleton::kRoot ? count : 1; j <= count; ++j) {
        auto at = static_cast<std::size_t>(index[node] - (count - j) * (pieces / count));
        Vec3 reach = glm::mix(from, own, static_cast<float>(j) / static_cast<float>(count));
        if (glm::length(reach) > 0)
          places.push_back(
              leaflet_at(stem.position[at], axes[at], reach, organ, seed.child("leaflet", places.size())));
      }
    }
  }
  return places;
}

/// The organ one unit long: of its stem or, without one, of its branches.
float length_of(const DrawnStem& drawn, const Figure& figure) {
  float length = drawn.skeleton.longest();
  if (length > 0) return length;
  for (const Vec3& p : figure.skeleton.position) length = std::max(length, glm::length(p));
  for (const Outline& outline : figure.outlines)
    for (const Vec3& p : outline.points) length = std::max(length, glm::length(p));
  return length;
}

Surface tapering_tubes(Skeleton stem) {
  constexpr int kSides = 5;
  set_tip_distances(stem);
  set_girth(stem,
            {.from = GirthFrom::distance, .radius = static_cast<double>(stem.radius[0]), .least = 0.0005},
            stem.radius[0]);
  Surface tubes = closed_tubes(stem, stem.position, stem.radius, 1, kSides).surface;
  tubes.uv.clear();
  return tubes;
}

}  // namespace

Result<TwigParts> drawn_foliage(const OrganParams& organ, Seed seed) {
  Result<Grammar> grammar = compile(*organ.grammar);
  if (!grammar) return grammar.errors();
  const GrammarText& text = grammar->text;
  seed = seed.child("derive", text.seed);
  if (Forecast size = forecast(*grammar, text.steps, seed, kMost); size.passes_at >= 0)
    return error_at("", "draws {} modules or segments by step {}; an organ has {} at most",
                    count_text(size.passes_with), size.passes_at, kMost.modules);
  Result<Figure> figure = figure_of(*grammar, text.growth(), seed, kMost);
  if (!figure) return figure.errors();
  if (!figure->sites.empty())
    return Error{"", "places an organ \"" + figure->sites[0].name + "\"; expected lines and outlines alone"};
  DrawnStem drawn = stem_of(figure->skeleton);
  float length = length_of(drawn, *figure);
  if (!(length > 0)) return Error{"", "draws nothing: its turtle meets no F and no outline"};
  for (Vec3& p : drawn.skeleton.position) p /= length;
  for (float& radius : drawn.skeleton.radius) radius /= length;
  for (std::vector<DrawnLeaflet>& at : drawn.leaflets)
    for (DrawnLeaflet& leaflet : at) leaflet.reach /= length;
  set_distances(drawn.skeleton);

  TwigParts parts;
  int count = std::max(1, organ.leaflets), pieces = count * ((2 + count) / count);  // three or more
  if (drawn.skeleton.size() > 0) {
    Skeleton stem = smooth(drawn.skeleton, pieces);
    parts.blades = leaflets_surface(leaflets_of(drawn, stem, pieces, organ, seed), organ.width, organ.lobes);
    if (stem.size() > 1) parts.stem = tapering_tubes(std::move(stem));
  }
  for (Outline& outline : figure->outlines) {
    for (Vec3& p : outline.points) p /= length;
    add_outline(parts.blades, outline.points, outline.points[0]);
  }
  return parts;
}

}  // namespace frond
