#include "draw/septa.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "draw/solids.h"

namespace frond {

namespace {

constexpr float kMiddle = 0.5f;                           // of a wall, by u of the skin's `uv`
constexpr float kThick = 0.62f;                           // of what is from septum to septum
constexpr float kSeptumSeen = 1.3f, kSeptumGone = 0.75f;  // pixels from septum to septum
constexpr float kSteepest = 0.94f;                        // sine of the angle of a wall
constexpr float kFacesAway = -0.25f;                      // cosine, beyond which what faces away is hidden
constexpr float kNarrow = 0.5f, kWide = 2.6f;  // a wall's least and most width, as a share of half a valley
constexpr Seed kSeptumLots{78};                // that vary septa

/// A side of a triangle that a line crosses, and the triangle.
struct Crossing {
  std::uint64_t key;
  std::uint32_t triangle;
};

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// How u rises over the skin at each vertex, 1/m.
std::vector<Vec3> slopes_of(const Surface& skin) {
  std::vector<Vec3> slope(skin.position.size(), Vec3(0));
  std::vector<float> whole(skin.position.size(), 0);
  for (const auto& t : skin.triangle) {
    Vec3 area = area_of(skin, t);
    float twice = glm::length(area);
    if (twice <= 0) continue;
    Vec3 rise(0);
    for (std::size_t k = 0; k < 3; ++k)
      rise += skin.uv[t[k]].x *
              glm::cross(area / twice, skin.position[t[(k + 2) % 3]] - skin.position[t[(k + 1) % 3]]);
    for (std::uint32_t v : t) slope[v] += rise, whole[v] += twice;
  }
  for (std::size_t v = 0; v < slope.size(); ++v)
    if (whole[v] > 0) slope[v] /= whole[v];
  return slope;
}

/// The line half way up all walls, triangle by triangle.
class WallLine {
 public:
  explicit WallLine(const Surface& skin) : skin_(skin) {
    for (std::uint32_t t = 0; t < skin.triangle.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (crosses(t, k)) crossings_.push_back({key(t, k), t});
    std::ranges::sort(crossings_, [](const Crossing& a, const Crossing& b) {
      return std::pair(a.key, a.triangle) < std::pair(b.key, b.triangle);
    });
    walked_.resize(skin.triangle.size());
  }

  /// Calls `step(triangle, side in, side out)` along each of the lines, one after the other; `step` gets true
  /// for `begins` where a line begins.
  template <class Step>
  void walk(const Step& step) {
    for (std::uint32_t first = 0; first < skin_.triangle.size(); ++first) {
      std::uint32_t t = first;
      std::size_t in = first_side(t);
      for (bool begins = true; in < 3 && !walked_[t]; begins = false) {
        walked_[t] = true;
        std::size_t out = crosses(t, (in + 1) % 3) ? (in + 1) % 3 : (in + 2) % 3;
        step(t, in, out, begins);
        std::uint64_t through = key(t, out);
        t = beyond(through, t);
        for (in = 0; in < 3 && key(t, in) != through;) ++in;
      }
    }
  }

  /// Where the line goes through a side of a triangle.
  SurfacePoint at(std::uint32_t t, std::size_t side) const {
    const auto& c = skin_.triangle[t];
    float a = skin_.uv[c[side]].x, b = skin_.uv[c[(side + 1) % 3]].x;
    SurfacePoint point{c, Vec3(0)};
    float share = (kMiddle - a) / (b - a);
    point.share[static_cast<int>(side)] = 1 - share;
    point.share[static_cast<int>((side + 1) % 3)] = share;
    return point;
  }

 private:
  bool high(std::uint32_t t, std::size_t k) const { return skin_.uv[skin_.triangle[t][k % 3]].x > kMiddle; }
  bool crosses(std::uint32_t t, std::size_t side) const { return high(t, side) != high(t, side + 1); }
  std::uint64_t key(std::uint32_t t, std::size_t side) const {
    return key_of(skin_.triangle[t][side], skin_.triangle[t][(side + 1) % 3]);
  }
  std::size_t first_side(std::uint32_t t) const {
    std::size_t side = 0;
    while (side < 3 && !crosses(t, side)) ++side;
    return side;
  }
  /// The triangle beyond a side; the same where there is none.
  std::uint32_t beyond(std::uint64_t key, std::uint32_t t) const {
    auto at = std::ranges::lower_bound(crossings_, key, {}, &Crossing::key);
    for (; at != crossings_.end() && at->key == key; ++at)
      if (at->triangle != t) return at->triangle;
    return t;
  }

  const Surface& skin_;
  std::vector<Crossing> crossings_;  // by their keys
  std::vector<bool> walked_;
};

/// The septum at a place of the line, if the wall there rises at all.
std::optional<SeptumPlace> septum_at(const Surface& skin, const std::vector<Vec3>& slopes,
                                     const SurfacePoint& at, const Septa& septa) {
  Vec3 normal = direction_or(at.of(skin.normal), Vec3(0, 1, 0));
  Vec3 slope = at.of(slopes);
  slope -= glm::dot(slope, normal) * normal;
  float rise = glm::length(slope);
  if (rise <= 0) return std::nullopt;
  Vec3 a = skin.position[at.corner[0]], p = skin.position[at.corner[1]] - a,
       q = skin.position[at.corner[2]] - a;
  auto depth = static_cast<float>(septa.depth), half = static_cast<float>(septa.valley / 2);
  float steep = std::min(kSteepest, depth * rise);
  // A wall that rises as a sine does is steepest in its middle.
  float width = static_cast<float>(kPi / 2) * depth * std::sqrt(1 - steep * steep) / std::max(steep, 1e-3f);
  width = std::clamp(width, kNarrow * half, kWide * half);
  Vec3 up = slope * (width / rise);
  // Of least squares: `up` lies in the triangle but for how it is rounded.
  float pp = glm::dot(p, p), pq = glm::dot(p, q), qq = glm::dot(q, q), det = pp * qq - pq * pq;
  if (det <= 0) return std::nullopt;
  float up_p = glm::dot(up, p), up_q = glm::dot(up, q);
  return SeptumPlace{at, Vec2(qq * up_p - pq * up_q, pp * up_q - pq * up_p) / det, steep, width};
}

std::vector<SeptumPlace> places_on(const Solid& solid) {
  std::vector<SeptumPlace> places;
  const Surface& skin = solid.surface;
  const Septa& septa = solid.material.septa;
  auto apart = static_cast<float>(septa.apart);
  std::vector<Vec3> slopes = slopes_of(skin);
  WallLine line(skin);
  float along = 0;  // metres since the last septum
  line.walk([&](std::uint32_t t, std::size_t in, std::size_t out, bool begins) {
    SurfacePoint from = line.at(t, in), to = line.at(t, out);
    float length = glm::distance(from.of(skin.position), to.of(skin.position));
    if (begins) along = 0;
    for (; along < length; along += apart)
      if (auto septum =
              septum_at(skin, slopes, {from.corner, glm::mix(from.share, to.share, along / length)}, septa))
        places.push_back(*septum);
    along -= length;
  });
  return places;
}

/// The turn, size and place of a septum on the skin as it is.
struct Standing {
  glm::mat3 frame;
  Vec3 at, outward;
  float share;  // of its size when all has grown
};

Standing standing(const SeptumPlace& place, const Surface& skin, float apart) {
  Vec3 a = skin.position[place.at.corner[0]];
  Vec3 uphill = place.uphill.x * (skin.position[place.at.corner[1]] - a) +
                place.uphill.y * (skin.position[place.at.corner[2]] - a);
  Vec3 normal = direction_or(place.at.of(skin.normal), Vec3(0, 1, 0));
  uphill -= glm::dot(uphill, normal) * normal;
  float width = glm::length(uphill);
  Vec3 up = direction_or(uphill, reference_axis(normal));
  float sine = place.steep, cosine = std::sqrt(1 - sine * sine);
  Vec3 across = cosine * up - sine * normal, outward = cosine * normal + sine * up;
  float high = width * sine / cosine * static_cast<float>(2 / kPi), share = width / place.across;
  return {glm::mat3(across * width, outward * high, glm::cross(across, outward) * (kThick * apart * share)),
          place.at.of(skin.position), normal, share};
}

}  // namespace

SeptumPlaces septum_places(const Solids& solids) {
  SeptumPlaces places(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids.shapes[solids.shape[i]];
    if (solid.material.septa.apart > 0 && solid.material.septa.depth > 0 && !solid.surface.uv.empty())
      places[i] = places_on(solid);
  }
  return places;
}

std::vector<DrawnSepta> drawn_septa(const Solids& solids, const SeptumPlaces& places, const Growth& growth,
                                    double time, const Eye& eye) {
  std::vector<DrawnSepta> all;
  each_grown_skin(
      solids, places, growth, time, [&](std::size_t i, const Solid& solid, const Surface& skin, float front) {
        DrawnSepta& septa = all.emplace_back(
            DrawnSepta{&solid.material, solids.position[i], solids.turn[i], solids.scale[i]});
        if (is_growing(solid, growth)) septa.front = std::min(front, 1.0f);
        auto apart = static_cast<float>(solid.material.septa.apart);
        for (std::size_t n = 0; n < places[i].size(); ++n) {
          Standing now = standing(places[i][n], skin, apart);
          Vec3 to_eye = eye.at - solids.placed(i, now.at);
          float distance = glm::length(to_eye),
                pixels = apart * now.share / (static_cast<float>(eye.pixel) * distance);
          if (pixels < kSeptumGone || glm::dot(solids.turn[i] * now.outward, to_eye) < kFacesAway * distance)
            continue;
          // Every other one is thinner, as the later orders of septa are.
          auto thick = static_cast<float>(kSeptumLots.child(n).range(0.85, 1.15)) * (n % 2 == 0 ? 1 : 0.94f);
          now.frame[2] *= smooth_step(kSeptumGone, kSeptumSeen, pixels) * thick;
          septa.frames.push_back(now.frame);
          septa.positions.push_back(now.at);
        }
        if (septa.frames.empty()) all.pop_back();
      });
  return all;
}

}  // namespace frond
