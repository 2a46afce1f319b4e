#include "masonry/bridge.h"

#include <algorithm>
#include <cmath>

#include "masonry/bridge_parts.h"

namespace frond {

namespace {

/// Boards laid across. None is quite as long, as level or as square as the next.
void lay_planks(const BridgeShape& shape, Bridge& bridge, double board, Seed seed) {
  double half = half_length(bridge.arch);
  int count = std::max(1, static_cast<int>(std::lround(2 * half / (shape.plank + shape.gap))));
  double pitch = 2 * half / count, wide = std::max(pitch - shape.gap, 0.3 * pitch);
  for (int i = 0; i < count; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i));
    double play = std::min(0.035, 0.03 * shape.width), shorter = play * own.child("length").unit();
    double aside = shorter * own.child("aside").range(-0.5, 0.5);
    double lower = 0.06 * board * own.child("lower").unit();
    ArchPoint on = arch_at(bridge.arch, -half + (i + 0.5) * pitch);
    Surface surface = block_surface(
        {Vec3(real(shape.width - shorter), real(board), real(wide)), real(0.1 * board), {6, 1, 1}});
    // A little wind in the board.
    float warp = real(0.05 * board * own.child("warp").range(-1, 1));
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
  double half = half_length(bridge.arch), wide = std::clamp(0.5 * bridge.thickness, 0.04, 0.16 * shape.width);
  std::vector<double> lines{-edge, edge}, joints{-half};
  if (shape.width > 1.4) lines.push_back(0);
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
    double thick = 1.4 * wide, top = -1.15 * board;
    Surface sill = block_surface(
        {Vec3(real(shape.width * 0.98), real(shape.foundation), real(thick)), 0.015f, {3, 1, 1}});
    bridge.pieces.push_back(
        {BridgePart::stringer, std::move(sill),
         Vec3(real(side * (shape.length / 2 - thick / 2)), real(top - shape.foundation / 2), 0),
         glm::angleAxis(real(kPi / 2), Vec3(0, 1, 0))});
  }
}

/// The bars that run along between the posts of one railing: each bay has timber of its own, let into the
/// posts.
void lay_rails(const BridgeShape& shape, Bridge& bridge, const std::vector<double>& stations, double z) {
  double deep = 0.75 * shape.rail, past = 0.7 * shape.post;
  std::vector<double> ends = stations;
  ends.front() -= past, ends.back() += past;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    auto bar = [&](BridgePart part, double low, double high, double wide, float bevel) {
      bridge.pieces.push_back(
          bar_piece(bridge.arch, part,
                    {ends[i], ends[i + 1], low, high, z - wide / 2, z + wide / 2, bevel, 10, 1, true}));
    };
    bar(BridgePart::hand_rail, shape.rail_height - deep, shape.rail_height, shape.rail, real(0.3 * deep));
    if (shape.lower_rail <= 0) continue;
    double thin = 0.7 * deep;
    bar(BridgePart::lower_rail, shape.lower_rail - thin / 2, shape.lower_rail + thin / 2, 0.62 * shape.rail,
        real(0.15 * thin));
  }
}

void lay_balusters(const BridgeShape& shape, Bridge& bridge, const std::vector<double>& stations, double z) {
  double wide = 0.32 * shape.post, sunk = 0.01;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    for (int k = 1; k <= shape.balusters; ++k) {
      double s = stations[i] + (stations[i + 1] - stations[i]) * k / (shape.balusters + 1);
      ArchPoint on = arch_at(bridge.arch, s);
      double foot = on.at.y + (shape.lower_rail > 0 ? shape.lower_rail : 0) - sunk;
      BridgePiece bar = post_piece(Vec2(on.at.x, z), foot, on.at.y + shape.rail_height - 0.5 * shape.rail,
                                   wide, real(0.12 * wide));
      bar.part = BridgePart::baluster;
      bridge.pieces.push_back(std::move(bar));
    }
  }
}

}  // namespace

std::vector<double> post_stations(const Arch& arch, const BridgeShape& shape) {
  // The last gap of each half is half a gap, so that the spacing goes on across mid-span.
  double margin = std::min(0.75 * shape.post, 0.25 * half_length(arch)), first = half_length(arch) - margin;
  double gap = first / (shape.posts - 0.5);
  std::vector<double> stations;
  for (int i = 0; i < shape.posts; ++i) stations.push_back(-first + i * gap);
  for (int i = shape.posts - 1; i >= 0; --i) stations.push_back(first - i * gap);
  return stations;
}

void build_wooden(const BridgeShape& shape, Bridge& bridge, Seed seed) {
  double board = std::clamp(0.2 * bridge.thickness, 0.3 * std::min(bridge.thickness, 0.06), 0.06);
  double edge = shape.width / 2 - std::min(0.9 * shape.post, 0.2 * shape.width);
  std::vector<double> stations = post_stations(bridge.arch, shape);
  lay_planks(shape, bridge, board, seed.child("plank"));
  lay_stringers(shape, bridge, stations, board, edge);
  for (double z : {-edge, edge}) {
    for (double s : stations) {
      glm::dvec2 on = arch_at(bridge.arch, s).at;
      // Down to the stringer, on which it stands, and up past the hand rail.
      double foot = std::min(arch_height(bridge.arch, on.x - shape.post / 2),
                             arch_height(bridge.arch, on.x + shape.post / 2));
      double head = on.y + shape.rail_height + 0.45 * shape.post;
      bridge.pieces.push_back(
          post_piece(Vec2(on.x, z), std::min(foot, on.y) - board, head, shape.post, real(0.08 * shape.post)));
      bridge.pieces.push_back(cap_piece(Vec2(on.x, z), head, shape.post));
    }
    lay_rails(shape, bridge, stations, z);
    lay_balusters(shape, bridge, stations, z);
  }
}

Bridge build_bridge(const BridgeShape& shape, Seed seed) {
  double crown = shape.crown > 0 ? shape.crown : seed.child("crown").range(0.1, 0.5);
  Bridge bridge;
  bridge.arch = make_arch(shape.length, shape.height, crown);
  bridge.thickness = std::min(shape.thickness, 0.8 * least_radius(bridge.arch));
  if (shape.style == BridgeStyle::wood)
    build_wooden(shape, bridge, seed);
  else
    build_stone(shape, bridge, seed);
  return bridge;
}

}  // namespace frond
