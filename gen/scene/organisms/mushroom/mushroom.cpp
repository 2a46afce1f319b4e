#include "organisms/mushroom/mushroom.h"

#include <algorithm>
#include <cmath>

#include "appearance/describe.h"
#include "core/noise.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr int kMushroomRings = 44, kMushroomOrders = 3;
constexpr int kSeptaInAll = 4;   // for each one that reaches the mouth
constexpr int kSeptumParts = 6;  // vertices from one to the next but one

/// How much a place stands on a septum: 0 between, 1 on the crest. Those of a later order begin farther out.
float septum_at(double turn, double share, int septa) {
  // From the mouth to the rim, 0..1: where septa of the first order begin, by how much farther out those of
  // the next, and how long they rise.
  constexpr double kBegins = 0.12, kBeginsFarther = 0.24, kRising = 0.12;
  constexpr double kLower = 0.22;  // by which crests of the next order are lower
  double best = 0;
  for (int order = 0; order < kMushroomOrders; ++order) {
    double count = septa * (order == 0 ? 1 : 1 << (order - 1)), shift = order == 0 ? 0 : 0.5;
    double phase = turn * count / (2 * kPi) - shift;
    double off = std::abs(phase - std::round(phase)) / count;  // turns to the nearest crest
    double half = 0.5 / (septa * kSeptaInAll);                 // turns
    double begins = kBegins + kBeginsFarther * order;
    double ridge = std::max(0.0, 1 - off / half) * smooth_step(begins, begins + kRising, share);
    best = std::max(best, ridge * (1 - kLower * order));
  }
  return static_cast<float>(best);
}

}  // namespace

Result<Model> grow_mushroom(const MushroomParams& params, const Surroundings&, Seed seed) {
  constexpr double kUneven = 0.05;                         // of its outline
  constexpr double kRimHeight = 0.12, kDomeHeight = 0.88;  // of its height
  constexpr double kDomePower = 2.4, kDomeRound = 0.75;    // exponents of its profile, a superellipse
  constexpr double kMouth = 0.02, kToRim = 0.98;           // of its radius
  constexpr double kSeptaWander = 0.04;                    // radians at the rim
  constexpr double kSlitWidth = 0.035, kSlitFull = 0.10, kSlitEnd = 0.22;  // of its length, from the middle
  constexpr double kSlitDepth = 0.16, kThickness = 0.1;                    // of its height
  constexpr double kCrestBelow = 0.6;                                      // of the septa's height
  int round = params.septa * kSeptaInAll * kSeptumParts / 2;
  double half = params.across / 2;
  SheetBody body;
  Vec3 lot(seed.child("lot").range(-99, 99), 0, 0);
  auto at_of = [&](double share, double turn) {
    Vec3 out(std::cos(turn), 0, params.oval * std::sin(turn));
    double bent = 1 + kUneven * fractal_noise(out * 1.5f + lot, 2);
    return out * static_cast<float>(half * share * bent);
  };
  auto thick = static_cast<float>(kThickness * params.height);
  auto dome = [&](double share) {
    return static_cast<float>(
        params.height *
        (kRimHeight + kDomeHeight * std::pow(std::max(0.0, 1 - std::pow(share, kDomePower)), kDomeRound)));
  };
  auto& surface = body.surface;
  auto put = [&](Vec3 p, float tone, double share) {
    surface.position.push_back(p);
    surface.uv.push_back({tone, static_cast<float>(share)});
  };
  for (int j = 0; j <= kMushroomRings; ++j)
    for (int i = 0; i < round; ++i) {
      double share = kMouth + kToRim * j / kMushroomRings, turn = 2 * kPi * i / round;
      double wander = kSeptaWander * std::sin(5 * share + 3 * noise(Vec3(6 * turn, 0, 0) + lot));
      float crest = septum_at(turn + wander * share, share, params.septa);
      Vec3 p = at_of(share, turn);
      // The mouth is a slit along it.
      double slit =
          std::exp(-std::pow(p.z / (kSlitWidth * params.across), 2)) *
          (1 - smooth_step(kSlitFull, kSlitEnd, std::abs(static_cast<double>(p.x)) / params.across));
      p.y = dome(share) +
            static_cast<float>(params.depth * (crest - kCrestBelow) * smooth_step(0.0, 0.15, share) -
                               kSlitDepth * params.height * slit);
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
  return model_of(std::move(body), params.tissue, Matter::meander, seed);
}

void describe(Properties& v, MushroomParams& p) {
  v.number("across", p.across, metres(0.01, 5), "How wide it comes to be");
  v.number("height", p.height, metres(0.005, 5), "How high it comes to be");
  v.number("oval", p.oval, {.min = 0.2, .max = 1}, "Its width by its length");
  v.integer("septa", p.septa, {.min = 6, .max = 200},
            "Septa that reach the mouth; others stand between them");
  v.number("depth", p.depth, metres(0, 0.1), "Depth of the valleys between septa");
  v.object("tissue", p.tissue, "The living skin");
  v.object("growth", p.growth, "When it grows in the film");
}

namespace {

class MushroomGrower final : public BodyColony<MushroomGrower, MushroomParams, grow_mushroom> {
 public:
  static constexpr std::string_view kLeading[] = {"across", "height", "oval",
                                                  "septa",  "depth",  "tissue/color"};

  Review review() const override { return {}; }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kTriangleSeconds = 2e-6;
    double triangles = 2.0 * (kMushroomRings + 2) * params.septa * (kSeptaInAll * kSeptumParts / 2);
    return SizeEstimate{.triangles = triangles,
                        .area = 2 * params.across * params.across * params.oval,
                        .blocks = 1,
                        .seconds = kTriangleSeconds * triangles,
                        .held = kPastTriangle * triangles};
  }
};

}  // namespace

Kind<Organism> mushroom_kind() {
  return make_grower<MushroomGrower>("mushroom", "A mushroom coral: an oval dome of radial septa");
}

}  // namespace frond
