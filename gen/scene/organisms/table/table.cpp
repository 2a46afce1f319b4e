#include "organisms/table/table.h"

#include <algorithm>
#include <cmath>

#include "appearance/describe.h"
#include "core/cell_grid.h"
#include "core/triangle.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

SheetBody table_top(const Sheet& sheet, const TableParams& params) {
  constexpr float kStalkDown = 0.02f;   // metres that the stalk goes down into the ground
  constexpr float kStalkBroad = 1.3f;   // above 1 it is of full height over a part of its width
  constexpr float kStalkGrows = 0.12f;  // share of the age in which it grows to the ground
  auto thick = static_cast<float>(params.thickness / 2), wide = static_cast<float>(params.stalk);
  auto high = static_cast<float>(params.height - params.branchlet);
  SheetSkin skin;
  skin.plumb = true;
  skin.sprout = 0.4;
  skin.upper = [=](std::uint32_t, float) { return thick; };
  skin.lower = [&sheet, thick, wide, high](std::uint32_t v, float age) {
    float share = 2 * sheet.distance[v] / wide;
    float stalk = (high + kStalkDown) * std::min(1.0f, kStalkBroad / (1 + share * share * share));
    return thick + stalk * smooth_step(0.0f, kStalkGrows, age);
  };
  return body_of(sheet, skin);
}

/// Places for branchlets on the upper side: a triangle of the sheet and where in it.
struct Socket {
  std::uint32_t triangle;
  Vec3 weights;
};

std::vector<Socket> sample_sockets(const Sheet& sheet, double spacing, Seed seed) {
  constexpr std::uint64_t kThrows = 5;  // at each triangle
  std::vector<Socket> sockets;
  Darts darts(static_cast<float>(spacing));
  for (std::uint64_t dart = 0; dart < kThrows; ++dart)
    for (std::uint32_t t = 0; t < sheet.triangle.size(); ++t) {
      Seed lot = seed.child(dart).child(t);
      Vec3 w(drawn_weights(lot.child("u").unit(), lot.child("v").unit()));
      auto [a, b, c] = sheet.triangle[t];
      if (darts.try_add(sheet.position[a] * w.x + sheet.position[b] * w.y + sheet.position[c] * w.z))
        sockets.push_back({t, w});
    }
  return sockets;
}

constexpr int kBranchletSides = 6, kLawnRings = 4;

/// Appends a branchlet: rings about an axis of `up`, closed at its tip and in its foot. Gives its first
/// vertex.
std::uint32_t add_branchlet(Surface& lawn, Vec3 foot, Vec3 up, float length, float thick, float birth) {
  constexpr float kFootBelow = 0.002f;  // metres in the table
  static constexpr float kProfile[kLawnRings] = {1.0f, 0.95f, 0.8f, 0.5f},
                         kRise[kLawnRings] = {0, 0.4f, 0.75f, 0.94f};
  Vec3 x = glm::normalize(glm::cross(up, Vec3(0.3f, 0.1f, 1)));
  Vec3 z = glm::cross(up, x);
  auto first = static_cast<std::uint32_t>(lawn.position.size());
  auto add = [&](Vec3 at, float share) {
    lawn.position.push_back(at);
    lawn.uv.push_back({0.3f + 0.7f * share, std::max(birth, 0.98f * share * share)});
  };
  for (int j = 0; j < kLawnRings; ++j)
    for (int i = 0; i < kBranchletSides; ++i) {
      auto angle = static_cast<float>(2 * kPi * i / kBranchletSides);
      add(foot + up * (length * kRise[j]) +
              (x * std::cos(angle) + z * std::sin(angle)) * (thick * kProfile[j]),
          kRise[j]);
    }
  add(foot + up * length, 1);
  add(foot - up * kFootBelow, 0);
  auto id = [&](int j, int i) {
    return first + static_cast<std::uint32_t>(j * kBranchletSides + i % kBranchletSides);
  };
  std::uint32_t tip = first + kLawnRings * kBranchletSides;
  for (int i = 0; i < kBranchletSides; ++i) {
    for (int j = 0; j + 1 < kLawnRings; ++j) {
      lawn.triangle.push_back({id(j, i), id(j + 1, i), id(j, i + 1)});
      lawn.triangle.push_back({id(j, i + 1), id(j + 1, i), id(j + 1, i + 1)});
    }
    lawn.triangle.push_back({id(kLawnRings - 1, i), tip, id(kLawnRings - 1, i + 1)});
    lawn.triangle.push_back({id(0, i + 1), tip + 1, id(0, i)});
  }
  return first;
}

/// The lawn of branchlets on the table, each with its past.
SheetBody lawn_of(const Sheet& sheet, const SheetBody& top, const TableParams& params, Seed seed) {
  constexpr double kScatter = 0.25;  // how far a branchlet leans in any direction, for 1 up
  constexpr float kOutward = 0.15f, kRimOutward = 0.9f;  // how far it leans outward, and more at the rim
  constexpr float kRimFrom = 0.75f, kRimFull = 0.95f;    // of the way to it
  constexpr float kLatestBirth = 0.8f;                   // of growth
  constexpr float kSmallest = 0.02f;                     // of its size
  // How long it grows, in shares of all growth: at least, and more of what is still to come at its birth.
  constexpr float kLeastGrowth = 0.1f, kMoreGrowth = 0.25f;
  SheetBody lawn;
  lawn.past.resize(kSheetSteps);
  std::vector<Socket> sockets = sample_sockets(sheet, params.spacing, seed);
  auto rows = static_cast<float>(sheet.rows);
  float reach = static_cast<float>(params.across / 2);
  for (std::size_t s = 0; s < sockets.size(); ++s) {
    Seed own = seed.child("branchlet", s);
    const Vec3 w = sockets[s].weights;
    auto corner = sheet.triangle[sockets[s].triangle];
    auto place = [&](const std::vector<Vec3>& side) {
      return side[corner[0]] * w.x + side[corner[1]] * w.y + side[corner[2]] * w.z;
    };
    float row = sheet.row[corner[0]] * w.x + sheet.row[corner[1]] * w.y + sheet.row[corner[2]] * w.z;
    Vec3 foot = place(top.surface.position);
    Vec3 out(foot.x, 0, foot.z);
    float away = glm::length(out) / reach;
    Vec3 lean(own.child("x").range(-kScatter, kScatter), 0, own.child("z").range(-kScatter, kScatter));
    Vec3 up = glm::normalize(Vec3(0, 1, 0) + lean +
                             out / reach * (kOutward + kRimOutward * smooth_step(kRimFrom, kRimFull, away)));
    auto length = static_cast<float>(params.branchlet * own.child("length").range(0.65, 1.05));
    auto thick = static_cast<float>(params.spacing * own.child("thick").range(0.27, 0.36));
    std::uint32_t first =
        add_branchlet(lawn.surface, foot, up, length, thick, std::min(row / rows, kLatestBirth));
    for (int k = 0; k < kSheetSteps; ++k) {
      Vec3 now = place(top.past[static_cast<std::size_t>(k)]);
      float share = static_cast<float>(k) / kSheetSteps;
      float grown = row / rows + kMoreGrowth * (1.02f - row / rows) + kLeastGrowth;
      float size = std::max(kSmallest, smooth_step(row / rows, grown, share));
      for (std::uint32_t v = first; v < lawn.surface.position.size(); ++v)
        lawn.past[static_cast<std::size_t>(k)].push_back(now + (lawn.surface.position[v] - foot) * size);
    }
  }
  set_normals(lawn.surface);
  return lawn;
}

}  // namespace

Sheet table_sheet(const TableParams& params, const Surroundings& around, Seed seed) {
  Margin law{.reach = params.across / 2 - 2 * params.edge,
             .edge = params.edge,
             .stiffness = 1,
             .pitch = radians(4.0),
             .light = 5,
             .lobes = params.lobes,
             .lobe_size = 0.16 * params.across,
             .clearance = 2.5 * params.edge};
  Vec3 middle(0, params.height - params.branchlet, 0);
  MarginStart start = ring_start(middle, 2 * params.edge, 0, 2 * kPi, 0, params.edge);
  start.filled = true;
  return grow_margins(law, {start}, margin_world(around), seed.child("sheet"));
}

Result<Model> grow_table(const TableParams& params, const Surroundings& around, Seed seed) {
  Sheet sheet = table_sheet(params, around, seed);
  SheetBody body = table_top(sheet, params);
  append(body, lawn_of(sheet, body, params, seed.child("lawn")));
  return model_of(std::move(body), params.tissue, Matter::polyps, seed);
}

void describe(Properties& v, TableParams& p) {
  v.number("across", p.across, metres(0.01, 5), "How wide it comes to be");
  v.number("height", p.height, metres(0.005, 5), "How high it comes to be");
  v.number("stalk", p.stalk, metres(0.005, 2), "How wide its stalk is");
  v.number("lobes", p.lobes, kShare, "How uneven its outline is");
  v.number("thickness", p.thickness, metres(0.001, 0.5), "Thickness of the table at its rim");
  v.number("branchlet", p.branchlet, metres(0.001, 0.5), "Length of the branchlets");
  v.number("spacing", p.spacing, metres(0.002, 0.5), "Distance from one branchlet to the next");
  v.number("edge", p.edge, metres(0.0005, 0.2), "Length of the sides of its triangles");
  v.object("tissue", p.tissue, "The living skin");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class TableGrower final : public BodyColony<TableGrower, TableParams, grow_table> {
 public:
  static constexpr std::string_view kLeading[] = {"across",    "height",    "stalk",   "lobes",
                                                  "thickness", "branchlet", "spacing", "tissue/color"};

  Review review() const override { return {check_edge(params.edge, params.across, 10)}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kBothSides = 1.6;  // of the square across
    constexpr double kOneTier = 55;     // edges across; the lobes of finer rims overlap
    constexpr double kCrowd = 0.5,
                     kBranchletArea = 1.4;  // branchlets on a square of the spacing; of its sides
    constexpr double kBranchletTriangles = 42, kPlateHeld = 2.5;  // of its past, while it is coarsened
    double square = params.across * params.across, spacing = params.spacing;
    double tiers = std::max(1.0, params.across / params.edge / kOneTier);
    double branchlets = tiers * kCrowd * square / (spacing * spacing);
    SizeEstimate sight = estimate_surface(tiers * kBothSides * square, params.edge);
    sight.area += branchlets * kBranchletArea * spacing * params.branchlet;
    sight.held *= kPlateHeld;
    sight.triangles += kBranchletTriangles * branchlets;
    return sight;
  }
};

}  // namespace

Kind<Organism> table_kind() {
  return make_grower<TableGrower>("table",
                                  "A table coral: a level disc on a stalk, a lawn of branchlets on it");
}

}  // namespace frond
