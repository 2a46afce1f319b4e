#include "foliage/floret_crowd.h"

#include <algorithm>
#include <cmath>

namespace frond {

Vec3 heading_of(const CrowdFloret& f, Vec3 down) {
  float cosine = std::clamp(glm::dot(f.way, down), -1.0f, 1.0f), angle = std::acos(cosine);
  auto turn = std::min(static_cast<float>(f.nod), angle);
  if (turn <= 0) return f.way;
  Vec3 aside = f.way - down * cosine;
  if (glm::length(aside) < 1e-4f) return f.nod > 0 && cosine < 0 ? f.way : down;
  aside = glm::normalize(aside);
  return aside * std::sin(angle - turn) + down * std::cos(angle - turn);
}

SegmentsGap gap_between(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  constexpr float kPoint = 1e-12f;
  Vec3 u = b - a, v = d - c, w = a - c;
  float uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), uw = glm::dot(u, w),
        vw = glm::dot(v, w);
  float s = 0, t = 0;
  if (uu > kPoint) {
    float across = uu * vv - uv * uv;
    if (vv <= kPoint)
      s = std::clamp(-uw / uu, 0.0f, 1.0f);
    else
      s = across > 1e-6f * uu * vv ? std::clamp((uv * vw - vv * uw) / across, 0.0f, 1.0f) : 0.5f;
  }
  if (vv > kPoint) {
    t = (uv * s + vw) / vv;
    if (t < 0 || t > 1) {
      t = std::clamp(t, 0.0f, 1.0f);
      if (uu > kPoint) s = std::clamp((uv * t - uw) / uu, 0.0f, 1.0f);
    }
  }
  Vec3 p = a + u * s, q = c + v * t;
  return {glm::distance(p, q), p, q};
}

void make_room(std::vector<CrowdFloret>& florets, Vec3 down) {
  constexpr int kRounds = 160,
                kPulled = 70;  // rounds in all, and those in which stalks are drawn to their rest
  constexpr float kPull = 0.04f, kMore = 1.05f;
  struct Body {
    Vec3 from, to;
  };
  auto body_of = [&](const CrowdFloret& f) {
    Vec3 heading = heading_of(f, down), tip = f.tip();
    return Body{tip + heading * static_cast<float>(f.room.from),
                tip + heading * static_cast<float>(f.room.to)};
  };
  std::vector<Body> bodies;
  std::vector<double> least;
  for (const CrowdFloret& f : florets) bodies.push_back(body_of(f)), least.push_back(f.stalk);
  auto push = [&](std::size_t i, Vec3 by, Vec3 at) {
    CrowdFloret& f = florets[i];
    Vec3 arm = at - f.foot;
    float reach = std::max(glm::length(arm), 1e-5f), along = glm::dot(by, f.way);
    f.way = direction_or(f.way + (by - f.way * along) / reach, f.way);
    f.stalk = std::max(least[i], f.stalk + static_cast<double>(along));
    bodies[i] = body_of(f);
  };
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < florets.size(); ++i) {
      for (std::size_t j = i + 1; j < florets.size(); ++j) {
        auto radii = static_cast<float>(florets[i].room.radius + florets[j].room.radius);
        Vec3 middles = (bodies[i].from + bodies[i].to - bodies[j].from - bodies[j].to) * 0.5f;
        auto far = radii + static_cast<float>(0.5 * (florets[i].room.to - florets[i].room.from +
                                                     florets[j].room.to - florets[j].room.from));
        if (glm::dot(middles, middles) >= far * far) continue;
        SegmentsGap gap = gap_between(bodies[i].from, bodies[i].to, bodies[j].from, bodies[j].to);
        float deep = radii - gap.distance;
        if (deep <= 1e-4f * radii) continue;
        moved = true;
        // Those in one place part along their stalks' difference, or aside by the golden angle.
        Vec3 apart =
            direction_or(gap.on_first - gap.on_second,
                         direction_or(middles, Vec3(std::cos(kGoldenAngle * static_cast<double>(i)), 0.1f,
                                                    std::sin(kGoldenAngle * static_cast<double>(i)))));
        Vec3 half = apart * (0.5f * kMore * deep);
        push(i, half, gap.on_first), push(j, -half, gap.on_second);
      }
    }
    if (!moved) break;
    // The last rounds push outward alone, so that they come to an end.
    for (std::size_t i = 0; i < florets.size(); ++i) {
      CrowdFloret& f = florets[i];
      if (round < kPulled) {
        f.way = direction_or(f.way + (f.rest - f.way) * kPull, f.way);
        f.stalk += (least[i] - f.stalk) * static_cast<double>(kPull);
      }
      bodies[i] = body_of(f);
    }
  }
}

double deepest_overlap(const LaidInflorescence& laid, RoomOf room) {
  struct Body {
    Vec3 from, to;
    double radius;
  };
  std::vector<Body> bodies;
  for (const LaidFloret& f : laid.florets) {
    if (f.role != FloretRole::flower) continue;
    OrganRoom r = room(f.role, f.stage);
    bodies.push_back({f.at + f.heading * static_cast<float>(r.from * f.scale),
                      f.at + f.heading * static_cast<float>(r.to * f.scale), r.radius * f.scale});
  }
  double deepest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double gap = gap_between(bodies[i].from, bodies[i].to, bodies[j].from, bodies[j].to).distance;
      deepest = std::max(deepest, (bodies[i].radius + bodies[j].radius - gap) /
                                      std::max(std::min(bodies[i].radius, bodies[j].radius), 1e-9));
    }
  return deepest;
}

}  // namespace frond
