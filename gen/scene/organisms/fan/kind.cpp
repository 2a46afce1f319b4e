#include "appearance/describe.h"
#include "organisms/colony.h"
#include "organisms/fan/fan.h"
#include "organisms/kinds.h"

namespace frond {

void describe(Properties& v, FanParams& f) {
  v.number("across", f.across, metres(0.03, 5), "How wide it is");
  v.number("height", f.height, metres(0.03, 5), "How high it is");
  v.number("mesh", f.mesh, metres(0.002, 0.5), "About the width of a mesh of its net");
  v.number("ragged", f.ragged, kShare, "How uneven its outline is");
  v.number("links", f.links, kShare, "Share of the meshes that are closed: 0 a mere tree");
  v.number("thread", f.thread, metres(0.0002, 0.1), "Radius of its thinnest threads");
  v.number("foot", f.foot, metres(0.001, 0.5), "Radius at its foot");
  v.number("gather", f.gather, {.min = 1, .max = 8},
           "Where threads meet, this power of their radii adds up: 2 keeps their section");
  v.number("curl", f.curl, metres(0, 2), "How far it bends out of its plane");
  v.object("skin", f.skin, "Pores and colours of the skin");
  v.object("wave", f.wave, "Swaying in the current");
  v.object("food", f.food, "What the branches bend toward");
  v.object("growth", f.growth, "When it grows in the film");
}

namespace {

class FanGrower final : public Described<FanParams, ColonyGrower> {
 public:
  static constexpr std::string_view kLeading[] = {"across", "height", "mesh",   "ragged", "links",
                                                  "thread", "foot",   "gather", "curl",   "skin/kind"};

  FanGrower() { params.skin.kind = SkinKind::fan; }
  Review review() const override {
    if (params.mesh * 5 > std::min(params.across, params.height))
      return {
          {{"/mesh", "found meshes that are too wide for the fan; expected a fifth of its size at most"}}};
    return {};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kFilled = 0.85;      // of the rectangle round it
    constexpr double kPlaceArea = 0.866;  // of a place of the net, in squares of the mesh: sqrt(3) / 2
    double places = kFilled * params.across * params.height / (kPlaceArea * params.mesh * params.mesh);
    return SizeEstimate{.nodes = places * (1 + params.links), .riding = true};
  }
  GrowerTraits traits() const override { return colony({.branches = true, .tallest = 1.1 * params.height}); }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.branches = {.skin = params.skin};
    appearance.motion = {params.growth, params.wave, params.food, 1};
    appearance.variation = params.skin.tint.variation;
    return appearance;
  }
  std::optional<Spread> spread() const override {
    return Spread{static_cast<float>(params.across / 2), static_cast<float>(params.height)};
  }
  Result<Model> grow_at(const Surroundings& around, Seed seed) const override {
    Model model;
    model.skeleton = grow_fan(params, seed);
    keep_to_room(model.skeleton, around);
    return model;
  }
};

}  // namespace

Kind<Organism> fan_kind() {
  return make_grower<FanGrower>("fan", "A sea fan: a net in one plane that flows together to its foot");
}

}  // namespace frond
