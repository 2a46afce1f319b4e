#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "masonry/bridge_parts.h"

namespace frond {

namespace {

// Sizes are in metres and by eye, for bridges in gardens.

constexpr double kSet = 0.04;          // how far walls stand back behind the course at the deck's height
constexpr double kMortarBack = 0.018;  // how far mortar stands back behind the faces of stones
constexpr float kStoneBevel = 0.016f;  // of the edges of wedges and of stones in walls
constexpr double kLeastVault = 0.15;   // rise and half span below which there is no hole
constexpr double kLeastPiece = 0.3;    // of a stone's usual length, which joints leave at the ends of a row
constexpr int kBridgeBisections = 40;

/// Lengths of stones along their row, and heights of courses.
struct Stonework {
  double two_voussoirs = 0.56;                 ///< along the vault
  double vault_stone = 0.62;                   ///< across the vault
  double long_head = 0.46, short_head = 0.32;  ///< of the vault's outermost stones, in turn
  double jamb_course = 0.3;                    ///< under the feet of the vault
  double wall_course = 0.23, wall_stone = 0.42, wall_depth = 0.26;
  double string_stone = 0.7, string_proud = 0.03;  ///< of the course at the deck's height, above the paving
  double parapet_course = 0.22, parapet_stone = 0.40;
  double coping_stone = 0.75, coping_course = 0.13, coping_out = 0.045;  ///< out: beyond the parapet
};
constexpr Stonework kStones;

/// The hole under a stone bridge: half an ellipse over its springing line, in a ring of voussoirs.
struct Vault {
  double half = 0;               ///< of its span
  double spring = 0;             ///< height of the springing line
  double rise = 0;               ///< from there to its crown
  double ring = 0;               ///< depth of the voussoirs
  double paving = 0.1;           ///< depth of what lies on top
  std::vector<double> distance;  ///< along the ellipse, from its left foot
  static constexpr int kSteps = 512;
  bool open() const { return rise > kLeastVault && half > kLeastVault; }

  /// The place `out` metres outside the ellipse, `angle` from its crown.
  glm::dvec2 at(double angle, double out) const {
    double c = std::cos(angle), s = std::sin(angle);
    return glm::dvec2(half * s, spring + rise * c) + glm::normalize(glm::dvec2(rise * s, half * c)) * out;
  }
  /// Measures the ellipse; to be called once its size is known.
  void measure() {
    distance = {0};
    for (int i = 0; i < kSteps; ++i)
      distance.push_back(distance.back() + glm::distance(at(kPi * i / kSteps - kPi / 2, 0),
                                                         at(kPi * (i + 1) / kSteps - kPi / 2, 0)));
  }
  /// The angle that lies `along` metres along the ellipse from its left foot.
  double angle_at(double along) const {
    auto above = std::lower_bound(distance.begin() + 1, distance.end() - 1, along);
    double share = std::clamp((along - *(above - 1)) / (*above - *(above - 1)), 0.0, 1.0);
    return kPi * ((static_cast<double>(above - 1 - distance.begin()) + share) / kSteps - 0.5);
  }
  /// How high the outside of the ring lies over x, or the foot of the wall beside it.
  double outside(double x, double foot) const {
    if (!open() || std::abs(x) >= half + ring) return foot;
    double low = 0, high = kPi / 2;
    for (int i = 0; i < kBridgeBisections; ++i) {
      double middle = (low + high) / 2;
      (at(middle, ring).x < std::abs(x) ? low : high) = middle;
    }
    return at(low, ring).y;
  }
};

/// The widest vault with its crown at the deck's thickness that stays under the deck.
Vault fit_vault(const BridgeShape& shape, const Bridge& bridge) {
  constexpr double kPavingShare = 0.3, kMostPaving = 0.14;  // of the deck's thickness; at most
  constexpr double kDeepestSpring = 0.35;                   // below the feet of the bridge
  constexpr double kWidest = 0.37;  // of the bridge's length: half the span with the ring, at most
  constexpr double kSlack = 0.02;   // of the deck's thickness: the vault may cut into it
  constexpr int kSamples = 128;     // of half the ellipse
  Vault vault;
  vault.paving = std::min(kPavingShare * bridge.thickness, kMostPaving);
  vault.ring = bridge.thickness - vault.paving - 0.25 * shape.gap;
  vault.spring = -std::min(kDeepestSpring, shape.foundation / 2);
  vault.rise = shape.height - bridge.thickness - vault.spring;
  if (vault.rise <= kLeastVault) return vault;
  auto fits = [&](double half) {
    vault.half = half;
    for (int i = 0; i <= kSamples; ++i) {
      double angle = kPi / 2 * i / kSamples;
      glm::dvec2 in = vault.at(angle, 0), out = vault.at(angle, vault.ring);
      if (out.y > arch_height(bridge.arch, out.x) - vault.paving + 1e-9) return false;
      if (in.y > arch_height(bridge.arch, in.x) - bridge.thickness + kSlack * bridge.thickness) return false;
    }
    return true;
  };
  double low = 0, high = std::max(0.0, kWidest * shape.length - vault.ring);
  if (!fits(high))
    for (int i = 0; i < kBridgeBisections; ++i) (fits((low + high) / 2) ? low : high) = vault.half;
  vault.half = fits(high) ? high : low;
  vault.measure();
  return vault;
}

/// What the makers of the single parts share.
struct BridgeMason {
  const BridgeShape& shape;
  Bridge& bridge;
  Vault vault;
  double face;  ///< z of the walls
  double wall;  ///< thickness of the parapet

  void add(BridgePart part, Surface surface, Seed seed, float depth = 0.006f) const {
    constexpr float kLump = 0.16f;  // size of what stands out of a face by `depth`
    if (depth > 0) roughen(surface, depth, kLump, seed.child("rough"));
    bridge.pieces.push_back({part, std::move(surface), Vec3(0), Quat(1, 0, 0, 0)});
  }
};

/// Cuts a length into stones of about `size`, none alike; `shift` staggers the joints of courses.
std::vector<double> joints(double from, double to, double size, bool shift, Seed seed) {
  constexpr double kUneven = 0.22;  // of a stone's length, by which a joint is off
  int count = std::max(1, static_cast<int>(std::lround((to - from) / size)));
  double pitch = (to - from) / count;
  std::vector<double> cuts{from};
  for (int i = shift ? 0 : 1; i < count; ++i) {
    double at = from + (i + (shift ? 0.5 : 0.0) + kUneven * seed.child(i).range(-1, 1)) * pitch;
    if (at - from > kLeastPiece * pitch && to - at > kLeastPiece * pitch) cuts.push_back(at);
  }
  cuts.push_back(to);
  return cuts;
}

/// One wedge of the vault, between two distances along it and two depths.
void lay_voussoir(const BridgeMason& m, double from, double to, double near, double far, Seed seed) {
  double joint = m.shape.gap / 2;
  Vec3 size(real(to - from - 2 * joint), real(m.vault.ring), real(far - near - 2 * joint));
  if (size.x < 0.02f || size.z < 0.02f) return;
  Surface surface = block_surface({size, kStoneBevel, {3, 3, 3}});
  bend(surface, [&](Vec3 p) {
    glm::dvec2 at = m.vault.at(m.vault.angle_at((from + to) / 2 + p.x), m.vault.ring / 2 + p.y);
    return Vec3(at.x, at.y, (near + far) / 2 + p.z);
  });
  m.add(BridgePart::voussoir, std::move(surface), seed);
}

/// The vault: an odd number of courses, so that there is a keystone, each bonded across in turn; under its
/// feet the jambs.
void build_vault(const BridgeMason& m, Seed seed) {
  if (!m.vault.open()) return;
  double length = m.vault.distance.back();
  int count = std::max(5, 2 * static_cast<int>(length / kStones.two_voussoirs) + 1);
  auto course = [&](bool deep, Seed own, auto&& lay) {
    double head = std::min(deep ? kStones.long_head : kStones.short_head, 0.3 * m.face);
    lay(-m.face, -m.face + head, own.child("left"));
    std::vector<double> cuts =
        joints(-m.face + head, m.face - head, kStones.vault_stone, deep, own.child("cut"));
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) lay(cuts[k], cuts[k + 1], own.child(k));
    lay(m.face - head, m.face, own.child("right"));
  };
  for (int i = 0; i < count; ++i) {
    double from = length * i / count, to = length * (i + 1) / count;
    course(i % 2 == 0, seed.child("course", i),
           [&](double near, double far, Seed own) { lay_voussoir(m, from, to, near, far, own); });
  }
  double deep = m.vault.spring + m.shape.foundation, joint = m.shape.gap / 2;
  int rows = std::max(1, static_cast<int>(std::lround(deep / kStones.jamb_course)));
  if (deep < 0.05) return;
  for (double side : {-1.0, 1.0})
    for (int row = 0; row < rows; ++row)
      course(
          row % 2 == 1, seed.child(side < 0 ? "left jamb" : "right jamb", static_cast<std::uint64_t>(row)),
          [&](double near, double far, Seed own) {
            double high = deep / rows - 2 * joint;
            if (far - near < 0.04) return;
            Surface surface = block_surface(
                {Vec3(real(m.vault.ring), real(high), real(far - near - 2 * joint)), kStoneBevel, {2, 2, 2}});
            Vec3 at(side * (m.vault.half + m.vault.ring / 2), m.vault.spring - (row + 0.5) * deep / rows,
                    (near + far) / 2);
            bend(surface, [&](Vec3 p) { return p + at; });
            m.add(BridgePart::voussoir, std::move(surface), own);
          });
}

/// One stone of a wall, cut off by the ring below and by the deck above.
void lay_wall_stone(const BridgeMason& m, double from, double to, double low, double high, double side,
                    Seed seed) {
  constexpr int kProbes = 24;
  constexpr double kLeastHeight = 0.035, kLeastLength = 0.05;  // of what is worth laying
  double joint = m.shape.gap / 2, foot = -m.shape.foundation,
         thick = std::min(kStones.wall_depth, 0.3 * m.face);
  low += joint, high -= joint, from += joint, to -= joint;
  auto bottom = [&](double x) { return std::max(low, m.vault.outside(x, foot) + joint); };
  auto top = [&](double x) { return std::min(high, arch_height(m.bridge.arch, x) - m.vault.paving - joint); };
  // The longest stretch on which anything is left of it.
  int best = 0, best_from = 0;
  for (int i = 0, run = 0; i <= kProbes; ++i) {
    double x = from + (to - from) * i / kProbes;
    run = top(x) - bottom(x) > kLeastHeight ? run + 1 : 0;
    if (run > best) best = run, best_from = i - run + 1;
  }
  if (best < 2) return;
  double pitch = (to - from) / kProbes;
  to = from + pitch * (best_from + best - 1), from += pitch * best_from;
  if (to - from < kLeastLength) return;
  bool whole = bottom(from) == low && bottom(to) == low && top(from) == high && top(to) == high;
  Vec3 size(real(to - from), real(high - low), real(thick));
  Surface surface = block_surface({size, kStoneBevel, {whole ? 4 : 10, 3, 1}});
  bend(surface, [&](Vec3 p) {
    double x = (from + to) / 2 + p.x, b = bottom(x), t = std::max(top(x), b + 0.01);
    return Vec3(x, b + (t - b) * (0.5 + p.y / size.y), side * (m.face - thick / 2) + p.z);
  });
  m.add(BridgePart::wall, std::move(surface), seed);
}

/// The walls between ring and deck.
void build_walls(const BridgeMason& m, Seed seed) {
  double foot = -m.shape.foundation, top = m.shape.height - m.vault.paving, end = m.shape.length / 2;
  int rows = std::max(1, static_cast<int>(std::lround((top - foot) / kStones.wall_course)));
  for (double side : {-1.0, 1.0}) {
    Seed own = seed.child(side < 0 ? "left" : "right");
    std::vector<double> levels = joints(foot, top, (top - foot) / rows, false, own.child("levels"));
    for (std::size_t row = 0; row + 1 < levels.size(); ++row) {
      Seed course = own.child("course", row);
      std::vector<double> cuts = joints(-end, end, kStones.wall_stone, row % 2 == 1, course.child("cuts"));
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        lay_wall_stone(m, cuts[i], cuts[i + 1], levels[row], levels[row + 1], side, course.child(i));
    }
  }
}

/// Stones in a row along the deck, one bar each.
void lay_row(const BridgeMason& m, BridgePart part, Bar bar, double size, bool shift, Seed seed) {
  std::vector<double> cuts = joints(bar.from, bar.to, size, shift, seed.child("cuts"));
  double joint = m.shape.gap / 2;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    Bar own = bar;
    own.from = cuts[i] + joint, own.to = cuts[i + 1] - joint;
    if (own.to - own.from < 0.02) continue;
    own.cuts = 5, own.sides = 2;
    m.add(part, bar_surface(m.bridge.arch, own), seed.child(i),
          part == BridgePart::hand_rail ? 0.003f : 0.005f);
  }
}

/// The course that shows the line of the deck, and between the two sides the paving.
void build_deck(const BridgeMason& m, Seed seed) {
  double half = half_length(m.bridge.arch), out = m.shape.width / 2, in = out - kSet - m.wall;
  for (double side : {-1.0, 1.0}) {
    double near = side < 0 ? -out : in, far = side < 0 ? -in : out;
    lay_row(m, BridgePart::lower_rail, {-half, half, -m.vault.paving, kStones.string_proud, near, far, 0.02f},
            kStones.string_stone, false, seed.child(side < 0 ? "left" : "right"));
  }
  constexpr double kPavingLength = 1.6;  // of a paving stone across the bridge, in its lengths along it
  constexpr double kMostSunk = 0.008;    // by which one lies lower than others
  int rows = std::max(1, static_cast<int>(std::lround(2 * half / m.shape.plank)));
  double joint = m.shape.gap / 2;
  for (int row = 0; row < rows; ++row) {
    Seed own = seed.child("row", row);
    std::vector<double> cuts =
        joints(-in, in, kPavingLength * m.shape.plank, row % 2 == 1, own.child("cuts"));
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      double sunk = kMostSunk * own.child("sunk", i).unit();
      Surface surface = bar_surface(
          m.bridge.arch, {-half + 2 * half * row / rows + joint, -half + 2 * half * (row + 1) / rows - joint,
                          -m.vault.paving - sunk, -sunk, cuts[i] + joint, cuts[i + 1] - joint, 0.018f, 2, 2});
      m.add(BridgePart::plank, std::move(surface), own.child(i), 0.004f);
    }
  }
}

/// Piers that stand upright on the deck, and between them a wall under a coping that follows it.
void build_parapets(const BridgeMason& m, Seed seed) {
  constexpr double kWider = 0.08, kHigher = 0.06;  // of piers than the wall and its coping
  std::vector<double> stations = post_stations(m.bridge.arch, m.shape);
  double coping = std::min(kStones.coping_course, 0.3 * m.shape.rail_height),
         wide = std::max(m.shape.post, m.wall + kWider);
  double top = m.shape.rail_height - coping;
  for (double side : {-1.0, 1.0}) {
    Seed own = seed.child(side < 0 ? "left" : "right");
    double z = side * (m.shape.width / 2 - kSet - m.wall / 2), near = z - m.wall / 2, far = z + m.wall / 2;
    for (double s : stations) {
      glm::dvec2 on = arch_at(m.bridge.arch, s).at;
      double head = on.y + m.shape.rail_height + kHigher;
      double foot = std::min(
          {on.y, arch_height(m.bridge.arch, on.x - wide / 2), arch_height(m.bridge.arch, on.x + wide / 2)});
      m.bridge.pieces.push_back(post_piece(Vec2(on.x, z), foot - 0.3 * m.vault.paving, head, wide, 0.02f));
      m.bridge.pieces.push_back(cap_piece(Vec2(on.x, z), head, wide));
    }
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      Seed bay = own.child("bay", i);
      double from = stations[i] + 0.4 * wide, to = stations[i + 1] - 0.4 * wide;
      if (to - from < 0.05) continue;
      int rows = std::max(1, static_cast<int>(std::lround(top / kStones.parapet_course)));
      for (int row = 0; row < rows; ++row)
        lay_row(m, BridgePart::wall,
                {from, to, top * row / rows + (row > 0 ? 0.5 * m.shape.gap : 0),
                 top * (row + 1) / rows - 0.5 * m.shape.gap, near, far, kStoneBevel, 1, 1, true},
                kStones.parapet_stone, row % 2 == 1, bay.child("course", row));
      lay_row(m, BridgePart::hand_rail,
              {from, to, top, m.shape.rail_height, near - kStones.coping_out, far + kStones.coping_out,
               real(0.32 * coping), 1, 1, true},
              kStones.coping_stone, false, bay.child("coping"));
      m.add(BridgePart::core,
            bar_surface(m.bridge.arch, {from, to, -0.5 * m.vault.paving, top + 0.3 * coping,
                                        near + kMortarBack, far - kMortarBack, 0.004f, 12, 1, true}),
            bay, 0);
    }
  }
}

/// The mortar behind all joints, a little behind their faces: the outline of the bridge from side to side.
void build_core(const BridgeMason& m) {
  constexpr int kColumns = 160;
  double end = m.shape.length / 2 - 0.02, back = kMortarBack, z = m.face - back, foot = -m.shape.foundation;
  double hole = m.vault.open() ? m.vault.half + back : 0;
  std::vector<glm::dvec3> columns;  // x, lower and upper edge
  auto column = [&](double x, double low) {
    columns.push_back({x, low, std::max(low + 0.01, arch_height(m.bridge.arch, x) - 0.5 * m.vault.paving)});
  };
  for (int i = 0; i <= kColumns; ++i) {
    double x = end * (2.0 * i / kColumns - 1);
    if (hole > 0 && std::abs(std::abs(x) - hole) < 2e-3) continue;
    double share = hole > 0 ? x / hole : 1;
    column(x, std::abs(share) < 1 ? m.vault.spring + (m.vault.rise + back) * std::sqrt(1 - share * share)
                                  : foot);
  }
  // Both sides of the hole are upright from its springing line down.
  if (hole > 0 && hole < end)
    for (double side : {-1.0, 1.0}) {
      column(side * (hole + 1e-3), foot);
      column(side * (hole - 1e-3), m.vault.spring);
    }
  std::sort(columns.begin(), columns.end(), [](const auto& a, const auto& b) { return a.x < b.x; });

  Surface surface;
  for (const glm::dvec3& c : columns)
    for (Vec3 p : {Vec3(c.x, c.y, -z), Vec3(c.x, c.y, z), Vec3(c.x, c.z, z), Vec3(c.x, c.z, -z)})
      surface.position.push_back(p);
  auto last = static_cast<std::uint32_t>(4 * (columns.size() - 1));
  for (std::uint32_t base = 0; base < last; base += 4)
    for (std::uint32_t k = 0; k < 4; ++k)
      add_quad(surface, base + k, base + 4 + k, base + 4 + (k + 1) % 4, base + (k + 1) % 4);
  add_quad(surface, 0, 1, 2, 3);
  add_quad(surface, last, last + 3, last + 2, last + 1);
  set_normals(surface);
  m.add(BridgePart::core, std::move(surface), Seed{}, 0);
}

}  // namespace

void build_stone(const BridgeShape& shape, Bridge& bridge, Seed seed) {
  // A parapet is so much thicker than a hand rail, and takes at most that share of the bridge's width.
  constexpr double kThinnest = 0.18, kThickest = 0.3, kRails = 2.2, kMostOfWidth = 0.2;
  double wall = std::min({std::max(kThinnest, kRails * shape.rail), kThickest, kMostOfWidth * shape.width});
  BridgeMason mason{shape, bridge, fit_vault(shape, bridge),
                    shape.width / 2 - std::min(kSet, 0.1 * shape.width), wall};
  build_core(mason);
  build_vault(mason, seed.child("vault"));
  build_walls(mason, seed.child("walls"));
  build_deck(mason, seed.child("deck"));
  build_parapets(mason, seed.child("parapets"));
}

}  // namespace frond
