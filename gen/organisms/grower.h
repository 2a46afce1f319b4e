#pragma once

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/seed.h"
#include "dress/dress.h"
#include "grammar/forecast.h"
#include "model/model.h"
#include "preset/describe.h"
#include "world/world.h"

// Kinds of organisms
// ==================
// A kind is a folder below gen/organisms and a row in organisms/kinds.h. In the folder its parameters are
// described (preset/describe.h) and a Grower answers all that others ask of them; what it does not answer
// does not compile. Nobody outside of the folder knows the parameters.
//
//     class Toy final : public Described<ToyParams, LoneGrower> {
//      public:
//       Result<Model> grow_alone(Seed seed) const override;
//       ...
//     };
//     Kind<Organism> toy_kind() { return make_grower<Toy>("toy", "A toy"); }

namespace frond {

struct Organism;

/// Kinds grow in this order; those of one stage see what earlier ones have made, and not each other.
enum class GrowthStage {
  free,      ///< bodies, and what needs nothing but a place
  in_space,  ///< what fights for space with its like, beside and on bodies
  in_light,  ///< what fights for light with its like and is shaded by bodies
  creeping,  ///< what finds its own place on bodies
  swimming   ///< what moves about among all that stands
};

/// Whether what grows then has no place that is found for it: all of an entry grow as one.
inline bool finds_own_place(GrowthStage stage) { return stage >= GrowthStage::creeping; }

/// A place for one organism.
struct Planting {
  Seed seed;
  Vec3 foot{0};                  ///< on the ground or on its rock, raised as the preset says
  Vec3 normal{0, 1, 0};          ///< of what it stands on, where that is a body
  std::size_t claim = SIZE_MAX;  ///< its own in the territories of the world, where it has one
};

/// Where one is put, how it is turned and its size as a factor.
struct Placement {
  Vec3 foot{0};
  Quat turn{1, 0, 0, 0};
  float size = 1;
};

/// How far one would spread from its foot if it were alone, metres.
struct Spread {
  float across = 0.2f, up = 0.2f;
};

/// An entry of a preset, about to grow.
struct Bed {
  const Organism* organism = nullptr;
  std::size_t entry = 0;
  Seed seed;
  std::vector<Planting> plantings;  ///< none where it finds its own place
};

/// How large one of them will be, within about a factor of two.
struct SizeEstimate {
  Forecast word;     ///< of its grammar
  double nodes = 0;  ///< of its skeleton
  std::optional<double>
      chains;  ///< runs of nodes for each node, where that is known; short ones take more text
  double organs = 0;
  double parts = 0;             ///< placements of all parts of its organs
  double corners = 0;           ///< of what the turtle outlined
  double shapes = 0;            ///< triangles of its organs' shapes, once for an entry
  double triangles = 0;         ///< of a body
  double area = 0;              ///< m2 of a living skin, which is written no finer than it is seen; 0: none
  double blocks = 0;            ///< how many placements a body is made of
  bool riding = false;          ///< whether its textures ride on it even while it does not move
  double nodes_a_second = 5e5;  ///< that grow
  double seconds = 0;           ///< of a processor, to grow one, beyond what its nodes, organs and word take
  double held = 0;              ///< bytes that are held of one while it grows, and later a half of it
};

/// Of what searches for its way: nodes that grow a second, as a SizeEstimate has them.
inline constexpr double kTreeNodesASecond = 5e4;

/// Called after each organism that has grown, from several threads.
using Step = std::function<void()>;

/// The parameters of an organism and all that others ask of them. Pure functions.
class Grower {
 public:
  virtual ~Grower() = default;

  /// The parameters themselves, for those who know their type: the kind, and tests.
  virtual std::any parameters() const = 0;

  virtual GrowthStage stage() const = 0;
  /// Whether a rock may be laid under it; not where it is stone itself.
  virtual bool stands_on_rock() const = 0;
  /// Faults that only show when all is read; each `where` is a JSON pointer below the organism.
  virtual Errors check() const = 0;
  /// What is no fault, but most likely not meant.
  virtual Errors doubts() const = 0;
  /// The same as check() for all of this kind that stand in a scene, whose land rises by `relief` metres; the
  /// pointers are below the first of them, whose grower this is.
  virtual Errors check_together(std::span<const Organism* const> all, double relief) const = 0;
  /// Its size, without growing; a derivation past its limits is refused with the figure and the step.
  virtual Result<SizeEstimate> estimate_size(Seed seed) const = 0;
  /// About how tall one may be, metres, rather too much; 0: unknown.
  virtual double tallest() const = 0;
  virtual Dress dress() const = 0;
  /// Whether it has branches, which an organism's `body` says how to draw.
  virtual bool branches() const = 0;
  /// Whether it is another shape in each frame of a film, made anew.
  virtual bool develops(bool filmed) const = 0;
  /// Its grammar, ready to derive, where it has one.
  virtual std::optional<Result<Grammar>> grammar() const = 0;
  /// The names of the organisms that it grows on; nullptr where it stands by itself.
  virtual const std::vector<std::string>* hosts() const = 0;
  /// What one claims of the space that colonies fight for; none: it takes no part.
  virtual std::optional<Spread> spread() const = 0;

  /// The same, rougher and grown in about `share`, 0..1, of the time, to look at while it is being changed;
  /// none where that is not needed.
  virtual std::shared_ptr<const Grower> coarse(double /*share*/) const { return nullptr; }

  /// Grows all plantings of all beds, in their order. All are of this kind, the first is its own.
  virtual std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                             const Step& step) const = 0;
  /// Grows one to be copied, upright, its foot at the origin: like no other of its entry in age or size.
  virtual Result<Model> grow_copy(const Organism& organism, Seed seed) const = 0;
  /// How deep such a one stands in the ground, metres.
  virtual float copy_depth(const Model& model) const = 0;
};

/// What stands by itself, whatever grows beside it.
class LoneGrower : public Grower {
 public:
  /// Grows one, upright, its foot at the origin.
  virtual Result<Model> grow_alone(Seed seed) const = 0;
  /// The same where it stands: another shape only for those that heed what is round them.
  virtual Result<Model> grow_standing(const World&, const Planting&, const Placement&, Seed seed) const {
    return grow_alone(seed);
  }
  /// What gives the same at a time of a film, fully revealed, see Life; empty: it is merely revealed.
  virtual std::function<Result<Model>(double)> develop(const Motion& motion, Seed seed) const = 0;

  GrowthStage stage() const override { return GrowthStage::free; }
  bool stands_on_rock() const override { return true; }
  Errors doubts() const override { return {}; }
  Errors check_together(std::span<const Organism* const>, double) const override { return {}; }
  const std::vector<std::string>* hosts() const override { return nullptr; }
  std::optional<Spread> spread() const override { return std::nullopt; }
  std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                     const Step& step) const override;
  Result<Model> grow_copy(const Organism& organism, Seed seed) const override;
  float copy_depth(const Model& model) const override;
};

/// A kind of the described parameters `Params`, which answers as `Base` does where it says nothing itself.
template <class Params, class Base>
class Described : public Base {
 public:
  Params params;
  std::any parameters() const final { return params; }
};

/// A grower with some of its parameters changed, for Grower::coarse(); none where those would be at fault.
template <class Mine, class Change>
std::shared_ptr<const Grower> changed(const Mine& grower, Change change) {
  auto other = std::make_shared<Mine>(grower);
  change(other->params);
  return other->check().empty() ? other : nullptr;
}

/// The same with edges of triangles so much longer that about `share` of the triangles are left, 1/16 at
/// least.
template <class Mine>
std::shared_ptr<const Grower> longer_edges(const Mine& grower, double share,
                                           double& (*edge)(decltype(grower.params)&)) {
  return changed(grower, [&](auto& params) { edge(params) /= std::sqrt(std::clamp(share, 1. / 16, 1.)); });
}

/// The same after fewer derivation steps, with no more than `share` of the nodes where that can be.
template <class Mine>
std::shared_ptr<const Grower> fewer_steps(const Mine& grower, double share,
                                          int& (*steps)(decltype(grower.params)&)) {
  auto other = std::make_shared<Mine>(grower);
  auto nodes = [&] {
    Result<SizeEstimate> sight = other->estimate_size(Seed{1});
    return sight ? sight->nodes : 0;
  };
  double most = share * nodes();
  other->params.smoothing = 1;
  for (int& left = steps(other->params); left > 1 && nodes() > most;) --left;
  return other->check().empty() ? other : nullptr;
}

/// What is built: how large it is only it knows; it has no branches, no motion, and no look but its
/// materials.
class BodyBuilder : public LoneGrower {
 public:
  double tallest() const override { return 0; }
  Dress dress() const override { return {}; }
  bool branches() const override { return false; }
  bool develops(bool) const override { return false; }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  std::function<Result<Model>(double)> develop(const Motion&, Seed) const override { return {}; }
};

/// How far from the middle one of them may stand, metres.
double reach_of(const Organism& organism);

/// Gives a specimen that stands in its place what it wears, with what differs from one to the next.
void put_on(Specimen& specimen, const Dress& dress, const World& world, Seed seed);

/// The lean that `place` asks of a planting, and its size as a factor.
Quat lean_of(const Organism& organism, Seed planting);
float size_of(const Organism& organism, Seed planting);

}  // namespace frond
