#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>

#include "core/parallel.h"
#include "draw/sweep.h"
#include "studio/view.h"

namespace frond {

namespace {

using Bytes4 = std::array<std::int8_t, 4>;
using Rgba = std::array<std::uint8_t, 4>;

/// As it goes over the wire.
struct WireSegment {
  Vec3 from{0};
  float from_radius = 0;
  Vec3 to{0};
  float to_radius = 0;
  Bytes4 from_heading{}, to_heading{};
  Rgba from_color{}, to_color{};
};
static_assert(sizeof(WireSegment) == 48);

constexpr float kRound = 0.004f;  // share of the longest path: thinner tips are not rounded

Bytes4 packed(Vec3 heading) {
  auto byte = [](float x) { return static_cast<std::int8_t>(std::lround(127 * x)); };
  return {byte(heading.x), byte(heading.y), byte(heading.z), 0};
}

Rgba packed(const Color& c) {
  auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))); };
  return {byte(c.red), byte(c.green), byte(c.blue), 255};
}

Vec3 direction(Vec3 from, Vec3 to, Vec3 otherwise) {
  float length = glm::distance(from, to);
  return length > 1e-9f ? (to - from) / length : otherwise;
}

/// The largest first, those of like sizes strewn evenly: any number of the first is the best picture that so
/// many make.
std::vector<WireSegment> largest_first(const std::vector<WireSegment>& segments) {
  constexpr std::uint32_t kSizes = 1024, kStrewn = 8;
  auto rank = [&](std::size_t i) {
    const WireSegment& s = segments[i];
    float area = glm::distance(s.from, s.to) * std::max(s.from_radius, s.to_radius);
    // Four sizes to each power of two; the golden ratio strews.
    std::uint32_t size = kSizes - 1 - (std::bit_cast<std::uint32_t>(area) >> 21);
    return kStrewn * size + (static_cast<std::uint32_t>(i) * 2654435769u >> 29);
  };
  std::vector<std::uint32_t> first(kSizes * kStrewn + 1);
  for (std::size_t i = 0; i < segments.size(); ++i) ++first[rank(i) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<WireSegment> sorted(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) sorted[first[rank(i)]++] = segments[i];
  return sorted;
}

/// Builds the segments of one skeleton.
class Weaver {
 public:
  explicit Weaver(const DrawnBranches& branches)
      : rest_(branches.rest()), pose_(branches.pose), colors_(branches), longest_(rest_.longest()) {
    segments_.reserve(rest_.size() + rest_.size() / 8);
  }

  std::vector<WireSegment> weave() && {
    auto n = static_cast<std::int32_t>(rest_.size());
    for (std::int32_t i = 0; i < n; ++i) {
      if (rest_.parent[i] == Skeleton::kRoot || rest_.birth[rest_.parent[i]] >= pose_.front) continue;
      add(i, i + 1 < n && rest_.parent[i + 1] == i && rest_.birth[i] < pose_.front);
    }
    return std::move(segments_);
  }

 private:
  void add(std::int32_t i, bool goes_on) {
    std::int32_t below = rest_.parent[i];
    WireSegment s;
    s.from = pose_.position[below], s.to = pose_.position[i];
    s.from_radius = pose_.radius[below], s.to_radius = pose_.radius[i];
    float length = glm::distance(s.from, s.to);
    if (!(length > 1e-7f)) return;
    Vec3 heading = (s.to - s.from) / length, from_heading = heading;
    if (below == i - 1 && !segments_.empty() && last_ == below) {
      from_heading = last_heading_;
    } else if (below != i - 1) {
      s.from_radius = foot_radius(rest_, pose_, i);
    }
    Vec3 to_heading =
        goes_on ? direction(Vec3(0), heading + direction(s.to, pose_.position[i + 1], heading), heading)
                : heading;
    s.from_heading = packed(from_heading), s.to_heading = packed(to_heading);
    s.from_color = packed(colors_.at(below, i)), s.to_color = packed(colors_.at(i, i));
    segments_.push_back(s);
    last_ = i, last_heading_ = to_heading;
    if (!goes_on) round_off(s, heading);
  }

  /// Half a ball on the end of a branch, where it is thick enough for that to show.
  void round_off(WireSegment s, Vec3 heading) {
    float r = s.to_radius;
    Vec3 end = s.to;
    s.from_heading = s.to_heading = packed(heading), s.from_color = s.to_color;
    auto cap = [&](float to, float radius) {
      s.from = s.to, s.from_radius = s.to_radius;
      s.to = end + heading * (to * r), s.to_radius = radius * r;
      segments_.push_back(s);
    };
    if (r > kRound * longest_) cap(0.5f, 0.866f), cap(0.87f, 0.5f);
    cap(1, 0);
  }

  const Skeleton& rest_;
  const Pose& pose_;
  BranchColors colors_;
  float longest_;
  std::vector<WireSegment> segments_;
  std::int32_t last_ = -1;
  Vec3 last_heading_{0};
};

}  // namespace

DrawnPart tubes_part(const DrawnBranches& branches) {
  DrawnPart part;
  part.head["kind"] = "tubes";
  part.head["gloss"] = branches.look().gloss();
  std::vector<WireSegment> segments = largest_first(Weaver(branches).weave());
  part.add("/segments", std::span(reinterpret_cast<const std::uint8_t*>(segments.data()),
                                  sizeof(WireSegment) * segments.size()));
  return part;
}

}  // namespace frond
