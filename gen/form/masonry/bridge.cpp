#include "masonry/bridge.h"

#include <algorithm>
#include <cmath>

#include "masonry/bridge_parts.h"

namespace frond {

namespace {

// All sizes are by eye.

/// Boards laid across. None is quite as long, as level or as square as the next.
void lay_planks(const BridgeShape& shape, Bridge& bridge, double board, Seed seed) {
  constexpr double kMostPlay = 0.035, kMostPlayShare = 0.03;  // in the length of boards: metres; share of it
  constexpr double kLower = 0.06, kWarp = 0.05;               // of a board's thickness, at most
  constexpr double kBevel = 0.1;                              // of a board's thickness
  double half = half_length(bridge.arch);
  int count = std::max(1, static_cast<int>(std::lround(2 * half / (shape.plank + shape.gap))));
  double pitch = 2 * half / count, wide = std::max(pitch - shape.gap, 0.3 * pitch);
  for (int i = 0; i < count; ++i) {
    Seed own = seed.child(i);
    double play = std::min(kMostPlay, kMostPlayShare * shape.width),
           shorter = play * own.child("length").unit();
    double aside = shorter * own.child("aside").range(-0.5, 0.5);
    double lower = kLower * board * own.child("lower").unit();
    ArchPoint on = arch_at(bridge.arch, -half + (i + 0.5) * pitch);
    Surface surface = block_surface(
        {Vec3(real(shape.width - shorter), real(board), real(wide)), real(kBevel * board), {6, 1, 1}});
    // A little wind in the board.
    float warp = real(kWarp * board * own.child("warp").range(-1, 1));
    bend(surface, [&](Vec3 p) { return p + Vec3(0, warp * (2 * p.x * p.z / real(shape.width * wide)), 0); });
    glm::dvec2 at = on.at - on.up * (board / 2 + lower);
    Quat slope = glm::angleAxis(real(std::atan2(on.along.y, on.along.x)), Vec3(0, 0, 1));
    // Along z, and now and then the other way round.
    float sign = own.child("way").unit() < 0.5 ? 1.0f : -1.0f;
    Quat across = glm::angleAxis(sign * real(kPi / 2), Vec3(0, 1, 0));
    bridge.pieces.push_back(
        {BridgePart::plank, std::move(surface), Vec3(real(at.x), real(at.y), real(aside)), slope * across});
  }
}

/// Two or three beams under the planks, in pieces that meet under posts, and a sill under each end.
void lay_stringers(const BridgeShape& shape, Bridge& bridge, const std::vector<double>& stations,
                   double board, double edge) {
  constexpr double kWide = 0.5;                           // of the deck's thickness: width of a beam
  constexpr double kNarrowest = 0.04, kMostShare = 0.16;  // width of a beam: metres; share of the bridge's
  constexpr double kTwoBeams = 1.4;                       // metres of the bridge's width that two can carry
  constexpr double kSillThick = 1.4, kSillBelow = 1.15;  // of a beam's width; of a board, from the deck's top
  constexpr double kSillLong = 0.98;                     // of the bridge's width
  double half = half_length(bridge.arch),
         wide = std::clamp(kWide * bridge.thickness, kNarrowest, kMostShare * shape.width);
  std::vector<double> lines{-edge, edge}, joints{-half};
  if (shape.width > kTwoBeams) lines.push_back(0);
  for (std::size_t i = 1; i + 1 < stations.size(); i += 2) joints.push_back(stations[i]);
  if (joints.size() > 1 && half - joints.back() < 0.5 * shape.post) joints.pop_back();
  joints.push_back(half);
  for (double z : lines)
    for (std::size_t i = 0; i + 1 < joints.size(); ++i)
      bridge.pieces.push_back(bar_piece(
          bridge.arch, BridgePart::stringer,
          {joints[i], joints[i + 1], -bridge.thickness, -board, z - wide / 2, z + wide / 2, 0.012f, 10}));
  if (shape.foundation <= 0) return;
  for (double side : {-1.0, 1.0}) {
    double thick = kSillThick * wide, top = -kSillBelow * board;
    Surface sill = block_surface(
        {Vec3(real(shape.width * kSillLong), real(shape.foundation), real(thick)), 0.015f, {3, 1, 1}});
    bridge.pieces.push_back(
        {BridgePart::stringer, std::move(sill),
         Vec3(real(side * (shape.length / 2 - thick / 2)), real(top - shape.foundation / 2), 0),
         glm::angleAxis(real(kPi / 2), Vec3(0, 1, 0))});
  }
}

/// The bars that run along between the posts of one railing: each bay has timber of its own, let into the
/// posts.
void lay_rails(const BridgeShape& shape, Bridge& bridge, const std::vector<double>& stations, double z) {
  constexpr double kDeep = 0.75, kBevel = 0.3;       // hand rail: of its width; of its depth
  constexpr double kLowDeep = 0.7, kLowWide = 0.62;  // lower rail: of the hand rail's depth and width
  constexpr double kLowBevel = 0.15;                 // of its own depth
  constexpr double kPast = 0.7;                      // of a post's width: how far rails go past the last
  double deep = kDeep * shape.rail, past = kPast * shape.post;
  std::vector<double> ends = stations;
  ends.front() -= past, ends.back() += past;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    auto bar = [&](BridgePart part, double low, double high, double wide, float bevel) {
      bridge.pieces.push_back(
          bar_piece(bridge.arch, part,
                    {ends[i], ends[i + 1], low, high, z - wide / 2, z + wide / 2, bevel, 10, 1, true}));
    };
    bar(BridgePart::hand_rail, shape.rail_height - deep, shape.rail_height, shape.rail, real(kBevel * deep));
    if (shape.lower_rail <= 0) continue;
    double thin = kLowDeep * deep;
    bar(BridgePart::lower_rail, shape.lower_rail - thin / 2, shape.lower_rail + thin / 2,
        kLowWide * shape.rail, real(kLowBevel * thin));
  }
}

void lay_balusters(const BridgeShape& shape, Bridge& bridge, const std::vector<double>& stations, double z) {
  constexpr double kWide = 0.32, kBevel = 0.12;  // of a post's width; of a baluster's
  double wide = kWide * shape.post, sunk = 0.01;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    for (int k = 1; k <= shape.balusters; ++k) {
      double s = stations[i] + (stations[i + 1] - stations[i]) * k / (shape.balusters + 1);
      ArchPoint on = arch_at(bridge.arch, s);
      double foot = on.at.y + (shape.lower_rail > 0 ? shape.lower_rail : 0) - sunk;
      BridgePiece bar = post_piece(Vec2(on.at.x, z), foot, on.at.y + shape.rail_height - 0.5 * shape.rail,
                                   wide, real(kBevel * wide));
      bar.part = BridgePart::baluster;
      bridge.pieces.push_back(std::move(bar));
    }
  }
}

void build_wooden(const BridgeShape& shape, Bridge& bridge, Seed seed) {
  constexpr double kBoard = 0.2, kLeastBoard = 0.3;  // of the deck's thickness
  constexpr double kThickest = 0.06;                 // metres of a board
  constexpr double kEdge = 0.9, kMostEdge = 0.2;     // from the side to a post: of its width; of the bridge's
  constexpr double kPastRail = 0.45, kBevel = 0.08;  // of a post's width
  double board =
      std::clamp(kBoard * bridge.thickness, kLeastBoard * std::min(bridge.thickness, kThickest), kThickest);
  double edge = shape.width / 2 - std::min(kEdge * shape.post, kMostEdge * shape.width);
  std::vector<double> stations = post_stations(bridge.arch, shape);
  lay_planks(shape, bridge, board, seed.child("plank"));
  lay_stringers(shape, bridge, stations, board, edge);
  for (double z : {-edge, edge}) {
    for (double s : stations) {
      glm::dvec2 on = arch_at(bridge.arch, s).at;
      // Down to the stringer, on which it stands, and up past the hand rail.
      double foot = std::min(arch_height(bridge.arch, on.x - shape.post / 2),
                             arch_height(bridge.arch, on.x + shape.post / 2));
      double head = on.y + shape.rail_height + kPastRail * shape.post;
      bridge.pieces.push_back(post_piece(Vec2(on.x, z), std::min(foot, on.y) - board, head, shape.post,
                                         real(kBevel * shape.post)));
      bridge.pieces.push_back(cap_piece(Vec2(on.x, z), head, shape.post));
    }
    lay_rails(shape, bridge, stations, z);
    lay_balusters(shape, bridge, stations, z);
  }
}

}  // namespace

std::vector<double> post_stations(const Arch& arch, const BridgeShape& shape) {
  constexpr double kMargin = 0.75, kMostMargin = 0.25;  // from the arch's feet: of a post's width; of a half
  // The last gap of each half is half a gap, so that the spacing goes on across mid-span.
  double margin = std::min(kMargin * shape.post, kMostMargin * half_length(arch)),
         first = half_length(arch) - margin;
  double gap = first / (shape.posts - 0.5);
  std::vector<double> stations;
  for (int i = 0; i < shape.posts; ++i) stations.push_back(-first + i * gap);
  for (int i = shape.posts - 1; i >= 0; --i) stations.push_back(first - i * gap);
  return stations;
}

Bridge build_bridge(const BridgeShape& shape, Seed seed) {
  constexpr double kPointed = 0.1, kRound = 0.5;  // bounds of Arch::crown
  constexpr double kMostOfRadius = 0.8;           // of the arch's least: thickness of the deck
  double crown = shape.crown > 0 ? shape.crown : seed.child("crown").range(kPointed, kRound);
  Bridge bridge;
  bridge.arch = make_arch(shape.length, shape.height, crown);
  bridge.thickness = std::min(shape.thickness, kMostOfRadius * least_radius(bridge.arch));
  if (shape.style == BridgeStyle::wood)
    build_wooden(shape, bridge, seed);
  else
    build_stone(shape, bridge, seed);
  return bridge;
}

}  // namespace frond
