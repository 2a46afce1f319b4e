#include "emit/polyps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/text.h"

namespace frond {

namespace {

constexpr int kTentacles = 10, kBends = 4, kRound = 4;
constexpr double kApart = 0.85;              // of their width: how near polyps stand to each other
constexpr float kSeen = 1.2f, kGone = 0.6f;  // pixels that one is wide
constexpr double kYoung = 0.06;              // of the growth, after which a place bears its polyp

/// One of width 1 when it is open, along +y.
Surface polyp_surface(double open) {
  Surface polyp;
  auto o = static_cast<float>(open);
  for (int t = 0; t < kTentacles; ++t) {
    bool inner = t % 2 == 1;
    float turn = 2 * static_cast<float>(kPi) * static_cast<float>(t) / kTentacles, c = std::cos(turn),
          s = std::sin(turn);
    Vec3 out(c, 0, s), side(-s, 0, c), at = 0.13f * out;
    float step = (inner ? 0.10f : 0.125f) * glm::mix(0.3f, 1.0f, o);
    auto first = static_cast<std::uint32_t>(polyp.position.size());
    for (int k = 0; k <= kBends; ++k) {
      float along = static_cast<float>(k) / kBends;
      float lean = glm::mix(-0.5f, (inner ? 0.2f : 0.5f) + 0.9f * along, o);
      Vec3 way = std::sin(lean) * out + std::cos(lean) * Vec3(0, 1, 0), up = glm::cross(side, way);
      float thick = 0.05f * (1 - 0.6f * along) * glm::mix(0.7f, 1.0f, o);
      for (int r = 0; r < kRound; ++r) {
        float a = 2 * static_cast<float>(kPi) * static_cast<float>(r) / kRound;
        Vec3 normal = std::cos(a) * side + std::sin(a) * up;
        polyp.position.push_back(at + thick * normal);
        polyp.normal.push_back(normal);
      }
      at += step * way;
    }
    auto id = [&](int k, int r) { return first + static_cast<std::uint32_t>(k * kRound + r % kRound); };
    for (int k = 0; k < kBends; ++k)
      for (int r = 0; r < kRound; ++r) {
        polyp.triangle.push_back({id(k, r), id(k + 1, r), id(k, r + 1)});
        polyp.triangle.push_back({id(k, r + 1), id(k + 1, r), id(k + 1, r + 1)});
      }
    polyp.triangle.push_back({id(kBends, 0), id(kBends, 2), id(kBends, 1)});
    polyp.triangle.push_back({id(kBends, 0), id(kBends, 3), id(kBends, 2)});
  }
  return polyp;
}

/// Places of the grown skin that are at least so far apart.
std::vector<Foothold> spots_of(const Surface& skin, float apart) {
  std::vector<Foothold> spots, all;
  for (const auto& t : skin.triangle) {
    Vec3 a = skin.position[t[0]], b = skin.position[t[1]], c = skin.position[t[2]];
    float side = std::max(glm::distance(a, b), std::max(glm::distance(b, c), glm::distance(c, a)));
    auto n = static_cast<int>(std::clamp(side / (0.5f * apart), 1.0f, 40.0f));
    for (int u = 0; u < n; ++u)
      for (int v = 0; u + v < n; ++v) {
        Vec2 at = (Vec2(u, v) + 1.0f / 3.0f) / static_cast<float>(n);
        all.push_back({t, Vec3(1 - at.x - at.y, at.x, at.y)});
      }
  }
  // Those that are taken, chained by the cell that they lie in; cells may share a chain.
  constexpr std::uint64_t kChains = 1 << 14;
  std::vector<std::int32_t> head(kChains, -1), next;
  std::vector<Vec3> taken;
  auto chain = [&](Vec3 p, int shift) {
    auto at = [&](int axis, int by) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[axis] / apart)) + by - 1);
    };
    std::uint64_t cell =
        at(0, shift % 3) * 73856093 ^ at(1, shift / 3 % 3) * 19349663 ^ at(2, shift / 9) * 83492791;
    return static_cast<std::size_t>(cell % kChains);
  };
  for (const Foothold& spot : all) {
    Vec3 p = spot.of(skin.position);
    bool free = true;
    for (int shift = 0; shift < 27 && free; ++shift)
      for (std::int32_t k = head[chain(p, shift)]; k >= 0 && free; k = next[static_cast<std::size_t>(k)])
        free = glm::distance(taken[static_cast<std::size_t>(k)], p) >= apart;
    if (!free) continue;
    std::int32_t& first = head[chain(p, 13)];
    next.push_back(first);
    first = static_cast<std::int32_t>(taken.size());
    taken.push_back(p);
    spots.push_back(spot);
  }
  return spots;
}

/// The polyps of one skin that are seen.
class Bearer {
 public:
  Bearer(const PovSpace& space, const Polyps& polyps, const Eye& eye)
      : space_(space), polyps_(polyps), eye_(eye) {}

  /// The share `grown` of the n-th one.
  void bear(std::size_t n, Vec3 at, Vec3 normal, double grown) {
    Seed own = Seed{77}.child(n);
    auto size = static_cast<float>(polyps_.width * own.child(0).range(0.8, 1.15) * grown);
    Vec3 way = eye_.at - at;
    float away = glm::length(way);
    size *= smooth_step(kGone, kSeen, size / (static_cast<float>(eye_.pixel) * away));
    if (!(size > 0) || glm::dot(normal, way) < -0.35f * away) return;
    Quat turn = Quat(Vec3(0, 1, 0), normal) *
                glm::angleAxis(static_cast<float>(own.child(1).range(0, 2 * kPi)), Vec3(0, 1, 0));
    std::size_t line = lines_.size();
    lines_ += "object{Polyp ";
    if (append_matrix(lines_, space_, glm::mat3_cast(turn) * size, at))
      lines_ += "}\n";
    else
      lines_.resize(line);
  }

  ObjectText text(const Color& color, double time) const {
    if (lines_.empty()) return {};
    std::string text = "#declare Polyp = ";
    append_mesh(text, space_, polyp_surface(std::clamp(polyps_.open.at(time), 0.0, 1.0)));
    text += "\nunion{\n" + lines_ + "texture{Reef_Polyp(";
    append_color(text, color);
    text += ',';
    append(text, polyps_.glow, 4);
    return {text + ")}}\n", 1};
  }

 private:
  const PovSpace& space_;
  const Polyps& polyps_;
  const Eye& eye_;
  std::string lines_;
};

double grown_since(double born, double front) { return smooth_step(born, born + kYoung, front); }

}  // namespace

PolypPlaces polyp_places(const Solids& solids) {
  PolypPlaces places(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids.shapes[solids.shape[i]];
    if (double width = solid.material.polyps.width; width > 0)
      places[i] = spots_of(solid.surface, static_cast<float>(kApart * width));
  }
  return places;
}

ObjectText polyps_text(const PovSpace& space, const Solids& solids, const PolypPlaces& places,
                       const Growth& growth, double time, const Eye& eye) {
  ObjectText text;
  auto front = static_cast<float>(growth_front(growth, time));
  if (front <= 0) return text;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids.shapes[solids.shape[i]];
    if (places[i].empty()) continue;
    Surface skin = surface_at(solid, front);
    Bearer bearer(space, solid.material.polyps, eye);
    for (std::size_t n = 0; n < places[i].size(); ++n) {
      const Foothold& spot = places[i][n];
      double born = solid.surface.uv.empty() ? 0 : static_cast<double>(solid.surface.uv[spot.corner[0]].y);
      bearer.bear(n, solids.placed(i, spot.of(skin.position)),
                  solids.turn[i] * direction_or(spot.of(skin.normal), Vec3(0, 1, 0)),
                  grown_since(born, static_cast<double>(front)));
    }
    text += bearer.text(solid.material.color, time);
  }
  return text;
}

ObjectText branch_polyps_text(const PovSpace& space, const Specimen& b, const Pose& pose, double time,
                              const Eye& eye) {
  const Skeleton& rest = b.model.skeleton;
  const Polyps& polyps = b.look.skin->polyps;
  Bearer bearer(space, polyps, eye);
  auto apart = static_cast<float>(kApart * polyps.width);
  std::size_t n = 0;
  float along = 0;  // metres of the branch since the last one
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest.parent[i] == Skeleton::kRoot) continue;
    auto below = static_cast<std::size_t>(rest.parent[i]);
    Vec3 axis = rest.position[i] - rest.position[below];
    float length = glm::length(axis), radius = rest.radius[i];
    if (length <= 0) continue;
    axis /= length;
    Vec3 side = glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
    Vec3 other = glm::cross(axis, side);
    // As many as have room round the branch: one each so far along it.
    float pitch = std::min(apart, 0.87f * apart * apart / (2 * static_cast<float>(kPi) * radius));
    auto put = [&](float share, Vec3 out, float lift) {
      double born = static_cast<double>(glm::mix(rest.birth[below], rest.birth[i], share));
      Vec3 at = glm::mix(pose.position[below], pose.position[i], share);
      Vec3 normal = pose.turn[i] * out;
      bearer.bear(n++, at + normal * (lift * glm::mix(pose.radius[below], pose.radius[i], share)), normal,
                  grown_since(born, static_cast<double>(pose.front)));
    };
    for (; along < length; along += pitch) {
      float turn = static_cast<float>(kGoldenAngle) * static_cast<float>(n);
      put(along / length, glm::normalize(std::cos(turn) * side + std::sin(turn) * other + 0.35f * axis),
          0.97f);
    }
    along -= length;
    if (rest.to_tip[i] <= 0) put(1, axis, 1);
  }
  return bearer.text(b.look.skin->tint.base, time);
}

}  // namespace frond
