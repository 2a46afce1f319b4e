#include "organisms/tree/knots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "foliage/organ_shapes.h"

namespace frond {

namespace {

constexpr double kShortStub = 0.4, kLongStub = 2.6;  // of the bough's radius, where `length` is 1
constexpr double kRots = 12;                         // years in which half of a stub's length rots away
constexpr float kTold = 0.1f;       // of what bore it: thinner boughs leave nothing that is seen
constexpr float kLip = 1.35f;       // of the bough's radius: the ring of bark round the stub
constexpr float kCloses = 1.6f;     // radii of new wood that close the wound
constexpr float kSinks = 5;         // radii of new wood under which nothing is left of it
constexpr float kSteepest = 0.4f;   // sine of the least angle between a bough and what bears it
constexpr float kDeep = 1.5f;       // radii below the bark at which all of its lip is hidden
constexpr float kStubEnd = 0.85f;   // of the bough's radius: the bare end of a stub
constexpr float kStubBulge = 1.1f;  // of it: the bark over an end that is closed
constexpr float kStandsOut = 0.1f;  // of it: how far an end is out of the bark at least
const Color kOldWood{0.33f, 0.27f, 0.21f}, kHollow{0.055f, 0.04f, 0.03f};

/// A weathered end, 1 wide at its foot: rough wood round a hollow.
Prototype wound_shape() {
  constexpr int kSides = 18;
  std::array<float, 4> rim{1.03f, 0.97f, 0.8f, 0.5f}, hollow{0.6f, 0.4f, 0.2f, 0.0f};
  Surface wood = turned_surface(rim, kSides), hole = turned_surface(hollow, kSides);
  Seed seed{17};
  for (std::size_t i = 0; i < wood.position.size(); ++i) {
    // Torn, not turned; the last point of a round is the first one.
    auto k = static_cast<std::uint64_t>(i % (kSides + 1) % kSides),
         row = static_cast<std::uint64_t>(i / (kSides + 1));
    wood.position[i].y *= 1.08f * static_cast<float>(seed.child(row).child(k).range(0.8, 1.1));
  }
  for (Vec3& p : hole.position) p.y = 1.0f + 0.03f * p.y;
  set_normals(wood);
  set_normals(hole);
  return {"knot", {{Tissue::skin, std::move(wood)}, {Tissue::heart, std::move(hole)}}, {kOldWood}, kHollow};
}

}  // namespace

std::vector<Knot> add_knots(Skeleton& skeleton, const Standing& now, const GrownTree& tree,
                            std::span<const std::int32_t> node, double length, double year, Seed seed) {
  std::vector<Knot> knots;
  if (length <= 0 || tree.scars.empty()) return knots;
  std::vector<std::int32_t> at(tree.size(), GrownTree::kRoot);
  for (std::size_t i = 0; i < now.size(); ++i) at[now.source[i]] = static_cast<std::int32_t>(i);
  for (const Scar& scar : tree.scars) {
    std::int32_t i = at[scar.on];
    if (i == GrownTree::kRoot || now.parent[i] == GrownTree::kRoot) continue;
    if (scar.fell > year || scar.radius < kTold * scar.girth) continue;
    // What bears it may be falling itself by now.
    Vec3 then = tree.tip[scar.on] - tree.tip[tree.parent[scar.on]], along = now.tip[i] - now.foot[i];
    if (glm::length(along) < 1e-6f || glm::length(then) < 1e-6f) continue;
    along = glm::normalize(along);
    Vec3 direction = glm::normalize(Quat(glm::normalize(then), along) * scar.direction);
    float sine = std::max(glm::length(glm::cross(direction, along)), kSteepest), r = scar.radius;
    float bark = skeleton.radius[node[i]] / sine;
    double left =
        seed.child(scar.id).range(kShortStub, kLongStub) * length * std::exp2((scar.fell - year) / kRots);
    float wood = scar.girth / sine + r * static_cast<float>(left), over = (bark - wood) / r;
    float sunk = std::clamp((over - kCloses) / kSinks, 0.0f, 1.0f);
    if (sunk >= 1) continue;
    float end = std::max(wood, bark + r * (kStandsOut - kDeep / sine * sunk)),
          closed = std::clamp(over / kCloses, 0.0f, 1.0f);
    Vec3 foot = now.tip[i];
    std::int32_t lip = skeleton.add(foot + direction * std::min(bark, end - 0.05f * r), kLip * r, node[i],
                                    static_cast<std::uint16_t>(skeleton.order[node[i]] + 1));
    std::int32_t tip = skeleton.add(foot + direction * end, r * glm::mix(kStubEnd, kStubBulge, closed), lip,
                                    skeleton.order[lip]);
    knots.push_back({tip, direction, kStubEnd * r * (1 - closed), scar.id});
  }
  return knots;
}

void add_wounds(Model& model, std::span<const Knot> knots) {
  auto prototype = static_cast<std::uint16_t>(model.prototypes.size());
  model.prototypes.push_back(wound_shape());
  Organs& o = model.organs;
  for (const Knot& knot : knots) {
    if (knot.wound <= 0) continue;
    o.prototype.push_back(prototype);
    o.position.push_back(model.skeleton.position[static_cast<std::size_t>(knot.node)]);
    o.turn.push_back(glm::normalize(Quat(Vec3(0, 1, 0), knot.direction)));
    o.scale.push_back(Vec3(knot.wound));
    o.node.push_back(knot.node);
    o.birth.push_back(0);
    o.color.push_back(0);
    o.id.push_back(knot.id);
  }
}

}  // namespace frond
