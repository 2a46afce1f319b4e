#include "organisms/massive/massive.h"

#include <algorithm>

#include "accretion/reaction.h"
#include "accretion/refine.h"
#include "appearance/describe.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

constexpr int kTimes = 2;  // that triangles are cut before the surface is wrought

Accretion law_of(const MassiveParams& params) {
  return {.across = params.across / 2,
          .up = params.height,
          .layers = 36,
          .edge = params.edge * (1 << kTimes),
          .light = 0.25,
          .hunger = 0.35,
          .lumps = params.lumps,
          .lump_size = params.lump_size,
          .smoothing = 0.5};
}

Reaction reaction_of(const MassiveParams& params) {
  if (params.relief == Wrought::cups)
    return {.feed = 0.030, .kill = 0.0615, .wave = params.valley, .steps = 2400, .fine = true};
  return {.feed = 0.055, .kill = 0.062, .wave = params.valley, .steps = 1800};
}

}  // namespace

Result<Model> grow_massive(const MassiveParams& params, const Surroundings& around, Seed seed) {
  constexpr float kValley = 0.05f, kRidge = 0.75f;  // of the second substance (reaction.h)
  constexpr float kOldestYoung = 0.84f;  // Reef_Aged in povinc/frond_reef.inc has what is younger pale
  Accreted skin = accrete(law_of(params), accretion_world(around), seed.child("skin"));
  std::vector<float> tone(skin.surface.position.size(), 1);
  if (params.relief != Wrought::plain) {
    refine(skin, kTimes);
    tone = react(skin.surface, reaction_of(params), seed.child("reaction"));
    std::vector<float> height;
    for (float& t : tone) {
      t = smooth_step(kValley, kRidge, t);
      if (params.relief == Wrought::cups) t = 1 - t;
      height.push_back(static_cast<float>(params.depth) * (t - 0.5f));
    }
    raise(skin, height);
  }
  // A dome grows all over, so when it has grown no part of it is pale as young rims are.
  for (std::size_t v = 0; v < tone.size(); ++v)
    skin.surface.uv.push_back({tone[v], kOldestYoung * skin.birth[v]});
  Matter matter = params.relief == Wrought::plain ? Matter::polyps : Matter::meander;
  Model model = model_of(std::move(skin.surface), std::move(skin.past), params.tissue, matter, seed);
  if (params.relief != Wrought::plain)
    model.solids.shapes[0].material.septa = {params.septa, params.valley, params.depth};
  return model;
}

inline constexpr Choice<Wrought> kWrought[] = {
    {"meander", Wrought::meander, "valleys that wind between ridges, as on brain corals"},
    {"cups", Wrought::cups, "a cup for each polyp, its wall shared with those beside it, as on star corals"},
    {"plain", Wrought::plain, "fine pores, as on Porites"}};

void describe(Properties& v, MassiveParams& m) {
  v.number("across", m.across, metres(0.02, 5), "How wide it comes to be");
  v.number("height", m.height, metres(0.01, 5), "How high it comes to be");
  v.number("lumps", m.lumps, kShare, "How uneven it is: 0 a dome .. 1 a heap of domes");
  v.number("lump_size", m.lump_size, metres(0.005, 5), "Distance from lump to lump");
  v.choice("relief", m.relief, kWrought, "What its surface is wrought into");
  v.number("valley", m.valley, metres(0.002, 1), "Distance from one ridge, or one cup, to the next");
  v.number("depth", m.depth, metres(0, 0.2), "Depth of the valleys, or of the cups");
  v.number("septa", m.septa, {.min = 0, .max = 0.05, .unit = "m"},
           "Distance from one septum to the next, thin walls that run down from ridges; 0 draws none, else a "
           "fiftieth of a valley at least. They come in view only where they are as large as a pixel");
  v.number("edge", m.edge, metres(0.001, 0.2),
           "Length of the sides of its triangles; a fifth of a valley draws it well");
  v.object("tissue", m.tissue, "The living skin");
  v.object("growth", m.growth, "When it grows in the film");
}

namespace {

constexpr int kMostSepta = 50;  // in the length of a valley's width

class MassiveGrower final : public BodyColony<MassiveGrower, MassiveParams, grow_massive> {
 public:
  static constexpr std::string_view kLeading[] = {"across", "height", "lumps", "lump_size",
                                                  "relief", "valley", "depth", "tissue/color"};

  Review review() const override {
    if (params.edge * 8 > std::min(params.across, params.height))
      return {{{"/edge",
                "found triangles that are too large for the coral; expected an eighth of its size at most"}}};
    if (params.septa > 0 && params.septa * kMostSepta < params.valley)
      return {{error_at("/septa",
                        "found {:g} m, of which more than {} fit on a valley; expected 0 or {:g} m at least",
                        params.septa, kMostSepta, params.valley / kMostSepta)}};
    if (params.septa > 0 && (params.relief == Wrought::plain || params.depth <= 0))
      return {{}, {{"/septa", "does nothing; expected a relief of cups or of a meander that has a depth"}}};
    return {};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    SizeEstimate sight =
        estimate_surface(law_of(params), kPi * params.across * (params.across / 4 + params.height));
    if (params.relief == Wrought::plain) return sight;
    constexpr double kReacting = 2.2e-9;  // seconds of a triangle in one step
    sight.triangles *= 1 << 2 * kTimes;
    sight.held *= 1 << 2 * kTimes;
    sight.seconds += kReacting * reaction_of(params).steps * sight.triangles;
    // A line half way up each wall runs twice along each valley.
    double skin = kPi * params.across * (params.across / 4 + params.height);
    constexpr double kSeptumBytes = 40;
    if (params.septa > 0) sight.held += kSeptumBytes * 2 * skin / (params.valley * params.septa);
    return sight;
  }
};

}  // namespace

Kind<Organism> massive_kind() {
  return make_grower<MassiveGrower>("massive", "A massive coral: a dome of valleys, cups or pores");
}

}  // namespace frond
