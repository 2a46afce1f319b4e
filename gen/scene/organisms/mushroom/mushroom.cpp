#include "organisms/mushroom/mushroom.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "organisms/describe_colony.h"
#include "organisms/kinds.h"
#include "organisms/sheet_growth.h"

namespace frond {

namespace {

constexpr int kMushroomRings = 44, kMushroomOrders = 3, kSeptumParts = 6;

/// How much a place stands on a septum: 0 between, 1 on the crest. Those of a later order begin farther out.
float septum_at(double turn, double share, int septa) {
  double best = 0;
  for (int order = 0; order < kMushroomOrders; ++order) {
    double count = septa * (order == 0 ? 1 : 1 << (order - 1)), shift = order == 0 ? 0 : 0.5;
    double phase = turn * count / (2 * kPi) - shift;
    double off = std::abs(phase - std::round(phase)) / count;  // turns to the nearest crest
    double half = 0.5 / (septa * 4);                           // turns
    double begins = 0.12 + 0.24 * order;
    double ridge = std::max(0.0, 1 - off / half) * smooth_step(begins, begins + 0.12, share);
    best = std::max(best, ridge * (1 - 0.22 * order));
  }
  return static_cast<float>(best);
}

}  // namespace

Result<Model> grow_mushroom(const MushroomParams& params, const Surroundings&, Seed seed) {
  int round = params.septa * 4 * kSeptumParts / 2;
  double half = params.across / 2;
  SheetBody body;
  Vec3 lot(static_cast<float>(seed.child("lot").range(-99, 99)), 0, 0);
  auto at_of = [&](double share, double turn) {
    Vec3 out(static_cast<float>(std::cos(turn)), 0, static_cast<float>(params.oval * std::sin(turn)));
    double bent = 1 + 0.05 * fractal_noise(out * 1.5f + lot, 2);
    return out * static_cast<float>(half * share * bent);
  };
  auto thick = static_cast<float>(0.1 * params.height);
  auto dome = [&](double share) {
    return static_cast<float>(params.height *
                              (0.12 + 0.88 * std::pow(std::max(0.0, 1 - std::pow(share, 2.4)), 0.75)));
  };
  auto& surface = body.surface;
  auto put = [&](Vec3 p, float tone, double share) {
    surface.position.push_back(p);
    surface.uv.push_back({tone, static_cast<float>(share)});
  };
  for (int j = 0; j <= kMushroomRings; ++j)
    for (int i = 0; i < round; ++i) {
      double share = 0.02 + 0.98 * j / kMushroomRings, turn = 2 * kPi * i / round;
      double wander = 0.04 * std::sin(5 * share + 3 * noise(Vec3(static_cast<float>(6 * turn), 0, 0) + lot));
      float crest = septum_at(turn + wander * share, share, params.septa);
      Vec3 p = at_of(share, turn);
      // The mouth is a slit along it.
      double slit = std::exp(-std::pow(p.z / (0.035 * params.across), 2)) *
                    (1 - smooth_step(0.10, 0.22, std::abs(static_cast<double>(p.x)) / params.across));
      p.y = dome(share) + static_cast<float>(params.depth * (crest - 0.6) * smooth_step(0.0, 0.15, share) -
                                             0.16 * params.height * slit);
      if (j == kMushroomRings) p.y = thick + static_cast<float>(params.depth * 0.5 * crest);
      put(p, crest * static_cast<float>(1 - 0.5 * slit), share);
    }
  for (int i = 0; i < round; ++i) put(at_of(0.96, 2 * kPi * i / round) - Vec3(0, thick, 0), 0.2f, 0.9);
  put(Vec3(0, surface.position[0].y - 0.001f, 0), 0, 0);
  put(Vec3(0, -thick, 0), 0, 0);
  auto id = [&](int j, int i) { return static_cast<std::uint32_t>(j * round + i % round); };
  auto top = static_cast<std::uint32_t>((kMushroomRings + 2) * round);
  for (int i = 0; i < round; ++i) {
    surface.triangle.push_back({top, id(0, i + 1), id(0, i)});
    surface.triangle.push_back({top + 1, id(kMushroomRings + 1, i), id(kMushroomRings + 1, i + 1)});
    for (int j = 0; j <= kMushroomRings; ++j) {
      surface.triangle.push_back({id(j, i), id(j, i + 1), id(j + 1, i)});
      surface.triangle.push_back({id(j, i + 1), id(j + 1, i + 1), id(j + 1, i)});
    }
  }
  set_normals(surface);
  for (int k = 0; k < kSheetSteps; ++k) {
    float size = 0.04f + 0.96f * static_cast<float>(k) / kSheetSteps;
    std::vector<Vec3>& then = body.past.emplace_back();
    for (Vec3 p : surface.position) then.push_back(p * size);
  }
  return model_of(std::move(body), material_of(params.tissue, Matter::meander, seed));
}

void describe(Properties& v, MushroomParams& p) {
  v.number("across", p.across, {.min = 0.01, .max = 5, .unit = "m"}, "How wide it comes to be");
  v.number("height", p.height, {.min = 0.005, .max = 5, .unit = "m"}, "How high it comes to be");
  v.number("oval", p.oval, {.min = 0.2, .max = 1}, "Its width by its length");
  v.integer("septa", p.septa, {.min = 6, .max = 200},
            "Septa that reach the mouth; others stand between them");
  v.number("depth", p.depth, {.min = 0, .max = 0.1, .unit = "m"}, "Depth of the valleys between septa");
  v.object("tissue", p.tissue, "The living skin");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class MushroomGrower final : public BodyColony<MushroomParams> {
 public:
  static constexpr std::string_view kLeading[] = {"across", "height", "oval",
                                                  "septa",  "depth",  "tissue/color"};

  Review review() const override { return {}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    SizeEstimate sight;
    sight.triangles = 2.0 * 46 * params.septa * 12;
    sight.area = 2 * params.across * params.across * params.oval;
    sight.blocks = 1;
    sight.seconds = 2e-6 * sight.triangles;
    sight.held = kPastTriangle * sight.triangles;
    return sight;
  }
  Result<Model> grow_at(const Surroundings& around, Seed seed) const override {
    return grow_mushroom(params, around, seed);
  }
};

}  // namespace

Kind<Organism> mushroom_kind() {
  return make_grower<MushroomGrower>("mushroom", "A mushroom coral: an oval dome of radial septa");
}

}  // namespace frond
