#include "foliage/sprig.h"

#include <cmath>
#include <span>

#include "core/seed.h"

namespace frond {

namespace {

/// Half the width of a leaf along its length, as shares of the greatest.
struct OutlineStation {
  float along, half;
};

constexpr OutlineStation kOval[] = {{0, 0.02f},     {0.10f, 0.30f}, {0.28f, 0.86f}, {0.45f, 1},
                                    {0.65f, 0.83f}, {0.84f, 0.42f}, {1, 0}};
constexpr OutlineStation kLobed[] = {{0, 0.05f},     {0.10f, 0.16f}, {0.20f, 0.52f}, {0.29f, 0.34f},
                                     {0.42f, 0.86f}, {0.52f, 0.55f}, {0.66f, 1},     {0.76f, 0.62f},
                                     {0.88f, 0.70f}, {0.97f, 0.36f}, {1, 0}};
constexpr OutlineStation kNarrow[] = {{0, 0.05f}, {0.15f, 0.75f}, {0.40f, 1}, {0.70f, 0.72f}, {1, 0}};
constexpr OutlineStation kLeaflet[] = {{0, 0.2f}, {0.45f, 1}, {1, 0}};

std::span<const OutlineStation> outline_of(SprigKind kind) {
  constexpr std::span<const OutlineStation> kOutlines[] = {kOval, kLobed, kNarrow, kLeaflet, kLeaflet};
  return kOutlines[static_cast<std::size_t>(kind)];
}

struct SprigLeaf {
  Vec3 foot, along, up;  ///< along and up of length 1, square to each other
  float length, half;    ///< metres, half: of its greatest width
  float bend;            ///< radians, downward from foot to tip
  float fold;            ///< share of the half width by which the rims are raised
};

/// A leaf with a crease: a row of three points at each station.
void add_leaf(Surface& s, std::span<const OutlineStation> outline, const SprigLeaf& leaf) {
  Vec3 across = glm::cross(leaf.along, leaf.up);
  auto base = static_cast<std::uint32_t>(s.position.size());
  for (const OutlineStation& at : outline) {
    float angle = leaf.bend * at.along;
    Vec3 middle = leaf.foot +
                  leaf.length * at.along * (leaf.along * std::cos(angle / 2) - leaf.up * std::sin(angle / 2));
    Vec3 up = leaf.up * std::cos(angle) + leaf.along * std::sin(angle);
    float half = leaf.half * at.half;
    for (int side : {-1, 0, 1}) {
      auto out = static_cast<float>(side);
      s.position.push_back(middle + across * (out * half) + up * (std::abs(out) * half * leaf.fold));
      s.uv.emplace_back(at.along, 0.5f + 0.5f * out * at.half);
    }
  }
  for (std::uint32_t k = 0; k + 1 < outline.size(); ++k) {
    for (std::uint32_t side = 0; side < 2; ++side) {
      std::uint32_t a = base + 3 * k + side;
      add_quad(s, a, a + 1, a + 4, a + 3);
    }
  }
}

Vec3 squared(Vec3 v, Vec3 along) {
  Vec3 rest = v - along * glm::dot(v, along);
  float length = glm::length(rest);
  return length > 1e-4f ? rest / length : Vec3(1, 0, 0);
}

/// The same number for the same leaf and property in every sprig.
float varied(int i, std::uint64_t which, float low, float high) {
  return static_cast<float>(Seed{77}.child(i).child(which).range(low, high));
}

// Sizes are by eye; bend and fold are those of SprigLeaf.

void add_needles(Surface& s, const SprigShape& shape) {
  constexpr float kTurn = 2.39996f;               // radians from needle to needle: the golden angle, rounded
  constexpr float kTurnVaries = 0.3f;             // radians
  constexpr float kFlatter = 0.75f, kUp = 0.18f;  // of directions across the twig: less up and down; upward
  constexpr float kShorter = 0.35f;               // share by which needles at the tip are shorter
  constexpr float kLast = 0.95f;                  // of the twig, where needles end
  constexpr float kBend = 0.15f, kFold = 0.3f;
  for (int i = 0; i < shape.leaves; ++i) {
    float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(shape.leaves);
    float turn = kTurn * static_cast<float>(i) + varied(i, 1, -kTurnVaries, kTurnVaries);
    // Needles of a shoot in shade stand more to the sides than below.
    Vec3 out(std::cos(turn), 0, kFlatter * std::sin(turn) + kUp);
    auto open = static_cast<float>(shape.open);
    Vec3 along = glm::normalize(glm::normalize(out) * std::sin(open) + Vec3(0, std::cos(open), 0));
    float length = static_cast<float>(shape.leaf) * varied(i, 2, 0.8f, 1.1f) * (1 - kShorter * t * t);
    add_leaf(s, outline_of(shape.kind),
             {Vec3(0, t * kLast, 0), along, squared(Vec3(0, 0, 1), along), length,
              0.5f * length * static_cast<float>(shape.width), kBend, kFold});
  }
}

void add_feather(Surface& s, const SprigShape& shape) {
  constexpr float kUp = 0.12f;    // of a leaflet's direction
  constexpr float kHang = 0.10f;  // of the length, by which the leaf's tip hangs
  constexpr float kBend = 0.2f, kFold = 0.1f;
  for (int i = 0; i < shape.leaves; ++i) {
    float t = (static_cast<float>(i) + 0.6f) / static_cast<float>(shape.leaves);
    float size = std::sin(static_cast<float>(kPi) * (0.12f + 0.80f * t));  // longest in the middle
    for (int side : {-1, 1}) {
      Vec3 along = glm::normalize(Vec3(static_cast<float>(side) * std::sin(static_cast<float>(shape.open)),
                                       std::cos(static_cast<float>(shape.open)), kUp));
      float length = static_cast<float>(shape.leaf) * size;
      Vec3 foot(0, t, -kHang * t * t);
      add_leaf(s, outline_of(shape.kind),
               {foot, along, squared(Vec3(0, 0, 1), along), length,
                0.5f * length * static_cast<float>(shape.width), kBend, kFold});
    }
  }
}

void add_leaves(Surface& s, const SprigShape& shape) {
  constexpr float kMostHang = 0.8f;  // share of downward in a leaf's direction at hang 1
  constexpr float kFirst = 0.06f;    // of the sprig, where leaves begin
  constexpr float kLastLeaf = 0.8f;  // of a leaf's length: what the last one adds to the sprig's
  constexpr float kFold = 0.35f;
  auto hang = static_cast<float>(shape.hang);
  for (int i = 0; i < shape.leaves; ++i) {
    bool last = i + 1 == shape.leaves;
    float t = shape.leaves > 1 ? static_cast<float>(i) / static_cast<float>(shape.leaves - 1) : 1.0f;
    auto side = static_cast<float>(i % 2 == 0 ? 1 : -1);
    float open = last ? 0.0f : static_cast<float>(shape.open) * varied(i, 1, 0.75f, 1.2f);
    Vec3 along(side * std::sin(open), std::cos(open), varied(i, 2, -0.25f, 0.35f));
    along = glm::normalize(along * (1 - kMostHang * hang) + Vec3(0, 0.1f, -1) * (kMostHang * hang));
    Vec3 up = squared(Vec3(varied(i, 3, -0.5f, 0.5f), varied(i, 4, -0.3f, 0.3f), 1), along);
    float length = static_cast<float>(shape.leaf) * varied(i, 5, 0.8f, 1.12f);
    float reach = 1 - static_cast<float>(shape.leaf) * kLastLeaf;
    add_leaf(s, outline_of(shape.kind),
             {Vec3(0, kFirst + (reach - kFirst) * t, 0), along, up, length,
              0.5f * length * static_cast<float>(shape.width), varied(i, 6, 0.25f, 0.8f), kFold});
  }
}

}  // namespace

Surface sprig_surface(const SprigShape& shape) {
  Surface s;
  if (shape.kind == SprigKind::needles)
    add_needles(s, shape);
  else if (shape.kind == SprigKind::feather)
    add_feather(s, shape);
  else
    add_leaves(s, shape);
  std::erase_if(s.triangle,
                [&](const std::array<std::uint32_t, 3>& t) { return glm::length(area_of(s, t)) < 1e-8f; });
  set_normals(s);
  return s;
}

}  // namespace frond
