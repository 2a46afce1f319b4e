#include <algorithm>
#include <cmath>

#include "images/leaf.h"

namespace frond {

namespace {

constexpr int kBoundPoints = 64;  // of the rim, that bounds are taken from

/// Leaves that spread from the end of the stalk; the outermost first, so that those within lie above them.
std::vector<LeafPlace> digitate_places(const Sprig& s) {
  std::vector<LeafPlace> places;
  Vec2 end(0, static_cast<float>(1 - s.length));
  // Without a leaf at the tip the gap between the innermost is as wide as the others.
  double first = s.end_leaf ? 0 : 0.5, last = s.pairs - first;
  for (int i = s.pairs; i > 0; --i) {
    double share = last > 0 ? (i - first) / last : 1;
    for (int side : {1, -1})
      places.push_back({end, side * s.angle * share, s.length * (1 - s.shrink * share * share)});
  }
  if (s.end_leaf || places.empty()) places.push_back({end, 0, s.length});
  return places;
}

}  // namespace

std::vector<LeafPlace> sprig_places(const Sprig& s) {
  if (s.arrangement == SprigArrangement::digitate) return digitate_places(s);
  constexpr double kLowestLeaf = 0.14, kHighestLeaf = 0.92;  // of the stalk, where no leaf is at its end
  constexpr double kBelowEnd = 0.35;  // of a leaf's length: from the last pair to the end leaf
  constexpr double kCloser = 0.25;    // share by which leaves at the tip lean more forward
  std::vector<LeafPlace> places;
  double top = s.end_leaf ? 1 - s.length * (1 - s.shrink) : kHighestLeaf, low = kLowestLeaf;
  double end = s.end_leaf ? top - kBelowEnd * s.length : top;
  for (int i = 0; i < s.pairs; ++i) {
    double t = s.pairs > 1 ? static_cast<double>(i) / (s.pairs - 1) : 0.5,
           gap = (end - low) / std::max(s.pairs, 2);
    // The longest is a little above the foot.
    double size = s.length * (1 - s.shrink * t) * (0.82 + 0.18 * std::sin(kPi * std::min(1.0, t + 0.35)));
    for (int side : {1, -1}) {
      double y = low + (end - low) * t + (side < 0 ? 0.5 * gap * s.alternate : 0);
      places.push_back({Vec2(0, y), side * s.angle * (1 - kCloser * t), size});
    }
  }
  if (s.end_leaf) places.push_back({Vec2(0, top), 0, 1 - top});
  return places;
}

PictureFrame picture_frame(const LeafImage& leaf) {
  std::vector<Vec2> rim = leaf_rim(leaf.outline, kBoundPoints);
  std::vector<LeafPlace> places = leaf.sprig ? sprig_places(leaf.sprigs) : std::vector<LeafPlace>{{}};
  PictureFrame frame{0.02, 0, leaf.sprig ? 0.0 : 1.0};
  for (const LeafPlace& p : places) {
    if (leaf.sprig) frame.high = std::max(frame.high, p.foot.y + 0.02);  // the stalk
    double c = std::cos(p.turn), s = std::sin(p.turn);
    for (Vec2 q : rim)
      for (double x : {static_cast<double>(q.x), -static_cast<double>(q.x)}) {
        double y = p.foot.y + p.size * (q.y * c - x * s);
        frame.half = std::max(frame.half, std::abs(p.foot.x + p.size * (x * c + q.y * s)));
        frame.low = std::min(frame.low, y);
        frame.high = std::max(frame.high, y);
      }
  }
  frame.half *= 1.02;
  // The foot and the tip of a leaf touch the edges; whatever goes farther keeps a little off them.
  double edge = 0.02 * (frame.high - frame.low);
  if (leaf.sprig || frame.low < 0) frame.low -= edge;
  if (leaf.sprig || frame.high > 1) frame.high += edge;
  return frame;
}

}  // namespace frond
