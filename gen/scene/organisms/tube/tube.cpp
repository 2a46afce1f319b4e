#include "organisms/tube/tube.h"

#include <algorithm>
#include <cmath>

#include "appearance/describe.h"
#include "core/noise.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

std::vector<MarginStart> tube_starts(const TubeParams& params, Seed seed) {
  constexpr double kDiameter = 2.15, kWallRoom = 1.5;  // in radii, and in thicknesses of the wall
  constexpr double kPacking = 0.36;  // square of the radius of all feet, in pitches, for each tube
  constexpr double kTubeTurn = radians(137.508);  // from tube to tube: the golden angle
  constexpr double kLean = 1.6;                   // above 1, as tubes turn upward while they grow
  constexpr float kTubeFoot = 0.012f;             // metres below the ground
  constexpr double kOuterShorter = 0.35;          // of the reach, at most
  std::vector<MarginStart> starts;
  // As near to each other as they have room.
  double pitch = kDiameter * params.radius + std::max(2 * params.edge, kWallRoom * params.wall);
  double around = pitch * std::sqrt(kPacking * params.tubes);
  double outward = std::max(0.0, (params.across / 2 - around) / params.height);
  for (int i = 0; i < params.tubes; ++i) {
    Seed own = seed.child("tube", static_cast<std::uint64_t>(i));
    double share = params.tubes > 1 ? std::sqrt((i + 0.5) / params.tubes) : 0, angle = kTubeTurn * i;
    Vec3 out(std::cos(angle), 0, std::sin(angle));
    Vec3 lean =
        Vec3(0, 1, 0) + out * static_cast<float>(kLean * outward * share * own.child("lean").range(0.9, 1.1));
    double radius = params.radius * own.child("radius").range(0.75, 1.0);
    MarginStart start = ring_start(out * static_cast<float>(around * share) - Vec3(0, kTubeFoot, 0), radius,
                                   angle, 2 * kPi, kPi / 2 - params.bulge, params.edge);
    for (Vec3& h : start.heading) h = glm::normalize(h + lean - Vec3(0, 1, 0));
    start.reach =
        params.tubes == 1 ? 1 : own.child("reach").range(0.55, 1) * (1 - kOuterShorter * share * share);
    starts.push_back(std::move(start));
  }
  return starts;
}

}  // namespace

Result<Model> grow_tube(const TubeParams& params, const Surroundings& around, Seed seed) {
  // Thickness of the wall inside and outside, in that of TubeParams: at the rim, and what comes with age.
  constexpr float kInnerRim = 0.25f, kInnerMore = 0.25f, kInnerAge = 0.2f;
  constexpr float kOuterRim = 0.3f, kOuterMore = 0.35f, kOuterAge = 0.15f;
  constexpr float kLumpy = 0.9f, kDeepestHollow = -0.3f;  // of what is uneven: its factor, and its least
  constexpr float kRibHeight = 0.8f, kRibBends = 0.15f;   // of what is uneven; radians round the axis
  constexpr float kRibsUpright = 0.25f;                   // bends along the tube by those across it
  Margin law{.reach = 1.03 * params.height,
             .edge = params.edge,
             .stiffness = 0.6,
             .pitch = kPi / 2,
             .light = 1.1,
             .lobes = 0.05,
             .lobe_size = params.lump_size * 2,
             .clearance = std::max(1.5 * params.edge, 1.3 * params.wall)};
  std::vector<MarginStart> starts = tube_starts(params, seed.child("tubes"));
  MarginWorld world = margin_world(around);
  Sheet sheet = grow_margins(law, starts, world, seed.child("sheet"));
  Vec3 lot(seed.child("lumps").range(-99, 99), 0, 0);
  auto wall = static_cast<float>(params.wall), lumps = static_cast<float>(params.lumps);
  auto often = static_cast<float>(1 / params.lump_size), ribs = static_cast<float>(params.ribs);
  SheetSkin skin;
  skin.upper = [=](std::uint32_t, float age) {
    return kInnerRim * wall + kInnerMore * wall * smooth_step(0.0f, kInnerAge, age);
  };
  skin.lower = [&, wall, lumps, often, ribs](std::uint32_t v, float age) {
    Vec3 at = sheet.position[v];
    float uneven = lumps * static_cast<float>(fractal_noise(at * often + lot, 3));
    if (ribs > 0) {
      Vec3 wave(at.x, kRibsUpright * at.y, at.z);
      float bent = std::atan2(at.z, at.x) + kRibBends * static_cast<float>(noise(wave * often * 0.5f + lot));
      uneven += kRibHeight * std::pow(0.5f + 0.5f * std::cos(ribs * bent), 2.0f);
    }
    return wall * (kOuterRim + (kOuterMore + kLumpy * std::max(kDeepestHollow, uneven)) *
                                   smooth_step(0.0f, kOuterAge, age));
  };
  skin.lines = params.form == TubeForm::pipes ? 0 : 0.08 * params.wall;
  skin.line = 1.5 * params.lump_size;
  Matter matter = params.form == TubeForm::sponge ? Matter::sponge : Matter::polyps;
  return model_of(body_of(sheet, skin), params.tissue, matter, seed);
}

inline constexpr Choice<TubeForm> kTubeForms[] = {
    {"sponge", TubeForm::sponge, "soft and pitted, as tube and barrel sponges"},
    {"pipes", TubeForm::pipes, "stony, as the organ-pipe coral"}};

void describe(Properties& v, TubeParams& p) {
  v.choice("form", p.form, kTubeForms, "What the tubes are made of");
  v.number("across", p.across, metres(0.01, 5), "How wide it comes to be");
  v.number("height", p.height, metres(0.005, 5), "How high it comes to be");
  v.integer("tubes", p.tubes, {.min = 1, .max = 400}, "Number of tubes");
  v.number("radius", p.radius, metres(0.0005, 2), "Radius of a tube at its foot");
  v.number("wall", p.wall, metres(0.0003, 0.5), "Thickness of its wall");
  v.angle("bulge", p.bulge, {.min = -30, .max = 70}, "How far a tube widens from its foot before it rises");
  v.number("lumps", p.lumps, {.min = 0, .max = 2}, "How uneven tubes are outside");
  v.number("lump_size", p.lump_size, metres(0.002, 2), "Distance from lump to lump");
  v.integer("ribs", p.ribs, {.min = 0, .max = 200}, "Ribs along a tube that stands alone; 0 none");
  v.number("edge", p.edge, metres(0.0005, 0.2), "Length of the sides of its triangles");
  v.object("tissue", p.tissue, "The living skin");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class TubeGrower final : public BodyColony<TubeGrower, TubeParams, grow_tube> {
 public:
  static constexpr std::string_view kLeading[] = {"form", "across", "height", "tubes", "radius",
                                                  "wall", "bulge",  "lumps",  "ribs",  "tissue/color"};

  Review review() const override { return {check_edge(params.edge, params.radius, 1)}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    return estimate_surface(
        2 * kPi * params.tubes * (params.radius + params.height * params.bulge / 3) * params.height,
        params.edge);
  }
};

}  // namespace

Kind<Organism> tube_kind() {
  return make_grower<TubeGrower>("tube",
                                 "Tube and barrel sponges, and organ pipes: tubes that grow at their rims");
}

}  // namespace frond
