#pragma once

#include "accretion/accretion.h"
#include "accretion/sheet_body.h"
#include "model/solid.h"
#include "organisms/colony.h"
#include "preset/describe.h"

// What kinds of colonies that are bodies share: they grow at a margin or by layers, under a living skin.

namespace frond {

/// A colony of the kind `Mine` that is a body, as `grow_body` makes it. Its parameters have `across`,
/// `height` and `growth`; with an `edge`, the length of its triangles' sides, it can be coarser.
template <class Mine, class Params, Result<Model> (*grow_body)(const Params&, const Surroundings&, Seed)>
class BodyColony : public Described<Params, ColonyGrower> {
 public:
  std::shared_ptr<const Grower> coarse(double share) const override {
    if constexpr (requires(Params p) { p.edge; })
      return longer_edges(static_cast<const Mine&>(*this), share, [](auto& p) -> double& { return p.edge; });
    return nullptr;
  }
  Result<Model> grow_at(const Surroundings& around, Seed seed) const final {
    return grow_body(this->params, around, seed);
  }
  GrowerTraits traits() const override { return this->colony({.tallest = this->params.height}); }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.motion.growth = this->params.growth;
    return appearance;
  }
  std::optional<Spread> spread() const override {
    return Spread{static_cast<float>(this->params.across / 2), static_cast<float>(this->params.height)};
  }
};

/// The living skin of colonies that are bodies.
struct TissueLook {
  Color color{0.62f, 0.50f, 0.26f};   ///< of raised parts
  Color second{0.25f, 0.30f, 0.14f};  ///< in cups and valleys
  double cup = 0.008;                 ///< metres, of one polyp's cup, > 0
  double relief = 0.8;                ///< depth of the cups
  double gloss = 0.4;                 ///< 0 matt .. 1 wet
  double variation = 0.12;            ///< variation of brightness between individuals
  double dead = 0;                    ///< share of the skin that has died, on the mean of all colonies
  int scars = 3;                      ///< patches that it lies in, > 0
  Polyps polyps;
};

void describe(Properties& v, TissueLook& t);

/// The material of one colony, but for what has died of it.
Material material_of(const TissueLook& look, Matter matter, Seed seed);

/// The parts of a grown skin that have died.
std::vector<DeadPatch> dead_patches(const TissueLook& look, const Surface& skin, Seed seed);

/// The room left for sheets by the colony's surroundings, which must outlive it.
MarginWorld margin_world(const Surroundings& around);

/// A ring, or an arc of one, about a middle: `turn` is the direction of the arc's middle, `arc` its angle,
/// radians; it grows outward, `pitch` radians above the horizon.
MarginStart ring_start(Vec3 middle, double radius, double turn, double arc, double pitch, double edge);

/// Adds a body to another.
void append(SheetBody& to, const SheetBody& more);

/// The error for triangles longer than a `parts`-th of the width.
Errors check_edge(double edge, double across, double parts);

/// Predicted size of a sheet with that area and edge length, counting both sides.
SizeEstimate estimate_surface(double area, double edge);

/// Memory of a body's past, bytes per triangle.
inline constexpr double kPastTriangle = 250;

/// Predicted size of a skin that grows by layers, from its final area, m2.
SizeEstimate estimate_surface(const Accretion& law, double area);

/// The surroundings for a skin that grows by layers.
AccretionWorld accretion_world(const Surroundings& around);

/// A body of one living skin, with its past, see Solid::past.
Model model_of(Surface skin, std::vector<std::vector<Vec3>> past, const TissueLook& look, Matter matter,
               Seed seed);

/// The body of a sheet as a model.
Model model_of(SheetBody body, const TissueLook& look, Matter matter, Seed seed);

}  // namespace frond
