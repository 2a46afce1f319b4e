#include "organisms/encrusting/encrusting.h"

#include "appearance/describe.h"
#include "core/noise.h"
#include "organisms/kinds.h"

namespace frond {

Result<Model> grow_encrusting(const EncrustingParams& params, const Surroundings& around, Seed seed) {
  constexpr double kClings = 0.2;  // of the width: how far off it finds a hold
  constexpr double kLumpsALobe = 2.2;
  constexpr float kFilm = 0.002f;                          // metres to each side, of the youngest
  constexpr float kGrownAbove = 0.3f, kGrownBelow = 0.2f;  // ages 0..1 of full thickness
  constexpr float kLipRisen = 0.04f, kLipFalls = 0.06f, kLipGone = 0.22f;  // ages of the raised edge
  constexpr float kBelow = 0.7f;                                           // of the thickness
  constexpr double kLineHeight = 0.1;                                      // of it
  Margin law{.reach = params.across / 2,
             .edge = params.edge,
             .lobes = params.lobes,
             .lobe_size = params.lobe_size,
             .clearance = 2 * params.edge};
  auto within = static_cast<float>(kClings * params.across);
  MarginWorld world;
  world.cling = [&around, within](Vec3& at, Vec3& normal) {
    Surroundings::Hold hold = around.hold(at, within);
    at = hold.at, normal = hold.normal;
  };
  world.room = [&around](Vec3 at, float) { return around.border(at); };
  MarginStart start = ring_start(Vec3(0), 2 * params.edge, 0, 2 * kPi, 0, params.edge);
  start.filled = true;
  for (Vec3& p : start.rim) {
    Vec3 normal;
    world.cling(p, normal);
  }
  Sheet sheet = grow_margins(law, {start}, world, seed.child("sheet"));
  Vec3 lot(seed.child("lumps").range(-99, 99), 0, 0);
  auto thick = static_cast<float>(params.thickness), raised = static_cast<float>(params.rim);
  auto lumps = static_cast<float>(params.lumps), often = static_cast<float>(kLumpsALobe / params.lobe_size);
  SheetSkin skin;
  skin.upper = [&](std::uint32_t v, float age) {
    float uneven = 1 + lumps * static_cast<float>(fractal_noise(sheet.position[v] * often + lot, 3));
    float lip = smooth_step(0.0f, kLipRisen, age) * (1 - smooth_step(kLipFalls, kLipGone, age));
    return kFilm + thick * uneven * smooth_step(0.0f, kGrownAbove, age) + raised * lip;
  };
  skin.lower = [&](std::uint32_t, float age) {
    return kFilm + kBelow * thick * smooth_step(0.0f, kGrownBelow, age);
  };
  skin.lines = kLineHeight * params.thickness;
  return model_of(body_of(sheet, skin), params.tissue, Matter::polyps, seed);
}

void describe(Properties& v, EncrustingParams& p) {
  v.number("across", p.across, metres(0.01, 5), "How wide it comes to be");
  v.number("height", p.height, metres(0.005, 5), "How high it comes to be");
  v.number("lobes", p.lobes, kShare, "How uneven its outline is");
  v.number("lobe_size", p.lobe_size, metres(0.005, 2), "Distance from lobe to lobe");
  v.number("thickness", p.thickness, metres(0.0005, 0.2), "Thickness of the crust");
  v.number("rim", p.rim, metres(0, 0.2), "How much its edge is raised");
  v.number("lumps", p.lumps, kShare, "How uneven its upper side is");
  v.number("edge", p.edge, metres(0.0005, 0.2), "Length of the sides of its triangles");
  v.object("tissue", p.tissue, "The living skin");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class EncrustingGrower final : public BodyColony<EncrustingGrower, EncrustingParams, grow_encrusting> {
 public:
  static constexpr std::string_view kLeading[] = {"across",    "height", "lobes", "lobe_size",
                                                  "thickness", "rim",    "lumps", "tissue/color"};

  Review review() const override { return {check_edge(params.edge, params.across, 10)}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kLaidTriangle = 1.2e-5;  // seconds: each is laid on what is below it
    SizeEstimate sight = estimate_surface(0.8 * params.across * params.across, params.edge);
    sight.seconds = kLaidTriangle * sight.triangles;
    return sight;
  }
};

}  // namespace

Kind<Organism> encrusting_kind() {
  return make_grower<EncrustingGrower>("encrusting",
                                       "A coral that covers what it stands on: a crust with a lobed edge");
}

}  // namespace frond
