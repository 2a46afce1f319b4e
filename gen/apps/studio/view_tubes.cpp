#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>

#include "draw/sweep.h"
#include "studio/tiles.h"
#include "studio/view.h"

namespace frond {

namespace {

using Bytes4 = std::array<std::int8_t, 4>;
using Rgba = std::array<std::uint8_t, 4>;

/// A segment as it goes over the wire. The last bytes of the headings say at which angle about `from_heading`
/// pictures begin, in 65536ths of a turn; those of the colours where on the picture `from` lies along the
/// branch, in 65536ths of it.
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

Vec3 unit_across(Vec3 way, bool from_x) {
  return glm::normalize(glm::cross(way, from_x ? Vec3(1, 0, 0) : Vec3(0, 0, 1)));
}

/// What stands across `from` turned as that is by the shortest way to `to`.
Vec3 carried(Vec3 axis, Vec3 from, Vec3 to) {
  float whole = std::max(1 + glm::dot(from, to), 1e-3f);
  return direction_or(axis - (from + to) * (glm::dot(axis, to) / whole), axis);
}

/// A heading as the page knows it.
Vec3 unpacked(Bytes4 heading) {
  return glm::normalize(Vec3(heading[0], heading[1], heading[2]) / 127.0f + Vec3(0, 1e-4f, 0));
}

/// The angle about a heading, in 65536ths of a turn, from where the page finds that 0 is.
std::uint32_t angle_of(Vec3 axis, Bytes4 heading) {
  Vec3 way = unpacked(heading),
       first = unit_across(way, std::abs(static_cast<float>(heading[0])) / 127.0f < 0.7f);
  float turn = std::atan2(glm::dot(axis, glm::cross(way, first)), glm::dot(axis, first));
  return static_cast<std::uint32_t>(std::lround(65536 * (turn / static_cast<float>(2 * kPi) + 1))) & 65535u;
}

/// The segments of a branch from its foot to its tip, which are sent one behind the other.
struct Axis {
  std::int32_t parent = -1;  ///< the one that it stands on
  std::size_t first = 0;     ///< segment
};

/// The largest branches first, those of like sizes strewn evenly, none before the one that it stands on: any
/// number of the first segments is a plant that hangs together, the best picture that so many make.
std::vector<WireSegment> largest_first(const std::vector<WireSegment>& segments,
                                       const std::vector<Axis>& axes) {
  struct Rank {
    std::uint32_t size = 0;   ///< four to each power of two; no larger than that of what it stands on
    std::uint32_t level = 0;  ///< how many of this size it stands on
    std::uint32_t strewn = 0;
    std::size_t axis = 0;
  };
  auto end_of = [&](std::size_t k) { return k + 1 < axes.size() ? axes[k + 1].first : segments.size(); };
  std::vector<Rank> ranks(axes.size());
  for (std::size_t k = 0; k < axes.size(); ++k) {
    float area = 0;
    for (std::size_t i = axes[k].first; i < end_of(k); ++i)
      area += glm::distance(segments[i].from, segments[i].to) *
              std::max(segments[i].from_radius, segments[i].to_radius);
    area /= static_cast<float>(std::max<std::size_t>(1, end_of(k) - axes[k].first));
    ranks[k] = {std::bit_cast<std::uint32_t>(area) >> 21, 0, static_cast<std::uint32_t>(k) * 2654435769u, k};
    if (axes[k].parent < 0) continue;
    const Rank& below = ranks[static_cast<std::size_t>(axes[k].parent)];
    if (below.size > ranks[k].size) continue;
    ranks[k].size = below.size, ranks[k].level = below.level + 1;
  }
  std::ranges::sort(ranks, [](const Rank& a, const Rank& b) {
    return std::tuple(b.size, a.level, a.strewn, a.axis) < std::tuple(a.size, b.level, b.strewn, b.axis);
  });
  std::vector<WireSegment> sorted;
  sorted.reserve(segments.size());
  for (const Rank& rank : ranks)
    sorted.insert(sorted.end(), segments.begin() + static_cast<std::ptrdiff_t>(axes[rank.axis].first),
                  segments.begin() + static_cast<std::ptrdiff_t>(end_of(rank.axis)));
  return sorted;
}

/// Builds the segments of one skeleton.
class Weaver {
 public:
  /// Builds the segments of one bark of the branches; pictures on the bark repeat after `high` metres.
  Weaver(const DrawnBranches& branches, double high, std::size_t bark)
      : branches_(branches),
        bark_(bark),
        rest_(branches.rest()),
        pose_(branches.pose),
        colors_(branches),
        longest_(rest_.longest()),
        high_(static_cast<float>(high)),
        along_(rest_.size()),
        axis_of_(rest_.size(), -1) {
    segments_.reserve(rest_.size() + rest_.size() / 8);
  }

  /// The segments, see largest_first().
  std::vector<WireSegment> weave() && {
    auto n = static_cast<std::int32_t>(rest_.size());
    for (std::int32_t i = 0; i < n; ++i) {
      if (rest_.parent[i] == Skeleton::kRoot || rest_.birth[rest_.parent[i]] >= pose_.front) continue;
      add(i, i + 1 < n && rest_.parent[i + 1] == i && rest_.birth[i] < pose_.front && worn_at(i + 1));
    }
    return largest_first(segments_, axes_);
  }

 private:
  bool worn_at(std::int32_t i) const {
    const BranchLook& look = branches_.look();
    return look.others.empty() || look.other(look.color_at(branches_.model, i)) == bark_;
  }

  void add(std::int32_t i, bool goes_on) {
    std::int32_t below = rest_.parent[i];
    WireSegment s;
    s.from = pose_.position[below], s.to = pose_.position[i];
    s.from_radius = pose_.radius[below], s.to_radius = pose_.radius[i];
    float length = glm::distance(s.from, s.to);
    along_[i] = along_[below] + length;
    axis_of_[i] = axis_of_[below];
    if (!(length > 1e-7f) || !worn_at(i)) return;
    Vec3 heading = (s.to - s.from) / length, from_heading = heading;
    if (below == i - 1 && !segments_.empty() && last_ == below) {
      from_heading = last_heading_;
    } else {
      if (below != i - 1) s.from_radius = foot_radius(rest_, pose_, i);
      axis_ = first_axis(i);
      axes_.push_back({axis_of_[below], segments_.size()});
      axis_of_[i] = static_cast<std::int32_t>(axes_.size()) - 1;
    }
    Vec3 to_heading = goes_on ? heading_at(i, heading) : heading;
    s.from_color = packed(colors_.at(below, i)), s.to_color = packed(colors_.at(i, i));
    lay(s, along_[below], from_heading, to_heading);
    segments_.push_back(s);
    last_ = i, last_heading_ = to_heading;
    if (!goes_on) round_off(s, heading);
  }

  /// The direction that a ring within a branch faces: from a radius below to a radius above it, as rings of a
  /// thick branch of short internodes would cut into each other if each stood across the next internode.
  Vec3 heading_at(std::int32_t i, Vec3 otherwise) const {
    constexpr int kMost = 64;  // nodes
    auto n = static_cast<std::int32_t>(rest_.size());
    Vec3 at = pose_.position[i], low = pose_.position[rest_.parent[i]], high = pose_.position[i + 1];
    auto near = [&](Vec3 end) { return glm::distance(at, end) < pose_.radius[i]; };
    auto goes_on = [&](std::int32_t k) { return k > 0 && k < n && rest_.parent[k] == k - 1; };
    for (std::int32_t k = i; k > i - kMost && goes_on(k) && near(low); --k) low = pose_.position[k - 1];
    for (std::int32_t k = i + 1; k < i + kMost && goes_on(k) && near(high); ++k) high = pose_.position[k];
    Vec3 below = direction(low, at, otherwise);
    return direction(Vec3(0), below + direction(at, high, below), otherwise);
  }

  /// Half a ball on the end of a branch, where it is thick enough for that to show.
  void round_off(WireSegment s, Vec3 heading) {
    float r = s.to_radius;
    Vec3 end = s.to;
    s.from_color = s.to_color;
    float along = along_[static_cast<std::size_t>(last_)];
    auto cap = [&](float to, float radius) {
      s.from = s.to, s.from_radius = s.to_radius;
      s.to = end + heading * (to * r), s.to_radius = radius * r;
      lay(s, along + glm::distance(end, s.from), heading, heading);
      segments_.push_back(s);
    };
    if (r > kRound * longest_) cap(0.5f, 0.866f), cap(0.87f, 0.5f);
    cap(1, 0);
  }

  /// Where pictures begin round the foot of a branch; it turns with that.
  Vec3 first_axis(std::int32_t i) const {
    Vec3 way = direction(rest_.position[rest_.parent[i]], rest_.position[i], Vec3(0, 1, 0)),
         axis = unit_across(way, std::abs(way.x) < 0.7f);
    return pose_.turn.empty() ? axis : pose_.turn[i] * axis;
  }

  /// Says how pictures lie on a segment; the axis goes on with it without a twist.
  void lay(WireSegment& s, float along, Vec3 from, Vec3 to) {
    s.from_heading = packed(from), s.to_heading = packed(to);
    float share = along / high_;
    std::uint32_t angle = angle_of(axis_, s.from_heading),
                  place = static_cast<std::uint32_t>(65536 * (share - std::floor(share)));
    s.from_heading[3] = static_cast<std::int8_t>(angle & 255),
    s.to_heading[3] = static_cast<std::int8_t>(angle >> 8);
    s.from_color[3] = static_cast<std::uint8_t>(place), s.to_color[3] = static_cast<std::uint8_t>(place >> 8);
    axis_ = carried(axis_, unpacked(s.from_heading), unpacked(s.to_heading));
  }

  const DrawnBranches& branches_;
  std::size_t bark_;
  const Skeleton& rest_;
  const Pose& pose_;
  BranchColors colors_;
  float longest_, high_;
  std::vector<float> along_;           // metres from the root, of each node
  std::vector<std::int32_t> axis_of_;  // of each node: the one whose segment ends there; -1: none
  std::vector<Axis> axes_;
  std::vector<WireSegment> segments_;
  std::int32_t last_ = -1;
  Vec3 last_heading_{0}, axis_{1, 0, 0};
};

}  // namespace

std::vector<DrawnPart> tubes_parts(const DrawnBranches& branches) {
  std::vector<DrawnPart> parts;
  const BranchLook& look = branches.look();
  for (std::size_t k = 0; k <= look.others.size(); ++k) {
    std::optional<Tile> tile = tile_of(look, look.color_of(k));
    std::vector<WireSegment> segments = Weaver(branches, tile ? tile->high : 1, k).weave();
    if (k > 0 && segments.empty()) continue;
    DrawnPart& part = parts.emplace_back();
    part.head["kind"] = "tubes";
    part.head["gloss"] = look.gloss(look.color_of(k));
    if (tile) part.head["tile"] = json_of(*tile);
    part.add("/segments", std::span(reinterpret_cast<const std::uint8_t*>(segments.data()),
                                    sizeof(WireSegment) * segments.size()));
  }
  return parts;
}

}  // namespace frond
