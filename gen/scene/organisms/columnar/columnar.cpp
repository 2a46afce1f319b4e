#include <algorithm>

#include "appearance/describe.h"
#include "organisms/body_colony.h"
#include "organisms/kinds.h"

namespace frond {

/// A coral that grows by layers where light and food arrive, so that fingers, knobs or pillars form without a
/// rule.
struct ColumnarParams {
  Accretion accretion;
  TissueLook tissue;
  Growth growth;
};

namespace {

Result<Model> grow_columnar(const ColumnarParams& params, const Surroundings& around, Seed seed) {
  constexpr float kLit = 0.1f, kShaded = 0.5f;      // shade of tips, and of what came to rest
  constexpr float kAtRest = 0.6f, kYounger = 0.4f;  // of the time of birth that is shown: there; more at tips
  Accreted skin = accrete(params.accretion, accretion_world(around), seed.child("skin"));
  // Young is what has just grown and still grows: the tips, not what came to rest below them.
  for (std::size_t v = 0; v < skin.birth.size(); ++v)
    skin.surface.uv.push_back(
        {1 - skin.shade[v],
         skin.birth[v] * (kAtRest + kYounger * (1 - smooth_step(kLit, kShaded, skin.shade[v])))});
  return model_of(std::move(skin.surface), std::move(skin.past), params.tissue, Matter::polyps, seed);
}

}  // namespace

void describe(Properties& v, Accretion& a) {
  v.number("across", a.across, metres(0.01, 5), "How far it comes to each side of its foot");
  v.number("up", a.up, metres(0.01, 5), "How high it comes");
  v.integer("layers", a.layers, {.min = 8, .max = 1000}, "Layers of skeleton, one on another");
  v.number("edge", a.edge, metres(0.001, 0.5), "Length of the sides of its triangles");
  v.number("light", a.light, kShare,
           "Share of the growth that light from above drives; the rest comes with the water from all sides");
  v.number("hunger", a.hunger, {.min = 0, .max = 8},
           "How much faster what stands out grows than what lies back: 0 a dome, 2 knobs, 4 fingers");
  v.number("upward", a.upward, {.min = -1, .max = 1}, "Whether it spreads (-1) or rises (1)");
  v.number("lumps", a.lumps, kShare, "How uneven polyps are from the start");
  v.number("lump_size", a.lump_size, metres(0.002, 5), "Distance from lump to lump");
  v.number("smoothing", a.smoothing, kShare, "How far polyps even out what lies between them");
}

void describe(Properties& v, ColumnarParams& c) {
  v.object("accretion", c.accretion, "How its skin lays skeleton");
  v.object("tissue", c.tissue, "The living skin");
  v.object("growth", c.growth, "When it grows in the film");
}

namespace {

class ColumnarGrower final : public Described<ColumnarParams, ColonyGrower> {
 public:
  static constexpr std::string_view kLeading[] = {
      "accretion/across", "accretion/up",    "accretion/layers",    "accretion/light", "accretion/hunger",
      "accretion/upward", "accretion/lumps", "accretion/lump_size", "tissue/color"};

  Review review() const override {
    const Accretion& a = params.accretion;
    if (a.edge * 6 > std::min(a.across, a.up))
      return {{{"/accretion/edge",
                "found triangles that are too large for the coral; expected a sixth of its size at most"}}};
    return {};
  }
  std::shared_ptr<const Grower> coarse(double share) const override {
    return longer_edges(*this, share, [](auto& p) -> double& { return p.accretion.edge; });
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    const Accretion& a = params.accretion;
    return estimate_surface(a, 2 * kPi * a.across * (a.across / 2 + a.up) * (1 + 0.5 * a.hunger));
  }
  GrowerTraits traits() const override { return colony({.tallest = params.accretion.up}); }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.motion.growth = params.growth;
    return appearance;
  }
  std::optional<Spread> spread() const override {
    return Spread{static_cast<float>(params.accretion.across), static_cast<float>(params.accretion.up)};
  }
  Result<Model> grow_at(const Surroundings& around, Seed seed) const override {
    return grow_columnar(params, around, seed);
  }
};

}  // namespace

Kind<Organism> columnar_kind() {
  return make_grower<ColumnarGrower>("columnar",
                                     "A coral that grows by layers: knobs, fingers or pillars by themselves");
}

}  // namespace frond
