#include "draw/twigs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "draw/organs.h"
#include "geometry/far.h"
#include "geometry/tubes.h"
#include "scene/copy_organs.h"

namespace frond {

namespace {

constexpr double kTinyPixels = 0.6;   // the side of a leaf below which several become one
constexpr double kThinPixels = 0.03;  // radius of wood that is left out
constexpr double kBendPixels = 0.25;  // by how much wood may be away from where it is

template <class T>
std::vector<T> chosen_of(const std::vector<T>& all, const std::vector<std::int32_t>& which) {
  std::vector<T> some;
  some.reserve(all.empty() ? 0 : which.size());
  for (std::size_t k = 0; k < which.size() && !all.empty(); ++k)
    some.push_back(all[static_cast<std::size_t>(which[k])]);
  return some;
}

/// Adds a leaf as a hexagon with the same length and area: its ends and, in each half, what
/// lies farthest to both sides. A diamond would be so broad that the leaves of a sprig cover each other.
void add_hexagon(Surface& out, const Surface& s, const std::vector<std::uint32_t>& vertices, double covered) {
  auto at = [&](std::uint32_t v) { return s.position[v]; };
  auto farthest = [&](Vec3 from) {
    return *std::ranges::max_element(vertices, {},
                                     [&](std::uint32_t v) { return glm::distance(at(v), from); });
  };
  std::uint32_t foot = farthest(at(vertices[0])), tip = farthest(at(foot));
  if (glm::length(at(foot)) > glm::length(at(tip))) std::swap(foot, tip);
  float length = glm::distance(at(foot), at(tip));
  Vec3 axis = direction_or(at(tip) - at(foot), Vec3(0, 1, 0)), facing(0);
  for (std::uint32_t v : vertices) facing += s.normal[v];
  Vec3 side = direction_or(glm::cross(axis, facing), Vec3(1, 0, 0));
  std::array<std::uint32_t, 6> corner{foot, foot, foot, tip, tip, tip};  // to the right and back
  std::array<float, 6> wide{};
  for (std::uint32_t v : vertices) {
    float along = glm::dot(at(v) - at(foot), axis) / length, aside = glm::dot(at(v) - at(foot), side);
    if (along < 0.12f || along > 0.88f) continue;
    std::size_t c = aside > 0 ? (along < 0.5f ? 1 : 2) : (along < 0.5f ? 5 : 4);
    if (std::abs(aside) > wide[c]) wide[c] = std::abs(aside), corner[c] = v;
  }
  std::vector<std::uint32_t> rim;  // half a leaf has no more than a corner or two beside its ends
  for (std::uint32_t v : corner)
    if (std::ranges::find(rim, v) == rim.end()) rim.push_back(v);
  float whole = 0;
  for (std::size_t k = 2; k < rim.size(); ++k)
    whole += 0.5f * glm::length(glm::cross(at(rim[k - 1]) - at(foot), at(rim[k]) - at(foot)));
  float narrower = whole > 0 ? static_cast<float>(covered) / whole : 1;
  auto first = static_cast<std::uint32_t>(out.position.size());
  for (std::uint32_t v : rim) {
    float aside = glm::dot(at(v) - at(foot), side);
    out.position.push_back(at(v) + side * (aside * (narrower - 1)));
    out.normal.push_back(s.normal[v]);
    if (!s.uv.empty()) out.uv.push_back(s.uv[v]);
  }
  for (std::uint32_t k = 2; k < rim.size(); ++k) out.triangle.push_back({first, first + k - 1, first + k});
}

/// A shape whose leaves are hexagons; what has as few triangles stays as it is.
Surface hexagons(const Surface& own) {
  constexpr std::size_t kFew = 4;
  Pieces pieces = pieces_of(own);
  std::vector<std::vector<std::uint32_t>> vertices(pieces.count);
  std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles(pieces.count);
  for (std::uint32_t v = 0; v < own.position.size(); ++v) vertices[pieces.of[v]].push_back(v);
  for (const auto& t : own.triangle) triangles[pieces.of[t[0]]].push_back(t);
  Surface out;
  for (std::size_t k = 0; k < pieces.count; ++k) {
    Surface piece = with_corners_of(own, std::vector(triangles[k]));
    piece.paint.clear();
    if (triangles[k].size() <= kFew)
      append(out, piece);
    else
      add_hexagon(out, own, vertices[k], area(piece));
  }
  return out;
}

Surface coarse(const OrganPart& part) {
  constexpr std::size_t kBody = 24;  // triangles of what is no leaf
  return is_leaf(part.tissue) ? hexagons(part.surface) : reduced(part.surface, kBody);
}

/// What a twig of the palette is made of at a time, at its joint and without the turn of its first node.
class TwigMaker {
 public:
  TwigMaker(const TwigPlan& plan, const Specimen& plant, const Pose& pose, double time)
      : plan_(plan), plant_(plant), pose_(pose), time_(time) {}

  std::vector<TwigPart> parts(const TwigPlan::Kept& kept) const {
    std::vector<TwigPart> parts;
    if (Surface wood = wood_of(kept); !wood.triangle.empty())
      parts.push_back({CopyPart::Kind::wood, 0, 0, std::move(wood)});
    Model bearing = organs_of(kept);
    for (std::size_t p = 0; p < bearing.prototypes.size(); ++p) {
      std::vector<Surface> merged = merged_of(bearing, p);
      for (std::size_t k = 0; k < merged.size(); ++k)
        if (!merged[k].triangle.empty()) parts.push_back({CopyPart::Kind::organ, p, k, std::move(merged[k])});
    }
    return parts;
  }

 private:
  Vec3 at_joint(const TwigPlan::Kept& kept, Vec3 at) const {
    auto node = static_cast<std::size_t>(kept.node);
    return glm::conjugate(pose_.turn[node]) *
           (at - pose_.position[joint_of(plant_.model.skeleton, kept.node)]);
  }

  Surface wood_of(const TwigPlan::Kept& kept) const {
    const Skeleton& rest = plant_.model.skeleton;
    auto first = static_cast<std::size_t>(kept.node);
    std::size_t joint = joint_of(rest, kept.node);
    std::vector<std::int32_t> index(static_cast<std::size_t>(kept.nodes.back() - kept.node) + 1);
    Skeleton bones;
    bones.add(Vec3(0), std::min(pose_.radius[joint], 1.25f * pose_.radius[first]), Skeleton::kRoot, 0);
    for (std::int32_t i : kept.nodes) {
      auto node = static_cast<std::size_t>(i);
      std::int32_t below =
          i == kept.node ? 0 : index[static_cast<std::size_t>(rest.parent[node] - kept.node)];
      // Only the first branch is sure to stay, however thin it is.
      auto order = static_cast<std::uint16_t>(rest.order[node] > rest.order[first]);
      index[static_cast<std::size_t>(i - kept.node)] =
          bones.add(at_joint(kept, pose_.position[node]), pose_.radius[node], below, order);
    }
    bones = thinned(bones, static_cast<float>(kThinPixels * plan_.grain),
                    static_cast<float>(kBendPixels * plan_.grain));
    TubeShape shape{.most_sides = 3};
    Surface wood = tube_surface(bones, shape);
    wood.uv.clear();
    return wood;
  }

  /// Its organs as they are then.
  Model organs_of(const TwigPlan::Kept& kept) const {
    Model bearing;
    bearing.prototypes = plant_.model.prototypes;
    const Organs& all = plant_.model.organs;
    Quat back = glm::conjugate(pose_.turn[static_cast<std::size_t>(kept.node)]);
    Organs& o = bearing.organs;
    for (std::uint32_t i : kept.organs) {
      float size = std::max(unfolded(all.birth[i], pose_.front, unfold_time(plant_.motion)), kUnfoldedLeast);
      OrganPlace place = organ_place(plant_.model, plant_.motion, pose_, time_, i, size);
      o.prototype.push_back(all.prototype[i]), o.position.push_back(at_joint(kept, place.at));
      o.turn.push_back(glm::normalize(back * place.turn)), o.scale.push_back(place.scale);
      o.color.push_back(all.color[i]), o.id.push_back(all.id[i]);
    }
    return bearing;
  }

  /// All organs of a prototype, each part of them as one mesh.
  std::vector<Surface> merged_of(const Model& bearing, std::size_t which) const {
    const Prototype& prototype = bearing.prototypes[which];
    const Organs& o = bearing.organs;
    std::vector<Surface> merged(prototype.parts.size());
    double size = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < o.size(); ++i)
      if (o.prototype[i] == which) size += std::max({o.scale[i].x, o.scale[i].y, o.scale[i].z}), ++count;
    if (count == 0) return merged;
    size /= static_cast<double>(count);
    bool tiny = std::ranges::all_of(prototype.parts, [&](const OrganPart& part) {
      double side = std::sqrt(area(part.surface) / pieces_of(part.surface).count);
      return size * side < kTinyPixels * plan_.grain;
    });
    if (tiny) {
      CopyDetail detail{kTinyPixels * plan_.grain};
      std::vector<CopyPart> few = merged_organs(bearing, which, detail, nullptr, nullptr);
      for (std::size_t k = 0; k < few.size(); ++k)
        merged[k] = numbered(std::move(few[k].surface), prototype.colors.size());
      return merged;
    }
    for (std::size_t k = 0; k < merged.size(); ++k)
      if (prototype.parts[k].tissue != Tissue::dew)
        merged[k] = placed_on(bearing, which, coarse(prototype.parts[k]));
    return merged;
  }

  /// A shape in the places of all organs of a prototype.
  static Surface placed_on(const Model& bearing, std::size_t which, const Surface& shape) {
    Surface all;
    const Organs& o = bearing.organs;
    std::size_t colors = bearing.prototypes[which].colors.size();
    for (std::size_t i = 0; i < o.size(); ++i) {
      if (o.prototype[i] != which) continue;
      Surface own = shape;
      own.uv.resize(own.position.size(), Vec2(0.5f));
      auto number = static_cast<float>(color_index(o.color[i], colors) + colors * leaf_shade(o.id[i]));
      // A place at the far rim would be one on the next leaf.
      for (Vec2& uv : own.uv) uv = glm::clamp(uv, Vec2(0.005f), Vec2(0.99f)) + Vec2(number, 0);
      append_placed(all, own, o.position[i], o.turn[i], o.scale[i]);
    }
    return all;
  }

  /// Small numbers of leaves: they tell colours and shades apart, but no more.
  static Surface numbered(Surface leaves, std::size_t colors) {
    auto numbers = static_cast<float>(twig_numbers(colors));
    for (Vec2& uv : leaves.uv) uv.x -= numbers * std::floor(uv.x / numbers);
    return leaves;
  }

  const TwigPlan& plan_;
  const Specimen& plant_;
  const Pose& pose_;
  double time_;
};

}  // namespace

DrawnTwigs::DrawnTwigs(const TwigPlan& of, const Specimen& plant, const Pose& pose, double time) : plan(of) {
  TwigMaker maker(plan, plant, pose, time);
  shapes.resize(plan.palette.size());
  parallel_for(shapes.size(), [&](std::size_t k) { shapes[k] = maker.parts(plan.palette[k]); });
  places.reserve(plan.places.size());
  for (const TwigPlan::Place& place : plan.places)
    places.push_back({pose.position[joint_of(plant.model.skeleton, place.node)],
                      glm::normalize(pose.turn[static_cast<std::size_t>(place.node)] * place.turn),
                      Vec3(place.scale)});
}

double DrawnTwigs::reach() const {
  float most = 0;
  for (const std::vector<TwigPart>& shape : shapes)
    for (const TwigPart& part : shape)
      for (const Vec3& p : part.surface.position) most = std::max(most, glm::length(p));
  return static_cast<double>(most);
}

Pose pose_of_limbs(const TwigPlan& plan, const Pose& pose) {
  Pose limbs;
  limbs.position = chosen_of(pose.position, plan.origin), limbs.radius = chosen_of(pose.radius, plan.origin);
  limbs.turn = chosen_of(pose.turn, plan.origin), limbs.stretch = chosen_of(pose.stretch, plan.origin);
  limbs.flutter = pose.flutter, limbs.flutter_phase = pose.flutter_phase, limbs.front = pose.front;
  return limbs;
}

}  // namespace frond
