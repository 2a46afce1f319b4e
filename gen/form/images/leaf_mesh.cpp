#include <algorithm>
#include <cmath>

#include "geometry/outline.h"
#include "images/leaf_half.h"

namespace frond {

namespace {

constexpr double kStalkWidth = 0.018;  // half, as a share of a leaf's length

/// What leaves of one mesh share.
struct Bending {
  double fold, bend;
  PictureFrame frame;
  LeafCurl curl;

  Vec2 uv(Vec2 p) const {
    return Vec2(0.5 + 0.5 * p.x / frame.half, (p.y - frame.low) / (frame.high - frame.low));
  }
};

/// The flat picture folded and bent: a point of the sprig's plane, raised above it by `lift`.
Vec3 bent(Vec2 p, double lift, const Bending& b) {
  double y = p.y, z = lift;
  if (std::abs(b.bend) > 1e-4) {
    double angle = b.bend * p.y, radius = 1 / b.bend;
    y = std::sin(angle) * (radius + lift);
    z = std::cos(angle) * (radius + lift) - radius;
  }
  return {p.x, static_cast<float>(y), static_cast<float>(z)};
}

/// A point of the blade as it lies curled about its middle: each spoke is an arc of its own.
Vec3 curled(Vec2 q, Vec2 middle, const LeafCurl& curl) {
  Vec2 off = q - middle;
  double r = glm::length(off), a = std::atan2(off.x, off.y), p = curl.phase;
  double arc = curl.share * (1.1 + 1.0 * std::sin(2 * a + p) + 0.7 * std::sin(3 * a + 2.3 * p) +
                             0.6 * std::sin(7 * a + 3.1 * p));
  double turn = arc * r, lift = std::abs(arc) > 1e-4 ? (1 - std::cos(turn)) / arc : 0;
  double near = std::abs(arc) > 1e-4 ? std::sin(turn) / turn : 1;
  // Between the veins the blade buckles.
  lift += 0.05 * curl.share * r * std::sin(26 * q.y + 3 * p) * std::sin(21 * std::abs(q.x) + p);
  Vec2 at = r > 1e-6 ? middle + off * static_cast<float>(near) : middle;
  return {at, static_cast<float>(lift)};
}

/// The blade of a leaf that curls: spokes from its middle to the rim, and rings.
void add_curled(Surface& s, const LeafImage& leaf, int points, const Bending& b) {
  constexpr std::uint32_t kRings = 10;
  std::vector<Vec2> rim = leaf_rim(leaf.outline, points);
  for (std::size_t i = rim.size() - 2; i > 0; --i) rim.emplace_back(-rim[i].x, rim[i].y);
  Vec2 middle(0, leaf_middle(leaf.outline));
  auto add = [&](Vec2 q) {
    Vec3 at = curled(q, middle, b.curl);
    s.position.push_back(bent(Vec2(at), at.z + std::abs(q.x) * std::tan(b.fold), b));
    s.uv.push_back(b.uv(q));
  };
  auto count = static_cast<std::uint32_t>(rim.size());
  add(middle);
  for (std::uint32_t ring = 1; ring <= kRings; ++ring)
    for (Vec2 q : rim) add(glm::mix(middle, q, static_cast<float>(ring) / kRings));
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t next = (i + 1) % count;
    s.triangle.push_back({0, 1 + next, 1 + i});
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      std::uint32_t in = 1 + ring * count, out = in + count;
      add_quad(s, in + i, in + next, out + next, out + i);
    }
  }
}

/// The halves of a leaf, which all leaves of a sprig share.
struct Halves {
  HalfBlade right, left;
};

/// One leaf where it lies on its sprig; `above` keeps leaves apart that cross.
void add_leaf(Surface& s, const LeafImage& leaf, const LeafPlace& place, int points, const Halves& halves,
              const Bending& b, double above) {
  auto c = static_cast<float>(std::cos(place.turn)), n = static_cast<float>(std::sin(place.turn));
  auto size = static_cast<float>(place.size);
  double slope = std::tan(b.fold);
  auto add = [&](Vec2 q, double up = 0) {
    // A leaf on a sprig also droops a little by itself.
    Vec2 p = place.foot + size * Vec2(q.x * c + q.y * n, -q.x * n + q.y * c);
    double lift = above + place.size * (up + std::abs(q.x) * slope - (leaf.sprig ? 0.22 * q.y * q.y : 0));
    s.position.push_back(bent(p, lift, b));
    s.uv.push_back(b.uv(p));
  };
  auto add_half = [&](int side) {
    auto start = static_cast<std::uint32_t>(s.position.size());
    // The picture mirrors the leaflets of the left side.
    const HalfBlade& half = (place.turn < 0) == (side < 0) ? halves.right : halves.left;
    for (Vec3 p : half.point) add(Vec2(p.x * static_cast<float>(side), p.y), p.z);
    for (auto [i, j, k] : half.triangle) {
      if (side < 0) std::swap(j, k);
      s.triangle.push_back({start + i, start + j, start + k});
    }
  };
  if (b.curl.share > 0)
    add_curled(s, leaf, points, b);
  else
    add_half(1), add_half(-1);
  // The stalk.
  double w = kStalkWidth * (points < 6 ? 1.6 : 1), foot = leaf.outline.stalk + 0.02;
  if (leaf.outline.stalk <= 0) return;
  auto start = static_cast<std::uint32_t>(s.position.size());
  for (Vec2 q : {Vec2(-w, 0), Vec2(w, 0), Vec2(w * 0.7, foot), Vec2(-w * 0.7, foot)}) add(q);
  add_quad(s, start, start + 1, start + 2, start + 3);
}

void add_rachis(Surface& s, double top, const Bending& b) {
  constexpr int kPieces = 6;
  auto start = static_cast<std::uint32_t>(s.position.size());
  for (int i = 0; i <= kPieces; ++i) {
    double t = static_cast<double>(i) / kPieces, w = 0.010 * (1 - 0.6 * t);
    for (double x : {-w, w}) {
      Vec2 p(x, t * top);
      s.position.push_back(bent(p, 0, b));
      s.uv.push_back(b.uv(p));
    }
  }
  stitch_rows(s, start, kPieces + 1, 2);
}

}  // namespace

Surface leaf_mesh(const LeafImage& leaf, int points, double fold, double bend, const LeafCurl& curl) {
  Surface s;
  Bending b{fold, bend, picture_frame(leaf), leaf.sprig ? LeafCurl{} : curl};
  Halves halves;
  if (b.curl.share <= 0)
    halves = {pleated_half(leaf.outline, points, 1, leaf.pleat),
              pleated_half(leaf.outline, points, -1, leaf.pleat)};
  if (leaf.sprig) {
    std::vector<LeafPlace> places = sprig_places(leaf.sprigs);
    double top = 0;
    for (const LeafPlace& p : places) top = std::max<double>(top, p.foot.y + 0.02);
    add_rachis(s, top, b);
    for (std::size_t i = 0; i < places.size(); ++i)
      add_leaf(s, leaf, places[i], points, halves, b, 0.004 * static_cast<double>(i % 3));
  } else {
    add_leaf(s, leaf, {}, points, halves, b, 0);
  }
  set_normals(s);
  return s;
}

}  // namespace frond
