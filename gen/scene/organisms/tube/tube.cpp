#include "organisms/tube/tube.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "organisms/describe_colony.h"
#include "organisms/kinds.h"
#include "organisms/sheet_growth.h"

namespace frond {

namespace {

std::vector<MarginStart> tube_starts(const TubeParams& params, Seed seed) {
  std::vector<MarginStart> starts;
  // As near to each other as they have room.
  double pitch = 2.15 * params.radius + std::max(2 * params.edge, 1.5 * params.wall);
  double around = pitch * std::sqrt(0.36 * params.tubes);
  double outward = std::max(0.0, (params.across / 2 - around) / params.height);
  for (int i = 0; i < params.tubes; ++i) {
    Seed own = seed.child("tube", static_cast<std::uint64_t>(i));
    double share = params.tubes > 1 ? std::sqrt((i + 0.5) / params.tubes) : 0, angle = radians(137.508) * i;
    Vec3 out(static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle)));
    Vec3 lean =
        Vec3(0, 1, 0) + out * static_cast<float>(1.6 * outward * share * own.child("lean").range(0.9, 1.1));
    double radius = params.radius * own.child("radius").range(0.75, 1.0);
    MarginStart start = ring_start(out * static_cast<float>(around * share) - Vec3(0, 0.012f, 0), radius,
                                   angle, 2 * kPi, kPi / 2 - params.bulge, params.edge);
    for (Vec3& h : start.heading) h = glm::normalize(h + lean - Vec3(0, 1, 0));
    start.reach = params.tubes == 1 ? 1 : own.child("reach").range(0.55, 1) * (1 - 0.35 * share * share);
    starts.push_back(std::move(start));
  }
  return starts;
}

}  // namespace

Result<Model> grow_tube(const TubeParams& params, const Surroundings& around, Seed seed) {
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
  Vec3 lot(static_cast<float>(seed.child("lumps").range(-99, 99)), 0, 0);
  auto wall = static_cast<float>(params.wall), lumps = static_cast<float>(params.lumps);
  auto often = static_cast<float>(1 / params.lump_size), ribs = static_cast<float>(params.ribs);
  SheetSkin skin;
  skin.upper = [=](std::uint32_t, float age) {
    return 0.25f * wall + 0.25f * wall * smooth_step(0.0f, 0.2f, age);
  };
  skin.lower = [&, wall, lumps, often, ribs](std::uint32_t v, float age) {
    Vec3 at = sheet.position[v];
    float uneven = lumps * static_cast<float>(fractal_noise(at * often + lot, 3));
    if (ribs > 0) {
      Vec3 wave(at.x, 0.25f * at.y, at.z);
      float bent = std::atan2(at.z, at.x) + 0.15f * static_cast<float>(noise(wave * often * 0.5f + lot));
      uneven += 0.8f * std::pow(0.5f + 0.5f * std::cos(ribs * bent), 2.0f);
    }
    return wall * (0.3f + (0.35f + 0.9f * std::max(-0.3f, uneven)) * smooth_step(0.0f, 0.15f, age));
  };
  skin.lines = params.form == TubeForm::pipes ? 0 : 0.08 * params.wall;
  skin.line = 1.5 * params.lump_size;
  Matter matter = params.form == TubeForm::sponge ? Matter::sponge : Matter::polyps;
  return model_of(body_of(sheet, skin), material_of(params.tissue, matter, seed));
}

inline constexpr Choice<TubeForm> kTubeForms[] = {
    {"sponge", TubeForm::sponge, "soft and pitted, as tube and barrel sponges"},
    {"pipes", TubeForm::pipes, "stony, as the organ-pipe coral"}};

void describe(Properties& v, TubeParams& p) {
  v.choice("form", p.form, kTubeForms, "What the tubes are made of");
  v.number("across", p.across, {.min = 0.01, .max = 5, .unit = "m"}, "How wide it comes to be");
  v.number("height", p.height, {.min = 0.005, .max = 5, .unit = "m"}, "How high it comes to be");
  v.integer("tubes", p.tubes, {.min = 1, .max = 400}, "Number of tubes");
  v.number("radius", p.radius, {.min = 0.0005, .max = 2, .unit = "m"}, "Radius of a tube at its foot");
  v.number("wall", p.wall, {.min = 0.0003, .max = 0.5, .unit = "m"}, "Thickness of its wall");
  v.angle("bulge", p.bulge, {.min = -30, .max = 70}, "How far a tube widens from its foot before it rises");
  v.number("lumps", p.lumps, {.min = 0, .max = 2}, "How uneven tubes are outside");
  v.number("lump_size", p.lump_size, {.min = 0.002, .max = 2, .unit = "m"}, "Distance from lump to lump");
  v.integer("ribs", p.ribs, {.min = 0, .max = 200}, "Ribs along a tube that stands alone; 0 none");
  v.number("edge", p.edge, {.min = 0.0005, .max = 0.2, .unit = "m"}, "Length of the sides of its triangles");
  v.object("tissue", p.tissue, "The living skin");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class TubeGrower final : public BodyColony<TubeParams> {
 public:
  static constexpr std::string_view kLeading[] = {"form", "across", "height", "tubes", "radius",
                                                  "wall", "bulge",  "lumps",  "ribs",  "tissue/color"};

  Review review() const override { return {check_edge(params.edge, params.radius, 1)}; }
  std::shared_ptr<const Grower> coarse(double share) const override {
    return longer_edges(*this, share, [](auto& p) -> double& { return p.edge; });
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    return estimate_surface(
        2 * kPi * params.tubes * (params.radius + params.height * params.bulge / 3) * params.height,
        params.edge);
  }
  Result<Model> grow_at(const Surroundings& around, Seed seed) const override {
    return grow_tube(params, around, seed);
  }
};

}  // namespace

Kind<Organism> tube_kind() {
  return make_grower<TubeGrower>("tube",
                                 "Tube and barrel sponges, and organ pipes: tubes that grow at their rims");
}

}  // namespace frond
